/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::MieGrueneisenEquation

Description
    Mie-Grueneisen with the Hugoniot Us = C0 + S up as reference and
    Gamma rho = Gamma0 rho0:

        p = pH (1 - Gamma0 x/2) + Gamma0 rho0 e,       x = 1 - rho0/rho
        pH = rho0 C0^2 x/(1 - S x)^2,                              x >= 0
        pH = rho0 C0^2 (rho/rho0 - 1), without Gamma0 x/2,         x < 0

    with e = 0 at rho0 without pressure. On the Hugoniot e = pH x/(2 rho0) gives
    back p = pH. The pole at x = 1/S cannot be reached by matter; from
    S x = 0.9 on the first term goes on along its tangent in x, so that a point
    that is numerically compressed so far still pushes back.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | MieGrueneisen                            | yes      |
        C0       | speed of a weak shock, > 0               | yes      | m/s
        S        | slope of Us over up, >= 0                | yes      | -
        Gamma0   | Grueneisen parameter, >= 0               | yes      | -
    \endtable

    Reference: M. A. Meyers, Dynamic behavior of materials, Wiley (1994),
    chapters 4 and 5.

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include <cmath>

namespace Foam::mpm
{

class MieGrueneisenEquation : public inlineEquation<MieGrueneisenEquation>
{
    scalar C0_, S_, Gamma0_;

    //- Compression up to which the curve is taken: S x = 0.9
    scalar yMost_;

public:
    TypeName("MieGrueneisen");

    MieGrueneisenEquation(const dictionary& dict, const scalar rho0) :
        inlineEquation<MieGrueneisenEquation>(rho0)
    {
        checkKeywords(dict, {"type", "C0", "S", "Gamma0"});
        C0_ = positive(dict, "C0");
        S_ = bounded(dict, "S", 0, 10);
        Gamma0_ = bounded(dict, "Gamma0", 0, 10);
        yMost_ = S_ > 0 ? 0.9 / S_ : GREAT;
    }

    bool usesEnergy() const override { return Gamma0_ > 0; }

    terms of(const scalar rho) const
    {
        // Both branches, without a jump: the sign changes from point to point
        const scalar r0 = rho0(), rRho = 1 / rho, x = 1 - r0 * rRho;
        const scalar y = max(min(x, yMost_), scalar(0));
        const scalar d = 1 / (1 - S_ * y), k = r0 * sqr(C0_ * d);
        const scalar pH = k * y, f = 1 - 0.5 * Gamma0_ * y;
        const scalar slope = k * (1 + S_ * y) * d * f - 0.5 * Gamma0_ * pH;
        const scalar A = pH * f + slope * (x - y), dA = slope * r0 * sqr(rRho);
        return {x < 0 ? sqr(C0_) * (rho - r0) : A, Gamma0_ * r0, x < 0 ? sqr(C0_) : dA, 0};
    }

    scalar storedEnergy(const scalar rho) const override
    {
        // Gamma0 = 0: integral of pH dx/rho0
        const scalar x = 1 - rho0() / rho, y = x < yMost_ ? x : yMost_;
        if (x < 0)
        {
            return sqr(C0_) * (std::log(rho / rho0()) + rho0() / rho - 1);
        }
        const scalar d = 1 / (1 - S_ * y), z = S_ * y;
        const scalar curve = z < 1e-3 ? sqr(y) * (0.5 + z * (2.0 / 3 + 0.75 * z))
                                      : (std::log1p(-z) + z * d) / sqr(S_);
        const scalar pH = sqr(C0_ * d) * y, slope = sqr(C0_ * d) * (1 + z) * d;
        return sqr(C0_) * curve + (x - y) * (pH + 0.5 * slope * (x - y));
    }
};

defineTypeNameAndDebug(MieGrueneisenEquation, 0);
addToRunTimeSelectionTable(equationOfState, MieGrueneisenEquation, dictionary);

} // End namespace Foam::mpm
