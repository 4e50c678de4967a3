/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::sphereShape

Description
    A sphere; in 2D a disc, in 1D a piece of the line. With innerRadius it is
    hollow: a shell, in 2D a ring.

Usage
    \table
        Property    | Description           | Required | Unit
        type        | sphere                | yes      |
        centre      | centre                | yes      | m
        radius      | radius, > 0           | yes      | m
        innerRadius | 0 to less than radius | no: 0    | m
    \endtable

\*---------------------------------------------------------------------------*/

#include "pointRegionShape.H"
#include "wedgeVolumes.H"
#include "shapeFormula.H"

namespace Foam::mpm
{

class sphereShape : public pointRegionShape
{
    //- Zero in empty directions
    const point centre_;

    const scalar radius_, inner_;

public:
    TypeName("sphere");

    sphereShape(const pointGrid& grid, const dictionary& dict) :
        pointRegionShape(grid),
        centre_(computed(required<point>(dict, "centre"))),
        radius_(positive(dict, "radius")),
        inner_(readInner(dict, radius_))
    {
    }

    using pointRegionShape::contains;

    wordList keywords() const override { return {"centre", "radius", "innerRadius"}; }

    boundBox bounds() const override
    {
        const vector r(radius_, radius_, radius_);
        return boundBox(centre_ - r, centre_ + r);
    }

    bool contains(const label, const point& x) const override
    {
        return inShell(magSqr(computed(x) - centre_), radius_, inner_);
    }

    bool formula(shapeFormula& f) const override
    {
        quadratic r2;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            r2.addSquare(d, centre_[grid_.direction(d)], 1);
        }
        addShell(f, r2, radius_, inner_);
        return true;
    }

    scalar volume() const override
    {
        if (grid_.radial() >= 0)
        {
            const scalar r = centre_[grid_.direction(grid_.radial())];
            return grid_.sector() * (ringOfDisc(r, radius_) - ringOfDisc(r, inner_));
        }
        const int n = grid_.nDim();
        return (ball(n, radius_) - ball(n, inner_)) * section();
    }
};

defineTypeNameAndDebug(sphereShape, 0);
addToRunTimeSelectionTable(pointRegionShape, sphereShape, dictionary);

} // End namespace Foam::mpm
