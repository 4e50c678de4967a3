// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointPhase.H"
#include "dictionaryTools.H"
#include "phaseNames.H"
#include "noTraps.H"
#include "OSspecific.H"
#include "Time.H"
#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::materialPointPhase::materialPointPhase(
    const pointGrid& grid, const word& name, const dictionary& dict, const bool needHalfSize,
    const bool needAffine) :
    name_(name),
    velocityField_(dict.getOrDefault<word>("velocityField", name)),
    failedTime_(-1),
    rho_(0),
    largestMass_(0),
    referencePressure_(0),
    grains_(false),
    Cv_(0),
    cloud_(grid, name),
    waveSpeed_(0),
    fastestBlock_(-1),
    nFailed_(0),
    nFailedKept_(0)
{
    readMaterial(dict);
    readLoads(dict);
    if (dict.found("heatTransfer"))
    {
        Cv_ = positive(dict, "Cv");
        cloud_.needTemperature();
    }
    else if (dict.found("Cv"))
    {
        FatalIOErrorInFunction(dict) << "Entry Cv only goes with heatTransfer; phase " << name
                                     << " has none." << exit(FatalIOError);
    }

    if (needHalfSize)
    {
        cloud_.needHalfSize();
    }
    if (needAffine)
    {
        cloud_.needAffine();
    }
    if (failure_)
    {
        cloud_.needDamage();
        if (failure_->scatters())
        {
            cloud_.needStrength();
        }
    }
    needHistory(dict);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointPhase::readMaterial(const dictionary& dict)
{
    const word type(oneOfOrDefault(dict, "type", "materialPoints", {"materialPoints", "rigid"}));
    if (type == "rigid")
    {
        checkKeywords(
            dict, {"type", "rho", "motion", "velocityField", "drag", "heatTransfer", "Cv"});
        rho_ = positive(dict, "rho");
        motion_ = rigidMotion::New(dict, cloud_.grid());
        cloud_.needReference();
    }
    else
    {
        checkKeywords(
            dict,
            {"type", "constitutiveModel", "failureModel", "bodyForce", "surfaceLoads", "damping",
             "erosion", "velocityField", "volumeModel", "referencePressure", "drag",
             "granularPressure", "heatTransfer", "Cv"});
        law_ = constitutiveModel::New(requiredDict(dict, "constitutiveModel"));
        readVolumeModel(dict);
        waveSpeed_ = law_->waveSpeed();
    }
    if (dict.found("failureModel"))
    {
        failure_ = failureModel::New(requiredDict(dict, "failureModel"));
    }
    if (law_)
    {
        readReferencePressure(dict);
    }
}

void Foam::mpm::materialPointPhase::readReferencePressure(const dictionary& dict)
{
    referencePressure_ = boundedOrDefault(dict, "referencePressure", 0, 0, GREAT);
    if (referencePressure_ <= 0)
    {
        return;
    }
    if (grains_ || !law_->hasStress() || law_->startPressure() != 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry referencePressure of phase " << name_ << ": "
            << (grains_ || !law_->hasStress()
                    ? "the stress of grains is that on each other, without the pressure around"
                      " them"
                    : "its law has a pressure of its own where it is unstrained")
            << "; leave it out." << exit(FatalIOError);
    }
    if (failure_ && failure_->ambient() > 0)
    {
        FatalIOErrorInFunction(dict)
            << "Phase " << name_ << " has a referencePressure and its failureModel an"
            << " ambientPressure. Failure sees the stress above referencePressure, and the"
            << " gas enters the cracks: leave ambientPressure out." << exit(FatalIOError);
    }
}

Foam::mpm::pointBlock
Foam::mpm::materialPointPhase::lawBlock(const pointBlock& b, scalarList& room) const
{
    pointBlock law(b);
    if (referencePressure_ > 0)
    {
        room.setSize(3 * b.n);
        for (int i = 0; i < 3; ++i)
        {
            law.stress[i] = room.begin() + i * b.n;
            std::transform(
                b.stress[i], b.stress[i] + b.n, law.stress[i],
                [&](const scalar s) { return s + referencePressure_; });
        }
    }
    return law;
}

void Foam::mpm::materialPointPhase::readLoads(const dictionary& dict)
{
    if (dict.found("bodyForce"))
    {
        bodyForce_ = bodyForce::New(requiredDict(dict, "bodyForce"));
        acceleration_.reset(new column("bodyForce", column::vectors, cloud_.grid().nDim()));
        if (bodyForce_->needsReference())
        {
            cloud_.needReference();
        }
    }

    if (dict.found("surfaceLoads"))
    {
        const dictionary& loads = requiredDict(dict, "surfaceLoads");
        for (const word& load : loads.toc())
        {
            surfaceLoads_.append(new surfaceLoad(requiredDict(loads, load), cloud_.grid()));
        }
    }
    if (dict.found("damping"))
    {
        damping_.reset(new pointDamping(requiredDict(dict, "damping")));
    }
}

void Foam::mpm::materialPointPhase::readErosion(
    const dictionary& dict, List<historyColumn>& history)
{
    if (!dict.found("erosion"))
    {
        return;
    }
    dictionary criterion(requiredDict(dict, "erosion"));
    if (criterion.found("to"))
    {
        debris_ = criterion.get<word>("to");
        criterion.remove("to");
    }
    erosion_ =
        erosionCriterion::New(criterion, erodible{*law_, cloud_.grid().nDim(), bool(failure_)});
    if (erosion_->needsFailedTime())
    {
        failedTime_ = 0;
        for (const historyColumn& h : history)
        {
            failedTime_ += h.nComponents(cloud_.grid().nDim());
        }
        history.append(historyColumn{"failedTime", historyColumn::scalars});
    }
}

void Foam::mpm::materialPointPhase::needHistory(const dictionary& dict)
{
    List<historyColumn> history;
    if (law_)
    {
        history = law_->history();
    }
    if (law_ && failure_)
    {
        failure_->connect(*law_, cloud_.grid().nDim());
        history.append(failure_->history());
    }
    readErosion(dict, history);

    int nHistory = 0;
    for (const historyColumn& h : history)
    {
        nHistory += h.nComponents(cloud_.grid().nDim());
    }
    if (nHistory > pointBlock::maxHistory)
    {
        FatalIOErrorInFunction(dict)
            << "Law and failure model of phase " << name_ << " have " << nHistory
            << " history components; at most " << pointBlock::maxHistory << " are possible."
            << exit(FatalIOError);
    }
    for (const historyColumn& h : history)
    {
        cloud_.needHistory(
            h.name,
            h.kind == historyColumn::scalars         ? column::scalars
                : h.kind == historyColumn::symmetric ? column::strains
                : h.kind == historyColumn::stresses  ? column::stresses
                                                     : column::tensors);
    }
}

void Foam::mpm::materialPointPhase::readVolumeModel(const dictionary& dict)
{
    grains_ = oneOfOrDefault(dict, "volumeModel", "ownStress", {"ownStress", "grains"}) == "grains";

    if (!law_->hasStress() && !grains_)
    {
        FatalIOErrorInFunction(dict)
            << "The law " << law_->type() << " of " << name_ << " needs"
            << "  volumeModel grains;  without a stress a point cannot resist"
            << " the pressure around it." << exit(FatalIOError);
    }
    if (!law_->hasStress() && dict.found("failureModel"))
    {
        FatalIOErrorInFunction(dict)
            << "Phase " << name_ << " has a failureModel, but points of the"
            << " law " << law_->type() << " have no stress and cannot fail." << exit(FatalIOError);
    }
    if (!grains_ && dict.found("granularPressure"))
    {
        FatalIOErrorInFunction(dict) << "Entry granularPressure of " << name_ << " only goes with"
                                     << "  volumeModel grains;" << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::materialPointPhase::names(const dictionary& dict)
{
    return phaseNames(dict, {"materialPoints", "rigid"});
}

void Foam::mpm::materialPointPhase::read(
    const bool mayBeEmpty, const bool losesPoints, const pointRows* rows)
{
    const label n = rows ? cloud_.setRows(*rows) : cloud_.readPoints();

    // A phase may have lost all its points to erosion or outflow
    const bool gone = losesPoints
        && isFile(cloud_.time().path() / cloud_.time().timeName() / "uniform"
                  / "materialPointState");
    if (n <= 0 && !rows && !gone && !mayBeEmpty)
    {
        const Time& time = cloud_.time();
        if (Pstream::parRun() && isDir(time.globalPath() / time.timeName() / cloud::prefix / name_))
        {
            FatalErrorInFunction << "Phase " << name_ << " has no material points in "
                                 << time.path() / time.timeName() / cloud::prefix / name_
                                 << ", but the case that was decomposed has them: they were"
                                 << " made after it." << nl << "Run  decomposePar -force"
                                 << exit(FatalError);
        }
        FatalErrorInFunction
            << "Phase " << name_ << " has no material points in "
            << cloud_.time().path() / cloud_.time().timeName() / cloud::prefix / name_ << "." << nl
            << "Run setMaterialPoints first (it reads system/setMaterialPointsDict)"
            << (Pstream::parRun() ? " and  decomposePar -force  after it" : "")
            << ", or remove the phase from constant/phaseProperties." << exit(FatalError);
    }

    if (column* s = cloud_.strength())
    {
        for (label p = 0; p < cloud_.size(); ++p)
        {
            (*s)[0][p] =
                failure_->strength(uint64_t(cloud_.id()[0][p]), cloud_.mass()[0][p] / rho());
        }
    }

    if (motion_)
    {
        for (label p = 0; p < cloud_.size(); ++p)
        {
            largestMass_ = max(largestMass_, cloud_.mass()[0][p]);
        }
        reduce(largestMass_, maxOp<scalar>());
        return;
    }

    // Points that start without the law's history, perhaps with a stress
    bool history = false;
    scalarList room;
    pointBlock b(lawBlock(block(), room));
    int h = 0;
    for (const column& c : cloud_.history())
    {
        for (int i = 0; i < c.nComponents(); ++i, ++h)
        {
            for (label p = 0; p < cloud_.size(); ++p)
            {
                history = history || b.history[h][p] != 0;
            }
        }
    }
    reduce(history, orOp<bool>());
    if (!history && (cloud_.history().size() || !law_->hasStress()))
    {
        law_->start(b);
        if (stressed(b))
        {
            law_->initialise(b);
        }
    }
}

bool Foam::mpm::materialPointPhase::stressed(const pointBlock& b)
{
    bool found = false;
    for (int i = 0; i < nStress(b.nDim); ++i)
    {
        for (label p = 0; p < b.n; ++p)
        {
            found = found || b.stress[i][p] != 0;
        }
    }
    return returnReduce(found, orOp<bool>());
}

void Foam::mpm::materialPointPhase::startHistory()
{
    scalarList room;
    pointBlock b(lawBlock(block(), room));
    if (law_ && !stressed(b))
    {
        law_->start(b);
    }
}

const Foam::mpm::column& Foam::mpm::materialPointPhase::acceleration(const scalar time)
{
    acceleration_->reserve(cloud_.capacity(), 0);

    bodyForceBlock b;
    b.nDim = cloud_.grid().nDim();
    b.n = cloud_.size();
    b.time = time;
    for (int d = 0; d < b.nDim; ++d)
    {
        b.axis[d] = cloud_.grid().direction(d);
        b.x[d] = cloud_.x()[d];
        b.X[d] = cloud_.reference() ? (*cloud_.reference())[d] : nullptr;
        b.b[d] = (*acceleration_)[d];
    }
    bodyForce_->correct(b);

    return *acceleration_;
}

void Foam::mpm::materialPointPhase::keepStress()
{
    cloud_.keepStress();
    nFailedKept_ = nFailed_;
}

void Foam::mpm::materialPointPhase::restoreStress()
{
    cloud_.restoreStress();
    nFailed_ = nFailedKept_;
}

Foam::scalar Foam::mpm::materialPointPhase::storedEnergy(const pointBlock& b) const
{
    scalarList room;
    const pointBlock law(lawBlock(b, room));
    scalar sum = failure_ ? failure_->storedEnergy(law) : law_->strainEnergy(law);
    for (label p = 0; referencePressure_ > 0 && p < b.n; ++p)
    {
        sum -= referencePressure_ * (b.volume[p] - b.mass[p] / rho());
    }
    return sum;
}

void Foam::mpm::materialPointPhase::scaleVelocity(const scalar factor)
{
    const auto scale = [&](column& c)
    {
        for (int i = 0; i < c.nComponents(); ++i)
        {
            for (label p = 0; p < cloud_.size(); ++p)
            {
                c[i][p] *= factor;
            }
        }
    };
    scale(cloud_.U());
    if (cloud_.affine())
    {
        scale(*cloud_.affine());
    }
}

Foam::scalar Foam::mpm::materialPointPhase::kineticEnergy() const
{
    if (motion_ && motion_->free())
    {
        return motion_->free()->kineticEnergy();
    }
    scalar sum = 0;
    for (label p = 0; p < cloud_.size(); ++p)
    {
        scalar U2 = 0;
        for (int d = 0; d < cloud_.grid().nDim(); ++d)
        {
            U2 += sqr(cloud_.U()[d][p]);
        }
        sum += 0.5 * cloud_.mass()[0][p] * U2;
    }
    return returnReduce(sum, sumOp<scalar>());
}

Foam::scalar Foam::mpm::materialPointPhase::strainEnergy() const
{
    if (!law_)
    {
        return 0;
    }
    const noTraps guard;
    const pointBlock b(const_cast<materialPointPhase&>(*this).block());
    return returnReduce(storedEnergy(b), sumOp<scalar>());
}

Foam::scalar Foam::mpm::materialPointPhase::mass() const
{
    if (motion_ && motion_->free())
    {
        return motion_->free()->mass();
    }
    scalar sum = 0;
    for (label p = 0; p < cloud_.size(); ++p)
    {
        sum += cloud_.mass()[0][p];
    }
    return returnReduce(sum, sumOp<scalar>());
}

Foam::vector Foam::mpm::materialPointPhase::momentum() const
{
    if (motion_ && motion_->free())
    {
        return motion_->free()->momentum();
    }
    vector sum(Zero);
    for (label p = 0; p < cloud_.size(); ++p)
    {
        sum += cloud_.mass()[0][p] * cloud_.velocity(p);
    }
    return returnReduce(sum, sumOp<vector>());
}
