// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointDamping.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointDamping::pointDamping(const dictionary& dict) : rate_(0), before_(0)
{
    if (oneOf(dict, "type", {"viscous", "kinetic"}) == "viscous")
    {
        checkKeywords(dict, {"type", "rate"});
        rate_ = positive(dict, "rate");
    }
    else
    {
        checkKeywords(dict, {"type"});
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::pointDamping::factor(const scalar dt, const scalar K)
{
    if (rate_ > 0)
    {
        return std::exp(-rate_ * dt);
    }
    const bool peak = K < before_;
    before_ = peak ? 0 : K;
    return peak ? 0 : 1;
}
