/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "MieGrueneisenEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(MieGrueneisenEquation, 0);
    addToRunTimeSelectionTable(equationOfState, MieGrueneisenEquation, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::MieGrueneisenEquation::MieGrueneisenEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<MieGrueneisenEquation>(rho0)
{
    checkKeywords(dict, {"type", "C0", "S", "Gamma0"});
    C0_ = positive(dict, "C0");
    S_ = bounded(dict, "S", 0, 10);
    Gamma0_ = bounded(dict, "Gamma0", 0, 10);
}

// ************************************************************************* //
