/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "programmedBurn.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(programmedBurn, 0);
    addToRunTimeSelectionTable(detonation, programmedBurn, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::programmedBurn::programmedBurn
(
    const dictionary& dict,
    const equationOfState& products
)
:
    detonation(dict, products, detonationFront::entries),
    front_(dict)
{}

// ************************************************************************* //
