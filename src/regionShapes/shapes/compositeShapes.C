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
    defineTypeNameAndDebug(compositeShape, 0);
    addNamedToRunTimeSelectionTable
    (
        pointRegionShape,
        compositeShape,
        dictionary,
        union
    );
    addNamedToRunTimeSelectionTable
    (
        pointRegionShape,
        compositeShape,
        dictionary,
        intersection
    );
    addNamedToRunTimeSelectionTable
    (
        pointRegionShape,
        compositeShape,
        dictionary,
        difference
    );
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::compositeShape::compositeShape
(
    const pointGrid& grid,
    const dictionary& dict
)
:
    pointRegionShape(grid),
    joint_
    (
        dict.get<word>("type") == "union" ? anyOf
      : dict.get<word>("type") == "intersection" ? allOf
      : firstOnly
    )
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
        if (i == 0)
        {
            continue;
        }
        switch (joint_)
        {
            case anyOf: f.orLast(); break;
            case allOf: f.andLast(); break;
            case firstOnly: f.notLast(); f.andLast(); break;
        }
    }
    return true;
}


Foam::boundBox Foam::mpm::compositeShape::bounds() const
{
    boundBox bb(shapes_[0].bounds());
    for (const pointRegionShape& s : shapes_)
    {
        if (joint_ == anyOf)
        {
            bb.add(s.bounds());
        }
        else if (joint_ == allOf)
        {
            bb.min() = max(bb.min(), s.bounds().min());
            bb.max() = min(bb.max(), s.bounds().max());
        }
    }
    return bb;
}


bool Foam::mpm::compositeShape::contains
(
    const label celli,
    const point& x
) const
{
    // The first one that decides ends the search
    const bool first = shapes_[0].contains(celli, x);
    if (first == (joint_ == anyOf))
    {
        return first;
    }
    for (label i = 1; i < shapes_.size(); ++i)
    {
        if (shapes_[i].contains(celli, x) == (joint_ != allOf))
        {
            return joint_ == anyOf;
        }
    }
    return joint_ != anyOf;
}

// ************************************************************************* //
