/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointRegion.H"
#include "cornerRegions.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointRegion::fillCorners(const label celli, const scalar rho)
{
    const polyMesh& mesh = grid_.mesh();
    const scalar whole = mesh.cellVolumes()[celli];
    pointField x(1, mesh.cellCentres()[celli]);
    scalarField part(1, 1.0);
    if (n_[0] > 1)
    {
        label side = -1;
        const bitSet& empty = emptyFaces_;
        for (const label facei : mesh.cells()[celli])
        {
            side = side < 0 && empty.test(facei) ? facei : side;
        }
        const cornerRegions c
        (
            grid_.nDim() == 3
          ? cornerRegions(mesh, celli)
          : cornerRegions(mesh.faces()[side], mesh.points())
        );
        part = c.volume()/c.whole();
        x.setSize(part.size());
        forAll(x, i)
        {
            x[i] = mesh.cellCentres()[celli];
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                const int k = grid_.direction(d);
                x[i][k] = c.centre(i)[k];
            }
        }
    }

    const label nBefore = points_.size();
    const boolList inside(shape_->contains(celli, x));
    forAll(x, i)
    {
        if (!inside[i])
        {
            continue;
        }
        materialPointCloud::newPoint p;
        p.x = x[i];
        p.U = Zero;
        p.sigma = sigma_;
        p.T = T_;
        p.volume = whole*part[i]*volumeFraction_;
        p.mass = rho*p.volume;
        p.halfSize = Zero;

        // Those of a cube (square) of the same volume
        const scalar size = p.volume/volumeFraction_/shape_->section();
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            p.halfSize[grid_.direction(d)] =
                0.5*std::pow(size, 1.0/grid_.nDim());
        }
        sub_.append(i);
        points_.append(p);
    }
    if (points_.size() > nBefore)
    {
        cells_.append(celli);
        start_.append(points_.size());
    }
}


bool Foam::mpm::pointRegion::cornersOverlap
(
    const pointRegion& other,
    const label k,
    point& where
) const
{
    for (label p = start_[k]; p < start_[k + 1]; ++p)
    {
        where = points_[p].x;
        if (other.shape_->contains(cells_[k], where))
        {
            return true;
        }
    }
    return false;
}

// ************************************************************************* //
