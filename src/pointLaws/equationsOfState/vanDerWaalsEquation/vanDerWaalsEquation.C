/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "vanDerWaalsEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(vanDerWaalsEquation, 0);
    addToRunTimeSelectionTable
    (
        equationOfState,
        vanDerWaalsEquation,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::vanDerWaalsEquation::vanDerWaalsEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<vanDerWaalsEquation>(rho0)
{
    checkKeywords(dict, {"type", "gamma", "a", "b", "p0"});
    gamma_ = bounded(dict, "gamma", 1.000001, 100);
    a_ = bounded(dict, "a", 0, GREAT);
    b_ = bounded(dict, "b", 0, mostCovolume/rho0);
    p0_ = positive(dict, "p0");
    if (!(c2(rho0, e0()) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "At rho " << rho0 << " and p0 " << p0_ << " the equation has no"
            << " speed of sound (the gas would condense): gamma (p + a rho^2)"
            << " must be above 2 a rho^2 (1 - b rho)."
            << exit(FatalIOError);
    }
}

// ************************************************************************* //
