/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::CochranChanEquation

Description
    Cochran and Chan: a solid or an explosive before it burns,

        p = p_c + Gamma0 rho (e - e_c),                 V = rho0/rho    [Pa]
        p_c = A V^-E1 - B V^-E2                                         [Pa]
        e_c = A/(rho0 (E1 - 1)) (V^(1 - E1) - 1)
            - B/(rho0 (E2 - 1)) (V^(1 - E2) - 1)                      [J/kg]
        rho c^2 = E1 A V^-E1 - E2 B V^-E2 + (1 + Gamma0)(p - p_c)       [Pa]

    Energies count from the cold material at rho0: e0 is Cv times the
    temperature of the start. There a pressure sets the density.

    Where it has expanded so far that rho c^2 < 0, the equation ends: a
    material that breaks needs a fluid beside it to fill the gaps.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | CochranChan                              | yes      |
        A        | > 0                                      | yes      | Pa
        B        | >= 0                                     | yes      | Pa
        E1       | > 1                                      | yes      |
        E2       | > 1                                      | yes      |
        Gamma0   | Grueneisen's coefficient, > 0            | yes      |
        p0       | pressure at rho0 and e0                  | yes      | Pa
    \endtable

    Reference: S. G. Cochran, J. Chan, UCID-18024 (1979); constants of copper and of
    TNT: K.-M. Shyue, J. Comput. Phys. 171 (2001) 678-707.

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include <cmath>

namespace Foam::mpm
{

class CochranChanEquation : public inlineEquation<CochranChanEquation>
{
    scalar A_, B_, E1_, E2_, Gamma0_, p0_;

public:
    TypeName("CochranChan");

    CochranChanEquation(const dictionary& dict, const scalar rho0) :
        inlineEquation<CochranChanEquation>(rho0)
    {
        checkKeywords(dict, {"type", "A", "B", "E1", "E2", "Gamma0", "p0"});
        A_ = positive(dict, "A");
        B_ = bounded(dict, "B", 0, GREAT);
        E1_ = bounded(dict, "E1", 1.000001, 100);
        E2_ = bounded(dict, "E2", 1.000001, 100);
        Gamma0_ = positive(dict, "Gamma0");
        p0_ = bounded(dict, "p0", -GREAT, GREAT);
        if (!(c2(rho0, e0()) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "At rho " << rho0 << " and p0 " << p0_ << " the equation has no"
                << " speed of sound: E1 A - E2 B + (1 + Gamma0)(p0 - A + B) must"
                << " be above 0." << exit(FatalIOError);
        }
    }

    bool usesEnergy() const override { return true; }
    scalar e0() const override { return (p0_ - A_ + B_) / (Gamma0_ * rho0()); }
    bool hasTemperature() const override { return true; }

    scalar coldEnergy(const scalar rho) const override
    {
        const scalar x = std::log(rho / rho0());
        return (A_ / (E1_ - 1) * std::expm1((E1_ - 1) * x)
                - B_ / (E2_ - 1) * std::expm1((E2_ - 1) * x))
            / rho0();
    }

    terms of(const scalar rho) const
    {
        // rho de_c/drho = p_c/rho
        const scalar x = rho / rho0();
        const scalar a = A_ * std::pow(x, E1_), b = B_ * std::pow(x, E2_);
        const scalar eCold =
            a / rho / (E1_ - 1) - b / rho / (E2_ - 1) - (A_ / (E1_ - 1) - B_ / (E2_ - 1)) / rho0();
        return {
            a - b - Gamma0_ * rho * eCold, Gamma0_ * rho,
            (E1_ * a - E2_ * b - Gamma0_ * (a - b)) / rho - Gamma0_ * eCold, Gamma0_};
    }
};

defineTypeNameAndDebug(CochranChanEquation, 0);
addToRunTimeSelectionTable(equationOfState, CochranChanEquation, dictionary);

} // End namespace Foam::mpm
