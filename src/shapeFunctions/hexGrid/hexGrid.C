/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexGrid.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(hexGrid, 0);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::hexGrid::hexGrid(const polyMesh& mesh)
:
    MeshObject<polyMesh, GeometricMeshObject, hexGrid>(mesh),
    nDim_(0),
    dir_{0, 0, 0},
    nCells_{0, 0, 0},
    period_{0, 0, 0},
    sameWidth_(0)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp))
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " is a wedge: axisymmetric"
                << " material points do not exist yet. Use empty patches"
                << " (2D) or a 3D mesh." << exit(FatalError);
        }
    }

    const Vector<label>& computed = mesh.solutionD();
    for (int d = 0; d < 3; ++d)
    {
        if (computed[d] > 0)
        {
            dir_[nDim_++] = d;
        }
    }

    makeNodes();
    makeCells();
    makeLattice();

    if (hasLattice() && mesh.nCells())
    {
        scalar shortest = GREAT, spread = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            const scalar h = width(0, d);
            shortest = min(shortest, h);
            forAll(mesh.cells(), celli)
            {
                spread = max(spread, mag(width(celli, d) - h)/h);
            }
        }
        sameWidth_ = spread < 1e-9 ? shortest : 0;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::hexGrid::width(const label celli, const int d) const
{
    if (hasLattice())
    {
        const label i = ijk(celli, d);
        return planes_[d][i + 1] - planes_[d][i];
    }

    // Shortest of the edges along the cell's direction
    const label nc = label(1) << nDim_;
    scalar corner[24];
    cornerPositions(celli, corner);
    scalar shortest = GREAT;
    for (label n = 0; n < nc; ++n)
    {
        if (!((n >> d) & 1))
        {
            scalar s = 0;
            for (int e = 0; e < nDim_; ++e)
            {
                s += sqr
                (
                    corner[nDim_*(n | (1 << d)) + e] - corner[nDim_*n + e]
                );
            }
            shortest = min(shortest, std::sqrt(s));
        }
    }
    return shortest;
}


void Foam::mpm::hexGrid::cornerPositions(const label celli, scalar* x) const
{
    const label nc = label(1) << nDim_;
    for (label n = 0; n < nc; ++n)
    {
        const point& p = mesh().points()[cellPoints_[nc*celli + n]];
        for (int d = 0; d < nDim_; ++d)
        {
            x[nDim_*n + d] = p[dir_[d]];
        }
    }
}

// ************************************************************************* //
