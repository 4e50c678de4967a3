/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "nobleAbelStiffenedGasEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(nobleAbelStiffenedGasEquation, 0);
    addToRunTimeSelectionTable
    (
        equationOfState,
        nobleAbelStiffenedGasEquation,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::nobleAbelStiffenedGasEquation::nobleAbelStiffenedGasEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<nobleAbelStiffenedGasEquation>(rho0)
{
    checkKeywords(dict, {"type", "gamma", "pInf", "b", "q", "p0"});
    gamma_ = bounded(dict, "gamma", 1.000001, 100);
    pInf_ = bounded(dict, "pInf", 0, GREAT);
    b_ = bounded(dict, "b", 0, mostCovolume/rho0);
    q_ = bounded(dict, "q", -GREAT, GREAT);
    p0_ = bounded(dict, "p0", -pInf_, GREAT);
}

// ************************************************************************* //
