/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::DruckerPrager

Description
    Drucker and Prager's cone; elasticity: frictionalLaw, entries: soilStrength.

        f = t + a s - k <= 0,       potential t + b s
        t = sqrt(J2), s = tr(sigma)/3, tension positive                  [Pa]

    a, k (with phi) and b (with psi) match Mohr and Coulomb's pyramid as match
    says:

        outer        6 sin/(sqrt(3)(3 - sin)),  k = 6 c cos/(sqrt(3)(3 - sin)):
                     its strength in triaxial compression
        inner        the same with 3 + sin: in triaxial extension
        planeStrain  3 tan/sqrt(9 + 12 tan^2),  k = 3 c/sqrt(9 + 12 tan^2):
                     collapse in plane strain

    Return to the cone: t = t' - G g, s = s' - K b g with
    g = f'/(G + K a b); where that has s above the least of tensionCutoff and
    the apex k/a, s is that limit and t the least of t' and the cone's.

Usage
    \table
        Property      | Description                          | Required | Unit
        type          | DruckerPrager                        | yes      |
        match         | outer, inner or planeStrain          | yes      |
        tensionCutoff | largest mean stress                  | no       | apex
        rho, E, nu, cohesion, frictionAngle, dilationAngle | see soilStrength | |
    \endtable

    References: D. C. Drucker, W. Prager, Quart. Appl. Math. 10 (1952) 157;
    E. de Souza Neto, D. Peric, D. Owen, Computational methods for plasticity,
    Wiley (2008), chapter 8.

\*---------------------------------------------------------------------------*/

#include "frictionalLaw.H"
#include "soilStrength.H"

namespace Foam::mpm
{

class DruckerPrager : public frictionalLaw<DruckerPrager>, soilStrength
{
    //- Slopes of cone and potential [-], strength [Pa], largest mean
    //  stress [Pa]
    scalar a_, b_, k_, sMax_;

public:
    TypeName("DruckerPrager");

    explicit DruckerPrager(const dictionary& dict) :
        frictionalLaw<DruckerPrager>(dict, keywords({"match"})), soilStrength(dict)
    {
        const word match(oneOf(dict, "match", {"outer", "inner", "planeStrain"}));
        const auto slope = [&](const scalar angle)
        {
            return match == "planeStrain"
                ? 3 * std::tan(angle) / std::sqrt(9 + 12 * sqr(std::tan(angle)))
                : 6 * std::sin(angle)
                    / (std::sqrt(3.0) * (3 + (match == "inner" ? 1 : -1) * std::sin(angle)));
        };
        a_ = slope(phi_);
        b_ = slope(psi_);
        k_ = match == "planeStrain" ? 3 * c_ / std::sqrt(9 + 12 * sqr(std::tan(phi_)))
                                    : 6 * c_ * std::cos(phi_)
                / (std::sqrt(3.0) * (3 + (match == "inner" ? 1 : -1) * std::sin(phi_)));
        sMax_ = min(tension_, a_ > 0 ? k_ / a_ : GREAT);
    }

    //- See frictionalLaw
    template<int DIM>
    MPM_INLINE void flow(
        const pointBlock&, const laneGroup<laneWidth<DIM>>&, elasticStrainStep<DIM>& step,
        lanes<laneWidth<DIM>>& theta, lanes<laneWidth<DIM>>& dEps) const
    {
        constexpr int W = laneWidth<DIM>;
        typedef lanes<W> T;

        T XX, XU, UU;
        step.products(XX, XU, UU);
        const T t0 = 2 * G_ * laneSqrt(0.5 * XX), s0 = K_ * theta;
        const T f = t0 + a_ * s0 - k_;
        const laneMask<W> flows = (f > 0.0) | (s0 > sMax_);
        if (!anyOf<W>(flows))
        {
            return;
        }

        const T g = laneMax(f, T{}) / (G_ + K_ * a_ * b_);
        T s = s0 - K_ * b_ * g;
        T t = t0 - G_ * g;
        const laneMask<W> cut = (s > sMax_) | (t < 0.0);
        s = select(cut, laneMin(s, broadcast<W>(sMax_)), s);
        t = select(cut, laneMax(laneMin(t0, k_ - a_ * s), T{}), t);

        const T factor = select(flows, t / select(t0 > 0.0, t0, broadcast<W>(1)), broadcast<W>(1));
        for (int i = 0; i < DIM * DIM; ++i)
        {
            step.X[i] *= factor;
        }
        for (int i = DIM; i < 3; ++i)
        {
            step.side[i] *= factor;
        }
        theta = select(flows, s / K_, theta);
        dEps = select(flows, (t0 - t) / (std::sqrt(3.0) * G_), T{});
    }
};

defineTypeNameAndDebug(DruckerPrager, 0);
addToRunTimeSelectionTable(constitutiveModel, DruckerPrager, dictionary);

} // End namespace Foam::mpm
