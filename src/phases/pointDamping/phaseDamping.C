// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "phaseDamping.H"
#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::phaseDamping::phaseDamping(materialPointSystem& points) :
    stepPart("damping"), points_(points), damped_(0)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::phaseDamping::damps() const
{
    for (const materialPointPhase& phase : points_.phases())
    {
        if (phase.damping())
        {
            return true;
        }
    }
    return false;
}

void Foam::mpm::phaseDamping::start(const scalar dt)
{
    const scalar more = dt - damped_;
    const bool again = damped_ > 0;
    damped_ = dt;

    bool changed = false;
    for (materialPointPhase& phase : points_.phases())
    {
        if (phase.damping() && !(again && phase.damping()->kinetic()))
        {
            const scalar K = phase.kineticEnergy();
            const scalar factor = phase.damping()->factor(more, K);
            if (factor != 1)
            {
                phase.scaleVelocity(factor);
                points_.energy().sums().damping -= (1 - sqr(factor)) * K;
                changed = true;
            }
        }
    }
    if (changed)
    {
        points_.projectAnew(0);
    }
}

void Foam::mpm::phaseDamping::addState(dictionary& state) const
{
    dictionary before;
    for (const materialPointPhase& phase : points_.phases())
    {
        if (phase.damping())
        {
            before.add(phase.name(), phase.damping()->before());
        }
    }
    if (before.size())
    {
        state.add("damping", before);
    }
}

void Foam::mpm::phaseDamping::setState(const dictionary& state)
{
    if (!state.found("damping"))
    {
        return;
    }
    const dictionary& before = requiredDict(state, "damping");
    for (materialPointPhase& phase : points_.phases())
    {
        if (phase.damping())
        {
            phase.damping()->setBefore(before.getOrDefault<scalar>(phase.name(), 0));
        }
    }
}
