/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasThermo.H"
#include "dictionaryTools.H"
#include "ListOps.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::mpm::gasThermo::keywords
{
    "thermo", "molWeight", "R", "Cp", "Cv", "gamma", "p0", "rho0",
    "equationOfState", "rho"
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


//- Fatal if one of these is there
void refuse
(
    const dictionary& dict,
    const wordList& keys,
    const string& of,
    const string& valid
)
{
    for (const word& key : keys)
    {
        if (dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " in " << dict.name() << " is not one of "
                << of.c_str() << ", which has " << valid.c_str()
                << exit(FatalIOError);
        }
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gasThermo::readEquation(const dictionary& dict)
{
    refuse
    (
        dict,
        {"thermo", "molWeight", "R", "Cp", "gamma", "p0", "rho0"},
        "a gas with equationOfState",
        "rho, Cv where it has a temperature, and the equation's own entries in"
        " equationOfState."
    );
    equation_ = equationOfState::New
    (
        requiredDict(dict, "equationOfState"),
        positive(dict, "rho")
    );
    if (dict.found("Cv"))
    {
        Cv_ = positive(dict, "Cv");
        if (!equation_->hasTemperature())
        {
            FatalIOErrorInFunction(dict)
                << "Entry Cv in " << dict.name() << ": the equation of state "
                << equation_->type() << " has no temperature. Remove Cv."
                << exit(FatalIOError);
        }
    }
}


void Foam::mpm::gasThermo::readGas(const dictionary& dict)
{
    if (!dict.found("thermo"))
    {
        FatalIOErrorInFunction(dict)
            << "One of the entries (thermo equationOfState) is missing in "
            << dict.name() << exit(FatalIOError);
    }
    isentropic_ =
        oneOf(dict, "thermo", {"perfectGas", "isentropic"}) == "isentropic";
    refuse
    (
        dict,
        isentropic_
      ? wordList({"molWeight", "R", "Cp", "Cv", "rho"})
      : wordList({"p0", "rho0", "rho"}),
        "thermo " + dict.get<word>("thermo"),
        isentropic_
      ? "p0, rho0 and gamma."
      : "molWeight or R, and Cp, Cv or gamma."
    );

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

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gasThermo::gasThermo(const dictionary& dict)
:
    isentropic_(false),
    gamma_(0),
    R_(0),
    p0_(0),
    rho0_(0),
    Cv_(0)
{
    if (dict.found("equationOfState"))
    {
        readEquation(dict);
    }
    else
    {
        readGas(dict);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::mpm::gasThermo::description() const
{
    OStringStream os;
    if (isGammaLaw())
    {
        os  << (isentropic_ ? "isentropic" : "perfectGas") << ", gamma "
            << gamma_;
        if (!isentropic_)
        {
            os  << ", R " << R_ << " J/kg/K";
        }
    }
    else
    {
        os  << "equation of state " << equation_->type() << ", rho0 "
            << equation_->rho0() << " kg/m3";
        if (Cv_ > 0)
        {
            os  << ", Cv " << Cv_ << " J/kg/K";
        }
    }
    return os.str();
}

// ************************************************************************* //
