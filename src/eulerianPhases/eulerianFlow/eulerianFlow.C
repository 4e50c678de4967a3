// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFlow.H"
#include "dictionaryTools.H"
#include "largestOfAll.H"
#include "fullPrecision.H"
#include "noTraps.H"
#include "Time.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeName(eulerianFlow::handle);
}

// * * * * * * * * * * * * * * * * Handle  * * * * * * * * * * * * * * * * * //

Foam::mpm::eulerianFlow::handle::handle(const eulerianFlow& flow) :
    regIOobject(IOobject("eulerianFlow", flow.mesh_.time().timeName(), flow.mesh_)), flow_(flow)
{
}

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::mpm::eulerianFlow::setEnergy(const bool energy)
{
    energy_ = energy;
    rhoE_.setSize(energy ? mesh_.nCells() : 0);
}

Foam::IOobject Foam::mpm::eulerianFlow::header(
    const word& name, const IOobject::readOption read, const word& of) const
{
    return IOobject(
        IOobject::groupName(name, of), mesh_.time().timeName(), mesh_, read, IOobject::NO_WRITE);
}

Foam::dimensionSet Foam::mpm::eulerianFlow::dimensionsOf(const word& name)
{
    return name == "p" || name == "thetaRhoE" ? dimPressure
        : name == "U"                         ? dimVelocity
        : name == "T"                         ? dimTemperature
        : name == "rho" || name == "thetaRho" ? dimDensity
        : name == "thetaRhoU"                 ? dimDensity * dimVelocity
        : name == "psi"                       ? dimDensity / dimPressure
                                              : dimless;
}

const Foam::IOobject& Foam::mpm::eulerianFlow::present(const IOobject& io) const
{
    const bool there = isThere(io);
    if (!there && group_.size())
    {
        FatalErrorInFunction << "Field " << io.name() << " of gas " << name_
                             << " is missing: there is no file " << io.objectPath() << "."
                             << exit(FatalError);
    }
    if (!there)
    {
        FatalErrorInFunction << "Field " << io.name() << " of the fluids is missing: there is no"
                             << " file " << io.objectPath() << ". setFluids writes those of"
                             << " system/setFluidsDict." << exit(FatalError);
    }
    return io;
}

Foam::volScalarField Foam::mpm::eulerianFlow::computed(const word& name) const
{
    return volScalarField(
        header(name, IOobject::NO_READ, group_), mesh_,
        dimensionedScalar(dimensionsOf(name), Zero));
}

void Foam::mpm::eulerianFlow::begin()
{
    conserve();
    primitives();
    far_->setValues(W_, g_, U_, p_);
    far_->warnOfPressure(W_, p_);
    updateBoundaryStates();
    updateFields();
    updateBoundaryStates();
}

void Foam::mpm::eulerianFlow::readState(const fieldStates* states)
{
    typedef volScalarField::Internal scalars;
    typedef volVectorField::Internal vectors;
    theta_ = startField<volScalarField>("theta", states, group_).primitiveField();
    rhoU_ = startField<vectors>("thetaRhoU", states, group_).field();
    if (energy_)
    {
        rhoE_ = startField<scalars>("thetaRhoE", states, group_).field();
    }
    if (far_->hasLayers()
        && (states || isThere(header("layerStrain", IOobject::MUST_READ, group_))))
    {
        far_->layer().strain() = startField<vectors>("layerStrain", states, group_).field();
    }
    porous_ = returnReduce(min(theta_) < 1 || max(theta_) > 1, orOp<bool>());
}

void Foam::mpm::eulerianFlow::forState(const fieldAction& f)
{
    f(p_);
    f(U_);
    volScalarField theta(
        header("theta", IOobject::NO_READ, group_), mesh_, dimensionedScalar(dimless, Zero),
        "zeroGradient");
    theta.primitiveFieldRef() = theta_;
    theta.correctBoundaryConditions();
    f(theta);
    volVectorField::Internal rhoU(
        header("thetaRhoU", IOobject::NO_READ, group_), mesh_, dimensionsOf("thetaRhoU"), rhoU_);
    f(rhoU);
    if (far_->hasLayers())
    {
        volVectorField::Internal strain(
            header("layerStrain", IOobject::NO_READ, group_), mesh_, dimless,
            far_->layer().strain());
        f(strain);
    }
    if (energy_)
    {
        volScalarField::Internal rhoE(
            header("thetaRhoE", IOobject::NO_READ, group_), mesh_, dimPressure, rhoE_);
        f(rhoE);
    }
}

void Foam::mpm::eulerianFlow::setRate(const scalar rate, label bad)
{
    bad = badCell_ < 0 ? bad : badCell_;
    rate_ = bad < 0 ? rate : VGREAT;
    if (companion_)
    {
        scalarList all({companion_->sumHere(), rate_, companion_->rateHere()});
        sumsAndLargest(all, 2);
        rate_ = all[1];
        if (companion_->judge(all[2], all[0]))
        {
            bad = badCell_ < 0 ? bad : badCell_;
            rate_ = largestOfAll(bad < 0 ? rate_ : VGREAT);
        }
    }
    else
    {
        rate_ = largestOfAll(rate_);
    }
    if (rate_ >= VGREAT)
    {
        stop(bad);
    }
    if (viscous_)
    {
        scalarField rhoCv(rho_.size(), 0);
        warmth_ = transport(rhoCv);
        rate_ += viscous_->rate(theta_, rho_, rhoCv);
    }
}

Foam::scalar Foam::mpm::eulerianFlow::newTheta(const scalar A, const scalar D, const scalar eps)
{
    scalar theta = A + D;
    if (theta < 0.5 * A)
    {
        theta = A / (1 - D / A);
        ++fixups_.theta;
    }
    if (theta < min(A, 0.5 * eps))
    {
        theta = min(A, 0.5 * eps);
        ++fixups_.theta;
    }
    return theta;
}

void Foam::mpm::eulerianFlow::bookFixup(const label celli, const scalar energy)
{
    // Without mass there is no end of it: the message is that of the state
    if (!std::isfinite(energy))
    {
        return;
    }
    fixups_.energy += energy;
    if (mag(energy) > fixedMost_)
    {
        fixedMost_ = mag(energy);
        fixedCell_ = celli;
    }
    if (flows_)
    {
        flows_->fixups += energy;
    }
}

Foam::string Foam::mpm::eulerianFlow::pressures() const
{
    scalar least = GREAT, most = -GREAT;
    for (const gasState& w : W_)
    {
        least = min(least, w.p);
        most = max(most, w.p);
    }
    OStringStream os;
    os << returnReduce(least, minOp<scalar>()) << " to " << returnReduce(most, maxOp<scalar>());
    return os.str();
}

void Foam::mpm::eulerianFlow::reportFilled() const
{
    const scalar volume = total(fixups_.filled);
    const scalar mass = total(fixups_.filledMass);
    if (volume != 0)
    {
        Info << "    filled what points left: " << volume << " m3, mass " << mass << endl;
    }
}

void Foam::mpm::eulerianFlow::addViscosity(const scalar dt)
{
    if (!viscous_)
    {
        return;
    }
    viscousFlux::result to{rhoU_, rhoE_, Zero, 0};
    viscous_->add(dt, U_, Wb_, warmth_, theta_, rho_, to);
    if (flows_)
    {
        flows_->impulse += to.impulse;
        flows_->energy += to.energy;
    }
}

void Foam::mpm::eulerianFlow::bookGravity(const scalar dt)
{
    const scalarField& V = mesh_.V();
    if (flows_ && mag(g_) > 0)
    {
        forAll(rho_, c)
        {
            flows_->gravityImpulse += dt * V[c] * rho_[c] * g_;
            flows_->gravityWork += dt * V[c] * (rhoU_[c] & g_);
        }
    }
}

void Foam::mpm::eulerianFlow::stop(const label celli)
{
    // One processor tells
    const label teller =
        returnReduce(celli < 0 ? Pstream::nProcs() : Pstream::myProcNo(), minOp<label>());
    if (teller == Pstream::nProcs())
    {
        FatalErrorInFunction << "The time step of " << name_ << " would be 0 although the state"
                             << " of each cell is good: a speed in constant/phaseProperties has"
                             << " no value of a fluid." << exit(FatalError);
    }
    string text;
    if (teller == Pstream::myProcNo())
    {
        const noTraps guard;
        text = whyBad_.size() ? whyBad_ : stateOf(celli);
    }
    List<string> texts(Pstream::nProcs());
    texts[Pstream::myProcNo()] = text;
    Pstream::gatherList(texts);
    Pstream::scatterList(texts);

    FatalErrorInFunction << texts[teller].c_str() << exit(FatalError);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::eulerianFlow::eulerianFlow(
    const fvMesh& mesh, const word& name, const word& group, const vector& g,
    const fieldStates* states) :
    mesh_(mesh),
    V_(mesh.V()),
    S_(mesh.faceAreas()),
    name_(name),
    group_(group),
    g_(g),
    energy_(false),
    region_(mesh),
    faces_{mesh, region_, {}, {}, {}, {}, {}, {}},
    coupled_(mesh),
    theta_(mesh.nCells(), 1),
    rho_(mesh.nCells()),
    rhoU_(mesh.nCells()),
    W_(mesh.nCells(), gasState{0, Zero, 0}),
    Wb_(mesh.nFaces() - mesh.nInternalFaces(), gasState{1, Zero, 1}),
    thetaB_(Wb_.size(), 1),
    reconstruction_(mesh, region_, coupled_, faces_.boundary, faces_.coupled),
    p_(startField<volScalarField>("p", states, word::null)),
    U_(startField<volVectorField>("U", states, group)),
    psi_(computed("psi")),
    phiField_(
        header("phi", IOobject::NO_READ, group_), mesh,
        dimensionedScalar(dimVolume / dimTime, Zero)),
    phi_(mesh.nFaces(), 0),
    pStar_(mesh.nFaces(), 0),
    limits_(false),
    warmth_(nullptr),
    out_(mesh.nCells()),
    sums_(mesh.nCells()),
    rate_(0),
    porous_(false),
    restarted_(false),
    promised_(Zero),
    promisedEnergy_(0),
    fixedCell_(-1),
    fixedMost_(0),
    badCell_(-1),
    share_(1),
    handle_(*this)
{
    setFaces();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianFlow::addSources(
    const UList<label>& cells, const UList<vector>& momentum, const UList<scalar>& energy,
    const UList<vector>& ahead)
{
    for (const label c : cells)
    {
        sources_.append(source{c, momentum[c], ahead.size() ? ahead[c] : vector(Zero), energy[c]});
    }
    addSources(sources_.size() - cells.size(), 1);
    region_.join();
    velocityChanged();
}

void Foam::mpm::eulerianFlow::addSources(const label first, const scalar share)
{
    for (label i = first; i < sources_.size(); ++i)
    {
        const source& s = sources_[i];
        region_.touch(s.c);
        rhoU_[s.c] += share * s.momentum;
        rhoE_[s.c] += share * s.energy;
        W_[s.c].u = (rhoU_[s.c] + mag(share) * s.ahead) / rho_[s.c];
        U_[s.c] = W_[s.c].u;
    }
}

void Foam::mpm::eulerianFlow::addHeat(const UList<label>& cells, const UList<scalar>& energy)
{
    forAll(cells, i)
    {
        const label c = cells[i];
        scalar heat = energy[i];
        if (heat < 0 && !canGet(c, heat))
        {
            for (int n = 0; n < 4 && !canGet(c, heat); ++n)
            {
                heat *= 0.5;
            }
            heat = canGet(c, heat) ? heat : 0;
            bookFixup(c, (heat - energy[i]) * V_[c]);
        }
        rhoE_[c] += heat;
    }
}

void Foam::mpm::eulerianFlow::step(
    const scalar dt, const solidOnFaces* pores, const label halves, const scalar share)
{
    share_ = share;
    faceFlux(dt, pores);
    startLayers(dt, pores);
    if (advance(dt, pores, halves == mostHalves))
    {
        far_->layer().keep();
        if (halves && pores)
        {
            forAll(pressureOfHalves_, c)
            {
                pressureOfHalves_[c] += dt * (W_[c].p - startOfHalves_[c]);
            }
        }
        return;
    }
    ++fixups_.halved;
    if (!halves && pores)
    {
        inHalves_ = true;
        pressureOfHalves_ = scalarField(mesh_.nCells(), 0);
        startOfHalves_.setSize(mesh_.nCells());
        forAll(startOfHalves_, c)
        {
            startOfHalves_[c] = W_[c].p;
        }
    }
    scalarField dilation(pores ? mesh_.nCells() : 0);
    solidOnFaces half;
    if (pores)
    {
        half = *pores;
        forAll(dilation, c)
        {
            dilation[c] = 0.5 * pores->dilation[c];
        }
        half.dilation = dilation.cdata();
    }
    addSources(0, -0.5 * share);
    velocityChanged();
    step(0.5 * dt, pores ? &half : nullptr, halves + 1, 0.5 * share);
    primitives();
    addSources(0, 0.5 * share);
    updateFields();
    updateBoundaryStates();
    step(0.5 * dt, pores ? &half : nullptr, halves + 1, 0.5 * share);
}

void Foam::mpm::eulerianFlow::step(const scalar dt, const solidOnFaces* pores)
{
    inHalves_ = false;
    step(dt, pores, 0, 1);
}

void Foam::mpm::eulerianFlow::correct()
{
    primitives();
    sources_.clear();

    // phi of the step that has just been made, for conditions that ask
    forAll(mesh_.boundary(), patchi)
    {
        fvsPatchScalarField& phi = phiField_.boundaryFieldRef()[patchi];
        const label start = mesh_.boundaryMesh()[patchi].start();
        forAll(phi, i)
        {
            phi[i] = phi_[start + i];
        }
    }
    updateFields();
    updateBoundaryStates();
    if (region_.next(
            W_, Wb_, faces_.boundary,
            [&](const label c)
            { return theta_[c] == 1 && !(near_.size() && near_[c]) && magSqr(rhoU_[c]) == 0; }))
    {
        leaveAlone();
    }
}

void Foam::mpm::eulerianFlow::leaveAlone()
{
    const label nInternal = mesh_.nInternalFaces();
    forAll(out_, c)
    {
        if (!region_.has(c))
        {
            out_[c] = 0;
        }
    }
    for (label f = 0; f < nInternal; ++f)
    {
        const label c = mesh_.faceOwner()[f];
        if (!region_.has(c) && !region_.has(mesh_.faceNeighbour()[f]))
        {
            phi_[f] = 0;
            pStar_[f] = W_[c].p;
            if (phiLimited_.size())
            {
                phiLimited_[f] = 0;
            }
        }
    }
    reconstruction_.leaveAlone();
}

void Foam::mpm::eulerianFlow::writeFields()
{
    const fullPrecision allDigits;
    forState(
        [&](regIOobject& field)
        {
            field.instance() = mesh_.time().timeName();
            field.write();
        });
}

Foam::mpm::fieldStates Foam::mpm::eulerianFlow::takeDown()
{
    fieldStates states;
    forState([&](const regIOobject& field) { states.set(field.name(), fieldDictionary(field)); });
    return states;
}

Foam::mpm::flowGains Foam::mpm::eulerianFlow::allGained() const
{
    flowGains all(earlier_);
    if (flows_)
    {
        all += *flows_;
    }
    return all;
}

void Foam::mpm::eulerianFlow::setAllGained(const flowGains& sums)
{
    startBudget();
    earlier_ = sums;
}

Foam::dictionary Foam::mpm::eulerianFlow::state() const
{
    dictionary state;
    state.add("limited", total(fixups_.limited));
    state.add("theta", total(fixups_.theta));
    state.add("isentropic", total(fixups_.isentropic));
    state.add("positive", total(fixups_.positive));
    state.add("halved", fixups_.halved);
    state.add("energy", total(fixups_.energy));
    state.add("heldBack", total(fixups_.heldBack));
    state.add("filled", total(fixups_.filled));
    state.add("filledMass", total(fixups_.filledMass));
    return state;
}

void Foam::mpm::eulerianFlow::setState(const dictionary& state)
{
    fixups_ = fixups();
    if (Pstream::master())
    {
        fixups_.limited = required<label>(state, "limited");
        fixups_.theta = required<label>(state, "theta");
        fixups_.isentropic = required<label>(state, "isentropic");
        fixups_.positive = state.getOrDefault<label>("positive", 0);
        fixups_.halved = state.getOrDefault<label>("halved", 0);
        fixups_.energy = required<scalar>(state, "energy");
        fixups_.heldBack = required<scalar>(state, "heldBack");
        fixups_.filled = state.getOrDefault<scalar>("filled", 0);
        fixups_.filledMass = state.getOrDefault<scalar>("filledMass", 0);
    }
}

Foam::scalar Foam::mpm::eulerianFlow::mass() const { return sum(mesh_.V().field() * rho_); }

Foam::vector Foam::mpm::eulerianFlow::momentum() const
{
    return sum(mesh_.V().field() * rhoU_) + promised_;
}

Foam::scalar Foam::mpm::eulerianFlow::energy() const
{
    return rhoE_.size() ? sum(mesh_.V().field() * rhoE_) + promisedEnergy_ : 0;
}
