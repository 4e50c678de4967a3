/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexGrid.H"
#include <Eigen/LU>

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
    radial_(-1),
    sector_(0),
    nCells_{0, 0, 0},
    window_{0, 0, 0},
    nAllCells_{0, 0, 0},
    period_{0, 0, 0},
    lowest_{0, 0, 0},
    highest_{0, 0, 0},
    sameWidth_(0)
{
    if (!returnReduce(mesh.nCells(), sumOp<label>()))
    {
        FatalErrorInFunction
            << "The mesh " << mesh.bounds() << " has no cells: check"
            << " system/blockMeshDict." << exit(FatalError);
    }

    // Beside wedges the geometric directions may include empty ones
    for (int d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] > 0 && mesh.geometricD()[d] > 0)
        {
            dir_[nDim_++] = d;
        }
    }

    if (!nDim_)
    {
        FatalErrorInFunction
            << "All directions of the mesh " << mesh.bounds() << " are empty:"
            << " check the patches in system/blockMeshDict; faces that none"
            << " of them names become empty." << exit(FatalError);
    }

    makeWedge();
    makeNodes();
    makeCells();
    makeLattice();

    if (hasLattice())
    {
        // Over planes of all processors: the same number on each
        bool same = true;
        scalar shortest = GREAT;
        for (int d = 0; d < nDim_; ++d)
        {
            scalar least = GREAT, most = 0;
            for (label i = 1; i <= nCells_[d]; ++i)
            {
                const scalar h = planes_[d][i + 1] - planes_[d][i];
                least = min(least, h);
                most = max(most, h);
            }
            reduce(least, minOp<scalar>());
            reduce(most, maxOp<scalar>());
            same = same && most < (1 + 1e-9)*least;
            shortest = min(shortest, least);
        }
        sameWidth_ = same ? shortest : 0;
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

    // Smallest distance between the two sides: 1/|grad xi_d| at the corners.
    // On sheared cells it is much less than the edges, and it is what limits
    // the time step
    const label nc = label(1) << nDim_;
    scalar corner[24];
    cornerPositions(celli, corner);
    scalar shortest = GREAT;
    for (label n = 0; n < nc; ++n)
    {
        Eigen::Matrix3d J(Eigen::Matrix3d::Identity());
        for (int k = 0; k < nDim_; ++k)
        {
            for (int e = 0; e < nDim_; ++e)
            {
                J(e, k) =
                    corner[nDim_*(n | (label(1) << k)) + e]
                  - corner[nDim_*(n & ~(label(1) << k)) + e];
            }
        }
        shortest = min(shortest, 1/J.inverse().row(d).norm());
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
