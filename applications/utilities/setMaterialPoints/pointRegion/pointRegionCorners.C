/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointRegion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Volumes and first moments of the corners' regions of a cell
struct corners
{
    labelList points;
    scalarField volume;
    vectorField moment;

    explicit corners(const labelUList& p)
    :
        points(p),
        volume(p.size(), Zero),
        moment(p.size(), Zero)
    {}

    //- A simplex of the region of a mesh point
    void add(const label pointi, const scalar v, const point& mean)
    {
        const label i = points.find(pointi);
        volume[i] += v;
        moment[i] += v*mean;
    }
};


corners corners3D(const polyMesh& mesh, const label celli)
{
    corners c(mesh.cellPoints()[celli]);
    point O(Zero);
    for (const label pointi : c.points)
    {
        O += mesh.points()[pointi]/c.points.size();
    }
    for (const label facei : mesh.cells()[celli])
    {
        const face& f = mesh.faces()[facei];
        const point F(f.average(mesh.points(), mesh.points()));
        forAll(f, i)
        {
            const edge e(f.faceEdge(i));
            const point E(e.centre(mesh.points()));
            for (const label pointi : {e.first(), e.second()})
            {
                const point& x = mesh.points()[pointi];
                c.add
                (
                    pointi,
                    mag((F - O) & ((E - O) ^ (x - O)))/6,
                    0.25*(O + F + E + x)
                );
            }
        }
    }
    return c;
}


//- By the face of a cell on an empty patch
corners corners2D(const polyMesh& mesh, const face& f)
{
    corners c(f);
    const point O(f.average(mesh.points(), mesh.points()));
    forAll(f, i)
    {
        const edge e(f.faceEdge(i));
        const point E(e.centre(mesh.points()));
        for (const label pointi : {e.first(), e.second()})
        {
            const point& x = mesh.points()[pointi];
            c.add(pointi, 0.5*mag((E - O) ^ (x - O)), (O + E + x)/3);
        }
    }
    return c;
}

}

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
        corners c
        (
            grid_.nDim() == 3
          ? corners3D(mesh, celli)
          : corners2D(mesh, mesh.faces()[side])
        );
        // Of rings the volumes are the sections times their radius
        part =
            grid_.radial() < 0
          ? c.volume
          : c.moment.component(grid_.direction(grid_.radial()))();
        part /= sum(part);
        x.setSize(part.size());
        forAll(x, i)
        {
            x[i] = mesh.cellCentres()[celli];
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                const int k = grid_.direction(d);
                x[i][k] = c.moment[i][k]/c.volume[i];
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
