// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "pointErosion.H"
#include "pointLoads.H"
#include "phaseDamping.H"
#include "rigidBodies.H"
#include "pointContact.H"
#include "phaseWatches.H"
#include "startHints.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "largestOfAll.H"
#include "noTraps.H"
#include "uniformDimensionedFields.H"
#include "Time.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Kinds of cells by their faces: "tetrahedra, prisms". Collective
std::string cellTypes(const polyMesh& mesh)
{
    static const char* const names[] = {
        "hexahedra", "prisms", "pyramids", "tetrahedra", "polyhedra"};
    labelList n(5, label(0));
    for (const cell& faces : mesh.cells())
    {
        label nTriangles = 0, nQuads = 0;
        for (const label facei : faces)
        {
            nTriangles += mesh.faces()[facei].size() == 3;
            nQuads += mesh.faces()[facei].size() == 4;
        }
        const label kind = faces.size() != nTriangles + nQuads ? 4
            : nTriangles == 0 && nQuads == 6                   ? 0
            : nTriangles == 2 && nQuads == 3                   ? 1
            : nTriangles == 4 && nQuads == 1                   ? 2
            : nTriangles == 4 && nQuads == 0                   ? 3
                                                               : 4;
        ++n[kind];
    }
    std::string found;
    forAll(n, kind)
    {
        if (returnReduce(n[kind], sumOp<label>()))
        {
            found += (found.empty() ? "" : ", ") + std::string(names[kind]);
        }
    }
    return found;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::readGravity()
{
    IOobject gHeader(
        "g", mesh_.time().constant(), mesh_, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    if (gHeader.typeHeaderOk<uniformDimensionedVectorField>(true)
        || exists(mesh_.time().globalPath() / mesh_.time().constant() / "g"))
    {
        const auto g = readNamed(
            gHeader.objectPath(),
            [&]
            {
                const uniformDimensionedVectorField field(gHeader);
                return dimensionedVector(field.name(), field.dimensions(), field.value());
            });
        const noTraps guard;
        if (g.dimensions() != dimAcceleration || !std::isfinite(mag(g.value())))
        {
            FatalErrorInFunction << "Gravity in " << gHeader.objectPath() << " is " << g.value()
                                 << ' ' << g.dimensions() << "; it must be finite and in "
                                 << dimAcceleration << " (m/s2)." << exit(FatalError);
        }
        g_ = g.value();
        checkGravity(gHeader.objectPath(), g_, mesh_.geometricD());
        Info << "Gravity " << g_ << " m/s2" << nl;
    }
    else
    {
        Info << "No gravity: constant/g is missing" << nl;
    }
}

void Foam::mpm::materialPointSystem::readPhases()
{
    const wordList names(materialPointPhase::names(properties_));
    phases_.setSize(names.size());
    fieldOf_.setSize(names.size());
    cellChanges_.setSize(names.size());
    shares_.setSize(names.size());
    if (properties_.found("outflow"))
    {
        outflow_.reset(new outflowPatches(requiredDict(properties_, "outflow"), grid_));
    }
    requireGas(properties_, names);
    forAll(names, phasei)
    {
        phases_.set(
            phasei,
            new materialPointPhase(
                grid_, names[phasei], requiredDict(properties_, names[phasei]),
                // Contact needs the points' boxes whatever the shape function
                gridTransfer_->hasExtent() || properties_.found("contact"),
                transfer_->affine() != transferScheme::none));
        if (gridTransfer_->remembers())
        {
            phases_[phasei].cloud().needHint();
        }
    }
}

void Foam::mpm::materialPointSystem::readFields()
{
    wordList fieldNames;
    forAll(phases_, phasei)
    {
        const word& field = phases_[phasei].velocityField();
        fieldOf_[phasei] = fieldNames.find(field);
        if (fieldOf_[phasei] < 0)
        {
            fieldOf_[phasei] = fieldNames.size();
            fieldNames.append(field);
        }
    }
    fields_.setSize(fieldNames.size());
    projectedShare_.setSize(fieldNames.size(), scalar(1));
    forAll(fieldNames, fieldi)
    {
        const fileName file(mesh_.time().timePath() / IOobject::groupName("U", fieldNames[fieldi]));
        fields_.set(
            fieldi,
            readNamed(
                file,
                [&]
                {
                    return new mpm::velocityField(
                        grid_, fieldNames[fieldi], gridTransfer_->reach(),
                        from_ ? &from_->pointFields : nullptr);
                }));
        fields_[fieldi].rigid().setPhases(phases_.size());
        forAll(phases_, phasei)
        {
            rigidMotion* motion = phases_[phasei].motion();
            if (motion && motion->free() && fieldOf_[phasei] == fieldi)
            {
                fields_[fieldi].rigid().addBody(phasei, *motion->free());
            }
        }
    }
}

void Foam::mpm::materialPointSystem::readPoints(materialPointPhase& phase, const bool isDebris)
{
    phase.read(
        isDebris, phase.erosion() || (outflow_ && !phase.motion()),
        from_ ? &from_->points[phase.name()] : nullptr);
    if (from_)
    {
        from_->points.erase(phase.name());
    }
    Info << "Phase " << phase.name() << ": " << returnReduce(phase.cloud().size(), sumOp<label>())
         << " points of ";
    if (phase.motion())
    {
        Info << "a rigid body, motion " << phase.motion()->type();
        phase.motion()->start(mesh_.time().value(), phase.cloud());
        phase.motion()->setVelocity(phase.cloud());
    }
    else
    {
        Info << phase.law().type() << ", wave speed " << phase.law().waveSpeed() << " m/s";
    }
    if (const freeBody* b = phase.motion() ? phase.motion()->free() : nullptr)
    {
        Info << ", mass " << b->mass() << " kg";
    }
    Info << ", velocity field " << phase.velocityField();
    if (phase.failure())
    {
        Info << ", failure " << phase.failure()->type();
    }
    if (phase.erosion())
    {
        Info << ", erosion " << phase.erosion()->type();
    }
    Info << nl;
    checkHalfSizes(phase);
    rate_ = max(rate_, speedRate(phase));
}

void Foam::mpm::materialPointSystem::checkHalfSizes(const materialPointPhase& phase) const
{
    if (!gridTransfer_->hasExtent())
    {
        return;
    }
    const materialPointCloud& cloud = phase.cloud();
    forAll(cloud.cells(), k)
    {
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                const scalar l = (*cloud.halfSize())[d][p];
                if (l > 1.0001 * grid_.width(cloud.cells()[k], d))
                {
                    FatalErrorInFunction
                        << "Material point " << cloud.id()[0][p] << " of " << phase.name() << " at "
                        << cloud.position(p, cloud.cells()[k]) << ", time "
                        << mesh_.time().timeName() << ", has half-size " << l
                        << ", larger than its cell." << nl << "Use more points per cell in"
                        << " setMaterialPointsDict or the shape"
                        << " function linear." << exit(FatalError);
                }
            }
        }
    }
}

Foam::scalar Foam::mpm::materialPointSystem::speedRate(const materialPointPhase& phase) const
{
    scalar rate = 0;
    const materialPointCloud& cloud = phase.cloud();
    forAll(cloud.cells(), k)
    {
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const scalar ih = 1 / grid_.width(cloud.cells()[k], d);
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                rate = max(rate, mag(cloud.U()[d][p]) * ih);
            }
        }
    }
    return rate;
}

void Foam::mpm::materialPointSystem::makeParts()
{
    parts_.own(new pointLoads(*this));
    parts_.own(new phaseDamping(*this));
    if (properties_.found("contact"))
    {
        parts_.own(new pointContact(*this));
    }
    parts_.select(
        properties_.found("stepParts") ? &requiredDict(properties_, "stepParts") : nullptr, *this);
}

void Foam::mpm::materialPointSystem::findWalls()
{
    if (!grid_.locator().knowsWayOut())
    {
        return;
    }
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    boolList holds(patches.size(), false);
    for (const polyPatch& patch : patches)
    {
        bool all = true;
        for (const velocityField& field : fields_)
        {
            bool held = field.holds(patch.index());
            for (const entry& e : properties_.subOrEmptyDict("contact"))
            {
                held = held
                    || (e.isDict() && e.dict().found("patch")
                        && e.dict().get<word>("patch") == patch.name()
                        && e.dict().get<wordList>("fields").found(field.name()));
            }
            all = all && held;
        }
        holds[patch.index()] = all;
    }
    if (returnReduce(holds.found(true), orOp<bool>()))
    {
        walls_.reset(new wallPatches(grid_, holds));
    }
}

void Foam::mpm::materialPointSystem::startNodes()
{
    for (materialPointPhase& phase : phases_)
    {
        if (phase.motion())
        {
            phase.motion()->setVelocity(phase.cloud());
        }
    }
    for (velocityField& field : fields_)
    {
        field.rigid().newTime();
    }
    projectAnew(0);
}

void Foam::mpm::materialPointSystem::startAffine()
{
    // Fixed point of C = grad u(v, C): rigid rotation to rounding
    const noTraps guard;
    for (label i = 0; i < 200; ++i)
    {
        scalar size = 0, change = 0;
        forAll(phases_, phasei)
        {
            materialPointCloud& cloud = phases_[phasei].cloud();
            const velocityField& field = fields_[fieldOf_[phasei]];
            if (phases_[phasei].motion())
            {
                continue;
            }
            gridTransfer_->affine(cloud, false, field.U(), 0);
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
        projectAll(pointGridTransfer::current);
        for (velocityField& field : fields_)
        {
            field.accept();
        }
        reduce(size, maxOp<scalar>());
        reduce(change, maxOp<scalar>());
        if (debug)
        {
            Info << "startAffine " << i << ": " << change << " of " << size << nl;
        }
        if (change <= 1e-14 * size)
        {
            break;
        }
    }
}

void Foam::mpm::materialPointSystem::makeOffsets()
{
    if (!dynamic_cast<const twoLevelShares*>(&*gridTransfer_) || grid_.nDim() == 1)
    {
        FatalIOErrorInFunction(numerics_)
            << "turnSides is for shapeFunction nodeDual in 2D and 3D, here it is "
            << numerics_.get<word>("shapeFunction") << " in " << grid_.nDim() << "D" << nl
            << "Leave the entry out" << exit(FatalIOError);
    }
    for (velocityField& field : fields_)
    {
        offsets_.append(new massOffsets(field, *gridTransfer_, grid_.nNodes()));
    }
    forAll(phases_, phasei)
    {
        if (!phases_[phasei].motion())
        {
            offsets_[fieldOf_[phasei]].append(phases_[phasei].cloud(), phases_[phasei].law().rho());
        }
    }
}

void Foam::mpm::materialPointSystem::reportBalance() const
{
    if (!Pstream::parRun())
    {
        return;
    }
    label n = 0;
    for (const materialPointPhase& phase : phases_)
    {
        n += phase.cloud().size();
    }
    labelList points(Pstream::nProcs());
    points[Pstream::myProcNo()] = n;
    Pstream::gatherList(points);
    if (!Pstream::master())
    {
        return;
    }
    label least = 0, most = 0;
    scalar sum = 0;
    forAll(points, proci)
    {
        least = points[proci] < points[least] ? proci : least;
        most = points[proci] > points[most] ? proci : most;
        sum += points[proci];
    }
    const scalar mean = sum / points.size();
    Info << "    points per processor: mean " << mean << ", least " << points[least] << " ("
         << least << "), most " << points[most] << " (" << most << "), imbalance "
         << 100 * (points[most] / mean - 1) << " %" << nl;
    if (points[most] > 1.3 * mean)
    {
        Info << "    the fullest processor sets the pace: cellWeights of"
             << " setMaterialPoints -cellWeights, named weightField in"
             << " system/decomposeParDict, share the points evenly" << nl;
    }
}

Foam::label Foam::mpm::materialPointSystem::nNodesOfAll() const
{
    label n = grid_.nNodes();
    if (Pstream::parRun())
    {
        // Of those that processors share the first one counts
        const sharedNodes& shared = grid_.shared(1);
        bitSet elsewhere(n);
        for (label i = 0; i < shared.procs().size(); ++i)
        {
            if (shared.procs()[i] < Pstream::myProcNo())
            {
                elsewhere.setMany(shared.with(i).begin(), shared.with(i).end());
            }
        }
        n -= elsewhere.count();
    }
    return returnReduce(n, sumOp<label>());
}

void Foam::mpm::materialPointSystem::reportStart() const
{
    const label nNodes = nNodesOfAll();
    Info << "Material points: " << nPoints() << " in " << phases_.size()
         << (phases_.size() == 1 ? " phase, " : " phases, ")
         << (grid_.radial() >= 0 ? "axisymmetric " : "") << grid_.nDim() << "D, " << nNodes
         << " nodes, " << (grid_.hasLattice() ? "lattice" : cellTypes(mesh_)).c_str() << nl
         << "    shape function " << numerics_.get<word>("shapeFunction")
         << (gridTransfer_->cellMeans ? ", dilatation cellMean" : "") << ", stress update "
         << stressUpdate_->type() << nl << "    ";
    bool grains = false;
    for (const materialPointPhase& phase : phases_)
    {
        grains = grains || (!phase.motion() && phase.grains());
    }
    transfer_->write(Info, grains);
    reportBalance();
    Info << "    " << bytesPerPoint() << " bytes per point in columns and"
         << " buffers, " << gridBytes() / max(nPoints(), label(1)) << " on the nodes" << nl << endl;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::materialPointSystem::materialPointSystem(const fvMesh& mesh, rows* from) :
    regIOobject(IOobject(
        "materialPointSystem", mesh.time().timeName(), mesh, IOobject::NO_READ,
        IOobject::NO_WRITE)),
    mesh_(mesh),
    grid_(pointGrid::New(mesh)),
    from_(from),
    properties_(
        IOobject(
            "phaseProperties", mesh.time().constant(), mesh,
            from ? IOobject::NO_READ : IOobject::MUST_READ, IOobject::NO_WRITE),
        from ? from->properties : dictionary::null),
    g_(Zero),
    coupling_(nullptr),
    rate_(0),
    waveRate_(0),
    nRedone_(0),
    dt_(0),
    tentative_(false),
    sharesHold_(false)
{
    readGravity();
    requireClosed(properties_.objectPath());
    requireClosed(mesh.solutionDict().name());
    readNumerics();
    gridTransfer_ = pointGridTransfer::New(numerics_, grid_);
    readPhases();
    if (!from_)
    {
        phases_[0].cloud().checkMesh();
    }
    readFields();

    energy_ = &parts_.own(new pointEnergy(*this));
    erosion_ = &parts_.own(new pointErosion(*this));
    rigid_ = &parts_.own(new rigidBodies(*this));

    // Before the points are read: parts may ask for columns
    makeParts();
    findWalls();
    forAll(phases_, phasei)
    {
        readPoints(phases_[phasei], erosion_->isDebris(phasei));
    }
    rate_ = largestOfAll(rate_);
    updateWaveRate();
    erosion_->countStarted();

    startNodes();
    parts_.within(&stepPart::started);
    // A processor without points of a phase has no files of it
    bool haveAffine = true;
    for (const materialPointPhase& phase : phases_)
    {
        const bool none = !returnReduce(phase.cloud().size(), sumOp<label>());
        const bool read = returnReduce(phase.cloud().affineRead(), orOp<bool>());
        haveAffine = haveAffine && (phase.motion() || none || read);
    }
    if (transfer_->affine() != transferScheme::none && !haveAffine)
    {
        startAffine();
    }
    for (mpm::velocityField& field : fields_)
    {
        field.writeField();
    }
    if (numerics_.getOrDefault<bool>("energyBudget", false))
    {
        energy_->startBudget();
    }
    parts_.own(new phaseWatches(*this));
    reportStart();
    for (const materialPointPhase& phase : phases_)
    {
        if (!from_)
        {
            warnOfUnits(phase, requiredDict(properties_, phase.name()));
            warnOfDensity(phase);
        }
    }
    if (!from_)
    {
        warnOfNormals(properties_, grid_, phases_);
    }
    from_ = nullptr;
}
