/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::NewtonianFluid

Description
    Compressible viscous fluid:

        sigma = -(p + q) I + 2 mu dev(D)                               [Pa]

    with the pressure of pressurePart, the viscosity mu and the rate of strain D
    of the step, log(U)/dt turned by R with exp(dt L) = R U: a superposed
    rotation turns it exactly. Viscous work goes into the internal energy where the
    equation of state has one. Columns: volumeStrain, ln(rho0/rho), and e.

    The time step also obeys the diffusion of momentum: the wave speed of the
    state is c + 2 nDim 4 mu/(3 rho l) with the width l of the cell.

    pMin cuts the pressure off below (0: a liquid that cannot be pulled); the
    stored energy then is that of the pressure that is left (pressurePart).
    Viscous work goes into e, or is dissipated (pointBlock).

    Initial stress: its pressure only; a deviator is fatal.

Usage
    \table
        Property | Description                               | Required | Unit
        type     | NewtonianFluid                            | yes      |
        rho      | density of the reference state            | yes      | kg/m3
        mu       | viscosity, >= 0                           | yes      | Pa s
        pMin     | least pressure                            | no       | none
        K, equationOfState, bulkViscosity | see pressurePart | yes     |
    \endtable

\*---------------------------------------------------------------------------*/

#include "constitutiveModel.H"
#include "pressurePart.H"
#include "elasticStrain.H"
#include "laneMath.H"

namespace Foam::mpm
{

class NewtonianFluid : public constitutiveModel
{
    //- Viscosity [Pa s]
    scalar mu_;

    pressurePart pressure_;

    template<int DIM>
    void update(pointBlock& block) const;

public:
    TypeName("NewtonianFluid");

    explicit NewtonianFluid(const dictionary& dict) :
        constitutiveModel(dict),
        mu_(bounded(dict, "mu", 0, GREAT)),
        pressure_(
            dict, rho(), 0, dict.found("pMin") ? bounded(dict, "pMin", -GREAT, GREAT) : -GREAT)
    {
        wordList valid({"type", "rho", "mu", "pMin"});
        valid.append(pressurePart::keywords);
        checkKeywords(dict, valid);
    }

    List<historyColumn> history() const override
    {
        List<historyColumn> h(1 + pressure_.usesEnergy());
        h[0] = historyColumn{"volumeStrain", historyColumn::scalars};
        if (pressure_.usesEnergy())
        {
            h[1] = historyColumn{"e", historyColumn::scalars};
        }
        return h;
    }

    bool needsWidth() const override { return mu_ > 0 || pressure_.usesWidth(); }

    void start(pointBlock& b) const override
    {
        for (label p = 0; pressure_.usesEnergy() && p < b.n; ++p)
        {
            b.history[1][p] = pressure_.equation().e0();
        }
    }

    scalar startPressure() const override { return pressure_.startPressure(); }

    void initialise(pointBlock& b) const override
    {
        for (label p = 0; p < b.n; ++p)
        {
            const scalar mean = (b.stress[0][p] + b.stress[1][p] + b.stress[2][p]) / 3;
            for (int i = 0; i < nStress(b.nDim); ++i)
            {
                if (mag(b.stress[i][p] - (i < 3 ? mean : 0)) > 1e-9 * mag(mean))
                {
                    FatalErrorInFunction << "The law " << type() << " cannot start with a shear"
                                         << " stress, as " << b.nameOf(p).c_str()
                                         << " does; give a pressure." << exit(FatalError);
                }
            }
            scalar e;
            pressure_.stateOf(-mean, b, p, b.history[0][p], e);
            if (pressure_.usesEnergy())
            {
                b.history[1][p] = e;
            }
        }
    }

    void correct(pointBlock& b) const override
    {
        forDimension(b.nDim, [&](auto D) { this->update<decltype(D)::value>(b); });
    }

    bool holdsTogether() const override { return false; }

    scalar waveSpeed() const override { return std::sqrt(pressure_.bulkModulus() / rho()); }

    bool waveSpeedVaries() const override { return true; }

    scalar strainEnergy(const pointBlock& b) const override
    {
        const scalar* energy = pressure_.usesEnergy() ? b.history[1] : nullptr;
        scalar sum = 0;
        for (label p = 0; p < b.n; ++p)
        {
            sum += b.mass[p]
                * pressure_.energy(
                    rho() * std::exp(-b.history[0][p]), energy ? energy + p : nullptr);
        }
        return sum;
    }
};

template<int DIM>
void NewtonianFluid::update(pointBlock& b) const
{
    constexpr int W = laneWidth<DIM>;
    typedef lanes<W> T;

    scalar* energy = pressure_.usesEnergy() ? b.history[1] : nullptr;
    const scalar twoMu = 2 * mu_ / b.dt;
    scalar fastest = 0, diffusion = 0;
    elasticStrainStep<DIM> step(b);
    pressurePart::run r;
    r.dt = b.dt;

    for (label first = 0; first < b.n; first += pressurePart::maxRun)
    {
        const label end = min(b.n, first + pressurePart::maxRun);
        r.n = end - first;
        forLaneGroups<W>(
            first, end, [&](const laneGroup<W> g) __attribute__((always_inline)) {
                step.kinematics(b, g);
                const T tr = step.dTheta;
                const T theta = g.get(b.history[0]) + tr;
                g.put(b.history[0], theta);

                if (b.dissipated)
                {
                    r.keepMean(b, g, g.first - first);
                }

                const T across = step.hoop - tr / 3.0;
                T dd = (DIM < 2 ? tr * tr / 9.0 : T{}), d[DIM * DIM];
                dd += DIM < 3 ? across * across : T{};
                for (int i = 0; i < DIM * DIM; ++i)
                {
                    step.X[i] = i % (DIM + 1) ? step.lnU[i] : step.lnU[i] - tr / 3.0;
                    dd += step.X[i] * step.X[i];
                }
                step.turned(broadcast<W>(twoMu), d);
                for (int i = 0; i < DIM; ++i)
                {
                    for (int j = i; j < DIM; ++j)
                    {
                        g.put(b.stress[symmSlot(i, j)], d[i * DIM + j]);
                    }
                }
                for (int i = DIM; i < 3; ++i)
                {
                    g.put(b.stress[i], twoMu * (i == 2 ? across : -tr / 3.0));
                }

                const T rhoNew = rho() * laneExp(-theta);
                store<W>(r.rho + (g.first - first), rhoNew);
                store<W>(r.rhoOld + (g.first - first), rho() * laneExp(tr - theta));
                store<W>(r.dTheta + (g.first - first), tr);
                store<W>(r.work + (g.first - first), twoMu * dd * (1.0 - 0.5 * tr) / rhoNew);
                if (b.dissipated && !energy)
                {
                    g.put(
                        b.dissipated,
                        g.get(b.dissipated) + g.get(b.mass) * load<W>(r.work + (g.first - first)));
                }
            });
        fastest =
            max(fastest, pressure_.advance(r, b, first, energy ? energy + first : nullptr, 0));
        r.addTo(b, first);
        for (label k = 0; b.width && mu_ > 0 && k < r.n; ++k)
        {
            diffusion = max(diffusion, 1 / (r.rho[k] * b.width[first + k]));
        }
    }
    b.waveSpeed = max(b.waveSpeed, fastest + 8.0 / 3 * DIM * mu_ * diffusion);
}

defineTypeNameAndDebug(NewtonianFluid, 0);
addToRunTimeSelectionTable(constitutiveModel, NewtonianFluid, dictionary);

} // End namespace Foam::mpm
