/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::compositeShape

Description
    Shapes made of shapes: what lies in one of them, in all of them, or in the
    first but in none of the others. They may be nested.

Usage
    \verbatim
    plate
    {
        phase           plate;
        type            difference;
        shapes
        {
            whole  { type box; min (0 0 0); max (1 1 0.1); }
            hole   { type cylinder; point1 (0.5 0.5 -1); point2 (0.5 0.5 1);
                     radius 0.2; }
        }
        pointsPerCell   2;
    }
    \endverbatim
    \table
        Property | Description                               | Required
        type     | union, intersection or difference         | yes
        shapes   | dictionaries of any names, one or more    | yes
    \endtable

\*---------------------------------------------------------------------------*/

#include "pointRegionShape.H"
#include "PtrList.H"
#include "shapeFormula.H"

namespace Foam::mpm
{

class compositeShape : public pointRegionShape
{
    enum joints
    {
        anyOf,
        allOf,
        firstOnly
    };
    const joints joint_;

    PtrList<pointRegionShape> shapes_;

public:
    TypeName("composite");

    compositeShape(const pointGrid& grid, const dictionary& dict) :
        pointRegionShape(grid),
        joint_(
            dict.get<word>("type") == "union"              ? anyOf
                : dict.get<word>("type") == "intersection" ? allOf
                                                           : firstOnly)
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

    using pointRegionShape::contains;

    wordList keywords() const override { return {"shapes"}; }

    boundBox bounds() const override
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

    bool contains(const label celli, const point& x) const override
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

    bool formula(shapeFormula& f) const override
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
            case anyOf:
                f.orLast();
                break;
            case allOf:
                f.andLast();
                break;
            case firstOnly:
                f.notLast();
                f.andLast();
                break;
            }
        }
        return true;
    }
};

defineTypeNameAndDebug(compositeShape, 0);
addNamedToRunTimeSelectionTable(pointRegionShape, compositeShape, dictionary, union);
addNamedToRunTimeSelectionTable(pointRegionShape, compositeShape, dictionary, intersection);
addNamedToRunTimeSelectionTable(pointRegionShape, compositeShape, dictionary, difference);

} // End namespace Foam::mpm
