/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::TaitEquation

Description
    Tait's equation (Murnaghan's for solids), no energy:

        p = p0 + K/n ((rho/rho0)^n - 1)

    with the bulk modulus K of the state rho0, p0 and its derivative
    n = dK/dp.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | Tait                                     | yes      |
        K        | bulk modulus at rho0, > 0                | yes      | Pa
        n        | exponent, >= 1 (water: 7)                | yes      | -
        p0       | pressure at rho0                         | yes      | Pa
    \endtable

    Reference: F. D. Murnaghan, Proc. Nat. Acad. Sci. 30 (1944) 244; R. H.
    Cole, Underwater explosions (1948), for water.

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include <cmath>

namespace Foam::mpm
{

class TaitEquation : public inlineEquation<TaitEquation>
{
    scalar K_, n_, p0_;

public:
    TypeName("Tait");

    TaitEquation(const dictionary& dict, const scalar rho0) : inlineEquation<TaitEquation>(rho0)
    {
        checkKeywords(dict, {"type", "K", "n", "p0"});
        K_ = positive(dict, "K");
        n_ = bounded(dict, "n", 1.000001, 100);
        p0_ = bounded(dict, "p0", -GREAT, GREAT);
    }

    bool usesEnergy() const override { return false; }

    terms of(const scalar rho) const
    {
        const scalar x = std::pow(rho / rho0(), n_);
        return {p0_ + K_ / n_ * (x - 1), 0, K_ * x / rho, 0};
    }

    scalar storedEnergy(const scalar rho) const override
    {
        const scalar x = rho / rho0();
        return ((p0_ - K_ / n_) * (1 - 1 / x) + K_ / (n_ * (n_ - 1)) * (std::pow(x, n_ - 1) - 1))
            / rho0();
    }
};

defineTypeNameAndDebug(TaitEquation, 0);
addToRunTimeSelectionTable(equationOfState, TaitEquation, dictionary);

} // End namespace Foam::mpm
