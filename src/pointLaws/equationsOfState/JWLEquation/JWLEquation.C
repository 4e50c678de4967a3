/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::JWLEquation

Description
    Jones, Wilkins and Lee: products of an explosive,

        p = A (1 - omega/(R1 V)) exp(-R1 V) + B (1 - omega/(R2 V)) exp(-R2 V)
          + omega rho e,                                     V = rho0/rho

    The products start with the energy E0 per volume of the explosive, or with
    the pressure of their points' stress.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | JWL                                      | yes      |
        A        | > 0                                      | yes      | Pa
        B        |                                          | yes      | Pa
        R1       | > 0                                      | yes      | -
        R2       | > 0                                      | yes      | -
        omega    | > 0                                      | yes      | -
        E0       | energy per volume at the start, > 0      | yes      | J/m3
    \endtable

    Reference: E. L. Lee, H. C. Hornig, J. W. Kury, UCRL-50422 (1968).

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include <cmath>

namespace Foam::mpm
{

class JWLEquation : public inlineEquation<JWLEquation>
{
    scalar A_, B_, R1_, R2_, omega_, E0_;

public:
    TypeName("JWL");

    JWLEquation(const dictionary& dict, const scalar rho0) : inlineEquation<JWLEquation>(rho0)
    {
        checkKeywords(dict, {"type", "A", "B", "R1", "R2", "omega", "E0"});
        A_ = positive(dict, "A");
        B_ = bounded(dict, "B", -GREAT, GREAT);
        R1_ = positive(dict, "R1");
        R2_ = positive(dict, "R2");
        omega_ = positive(dict, "omega");
        E0_ = positive(dict, "E0");
    }

    bool usesEnergy() const override { return true; }
    bool pressureByEnergy() const override { return true; }
    bool ofReaction() const override { return true; }
    scalar e0() const override { return E0_ / rho0(); }
    bool hasTemperature() const override { return true; }

    scalar coldEnergy(const scalar rho) const override
    {
        const scalar V = rho0() / rho;
        return (A_ / R1_ * std::exp(-R1_ * V) + B_ / R2_ * std::exp(-R2_ * V)) / rho0();
    }

    terms of(const scalar rho) const
    {
        const scalar V = rho0() / rho;
        const scalar a = A_ * std::exp(-R1_ * V), b = B_ * std::exp(-R2_ * V);
        const scalar u = omega_ / (R1_ * V), w = omega_ / (R2_ * V);
        const scalar dV = a * (u / V - R1_ * (1 - u)) + b * (w / V - R2_ * (1 - w));
        return {a * (1 - u) + b * (1 - w), omega_ * rho, -dV * V / rho, omega_};
    }
};

defineTypeNameAndDebug(JWLEquation, 0);
addToRunTimeSelectionTable(equationOfState, JWLEquation, dictionary);

} // End namespace Foam::mpm
