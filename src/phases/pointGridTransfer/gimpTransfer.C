/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "shapeTransfer.H"
#include "gimpShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

typedef shapeFunction<gimpShape> GIMP;
addNamedToRunTimeSelectionTable(pointGridTransfer, GIMP, grid, GIMP);

}

// ************************************************************************* //
