/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "cornerRegions.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::point meanOf
(
    const Foam::labelUList& corners,
    const Foam::UList<Foam::point>& points
)
{
    Foam::point mean(Foam::Zero);
    for (const Foam::label i : corners)
    {
        mean += points[i]/corners.size();
    }
    return mean;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::cornerRegions::cornerRegions(const labelUList& corners)
:
    corners_(corners),
    volume_(corners.size(), Zero),
    moment_(corners.size(), Zero)
{}


void Foam::mpm::cornerRegions::add
(
    const label corner,
    const scalar v,
    const point& mean,
    const int n,
    const FixedList<point, 4>& x
)
{
    const label i = corners_.find(corner);
    volume_[i] += v;
    moment_[i] += v*mean;
    simplices_.append(simplex{i, n, x, v});
}


void Foam::mpm::cornerRegions::addFace
(
    const face& f,
    const UList<point>& points,
    const point& F,
    const point& O
)
{
    forAll(f, i)
    {
        const edge e(f.faceEdge(i));
        const point E(e.centre(points));
        for (const label pointi : {e.first(), e.second()})
        {
            const point& x = points[pointi];
            add
            (
                pointi,
                mag((F - O) & ((E - O) ^ (x - O)))/6,
                0.25*(O + F + E + x),
                4,
                {O, F, E, x}
            );
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::mpm::cornerRegions::simplex::sample
(
    const label m,
    label i,
    scalar& weight
) const
{
    // u from x[0] to x[1], v of that to x[2], w to x[3]
    point at(x[0]);
    weight = 1;
    for (int k = 1; k < n; ++k)
    {
        const scalar s = (i % m + 0.5)/m;
        i /= m;
        at += s*(x[k] - at);
        weight *= k*std::pow(1 - s, k - 1);
    }
    return at;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::cornerRegions::cornerRegions
(
    const polyMesh& mesh,
    const label celli
)
:
    cornerRegions(mesh.cellPoints()[celli])
{
    const point O(meanOf(corners_, mesh.points()));
    for (const label facei : mesh.cells()[celli])
    {
        const face& f = mesh.faces()[facei];
        addFace(f, mesh.points(), f.average(mesh.points(), mesh.points()), O);
    }
}


Foam::mpm::cornerRegions::cornerRegions
(
    const labelUList& corners,
    const faceList& faces,
    const UList<point>& points
)
:
    cornerRegions(corners)
{
    const point O(meanOf(corners, points));
    for (const face& f : faces)
    {
        addFace(f, points, meanOf(f, points), O);
    }
}


Foam::mpm::cornerRegions::cornerRegions
(
    const face& f,
    const pointField& points
)
:
    cornerRegions(static_cast<const labelUList&>(f))
{
    const point O(f.average(points, points));
    forAll(f, i)
    {
        const edge e(f.faceEdge(i));
        const point E(e.centre(points));
        for (const label pointi : {e.first(), e.second()})
        {
            const point& x = points[pointi];
            add
            (
                pointi,
                0.5*mag((E - O) ^ (x - O)),
                (O + E + x)/3,
                3,
                {O, E, x, x}
            );
        }
    }
}

// ************************************************************************* //
