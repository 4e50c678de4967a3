/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "dragModel.H"
#include "dictionaryTools.H"
#include "FlatOutput.H"

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
    requireKeyword(dict, "type");
    const word type(dict.get<word>("type"));
    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown drag model " << type << "." << nl
            << "Valid models: "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }
    return constructor.val()(dict);
}

// ************************************************************************* //
