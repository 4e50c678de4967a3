/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::neoHookean

Description
    Compressible neo-Hookean elasticity:

        sigma = (lambda ln J I + mu (b - I))/J,
        b <- exp(dt L) b exp(dt L)^T,               J = rho0 v/m

    with the Cauchy stress sigma [Pa], tension positive, the left Cauchy-Green
    tensor b = F F^T [-] and Lame's constants lambda, mu [Pa] of E and nu; the
    same as the first Piola-Kirchhoff stress
    P = lambda ln J F^-T + mu (F - F^-T). The column "leftStretch" holds b - I
    (no cancellation at small strain). A rotation turns b and so sigma exactly:
    the law is objective. It is linear elasticity at small strain. In 1D and 2D
    F = 1 in the missing directions (plane strain), or what an initial stress
    needs, and their stress is kept.

    Stored energy [J] of a point, V0 = m/rho0:

        W = V0 (mu/2 (tr(b - I) - ln det b) + lambda/2 (ln J)^2)

    where ln det b = 2 ln J; hyperelastic, so W is the work done on every
    strain path. Taken from b and J, also where a failure model has reduced
    the stress: then W is what the unbroken point would store.

    Wave speed. waveSpeed() is that of the unstressed material. Along a
    principal stretch F1 the longitudinal wave has, in the current
    configuration,

        c^2 = (lambda (1 - ln J) + mu (1 + F1^2))/rho0,

    so it grows with compression where lambda > 2 mu (uniaxial strain), and
    with strong tension: at nu = 0 it is 1.6 times the initial one at
    F1 = J = 2. maxCo must be low enough to allow for that.

    Initial stress. J follows from mass and volume (1 from setMaterialPoints),
    so that b = I + (J sigma - lambda ln J I)/mu carries the stress of all
    directions exactly. b then differs from the b of a point that was strained to this stress,
    det b != J^2: the elastic constants are those of the unstressed material
    up to |sigma|/mu. Fatal where b would not be positive definite
    (pressure of mu and above at J = 1).

Usage
    \table
        Property | Description                          | Required | Unit
        type     | neoHookean                           | yes      |
        rho      | density of the unstressed material   | yes      | kg/m3
        E        | Young's modulus, > 0                 | yes      | Pa
        nu       | Poisson's ratio, -1 < nu < 0.5       | yes      | -
    \endtable

    Reference: J. Bonet, R. D. Wood, Nonlinear continuum mechanics for finite
    element analysis, Cambridge University Press (1997), chapter on
    hyperelasticity, compressible neo-Hookean material.

\*---------------------------------------------------------------------------*/

#include "isotropicElastic.H"
#include "spectral.H"

namespace Foam::mpm
{

namespace
{

//- |J - 1|/(J + 1) up to which ln J goes through its series: J from 1/3 to 3
constexpr double seriesLimit = 0.5;

//- Largest (J - 1)^2/(J + 1)^2 of the block
template<int W>
MPM_INLINE double largestVolumeChange(const pointBlock& b, const scalar rho)
{
    lanes<W> largest = {};
    forLaneGroups<W>(
        0, b.n, [&](const laneGroup<W> g) __attribute__((always_inline)) {
            const lanes<W> m = g.get(b.mass), m0 = rho * g.get(b.volume);
            const lanes<W> z = (m0 - m) / (m0 + m);
            largest = laneMax(largest, z * z);
        });
    return horizontalMax(largest);
}

//- x - ln(1 + x), without cancellation for small x
double minusLog1p(const double x)
{
    return mag(x) < 1e-3 ? x * x * (0.5 - x * (1.0 / 3 - x * (0.25 - x * (0.2 - x / 6))))
                         : x - std::log1p(x);
}

}

class neoHookean : public isotropicElastic<neoHookean>
{
public:
    TypeName("neoHookean");

    explicit neoHookean(const dictionary& dict) : isotropicElastic<neoHookean>(dict) {}

    //- Terms of a block: see isotropicElastic
    template<int DIM>
    class terms
    {
        static constexpr int W = laneWidth<DIM>;
        static constexpr int N = DIM * DIM;
        typedef lanes<W> T;

        const neoHookean& law_;

        //- Terms of the logarithm; none: volume changes too large for the series
        int nLog_;

    public:
        terms(const neoHookean& law, const pointBlock& b, const double) : law_(law), nLog_(0)
        {
            const double q = std::sqrt(largestVolumeChange<W>(b, law.rho()));
            if (q < seriesLimit)
            {
                nLog_ = logTerms(q);
            }
        }

        MPM_INLINE void stress(
            const pointBlock& b, const laneGroup<W>& g, const T (&c)[N], T& volumePart, T& factor,
            T (&a)[N], T (&side)[3]) const
        {
            const T m = g.get(b.mass), m0 = law_.rho() * g.get(b.volume);
            const T dJ[1] = {(m0 - m) / m};
            T lnJ[1];
            if (nLog_)
            {
                logHalfSeries<1>(dJ, nLog_, lnJ);
                lnJ[0] *= 2.0;
            }
            else
            {
                for (int l = 0; l < W; ++l)
                {
                    lnJ[0][l] = std::log1p(dJ[0][l]);
                }
            }

            const T rJ = m / m0;
            volumePart = law_.lambda() * rJ * lnJ[0];
            factor = law_.mu() * rJ;
            for (int i = 0; i < N; ++i)
            {
                a[i] = c[i];
            }
            for (int i = DIM; i < 3; ++i)
            {
                side[i] = g.get(b.history[i]);
            }
        }
    };

    //- Left stretch that carries a stress: see isotropicElastic
    std::string leftStretch(const double (&sigma)[9], const scalar J, double (&c)[9]) const;

    scalar strainEnergy(const pointBlock& b) const override
    {
        scalar sum = 0;
        for (label p = 0; p < b.n; ++p)
        {
            double c[9];
            fullTensor(b.history, b.nDim, p, c);

            // det b = 1 + I1 + I2 + I3 with the invariants of c = b - I
            const scalar I1 = c[0] + c[4] + c[8];
            const scalar I2 =
                c[0] * c[4] - sqr(c[1]) + c[0] * c[8] - sqr(c[2]) + c[4] * c[8] - sqr(c[5]);
            const scalar I3 = c[0] * (c[4] * c[8] - sqr(c[5])) - c[1] * (c[1] * c[8] - c[5] * c[2])
                + c[2] * (c[1] * c[5] - c[4] * c[2]);

            // tr c - ln det b: what is of first order in c has left
            const scalar shape = minusLog1p(I1 + I2 + I3) - I2 - I3;
            const scalar lnJ = std::log1p((rho() * b.volume[p] - b.mass[p]) / b.mass[p]);

            sum += b.mass[p] / rho() * 0.5 * (mu() * shape + lambda() * sqr(lnJ));
        }
        return sum;
    }
};

std::string neoHookean::leftStretch(const double (&sigma)[9], const scalar J, double (&c)[9]) const
{
    // J is known, so that the law is linear in b:
    // b - I = (J sigma - lambda ln J I)/mu
    const scalar volumePart = lambda() * std::log(J);

    double minusC[9];
    for (int i = 0; i < 9; ++i)
    {
        c[i] = (J * sigma[i] - (i % 4 == 0 ? volumePart : 0)) / mu();
        minusC[i] = -c[i];
    }

    // A stress that is not finite ends here too
    if (!(largestPrincipal(minusC) < 1 && largestPrincipal(c) < GREAT))
    {
        return "every principal stress has to be finite and above "
            + Foam::name((volumePart - mu()) / J) + " Pa";
    }
    return std::string();
}

defineTypeNameAndDebug(neoHookean, 0);
addToRunTimeSelectionTable(constitutiveModel, neoHookean, dictionary);

} // End namespace Foam::mpm
