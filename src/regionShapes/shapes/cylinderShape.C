/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::cylinderShape

Description
    A circular cylinder between two points, with innerRadius a tube. In 2D with
    its axis along the empty direction it is a disc, with its axis in the plane
    a rectangle; an oblique axis is an error.

Usage
    \table
        Property    | Description               | Required | Unit
        type        | cylinder                  | yes      |
        point1      | one end of the axis       | yes      | m
        point2      | the other end of the axis | yes      | m
        radius      | radius, > 0               | yes      | m
        innerRadius | 0 to less than radius     | no: 0    | m
    \endtable

\*---------------------------------------------------------------------------*/

#include "pointRegionShape.H"
#include "wedgeVolumes.H"
#include "shapeFormula.H"

namespace Foam::mpm
{

class cylinderShape : public pointRegionShape
{
    //- End of the axis and the way to its other end, zero in empty
    //  directions. No way: the axis is along an empty direction
    const point start_;
    vector axis_;

    const scalar radius_, inner_;

public:
    TypeName("cylinder");

    cylinderShape(const pointGrid& grid, const dictionary& dict) :
        pointRegionShape(grid),
        start_(computed(required<point>(dict, "point1"))),
        axis_(required<point>(dict, "point2") - required<point>(dict, "point1")),
        radius_(positive(dict, "radius")),
        inner_(readInner(dict, radius_))
    {
        const scalar length = mag(axis_);
        if (!(length > 0))
        {
            FatalIOErrorInFunction(dict)
                << "The ends of the cylinder's axis, point1 and point2, are both "
                << required<point>(dict, "point1") << "; they must differ." << exit(FatalIOError);
        }

        const vector inPlane(computed(axis_));
        const scalar tol = 1e-6 * length;
        if (mag(inPlane) > tol && mag(axis_ - inPlane) > tol)
        {
            FatalIOErrorInFunction(dict)
                << "The cylinder's axis " << axis_ << " is oblique to the mesh's"
                << " empty direction; it must be along it or normal to it." << exit(FatalIOError);
        }
        axis_ = mag(inPlane) > tol ? inPlane : vector(Zero);
    }

    using pointRegionShape::contains;

    wordList keywords() const override { return {"point1", "point2", "radius", "innerRadius"}; }

    boundBox bounds() const override
    {
        // The ends are circles: in direction c they reach r*sqrt(1 - e_c^2)
        vector r(radius_, radius_, radius_);
        for (direction c = 0; c < 3; ++c)
        {
            if (magSqr(axis_) > 0)
            {
                r[c] *= sqrt(max(1 - sqr(axis_[c]) / magSqr(axis_), scalar(0)));
            }
        }
        const point end(start_ + axis_);
        return boundBox(min(start_, end) - r, max(start_, end) + r);
    }

    bool contains(const label, const point& x) const override
    {
        const vector dx(computed(x) - start_);
        const scalar length2 = magSqr(axis_);
        if (!(length2 > 0))
        {
            return inShell(magSqr(dx), radius_, inner_);
        }

        const scalar t = (dx & axis_) / length2;
        return t >= 0 && t < 1 && inShell(magSqr(dx - t * axis_), radius_, inner_);
    }

    bool formula(shapeFormula& f) const override
    {
        const scalar length = mag(axis_);
        scalar from[3] = {0, 0, 0}, along[3] = {0, 0, 0};
        quadratic r2;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            from[d] = start_[grid_.direction(d)];
            along[d] = length > 0 ? axis_[grid_.direction(d)] / length : 0;
            r2.addSquare(d, from[d], 1);
        }
        r2.addSquare(from, along, -1);
        addShell(f, r2, radius_, inner_);
        if (!(length > 0))
        {
            return true;
        }

        quadratic lower, upper;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            lower.addLinear(d, from[d], -along[d]);
            upper.addLinear(d, from[d], along[d]);
        }
        upper.addConstant(-length);
        for (const quadratic& end : {lower, upper})
        {
            f.surface(end);
            f.andLast();
        }
        return true;
    }

    scalar volume() const override
    {
        if (grid_.radial() >= 0)
        {
            // In the plane of axis and radius: a disc, or one band, two if hollow
            const int way = grid_.direction(grid_.radial());
            const int other = grid_.direction(1 - grid_.radial());
            const scalar r = start_[way], along = axis_[way];
            const scalar length = mag(axis_);
            if (!(length > 0))
            {
                return grid_.sector() * (ringOfDisc(r, radius_) - ringOfDisc(r, inner_));
            }
            if (mag(along) < 1e-9 * length)
            {
                return grid_.sector()
                    * (ringOfRectangle(length, r - radius_, r + radius_)
                       - ringOfRectangle(length, r - inner_, r + inner_));
            }
            if (mag(axis_[other]) < 1e-9 * length)
            {
                return grid_.sector()
                    * ringOfRectangle(2 * (radius_ - inner_), min(r, r + along), max(r, r + along));
            }
            return -1;
        }
        const int n = grid_.nDim();
        return section()
            * (magSqr(axis_) > 0 ? (ball(n - 1, radius_) - ball(n - 1, inner_)) * mag(axis_)
                                 : ball(n, radius_) - ball(n, inner_));
    }
};

defineTypeNameAndDebug(cylinderShape, 0);
addToRunTimeSelectionTable(pointRegionShape, cylinderShape, dictionary);

} // End namespace Foam::mpm
