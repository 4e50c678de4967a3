/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "shapeTransfer.H"
#include "bSplineShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

#define addBSpline(name)                                                      \
    typedef shapeFunction<name##Shape> name;                                  \
    addNamedToRunTimeSelectionTable(pointGridTransfer, name, grid, name);

addBSpline(quadraticBSpline)
addBSpline(cubicBSpline)

#undef addBSpline

}

// ************************************************************************* //
