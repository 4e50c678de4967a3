/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "dictionaryTools.H"
#include "compositeShapes.H"
#include "shapeFormula.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(unionShape, 0);
    addToRunTimeSelectionTable(pointRegionShape, unionShape, dictionary);
    defineTypeNameAndDebug(intersectionShape, 0);
    addToRunTimeSelectionTable(pointRegionShape, intersectionShape, dictionary);
    defineTypeNameAndDebug(differenceShape, 0);
    addToRunTimeSelectionTable(pointRegionShape, differenceShape, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::compositeShape::compositeShape
(
    const pointGrid& grid,
    const dictionary& dict
)
:
    pointRegionShape(grid)
{
    const dictionary& shapesDict = requiredDict(dict, "shapes");
    for (const word& name : shapesDict.toc())
    {
        const dictionary& shapeDict = requiredDict(shapesDict, name);
        shapes_.append(pointRegionShape::New(grid, shapeDict));
        wordList valid({"type"});
        valid.append(shapes_.last().keywords());
        checkKeywords(shapeDict, valid);
    }
    if (shapes_.empty())
    {
        FatalIOErrorInFunction(shapesDict)
            << "There are no shapes; write  shapes { a { type box; ...; }"
            << " b { type sphere; ...; } }" << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::compositeShape::formula(shapeFormula& f) const
{
    forAll(shapes_, i)
    {
        if (!shapes_[i].formula(f))
        {
            return false;
        }
        if (i > 0)
        {
            join(f);
        }
    }
    return true;
}


Foam::boundBox Foam::mpm::unionShape::bounds() const
{
    boundBox bb(shapes_[0].bounds());
    for (const pointRegionShape& s : shapes_)
    {
        bb.add(s.bounds());
    }
    return bb;
}


bool Foam::mpm::unionShape::contains(const label celli, const point& x) const
{
    for (const pointRegionShape& s : shapes_)
    {
        if (s.contains(celli, x))
        {
            return true;
        }
    }
    return false;
}


void Foam::mpm::unionShape::join(shapeFormula& f) const
{
    f.orLast();
}


Foam::boundBox Foam::mpm::intersectionShape::bounds() const
{
    boundBox bb(shapes_[0].bounds());
    for (const pointRegionShape& s : shapes_)
    {
        bb.min() = max(bb.min(), s.bounds().min());
        bb.max() = min(bb.max(), s.bounds().max());
    }
    return bb;
}


bool Foam::mpm::intersectionShape::contains
(
    const label celli,
    const point& x
) const
{
    for (const pointRegionShape& s : shapes_)
    {
        if (!s.contains(celli, x))
        {
            return false;
        }
    }
    return true;
}


void Foam::mpm::intersectionShape::join(shapeFormula& f) const
{
    f.andLast();
}


Foam::boundBox Foam::mpm::differenceShape::bounds() const
{
    return shapes_[0].bounds();
}


bool Foam::mpm::differenceShape::contains
(
    const label celli,
    const point& x
) const
{
    for (label i = 1; i < shapes_.size(); ++i)
    {
        if (shapes_[i].contains(celli, x))
        {
            return false;
        }
    }
    return shapes_[0].contains(celli, x);
}


void Foam::mpm::differenceShape::join(shapeFormula& f) const
{
    f.notLast();
    f.andLast();
}

// ************************************************************************* //
