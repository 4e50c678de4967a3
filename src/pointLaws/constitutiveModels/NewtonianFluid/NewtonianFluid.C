/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "NewtonianFluid.H"
#include "dictionaryTools.H"
#include "elasticStrain.H"
#include "laneMath.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(NewtonianFluid, 0);
    addToRunTimeSelectionTable(constitutiveModel, NewtonianFluid, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::NewtonianFluid::NewtonianFluid(const dictionary& dict)
:
    constitutiveModel(dict),
    mu_(bounded(dict, "mu", 0, GREAT)),
    pressure_
    (
        dict,
        rho(),
        0,
        dict.found("pMin") ? bounded(dict, "pMin", -GREAT, GREAT) : -GREAT
    )
{
    wordList valid({"type", "rho", "mu", "pMin"});
    valid.append(pressurePart::keywords);
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int DIM>
void Foam::mpm::NewtonianFluid::update(pointBlock& b) const
{
    constexpr int W = laneWidth<DIM>;
    typedef lanes<W> T;

    scalar* energy = pressure_.usesEnergy() ? b.history[1] : nullptr;
    const scalar twoMu = 2*mu_/b.dt;
    scalar fastest = 0, diffusion = 0;
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
            step.kinematics(b, g);
            const T tr = step.dTheta;
            const T theta = g.get(b.history[0]) + tr;
            g.put(b.history[0], theta);

            if (b.dissipated)
            {
                r.keepMean(b, g, p - first);
            }

            const T across = step.hoop - tr/3.0;
            T dd = (DIM < 2 ? tr*tr/9.0 : T{}), d[DIM*DIM];
            dd += DIM < 3 ? across*across : T{};
            for (int i = 0; i < DIM*DIM; ++i)
            {
                step.X[i] =
                    i % (DIM + 1) ? step.lnU[i] : step.lnU[i] - tr/3.0;
                dd += step.X[i]*step.X[i];
            }
            step.turned(broadcast<W>(twoMu), d);
            for (int i = 0; i < DIM; ++i)
            {
                for (int j = i; j < DIM; ++j)
                {
                    g.put(b.stress[symmSlot(i, j)], d[i*DIM + j]);
                }
            }
            for (int i = DIM; i < 3; ++i)
            {
                g.put(b.stress[i], twoMu*(i == 2 ? across : -tr/3.0));
            }

            const T rhoNew = rho()*laneExp(-theta);
            store<W>(r.rho + (p - first), rhoNew);
            store<W>(r.rhoOld + (p - first), rho()*laneExp(tr - theta));
            store<W>(r.dTheta + (p - first), tr);
            store<W>
            (
                r.work + (p - first),
                twoMu*dd*(1.0 - 0.5*tr)/rhoNew
            );
            if (b.dissipated && !energy)
            {
                g.put
                (
                    b.dissipated,
                    g.get(b.dissipated)
                  + g.get(b.mass)*load<W>(r.work + (p - first))
                );
            }
        }
        fastest = max
        (
            fastest,
            pressure_.advance(r, b, first, energy ? energy + first : nullptr, 0)
        );
        r.addTo(b, first);
        for (label k = 0; b.width && mu_ > 0 && k < r.n; ++k)
        {
            diffusion = max(diffusion, 1/(r.rho[k]*b.width[first + k]));
        }
    }
    b.waveSpeed = max(b.waveSpeed, fastest + 8.0/3*DIM*mu_*diffusion);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::mpm::historyColumn> Foam::mpm::NewtonianFluid::history() const
{
    List<historyColumn> h(1 + pressure_.usesEnergy());
    h[0] = historyColumn{"volumeStrain", historyColumn::scalars};
    if (pressure_.usesEnergy())
    {
        h[1] = historyColumn{"e", historyColumn::scalars};
    }
    return h;
}


void Foam::mpm::NewtonianFluid::start(pointBlock& b) const
{
    for (label p = 0; pressure_.usesEnergy() && p < b.n; ++p)
    {
        b.history[1][p] = pressure_.equation().e0();
    }
}


void Foam::mpm::NewtonianFluid::initialise(pointBlock& b) const
{
    for (label p = 0; p < b.n; ++p)
    {
        const scalar mean =
            (b.stress[0][p] + b.stress[1][p] + b.stress[2][p])/3;
        for (int i = 0; i < nStress(b.nDim); ++i)
        {
            if (mag(b.stress[i][p] - (i < 3 ? mean : 0)) > 1e-9*mag(mean))
            {
                FatalErrorInFunction
                    << "The law " << type() << " cannot start with a shear"
                    << " stress, as " << b.nameOf(p).c_str()
                    << " does; give a pressure."
                    << exit(FatalError);
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


void Foam::mpm::NewtonianFluid::correct(pointBlock& b) const
{
    switch (b.nDim)
    {
        case 1: update<1>(b); break;
        case 2: update<2>(b); break;
        default: update<3>(b);
    }
}


Foam::scalar Foam::mpm::NewtonianFluid::waveSpeed() const
{
    return std::sqrt(pressure_.bulkModulus()/rho());
}


Foam::scalar
Foam::mpm::NewtonianFluid::strainEnergy(const pointBlock& b) const
{
    const scalar* energy = pressure_.usesEnergy() ? b.history[1] : nullptr;
    scalar sum = 0;
    for (label p = 0; p < b.n; ++p)
    {
        sum += b.mass[p]*pressure_.energy
        (
            rho()*std::exp(-b.history[0][p]),
            energy ? energy + p : nullptr
        );
    }
    return sum;
}

// ************************************************************************* //
