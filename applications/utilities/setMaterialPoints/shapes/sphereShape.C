/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "sphereShape.H"
#include "selector.H"
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
    const hexGrid& grid,
    const dictionary& dict
)
:
    pointRegionShape(grid),
    centre_(computed(required<point>(dict, "centre"))),
    radius_(positive(dict, "radius"))
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::sphereShape::keywords() const
{
    return {"centre", "radius"};
}


Foam::boundBox Foam::mpm::sphereShape::bounds() const
{
    const vector r(radius_, radius_, radius_);
    return boundBox(centre_ - r, centre_ + r);
}


bool Foam::mpm::sphereShape::contains(const label, const point& x) const
{
    return magSqr(computed(x) - centre_) <= sqr(radius_);
}


Foam::scalar Foam::mpm::sphereShape::volume() const
{
    return grid_.radial() >= 0 ? -1 : ball(grid_.nDim(), radius_)*section();
}

// ************************************************************************* //
