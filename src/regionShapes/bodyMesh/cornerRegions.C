// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "cornerRegions.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::point meanOf(const Foam::labelUList& corners, const Foam::UList<Foam::point>& points)
{
    Foam::point mean(Foam::Zero);
    for (const Foam::label i : corners)
    {
        mean += points[i] / corners.size();
    }
    return mean;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::cornerRegions::cornerRegions(const labelUList& corners) :
    cellParts(corners.size()), corners_(corners)
{
}

void Foam::mpm::cornerRegions::addFace(
    const face& f, const UList<point>& points, const point& F, const point& O)
{
    forAll(f, i)
    {
        const edge e(f.faceEdge(i));
        const point E(e.centre(points));
        for (const label pointi : {e.first(), e.second()})
        {
            const point& x = points[pointi];
            add(corners_.find(pointi), mag((F - O) & ((E - O) ^ (x - O))) / 6,
                0.25 * (O + F + E + x), 4, {O, F, E, x});
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::cornerRegions::cornerRegions(const polyMesh& mesh, const label celli) :
    cornerRegions(mesh.cellPoints()[celli])
{
    const point O(meanOf(corners_, mesh.points()));
    for (const label facei : mesh.cells()[celli])
    {
        const face& f = mesh.faces()[facei];
        addFace(f, mesh.points(), f.average(mesh.points(), mesh.points()), O);
    }
}

Foam::mpm::cornerRegions::cornerRegions(
    const labelUList& corners, const faceList& faces, const UList<point>& points) :
    cornerRegions(corners)
{
    const point O(meanOf(corners, points));
    for (const face& f : faces)
    {
        addFace(f, points, meanOf(f, points), O);
    }
}

Foam::mpm::cornerRegions::cornerRegions(const face& f, const pointField& points) :
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
            add(corners_.find(pointi), 0.5 * mag((E - O) ^ (x - O)), (O + E + x) / 3, 3,
                {O, E, x, x});
        }
    }
}
