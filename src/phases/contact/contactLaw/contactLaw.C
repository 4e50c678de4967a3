/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "contactLaw.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(contactLaw, 0);
    defineRunTimeSelectionTable(contactLaw, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::contactLaw::contactLaw
(
    const dictionary& dict,
    const wordList& keywords
)
{
    wordList valid({"type", "fields", "patch", "normal"});
    valid.append(keywords);
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::contactLaw> Foam::mpm::contactLaw::New
(
    const dictionary& dict
)
{
    return selectFromTable<contactLaw>
    (
        dict,
        dictionaryConstructorTablePtr_,
        dict
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::contactLaw::slope(const state& s) const
{
    const scalar change = 1e-6*s.Jn;
    state more(s), less(s);
    more.Jn += change;
    less.Jn -= change;
    return (limit(more) - limit(less))/(more.Jn - less.Jn);
}

// ************************************************************************* //
