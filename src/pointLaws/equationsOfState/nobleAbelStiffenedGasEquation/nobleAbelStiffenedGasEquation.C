/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::nobleAbelStiffenedGasEquation

Description
    Noble and Abel's stiffened gas: a liquid, or a gas of powder, whose
    molecules attract each other (pInf) and have a volume of their own (b),

        p = (gamma - 1) rho (e - q)/(1 - b rho) - gamma pInf             [Pa]
        c^2 = gamma (p + pInf)/(rho (1 - b rho))                      [m2/s2]

    b = q = 0: stiffenedGas; pInf = 0: a gas of Noble and Abel. Above
    b rho = 0.99 the pole is left out (covolume.H).

    The material starts with the pressure p0, or that of its points' stress.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | nobleAbelStiffenedGas                    | yes      |
        gamma    | > 1 (water: 1.19)                        | yes      |
        pInf     | >= 0 (water: 7.028e8)                    | yes      | Pa
        b        | volume of the molecules, b rho < 0.99    | yes      | m3/kg
                 | (water: 6.61e-4)                         |          |
        q        | energy of reference (water: -1177788)    | yes      | J/kg
        p0       | pressure of the start, >= -pInf          | yes      | Pa
    \endtable

    Reference: O. Le Metayer, R. Saurel, Phys. Fluids 28 (2016) 046102.

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include "covolume.H"

namespace Foam::mpm
{

class nobleAbelStiffenedGasEquation : public inlineEquation<nobleAbelStiffenedGasEquation>
{
    scalar gamma_, pInf_, b_, q_, p0_;

public:
    TypeName("nobleAbelStiffenedGas");

    nobleAbelStiffenedGasEquation(const dictionary& dict, const scalar rho0) :
        inlineEquation<nobleAbelStiffenedGasEquation>(rho0)
    {
        checkKeywords(dict, {"type", "gamma", "pInf", "b", "q", "p0"});
        gamma_ = bounded(dict, "gamma", 1.000001, 100);
        pInf_ = bounded(dict, "pInf", 0, GREAT);
        b_ = bounded(dict, "b", 0, mostCovolume / rho0);
        q_ = bounded(dict, "q", -GREAT, GREAT);
        p0_ = bounded(dict, "p0", -pInf_, GREAT);
    }

    bool usesEnergy() const override { return true; }
    bool pressureByEnergy() const override { return true; }

    scalar e0() const override
    {
        const scalar v = (1 - b_ * rho0()) / rho0();
        return (p0_ + gamma_ * pInf_) * v / (gamma_ - 1) + q_;
    }

    bool hasTemperature() const override { return true; }

    scalar coldEnergy(const scalar rho) const override { return pInf_ * (1 / rho - b_) + q_; }

    bool isStiffened(scalar& gamma, scalar& pInf) const override
    {
        if (b_ == 0 && q_ == 0)
        {
            gamma = gamma_;
            pInf = pInf_;
        }
        return b_ == 0 && q_ == 0;
    }

    terms of(const scalar rho) const
    {
        const covolume v(b_ * rho);
        const scalar B = (gamma_ - 1) * rho * v.factor;
        const scalar dB = (gamma_ - 1) * (v.factor + b_ * rho * v.slope);
        return {-q_ * B - gamma_ * pInf_, B, -q_ * dB, dB};
    }
};

defineTypeNameAndDebug(nobleAbelStiffenedGasEquation, 0);
addToRunTimeSelectionTable(equationOfState, nobleAbelStiffenedGasEquation, dictionary);

} // End namespace Foam::mpm
