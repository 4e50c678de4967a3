// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "afterburn.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"
#include "StringStream.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam::mpm
{

defineTypeNameAndDebug(afterburn, 0);
defineRunTimeSelectionTable(afterburn, dictionary);

class MillerAfterburn : public afterburn
{
    const scalar a_, m_, n_;

public:
    TypeName("Miller");

    explicit MillerAfterburn(const dictionary& dict) :
        afterburn(dict, {"a", "m", "n"}),
        a_(bounded(dict, "a", VSMALL, VGREAT)),
        m_(boundedOrDefault(dict, "m", 0.5, 0, 10)),
        n_(boundedOrDefault(dict, "n", 1.0 / 6, 0, 10))
    {
    }

    // Member Functions

    scalar burn(const scalar x, const scalar p, const scalar dt) const override
    {
        // y = 1 - x: dy/dt = -a p^n y^m
        const scalar y = 1 - x, s = a_ * std::pow(max(p, scalar(0)), n_) * dt, k = 1 - m_;
        if (!(y > 0))
        {
            return x;
        }
        if (mag(k) < 1e-6)
        {
            return 1 - y * std::exp(-s);
        }
        const scalar left = std::pow(y, k) - k * s;
        return left > 0 ? 1 - std::pow(left, 1 / k) : 1;
    }

    string description() const override
    {
        OStringStream os;
        os << "burns on, " << Q() << " J/kg at the rate " << a_ << " (1 - x)^" << m_ << " p^" << n_;
        return os.str();
    }
};

defineTypeNameAndDebug(MillerAfterburn, 0);
addToRunTimeSelectionTable(afterburn, MillerAfterburn, dictionary);

} // End namespace Foam::mpm

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::afterburn::afterburn(const dictionary& dict, const wordList& entries) :
    Q_(bounded(dict, "Q", VSMALL, 1e12))
{
    wordList valid(entries);
    valid.append("type");
    valid.append("Q");
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::afterburn>
Foam::mpm::afterburn::New(const dictionary& dict, const equationOfState& products)
{
    if (!products.ofReaction())
    {
        FatalIOErrorInFunction(dict)
            << "A fluid with the equation of state " << products.type()
            << " cannot burn on: that of the fluid must be one of the products of an explosive"
            << " (JWL)." << exit(FatalIOError);
    }
    return selectFromTable<afterburn>(dict, dictionaryConstructorTablePtr_, dict);
}
