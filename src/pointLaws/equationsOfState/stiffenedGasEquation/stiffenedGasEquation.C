/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "stiffenedGasEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(stiffenedGasEquation, 0);
    addToRunTimeSelectionTable(equationOfState, stiffenedGasEquation, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::stiffenedGasEquation::stiffenedGasEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<stiffenedGasEquation>(rho0)
{
    checkKeywords(dict, {"type", "gamma", "pInf", "p0"});
    gamma_ = bounded(dict, "gamma", 1.000001, 100);
    pInf_ = positive(dict, "pInf");
    p0_ = bounded(dict, "p0", -pInf_, GREAT);
}

// ************************************************************************* //
