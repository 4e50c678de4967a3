/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "bookedLosses.H"
#include "noTraps.H"
#include "timer.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::filter
(
    const velocityField::series s,
    const scalar weight
)
{
    if (weight <= 0)
    {
        return;
    }
    const timer t(clock_.project);
    for (label k = 1; k < transfer_->order(); ++k)
    {
        forAll(fields_, fieldi)
        {
            velocityField& field = fields_[fieldi];
            if (k == 1)
            {
                field.startFilter(s);
            }
            scalar* Mv = field.zeroProduct();
            forAll(phases_, phasei)
            {
                if (fieldOf_[phasei] == fieldi && !phases_[phasei].motion())
                {
                    gridTransfer_->massTimes
                    (
                        phases_[phasei].cloud(),
                        false,
                        field.increment(),
                        Mv
                    );
                }
            }
            field.sumColumn(Mv);
            field.nextIncrement(s);
        }
        if (contact_)
        {
            contact_->filter(s != velocityField::ofStrain);
        }
        for (velocityField& field : fields_)
        {
            field.addIncrement(s, weight);
        }
    }
}


void Foam::mpm::materialPointSystem::finishForce(const scalar dt)
{
    addBodyForces(mesh_.time().value() + dt);
    for (velocityField& field : fields_)
    {
        field.sumForce();
    }
    addSurfaceLoads(mesh_.time().value() + dt);
    addRigidTraction();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::strainVelocity()
{
    const noTraps guard;
    const bool filtered =
        transfer_->order() > 1 && transfer_->strainFilter() > 0;
    for (velocityField& field : fields_)
    {
        field.strainFromU(filtered || contact_);
    }
    if (contact_)
    {
        contact_->applyStrainImpulses(dt_);
    }
    filter(velocityField::ofStrain, transfer_->strainFilter());
}


void Foam::mpm::materialPointSystem::strainVelocityL()
{
    for (velocityField& field : fields_)
    {
        field.strainFromUL(transfer_->strainFilter());
    }
}


void Foam::mpm::materialPointSystem::strainVelocityAnew()
{
    const noTraps guard;
    {
        const timer t(clock_.project);
        List<scalar*> mU(fields_.size());
        forAll(fields_, fieldi)
        {
            mU[fieldi] = fields_[fieldi].strainMomentum();
        }
        forAll(phases_, phasei)
        {
            if (!phases_[phasei].motion())
            {
                gridTransfer_->project
                (
                    phases_[phasei].cloud(),
                    pointGridTransfer::oldPlaces,
                    mU[fieldOf_[phasei]]
                );
            }
        }
        for (velocityField& field : fields_)
        {
            field.strainFromMomentum();
        }
        if (contact_)
        {
            contact_->applyStrainImpulses(dt_);
        }
    }
    filter(velocityField::ofStrain, transfer_->strainFilter());
}


void Foam::mpm::materialPointSystem::force(const scalar dt)
{
    const noTraps guard;
    const timer t(clock_.stress);

    for (velocityField& field : fields_)
    {
        field.clearForce();
    }
    forAll(phases_, phasei)
    {
        if (!phases_[phasei].motion())
        {
            gridTransfer_->force
            (
                phases_[phasei].cloud(),
                fields_[fieldOf_[phasei]].force()
            );
        }
    }
    finishForce(dt);
}


void Foam::mpm::materialPointSystem::correctStress
(
    const scalar dt,
    const bool withForce,
    const scalar dtForce
)
{
    const noTraps guard;
    const timer t(clock_.stress);

    for (velocityField& field : fields_)
    {
        if (withForce)
        {
            field.clearForce();
        }
    }
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = phases_[phasei];
        if (phase.motion() || !phase.law().hasStress())
        {
            continue;
        }
        autoPtr<bookedLosses> booked;
        if (budget_.active)
        {
            booked.reset
            (
                new bookedLosses(phase.failure(), phase.law(), grid_.nDim())
            );
        }
        const pointGridTransfer::stressResult result
        (
            gridTransfer_->correctStress
            (
                phase.cloud(),
                phase.law(),
                booked ? booked.get() : phase.failure(),
                dt,
                meanMove() ? 0 : stressUpdate_->square(),
                fields_[fieldOf_[phasei]].Ustrain(),
                withForce && !coupling_
              ? fields_[fieldOf_[phasei]].force()
              : nullptr
            )
        );
        if (result.badPoint >= 0)
        {
            const materialPointCloud& cloud = phase.cloud();
            const label p = result.badPoint;
            const point x(cloud.position(p, cloud.cellOf(p)));
            FatalErrorInFunction
                << "Material point " << label(cloud.id()[0][p]) << " of "
                << phase.name() << " at " << x << ", step of " << dt
                << " s after time " << mesh_.time().timeName()
                << ": sigma (stress) from the law " << phase.law().type()
                << " is no finite number; velocity " << cloud.velocity(p)
                << ", volume " << cloud.volume()[0][p] << "." << nl
                << "Nothing is written: the last written time is the last"
                << " good state." << nl
                << "A smaller maxCo in system/controlDict or maxStrain in"
                << " fvSolution.materialPoints makes the step smaller."
                << exit(FatalError);
        }
        phase.nFailed() += result.nFailed;
        if (booked)
        {
            losses_ += booked->sums();
        }
        if (phase.law().waveSpeedVaries())
        {
            phase.setWaveSpeed(result.waveSpeed, result.fastest);
        }
    }
    if (withForce && !coupling_)
    {
        finishForce(dtForce);
    }
}

// ************************************************************************* //
