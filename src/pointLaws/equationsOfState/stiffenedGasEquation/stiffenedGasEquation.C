/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::stiffenedGasEquation

Description
    p = (gamma - 1) rho e - gamma pInf: a liquid under strong compression;
    c^2 = gamma (p + pInf)/rho.

    The material starts with the pressure p0, or that of its points' stress.

    A flow of the velocity u does not feel the liquid's compressibility while u
    is far below c. A softer one takes larger time steps: with soundSpeed

        pInf = rho0 soundSpeed^2/gamma - p0

    and density changes by u^2/c^2, 1 % at u = 0.1 c, beyond which a run of
    fluids warns.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | stiffenedGas                             | yes      |
        gamma    | > 1 (water: 4.4)                         | yes      | -
        pInf     | > 0 (water: 6e8)                         | or soundSpeed | Pa
        soundSpeed | of the start, of a liquid that is softened | or pInf | m/s
        p0       | pressure of the start                    | yes      | Pa
    \endtable

    Reference: R. Saurel, R. Abgrall, J. Comput. Phys. 150 (1999) 425.

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include <cmath>

namespace Foam::mpm
{

class stiffenedGasEquation : public inlineEquation<stiffenedGasEquation>
{
    scalar gamma_, pInf_, p0_;

    //- Entry soundSpeed; 0: none
    scalar softened_;

public:
    TypeName("stiffenedGas");

    stiffenedGasEquation(const dictionary& dict, const scalar rho0) :
        inlineEquation<stiffenedGasEquation>(rho0), softened_(0)
    {
        checkKeywords(dict, {"type", "gamma", "pInf", "soundSpeed", "p0"});
        gamma_ = bounded(dict, "gamma", 1.000001, 100);
        if (!dict.found("soundSpeed"))
        {
            pInf_ = positive(dict, "pInf");
            p0_ = bounded(dict, "p0", -pInf_, GREAT);
            return;
        }
        if (dict.found("pInf"))
        {
            FatalIOErrorInFunction(dict)
                << "Entries pInf and soundSpeed in " << dict.name()
                << " say the same thing; give just one of them." << exit(FatalIOError);
        }
        softened_ = positive(dict, "soundSpeed");
        p0_ = bounded(dict, "p0", -GREAT, GREAT);
        pInf_ = rho0 * sqr(softened_) / gamma_ - p0_;
        if (!(pInf_ > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry soundSpeed " << softened_ << " in " << dict.name()
                << " is too small for the pressure p0 " << p0_ << " Pa: at " << rho0
                << " kg/m3 it must be above sqrt(gamma p0/rho) " << std::sqrt(gamma_ * p0_ / rho0)
                << " m/s."
                << (rho0 < 100 ? " Is rho in kg/m3? Water has 1000, no liquid less than 100." : "")
                << exit(FatalIOError);
        }
    }

    bool usesEnergy() const override { return true; }
    bool pressureByEnergy() const override { return true; }

    scalar e0() const override { return (p0_ + gamma_ * pInf_) / ((gamma_ - 1) * rho0()); }

    bool hasTemperature() const override { return true; }
    scalar softened() const override { return softened_; }
    scalar coldEnergy(const scalar rho) const override { return pInf_ / rho; }

    bool isStiffened(scalar& gamma, scalar& pInf) const override
    {
        gamma = gamma_;
        pInf = pInf_;
        return true;
    }

    terms of(const scalar rho) const
    {
        return {-gamma_ * pInf_, (gamma_ - 1) * rho, 0, gamma_ - 1};
    }
};

defineTypeNameAndDebug(stiffenedGasEquation, 0);
addToRunTimeSelectionTable(equationOfState, stiffenedGasEquation, dictionary);

} // End namespace Foam::mpm
