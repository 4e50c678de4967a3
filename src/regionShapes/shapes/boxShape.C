/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::boxShape

Description
    A box along the axes. Of places in its sides it owns those of the lower
    ones.

Usage
    \table
        Property | Description  | Required | Unit
        type     | box          | yes      |
        min      | lower corner | yes      | m
        max      | upper corner | yes      | m
    \endtable

\*---------------------------------------------------------------------------*/

#include "pointRegionShape.H"
#include "shapeFormula.H"
#include "wedgeVolumes.H"

namespace Foam::mpm
{

class boxShape : public pointRegionShape
{
    const point min_, max_;

public:
    TypeName("box");

    boxShape(const pointGrid& grid, const dictionary& dict) :
        pointRegionShape(grid),
        min_(required<point>(dict, "min")),
        max_(required<point>(dict, "max"))
    {
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const int c = grid_.direction(d);
            if (!(min_[c] < max_[c]))
            {
                FatalIOErrorInFunction(dict)
                    << "The box has min " << min_ << " and max " << max_
                    << "; each component of min must be less than that of max."
                    << exit(FatalIOError);
            }
        }
    }

    using pointRegionShape::contains;

    wordList keywords() const override { return {"min", "max"}; }
    boundBox bounds() const override { return boundBox(min_, max_); }

    bool contains(const label, const point& x) const override
    {
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const int c = grid_.direction(d);
            if (!(x[c] >= min_[c] && x[c] < max_[c]))
            {
                return false;
            }
        }
        return true;
    }

    bool formula(shapeFormula& f) const override
    {
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const int c = grid_.direction(d);
            quadratic lower, upper;
            lower.addLinear(d, min_[c], -1);
            upper.addLinear(d, max_[c], 1);
            f.surface(lower);
            f.surface(upper);
            f.andLast();
            if (d > 0)
            {
                f.andLast();
            }
        }
        return true;
    }

    scalar volume() const override
    {
        if (grid_.radial() >= 0)
        {
            const int r = grid_.direction(grid_.radial());
            const int a = grid_.direction(1 - grid_.radial());
            return grid_.sector() * ringOfRectangle(max_[a] - min_[a], min_[r], max_[r]);
        }
        scalar v = section();
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            v *= max_[grid_.direction(d)] - min_[grid_.direction(d)];
        }
        return v;
    }
};

defineTypeNameAndDebug(boxShape, 0);
addToRunTimeSelectionTable(pointRegionShape, boxShape, dictionary);

} // End namespace Foam::mpm
