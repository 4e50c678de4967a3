/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "nodeDualTransfer.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{

typedef shapeFunction<simplexShape, nodeDualTransfer> nodeDualFunctions;
addNamedToRunTimeSelectionTable
(
    pointGridTransfer, nodeDualFunctions, grid, nodeDual
);

}
}

// ************************************************************************* //
