/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "CochranChanEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(CochranChanEquation, 0);
    addToRunTimeSelectionTable
    (
        equationOfState,
        CochranChanEquation,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::CochranChanEquation::CochranChanEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<CochranChanEquation>(rho0)
{
    checkKeywords(dict, {"type", "A", "B", "E1", "E2", "Gamma0", "p0"});
    A_ = positive(dict, "A");
    B_ = bounded(dict, "B", 0, GREAT);
    E1_ = bounded(dict, "E1", 1.000001, 100);
    E2_ = bounded(dict, "E2", 1.000001, 100);
    Gamma0_ = positive(dict, "Gamma0");
    p0_ = bounded(dict, "p0", -GREAT, GREAT);
    if (!(c2(rho0, e0()) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "At rho " << rho0 << " and p0 " << p0_ << " the equation has no"
            << " speed of sound: E1 A - E2 B + (1 + Gamma0)(p0 - A + B) must"
            << " be above 0."
            << exit(FatalIOError);
    }
}

// ************************************************************************* //
