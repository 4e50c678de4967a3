#include "granularPressure.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

defineTypeNameAndDebug(granularPressure, 0);
defineRunTimeSelectionTable(granularPressure, dictionary);

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace granularPressures
{

class JohnsonJackson : public granularPressure
{
    const scalar min_, max_, Fr_, eta_, n_, delta_;

    //- The formula without its tangent
    scalar formula(const scalar a) const
    {
        return Fr_ * a * std::pow(a - min_, eta_) / std::pow(max_ - a, n_);
    }

public:
    TypeName("JohnsonJackson");

    explicit JohnsonJackson(const dictionary& dict) :
        granularPressure(dict, {"alphaMin", "alphaMax", "Fr", "eta", "n", "delta"}),
        min_(bounded(dict, "alphaMin", 0, 0.98)),
        max_(bounded(dict, "alphaMax", min_ + 0.02, 1)),
        Fr_(boundedOrDefault(dict, "Fr", 0.1, VSMALL, GREAT)),
        eta_(boundedOrDefault(dict, "eta", 2, 1, 10)),
        n_(boundedOrDefault(dict, "n", 5, 0, 10)),
        delta_(boundedOrDefault(dict, "delta", 0.01, 1e-6, 0.9 * (max_ - min_)))
    {
    }

    scalar p(const scalar a) const override
    {
        if (a <= min_)
        {
            return 0;
        }
        const scalar last = max_ - delta_;
        return a < last ? formula(a) : formula(last) + slope(last) * (a - last);
    }

    scalar slope(const scalar a) const override
    {
        if (a <= min_)
        {
            return 0;
        }
        const scalar b = min(a, max_ - delta_);
        return formula(b) * (1 / b + eta_ / (b - min_) + n_ / (max_ - b));
    }
};

defineTypeNameAndDebug(JohnsonJackson, 0);
addToRunTimeSelectionTable(granularPressure, JohnsonJackson, dictionary);

} // End namespace granularPressures

} // End namespace Foam::mpm

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::granularPressure::granularPressure(const dictionary& dict, const wordList& keywords) :
    linear_(boundedOrDefault(dict, "linear", 1, 0, 2)),
    quadratic_(boundedOrDefault(dict, "quadratic", 4, 0, 10))
{
    wordList valid({"type", "linear", "quadratic"});
    valid.append(keywords);
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::granularPressure> Foam::mpm::granularPressure::New(const dictionary& dict)
{
    return selectFromTable<granularPressure>(dict, dictionaryConstructorTablePtr_, dict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar
Foam::mpm::granularPressure::q(const scalar a, const scalar rho, const scalar jump) const
{
    const scalar stiffness = jump > 0 ? slope(a) : 0;
    return stiffness > 0
        ? rho * a * jump * (linear_ * std::sqrt(stiffness / rho) + quadratic_ * jump)
        : 0;
}
