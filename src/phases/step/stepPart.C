/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "stepPart.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(stepPart, 0);
    defineRunTimeSelectionTable(stepPart, dictionary);
}
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::stepPart> Foam::mpm::stepPart::New
(
    const word& name,
    const dictionary& dict,
    materialPointSystem& points
)
{
    return selectFromTable<stepPart>
    (
        dict,
        dictionaryConstructorTablePtr_,
        name,
        dict,
        points
    );
}

// ************************************************************************* //
