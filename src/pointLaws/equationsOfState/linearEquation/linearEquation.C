/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "linearEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(linearEquation, 0);
    addToRunTimeSelectionTable(equationOfState, linearEquation, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::linearEquation::linearEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<linearEquation>(rho0)
{
    checkKeywords(dict, {"type", "K"});
    K_ = positive(dict, "K");
}

// ************************************************************************* //
