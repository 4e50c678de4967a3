/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"
#include "pointEnergy.H"
#include "dictionaryTools.H"
#include "noTraps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gasCoupling::gasCoupling
(
    materialPointSystem& points,
    eulerianFlow& gas,
    const dictionary& properties,
    const fieldStates* fields
)
:
    points_(points),
    gas_(gas),
    fraction_
    (
        solidFraction::New(points, requiredDict(properties, gas.name()))
    ),
    grains_(points, *fraction_, properties),
    pressure_(points, gas, *fraction_),
    drag_(points, gas, *fraction_, properties),
    heat_(points, gas, *fraction_, properties),
    watch_(points, gas, *fraction_, grains_),
    several_(false),
    later_(fraction_->mesh()),
    further_(false),
    gasDeltaT_(GREAT),
    passed_(0),
    ended_(false),
    removed_(false),
    books_(false)
{
    if (gas_.oneThermo() && !gas_.oneThermo()->isGammaLaw())
    {
        FatalIOErrorInFunction(requiredDict(properties, gas_.name()))
            << "Gas " << gas_.name() << " has an equationOfState; beside"
            << " material points a phase of type gas needs thermo perfectGas or"
            << " isentropic." << nl << "With this equation:  type fluid;"
            << exit(FatalIOError);
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


void Foam::mpm::gasCoupling::accepted(const scalar)
{
    fraction_->keepVolumes();
}


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
        room[c] =
            max
            (
                min(room[c], most - theta),
                min(0.5*fraction_->eps() - theta, scalar(0))
            );
    }
    gas_.fill(room);
    removed_ = false;
}


void Foam::mpm::gasCoupling::needEnergy() const
{
    if (!gas_.hasEnergy())
    {
        FatalErrorInFunction
            << "An energy budget needs a gas with an energy: the thermo of "
            << gas_.name() << " is isentropic. Remove energyBudget from"
            << " fvSolution.materialPoints and function objects of type"
            << " materialPointEnergy, or use perfectGas." << exit(FatalError);
    }
}


void Foam::mpm::gasCoupling::startBudget()
{
    books_ = true;
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

// ************************************************************************* //
