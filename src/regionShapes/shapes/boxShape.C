/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "dictionaryTools.H"
#include "shapeFormula.H"
#include "boxShape.H"
#include "wedgeVolumes.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(boxShape, 0);
    addToRunTimeSelectionTable(pointRegionShape, boxShape, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::boxShape::boxShape(const pointGrid& grid, const dictionary& dict)
:
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

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::boxShape::keywords() const
{
    return {"min", "max"};
}


Foam::boundBox Foam::mpm::boxShape::bounds() const
{
    return boundBox(min_, max_);
}


bool Foam::mpm::boxShape::contains(const label, const point& x) const
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


bool Foam::mpm::boxShape::formula(shapeFormula& f) const
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


Foam::scalar Foam::mpm::boxShape::volume() const
{
    if (grid_.radial() >= 0)
    {
        const int r = grid_.direction(grid_.radial());
        const int a = grid_.direction(1 - grid_.radial());
        return
            grid_.sector()
           *ringOfRectangle(max_[a] - min_[a], min_[r], max_[r]);
    }
    scalar v = section();
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        v *= max_[grid_.direction(d)] - min_[grid_.direction(d)];
    }
    return v;
}

// ************************************************************************* //
