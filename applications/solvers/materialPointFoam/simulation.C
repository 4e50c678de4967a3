// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "simulation.H"
#include "phaseNames.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "timer.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::simulation::simulation(const fvMesh& mesh) :
    mesh_(&mesh),
    properties_(IOdictionary(IOobject(
        "phaseProperties", mesh.time().constant(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE,
        false))),
    seconds_(0)
{
    warnOfChangedProperties(mesh.time(), properties_);
    makePhases(nullptr);
}

Foam::mpm::simulation::simulation(const fvMesh& mesh, rows&& from) :
    mesh_(&mesh), properties_(from.points.properties), seconds_(0)
{
    if (from.time != mesh.time().value())
    {
        FatalErrorInFunction << "The state is that of time " << from.time << ", but the time is "
                             << mesh.time().value() << "." << exit(FatalError);
    }
    const meshPlaces::order order(from.places.orderOf(mesh));
    for (fieldStates* fields : {&from.gas, &from.points.cellFields})
    {
        forAllIters(*fields, iter) { order.ofCells(iter.val()); }
    }
    forAllIters(from.points.pointFields, iter) { order.ofPoints(iter.val()); }
    forAllIters(from.points.points, iter)
    {
        if (!order.sameCells())
        {
            iter.val().cells.clear();
        }
    }

    Info << "Simulation is built again from memory, time " << mesh.time().timeName() << nl << endl;
    makePhases(&from);
    setState(from.state);
    if (points_)
    {
        points_->resume(from.points);
    }
    if (from.gasBudget.size())
    {
        gasBudget sums;
        sums.setState(from.gasBudget);
        coupling_->setBalance(sums);
    }
    if (from.gains)
    {
        gas_->setAllGained(from.gained);
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::simulation::makePhases(rows* from)
{
    if (phaseNames(properties_, {"materialPoints", "rigid"}).size())
    {
        points_.reset(new materialPointSystem(*mesh_, from ? &from->points : nullptr));
    }
    makeFlow(from);
    if (points_ && gas_)
    {
        coupling_.reset(new gasCoupling(
            *points_, *gas_, properties_, from ? &from->points.cellFields : nullptr));
    }
}

void Foam::mpm::simulation::makeFlow(const rows* from)
{
    const wordList names(phaseNames(properties_, {"gas"}));
    const wordList fluids(phaseNames(properties_, {"fluid"}));
    if (names.empty() && fluids.empty())
    {
        return;
    }
    requireClosed(properties_.name());
    requireClosed(mesh_->schemesDict().name());
    if (names.size() > 1)
    {
        FatalIOErrorInFunction(properties_)
            << "There are " << names.size() << " phases of type gas " << flatOutput(names)
            << "; there may be one. Several that share"
            << " cells are of type fluid." << exit(FatalIOError);
    }
    vector g(Zero);
    IOobject header(
        "g", mesh_->time().constant(), *mesh_, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    if (header.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        g = uniformDimensionedVectorField(header).value();
        if (!points_)
        {
            checkGravity(header.objectPath(), g, mesh_->geometricD());
        }
    }
    if (fluids.size())
    {
        if (!properties_.found("fluids"))
        {
            properties_.add("fluids", dictionary());
        }
        gas_.reset(new eulerianFluids(*mesh_, properties_, fluids, g, from ? &from->gas : nullptr));
        return;
    }
    gas_.reset(new eulerianGas(
        *mesh_, names[0], requiredDict(properties_, names[0]), g, from ? &from->gas : nullptr));
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::simulation::advanceGas(const scalar dt, const scalar all, const bool last)
{
    const timer t(gasSeconds());
    if (coupling_)
    {
        coupling_->advanceGas(dt, all, last);
    }
    else if (gas_)
    {
        gas_->step(dt);
    }
}

Foam::dictionary Foam::mpm::simulation::state() const
{
    dictionary state;
    if (points_)
    {
        state.add("points", points_->state());
    }
    if (gas_)
    {
        state.add("gas", gas_->state());
    }
    return state;
}

void Foam::mpm::simulation::setState(const dictionary& state, const bool ofPoints)
{
    if (points_ && ofPoints)
    {
        points_->setState(requiredDict(state, "points"));
    }
    if (gas_)
    {
        gas_->setState(requiredDict(state, "gas"));
    }
}

Foam::mpm::simulation::rows Foam::mpm::simulation::takeDown()
{
    // A vector in a dictionary has the digits of its text
    const fullPrecision allDigits;
    rows r;
    r.time = mesh_->time().value();
    r.places = meshPlaces(*mesh_);
    r.state = state();
    if (coupling_ && coupling_->hasBudget())
    {
        r.gasBudget = coupling_->balance().state();
    }
    r.gains = gas_ && gas_->hasBudget();
    if (r.gains)
    {
        r.gained = gas_->allGained();
    }
    if (points_)
    {
        r.points = points_->takeDown();
    }
    if (gas_)
    {
        r.gas = gas_->takeDown();
    }
    r.points.properties = properties_;

    coupling_.clear();
    gas_.clear();
    points_.clear();
    pointGrid::Delete(*mesh_);
    return r;
}
