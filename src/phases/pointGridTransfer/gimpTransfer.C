// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "shapeTransfer.H"
#include "gimpShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

typedef shapeFunction<gimpShape> GIMP;
addNamedToRunTimeSelectionTable(pointGridTransfer, GIMP, grid, GIMP);

}
