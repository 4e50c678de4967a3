// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "shapeTransfer.H"
#include "bSplineShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

typedef shapeFunction<quadraticBSplineShape> quadraticBSpline;
typedef shapeFunction<cubicBSplineShape> cubicBSpline;

addNamedToRunTimeSelectionTable(pointGridTransfer, quadraticBSpline, grid, quadraticBSpline);
addNamedToRunTimeSelectionTable(pointGridTransfer, cubicBSpline, grid, cubicBSpline);

}
