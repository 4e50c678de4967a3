/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::materialPointSystem::timeDependent() const
{
    for (const materialPointPhase& phase : phases_)
    {
        if
        (
            phase.motion()
         || phase.hasBodyForce()
         || phase.surfaceLoads().size()
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::mpm::materialPointSystem::startNodes()
{
    for (materialPointPhase& phase : phases_)
    {
        if (phase.motion())
        {
            phase.motion()->setVelocity(phase.cloud());
        }
    }
    for (velocityField& field : fields_)
    {
        field.rigid().newTime();
    }
    projectAnew(0);
}


void Foam::mpm::materialPointSystem::projectAnew(const scalar dt)
{
    const noTraps guard;

    activate(true);
    projectAll(pointGridTransfer::current);
    for (velocityField& field : fields_)
    {
        field.replace();
    }
    force(dt);
}


void Foam::mpm::materialPointSystem::advanceRigid(const scalar dt)
{
    const scalar time = mesh_.time().value();
    forAll(phases_, phasei)
    {
        if (rigidMotion* motion = phases_[phasei].motion())
        {
            motion->advance(time, time + dt);
            if (!motion->free())
            {
                fields_[fieldOf_[phasei]].rigid().newVelocity(phasei, *motion);
            }
        }
    }
}


void Foam::mpm::materialPointSystem::reachRigid
(
    const pointGridTransfer::states state
)
{
    for (velocityField& field : fields_)
    {
        field.rigid().clear();
    }
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = phases_[phasei];
        if (phase.motion())
        {
            velocityField& field = fields_[fieldOf_[phasei]];
            scalar* mass =
                field.rigid().clearMass(field.activeNew(), field.stride());
            gridTransfer_->project(phase.cloud(), state, mass);
            field.sumWithMass(mass);
            const bool shares = sharesNodes(phasei);
            if (shares)
            {
                field.rigid().startShares
                (
                    *gridTransfer_,
                    phase.cloud(),
                    field.nodeVolume(),
                    field.activeNew(),
                    field.stride()
                );
                field.largestOfShared(mass, field.stride(), 1);
            }
            field.rigid().add
            (
                phasei,
                *phase.motion(),
                phase.largestMass(),
                shares ? &field.nodeVolume() : nullptr,
                field.activeNew(),
                field.stride()
            );
        }
    }

    // An impulse on a node of several processors counts once
    boolList done(fields_.size(), false);
    forAll(phases_, phasei)
    {
        const label fieldi = fieldOf_[phasei];
        if (phases_[phasei].motion() && !done[fieldi])
        {
            velocityField& field = fields_[fieldi];
            scalar* marks =
                field.rigid().marks(field.activeNew(), field.stride());
            field.sumColumn(marks);
            field.rigid().setParts(marks, field.stride());
            done[fieldi] = true;
        }
    }
}


bool Foam::mpm::materialPointSystem::sharesNodes(const label phasei) const
{
    return
        phases_[phasei].prescribed()
     && phases_[phasei].motion()->moves()
     && !coupling_
     && !(contact_ && contact_->has(fieldOf_[phasei]));
}


void Foam::mpm::materialPointSystem::addRigidTraction()
{
    forAll(fields_, fieldi)
    {
        velocityField& field = fields_[fieldi];
        rigidNodes& rigid = field.rigid();
        bool shares = false;
        forAll(phases_, phasei)
        {
            shares = shares
             || (fieldOf_[phasei] == fieldi && sharesNodes(phasei));
        }
        rigid.setShares(shares);
        if (!shares)
        {
            continue;
        }
        scalar* q = rigid.clearSums(field.active());
        forAll(phases_, phasei)
        {
            if (fieldOf_[phasei] == fieldi)
            {
                rigid.addSums
                (
                    *gridTransfer_,
                    phases_[phasei].cloud(),
                    phases_[phasei].motion()
                );
            }
        }
        field.sumShared(q, rigidNodes::nSums, rigidNodes::nSums);
        rigid.addTraction(field.stride(), field.force());
    }
}


void Foam::mpm::materialPointSystem::addBodyForces(const scalar time)
{
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = phases_[phasei];
        if (phase.hasBodyForce())
        {
            gridTransfer_->addBodyForce
            (
                phase.cloud(),
                phase.acceleration(time),
                fields_[fieldOf_[phasei]].force()
            );
        }
    }
}

// ************************************************************************* //
