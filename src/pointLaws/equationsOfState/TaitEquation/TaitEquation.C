/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "TaitEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(TaitEquation, 0);
    addToRunTimeSelectionTable(equationOfState, TaitEquation, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::TaitEquation::TaitEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<TaitEquation>(rho0)
{
    checkKeywords(dict, {"type", "K", "n", "p0"});
    K_ = positive(dict, "K");
    n_ = bounded(dict, "n", 1.000001, 100);
    p0_ = bounded(dict, "p0", -GREAT, GREAT);
}

// ************************************************************************* //
