// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "transferScheme.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(transferScheme, 0);
defineRunTimeSelectionTable(transferScheme, dictionary);
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

wordList schemes() { return transferScheme::dictionaryConstructorTablePtr_->sortedToc(); }

autoPtr<transferScheme> make(const word& name, const dictionary& dict)
{
    return transferScheme::dictionaryConstructorTablePtr_->cfind(name).val()(dict);
}

//- Entries of a scheme; none if some of them are required
wordList keywordsOf(const word& name)
{
    dictionary defaults;
    defaults.add("transfer", name);
    wordList keys;
    const bool throwing = FatalIOError.throwExceptions();
    try
    {
        keys = make(name, defaults)->keywords();
    }
    catch (const IOerror&)
    {
    }
    FatalIOError.throwExceptions(throwing);
    return keys;
}

}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::transferScheme> Foam::mpm::transferScheme::New(const dictionary& dict)
{
    const word name(oneOf(dict, "transfer", schemes()));
    autoPtr<transferScheme> scheme(make(name, dict));

    // An entry that the selected transfer does not read is an error
    const wordList own(scheme->keywords());
    for (const word& key : dict.toc())
    {
        string owners;
        for (const word& other : schemes())
        {
            if (other != name && keywordsOf(other).found(key))
            {
                owners += (owners.empty() ? "" : " or ") + other;
            }
        }
        if (!owners.empty() && !own.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " belongs to transfer " << owners.c_str() << ", not to "
                << name << "; remove it, or choose that"
                << " transfer." << exit(FatalIOError);
        }
    }
    return scheme;
}

Foam::wordList Foam::mpm::transferScheme::keywordsOfAll(const dictionary& dict)
{
    const word chosen(dict.getOrDefault<word>("transfer", ""));
    wordList all({"transfer"});
    for (const word& name : schemes())
    {
        wordList keys(keywordsOf(name));
        if (name == chosen && keys.empty())
        {
            keys = make(name, dict)->keywords();
        }
        for (const word& key : keys)
        {
            if (!all.found(key))
            {
                all.append(key);
            }
        }
    }
    return all;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::transferScheme::write(Ostream& os, const bool) const
{
    os << "transfer " << type() << nl;
}
