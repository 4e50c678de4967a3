/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "linearElastic.H"
#include "selector.H"
#include "leftStretch.H"
#include "spectral.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(linearElastic, 0);
    addToRunTimeSelectionTable(constitutiveModel, linearElastic, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- Strains up to this size go through the series of the logarithm
constexpr double seriesLimit = 0.5;

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::linearElastic::linearElastic(const dictionary& dict)
:
    constitutiveModel(dict)
{
    checkKeywords(dict, {"type", "rho", "E", "nu", "stress"});

    const scalar E = positive(dict, "E");
    const scalar nu = bounded(dict, "nu", -0.999, 0.499999);

    lambda_ = E*nu/((1 + nu)*(1 - 2*nu));
    mu_ = E/(2*(1 + nu));
    kirchhoff_ =
        oneOfOrDefault(dict, "stress", "Cauchy", {"Cauchy", "Kirchhoff"})
     == "Kirchhoff";
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int DIM>
void Foam::mpm::linearElastic::update(pointBlock& b) const
{
    constexpr int W = laneWidth<DIM>;
    constexpr int N = DIM*DIM;
    typedef lanes<W> T;

    // Largest velocity gradient and strain of the block choose the number of
    // terms for all its points
    const double dLMag = largestIncrement<DIM>(b);
    const int nExp = expTerms(dLMag);

    // |c'| <= (1 + |D|)^2 (1 + |c|) - 1 with |D| <= exp(|dL|) - 1
    const double cBound =
        std::exp(2*dLMag)*(1 + largestLeftStretch<DIM>(b)) - 1;
    const double q = cBound < 1 ? cBound/(2 - cBound) : 1.0;
    const bool series = q < seriesLimit;
    const int nLog = series ? logTerms(q) : 0;

    for (label p = 0; p < b.n; p += W)
    {
        const laneGroup<W> g(p, b.n);
        T c[N];
        updateLeftStretch<DIM>(b, g, nExp, c);

        T h[N];
        if (series)
        {
            logHalfSeries<DIM>(c, nLog, h);
        }
        else
        {
            for (int l = 0; l < g.n; ++l)
            {
                double c1[N], h1[N];
                for (int i = 0; i < N; ++i)
                {
                    c1[i] = c[i][l];
                }
                isotropicFunction<DIM>
                (
                    c1,
                    [](double x) { return 0.5*std::log1p(x); },
                    h1
                );
                for (int i = 0; i < N; ++i)
                {
                    h[i][l] = h1[i];
                }
            }
            for (int l = g.n; l < W; ++l)
            {
                for (int i = 0; i < N; ++i)
                {
                    h[i][l] = 0;
                }
            }
        }

        T trh = h[0];
        for (int i = 1; i < DIM; ++i)
        {
            trh += h[i*(DIM + 1)];
        }

        // sigma = s or s/J
        const T rJ =
            kirchhoff_
          ? g.get(b.mass)/(rho()*g.get(b.volume))
          : broadcast<W>(1);
        const T pressurePart = lambda_*trh*rJ;
        const T mu2 = 2*mu_*rJ;
        for (int i = 0; i < 3; ++i)
        {
            g.put
            (
                b.stress[i],
                i < DIM ? pressurePart + mu2*h[i*DIM + i] : pressurePart
            );
        }
        for (int i = 0; i < DIM; ++i)
        {
            for (int j = i + 1; j < DIM; ++j)
            {
                g.put(b.stress[symmSlot(i, j)], mu2*h[i*DIM + j]);
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::mpm::historyColumn>
Foam::mpm::linearElastic::history() const
{
    return List<historyColumn>
    (
        1,
        historyColumn{"leftStretch", historyColumn::symmetric}
    );
}


void Foam::mpm::linearElastic::correct(pointBlock& block) const
{
    switch (block.nDim)
    {
        case 1: update<1>(block); break;
        case 2: update<2>(block); break;
        default: update<3>(block);
    }
}


void Foam::mpm::linearElastic::initialise(pointBlock& b) const
{
    // s = lambda tr(h) I + 2 mu h inverted
    for (label p = 0; p < b.n; ++p)
    {
        double sigma[9];
        fullStress(b, p, sigma);

        // Strain of the computed directions only; J = rho0 v/m
        const int D = b.nDim;
        const scalar J = kirchhoff_ ? rho()*b.volume[p]/b.mass[p] : 1;
        scalar tr = 0;
        for (int i = 0; i < D; ++i)
        {
            tr += J*sigma[4*i];
        }
        tr /= D*lambda_ + 2*mu_;

        double h[9], c[9];
        for (int i = 0; i < 9; ++i)
        {
            h[i] =
                i/3 < D && i % 3 < D
              ? (J*sigma[i] - (i % 4 == 0 ? lambda_*tr : 0))/(2*mu_)
              : 0;
        }
        isotropicFunction<3>(h, [](double x) { return std::expm1(2*x); }, c);

        for (int i = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j)
            {
                b.history[strainSlot(D, i, j)][p] = c[3*i + j];
            }
        }
    }
}


Foam::scalar Foam::mpm::linearElastic::waveSpeed() const
{
    return std::sqrt((lambda_ + 2*mu_)/rho());
}


Foam::scalar Foam::mpm::linearElastic::strainEnergy(const pointBlock& b) const
{
    // From the stress: h = (s - lambda tr(h) I)/(2 mu)
    const int D = b.nDim;
    scalar sum = 0;
    for (label p = 0; p < b.n; ++p)
    {
        const scalar J = kirchhoff_ ? rho()*b.volume[p]/b.mass[p] : 1;
        scalar a = 0;
        for (int i = 0; i < D; ++i)
        {
            a += J*b.stress[i][p];
        }
        a /= D*lambda_ + 2*mu_;

        scalar hh = 0;
        for (int i = 0; i < D; ++i)
        {
            hh += sqr((J*b.stress[i][p] - lambda_*a)/(2*mu_));
            for (int j = i + 1; j < D; ++j)
            {
                hh += 2*sqr(J*b.stress[symmSlot(i, j)][p]/(2*mu_));
            }
        }
        scalar w = 0.5*lambda_*sqr(a) + mu_*hh;

        if (!kirchhoff_)
        {
            // 2 (exp(a) (a - 1) + 1)/a^2, by its series where a is small
            w *=
                mag(a) < 1e-3
              ? 1 + a*(2.0/3 + a*(0.25 + a/15))
              : 2*(std::exp(a)*(a - 1) + 1)/sqr(a);
        }
        sum += b.mass[p]/rho()*w;
    }
    return sum;
}

// ************************************************************************* //
