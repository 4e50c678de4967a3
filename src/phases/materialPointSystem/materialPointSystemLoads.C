/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "noTraps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::addSurfaceLoads(const scalar time)
{
    forAll(phases_, phasei)
    {
        velocityField& field = fields_[fieldOf_[phasei]];
        for (const surfaceLoad& load : phases_[phasei].surfaceLoads())
        {
            load.addForce
            (
                *gridTransfer_,
                phases_[phasei].cloud(),
                time,
                field.load(),
                field.stride()
            );
        }
    }
    for (velocityField& field : fields_)
    {
        field.addLoad();
    }
}


void Foam::mpm::materialPointSystem::damp(const scalar dt)
{
    // Once, also where the step is redone. Behind the strain of u^n (USAVG,
    // USF): points and strain see the same velocities
    if (damped_)
    {
        return;
    }
    damped_ = true;

    bool slower = false;
    for (materialPointPhase& phase : phases_)
    {
        if (phase.damping())
        {
            const scalar K = phase.kineticEnergy();
            const scalar factor = phase.damping()->factor(dt, K);
            if (factor < 1)
            {
                phase.scaleVelocity(factor);
                budget_.damping -= (1 - sqr(factor))*K;
                slower = true;
            }
        }
    }
    if (slower)
    {
        projectAnew(0);
    }
}


bool Foam::mpm::materialPointSystem::damps() const
{
    for (const materialPointPhase& phase : phases_)
    {
        if (phase.damping())
        {
            return true;
        }
    }
    return false;
}


Foam::dictionary Foam::mpm::materialPointSystem::dampingState() const
{
    dictionary state;
    for (const materialPointPhase& phase : phases_)
    {
        if (phase.damping())
        {
            state.add(phase.name(), phase.damping()->before());
        }
    }
    return state;
}


void Foam::mpm::materialPointSystem::setDampingState(const dictionary& state)
{
    for (materialPointPhase& phase : phases_)
    {
        if (phase.damping())
        {
            phase.damping()->setBefore
            (
                state.getOrDefault<scalar>(phase.name(), 0)
            );
        }
    }
}

// ************************************************************************* //
