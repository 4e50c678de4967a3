/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasThermo.H"
#include "dictionaryTools.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::mpm::gasThermo::keywords
{
    "thermo", "molWeight", "R", "Cp", "Cv", "gamma", "p0", "rho0"
};

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The one of these keywords that a dictionary has; fatal if it has none or
//  more than one
word justOne(const dictionary& dict, const wordList& keys)
{
    word found;
    for (const word& key : keys)
    {
        if (dict.found(key))
        {
            if (found.size())
            {
                FatalIOErrorInFunction(dict)
                    << "Entries " << found << " and " << key << " in "
                    << dict.name() << " say the same thing; give just one of "
                    << flatOutput(keys) << exit(FatalIOError);
            }
            found = key;
        }
    }
    if (found.empty())
    {
        FatalIOErrorInFunction(dict)
            << "One of the entries " << flatOutput(keys) << " is missing in "
            << dict.name() << exit(FatalIOError);
    }
    return found;
}

//- Universal gas constant [J/kmol/K]
constexpr scalar universal = 8314.46261815324;

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gasThermo::gasThermo(const dictionary& dict)
:
    isentropic_
    (
        oneOf(dict, "thermo", {"perfectGas", "isentropic"}) == "isentropic"
    ),
    gamma_(0),
    R_(0),
    p0_(0),
    rho0_(0)
{
    const wordList others
    (
        isentropic_
      ? wordList({"molWeight", "R", "Cp", "Cv"})
      : wordList({"p0", "rho0"})
    );
    for (const word& key : others)
    {
        if (dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " in " << dict.name() << " is not one of"
                << " thermo " << dict.get<word>("thermo") << ", which has "
                << (isentropic_
                  ? "p0, rho0 and gamma."
                  : "molWeight or R, and Cp, Cv or gamma.")
                << exit(FatalIOError);
        }
    }

    if (isentropic_)
    {
        p0_ = positive(dict, "p0");
        rho0_ = positive(dict, "rho0");
        gamma_ = bounded(dict, "gamma", 1, 100);
        return;
    }

    const word first(justOne(dict, {"molWeight", "R"}));
    R_ = positive(dict, first);
    if (first == "molWeight")
    {
        R_ = universal/R_;
    }

    const word second(justOne(dict, {"Cp", "Cv", "gamma"}));
    const scalar value = positive(dict, second);
    gamma_ =
        second == "gamma" ? value
      : second == "Cv" ? 1 + R_/value
      : value > R_ ? value/(value - R_) : 0;

    if (!(gamma_ > 1.0001 && gamma_ < 100))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << second << " " << value << " with R " << R_
            << " J/kg/K gives the ratio of heat capacities " << gamma_
            << "; it must be in [1.0001, 100]." << exit(FatalIOError);
    }
}

// ************************************************************************* //
