// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "aboveReference.H"
#include "bookedLosses.H"
#include "lanes.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::filter(
    const velocityField::series s, const scalar weight, const scalar scale)
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
                field.startFilter(s, scale);
            }
            scalar* Mv = field.zeroProduct();
            forAll(phases_, phasei)
            {
                if (fieldOf_[phasei] == fieldi && !phases_[phasei].motion())
                {
                    gridTransfer_->massTimes(phases_[phasei].cloud(), false, field.increment(), Mv);
                }
            }
            field.sumColumn(Mv);
            field.nextIncrement(s);
        }
        parts_.within(&stepPart::filtered, s != velocityField::ofStrain);
        for (velocityField& field : fields_)
        {
            field.addIncrement(s, weight);
        }
    }
}

void Foam::mpm::materialPointSystem::finishForce(const scalar dt)
{
    const scalar time = mesh_.time().value() + dt;
    parts_.within(&stepPart::force, time);
    for (velocityField& field : fields_)
    {
        field.sumForce();
        field.sumLoad();
    }
    forAll(fields_, fieldi)
    {
        if (massOffsets* offsets = this->offsets(fieldi))
        {
            offsets->addCouples(fields_[fieldi].force());
            if (fields_[fieldi].hasLoad())
            {
                offsets->addCouples(fields_[fieldi].load());
            }
        }
    }
    for (velocityField& field : fields_)
    {
        field.addLoad();
    }
    parts_.within(&stepPart::summedForce, time);
}

Foam::mpm::massOffsets* Foam::mpm::materialPointSystem::offsets(const label fieldi)
{
    if (!turnSides_ || transfer_->affine() != transferScheme::none)
    {
        return nullptr;
    }
    if (offsets_.empty())
    {
        makeOffsets();
    }
    return &offsets_[fieldi];
}

const Foam::scalar* Foam::mpm::materialPointSystem::filteredPressure(
    materialPointPhase& phase, velocityField& field, const scalar dt)
{
    // Four terms of the projection cost as much as the step
    constexpr label every = 8, terms = 4;
    if (pressureFilter_ <= 0 || mesh_.time().timeIndex() % every != 0)
    {
        return nullptr;
    }
    materialPointCloud& cloud = phase.cloud();
    const label n = cloud.size();
    const column& s = cloud.stress();
    const column* damage = cloud.damage();

    // As pressure and with their volumes; groups of lanes may go beyond the end
    scalarList& weight = filterWeight_;
    scalarList& p = filtered_;
    weight.setSize(n + laneWidth<3>);
    p.setSize(n + laneWidth<3>);
    const int nDiagonal = grid_.nDim() + (grid_.radial() >= 0 ? 1 : 0);
    for (label i = 0; i < n; ++i)
    {
        weight[i] = damage && (*damage)[0][i] > 0 ? 0 : cloud.volume()[0][i];
        scalar trace = grid_.radial() >= 0 ? s[2][i] : 0;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            trace += s[symmSlot(d, d)][i];
        }
        p[i] = -trace / nDiagonal;
    }
    for (label k = 0; k < terms; ++k)
    {
        scalar* sums = field.zeroProduct();
        gridTransfer_->sumAtNodes(cloud, weight.cdata(), p.cdata(), sums);
        field.sumWithMass(sums);
        for (const label node : field.active())
        {
            scalar* q = sums + field.stride() * node;
            q[0] = q[1] > 0 ? q[0] / q[1] : 0;
        }
        gridTransfer_->lessAtPoints(cloud, sums, p.data());
    }

    const scalar share = 1 - std::pow(1 - pressureFilter_, every * dt * waveRate_ / 0.4);
    for (label i = 0; i < n; ++i)
    {
        const scalar rho = cloud.mass()[0][i] / cloud.volume()[0][i];
        p[i] *= weight[i] > 0 ? share / (rho * sqr(phase.law().waveSpeed())) : 0;
    }
    return p.cdata();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::strainVelocity()
{
    const noTraps guard;
    const bool filtered = transfer_->order() > 1 && transfer_->strainFilter() > 0;
    for (velocityField& field : fields_)
    {
        field.strainFromU(filtered || parts_.changesStrain());
    }
    parts_.within(&stepPart::strainVelocity, dt_);
    filter(velocityField::ofStrain, transfer_->strainFilter());
}

void Foam::mpm::materialPointSystem::strainVelocityL()
{
    if (transfer_->order() > 1 && transfer_->filtered() == velocityField::ofDU)
    {
        // Q u^n + Q du, which du is already
        strainVelocity();
        for (velocityField& field : fields_)
        {
            field.addChangeToStrain();
        }
        return;
    }
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
                gridTransfer_->project(
                    phases_[phasei].cloud(), pointGridTransfer::oldPlaces, mU[fieldOf_[phasei]]);
            }
        }
        for (velocityField& field : fields_)
        {
            field.strainFromMomentum();
        }
        parts_.within(&stepPart::strainVelocity, dt_);
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
            gridTransfer_->force(phases_[phasei].cloud(), fields_[fieldOf_[phasei]].force());
        }
    }
    finishForce(dt);
}

void Foam::mpm::materialPointSystem::correctStress(
    const scalar dt, const bool withForce, const scalar dtForce)
{
    // If a part changes the force it is made anew at the start of the step
    const bool makesForce = withForce && !parts_.changesForce();
    const noTraps guard;
    const timer t(clock_.stress);

    for (velocityField& field : fields_)
    {
        if (withForce)
        {
            field.clearForce();
        }
    }
    List<const scalar*> u(fields_.size());
    forAll(fields_, fieldi)
    {
        massOffsets* offsets = this->offsets(fieldi);
        u[fieldi] =
            offsets ? offsets->velocity(fields_[fieldi].Ustrain()) : fields_[fieldi].Ustrain();
    }
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = phases_[phasei];
        if (phase.motion() || !phase.law().hasStress())
        {
            continue;
        }
        const failureModel* failure = phase.failure();
        const scalar pressure = phase.referencePressure();
        autoPtr<bookedLosses> booked;
        if (energy_->active())
        {
            booked.reset(new bookedLosses(failure, phase.law(), grid_.nDim(), pressure));
            failure = booked.get();
        }
        const aboveReference above(failure, pressure);
        if (pressure > 0)
        {
            failure = &above;
        }
        const pointGridTransfer::stressResult result(gridTransfer_->correctStress(
            phase.cloud(), phase.law(), failure, dt, meanMove() ? 0 : stressUpdate_->square(),
            u[fieldOf_[phasei]], makesForce ? fields_[fieldOf_[phasei]].force() : nullptr,
            filteredPressure(phase, fields_[fieldOf_[phasei]], dt)));
        if (result.badPoint >= 0)
        {
            stopForStress(phase, result.badPoint, dt);
        }
        phase.nFailed() += result.nFailed;
        if (booked)
        {
            energy_->losses() += booked->sums();
        }
        if (phase.law().waveSpeedVaries())
        {
            phase.setWaveSpeed(result.waveSpeed, result.fastest);
        }
    }
    if (makesForce)
    {
        finishForce(dtForce);
    }
}
