/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "neoHookean.H"
#include "selector.H"
#include "leftStretch.H"
#include "spectral.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(neoHookean, 0);
    addToRunTimeSelectionTable(constitutiveModel, neoHookean, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- |J - 1|/(J + 1) up to which ln J goes through its series: J from 1/3 to 3
constexpr double seriesLimit = 0.5;


//- Largest (J - 1)^2/(J + 1)^2 of the block
template<int W>
MPM_INLINE double largestVolumeChange(const pointBlock& b, const scalar rho)
{
    lanes<W> largest = {};
    for (label p = 0; p < b.n; p += W)
    {
        const laneGroup<W> g(p, b.n);
        const lanes<W> m = g.get(b.mass), m0 = rho*g.get(b.volume);
        const lanes<W> z = (m0 - m)/(m0 + m);
        largest = laneMax(largest, z*z);
    }
    return horizontalMax(largest);
}


//- x - ln(1 + x), without cancellation for small x
double minusLog1p(const double x)
{
    return
        mag(x) < 1e-3
      ? x*x*(0.5 - x*(1.0/3 - x*(0.25 - x*(0.2 - x/6))))
      : x - std::log1p(x);
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::neoHookean::neoHookean(const dictionary& dict)
:
    constitutiveModel(dict)
{
    checkKeywords(dict, {"type", "rho", "E", "nu"});

    const scalar E = positive(dict, "E");
    const scalar nu = bounded(dict, "nu", -0.999, 0.499999);

    lambda_ = E*nu/((1 + nu)*(1 - 2*nu));
    mu_ = E/(2*(1 + nu));
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int DIM>
void Foam::mpm::neoHookean::update(pointBlock& b) const
{
    constexpr int W = laneWidth<DIM>;
    constexpr int N = DIM*DIM;
    typedef lanes<W> T;

    // Largest velocity gradient and volume change of the block choose the
    // number of terms for all its points
    const int nExp = expTerms(largestIncrement<DIM>(b));
    const double q = std::sqrt(largestVolumeChange<W>(b, rho()));
    const bool series = q < seriesLimit;
    const int nLog = series ? logTerms(q) : 0;

    for (label p = 0; p < b.n; p += W)
    {
        const laneGroup<W> g(p, b.n);
        T c[N];
        updateLeftStretch<DIM>(b, g, nExp, c);

        const T m = g.get(b.mass), m0 = rho()*g.get(b.volume);
        const T dJ[1] = {(m0 - m)/m};
        T lnJ[1];
        if (series)
        {
            logHalfSeries<1>(dJ, nLog, lnJ);
            lnJ[0] *= 2.0;
        }
        else
        {
            for (int l = 0; l < W; ++l)
            {
                lnJ[0][l] = std::log1p(dJ[0][l]);
            }
        }

        const T rJ = m/m0;
        const T volumePart = lambda_*rJ*lnJ[0];
        const T muJ = mu_*rJ;
        for (int i = 0; i < 3; ++i)
        {
            g.put
            (
                b.stress[i],
                i < DIM ? volumePart + muJ*c[i*DIM + i] : volumePart
            );
        }
        for (int i = 0; i < DIM; ++i)
        {
            for (int j = i + 1; j < DIM; ++j)
            {
                g.put(b.stress[symmSlot(i, j)], muJ*c[i*DIM + j]);
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::mpm::historyColumn>
Foam::mpm::neoHookean::history() const
{
    return List<historyColumn>
    (
        1,
        historyColumn{"leftStretch", historyColumn::symmetric}
    );
}


void Foam::mpm::neoHookean::correct(pointBlock& block) const
{
    switch (block.nDim)
    {
        case 1: update<1>(block); break;
        case 2: update<2>(block); break;
        default: update<3>(block);
    }
}


void Foam::mpm::neoHookean::initialise(pointBlock& b) const
{
    const int D = b.nDim;
    for (label p = 0; p < b.n; ++p)
    {
        double sigma[9];
        fullStress(b, p, sigma);

        // J is known, so that the law is linear in b:
        // b - I = (J sigma - lambda ln J I)/mu
        const scalar J = rho()*b.volume[p]/b.mass[p];
        const scalar volumePart =
            lambda_*std::log1p((rho()*b.volume[p] - b.mass[p])/b.mass[p]);

        // I - b, zero in the missing directions
        double minusC[9];
        for (int i = 0; i < 9; ++i)
        {
            minusC[i] =
                i/3 < D && i % 3 < D
              ? ((i % 4 == 0 ? volumePart : 0) - J*sigma[i])/mu_
              : 0;
        }

        // A stress that is not finite ends here too
        if (!(largestPrincipal(minusC) < 1))
        {
            FatalErrorInFunction
                << "The law " << type() << " cannot start with the stress"
                << " (xx yy zz xy xz yz) = (" << sigma[0] << ' ' << sigma[4]
                << ' ' << sigma[8] << ' ' << sigma[1] << ' ' << sigma[2]
                << ' ' << sigma[5] << ") Pa of point " << p << " at J = "
                << J << ": every principal stress has to be above "
                << (volumePart - mu_)/J << " Pa." << exit(FatalError);
        }

        for (int i = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j)
            {
                b.history[strainSlot(D, i, j)][p] = -minusC[3*i + j];
            }
        }
    }
}


Foam::scalar Foam::mpm::neoHookean::waveSpeed() const
{
    return std::sqrt((lambda_ + 2*mu_)/rho());
}


Foam::scalar Foam::mpm::neoHookean::strainEnergy(const pointBlock& b) const
{
    const int D = b.nDim;
    scalar sum = 0;
    for (label p = 0; p < b.n; ++p)
    {
        double c[9] = {};
        for (int i = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j)
            {
                c[3*i + j] = c[3*j + i] = b.history[strainSlot(D, i, j)][p];
            }
        }

        // det b = 1 + I1 + I2 + I3 with the invariants of c = b - I
        const scalar I1 = c[0] + c[4] + c[8];
        const scalar I2 =
            c[0]*c[4] - sqr(c[1]) + c[0]*c[8] - sqr(c[2])
          + c[4]*c[8] - sqr(c[5]);
        const scalar I3 =
            c[0]*(c[4]*c[8] - sqr(c[5])) - c[1]*(c[1]*c[8] - c[5]*c[2])
          + c[2]*(c[1]*c[5] - c[4]*c[2]);

        // tr c - ln det b: what is of first order in c has left
        const scalar shape = minusLog1p(I1 + I2 + I3) - I2 - I3;
        const scalar lnJ =
            std::log1p((rho()*b.volume[p] - b.mass[p])/b.mass[p]);

        sum += b.mass[p]/rho()*0.5*(mu_*shape + lambda_*sqr(lnJ));
    }
    return sum;
}

// ************************************************************************* //
