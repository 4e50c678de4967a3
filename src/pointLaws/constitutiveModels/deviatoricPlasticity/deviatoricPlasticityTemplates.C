/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    Included by deviatoricPlasticity.H.

\*---------------------------------------------------------------------------*/

#include "dictionaryTools.H"
#include "elasticStrain.H"
#include "laneMath.H"

namespace Foam
{
namespace mpm
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Law>
deviatoricPlasticity<Law>::deviatoricPlasticity(const dictionary& dict, const wordList& keywords)
:
    constitutiveModel(dict),
    G_(elasticConstants(dict).G),
    pressure_(dict, rho(), elasticConstants(dict).K),
    betaOverCp_(0),
    rCp_(0),
    startT_(0)
{
    wordList valid({"type", "rho"});
    valid.append(elasticConstants::keywords);
    valid.append(pressurePart::keywords);
    valid.append(keywords);
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Law>
template<int W>
MPM_INLINE lanes<W> deviatoricPlasticity<Law>::flow
(
    const lanes<W> q,
    const lanes<W> eps,
    const lanes<W> soft,
    const scalar dt
) const
{
    typedef lanes<W> T;
    const Law& law = static_cast<const Law&>(*this);
    const scalar threeG = 3*G_, rdt = 1/dt;

    T Y, slope, rateSlope;
    law.strength(eps, T{}, soft, Y, slope, rateSlope);
    const laneMask<W> flows = q > Y;
    if (!anyOf<W>(flows))
    {
        return T{};
    }

    // g(x) = q - 3 G x - Y(eps + x, x/dt) falls with x: low and high enclose
    // its root; convergence is quadratic, so that 1e-6 of the excess is the
    // last step but one
    const T excess = q - Y;
    T x = excess/threeG, low = {}, high = x;
    for (int i = 0; i < 100; ++i)
    {
        law.strength(eps + x, rdt*x, soft, Y, slope, rateSlope);
        const T g = q - threeG*x - Y;
        low = select(g > 0.0, x, low);
        high = select(g > 0.0, high, x);
        const T next = x + g/(threeG + slope + rdt*rateSlope);
        const laneMask<W> far = laneAbs(g) > 1e-6*excess;
        x = select
        (
            (next > low) & (next <= high),
            next,
            select(far, 0.5*(low + high), x)
        );
        if (!anyOf<W>(flows & far))
        {
            break;
        }
    }
    return select(flows, x, T{});
}


template<class Law>
template<int DIM>
void deviatoricPlasticity<Law>::update(pointBlock& b) const
{
    constexpr int W = laneWidth<DIM>;
    typedef lanes<W> T;

    const Law& law = static_cast<const Law&>(*this);
    scalar* plastic = b.history[nStress(DIM)];
    scalar* temperature = Law::thermal ? b.history[nStress(DIM) + 1] : nullptr;
    scalar* energy =
        pressure_.usesEnergy()
      ? b.history[nStress(DIM) + (Law::thermal ? 2 : 1)]
      : nullptr;

    elasticStrainStep<DIM> step(b);
    pressurePart::run r;
    r.dt = b.dt;

    for (label first = 0; first < b.n; first += pressurePart::maxRun)
    {
        const label end = min(b.n, first + pressurePart::maxRun);
        r.n = end - first;
        for (label p = first; p < end; p += W)
        {
            const laneGroup<W> g(p, end);
            step.trial(b, g);
            const T theta = step.theta;
            step.deviator();
            T XX, XU, UU;
            step.products(XX, XU, UU);

            const T q = 2*G_*laneSqrt(1.5*XX);
            T eps = g.get(plastic), Tp = {}, soft = broadcast<W>(1);
            if constexpr (Law::thermal)
            {
                Tp = g.get(temperature);
                soft = law.softening(Tp);
            }
            const T dEps = this->template flow<W>(q, eps, soft, b.dt);
            const T factor =
                1.0 - 3*G_*dEps/select(q > 0.0, q, broadcast<W>(1));
            g.put(plastic, eps + dEps);

            const T rhoNew = rho()*laneExp(-theta);
            store<W>(r.rho + (p - first), rhoNew);
            store<W>(r.dTheta + (p - first), step.dTheta);
            if (b.dissipated && !energy)
            {
                r.keepMean(b, g, p - first);

                // Mean of old and new deviator times the plastic strain
                store<W>
                (
                    r.rhoOld + (p - first),
                    rho()*laneExp(step.dTheta - theta)
                );
                g.put
                (
                    b.dissipated,
                    g.get(b.dissipated)
                  + g.get(b.mass)*(1.0 - 0.5*step.dTheta)/rhoNew
                   *G_*(1.0 - factor)*((1.0 + factor)*XX - XU)
                );
            }
            if (Law::thermal || energy)
            {
                // 1/rho in the middle of the step
                const T rRho = (1.0 - 0.5*step.dTheta)/rhoNew;
                if constexpr (Law::thermal)
                {
                    g.put
                    (
                        temperature,
                        Tp + betaOverCp_*rRho*factor*q*dEps
                    );
                }
                if (energy)
                {
                    store<W>
                    (
                        r.rhoOld + (p - first),
                        rho()*laneExp(step.dTheta - theta)
                    );
                    store<W>
                    (
                        r.work + (p - first),
                        G_*rRho
                       *(
                            (1.0 + factor)*XU - UU
                          + step.dTheta*step.dTheta/3.0
                        )
                    );
                }
            }
            step.finish(b, g, factor, theta/3.0, broadcast<W>(2*G_), T{});
        }

        b.waveSpeed = max
        (
            b.waveSpeed,
            pressure_.advance(r, b, first, energy ? energy + first : nullptr, G_)
        );
        r.addTo(b, first);
        if (Law::thermal && energy)
        {
            scalar* Tp = temperature + first;
            for (label k = 0; k < r.n; ++k)
            {
                // exp(a) to second order
                const scalar a = 0.5*r.isentropic[k];
                Tp[k] = Tp[k]*(1 + a)/(1 - a) + rCp_*r.heat[k];
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Law>
List<historyColumn> deviatoricPlasticity<Law>::history() const
{
    List<historyColumn> h(2 + Law::thermal + pressure_.usesEnergy());
    h[0] = historyColumn{"elasticStrain", historyColumn::stresses};
    h[1] = historyColumn{"plasticStrain", historyColumn::scalars};
    if (Law::thermal)
    {
        h[2] = historyColumn{"T", historyColumn::scalars};
    }
    if (pressure_.usesEnergy())
    {
        h.last() = historyColumn{"e", historyColumn::scalars};
    }
    return h;
}


template<class Law>
void deviatoricPlasticity<Law>::start(pointBlock& b) const
{
    const int next = nStress(b.nDim) + 1;
    for (label p = 0; p < b.n; ++p)
    {
        if (Law::thermal)
        {
            b.history[next][p] = startT_;
        }
        if (pressure_.usesEnergy())
        {
            b.history[next + Law::thermal][p] = pressure_.equation().e0();
        }
    }
}


template<class Law>
void deviatoricPlasticity<Law>::initialise(pointBlock& b) const
{
    const int n = nStress(b.nDim);
    for (label p = 0; p < b.n; ++p)
    {
        const scalar mean =
            (b.stress[0][p] + b.stress[1][p] + b.stress[2][p])/3;
        scalar theta, e;
        pressure_.stateOf(-mean, b, p, theta, e);
        for (int i = 0; i < n; ++i)
        {
            b.history[i][p] =
                i < 3
              ? (b.stress[i][p] - mean)/(2*G_) + theta/3
              : b.stress[i][p]/(2*G_);
        }
        if (pressure_.usesEnergy())
        {
            b.history[n + 1 + Law::thermal][p] = e;
        }
    }
}


template<class Law>
void deviatoricPlasticity<Law>::correct(pointBlock& b) const
{
    switch (b.nDim)
    {
        case 1: update<1>(b); break;
        case 2: update<2>(b); break;
        default: update<3>(b);
    }
}


template<class Law>
scalar deviatoricPlasticity<Law>::waveSpeed() const
{
    return std::sqrt((pressure_.bulkModulus() + 4.0/3*G_)/rho());
}


template<class Law>
scalar deviatoricPlasticity<Law>::elasticModulus() const
{
    const scalar K = pressure_.bulkModulus();
    return 9*G_*(K/(3*K + G_));
}


template<class Law>
scalar deviatoricPlasticity<Law>::strainEnergy(const pointBlock& b) const
{
    const int n = nStress(b.nDim);
    const scalar* energy =
        pressure_.usesEnergy() ? b.history[n + 1 + Law::thermal] : nullptr;
    scalar sum = 0;
    for (label p = 0; p < b.n; ++p)
    {
        const scalar theta =
            b.history[0][p] + b.history[1][p] + b.history[2][p];
        const scalar rhoNow = rho()*std::exp(-theta);
        sum +=
            b.mass[p]*pressure_.energy(rhoNow, energy ? energy + p : nullptr);
        if (!energy)
        {
            scalar hh = 0;
            for (int i = 0; i < n; ++i)
            {
                hh +=
                    i < 3
                  ? sqr(b.history[i][p] - theta/3)
                  : 2*sqr(b.history[i][p]);
            }
            sum += b.mass[p]/rhoNow*G_*hh;
        }
    }
    return sum;
}

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
