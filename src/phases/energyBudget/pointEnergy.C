// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointEnergy.H"
#include "materialPointSystem.H"
#include "phaseDamping.H"
#include "pointErosion.H"
#include "pointContact.H"
#include "dictionaryTools.H"
#include "largestOfAll.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Call f(name, value) for terms of a state that goes on
template<class Budget, class Function>
void forTerms(Budget& b, const Function& f)
{
    f("kinetic0", b.kinetic0);
    f("strain0", b.strain0);
    f("internal", b.work.internal);
    f("external", b.work.external);
    f("boundary", b.work.boundary);
}

//- The same of those that older states do not have
template<class Budget, class Function>
void forLaterTerms(Budget& b, const Function& f)
{
    f("erodedKinetic", b.erodedKinetic);
    f("erodedStored", b.erodedStored);
    f("contact", b.work.contact);
    f("damping", b.damping);
    f("driven", b.work.driven);
    f("exchanged", b.exchanged);
    f("pressure", b.work.pressure);
    f("drag", b.work.drag);
    f("compression", b.compression);
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointEnergy::pointEnergy(materialPointSystem& points) :
    stepPart("energy"),
    points_(points),
    startEnergy_(0),
    largestEnergy_(0),
    largestRead_(0),
    energyGrowth_(0),
    leastUnexplained_(0),
    sourceless_(false)
{
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::pointEnergy::hasSources() const
{
    bool sources = mag(points_.g()) > 0 || points_.parts().drives();
    for (const velocityField& field : points_.fields())
    {
        sources = sources || field.drives();
    }
    return returnReduce(sources, orOp<bool>());
}

void Foam::mpm::pointEnergy::noteEnergy(
    const scalar kinetic, const scalar strain, const energyBudget* b) const
{
    // An explosive's stored energy is negative as it drives
    const scalar energy = kinetic + strain;
    const scalar size = max(mag(kinetic), mag(strain));
    if (!(largestEnergy_ > 0))
    {
        const scalar size0 = b ? max(mag(b->kinetic0), mag(b->strain0)) : 0;

        // Energies below this are rounding
        scalar least = b && b->hasGas ? 1e-9 * mag(b->gas.energy0) : 0;
        for (const materialPointPhase& phase : points_.phases())
        {
            if (!phase.motion())
            {
                least += 1e-12 * phase.mass() * sqr(phase.law().waveSpeed());
            }
        }
        largestEnergy_ = max(max(least, largestRead_), b ? size0 : size);
        startEnergy_ = energy;
        sourceless_ = !hasSources();
    }
    if (b)
    {
        const scalar unexplained = b->unexplained();
        leastUnexplained_ = min(leastUnexplained_, unexplained);
        const scalar rise = unexplained - leastUnexplained_;

        // Without what has grown
        largestEnergy_ = max(
            largestEnergy_, max(size, mag(b->hasGas ? b->gas.energy - b->gas.energy0 : 0)) - rise);
        energyGrowth_ = rise
            / max(max(largestEnergy_, VSMALL),
                  b->exchanged + mag(b->gas.heat) + mag(b->gas.granular));
    }
    else if (sourceless_)
    {
        energyGrowth_ = (energy - startEnergy_) / max(largestEnergy_, VSMALL);
    }
}

void Foam::mpm::pointEnergy::update() const
{
    finish();
    const pointCoupling* gas = points_.coupling();
    sums_.kinetic = sums_.strain = 0;
    for (const materialPointPhase& phase : points_.phases())
    {
        // Prescribed bodies do work on the others, booked as boundary
        if (!phase.prescribed())
        {
            sums_.kinetic += phase.kineticEnergy();
            sums_.strain += phase.strainEnergy();
        }
    }
    sums_.losses = losses_;
    sums_.losses.reduceAll();
    sums_.hasGas = gas;
    if (gas)
    {
        sums_.gas = gas->balance();
        pointLosses before(lossesBefore_);
        before.reduceAll();
        sums_.lastStep =
            0.5 * (sums_.losses.work - before.work + sums_.compression - compressionBefore_);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::pointEnergy::largest(const scalar x) const
{
    if (waiting_.empty())
    {
        return largestOfAll(x);
    }
    here_.append(x);
    scalarList all(here_);
    sumsAndLargest(all, 1);
    forAll(waiting_, i)
    {
        *waiting_[i] += all[i];
    }
    waiting_.clear();
    here_.clear();
    return all.last();
}

bool Foam::mpm::pointEnergy::hasContact() const { return points_.parts().find<pointContact>(); }

void Foam::mpm::pointEnergy::startBudget() const
{
    if (sums_.active)
    {
        return;
    }
    sums_.active = true;
    if (pointCoupling* gas = points_.coupling())
    {
        gas->needEnergy();
        gas->startBudget();
    }
    update();
    sums_.kinetic0 = sums_.kinetic;
    sums_.strain0 = sums_.strain;
}

const Foam::mpm::energyBudget* Foam::mpm::pointEnergy::budget() const
{
    if (!sums_.active)
    {
        return nullptr;
    }
    update();
    return &sums_;
}

void Foam::mpm::pointEnergy::begin(const scalar)
{
    lossesBefore_ = losses_;
    sums_.all = bodyWork_ = load_ = 0;
    momentum_ = Zero;
    sums_.step = forceWork();
    mean_.setSize(points_.fields().size());
    impulse_.setSize(points_.fields().size());
    given_ = boolList(points_.fields().size(), false);
}

void Foam::mpm::pointEnergy::impulse(const scalar dt)
{
    if (!sums_.active)
    {
        return;
    }
    scalar boundary = 0;
    for (const velocityField& field : points_.fields())
    {
        boundary += field.boundaryWork(dt, points_.g());
    }
    book(sums_.step.boundary, boundary);
}

template<class Function>
void Foam::mpm::pointEnergy::forActive(const velocityField& field, const Function& f)
{
    const int stride = field.stride(), D = field.nDim();
    for (const label node : field.active())
    {
        for (label i = stride * node; i < stride * node + D; ++i)
        {
            f(i, node);
        }
    }
}

void Foam::mpm::pointEnergy::addImpulse(const label fieldi, const scalar* impulse)
{
    const velocityField& field = points_.fields()[fieldi];
    scalarList& J = impulse_[fieldi];
    if (!given_[fieldi])
    {
        J.setSize(field.stride() * points_.grid().nNodes());
        forActive(field, [&](const label i, label) { J[i] = 0; });
        given_[fieldi] = true;
    }
    forActive(
        field, [&](const label i, const label node) { J[i] += field.part(node) * impulse[i]; });
}

void Foam::mpm::pointEnergy::moving(const scalar)
{
    // Who asks for the mean velocity; all processors alike
    if (!sums_.active || !(hasContact() || points_.coupling() || given_.found(true)))
    {
        return;
    }
    scalar drag = 0;
    forAll(mean_, fieldi)
    {
        const velocityField& field = points_.fields()[fieldi];
        scalarList& mean = mean_[fieldi];
        const int stride = field.stride(), D = field.nDim();
        mean.setSize(stride * points_.grid().nNodes());
        forActive(field, [&](const label i, label) { mean[i] = 0; });
        forAll(points_.phases(), phasei)
        {
            if (points_.fieldOf(phasei) == fieldi && !points_.phases()[phasei].motion())
            {
                points_.gridTransfer().massTimes(
                    points_.phases()[phasei].cloud(), false, field.dU(), mean.data());
            }
        }
        field.sumColumn(mean.data());
        forActive(
            field,
            [&](const label i, const label node)
            {
                const scalar m = field.momentum()[stride * node + D];
                mean[i] = field.U()[i] + (m > 0 ? 0.5 * mean[i] / m : 0);
                drag += given_[fieldi] ? impulse_[fieldi][i] * mean[i] : 0;
            });
    }
    book(sums_.step.drag, drag);
}

void Foam::mpm::pointEnergy::addMove(
    const scalar dt, const scalar work, const vector& momentum, const scalar bodyWork)
{
    if (!sums_.active)
    {
        return;
    }
    scalar load = 0;
    for (const velocityField& field : points_.fields())
    {
        load += field.loadWork(dt);
    }
    book(sums_.all, work);
    for (direction d = 0; d < 3; ++d)
    {
        book(momentum_[d], momentum[d]);
    }
    book(bodyWork_, bodyWork);
    book(load_, load);
}

void Foam::mpm::pointEnergy::accepted(const scalar dt)
{
    compressionBefore_ = sums_.compression;
    forceWork& step = sums_.step;
    step.external += dt * ((points_.g() & momentum_) + bodyWork_) + load_;
    step.internal = sums_.all - (step.sum() - step.internal);
    sums_.work += step;
    sums_.exchanged += mag(step.external) + mag(step.boundary) + mag(step.driven);
}

void Foam::mpm::pointEnergy::rejected()
{
    finish();
    losses_ = lossesBefore_;
}

void Foam::mpm::pointEnergy::addState(dictionary& state) const
{
    if (!sums_.active)
    {
        return;
    }
    finish();
    dictionary energy;
    const auto add = [&](const char* name, const scalar value) { energy.add(name, value); };
    forTerms(sums_, add);
    pointLosses losses(losses_);
    losses.reduceAll();
    energy.add("failure", losses.failure);
    energy.add("dissipation", losses.dissipation);
    energy.add("stressWork", losses.work);
    forLaterTerms(sums_, add);
    if (const pointCoupling* gas = points_.coupling())
    {
        energy.add("gas", gas->balance().state());
    }
    energy.add("largest", max(largestEnergy_, largestRead_));
    energy.add("leastUnexplained", leastUnexplained_);
    state.add("energy", energy);
}

void Foam::mpm::pointEnergy::setState(const dictionary& state)
{
    if (!state.found("energy"))
    {
        return;
    }
    sums_.active = true;
    const dictionary& energy = requiredDict(state, "energy");
    checkKeywords(energy, {"kinetic0",      "strain0",      "internal",    "external",
                           "boundary",      "failure",      "dissipation", "stressWork",
                           "erodedKinetic", "erodedStored", "gas",         "contact",
                           "damping",       "driven",       "exchanged",   "pressure",
                           "drag",          "compression",  "largest",     "leastUnexplained"});
    forTerms(
        sums_, [&](const char* name, scalar& value) { value = required<scalar>(energy, name); });
    forLaterTerms(
        sums_,
        [&](const char* name, scalar& value) { value = energy.getOrDefault<scalar>(name, 0); });
    losses_ = pointLosses();
    if (Pstream::master())
    {
        losses_.failure = energy.getOrDefault<scalar>("failure", 0);
        losses_.dissipation = energy.getOrDefault<scalar>("dissipation", 0);
        losses_.work = energy.getOrDefault<scalar>("stressWork", -sums_.work.internal);
    }
    lossesBefore_ = losses_;
    compressionBefore_ = sums_.compression;
    if (pointCoupling* gas = points_.coupling())
    {
        gas->startBudget();
        if (energy.found("gas"))
        {
            gasBudget sums;
            sums.setState(requiredDict(energy, "gas"));
            gas->setBalance(sums);
        }
    }
    largestRead_ = energy.getOrDefault<scalar>("largest", 0);
    // Of an older state: what is there now
    leastUnexplained_ = energy.getOrDefault<scalar>("leastUnexplained", GREAT);
}

void Foam::mpm::pointEnergy::report() const
{
    scalar mass = 0, kinetic = 0, strain = 0;
    vector momentum(Zero);
    for (const materialPointPhase& phase : points_.phases())
    {
        mass += phase.mass();
        momentum += phase.momentum();
        kinetic += phase.kineticEnergy();
        strain += phase.strainEnergy();
    }
    Info << "Material points: " << points_.nPoints() << ", mass " << mass << ", momentum "
         << momentum << nl << "Energy: kinetic " << kinetic << ", strain " << strain << ", total "
         << kinetic + strain << nl;
    const energyBudget* b = budget();
    noteEnergy(kinetic, strain, b);
    if (b)
    {
        Info << "Energy budget: transfer " << b->transfer() << ", boundary " << b->work.boundary
             << ", external " << b->work.external << ", failure " << b->losses.failure
             << ", dissipation " << b->losses.dissipation;
        if (hasContact())
        {
            Info << ", contact " << b->work.contact;
        }
        Info << ", remap " << b->remap();
        if (points_.erosion().erodes())
        {
            Info << ", erosion " << b->erosion();
        }
        if (points_.damps())
        {
            Info << ", damping " << b->damping;
        }
        if (b->hasGas)
        {
            const gasBudget& g = b->gas;
            Info << nl << "    gas " << g.energy << ", gained " << g.energy - g.energy0
                 << ", boundary " << g.boundary << ", external " << g.external << ", rigid "
                 << g.rigid << ", dry " << g.dry << ", fix-ups " << g.fixups;
            if (points_.coupling()->exchangesHeat())
            {
                Info << ", heat " << g.heat;
            }
            if (points_.coupling()->pressesGrains())
            {
                Info << ", granular " << g.granular;
            }
            if (g.afterburn > 0)
            {
                Info << ", afterburn " << g.afterburn;
            }
            Info << nl << "    to points: pressure " << b->pressure() << ", drag " << b->work.drag
                 << nl << "    last step " << b->lastStep << ", laws " << b->laws() << ", exchange "
                 << b->exchange();
        }
        Info << ", residual " << b->residual() << nl;
    }
    points_.reportSteps();
}
