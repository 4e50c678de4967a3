/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianFlow.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "basicSymmetryFvPatchFields.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeName(eulerianFlow::handle);
}
}

// * * * * * * * * * * * * * * * * Handle  * * * * * * * * * * * * * * * * * //

Foam::mpm::eulerianFlow::handle::handle(const eulerianFlow& flow)
:
    regIOobject
    (
        IOobject("eulerianFlow", flow.mesh_.time().timeName(), flow.mesh_)
    ),
    flow_(flow)
{}

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::mpm::eulerianFlow::setEnergy(const bool energy)
{
    energy_ = energy;
    rhoE_.setSize(energy ? mesh_.nCells() : 0);
}


void Foam::mpm::eulerianFlow::setFaces
(
    const volVectorField& U,
    const volScalarField& p
)
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label nInternal = mesh_.nInternalFaces();

    DynamicList<label> boundary, coupled;
    faces_.wall.setSize(mesh_.nFaces() - nInternal, false);
    forAll(patches, patchi)
    {
        const polyPatch& pp = patches[patchi];
        if (isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        const fvPatchVectorField& Ub = U.boundaryField()[patchi];
        const bool wall =
            (
                Ub.fixesValue()
             || isA<basicSymmetryFvPatchVectorField>(Ub)
            )
         && !p.boundaryField()[patchi].fixesValue();
        for (label f = pp.start(); f < pp.start() + pp.size(); ++f)
        {
            (pp.coupled() ? coupled : boundary).append(f);
            faces_.wall[f - nInternal] = wall;
        }
    }
    far_.reset(new farField(U, p));
    faces_.boundary.transfer(boundary);
    faces_.coupled.transfer(coupled);

    // Courant number per second of a cell: half the sum of |u.S| + c|S| over
    // its faces over its volume
    faceRates_.directions.setSize(mesh_.nCells(), Zero);
    faceRates_.all.setSize(mesh_.nCells(), 0);
    const auto add = [&](const label f, const label c)
    {
        const vector& S = mesh_.faceAreas()[f];
        const scalar h = 0.5/mesh_.V()[c];
        faceRates_.directions[c] += h*cmptMag(S);
        faceRates_.all[c] += h*mag(S);
    };
    for (label f = 0; f < nInternal; ++f)
    {
        add(f, mesh_.faceOwner()[f]);
        add(f, mesh_.faceNeighbour()[f]);
    }
    for (const labelList* list : {&faces_.boundary, &faces_.coupled})
    {
        for (const label f : *list)
        {
            add(f, mesh_.faceOwner()[f]);
        }
    }

    faces_.Vb.setSize(mesh_.nFaces() - nInternal);
    faces_.magS.setSize(mesh_.nFaces());
    forAll(faces_.magS, f)
    {
        faces_.magS[f] = mag(mesh_.faceAreas()[f]);
    }
    forAll(faces_.Vb, i)
    {
        faces_.Vb[i] = mesh_.V()[mesh_.faceOwner()[nInternal + i]];
    }
    coupled_.swap(faces_.Vb);
}


Foam::scalar Foam::mpm::eulerianFlow::newTheta
(
    const scalar A,
    const scalar D,
    const scalar eps
)
{
    scalar theta = A + D;
    if (theta < 0.5*A)
    {
        theta = A/(1 - D/A);
        ++fixups_.theta;
    }
    if (theta < min(A, 0.5*eps))
    {
        theta = min(A, 0.5*eps);
        ++fixups_.theta;
    }
    return theta;
}


void Foam::mpm::eulerianFlow::bookFixup
(
    const label celli,
    const scalar energy
)
{
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


Foam::dictionary Foam::mpm::eulerianFlow::fixupState() const
{
    dictionary state;
    state.add("limited", returnReduce(fixups_.limited, sumOp<label>()));
    state.add("theta", returnReduce(fixups_.theta, sumOp<label>()));
    state.add("isentropic", returnReduce(fixups_.isentropic, sumOp<label>()));
    state.add("positive", returnReduce(fixups_.positive, sumOp<label>()));
    state.add("energy", returnReduce(fixups_.energy, sumOp<scalar>()));
    state.add("heldBack", returnReduce(fixups_.heldBack, sumOp<scalar>()));
    state.add("filled", returnReduce(fixups_.filled, sumOp<scalar>()));
    state.add("filledMass", returnReduce(fixups_.filledMass, sumOp<scalar>()));
    return state;
}


void Foam::mpm::eulerianFlow::setFixups(const dictionary& state)
{
    fixups_ = fixups();
    if (Pstream::master())
    {
        fixups_.limited = required<label>(state, "limited");
        fixups_.theta = required<label>(state, "theta");
        fixups_.isentropic = required<label>(state, "isentropic");
        fixups_.positive = state.getOrDefault<label>("positive", 0);
        fixups_.energy = required<scalar>(state, "energy");
        fixups_.heldBack = required<scalar>(state, "heldBack");
        fixups_.filled = state.getOrDefault<scalar>("filled", 0);
        fixups_.filledMass = state.getOrDefault<scalar>("filledMass", 0);
    }
}


void Foam::mpm::eulerianFlow::reportFilled() const
{
    const scalar volume = returnReduce(fixups_.filled, sumOp<scalar>());
    const scalar mass = returnReduce(fixups_.filledMass, sumOp<scalar>());
    if (volume != 0)
    {
        Info<< "    filled what points left: " << volume << " m3, mass "
            << mass << endl;
    }
}


void Foam::mpm::eulerianFlow::updateViscosity()
{
    if (viscous_)
    {
        scalarField rhoCv(rho_.size(), 0);
        warmth_ = transport(rhoCv);
        rate_ += viscous_->rate(theta_, rho_, rhoCv);
    }
}


void Foam::mpm::eulerianFlow::addViscosity
(
    const scalar dt,
    const volVectorField& U
)
{
    if (!viscous_)
    {
        return;
    }
    viscousFlux::result to{rhoU_, rhoE_, Zero, 0};
    viscous_->add
    (
        dt, U, Wb_, warmth_, theta_, rho_, to
    );
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
            flows_->gravityImpulse += dt*V[c]*rho_[c]*g_;
            flows_->gravityWork += dt*V[c]*(rhoU_[c] & g_);
        }
    }
}


void Foam::mpm::eulerianFlow::stop(const label celli)
{
    // One processor tells
    const label teller = returnReduce
    (
        celli < 0 ? Pstream::nProcs() : Pstream::myProcNo(),
        minOp<label>()
    );
    if (teller == Pstream::nProcs())
    {
        FatalErrorInFunction
            << "The time step of " << name_ << " would be 0 although the state"
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

Foam::mpm::eulerianFlow::eulerianFlow
(
    const fvMesh& mesh,
    const word& name,
    const vector& g
)
:
    mesh_(mesh),
    name_(name),
    g_(g),
    energy_(false),
    faces_{mesh, {}, {}, {}, {}, {}},
    coupled_(mesh),
    theta_(mesh.nCells(), 1),
    rho_(mesh.nCells()),
    rhoU_(mesh.nCells()),
    W_(mesh.nCells()),
    Wb_(mesh.nFaces() - mesh.nInternalFaces(), gasState{1, Zero, 1}),
    thetaB_(Wb_.size(), 1),
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
    handle_(*this)
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianFlow::addSources
(
    const UList<label>& cells,
    const UList<vector>& momentum,
    const UList<scalar>& energy,
    const UList<vector>& ahead
)
{
    for (const label c : cells)
    {
        rhoU_[c] += momentum[c];
        rhoE_[c] += energy[c];
        W_[c].u =
            (ahead.size() ? vector(rhoU_[c] + ahead[c]) : rhoU_[c])/rho_[c];
    }
    velocityChanged(cells);
}


void Foam::mpm::eulerianFlow::addHeat
(
    const UList<label>& cells,
    const UList<scalar>& energy
)
{
    forAll(cells, i)
    {
        rhoE_[cells[i]] += energy[i];
    }
}


Foam::scalar Foam::mpm::eulerianFlow::mass() const
{
    return sum(mesh_.V().field()*rho_);
}


Foam::vector Foam::mpm::eulerianFlow::momentum() const
{
    return sum(mesh_.V().field()*rhoU_) + promised_;
}


Foam::scalar Foam::mpm::eulerianFlow::energy() const
{
    return
        rhoE_.size() ? sum(mesh_.V().field()*rhoE_) + promisedEnergy_ : 0;
}

// ************************************************************************* //
