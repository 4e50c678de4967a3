// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointSystem.H"
#include "noTraps.H"
#include "dictionaryTools.H"
#include "Time.H"
#include <iomanip>
#include <sstream>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Largest speed over width, and a description of its point
struct fastest
{
    scalar rate = 0;
    string words;

    //- Take the words of the processor with the largest rate; 0: none.
    //  Collective
    void combine()
    {
        const scalar most = returnReduce(rate, maxOp<scalar>());
        label teller = most > 0 && rate == most ? Pstream::myProcNo() : labelMax;
        reduce(teller, minOp<label>());
        List<string> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = words;
        Pstream::gatherList(all);
        Pstream::scatterList(all);
        rate = most;
        words = teller < all.size() ? all[teller] : string();
    }
};

string inWords(const string& who, const char* what, const scalar speed, const scalar width)
{
    OStringStream os;
    os.precision(4);
    os << who.c_str() << ": " << what << ' ' << speed << " m/s in "
       << (width < 1 ? 1e3 * width : width) << (width < 1 ? " mm" : " m");
    return os.str();
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::makeMeans(const label phasei)
{
    const auto make = [&](auto& fields, const word& name, const auto& zero)
    {
        typedef typename std::decay_t<decltype(fields)>::value_type fieldType;
        fields.set(
            phasei,
            new fieldType(
                IOobject(
                    IOobject::groupName(name, phases_[phasei].name()), mesh_.time().timeName(),
                    mesh_, IOobject::NO_READ, IOobject::AUTO_WRITE),
                mesh_, zero));
    };
    make(alpha_, "alpha", dimensionedScalar(dimless, Zero));
    make(Umean_, "Umean", dimensionedVector(dimVelocity, Zero));
    make(sigmaMean_, "sigma", dimensionedSymmTensor(dimPressure, Zero));
    if (phases_[phasei].cloud().temperature())
    {
        make(Tmean_, "Tmean", dimensionedScalar(dimTemperature, Zero));
    }
}

void Foam::mpm::materialPointSystem::updateMeans(const label phasei)
{
    const materialPointCloud& cloud = phases_[phasei].cloud();
    alpha_[phasei] = dimensionedScalar(dimless, Zero);
    Umean_[phasei] = dimensionedVector(dimVelocity, Zero);
    sigmaMean_[phasei] = dimensionedSymmTensor(dimPressure, Zero);
    const column* T = cloud.temperature();
    if (T)
    {
        Tmean_[phasei] = dimensionedScalar(dimTemperature, Zero);
    }

    forAll(cloud.cells(), k)
    {
        const label celli = cloud.cells()[k];
        scalar v = 0, m = 0, mT = 0;
        vector mU(Zero);
        symmTensor vSigma(Zero);
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            const scalar vp = cloud.volume()[0][p];
            const scalar mp = cloud.mass()[0][p];
            v += vp;
            m += mp;
            mU += mp * cloud.velocity(p);
            vSigma += vp * cloud.sigma(p);
            mT += T ? mp * (*T)[0][p] : 0;
        }
        alpha_[phasei][celli] = v / mesh_.V()[celli];
        Umean_[phasei][celli] = mU / m;
        sigmaMean_[phasei][celli] = vSigma / v;
        if (T)
        {
            Tmean_[phasei][celli] = mT / m;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::mpm::materialPointSystem::limiter() const
{
    const noTraps guard;
    fastest sound, speed;
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = const_cast<materialPointPhase&>(phases_[phasei]);
        const materialPointCloud& cloud = phase.cloud();
        const auto name = [&](const label p)
        { return "point " + Foam::name(label(cloud.id()[0][p])) + " of " + phase.name(); };

        // Speeds
        forAll(cloud.cells(), k)
        {
            const scalar h = gridTransfer_->cellWidth(grid_, cloud.cells()[k]);
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                const scalar u = phase.largestSpeed(p);
                if (u > speed.rate * h)
                {
                    speed.rate = u / h;
                    speed.words = inWords(name(p), "speed", u, h);
                }
            }
        }

        if (phase.motion() || !cloud.size())
        {
            continue;
        }
        const scalar h = gridTransfer_->shortestWidth(cloud, phase.shortestSide());
        const scalar c = phase.waveSpeed();
        if (c > sound.rate * h)
        {
            sound.rate = c / h;
            const label p = phase.fastestPoint();
            sound.words =
                inWords(p < 0 ? "points of " + phase.name() : string(name(p)), "sound", c, h);
        }
    }
    sound.combine();
    speed.combine();

    const fastest& most = sound.rate >= speed.rate ? sound : speed;
    const fastest& other = sound.rate >= speed.rate ? speed : sound;
    string words(most.rate > 0 ? most.words : string("nothing: no point has a speed"));
    if (most.rate > 0 && other.rate > 0.1 * most.rate)
    {
        words += "; " + other.words;
    }
    for (const stepPart* part : parts_.all())
    {
        if (part->courantRate() > most.rate)
        {
            OStringStream os;
            os.precision(4);
            os << part->waves() << " through " << part->courantRate() << " cells a second; then "
               << words.c_str();
            words = os.str();
        }
    }
    return words;
}

void Foam::mpm::materialPointSystem::report() const
{
    parts_.within(&stepPart::report);
    if (walls_)
    {
        scalar deepest = 0;
        const label n = walls_->count(deepest);
        if (n)
        {
            Info << "Put back on walls since the last report: " << n << " points, up to " << deepest
                 << " of a cell beyond" << endl;
        }
    }
}

void Foam::mpm::materialPointSystem::reportSteps() const
{
    label nFailed = 0;
    for (const materialPointPhase& phase : phases_)
    {
        nFailed += returnReduce(phase.nFailed(), sumOp<label>());
    }
    Info << "Failed points: " << nFailed << ", steps redone: " << nRedone_ << endl;
}

void Foam::mpm::materialPointSystem::reportClock() const
{
    std::vector<std::pair<word, scalar>> parts(
        {{"nodes", clock_.nodes},
         {"move", clock_.move},
         {"sort", clock_.sort},
         {"project", clock_.project},
         {"stress and force", clock_.stress},
         {"gas", clock_.gas}});
    for (const stepPart* part : parts_.all())
    {
        parts.emplace_back(part->name(), part->seconds());
    }
    scalar sum = 0;
    for (const auto& part : parts)
    {
        sum += part.second;
    }
    std::ostringstream line;
    line << std::fixed << std::setprecision(2) << "Parts of the steps' " << sum
         << " s of wall time:" << std::setprecision(1);
    const char* separator = " ";
    for (const auto& part : parts)
    {
        if (part.second > 0.0005 * sum)
        {
            line << separator << part.first << ' ' << 100 * part.second / sum << " %";
            separator = ", ";
        }
    }
    Info << line.str().c_str() << nl << endl;
}

void Foam::mpm::materialPointSystem::writePoints()
{
    parts_.within(&stepPart::write);
    for (mpm::velocityField& field : fields_)
    {
        field.writeField();
    }

    if (alpha_.empty())
    {
        alpha_.setSize(phases_.size());
        Umean_.setSize(phases_.size());
        sigmaMean_.setSize(phases_.size());
        Tmean_.setSize(phases_.size());
        forAll(phases_, phasei)
        {
            makeMeans(phasei);
        }
    }
    forAll(phases_, phasei)
    {
        phases_[phasei].cloud().writePoints();
        updateMeans(phasei);
    }
}

Foam::dictionary Foam::mpm::materialPointSystem::state() const
{
    dictionary state;
    state.add("rate", rate_);
    state.add("waveRate", waveRate_);
    state.add("stepsRedone", nRedone_);
    dictionary failed;
    for (const materialPointPhase& phase : phases_)
    {
        failed.add(phase.name(), returnReduce(phase.nFailed(), sumOp<label>()));
    }
    state.add("failed", failed);
    parts_.within(&stepPart::addState, state);
    return state;
}

void Foam::mpm::materialPointSystem::setState(const dictionary& state)
{
    wordList keys({"rate", "waveRate", "stepsRedone", "failed"});
    keys.append(parts_.stateKeys());
    for (const word& key : state.toc())
    {
        if (!keys.found(key))
        {
            FatalIOErrorInFunction(state)
                << "Entry " << key << " of " << state.name() << " is the state of something that"
                << " the case no longer has." << nl
                << "Give it back in constant/phaseProperties or system/fvSolution, or remove the"
                << " entry from this file: the run goes on without it." << nl << nl
                << "Valid keywords are: " << flatOutput(keys) << exit(FatalIOError);
        }
    }

    // The laws may have changed since
    rate_ = bounded(state, "rate", 0, waveRate_ > 0 ? 1e3 * (rate_ + waveRate_) : GREAT);
    const scalar waveRate = bounded(state, "waveRate", 0, GREAT);
    scalar least = 1, most = 2;
    for (const materialPointPhase& phase : phases_)
    {
        if (!phase.motion() && phase.law().waveSpeedVaries())
        {
            least = 1e-3;
            most = 1e3;
        }
    }
    if (waveRate >= least * waveRate_ && waveRate <= most * waveRate_)
    {
        waveRate_ = waveRate;
    }
    requireKeyword(state, "stepsRedone");
    nRedone_ = boundedLabelOrDefault(state, "stepsRedone", 0, 0, labelMax);

    const dictionary& failed = requiredDict(state, "failed");
    DynamicList<word> names;
    for (materialPointPhase& phase : phases_)
    {
        names.append(phase.name());
        requireKeyword(failed, phase.name());
        const label n = boundedLabelOrDefault(failed, phase.name(), 0, 0, labelMax);
        phase.nFailed() = Pstream::master() ? n : 0;
    }
    checkKeywords(failed, wordList(names));

    parts_.within(&stepPart::setState, state);
    if (parts_.timeDependent())
    {
        startNodes();
    }
}

Foam::mpm::materialPointSystem::rows Foam::mpm::materialPointSystem::takeDown()
{
    rows r;
    for (materialPointPhase& phase : phases_)
    {
        r.points.set(phase.name(), phase.cloud().rows());
    }
    for (const mpm::velocityField& field : fields_)
    {
        r.pointFields.set(field.field().name(), fieldDictionary(field.field()));
        if (field.reactions())
        {
            r.reactions.append(field.name());
        }
    }
    parts_.within(&stepPart::addFields, r.cellFields);
    r.numerics = numerics_;
    r.numericsRead = numericsRead_;
    r.clock = clock_;
    for (const stepPart* part : parts_.all())
    {
        r.seconds.set(part->name(), part->seconds());
    }
    return r;
}

void Foam::mpm::materialPointSystem::resume(const rows& from)
{
    for (mpm::velocityField& field : fields_)
    {
        if (from.reactions.found(field.name()))
        {
            field.needReactions();
        }
    }
    clock_ = from.clock;
    for (stepPart* part : parts_.all())
    {
        part->seconds() += from.seconds.lookup(part->name(), 0);
    }
}
