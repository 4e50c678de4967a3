// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "gasCoupling.H"
#include "pointEnergy.H"
#include "cellSums.H"
#include "dictionaryTools.H"
#include "fieldDictionary.H"
#include "largestOfAll.H"
#include "noTraps.H"
#include "startFields.H"
#include "OSspecific.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gasCoupling::settle(const scalar dt)
{
    const noTraps guard;
    vectorField rest;
    scalarField energy;
    later_.finish(pores_, dt, rest, energy);
    drag_.owe(rest);
    if (gas_.hasEnergy())
    {
        gas_.addHeat(identity(energy.size()), energy);
    }
    promise();
}

void Foam::mpm::gasCoupling::updateWidths() const
{
    const fvMesh& mesh = fraction_->mesh();
    inverse_.setSize(mesh.nCells(), 0);
    allWays_.setSize(mesh.nCells(), 0);
    const auto add = [&](const label f, const label c)
    {
        const scalar width = mag(mesh.faceAreas()[f]) / mesh.V()[c];
        inverse_[c] = max(inverse_[c], width);
        allWays_[c] = std::sqrt(sqr(allWays_[c]) + 0.5 * sqr(width));
    };
    for (label f = 0; f < mesh.nInternalFaces(); ++f)
    {
        add(f, mesh.faceOwner()[f]);
        add(f, mesh.faceNeighbour()[f]);
    }
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(pp) && !isA<wedgePolyPatch>(pp))
        {
            forAll(pp, i)
            {
                add(pp.start() + i, pp.faceCells()[i]);
            }
        }
    }
}

void Foam::mpm::gasCoupling::promise()
{
    gas_.promise(later_.owed() - drag_.owedMomentum(), later_.energy() - drag_.owedEnergy());
}

template<class Function>
void Foam::mpm::gasCoupling::forOwed(const Function& f) const
{
    gasCoupling& all = const_cast<gasCoupling&>(*this);
    const word of('.' + gas_.name());
    f("owedPressure" + of, dimPressure * dimTime, all.later_.C());
    f("owedImpulse" + of, dimForce * dimTime, all.later_.B());
    f("owedPressureWork" + of, dimPressure, all.later_.CW());
    f("owedWork" + of, dimPressure, all.drag_.owedWork());
    forAll(points_.phases(), phasei)
    {
        f("owedDrag." + points_.phases()[phasei].name(), dimDensity * dimVelocity,
          all.drag_.owedOf(phasei));
    }
}

Foam::IOobject
Foam::mpm::gasCoupling::owedHeader(const word& name, const IOobject::readOption read) const
{
    const fvMesh& mesh = fraction_->mesh();
    return IOobject(name, mesh.time().timeName(), mesh, read, IOobject::NO_WRITE, false);
}

template<class Function>
void Foam::mpm::gasCoupling::forOwedFields(const Function& f) const
{
    forOwed(
        [&](const word& name, const dimensionSet& dimensions, auto& values)
        {
            typedef typename std::decay<decltype(values[0])>::type Type;
            const DimensionedField<Type, volMesh> field(
                owedHeader(name, IOobject::NO_READ), fraction_->mesh(), dimensions, values);
            f(field);
        });
}

void Foam::mpm::gasCoupling::readOwed(const fieldStates* states)
{
    IOobject first(owedHeader("owedPressure." + gas_.name(), IOobject::MUST_READ));
    const bool there =
        states ? states->found(first.name()) : first.typeHeaderOk<volScalarField::Internal>(false);
    if (!returnReduce(there, orOp<bool>()))
    {
        return;
    }
    forOwed(
        [&](const word& name, const dimensionSet& dimensions, auto& values)
        {
            typedef typename std::decay<decltype(values[0])>::type Type;
            const DimensionedField<Type, volMesh> field(
                fileOrState<DimensionedField<Type, volMesh>>(
                    owedHeader(name, IOobject::MUST_READ), fraction_->mesh(), states));
            checkDimensions(field, dimensions);
            values = field.field();
        });
    later_.resume();
    drag_.resume();
    promise();
}

void Foam::mpm::gasCoupling::addFields(fieldStates& fields) const
{
    if (later_.acts() || drag_.owes())
    {
        forOwedFields([&](const auto& field) { fields.set(field.name(), fieldDictionary(field)); });
    }
}

void Foam::mpm::gasCoupling::writeOwed() const
{
    if (later_.acts() || drag_.owes())
    {
        const fullPrecision allDigits;
        forOwedFields([](const auto& field) { field.write(); });
        return;
    }

    // Nor what an earlier run has left
    const Time& time = fraction_->mesh().time();
    rm(time.path() / time.timeName() / "owedPressure." + gas_.name());
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gasCoupling::gasCoupling(
    materialPointSystem& points, eulerianFlow& gas, const dictionary& properties,
    const fieldStates* fields) :
    points_(points),
    gas_(gas),
    fraction_(solidFraction::New(points, requiredDict(properties, gas.name()))),
    grains_(points, *fraction_, properties),
    pressure_(points, gas, *fraction_),
    drag_(points, gas, *fraction_, properties),
    heat_(points, gas, *fraction_, properties),
    fluctuations_(points, gas, *fraction_, drag_, properties),
    watch_(points, gas, *fraction_, grains_),
    several_(false),
    later_(fraction_->mesh()),
    further_(false),
    settles_(false),
    gasDeltaT_(GREAT),
    passed_(0),
    poreRate_(-1),
    ended_(false),
    removed_(false),
    books_(false)
{
    if (gas_.oneThermo() && !gas_.oneThermo()->isGammaLaw())
    {
        FatalIOErrorInFunction(requiredDict(properties, gas_.name()))
            << "Gas " << gas_.name() << " has an equationOfState; beside"
            << " material points a phase of type gas needs thermo perfectGas or"
            << " isentropic." << nl << "With this equation:  type fluid;" << exit(FatalIOError);
    }
    fraction_->beside(gas.theta(), gas.thetaBehind(), gas.walls());
    fraction_->show(pores_);
    drag_.show(pores_);

    const noTraps guard;
    points_.couple(*this);
    fraction_->initialise();
    scalarField theta(fraction_->theta());
    forAll(theta, c)
    {
        theta[c] = max(1 - theta[c], 1 - fraction_->most());
    }
    gas_.setTheta(theta);
    readOwed(fields);
    watch_.measureEnergy();
    gas_.accompany(*this);
    if (points_.energy().active())
    {
        // The points began before the gas was there
        needEnergy();
        startBudget();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::gasCoupling::start(const scalar dt)
{
    const noTraps guard;
    pressure_.start(grains_, books_, later_, dt);
}

void Foam::mpm::gasCoupling::exchange(const scalar dt)
{
    const noTraps guard;
    pressure_.load(dt);
    drag_.exchange(firstOfGas(dt));
}

void Foam::mpm::gasCoupling::moved(const scalar dt)
{
    const noTraps guard;
    fraction_->depart();
    if (books_)
    {
        pressure_.sumWork(dt);
    }
}

void Foam::mpm::gasCoupling::accepted(const scalar) { fraction_->keepVolumes(); }

void Foam::mpm::gasCoupling::end(const scalar dt)
{
    if (!ended_)
    {
        finish(dt);
    }
    ended_ = false;
}

void Foam::mpm::gasCoupling::removing(const scalar dt)
{
    finish(dt);
    ended_ = true;
}

void Foam::mpm::gasCoupling::finish(const scalar dt)
{
    const noTraps guard;
    fraction_->arrive(dt);
    drag_.updateFaces();
    if (several_)
    {
        drag_.keep(dt);
        steps_->add(pores_, dt);
    }
    if (books_)
    {
        drag_.addWork(budget_);
        pressure_.addWork(budget_);
    }
}

void Foam::mpm::gasCoupling::fill()
{
    scalarField room(fraction_->theta());
    fraction_->initialise();
    room -= fraction_->theta();
    forAll(room, c)
    {
        // No more than there is room: fractions may have added up to more
        const scalar theta = gas_.theta()[c];
        const scalar most = max(theta, 1 - fraction_->theta()[c]);
        room[c] = max(min(room[c], most - theta), min(0.5 * fraction_->eps() - theta, scalar(0)));
    }
    gas_.fill(room);
    removed_ = false;
}

void Foam::mpm::gasCoupling::needEnergy() const
{
    if (!gas_.hasEnergy())
    {
        FatalErrorInFunction << "An energy budget needs a gas with an energy: the thermo of "
                             << gas_.name() << " is isentropic. Remove energyBudget from"
                             << " fvSolution.materialPoints and function objects of type"
                             << " materialPointEnergy, or use perfectGas." << exit(FatalError);
    }
}

void Foam::mpm::gasCoupling::startBudget()
{
    books_ = true;
    for (materialPointPhase& phase : points_.phases())
    {
        phase.cloud().carryGasPressure();
    }
    gas_.startBudget();
    budget_ = gasBudget();
    budget_.mass0 = gas_.mass();
    budget_.momentum0 = gas_.momentum();
    budget_.energy0 = gas_.energy();
}

Foam::mpm::gasBudget Foam::mpm::gasCoupling::balance() const
{
    gasBudget b(budget_);
    const eulerianFlow::flows& gained = gas_.gained();
    b.mass = gas_.mass();
    b.momentum = gas_.momentum();
    b.energy = gas_.energy();
    b.massIn += gained.mass;
    b.boundaryImpulse += gained.impulse;
    b.gravityImpulse += gained.gravityImpulse;
    b.boundary += gained.energy;
    b.external += gained.gravityWork;
    b.fixups += gained.fixups;
    b.afterburn += gained.afterburn;
    b.reduceAll();
    return b;
}

void Foam::mpm::gasCoupling::setBalance(const gasBudget& sums)
{
    startBudget();
    budget_ = Pstream::master() ? sums : gasBudget();
}

void Foam::mpm::gasCoupling::report() const
{
    watch_.report();
    heat_.report();
}

void Foam::mpm::gasCoupling::write()
{
    watch_.write();
    writeOwed();
}

void Foam::mpm::gasCoupling::severalSteps(const bool several)
{
    several_ = several;
    if (several_ && (later_.acts() || drag_.owes()))
    {
        FatalErrorInFunction << "Time " << fraction_->mesh().time().timeName()
                             << " was written with maxGasSubSteps: what points and " << gas_.name()
                             << " owe each other (files owed*) goes with one"
                             << " step of the points." << nl
                             << "Go on with maxGasSubSteps, or start maxSubSteps from a time"
                             << " without these files." << exit(FatalError);
    }
    if (several_ && !steps_)
    {
        steps_.reset(new solidOverSteps(fraction_->mesh()));
    }
}

void Foam::mpm::gasCoupling::severalOfGas(const bool several, const scalar gasDeltaT)
{
    further_ = several;
    gasDeltaT_ = several ? gasDeltaT : GREAT;
    drag_.severalOfGas(several || later_.acts());
}

template<class Function>
Foam::scalar Foam::mpm::gasCoupling::largestRate(const Function& rateOf) const
{
    const noTraps guard;
    if (inverse_.empty())
    {
        updateWidths();
    }
    scalar rate = 0;
    for (const materialPointPhase& phase : points_.phases())
    {
        if (phase.prescribed())
        {
            continue;
        }
        const materialPointCloud& cloud = phase.cloud();
        const scalar* mass = cloud.mass()[0];
        const scalar* volume = cloud.volume()[0];
        forAll(cloud.cells(), k)
        {
            const label c = cloud.cells()[k];
            const scalar rho = cellSum(cloud, k, mass) / cellSum(cloud, k, volume);
            const scalar theta = max(gas_.theta()[c], fraction_->eps());
            rate = max(rate, rateOf(c, theta, rho));
        }
    }
    return rate;
}

Foam::scalar Foam::mpm::gasCoupling::lagRate() const
{
    // See gasCoupling.H
    constexpr scalar added = 0.5, pores = 0.6, drains = 70;
    return largestOfAll(largestRate(
        [&](const label c, const scalar theta, const scalar rho)
        {
            const eulerianFlow::waveState w(gas_.wave(c));
            const scalar spring =
                std::sqrt(w.K / (theta * rho)) / (1 + drains * min(w.drained, 0.1));
            return inverse_[c] * max(w.z / (added * rho), spring / pores);
        }));
}

Foam::scalar Foam::mpm::gasCoupling::poreRate() const
{
    if (poreRate_ < 0)
    {
        poreRate_ = largestOfAll(rateHere());
    }
    return poreRate_;
}

Foam::scalar Foam::mpm::gasCoupling::rateHere() const
{
    // Of a phase of type gas Y is small
    if (gas_.oneThermo() && gas_.oneThermo()->isGammaLaw())
    {
        return 0;
    }

    // The modulus of waves too short for traces of gas
    return largestRate(
               [&](const label c, const scalar theta, const scalar rho)
               {
                   const scalar K = sqr(gas_.wave(c).z) / gas_.states()[c].rho;
                   return allWays_[c] * std::sqrt(K / (theta * rho));
               })
        / points_.stiffestPores();
}

void Foam::mpm::gasCoupling::advanceGas(const scalar dt, const scalar all, const bool last)
{
    if (passed_ > 0)
    {
        const noTraps guard;
        scalarField p(gas_.states().size());
        scalarField pBehind(gas_.boundaryStates().size());
        forAll(p, c)
        {
            p[c] = gas_.states()[c].p;
        }
        forAll(pBehind, i)
        {
            pBehind[i] = gas_.boundaryStates()[i].p;
        }
        fraction_->pushAnew(p, pBehind);
        drag_.further(dt);
        later_.add(p, dt);
    }
    else
    {
        settles_ = drag_.owes();
        drag_.addToGas();
        if (further_)
        {
            later_.begin(gas_.states());
        }
    }
    passed_ += dt;

    solidOnFaces pores(several_ ? steps_->mean(pores_) : pores_);
    if (further_)
    {
        dilation_.setSize(fraction_->mesh().nCells());
        forAll(dilation_, c)
        {
            dilation_[c] = dt / all * pores.dilation[c];
        }
        pores.dilation = dilation_.cdata();
    }
    gas_.step(dt, &pores);
    // With several steps of the points the lag is left out: momentum is not kept in such steps
    if (!several_ && gas_.inHalves())
    {
        later_.add(gas_.pressureOfHalves());
        settles_ = true;
    }
    if (!last)
    {
        return;
    }
    passed_ = 0;
    if (further_ || settles_ || later_.acts())
    {
        settles_ = false;
        settle(all);
    }
    const noTraps guard;
    fluctuations_.exchange(all);
    heat_.exchange(all);
    if (books_)
    {
        heat_.addGain(budget_);
    }
    if (removed_)
    {
        fill();
    }
    if (several_)
    {
        steps_->clear();
    }
    watch_.check();
}
