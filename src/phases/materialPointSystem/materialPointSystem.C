/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "dictionaryTools.H"
#include "largestOfAll.H"
#include "noTraps.H"
#include "timer.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(materialPointSystem, 0);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::updateWaveRate()
{
    scalar rate = 0;
    for (const materialPointPhase& phase : phases_)
    {
        if (!phase.motion())
        {
            const scalar c = phase.waveSpeed();
            rate = max(rate, c/phase.shortestSide());
        }
        else if (phase.motion()->free())
        {
            // A body that starts from rest
            rate = max(rate, std::sqrt(mag(g_)/phase.shortestSide()));
        }
    }
    waveRate_ = largestOfAll(rate);
}


Foam::mpm::moveCoefficients Foam::mpm::materialPointSystem::coefficients
(
    const label fieldi,
    const scalar dt
) const
{
    // Grains without a law's stress have no waves until they are packed. With
    // the rate of the packed ones a PIC fraction would be a viscosity that holds
    // loose grains. One set of coefficients for a field keeps its momentum
    bool loose = false, waves = false;
    forAll(phases_, phasei)
    {
        const materialPointPhase& phase = phases_[phasei];
        if (fieldOf_[phasei] == fieldi && !phase.motion())
        {
            const bool grains = phase.grains() && !phase.law().hasStress();
            (grains ? loose : waves) = true;
        }
    }
    const bool grains = loose && !waves;
    return transfer_->coefficients
    ({
        dt*(rate_ + (grains ? 0 : waveRate_)),
        grains,
        meanMove()
    });
}


void Foam::mpm::materialPointSystem::activate(const bool changed)
{
    forAll(fields_, fieldi)
    {
        if (!changed)
        {
            fields_[fieldi].keepActive();
            continue;
        }
        DynamicList<const labelList*> cells;
        forAll(phases_, phasei)
        {
            if (fieldOf_[phasei] == fieldi)
            {
                cells.append(&phases_[phasei].cloud().cells());
            }
        }
        fields_[fieldi].activate(cells, gridTransfer_->reach());
    }
}


void Foam::mpm::materialPointSystem::projectAll
(
    const pointGridTransfer::states state
)
{
    const noTraps guard;

    for (velocityField& field : fields_)
    {
        field.clearMomentum();
    }
    forAll(phases_, phasei)
    {
        // Nodes of rigid phases have a velocity without their mass
        if (!phases_[phasei].motion())
        {
            gridTransfer_->project
            (
                phases_[phasei].cloud(),
                state,
                fields_[fieldOf_[phasei]].momentumNew()
            );
        }
    }
    reachRigid(state);
    for (velocityField& field : fields_)
    {
        field.sumMomentum();
        field.velocity();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::materialPointSystem::indexOf(const word& phase) const
{
    forAll(phases_, phasei)
    {
        if (phases_[phasei].name() == phase)
        {
            return phasei;
        }
    }
    return -1;
}


Foam::label Foam::mpm::materialPointSystem::nPoints() const
{
    label n = 0;
    for (const materialPointPhase& phase : phases_)
    {
        n += phase.cloud().size();
    }
    return returnReduce(n, sumOp<label>());
}


Foam::scalar Foam::mpm::materialPointSystem::bytesPerPoint() const
{
    scalar bytes = 0;
    label n = 0;
    forAll(phases_, phasei)
    {
        const materialPointCloud& cloud = phases_[phasei].cloud();
        bytes += cloud.bytesPerPoint()*cloud.size();
        bytes +=
            cellChanges_[phasei].capacity()*sizeof(materialPointCloud::cellChange);
        n += cloud.size();
    }
    reduce(bytes, sumOp<scalar>());
    reduce(n, sumOp<label>());
    return bytes/max(n, label(1));
}


Foam::scalar Foam::mpm::materialPointSystem::gridBytes() const
{
    scalar bytes = 0;
    for (const velocityField& field : fields_)
    {
        bytes += field.bytes();
    }
    return returnReduce(bytes, sumOp<scalar>());
}


void Foam::mpm::materialPointSystem::momentum(const scalar dt)
{
    const noTraps guard;
    {
        const timer t(clock_.nodes);
        dt_ = dt;
        for (velocityField& field : fields_)
        {
            field.newTime(dt);
        }
        advanceRigid(dt);
        for (velocityField& field : fields_)
        {
            field.momentumStep(dt, g_);
        }
    }

    scalar boundary = 0, work = 0;
    for (const velocityField& field : fields_)
    {
        boundary += budget_.active ? field.boundaryWork(dt, g_) : 0;
    }
    if (contact_)
    {
        const timer t(clock_.contact);
        work = contact_->applyImpulses(dt, budget_.active, boundary);
    }
    if (budget_.active)
    {
        budget_.step.boundary = returnReduce(boundary, sumOp<scalar>());
        budget_.step.contact = returnReduce(work, sumOp<scalar>());
    }

    filter(transfer_->filtered(), 1);
}


Foam::scalar Foam::mpm::materialPointSystem::move(const scalar dt)
{
    const noTraps guard;
    const timer t(clock_.move);

    pointGridTransfer::moveRule rule;
    rule.dt = dt;
    rule.energy = budget_.active;
    rule.outflow = outflow_.get();

    // Share of their velocity that points take from the nodes
    List<moveCoefficients> take(fields_.size());
    scalarList projected(fields_.size());
    forAll(fields_, fieldi)
    {
        take[fieldi] = coefficients(fieldi, dt);
        projected[fieldi] = take[fieldi].projected();
        fields_[fieldi].addProjected(projected[fieldi]);
    }

    scalar travel = 0, rate = 0, work = 0, body = 0;
    scalar bodyWork = 0, gravityWork = 0;
    vector momentum(Zero);
    badPoint bad{-1, -1, false};
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = phases_[phasei];
        const velocityField& field = fields_[fieldOf_[phasei]];
        rule.take = take[fieldOf_[phasei]];
        rule.bodyForce = phase.bodyAcceleration();
        if (transfer_->affine() != transferScheme::none && !phase.motion())
        {
            const bool moment = transfer_->affine() == transferScheme::moment;
            gridTransfer_->affine
            (
                phase.cloud(),
                moment,
                moment ? field.UL() : field.U(),
                dt
            );
        }
        if (phase.motion() && phase.motion()->free())
        {
            freeBody& b = *phase.motion()->free();
            b.finish(dt, projected[fieldOf_[phasei]]);
            bodyWork += b.work();
            gravityWork += b.gravityWork();
        }
        const pointGridTransfer::moveResult result
        (
            phase.motion()
          ? phase.motion()->move(phase.cloud(), cellChanges_[phasei])
          : gridTransfer_->move
            (
                phase.cloud(),
                rule,
                field.velocities(),
                cellChanges_[phasei]
            )
        );

        travel = max(travel, result.travel);
        rate = max(rate, result.rate);
        work += result.work;
        momentum += result.momentum;
        body += result.bodyWork;

        // Too far is no reason to stop yet: a smaller step may end inside
        if
        (
            bad.phase < 0
         && result.badPoint >= 0
         && (!result.left || result.travel <= maxTravel_)
        )
        {
            bad = badPoint{phasei, result.badPoint, result.left};
        }
    }
    travel = largestOfAll(travel);
    rate_ = largestOfAll(bad.phase < 0 ? rate : VGREAT);
    if (rate_ >= VGREAT)
    {
        stop(bad);
    }
    if (budget_.active)
    {
        reduce(work, sumOp<scalar>());
        reduce(momentum, sumOp<vector>());
        reduce(body, sumOp<scalar>());
        scalar load = 0;
        for (const velocityField& field : fields_)
        {
            load += field.loadWork(dt);
        }
        reduce(load, sumOp<scalar>());
        forceWork& step = budget_.step;
        step.external = dt*((g_ & momentum) + body) + gravityWork + load;
        step.internal =
            work + bodyWork - step.external - step.boundary - step.contact;
    }

    forAll(fields_, fieldi)
    {
        fields_[fieldi].addProjectionImpulse(projected[fieldi]);
    }

    return travel <= maxTravel_ ? 1 : max(0.8*maxTravel_/travel, scalar(0.1));
}


Foam::scalar Foam::mpm::materialPointSystem::project(const scalar dt)
{
    bool changed = false;
    {
        const timer t(clock_.sort);
        forAll(phases_, phasei)
        {
            phases_[phasei].cloud().exchange(cellChanges_[phasei]);
            checkExtent(phases_[phasei], cellChanges_[phasei]);
            if (phases_[phasei].cloud().sort(cellChanges_[phasei]))
            {
                changed = true;
            }
        }
        activate(changed);
        tentative_ = true;
    }

    scalar strain = 0;
    {
        const timer t(clock_.project);
        projectAll(pointGridTransfer::tentative);
    }
    {
        const timer t(clock_.nodes);
        forAll(phases_, phasei)
        {
            strain = max
            (
                strain,
                fields_[fieldOf_[phasei]].maxStrain
                (
                    phases_[phasei].cloud().cells(),
                    dt
                )
            );
        }
    }
    strain = largestOfAll(strain);

    // Cells of different sizes
    if (grid_.sameWidth() <= 0)
    {
        updateWaveRate();
    }

    return strain <= maxStrain_ ? 1 : max(0.8*maxStrain_/strain, scalar(0.1));
}


void Foam::mpm::materialPointSystem::accept()
{
    damped_ = false;
    for (materialPointPhase& phase : phases_)
    {
        phase.cloud().accept();
        if (phase.motion())
        {
            phase.motion()->accept();
        }
    }
    bookOutflow();
    for (velocityField& field : fields_)
    {
        field.accept();
    }
    if (contact_)
    {
        const timer t(clock_.contact);
        contact_->accept();
        contact_->update();
    }
    budget_.work += budget_.step;
    tentative_ = false;
}


void Foam::mpm::materialPointSystem::reject()
{
    ++nRedone_;
    if (tentative_)
    {
        for (materialPointPhase& phase : phases_)
        {
            phase.cloud().reject();
        }
        for (velocityField& field : fields_)
        {
            field.reject();
        }
        updateWaveRate();
    }
    if (stressUpdate_->early())
    {
        for (materialPointPhase& phase : phases_)
        {
            phase.restoreStress();
        }
        losses_ = lossesBefore_;
    }
    tentative_ = false;
}


void Foam::mpm::materialPointSystem::couple(pointCoupling& coupling)
{
    if (stressUpdate_->early())
    {
        FatalIOErrorInFunction
        (
            mesh_.solutionDict().subDict("materialPoints")
        )   << "stressUpdate " << stressUpdate_->type() << " does not work in"
            << " a gas, which has to act on the stress of the start of the"
            << " step." << nl << "Valid choice: MUSL" << exit(FatalIOError);
    }
    if (outflow_)
    {
        FatalIOErrorInFunction(properties_.subDict("outflow"))
            << "There is an outflow, which does not work in a gas: the cell of"
            << " a point that leaves would have its gas expand at once into the"
            << " free volume." << nl << "Remove outflow, and make the mesh"
            << " larger or keep points inside by the boundary conditions of"
            << " their velocity." << exit(FatalIOError);
    }
    for (const materialPointPhase& phase : phases_)
    {
        if (phase.erosion())
        {
            FatalIOErrorInFunction(properties_.subDict(phase.name()))
                << "Phase " << phase.name() << " has erosion, which does not"
                << " work in a gas: the cell of a point that vanishes would"
                << " have its gas expand at once into the free volume." << nl
                << "Remove erosion; failureModel  { failed nothing; ... }"
                << " keeps failed points without a stress."
                << exit(FatalIOError);
        }
    }
    if (damps())
    {
        FatalIOErrorInFunction(properties_)
            << "damping does not work in a gas, whose drag has to take what"
            << " the points lose." << exit(FatalIOError);
    }
    bool shares = false;
    forAll(phases_, phasei)
    {
        shares = shares || sharesNodes(phasei);
    }
    coupling_ = &coupling;
    if (shares)
    {
        // In a gas rigid bodies have whole nodes
        startNodes();
    }
}


void Foam::mpm::materialPointSystem::addImpulse
(
    const label fieldi,
    scalar* impulse
)
{
    velocityField& field = fields_[fieldi];
    field.sumColumn(impulse);
    const scalar work = field.addImpulse(impulse, budget_.active);
    if (budget_.active)
    {
        budget_.step.boundary += returnReduce(work, sumOp<scalar>());
    }
}


bool Foam::mpm::materialPointSystem::advance(const scalar dt, scalar& factor)
{
    lossesBefore_ = losses_;
    const scalar stored =
        budget_.active && coupling_ ? storedEnergy() : 0;
    if (stressUpdate_->early())
    {
        for (materialPointPhase& phase : phases_)
        {
            phase.keepStress();
        }
    }
    stressUpdate_->start(*this, dt);
    damp(dt);

    if (coupling_)
    {
        {
            const timer t(clock_.coupling);
            coupling_->force();
        }
        force(0);
    }
    momentum(dt);
    if (coupling_)
    {
        const timer t(clock_.coupling);
        coupling_->drag(dt);
    }
    factor = move(dt);
    if (factor >= 1)
    {
        if (coupling_)
        {
            const timer t(clock_.coupling);
            coupling_->depart();
        }
        stressUpdate_->moved(*this, dt);
        factor = project(dt);
    }
    if (factor < 1)
    {
        reject();
        return false;
    }
    accept();

    if (coupling_)
    {
        const timer t(clock_.coupling);
        coupling_->accepted();
    }
    stressUpdate_->end(*this, dt);
    erode(dt);
    if (contact_)
    {
        // The strain has changed the points' volumes and boxes
        contact_->update();
    }
    for (const materialPointPhase& phase : phases_)
    {
        if (!phase.motion() && phase.law().waveSpeedVaries())
        {
            updateWaveRate();
            break;
        }
    }
    if (coupling_)
    {
        const timer t(clock_.coupling);
        coupling_->arrive(dt);
        if (budget_.active)
        {
            budget_.strainStep = storedEnergy() - stored;
        }
    }
    checkOverlap();

    return true;
}

// ************************************************************************* //
