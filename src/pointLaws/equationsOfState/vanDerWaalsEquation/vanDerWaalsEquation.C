/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::vanDerWaalsEquation

Description
    van der Waals: a dense gas whose molecules attract each other and have a
    volume of their own,

        p = (gamma - 1) rho (e + a rho)/(1 - b rho) - a rho^2           [Pa]
        rho c^2 = gamma (p + a rho^2)/(1 - b rho) - 2 a rho^2           [Pa]

    gamma = 1 + R/Cv, that of the gas when it is thin; a = b = 0: perfectGas.
    Where rho c^2 < 0 the gas would condense, which it does not here. Above
    b rho = 0.99 the pole is left out (covolume.H).

    The gas starts with the pressure p0, or that of its points' stress.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | vanDerWaals                              | yes      |
        gamma    | > 1                                      | yes      |
        a        | attraction, >= 0                         | yes      | Pa m6/kg2
        b        | volume of the molecules, b rho < 0.99    | yes      | m3/kg
        p0       | pressure of the start, > 0               | yes      | Pa
    \endtable

    Reference: K.-M. Shyue, J. Comput. Phys. 156 (1999) 43-88.

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include "covolume.H"

namespace Foam::mpm
{

class vanDerWaalsEquation : public inlineEquation<vanDerWaalsEquation>
{
    scalar gamma_, a_, b_, p0_;

public:
    TypeName("vanDerWaals");

    vanDerWaalsEquation(const dictionary& dict, const scalar rho0) :
        inlineEquation<vanDerWaalsEquation>(rho0)
    {
        checkKeywords(dict, {"type", "gamma", "a", "b", "p0"});
        gamma_ = bounded(dict, "gamma", 1.000001, 100);
        a_ = bounded(dict, "a", 0, GREAT);
        b_ = bounded(dict, "b", 0, mostCovolume / rho0);
        p0_ = positive(dict, "p0");
        if (!(c2(rho0, e0()) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "At rho " << rho0 << " and p0 " << p0_ << " the equation has no"
                << " speed of sound (the gas would condense): gamma (p + a rho^2)"
                << " must be above 2 a rho^2 (1 - b rho)." << exit(FatalIOError);
        }
    }

    bool usesEnergy() const override { return true; }
    bool pressureByEnergy() const override { return true; }

    scalar e0() const override
    {
        const scalar r = rho0();
        return (p0_ + a_ * sqr(r)) * (1 - b_ * r) / ((gamma_ - 1) * r) - a_ * r;
    }

    bool hasTemperature() const override { return true; }
    scalar coldEnergy(const scalar rho) const override { return -a_ * rho; }

    terms of(const scalar rho) const
    {
        // A = a rho (B - rho)
        const covolume v(b_ * rho);
        const scalar B = (gamma_ - 1) * rho * v.factor;
        const scalar dB = (gamma_ - 1) * (v.factor + b_ * rho * v.slope);
        return {a_ * rho * (B - rho), B, a_ * (B - 2 * rho + rho * dB), dB};
    }
};

defineTypeNameAndDebug(vanDerWaalsEquation, 0);
addToRunTimeSelectionTable(equationOfState, vanDerWaalsEquation, dictionary);

} // End namespace Foam::mpm
