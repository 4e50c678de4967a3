// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointRegionShape.H"
#include "shapeFormula.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(pointRegionShape, 0);
defineRunTimeSelectionTable(pointRegionShape, dictionary);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointRegionShape::pointRegionShape(const pointGrid& grid) : grid_(grid) {}

Foam::autoPtr<Foam::mpm::pointRegionShape>
Foam::mpm::pointRegionShape::New(const pointGrid& grid, const dictionary& dict)
{
    return selectFromTable<pointRegionShape>(dict, dictionaryConstructorTablePtr_, grid, dict);
}

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::vector Foam::mpm::pointRegionShape::computed(const vector& v) const
{
    vector result(Zero);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        result[grid_.direction(d)] = v[grid_.direction(d)];
    }
    return result;
}

Foam::scalar Foam::mpm::pointRegionShape::section() const
{
    if (grid_.radial() >= 0)
    {
        return 1;
    }
    vector span(grid_.mesh().bounds().span());
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        span[grid_.direction(d)] = 1;
    }
    return cmptProduct(span);
}

Foam::scalar Foam::mpm::pointRegionShape::readInner(const dictionary& dict, const scalar radius)
{
    const scalar inner = boundedOrDefault(dict, "innerRadius", 0, 0, GREAT);
    if (!(inner < radius))
    {
        FatalIOErrorInFunction(dict) << "Entry innerRadius is " << inner << "; it must be less than"
                                     << " radius, which is " << radius << "." << exit(FatalIOError);
    }
    return inner;
}

void Foam::mpm::pointRegionShape::addShell(
    shapeFormula& f, const quadratic& r2, const scalar radius, const scalar inner)
{
    quadratic outside(r2);
    outside.addConstant(-sqr(radius));
    f.surface(outside);
    if (inner > 0)
    {
        quadratic inside(r2);
        inside.addConstant(-sqr(inner));
        f.surface(inside);
        f.notLast();
        f.andLast();
    }
}

Foam::scalar Foam::mpm::pointRegionShape::ball(const int n, const scalar radius)
{
    const scalar pi = constant::mathematical::pi;

    switch (n)
    {
    case 0:
        return 1;
    case 1:
        return 2 * radius;
    case 2:
        return pi * sqr(radius);
    default:
        return 4 * pi / 3 * pow3(radius);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::mpm::pointRegionShape::contains(const label celli, const pointField& x) const
{
    boolList inside(x.size());
    forAll(x, i)
    {
        inside[i] = contains(celli, x[i]);
    }
    return inside;
}

bool Foam::mpm::pointRegionShape::formula(shapeFormula& f) const { return f.body(*this); }

bool Foam::mpm::pointRegionShape::insideMesh() const
{
    const polyMesh& mesh = grid_.mesh();

    const boundBox shape(bounds());
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        const int c = grid_.direction(d);
        const scalar tol = 1e-9 * mesh.bounds().span()[c];
        // What lies beyond the axis of a wedge is there on this side as well
        const bool axis = d == grid_.radial() && mesh.bounds().min()[c] < tol;
        if ((!axis && shape.min()[c] < mesh.bounds().min()[c] - tol)
            || shape.max()[c] > mesh.bounds().max()[c] + tol)
        {
            return false;
        }
    }

    // A mesh that does not fill its bounding box: nothing of the shape lies
    // just beyond the middle or beyond the corners of a boundary face
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp) || isA<cyclicPolyPatch>(pp))
        {
            continue;
        }
        forAll(pp, i)
        {
            const label celli = pp.faceCells()[i];
            const point& middle = mesh.faceCentres()[pp.start() + i];
            const vector beyond(1e-4 * (middle - mesh.cellCentres()[celli]));

            pointField x(pp[i].size() + 1, middle + beyond);
            forAll(pp[i], j)
            {
                x[j] += 0.99 * (mesh.points()[pp[i][j]] - middle);
            }
            if (contains(celli, x).found(true))
            {
                return false;
            }
        }
    }
    return true;
}
