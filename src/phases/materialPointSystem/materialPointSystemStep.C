// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "largestOfAll.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::keepStress()
{
    if (stressUpdate_->early())
    {
        for (materialPointPhase& phase : phases_)
        {
            phase.keepStress();
        }
    }
}

Foam::scalar Foam::mpm::materialPointSystem::waveRateHere() const
{
    scalar rate = 0;
    for (const materialPointPhase& phase : phases_)
    {
        const scalar h = gridTransfer_->shortestWidth(phase.cloud(), phase.shortestSide());
        rate = max(rate, phase.waveRate(g_, h));
    }
    return rate;
}

Foam::mpm::moveCoefficients
Foam::mpm::materialPointSystem::coefficients(const label fieldi, const scalar dt) const
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
    return transfer_->coefficients({dt * (rate_ + (grains ? 0 : waveRate_)), grains, meanMove()});
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

void Foam::mpm::materialPointSystem::projectPhase(
    const label phasei, const pointGridTransfer::states state, scalar* mU)
{
    materialPointCloud& cloud = phases_[phasei].cloud();
    if (coupling_)
    {
        shares_[phasei].setSize(gridTransfer_->nStencil() * cloud.cells().size());
    }
    gridTransfer_->project(cloud, state, mU, shares_[phasei].data());
}

void Foam::mpm::materialPointSystem::projectAll(const pointGridTransfer::states state)
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
            projectPhase(phasei, state, fields_[fieldOf_[phasei]].momentumNew());
        }
    }
    sharesHold_ = coupling_;
    for (massOffsets& offsets : offsets_)
    {
        offsets.change();
    }
    parts_.within(&stepPart::projected, state);
    for (velocityField& field : fields_)
    {
        field.sumMomentum();
        field.velocity();
    }
}

void Foam::mpm::materialPointSystem::momentum(const scalar dt)
{
    const noTraps guard;
    const timer t(clock_.nodes);

    dt_ = dt;
    for (velocityField& field : fields_)
    {
        field.newTime(dt);
    }
    parts_.within(&stepPart::constrain, dt);
    forAll(fields_, fieldi)
    {
        const moveCoefficients c(coefficients(fieldi, dt));
        fields_[fieldi].momentumStep(dt, g_, c.a0 * c.a1 != 0 && c.b1 == 0);
    }
}

void Foam::mpm::materialPointSystem::filterVelocity()
{
    const noTraps guard;
    filter(transfer_->filtered(), 1, transfer_->filterScale());
}

Foam::scalar Foam::mpm::materialPointSystem::move(const scalar dt)
{
    const noTraps guard;
    const timer t(clock_.move);

    pointGridTransfer::moveRule rule;
    rule.dt = dt;
    rule.energy = energy_->active();
    rule.outflow = outflow_.get();
    rule.walls = walls_.get();

    // Share of the points' velocity that comes from the nodes
    List<moveCoefficients> take(fields_.size());
    List<pointGridTransfer::nodeVelocities> velocities(fields_.size());
    forAll(fields_, fieldi)
    {
        take[fieldi] = coefficients(fieldi, dt);
        projectedShare_[fieldi] = take[fieldi].projected();
        fields_[fieldi].addProjected(projectedShare_[fieldi]);
    }
    parts_.within(&stepPart::moving, dt);
    forAll(fields_, fieldi)
    {
        velocities[fieldi] = fields_[fieldi].velocities();
        if (massOffsets* offsets = this->offsets(fieldi))
        {
            offsets->turnOn(take[fieldi], velocities[fieldi]);
        }
    }

    scalar travel = 0, rate = 0, work = 0, body = 0;
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
            gridTransfer_->affine(phase.cloud(), moment, moment ? field.UL() : field.U(), dt);
        }
        const pointGridTransfer::moveResult result(
            phase.motion()
                ? phase.motion()->move(phase.cloud(), cellChanges_[phasei])
                : gridTransfer_->move(
                    phase.cloud(), rule, velocities[fieldOf_[phasei]], cellChanges_[phasei]));

        travel = max(travel, result.travel);
        rate = max(rate, result.rate);
        work += result.work;
        momentum += result.momentum;
        body += result.bodyWork;

        // Moving too far does not stop the run: a smaller step may stay inside
        if (bad.phase < 0 && result.badPoint >= 0 && (!result.left || result.travel <= maxTravel_))
        {
            bad = badPoint{phasei, result.badPoint, result.left};
        }
    }
    // In one number: the rate, or that a point is bad or has gone too far,
    // which is asked for only then
    rate_ = largestOfAll(bad.phase < 0 && travel <= maxTravel_ ? rate : VGREAT);
    if (rate_ >= VGREAT)
    {
        travel = largestOfAll(travel);
        rate_ = largestOfAll(bad.phase < 0 ? rate : VGREAT);
        if (rate_ >= VGREAT)
        {
            stop(bad);
        }
    }
    energy_->addMove(dt, work, momentum, body);

    forAll(fields_, fieldi)
    {
        fields_[fieldi].addProjectionImpulse(projectedShare_[fieldi]);
    }

    return travel <= maxTravel_ ? 1 : max(0.8 * maxTravel_ / travel, scalar(0.1));
}

Foam::scalar Foam::mpm::materialPointSystem::project(const scalar dt)
{
    bool changed = false;
    {
        const timer t(clock_.sort);

        // 2: some point, 1: none of them travels on, which without a lattice is
        // by way of a third processor; 0: none has left its cell
        scalar most = Pstream::parRun() ? 2 : 1;
        for (label round = 1; most > 1; ++round)
        {
            bool more = false, any = false;
            forAll(phases_, phasei)
            {
                const wallPatches* walls = phases_[phasei].motion() ? nullptr : walls_.get();
                more |= phases_[phasei].cloud().exchange(cellChanges_[phasei], round, walls);
                any |= cellChanges_[phasei].size() > 0;
            }
            most = grid_.locatesAtOnce() ? 1 : largestOfAll(more ? 2 : any ? 1 : 0);
        }
        if (most > 0)
        {
            gridTransfer_->cellsChange();
        }
        forAll(phases_, phasei)
        {
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
            strain = max(
                strain, fields_[fieldOf_[phasei]].maxStrain(phases_[phasei].cloud().cells(), dt));
        }
    }

    // c/h changes with the cell where cells differ in size; the strain itself
    // is asked for only if it is too large
    const bool varies = grid_.sameWidth() <= 0;
    const scalar rate = energy_->largest(
        !(strain <= maxStrain_) ? VGREAT
            : varies            ? waveRateHere()
                                : 0);
    waveRate_ = varies ? rate : waveRate_;
    if (rate >= VGREAT)
    {
        strain = largestOfAll(strain);
        updateWaveRate();
    }

    return strain <= maxStrain_ ? 1 : max(0.8 * maxStrain_ / strain, scalar(0.1));
}

void Foam::mpm::materialPointSystem::accept(const scalar dt)
{
    for (materialPointPhase& phase : phases_)
    {
        phase.cloud().accept();
    }
    for (velocityField& field : fields_)
    {
        field.accept();
    }
    tentative_ = false;
    parts_.act(&stepPart::accepted, dt);
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
        gridTransfer_->cellsChange();
        updateWaveRate();
        sharesHold_ = false;
        for (massOffsets& offsets : offsets_)
        {
            offsets.change();
        }
    }
    if (stressUpdate_->early())
    {
        for (materialPointPhase& phase : phases_)
        {
            phase.restoreStress();
        }
    }
    tentative_ = false;
    parts_.act(&stepPart::rejected);
}

void Foam::mpm::materialPointSystem::updateVaryingWaves()
{
    for (const materialPointPhase& phase : phases_)
    {
        if (!phase.motion() && phase.law().waveSpeedVaries())
        {
            updateWaveRate();
            return;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::materialPointSystem::advance(const scalar dt, scalar& factor)
{
    keepStress();
    parts_.act(&stepPart::begin, dt);
    stressUpdate_->start(*this, dt);
    parts_.act(&stepPart::start, dt);

    // The right-hand side of (5) is that of the stress of the end of the last
    // step (correctStress), unless a part changes it
    if (parts_.changesForce())
    {
        force(0);
    }
    momentum(dt); // (5)
    parts_.act(&stepPart::impulse, dt);
    filterVelocity();
    parts_.act(&stepPart::exchange, dt);

    factor = move(dt); // (7), (8)
    if (factor >= 1)
    {
        parts_.act(&stepPart::moved, dt);
        stressUpdate_->moved(*this, dt);
        factor = project(dt); // (6), (9)
    }
    if (factor < 1)
    {
        reject();
        return false;
    }
    accept(dt);

    stressUpdate_->end(*this, dt); // section 3.1
    parts_.act(&stepPart::end, dt);
    updateVaryingWaves();

    return true;
}

const Foam::scalarList& Foam::mpm::materialPointSystem::massShares(const label phasei)
{
    if (!sharesHold_)
    {
        // After a step that is redone, and at the start
        forAll(phases_, i)
        {
            if (!phases_[i].motion())
            {
                const velocityField& field = fields_[fieldOf_[i]];
                scalarList mU(field.stride() * grid_.nNodes(), scalar(0));
                projectPhase(i, pointGridTransfer::current, mU.data());
            }
        }
        sharesHold_ = true;
    }
    return shares_[phasei];
}

void Foam::mpm::materialPointSystem::projectAnew(const scalar dt)
{
    const noTraps guard;

    gridTransfer_->cellsChange();
    activate(true);
    projectAll(pointGridTransfer::current);
    for (velocityField& field : fields_)
    {
        field.replace();
    }
    force(dt);
}
