/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    Included by frictionalLaw.H.

\*---------------------------------------------------------------------------*/

#include "dictionaryTools.H"

namespace Foam
{
namespace mpm
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Law>
frictionalLaw<Law>::frictionalLaw
(
    const dictionary& dict,
    const wordList& keywords
)
:
    constitutiveModel(dict)
{
    wordList valid
    ({
        "type", "rho", "E", "nu", "cohesion", "frictionAngle",
        "dilationAngle", "tensionCutoff"
    });
    valid.append(keywords);
    checkKeywords(dict, valid);

    const scalar E = positive(dict, "E");
    const scalar nu = bounded(dict, "nu", -0.999, 0.499999);
    K_ = E/(3*(1 - 2*nu));
    G_ = E/(2*(1 + nu));
    c_ = bounded(dict, "cohesion", 0, GREAT);

    const scalar degree = std::atan(scalar(1))/45;
    const scalar phi = bounded(dict, "frictionAngle", 0, 89);
    phi_ = phi*degree;
    psi_ = bounded(dict, "dilationAngle", 0, phi)*degree;
    tension_ =
        dict.found("tensionCutoff")
      ? bounded(dict, "tensionCutoff", 0, GREAT)
      : GREAT;
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Law>
template<int DIM>
void frictionalLaw<Law>::update(pointBlock& b) const
{
    constexpr int W = laneWidth<DIM>;
    typedef lanes<W> T;

    const Law& law = static_cast<const Law&>(*this);
    scalar* plastic = b.history[nStress(DIM)];
    elasticStrainStep<DIM> step(b);

    for (label p = 0; p < b.n; p += W)
    {
        const laneGroup<W> g(p, b.n);
        step.trial(b, g);
        step.deviator();
        T theta = step.theta, dEps = {};
        T trial[DIM*DIM], across[3];
        if (b.dissipated)
        {
            std::copy(step.X, step.X + DIM*DIM, trial);
            std::copy(step.side, step.side + 3, across);
        }
        law.template flow<DIM>(step, theta, dEps, g.n);
        if (b.dissipated)
        {
            // Mean of old and new stress times the plastic strain
            T work =
                0.5*K_*(theta + step.theta - step.dTheta)*(step.theta - theta);
            for (int i = 0; i < DIM*DIM; ++i)
            {
                work +=
                    G_*(step.X[i] + trial[i] - step.lnU[i])
                   *(trial[i] - step.X[i]);
            }
            for (int i = DIM; i < 3; ++i)
            {
                const T hoop = i == 2 ? step.hoop : T{};
                work +=
                    G_*(step.side[i] + across[i] - hoop)
                   *(across[i] - step.side[i]);
            }
            g.put
            (
                b.dissipated,
                g.get(b.dissipated) + g.get(b.volume)*work
            );
        }
        g.put(plastic, g.get(plastic) + dEps);
        step.finish
        (
            b,
            g,
            broadcast<W>(1),
            theta/3.0,
            broadcast<W>(2*G_),
            K_*theta
        );
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Law>
List<historyColumn> frictionalLaw<Law>::history() const
{
    List<historyColumn> h(2);
    h[0] = historyColumn{"elasticStrain", historyColumn::stresses};
    h[1] = historyColumn{"plasticStrain", historyColumn::scalars};
    return h;
}


template<class Law>
void frictionalLaw<Law>::initialise(pointBlock& b) const
{
    for (label p = 0; p < b.n; ++p)
    {
        const scalar mean =
            (b.stress[0][p] + b.stress[1][p] + b.stress[2][p])/3;
        for (int i = 0; i < nStress(b.nDim); ++i)
        {
            b.history[i][p] =
                i < 3
              ? (b.stress[i][p] - mean)/(2*G_) + mean/(3*K_)
              : b.stress[i][p]/(2*G_);
        }
    }
}


template<class Law>
void frictionalLaw<Law>::correct(pointBlock& b) const
{
    switch (b.nDim)
    {
        case 1: update<1>(b); break;
        case 2: update<2>(b); break;
        default: update<3>(b);
    }
}


template<class Law>
scalar frictionalLaw<Law>::waveSpeed() const
{
    return std::sqrt((K_ + 4.0/3*G_)/rho());
}


template<class Law>
scalar frictionalLaw<Law>::elasticModulus() const
{
    return 9*G_*(K_/(3*K_ + G_));
}


template<class Law>
scalar frictionalLaw<Law>::strainEnergy(const pointBlock& b) const
{
    scalar sum = 0;
    for (label p = 0; p < b.n; ++p)
    {
        const scalar theta =
            b.history[0][p] + b.history[1][p] + b.history[2][p];
        scalar hh = 0;
        for (int i = 0; i < nStress(b.nDim); ++i)
        {
            hh +=
                i < 3
              ? sqr(b.history[i][p] - theta/3)
              : 2*sqr(b.history[i][p]);
        }
        sum += b.volume[p]*(0.5*K_*sqr(theta) + G_*hh);
    }
    return sum;
}

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
