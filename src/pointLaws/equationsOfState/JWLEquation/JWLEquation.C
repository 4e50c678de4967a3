/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "JWLEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(JWLEquation, 0);
    addToRunTimeSelectionTable(equationOfState, JWLEquation, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::JWLEquation::JWLEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<JWLEquation>(rho0)
{
    checkKeywords(dict, {"type", "A", "B", "R1", "R2", "omega", "E0"});
    A_ = positive(dict, "A");
    B_ = bounded(dict, "B", -GREAT, GREAT);
    R1_ = positive(dict, "R1");
    R2_ = positive(dict, "R2");
    omega_ = positive(dict, "omega");
    E0_ = positive(dict, "E0");
}

// ************************************************************************* //
