/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "sphereShape.H"
#include "wedgeVolumes.H"
#include "dictionaryTools.H"
#include "shapeFormula.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(sphereShape, 0);
    addToRunTimeSelectionTable(pointRegionShape, sphereShape, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::sphereShape::sphereShape
(
    const pointGrid& grid,
    const dictionary& dict
)
:
    pointRegionShape(grid),
    centre_(computed(required<point>(dict, "centre"))),
    radius_(positive(dict, "radius")),
    inner_(readInner(dict, radius_))
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::sphereShape::keywords() const
{
    return {"centre", "radius", "innerRadius"};
}


Foam::boundBox Foam::mpm::sphereShape::bounds() const
{
    const vector r(radius_, radius_, radius_);
    return boundBox(centre_ - r, centre_ + r);
}


bool Foam::mpm::sphereShape::contains(const label, const point& x) const
{
    return inShell(magSqr(computed(x) - centre_), radius_, inner_);
}


bool Foam::mpm::sphereShape::formula(shapeFormula& f) const
{
    quadratic r2;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        r2.addSquare(d, centre_[grid_.direction(d)], 1);
    }
    addShell(f, r2, radius_, inner_);
    return true;
}


Foam::scalar Foam::mpm::sphereShape::volume() const
{
    if (grid_.radial() >= 0)
    {
        const scalar r = centre_[grid_.direction(grid_.radial())];
        return
            grid_.sector()*(ringOfDisc(r, radius_) - ringOfDisc(r, inner_));
    }
    const int n = grid_.nDim();
    return (ball(n, radius_) - ball(n, inner_))*section();
}

// ************************************************************************* //
