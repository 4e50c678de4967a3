/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::muI

Description
    Dense flow of grains: friction that grows with the rate of shear, after
    Jop, Forterre and Pouliquen; elasticity: frictionalLaw.

        t = mu(I) p,    mu = muS + (mu2 - muS)/(1 + I0/I)               [-]
        I = d g/sqrt(p/rhoS),  rhoS = rho/packing;  t = sqrt(J2)        [Pa]

    with the pressure p of the skeleton and the rate of plastic shear g =
    sqrt(2 De:De) of its deviator [1/s]; t < muS p: elastic. With viscosity eta
    of a liquid in the pores I is the viscous number eta g/(packing p). The
    step is implicit, t = t' - G dt g from the trial t': it ends on the surface
    of its own g whatever dt is.

    Grains do not pull: where the volume strain would be that of a tension,
    the stress is zero and the strain goes to the column openStrain, which has
    to close before there is a pressure again. Take dilatation cellMean:
    volumes of single points else drift, and part them.

    dilatancy, after Pailha and Pouliquen: with the volume fraction
    phi = packing m/(rho v) of a point

        phiEq = phiC - K2 I,    b = K3 (phi - phiEq)                    [-]
        dilation b g,           t = (mu(I) + b) p

    with phiEq >= 0, mu + b >= 0: dense grains expand when they are sheared,
    loose ones contract and lose their pressure to the liquid between them.
    Without it the flow keeps its volume.

    collisions: beside friction, the kinetic theory of granularCollisions.H with
    the volume fraction phi. In the column granularTemperature is T, and the
    stress gains

        m/v (-(P s^2 - L s div u) I + 2 M s dev(D)).

    3/2 m T counts as stored energy, what collisions lose is dissipated.

Usage
    \table
        Property  | Description                            | Required | Unit
        type      | muI                                    | yes      |
        rho, E, nu | see frictionalLaw                     | yes      |
        muS       | friction of slow flow, >= 0            | yes      | -
        mu2       | friction of fast flow, >= muS          | yes      | -
        I0        | number I of their mean, > 0            | yes      | -
        d         | diameter of the grains, > 0            | yes      | m
        packing   | volume fraction at rho, 0 to 1         | yes      | -
        viscosity | of the liquid in the pores, > 0 (volumeModel grains) | no | Pa s
        dilatancy | phiC (0 to 1), K2 (>= 0), K3 (>= 0)    | no       | -
        collisions | e (0 to 1), alphaMax (packing to 1),  | no       | -
                  | granularTemperature at the start (0)   |          | m2/s2
    \endtable
    packing is that of the region: its volumeFraction for volumeModel grains,
    where rho is that of a grain and the stress that of the volume m/rho; else
    rho/rhoS. With viscosity d is not needed but by collisions.

    References: P. Jop, Y. Forterre, O. Pouliquen, Nature 441 (2006) 727;
    M. Pailha, O. Pouliquen, J. Fluid Mech. 633 (2009) 115 (viscous number,
    dilatancy).

\*---------------------------------------------------------------------------*/

#include "frictionalLaw.H"
#include "granularCollisions.H"
#include <memory>

namespace Foam::mpm
{

class muI : public frictionalLaw<muI>
{
    //- Friction, number I of its mean, volume fraction at rho [-]
    scalar muS_, mu2_, I0_, packing_;

    //- I = scale_ g/p, viscous, or scale_ g/sqrt(p)
    bool viscous_;
    scalar scale_;

    //- Dilatancy [-]
    bool dilates_;
    scalar phiC_, K2_, K3_;

    std::unique_ptr<granularCollisions> collisions_;

    //- Trial pressure p and shear stress t of a point of volume fraction phi to
    //  those after a step of dt [s]
    void dilate(double& p, double& t, const double phi, const double dt) const;

    //- Shear stress after the step at constant volume: a quadratic equation for g
    template<class T>
    MPM_INLINE T sheared(const T p, const T t, const double dt) const
    {
        const double a = scale_ / dt;
        const T w = viscous_ ? p : laneSqrt(p);
        const T b = t * a - G_ * I0_ * w - mu2_ * p * a;
        const T c = laneMax(I0_ * w * (t - muS_ * p), T{});
        const T root = laneSqrt(b * b + 4 * G_ * a * c);
        const T under = select(b < 0.0, root - b, T{} + 1.0);
        return t - G_ * select(b < 0.0, 2.0 * c / under, (b + root) / (2 * G_ * a));
    }

    //- Volume fraction of grains of a point
    scalar fraction(const pointBlock& b, const label p) const
    {
        return packing_ * b.mass[p] / (rho() * b.volume[p]);
    }

    //- Granular temperature after the step; stress of the collisions
    void collide(pointBlock& b) const;

public:
    TypeName("muI");

    explicit muI(const dictionary& dict);

    List<historyColumn> history() const override
    {
        List<historyColumn> h(frictionalLaw<muI>::history());
        const label n = h.size();
        h.resize(collisions_ ? n + 2 : n + 1);
        h[n] = historyColumn{"openStrain", historyColumn::scalars};
        if (collisions_)
        {
            h[n + 1] = historyColumn{"granularTemperature", historyColumn::scalars};
        }
        return h;
    }

    bool needsWidth() const override { return bool(collisions_); }

    bool waveSpeedVaries() const override { return bool(collisions_); }

    void start(pointBlock& b) const override
    {
        if (collisions_)
        {
            scalar* T = b.history[nStress(b.nDim) + 2];
            std::fill(T, T + b.n, collisions_->T0());
        }
    }

    void correct(pointBlock& b) const override
    {
        frictionalLaw<muI>::correct(b);
        if (collisions_)
        {
            collide(b);
        }
    }

    scalar strainEnergy(const pointBlock& b) const override
    {
        scalar sum = frictionalLaw<muI>::strainEnergy(b);
        for (label p = 0; collisions_ && p < b.n; ++p)
        {
            sum += 1.5 * b.mass[p] * b.history[nStress(b.nDim) + 2][p];
        }
        return sum;
    }

    //- See frictionalLaw
    template<int DIM>
    MPM_INLINE void flow(
        const pointBlock& b, const laneGroup<laneWidth<DIM>>& g, elasticStrainStep<DIM>& step,
        lanes<laneWidth<DIM>>& theta, lanes<laneWidth<DIM>>& dEps) const
    {
        constexpr int W = laneWidth<DIM>;
        typedef lanes<W> T;

        scalar* open = b.history[nStress(DIM) + 1];
        const T gap = theta + g.get(open);
        g.put(open, laneMax(gap, T{}));
        theta = laneMin(gap, T{});

        T XX, XU, UU;
        step.products(XX, XU, UU);
        const T t0 = 2 * G_ * laneSqrt(0.5 * XX);
        T p = -K_ * theta, t = t0;
        if (dilates_)
        {
            for (int l = 0; l < g.n; ++l)
            {
                const double phi = fraction(b, g.first + l);
                double pl = p[l], tl = t[l];
                dilate(pl, tl, phi, b.dt);
                p[l] = pl;
                t[l] = tl;
            }
            theta = -p / K_;
        }
        else
        {
            const laneMask<W> flows = t0 > muS_ * p;
            if (!anyOf<W>(flows))
            {
                return;
            }
            t = select(flows, laneMax(sheared(p, t0, b.dt), T{}), t0);
            t = select(p > 0.0, t, T{});
        }

        const T factor = t / select(t0 > 0.0, t0, broadcast<W>(1));
        for (int i = 0; i < DIM * DIM; ++i)
        {
            step.X[i] *= factor;
        }
        for (int i = DIM; i < 3; ++i)
        {
            step.side[i] *= factor;
        }
        dEps = (t0 - t) / (std::sqrt(3.0) * G_);
    }
};

muI::muI(const dictionary& dict) :
    frictionalLaw<muI>(
        dict,
        wordList({"muS", "mu2", "I0", "d", "packing", "viscosity", "dilatancy", "collisions"})),
    muS_(bounded(dict, "muS", 0, GREAT)),
    mu2_(bounded(dict, "mu2", muS_, GREAT)),
    I0_(positive(dict, "I0")),
    packing_(bounded(dict, "packing", SMALL, 1)),
    viscous_(dict.found("viscosity")),
    scale_(
        viscous_ ? positive(dict, "viscosity") / packing_
                 : positive(dict, "d") * std::sqrt(rho() / packing_)),
    dilates_(dict.found("dilatancy")),
    phiC_(1),
    K2_(0),
    K3_(0)
{
    if (dilates_)
    {
        const dictionary& d = requiredDict(dict, "dilatancy");
        checkKeywords(d, {"phiC", "K2", "K3"});
        phiC_ = bounded(d, "phiC", 0, 1);
        K2_ = bounded(d, "K2", 0, GREAT);
        K3_ = bounded(d, "K3", 0, GREAT);
    }
    if (dict.found("collisions"))
    {
        collisions_.reset(new granularCollisions(
            requiredDict(dict, "collisions"), packing_, positive(dict, "d")));
    }
}

void muI::collide(pointBlock& b) const
{
    const int D = b.nDim;
    scalar* column = b.history[nStress(D) + 2];
    scalar fastest = 0;
    for (label p = 0; p < b.n; ++p)
    {
        // Rate of strain; the missing directions have none but a hoop
        scalar d[6] = {}, div = 0, dd = 0;
        for (int i = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j)
            {
                d[symmSlot(i, j)] = 0.5 * (b.dL[i * D + j][p] + b.dL[j * D + i][p]) / b.dt;
            }
        }
        d[2] += b.hoop ? b.hoop[p] / b.dt : 0;
        for (int i = 0; i < 6; ++i)
        {
            div += i < 3 ? d[i] : 0;
            dd += (i < 3 ? 1 : 2) * sqr(d[i]);
        }
        const granularCollisions::factors f = collisions_->at(fraction(b, p), b.width[p]);
        const scalar B = 2 * f.M * (dd - div * div / 3) + f.L * div * div;
        const scalar s0 = std::sqrt(column[p]);
        const scalar s = collisions_->advance(s0, f.P, div, B, f.N, b.dt);
        column[p] = s * s;
        if (b.dissipated)
        {
            const scalar work = 0.5 * b.dt * (B * (s0 + s) - f.P * div * (sqr(s0) + sqr(s)));
            b.dissipated[p] += b.mass[p] * (work - 1.5 * (sqr(s) - sqr(s0)));
        }
        const scalar density = b.mass[p] / b.volume[p];
        for (int i = 0; i < nStress(D); ++i)
        {
            const scalar pressure = f.P * s * s - (f.L - 2 * f.M / 3) * s * div;
            b.stress[i][p] += density * (2 * f.M * s * d[i] - (i < 3 ? pressure : 0));
        }
        // Waves, and the diffusion of momentum as in NewtonianFluid
        fastest = max(fastest, s * (std::sqrt(f.c2) + 2 * D * (4.0 / 3 * f.M + f.L) / b.width[p]));
    }
    b.waveSpeed = max(b.waveSpeed, waveSpeed() + fastest);
}

void muI::dilate(double& p, double& t, const double phi, const double dt) const
{
    if (p <= 0 || t <= 0)
    {
        t = 0;
        return;
    }
    const double p0 = p, t0 = t, a = scale_ / dt;

    // Pressure and shear stress where the number is I, and what t has too much:
    // of p = p0 + K b g and I = a g/w(p)
    const auto excess = [&](const double I)
    {
        const double b = K3_ * (phi - max(phiC_ - K2_ * I, 0.0)), c = K_ * b * I / a;
        if (viscous_ && c >= 1)
        {
            return -GREAT;
        }
        const double root = std::sqrt(c * c + 4 * p0);
        const double w = viscous_ ? p0 / (1 - c) : c < 0 ? 2 * p0 / (root - c) : 0.5 * (c + root);
        p = viscous_ ? w : w * w;
        t = t0 - G_ * I * w / a;
        const double mu = muS_ + (I > 0 ? (mu2_ - muS_) / (1 + I0_ / I) : 0.0);
        return t - max(mu + b, 0.0) * p;
    };

    double low = 0, fLow = excess(0);
    if (fLow <= 0)
    {
        return;
    }
    double high = t0 / G_ * a / (viscous_ ? p0 : std::sqrt(p0)), fHigh = excess(high);
    for (int i = 0; fHigh > 0 && i < 200; ++i)
    {
        low = high;
        fLow = fHigh;
        fHigh = excess(high *= 4);
    }

    // Regula falsi that halves the value of an end that stays (Illinois); bisection beside it
    for (int i = 0, last = 0; i < 100 && high - low > 1e-14 * high; ++i)
    {
        const double secant = (low * fHigh - high * fLow) / (fHigh - fLow);
        const bool inside = i % 4 < 3 && secant > low && secant < high;
        const double I = inside ? secant : 0.5 * (low + high), f = excess(I);
        if (mag(f) <= 1e-13 * t0)
        {
            break;
        }
        const int side = f > 0 ? 1 : -1;
        (f > 0 ? low : high) = I;
        (f > 0 ? fLow : fHigh) = f;
        (f > 0 ? fHigh : fLow) *= side == last ? 0.5 : 1;
        last = side;
    }
    t = max(t, 0.0);
}

defineTypeNameAndDebug(muI, 0);
addToRunTimeSelectionTable(constitutiveModel, muI, dictionary);

} // End namespace Foam::mpm
