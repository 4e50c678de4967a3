/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::perfectGasEquation

Description
    p = (gamma - 1) rho e.

    The gas starts with the pressure p0, or that of its points' stress.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | perfectGas                               | yes      |
        gamma    | ratio of heat capacities, > 1            | yes      | -
        p0       | pressure of the start, > 0               | yes      | Pa
    \endtable

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include <cmath>

namespace Foam::mpm
{

class perfectGasEquation : public inlineEquation<perfectGasEquation>
{
    scalar gamma_, p0_;

public:
    TypeName("perfectGas");

    perfectGasEquation(const dictionary& dict, const scalar rho0) :
        inlineEquation<perfectGasEquation>(rho0)
    {
        checkKeywords(dict, {"type", "gamma", "p0"});
        gamma_ = bounded(dict, "gamma", 1.000001, 100);
        p0_ = positive(dict, "p0");
    }

    bool usesEnergy() const override { return true; }
    bool pressureByEnergy() const override { return true; }
    scalar e0() const override { return p0_ / ((gamma_ - 1) * rho0()); }
    bool hasTemperature() const override { return true; }
    scalar coldEnergy(const scalar) const override { return 0; }

    bool isStiffened(scalar& gamma, scalar& pInf) const override
    {
        gamma = gamma_;
        pInf = 0;
        return true;
    }

    terms of(const scalar rho) const { return {0, (gamma_ - 1) * rho, 0, gamma_ - 1}; }
};

defineTypeNameAndDebug(perfectGasEquation, 0);
addToRunTimeSelectionTable(equationOfState, perfectGasEquation, dictionary);

} // End namespace Foam::mpm
