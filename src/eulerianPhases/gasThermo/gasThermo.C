// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "gasThermo.H"
#include "dictionaryTools.H"
#include "ListOps.H"
#include "StringStream.H"
#include "addToRunTimeSelectionTable.H"

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
                    << "Entries " << found << " and " << key << " in " << dict.name()
                    << " say the same thing; give just one of " << flatOutput(keys)
                    << exit(FatalIOError);
            }
            found = key;
        }
    }
    if (found.empty())
    {
        FatalIOErrorInFunction(dict) << "One of the entries " << flatOutput(keys)
                                     << " is missing in " << dict.name() << exit(FatalIOError);
    }
    return found;
}

//- Universal gas constant [J/kmol/K]
constexpr scalar universal = 8314.46261815324;

}

// * * * * * * * * * * * * * * * * * Classes * * * * * * * * * * * * * * * * //

namespace Foam::mpm
{

class perfectGasThermo : public gasThermo
{
public:
    TypeName("perfectGas");

    explicit perfectGasThermo(const dictionary& dict)
    {
        const word first(justOne(dict, {"molWeight", "R"}));
        R_ = positive(dict, first);
        if (first == "molWeight")
        {
            if (R_ < 1)
            {
                FatalIOErrorInFunction(dict)
                    << "Entry molWeight " << R_ << " is less than that of"
                    << " hydrogen atoms, 1.008: it is in kg/kmol, of air 28.96."
                    << exit(FatalIOError);
            }
            R_ = universal / R_;
        }

        const word second(justOne(dict, {"Cp", "Cv", "gamma"}));
        const scalar value = positive(dict, second);
        gamma_ = second == "gamma" ? value
            : second == "Cv"       ? 1 + R_ / value
            : value > R_           ? value / (value - R_)
                                   : 0;

        if (!(gamma_ > 1.0001 && gamma_ < 100))
        {
            FatalIOErrorInFunction(dict) << "Entry " << second << " " << value << " with R " << R_
                                         << " J/kg/K gives the ratio of heat capacities " << gamma_
                                         << "; it must be in [1.0001, 100]." << exit(FatalIOError);
        }
    }

    wordList keywords() const override { return {"thermo", "molWeight", "R", "Cp", "Cv", "gamma"}; }
};

class isentropicThermo : public gasThermo
{
public:
    TypeName("isentropic");

    explicit isentropicThermo(const dictionary& dict)
    {
        isentropic_ = true;
        p0_ = positive(dict, "p0");
        rho0_ = positive(dict, "rho0");
        gamma_ = bounded(dict, "gamma", 1, 100);
    }

    wordList keywords() const override { return {"thermo", "p0", "rho0", "gamma"}; }
};

class equationThermo : public gasThermo
{
public:
    TypeName("equationOfState");

    explicit equationThermo(const dictionary& dict)
    {
        equation_ =
            equationOfState::New(requiredDict(dict, "equationOfState"), positive(dict, "rho"));
        if (dict.found("Cv"))
        {
            Cv_ = positive(dict, "Cv");
            if (!equation_->hasTemperature())
            {
                FatalIOErrorInFunction(dict)
                    << "Entry Cv in " << dict.name() << ": the equation of"
                    << " state " << equation_->type() << " has no temperature. Remove Cv."
                    << exit(FatalIOError);
            }
        }
    }

    wordList keywords() const override { return {"thermo", "equationOfState", "rho", "Cv"}; }
};

defineTypeNameAndDebug(gasThermo, 0);
defineRunTimeSelectionTable(gasThermo, dictionary);

defineTypeNameAndDebug(perfectGasThermo, 0);
defineTypeNameAndDebug(isentropicThermo, 0);
defineTypeNameAndDebug(equationThermo, 0);
addToRunTimeSelectionTable(gasThermo, perfectGasThermo, dictionary);
addToRunTimeSelectionTable(gasThermo, isentropicThermo, dictionary);
addToRunTimeSelectionTable(gasThermo, equationThermo, dictionary);

} // End namespace Foam::mpm

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::gasThermo> Foam::mpm::gasThermo::New(const dictionary& dict)
{
    word name("equationOfState");
    if (!dict.found(name) || dict.found("thermo"))
    {
        if (!dict.found("thermo"))
        {
            FatalIOErrorInFunction(dict)
                << "One of the entries (thermo equationOfState) is missing in " << dict.name()
                << exit(FatalIOError);
        }
        name = oneOf(dict, "thermo", dictionaryConstructorTablePtr_->sortedToc());
    }
    if (dict.found("equationOfState") && (name == "perfectGas" || name == "isentropic"))
    {
        FatalIOErrorInFunction(dict)
            << "Entries thermo " << name << " and equationOfState in " << dict.name()
            << " exclude each other; give one of them." << exit(FatalIOError);
    }
    return dictionaryConstructorTablePtr_->cfind(name).val()(dict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::mpm::gasThermo::description() const
{
    OStringStream os;
    if (isGammaLaw())
    {
        os << type() << ", gamma " << gamma_;
        if (!isentropic_)
        {
            os << ", R " << R_ << " J/kg/K";
        }
    }
    else
    {
        os << "equation of state " << equation_->type() << ", rho0 " << equation_->rho0()
           << " kg/m3";
        if (Cv_ > 0)
        {
            os << ", Cv " << Cv_ << " J/kg/K";
        }
    }
    return os.str();
}
