/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "dragModel.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(dragModel, 0);
    defineRunTimeSelectionTable(dragModel, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::dragModel::dragModel
(
    const dictionary& dict,
    const wordList& keywords
)
:
    normalOnly_
    (
        oneOfOrDefault(dict, "direction", "all", {"all", "normal"}) == "normal"
    )
{
    wordList valid(keywords);
    valid.append("type");
    valid.append("direction");
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::dragModel> Foam::mpm::dragModel::New
(
    const dictionary& dict
)
{
    return selectFromTable<dragModel>
    (
        dict,
        dictionaryConstructorTablePtr_,
        dict
    );
}

// ************************************************************************* //
