/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::linearEquation

Description
    p = K (rho/rho0 - 1): constant dp/drho, no energy.

    Stored energy K/rho0 (ln(rho/rho0) + rho0/rho - 1) [J/kg].

Usage
    \table
        Property | Description                              | Required | Unit
        type     | linear                                   | yes      |
        K        | bulk modulus, > 0                        | yes      | Pa
    \endtable

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include <cmath>

namespace Foam::mpm
{

class linearEquation : public inlineEquation<linearEquation>
{
    scalar K_;

public:
    TypeName("linear");

    linearEquation(const dictionary& dict, const scalar rho0) : inlineEquation<linearEquation>(rho0)
    {
        checkKeywords(dict, {"type", "K"});
        K_ = positive(dict, "K");
    }

    bool usesEnergy() const override { return false; }

    terms of(const scalar rho) const { return {K_ * (rho / rho0() - 1), 0, K_ / rho0(), 0}; }

    scalar storedEnergy(const scalar rho) const override
    {
        return K_ / rho0() * (std::log(rho / rho0()) + rho0() / rho - 1);
    }
};

defineTypeNameAndDebug(linearEquation, 0);
addToRunTimeSelectionTable(equationOfState, linearEquation, dictionary);

} // End namespace Foam::mpm
