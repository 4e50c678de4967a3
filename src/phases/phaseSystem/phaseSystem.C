/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "phaseSystem.H"
#include "selector.H"
#include "fatalMessages.H"
#include "noTraps.H"
#include "uniformDimensionedFields.H"
#include "Time.H"
#include "OSspecific.H"
#include <chrono>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(pointPhaseSystem, 0);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Adds the wall-clock time of a scope
class timer
{
    scalar& sum_;
    const std::chrono::steady_clock::time_point start_;

public:

    explicit timer(scalar& sum)
    :
        sum_(sum),
        start_(std::chrono::steady_clock::now())
    {}

    ~timer()
    {
        sum_ +=
            std::chrono::duration<scalar>
            (
                std::chrono::steady_clock::now() - start_
            ).count();
    }
};


//- Largest value of all processors, by the reduction that MPI does itself
scalar largestOfAll(const scalar x)
{
    scalar least = -x;
    reduce(least, minOp<scalar>());
    return -least;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointPhaseSystem::readNumerics()
{
    const dictionary& dict =
        requiredDict(mesh_.solutionDict(), "materialPoints");

    wordList valid(transfer::keywords());
    valid.append
    (
        wordList
        ({
            "shapeFunction", "stressUpdate", "energyBudget", "maxTravel",
            "maxStrain"
        })
    );
    checkKeywords(dict, valid);

    transfer_ = transfer(dict);
    stressUpdate_ = stressUpdate::New(dict);
    maxTravel_ = boundedOrDefault(dict, "maxTravel", 0.5, 1e-3, 0.9);
    maxStrain_ = boundedOrDefault(dict, "maxStrain", 0.2, 1e-4, 1);
}


void Foam::mpm::pointPhaseSystem::filter
(
    const gridState::series s,
    const scalar weight
)
{
    if (weight <= 0)
    {
        return;
    }
    const timer t(clock_.project);
    forAll(fields_, fieldi)
    {
        gridState& field = fields_[fieldi];
        for (label k = 1; k < transfer_.order; ++k)
        {
            if (k == 1)
            {
                field.startFilter(s);
            }
            scalar* Mv = field.zeroProduct();
            forAll(phases_, phasei)
            {
                if (fieldOf_[phasei] == fieldi && !phases_[phasei].motion())
                {
                    passes_->massTimes
                    (
                        phases_[phasei].cloud(),
                        false,
                        field.increment(),
                        Mv
                    );
                }
            }
            field.sumColumn(Mv);
            field.addFilter(s, weight);
        }
    }
}


void Foam::mpm::pointPhaseSystem::startAffine()
{
    // Fixed point of C = grad u(v, C): rigid rotation to rounding
    const noTraps guard;
    for (label i = 0; i < 200; ++i)
    {
        scalar size = 0, change = 0;
        forAll(phases_, phasei)
        {
            materialPointCloud& cloud = phases_[phasei].cloud();
            const gridState& field = fields_[fieldOf_[phasei]];
            if (phases_[phasei].motion())
            {
                continue;
            }
            passes_->affine(cloud, false, field.U(), field.stride());
            column& C = *cloud.affine();
            column& CNew = *cloud.affineNew();
            for (int c = 0; c < C.nComponents(); ++c)
            {
                for (label p = 0; p < cloud.size(); ++p)
                {
                    size = max(size, mag(CNew[c][p]));
                    change = max(change, mag(CNew[c][p] - C[c][p]));
                }
            }
            C.swap(CNew);
        }
        activate(false);
        projectAll(pointPasses::current);
        for (gridState& field : fields_)
        {
            field.accept();
        }
        reduce(size, maxOp<scalar>());
        reduce(change, maxOp<scalar>());
        if (debug)
        {
            Info<< "startAffine " << i << ": " << change << " of " << size << nl;
        }
        if (change <= 1e-14*size)
        {
            break;
        }
    }
}


Foam::scalar Foam::mpm::pointPhaseSystem::shortestSide
(
    const materialPointPhase& phase
) const
{
    if (grid_.sameWidth() > 0)
    {
        return grid_.sameWidth();
    }
    scalar shortest = GREAT;
    for (const label celli : phase.cloud().cells())
    {
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            shortest = min(shortest, grid_.width(celli, d));
        }
    }
    return shortest;
}


void Foam::mpm::pointPhaseSystem::updateWaveRate()
{
    scalar rate = 0;
    for (const materialPointPhase& phase : phases_)
    {
        if (!phase.motion())
        {
            const scalar c = phase.waveSpeed();
            rate = max(rate, c/shortestSide(phase));
        }
    }
    waveRate_ = largestOfAll(rate);
}


void Foam::mpm::pointPhaseSystem::activate(const bool changed)
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
        fields_[fieldi].activate(cells, passes_->reach());
    }
}


void Foam::mpm::pointPhaseSystem::projectAll
(
    const pointPasses::states state
)
{
    const noTraps guard;

    for (gridState& field : fields_)
    {
        field.clearMomentum();
    }
    forAll(phases_, phasei)
    {
        // Nodes of rigid phases have a velocity without their mass
        if (!phases_[phasei].motion())
        {
            passes_->project
            (
                phases_[phasei].cloud(),
                state,
                fields_[fieldOf_[phasei]].momentumNew()
            );
        }
    }
    reachRigid(state);
    for (gridState& field : fields_)
    {
        field.sumMomentum();
        field.velocity();
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointPhaseSystem::pointPhaseSystem(const fvMesh& mesh)
:
    regIOobject
    (
        IOobject
        (
            "pointPhaseSystem",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(mesh),
    grid_(hexGrid::New(mesh)),
    properties_
    (
        IOobject
        (
            "phaseProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    g_(Zero),
    rate_(0),
    waveRate_(0),
    nRedone_(0),
    dt_(0),
    tentative_(false),
    warned_(false),
    coupling_(nullptr)
{
    IOobject gHeader
    (
        "g",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if
    (
        gHeader.typeHeaderOk<uniformDimensionedVectorField>(true)
     || exists(mesh.time().globalPath()/mesh.time().constant()/"g")
    )
    {
        const auto g = readNamed
        (
            gHeader.objectPath(),
            [&]
            {
                const uniformDimensionedVectorField field(gHeader);
                return dimensionedVector(field.name(), field.dimensions(),
                    field.value());
            }
        );
        const noTraps guard;
        if (g.dimensions() != dimAcceleration || !std::isfinite(mag(g.value())))
        {
            FatalErrorInFunction
                << "Gravity in " << gHeader.objectPath() << " is " << g.value()
                << ' ' << g.dimensions() << "; it must be finite and in "
                << dimAcceleration << " (m/s2)." << exit(FatalError);
        }
        g_ = g.value();
    }

    requireClosed(properties_.objectPath());
    requireClosed(mesh.solutionDict().name());
    readNumerics();
    passes_ = pointPasses::New
    (
        mesh.solutionDict().subDict("materialPoints"),
        grid_
    );

    const wordList names(materialPointPhase::names(properties_));
    phases_.setSize(names.size());
    fieldOf_.setSize(names.size());
    movers_.setSize(names.size());

    wordList fieldNames;
    forAll(names, phasei)
    {
        phases_.set
        (
            phasei,
            new materialPointPhase
            (
                grid_,
                names[phasei],
                requiredDict(properties_, names[phasei]),
                passes_->hasExtent(),
                transfer_.kind == transfer::APIC
            )
        );
        const word& field = phases_[phasei].velocityField();
        fieldOf_[phasei] = fieldNames.find(field);
        if (fieldOf_[phasei] < 0)
        {
            fieldOf_[phasei] = fieldNames.size();
            fieldNames.append(field);
        }
    }

    fields_.setSize(fieldNames.size());
    forAll(fieldNames, fieldi)
    {
        const fileName file
        (
            mesh.time().timePath()
           /IOobject::groupName("U", fieldNames[fieldi])
        );
        fields_.set
        (
            fieldi,
            readNamed
            (
                file,
                [&]
                {
                    return new gridState
                    (
                        grid_,
                        fieldNames[fieldi],
                        passes_->reach()
                    );
                }
            )
        );
        fields_[fieldi].rigid().setPhases(phases_.size());
    }

    for (materialPointPhase& phase : phases_)
    {
        phase.read();
        Info<< "Phase " << phase.name() << ": "
            << returnReduce(phase.cloud().size(), sumOp<label>())
            << " points of ";
        if (phase.motion())
        {
            Info<< "a rigid body, motion " << phase.motion()->type();
            phase.motion()->start(mesh_.time().value(), Zero);
            phase.motion()->setVelocity(phase.cloud());
        }
        else
        {
            Info<< phase.law().type() << ", wave speed "
                << phase.law().waveSpeed() << " m/s";
        }
        Info<< ", velocity field " << phase.velocityField() << nl;

        // The domain of a point must not reach past the next cell
        if (passes_->hasExtent())
        {
            materialPointCloud& cloud = phase.cloud();
            forAll(cloud.cells(), k)
            {
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    for (int d = 0; d < grid_.nDim(); ++d)
                    {
                        const scalar l = (*cloud.halfSize())[d][p];
                        if (l > 1.0001*grid_.width(cloud.cells()[k], d))
                        {
                            FatalErrorInFunction
                                << "Material point " << cloud.id()[0][p]
                                << " of " << phase.name() << " at "
                                << cloud.position(p, cloud.cells()[k])
                                << ", time " << mesh_.time().timeName()
                                << ", has half-size " << l
                                << ", larger than its cell." << nl
                                << "Use more points per cell in"
                                << " setMaterialPointsDict or the shape"
                                << " function linear." << exit(FatalError);
                        }
                    }
                }
            }
        }
        const materialPointCloud& cloud = phase.cloud();
        forAll(cloud.cells(), k)
        {
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                const scalar ih = 1/grid_.width(cloud.cells()[k], d);
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    rate_ = max(rate_, mag(cloud.U()[d][p])*ih);
                }
            }
        }
    }
    rate_ = largestOfAll(rate_);
    updateWaveRate();

    startNodes();
    bool haveAffine = true;
    for (const materialPointPhase& phase : phases_)
    {
        haveAffine = haveAffine && (phase.motion() || phase.cloud().affineRead());
    }
    if
    (
        transfer_.kind == transfer::APIC
     && !returnReduce(haveAffine, orOp<bool>())
    )
    {
        startAffine();
    }
    for (gridState& field : fields_)
    {
        field.writeField();
    }
    if
    (
        mesh.solutionDict().subDict("materialPoints")
       .getOrDefault<bool>("energyBudget", false)
    )
    {
        bookEnergy();
    }
    checkOverlap();

    Info<< "Material points: " << nPoints() << " in "
        << phases_.size() << " phases, " << grid_.nDim() << "D, "
        << grid_.nNodes() << " nodes, "
        << (grid_.hasLattice() ? "lattice" : "general hexahedra") << nl
        << "    shape function "
        << mesh.solutionDict().subDict("materialPoints").get<word>("shapeFunction")
        << ", stress update " << stressUpdate_->name() << nl << "    ";
    transfer_.write(Info);
    reportBalance();
    Info<< "    " << bytesPerPoint() << " bytes per point in columns and"
        << " buffers, " << gridBytes()/max(nPoints(), label(1))
        << " on the nodes" << nl << endl;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::pointPhaseSystem::nPoints() const
{
    label n = 0;
    for (const materialPointPhase& phase : phases_)
    {
        n += phase.cloud().size();
    }
    return returnReduce(n, sumOp<label>());
}


Foam::scalar Foam::mpm::pointPhaseSystem::bytesPerPoint() const
{
    scalar bytes = 0;
    label n = 0;
    forAll(phases_, phasei)
    {
        const materialPointCloud& cloud = phases_[phasei].cloud();
        bytes += cloud.bytesPerPoint()*cloud.size();
        bytes +=
            movers_[phasei].capacity()*sizeof(materialPointCloud::mover);
        n += cloud.size();
    }
    reduce(bytes, sumOp<scalar>());
    reduce(n, sumOp<label>());
    return bytes/max(n, label(1));
}


Foam::scalar Foam::mpm::pointPhaseSystem::gridBytes() const
{
    scalar bytes = 0;
    for (const gridState& field : fields_)
    {
        bytes += field.bytes();
    }
    return returnReduce(bytes, sumOp<scalar>());
}


void Foam::mpm::pointPhaseSystem::momentum(const scalar dt)
{
    const noTraps guard;
    {
        const timer t(clock_.nodes);
        dt_ = dt;
        for (gridState& field : fields_)
        {
            field.newTime(dt);
        }
        advanceRigid(dt);
        for (gridState& field : fields_)
        {
            field.momentumStep(dt, g_);
        }
    }

    if (budget_.active)
    {
        scalar boundary = 0;
        for (const gridState& field : fields_)
        {
            boundary += field.boundaryWork(dt, g_);
        }
        budget_.step.boundary = returnReduce(boundary, sumOp<scalar>());
    }

    if (transfer_.kind == transfer::FMPM)
    {
        filter(gridState::FMPM, 1);
    }
    else if (transfer_.kind == transfer::XPIC)
    {
        filter(gridState::XPIC, 1);
    }
}


Foam::scalar Foam::mpm::pointPhaseSystem::move(const scalar dt)
{
    const noTraps guard;
    const timer t(clock_.move);

    pointPasses::moveRule rule;
    rule.dt = dt;
    rule.kind = transfer_.kind;
    rule.PICfraction = transfer_.fraction(dt*courantRate());

    rule.energy = budget_.active;

    const scalar projected =
        transfer_.kind == transfer::FLIP ? rule.PICfraction : 1;
    for (gridState& field : fields_)
    {
        field.addProjected(projected);
    }

    scalar travel = 0, rate = 0, work = 0, body = 0;
    vector momentum(Zero);
    badPoint bad{-1, -1, false};
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = phases_[phasei];
        const gridState& field = fields_[fieldOf_[phasei]];
        rule.U = field.U();
        rule.bodyForce = phase.bodyAcceleration();
        if (transfer_.kind == transfer::APIC && !phase.motion())
        {
            const bool moment = transfer_.moment;
            passes_->affine
            (
                phase.cloud(),
                moment,
                moment ? field.UL() : field.U(),
                moment ? 2*field.stride() : field.stride()
            );
        }
        const pointPasses::moveResult result
        (
            phase.motion()
          ? phase.motion()->move(phase.cloud(), movers_[phasei])
          : passes_->move
            (
                phase.cloud(),
                rule,
                field.UL(),
                movers_[phasei]
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
        forceWork& step = budget_.step;
        step.external = dt*((g_ & momentum) + body);
        step.internal = work - step.external - step.boundary;
    }

    for (gridState& field : fields_)
    {
        field.addProjectionImpulse(projected);
    }

    return travel <= maxTravel_ ? 1 : max(0.8*maxTravel_/travel, scalar(0.1));
}


Foam::scalar Foam::mpm::pointPhaseSystem::project(const scalar dt)
{
    bool changed = false;
    {
        const timer t(clock_.sort);
        forAll(phases_, phasei)
        {
            phases_[phasei].cloud().exchange(movers_[phasei]);
            checkExtent(phases_[phasei], movers_[phasei]);
            if (phases_[phasei].cloud().sort(movers_[phasei]))
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
        projectAll(pointPasses::tentative);
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


void Foam::mpm::pointPhaseSystem::accept()
{
    for (materialPointPhase& phase : phases_)
    {
        phase.cloud().accept();
        if (phase.motion())
        {
            phase.motion()->accept();
        }
    }
    for (gridState& field : fields_)
    {
        field.accept();
    }
    budget_.work += budget_.step;
    tentative_ = false;
}


void Foam::mpm::pointPhaseSystem::reject()
{
    ++nRedone_;
    if (tentative_)
    {
        for (materialPointPhase& phase : phases_)
        {
            phase.cloud().reject();
        }
        for (gridState& field : fields_)
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
    }
    tentative_ = false;
}


void Foam::mpm::pointPhaseSystem::strainVelocity()
{
    const noTraps guard;
    const bool filtered = transfer_.order > 1 && transfer_.strainFilter > 0;
    for (gridState& field : fields_)
    {
        field.strainFromU(filtered);
    }
    filter(gridState::strain, transfer_.strainFilter);
}


void Foam::mpm::pointPhaseSystem::strainVelocityL()
{
    for (gridState& field : fields_)
    {
        field.strainFromUL(transfer_.strainFilter);
    }
}


void Foam::mpm::pointPhaseSystem::strainVelocityAnew()
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
                passes_->project
                (
                    phases_[phasei].cloud(),
                    pointPasses::oldPlaces,
                    mU[fieldOf_[phasei]]
                );
            }
        }
        for (gridState& field : fields_)
        {
            field.strainFromMomentum();
        }
    }
    filter(gridState::strain, transfer_.strainFilter);
}


void Foam::mpm::pointPhaseSystem::force(const scalar dt)
{
    const noTraps guard;
    const timer t(clock_.stress);

    for (gridState& field : fields_)
    {
        field.clearForce();
    }
    forAll(phases_, phasei)
    {
        if (!phases_[phasei].motion())
        {
            passes_->force
            (
                phases_[phasei].cloud(),
                fields_[fieldOf_[phasei]].force()
            );
        }
    }
    finishForce(dt);
}


void Foam::mpm::pointPhaseSystem::finishForce(const scalar dt)
{
    addBodyForces(mesh_.time().value() + dt);
    for (gridState& field : fields_)
    {
        field.sumForce();
    }
}


void Foam::mpm::pointPhaseSystem::correctStress
(
    const scalar dt,
    const bool withForce,
    const scalar dtForce
)
{
    const noTraps guard;
    const timer t(clock_.stress);

    for (gridState& field : fields_)
    {
        if (withForce)
        {
            field.clearForce();
        }
    }
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = phases_[phasei];
        if (phase.motion())
        {
            continue;
        }
        const pointPasses::stressResult result
        (
            passes_->correctStress
            (
                phase.cloud(),
                phase.law(),
                phase.failure(),
                dt,
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
        if (phase.law().waveSpeedVaries())
        {
            phase.setWaveSpeed(result.waveSpeed);
        }
    }
    if (withForce && !coupling_)
    {
        finishForce(dtForce);
    }
}


void Foam::mpm::pointPhaseSystem::couple(pointCoupling& coupling)
{
    if (stressUpdate_->early() || word(stressUpdate_->name()) != "MUSL")
    {
        FatalIOErrorInFunction
        (
            mesh_.solutionDict().subDict("materialPoints")
        )   << "stressUpdate " << stressUpdate_->name() << " does not work in"
            << " a gas, which has to act on the stress of the start of the"
            << " step." << nl << "Valid choice: MUSL" << exit(FatalIOError);
    }
    if (budget_.active)
    {
        FatalIOErrorInFunction
        (
            mesh_.solutionDict().subDict("materialPoints")
        )   << "energyBudget is that of points without a gas; remove it."
            << exit(FatalIOError);
    }
    coupling_ = &coupling;
}


void Foam::mpm::pointPhaseSystem::addImpulse
(
    const label fieldi,
    scalar* impulse
)
{
    gridState& field = fields_[fieldi];
    field.sumColumn(impulse);
    field.addImpulse(impulse);
}


bool Foam::mpm::pointPhaseSystem::advance(const scalar dt, scalar& factor)
{
    if (stressUpdate_->early())
    {
        for (materialPointPhase& phase : phases_)
        {
            phase.keepStress();
        }
    }
    stressUpdate_->start(*this, dt);

    if (coupling_)
    {
        coupling_->force();
        force(0);
    }
    momentum(dt);
    if (coupling_)
    {
        coupling_->drag(dt);
    }
    factor = move(dt);
    if (factor >= 1)
    {
        if (coupling_)
        {
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
        coupling_->accepted();
    }
    stressUpdate_->end(*this, dt);
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
        coupling_->arrive(dt);
    }
    checkOverlap();

    return true;
}

// ************************************************************************* //
