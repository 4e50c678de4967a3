/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "perfectGasEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(perfectGasEquation, 0);
    addToRunTimeSelectionTable(equationOfState, perfectGasEquation, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::perfectGasEquation::perfectGasEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<perfectGasEquation>(rho0)
{
    checkKeywords(dict, {"type", "gamma", "p0"});
    gamma_ = bounded(dict, "gamma", 1.000001, 100);
    p0_ = positive(dict, "p0");
}

// ************************************************************************* //
