// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "contactLaw.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(contactLaw, 0);
defineRunTimeSelectionTable(contactLaw, dictionary);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::contactLaw::contactLaw(const dictionary& dict, const wordList& keywords)
{
    wordList valid({"type", "fields", "patch", "normal"});
    valid.append(keywords);
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::contactLaw> Foam::mpm::contactLaw::New(const dictionary& dict)
{
    return selectFromTable<contactLaw>(dict, dictionaryConstructorTablePtr_, dict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::contactLaw::slope(const state& s) const
{
    const scalar change = 1e-6 * s.Jn;
    state more(s), less(s);
    more.Jn += change;
    less.Jn -= change;
    return (limit(more) - limit(less)) / (more.Jn - less.Jn);
}

namespace Foam::mpm
{
namespace contactLaws
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- mu belongs to Coulomb; fatal where another law has it
static wordList withoutMu(const dictionary& dict)
{
    if (dict.found("mu"))
    {
        FatalIOErrorInFunction(dict) << "mu is the friction of type Coulomb; the type is "
                                     << dict.get<word>("type") << "." << exit(FatalIOError);
    }
    return wordList();
}

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

//- A limit that nothing changes
class fixedLimit : public contactLaw
{
    const scalar limit_;

public:
    fixedLimit(const dictionary& dict, const scalar limit) :
        contactLaw(dict, withoutMu(dict)), limit_(limit)
    {
    }

    scalar limit(const state&) const override { return limit_; }
    scalar slope(const state&) const override { return 0; }
};

class frictionless : public fixedLimit
{
public:
    TypeName("frictionless");

    explicit frictionless(const dictionary& dict) : fixedLimit(dict, 0) {}
};

class stick : public fixedLimit
{
public:
    TypeName("stick");

    explicit stick(const dictionary& dict) : fixedLimit(dict, VGREAT) {}
};

class Coulomb : public contactLaw
{
    const scalar mu_;

public:
    TypeName("Coulomb");

    explicit Coulomb(const dictionary& dict) :
        contactLaw(dict, {"mu"}), mu_(bounded(dict, "mu", 0, GREAT))
    {
        if (mu_ > 2)
        {
            IOWarningInFunction(dict)
                << "The coefficient of friction mu is " << mu_ << "; that of dry"
                << " matter is up to about 1. Bodies that must not slide:"
                << "  type stick;" << endl;
        }
    }

    scalar limit(const state& s) const override { return mu_ * s.Jn; }
    scalar slope(const state&) const override { return mu_; }
};

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

defineTypeNameAndDebug(frictionless, 0);
defineTypeNameAndDebug(Coulomb, 0);
defineTypeNameAndDebug(stick, 0);
addToRunTimeSelectionTable(contactLaw, frictionless, dictionary);
addToRunTimeSelectionTable(contactLaw, Coulomb, dictionary);
addToRunTimeSelectionTable(contactLaw, stick, dictionary);

} // End namespace contactLaws
} // End namespace Foam::mpm
