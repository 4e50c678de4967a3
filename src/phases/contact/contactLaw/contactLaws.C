/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    The contact laws of contactLaw.H.

\*---------------------------------------------------------------------------*/

#include "contactLaw.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace mpm
{
namespace contactLaws
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- mu belongs to Coulomb; fatal where another law has it
static wordList withoutMu(const dictionary& dict)
{
    if (dict.found("mu"))
    {
        FatalIOErrorInFunction(dict)
            << "mu is the friction of type Coulomb; the type is "
            << dict.get<word>("type") << "." << exit(FatalIOError);
    }
    return wordList();
}

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

class frictionless
:
    public contactLaw
{
public:

    TypeName("frictionless");

    explicit frictionless(const dictionary& dict)
    :
        contactLaw(dict, withoutMu(dict))
    {}

    scalar limit(const state&) const override
    {
        return 0;
    }

    scalar slope(const state&) const override
    {
        return 0;
    }
};


class Coulomb
:
    public contactLaw
{
    const scalar mu_;

public:

    TypeName("Coulomb");

    explicit Coulomb(const dictionary& dict)
    :
        contactLaw(dict, {"mu"}),
        mu_(bounded(dict, "mu", 0, GREAT))
    {
        if (mu_ > 2)
        {
            IOWarningInFunction(dict)
                << "The coefficient of friction mu is " << mu_ << "; that of dry"
                << " matter is up to about 1. Bodies that must not slide:"
                << "  type stick;" << endl;
        }
    }

    scalar limit(const state& s) const override
    {
        return mu_*s.Jn;
    }

    scalar slope(const state&) const override
    {
        return mu_;
    }
};


class stick
:
    public contactLaw
{
public:

    TypeName("stick");

    explicit stick(const dictionary& dict)
    :
        contactLaw(dict, withoutMu(dict))
    {}

    scalar limit(const state&) const override
    {
        return VGREAT;
    }

    scalar slope(const state&) const override
    {
        return 0;
    }
};

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

defineTypeNameAndDebug(frictionless, 0);
defineTypeNameAndDebug(Coulomb, 0);
defineTypeNameAndDebug(stick, 0);
addToRunTimeSelectionTable(contactLaw, frictionless, dictionary);
addToRunTimeSelectionTable(contactLaw, Coulomb, dictionary);
addToRunTimeSelectionTable(contactLaw, stick, dictionary);

} // End namespace contactLaws
} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
