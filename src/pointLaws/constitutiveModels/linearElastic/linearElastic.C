/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::linearElastic

Description
    Isotropic elasticity, linear in the logarithmic strain (Hencky):

        s = lambda tr(h) I + 2 mu h,                h = log(b)/2,
        b <- exp(dt L) b exp(dt L)^T,               J = rho0 v/m

    with s = sigma, the Cauchy stress [Pa], tension positive (stress Cauchy,
    the default), or s = J sigma (stress Kirchhoff). h is the spatial Hencky
    strain [-], b the left Cauchy-Green tensor, of which the column
    "leftStretch" holds b - I (no cancellation at small strain). A rotation
    turns b and so sigma exactly: the law is objective. In 1D and 2D the
    strain of the missing directions is zero (plane strain), or stays that of
    an initial stress, and their stress is kept.

    Which stress. Uniaxial strain F at nu = 0 has the wave speed
    c^2 = c0^2/F (Cauchy) or c0^2 (1 - ln F)/F^2 (Kirchhoff) against the
    constant c0^2 of the linear theory: at 1 % compression the release runs
    0.5 % or 1.5 % faster. Cauchy is nearer to linear elasticity and is what
    plate impacts are compared with; Kirchhoff has a stored energy for every
    strain path (hyperelastic), Cauchy only up to the product of volume strain
    and shear strain.

    Stored energy [J] of a point, V0 = m/rho0, a = tr(h),
    w = (lambda a^2/2 + mu h:h):
        Kirchhoff  V0 w
        Cauchy     V0 w 2 (exp(a) (a - 1) + 1)/a^2, exact for a proportional
                   strain path

    Initial stress. The strain h that carries it, whatever the stress of the
    missing directions; J follows from mass and volume. Principal strains beyond
    3 (factor 20) are refused.

Usage
    \table
        Property | Description                          | Required | Unit
        type     | linearElastic                        | yes      |
        rho      | density of the unstressed material   | yes      | kg/m3
        E        | Young's modulus, > 0                 | yes      | Pa
        nu       | Poisson's ratio, -1 < nu < 0.5       | yes      | -
        stress   | Cauchy or Kirchhoff (see above)      | no       | Cauchy
    \endtable

    Reference: H. Hencky, Z. techn. Phys. 9 (1928) 215 (Cauchy stress) and
    Ann. Phys. 394 (1929) 617 (Kirchhoff stress).

\*---------------------------------------------------------------------------*/

#include "isotropicElastic.H"
#include "logHalf.H"

namespace Foam::mpm
{

namespace
{

//- Largest principal strain that an initial stress may need: beyond, 1 + c
//  has lost too many digits
constexpr double strainLimit = 3;

}

class linearElastic : public isotropicElastic<linearElastic>
{
    //- The law gives J sigma instead of sigma
    bool kirchhoff_;

public:
    TypeName("linearElastic");

    explicit linearElastic(const dictionary& dict) :
        isotropicElastic<linearElastic>(dict, wordList({"stress"}))
    {
        kirchhoff_ =
            oneOfOrDefault(dict, "stress", "Cauchy", {"Cauchy", "Kirchhoff"}) == "Kirchhoff";
    }

    //- Terms of a block: see isotropicElastic
    template<int DIM>
    class terms
    {
        static constexpr int W = laneWidth<DIM>;
        static constexpr int N = DIM * DIM;
        typedef lanes<W> T;

        const linearElastic& law_;

        //- Terms of the logarithm: see logHalfTerms
        int nLog_;

        //- Some point is strained in a missing direction
        bool across_;

    public:
        terms(const linearElastic& law, const pointBlock& b, const double dLMag) :
            law_(law), across_(false)
        {
            // |c'| <= (1 + |D|)^2 (1 + |c|) - 1 with |D| <= exp(|dL|) - 1
            const double cBound = std::exp(2 * dLMag) * (1 + largestLeftStretch<DIM>(b)) - 1;
            nLog_ = logHalfTerms(cBound);
            if (DIM < 3)
            {
                across_ = largestSquare<W, 3 - DIM, 3 - DIM>(b.history + DIM, b.n) > 0;
            }
        }

        MPM_INLINE void stress(
            const pointBlock& b, const laneGroup<W>& g, const T (&c)[N], T& volumePart, T& factor,
            T (&h)[N], T (&side)[3]) const
        {
            logHalf<W, DIM>(c, g.n, nLog_, h);

            T trh = h[0];
            for (int i = 1; i < DIM; ++i)
            {
                trh += h[i * (DIM + 1)];
            }
            for (int i = DIM; i < 3; ++i)
            {
                side[i] = T{};
                if (across_)
                {
                    const T ci[1] = {g.get(b.history[i])};
                    T hi[1];
                    logHalf<W, 1>(ci, g.n, nLog_, hi);
                    side[i] = hi[0];
                    trh += hi[0];
                }
            }

            // sigma = s or s/J
            const T rJ =
                law_.kirchhoff_ ? g.get(b.mass) / (law_.rho() * g.get(b.volume)) : broadcast<W>(1);
            volumePart = law_.lambda() * trh * rJ;
            factor = 2 * law_.mu() * rJ;
        }
    };

    //- Left stretch that carries a stress: see isotropicElastic
    std::string leftStretch(const double (&sigma)[9], const scalar J, double (&c)[9]) const;

    scalar strainEnergy(const pointBlock& b) const override
    {
        // From the stress: h = (s - lambda tr(h) I)/(2 mu)
        const int D = b.nDim;
        const scalar lambda = this->lambda(), mu = this->mu();
        scalar sum = 0;
        for (label p = 0; p < b.n; ++p)
        {
            const scalar J = kirchhoff_ ? rho() * b.volume[p] / b.mass[p] : 1;
            const scalar a =
                J * (b.stress[0][p] + b.stress[1][p] + b.stress[2][p]) / (3 * lambda + 2 * mu);

            scalar hh = 0;
            for (int i = 0; i < 3; ++i)
            {
                hh += sqr((J * b.stress[i][p] - lambda * a) / (2 * mu));
            }
            for (int i = 0; i < D; ++i)
            {
                for (int j = i + 1; j < D; ++j)
                {
                    hh += 2 * sqr(J * b.stress[symmSlot(i, j)][p] / (2 * mu));
                }
            }
            scalar w = 0.5 * lambda * sqr(a) + mu * hh;

            if (!kirchhoff_)
            {
                w *= cauchyEnergy(a);
            }
            sum += b.mass[p] / rho() * w;
        }
        return sum;
    }
};

std::string
linearElastic::leftStretch(const double (&sigma)[9], const scalar J, double (&c)[9]) const
{
    // s = lambda tr(h) I + 2 mu h inverted
    const scalar f = kirchhoff_ ? J : 1;
    const scalar trh = f * (sigma[0] + sigma[4] + sigma[8]) / (3 * lambda() + 2 * mu());

    double h[9], minusH[9];
    for (int i = 0; i < 9; ++i)
    {
        h[i] = (f * sigma[i] - (i % 4 == 0 ? lambda() * trh : 0)) / (2 * mu());
        minusH[i] = -h[i];
    }

    // A stress that is not finite ends here too
    const double high = largestPrincipal(h), low = -largestPrincipal(minusH);
    if (!(high <= strainLimit && low >= -strainLimit))
    {
        return "its principal logarithmic strains " + Foam::name(low) + " to " + Foam::name(high)
            + " must be in [" + Foam::name(-strainLimit) + ", " + Foam::name(strainLimit) + "]";
    }
    isotropicFunction<3>(
        h, [](double x) { return std::expm1(2 * x); }, c);

    return std::string();
}

defineTypeNameAndDebug(linearElastic, 0);
addToRunTimeSelectionTable(constitutiveModel, linearElastic, dictionary);

} // End namespace Foam::mpm
