/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "erosionCriterion.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(erosionCriterion, 0);
    defineRunTimeSelectionTable(erosionCriterion, dictionary);
}
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::erosionCriterion>
Foam::mpm::erosionCriterion::New(const dictionary& dict, const erodible& of)
{
    return selectFromTable<erosionCriterion>
    (
        dict,
        dictionaryConstructorTablePtr_,
        dict,
        of
    );
}

// ************************************************************************* //
