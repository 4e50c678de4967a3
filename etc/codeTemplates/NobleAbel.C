// An equation of state of a user, for points and gases: molecules that take up
// the volume b [m3/kg],
//
//     p = (gamma - 1) rho e/(1 - b rho)

#include "equationOfState.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class NobleAbel
:
    public inlineEquation<NobleAbel>
{
    const scalar gamma_, b_, p0_;

public:

    TypeName("NobleAbel");

    NobleAbel(const dictionary& dict, const scalar rho0)
    :
        inlineEquation<NobleAbel>(rho0),
        gamma_(bounded(dict, "gamma", 1.000001, 100)),
        b_(bounded(dict, "b", 0, 0.99/rho0)),
        p0_(positive(dict, "p0"))
    {
        checkKeywords(dict, {"type", "gamma", "b", "p0"});
    }

    bool usesEnergy() const override { return true; }

    bool pressureByEnergy() const override { return true; }

    scalar e0() const override
    {
        return p0_*(1/rho0() - b_)/(gamma_ - 1);
    }

    //- Of p = A + B e
    terms of(const scalar rho) const
    {
        const scalar free = 1 - b_*rho;
        return {0, (gamma_ - 1)*rho/free, 0, (gamma_ - 1)/sqr(free)};
    }
};

defineTypeNameAndDebug(NobleAbel, 0);
addToRunTimeSelectionTable(equationOfState, NobleAbel, dictionary);

} // End namespace Foam::mpm
