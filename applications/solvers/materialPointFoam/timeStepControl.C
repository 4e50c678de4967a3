// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "timeStepControl.H"
#include "pointErosion.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "fullPrecision.H"
#include "version.H"
#include "cloud.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

fileName stateFile(const fileName& path, const word& instance)
{
    return path / instance / "uniform" / "materialPointState";
}

//- Has a run only begun to write this time (or not at all): neither a field
//  nor a mesh?
bool isHollow(const fileName& folder)
{
    for (const fileName& name : readDir(folder, fileName::DIRECTORY))
    {
        if (name != "uniform" && name != cloud::prefix)
        {
            return false;
        }
    }
    return readDir(folder, fileName::FILE).empty();
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::timeStepControl::timeStepControl(Time& time, mpm::simulation& simulation) :
    time_(time), simulation_(simulation), origin_(time.value()), startTime_(time.value())
{
    passed_.append(Tuple2<scalar, clock::time_point>(time.value(), clock::now()));

    const fileName file(stateFile(time.path(), time.timeName()));
    if (isFile(file))
    {
        IFstream is(file);
        const dictionary state(is);
        checkKeywords(
            state, {"value", "origin", "growFrom", "points", "gas", "complete", "newPoints"});
        requireClosed(file);
        if (!state.found("complete") || !required<bool>(state, "complete"))
        {
            FatalIOErrorInFunction(state)
                << "File " << file << " was cut off, or written by an older"
                << " version: its last entry, complete, is missing." << nl
                << "Start from an earlier time (remove or rename " << time.timeName() << ")."
                << exit(FatalIOError);
        }

        // The folder's name has fewer digits
        const scalar value = bounded(
            state, "value", time.value() - 0.01 * mag(time.value()),
            time.value() + 0.01 * mag(time.value()));
        time.setTime(value, time.timeIndex());
        origin_ = bounded(state, "origin", -GREAT, value);
        growFrom_ = positive(state, "growFrom");
        // Not of points that setMaterialPoints has put there since
        simulation.setState(state, !state.found("newPoints"));
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::timeStepControl::setAsideIncomplete(const argList& args)
{
    const fileName controlFile(args.rootPath() / args.globalCaseName() / "system" / "controlDict");
    if (!isFile(controlFile))
    {
        return;
    }
    IFstream is(controlFile);
    const dictionary control(is);
    if (control.getOrDefault<word>("startFrom", "latestTime") != "latestTime")
    {
        return;
    }

    // Times of all processors
    const fileName path(args.path());
    std::map<scalar, word> times;
    {
        List<wordList> names(Pstream::nProcs());
        for (const instant& t : Time::findTimes(path))
        {
            if (t.name() != "constant")
            {
                names[Pstream::myProcNo()].append(t.name());
            }
        }
        Pstream::gatherList(names);
        Pstream::scatterList(names);
        for (const wordList& list : names)
        {
            for (const word& name : list)
            {
                times.emplace(readScalar(name), name);
            }
        }
    }

    // The last ones that were only begun: no run can start there
    DynamicList<word> incomplete;
    while (times.size() > 1)
    {
        const auto last = std::prev(times.end());
        const bool hollow = isHollow(path / last->second) && !isFile(stateFile(path, last->second));
        if (!returnReduce(hollow, andOp<bool>()))
        {
            break;
        }
        incomplete.append(last->second);
        times.erase(last);
    }

    // Those with points or a state on some processor, complete on all. The
    // first one with points is that of setMaterialPoints; later ones are of a
    // run
    wordList names;
    boolList complete;
    for (const auto& t : times)
    {
        const bool here =
            isDir(path / t.second / cloud::prefix) || isFile(stateFile(path, t.second));
        const bool has = returnReduce(here, orOp<bool>());
        if (names.size() || has)
        {
            names.append(t.second);
            complete.append(returnReduce(isFile(stateFile(path, t.second)), andOp<bool>()));
        }
    }

    word start(names.empty() && times.size() ? times.rbegin()->second : word());
    for (label i = names.size() - 1; i >= 0 && start.empty(); --i)
    {
        if (i == 0 || complete[i])
        {
            start = names[i];
        }
        else
        {
            incomplete.append(names[i]);
        }
    }

    for (const word& name : incomplete)
    {
        const fileName aside(path / (name + ".incomplete"));
        Info << "Time " << name << " was not written to its end (no"
             << " uniform/materialPointState" << (Pstream::parRun() ? " on some processor" : "")
             << "); it is now called " << aside.name() << " and the run starts from " << start << nl
             << endl;
        if (isDir(aside))
        {
            rmDir(aside);
        }
        if (isDir(path / name))
        {
            mv(path / name, aside);
        }
    }
}

void Foam::mpm::timeStepControl::writeState() const
{
    const fileName file(stateFile(time_.path(), time_.timeName()));
    const fullPrecision allDigits;

    mkDir(file.path());
    {
        dictionary state;
        state.add("value", time_.value());
        state.add("origin", origin_);
        state.add("growFrom", growFrom_);
        state.merge(simulation_.state());
        state.add("complete", true);

        OFstream os(file + ".part");
        os.precision(17);
        os << "// " << version << nl;
        state.write(os, false);
    }
    mv(file + ".part", file);
}

bool Foam::mpm::timeStepControl::dryRun(const argList& args) const
{
    if (args.found("dry-run") || args.found("dry-run-write"))
    {
        Info << "Dry run: the case is complete (maxCo and functions of"
             << " controlDict are not read). End\n"
             << endl;
        return true;
    }
    return false;
}

bool Foam::mpm::timeStepControl::openEnd() const { return time_.endTime().value() > 0.1 * GREAT; }

Foam::label Foam::mpm::timeStepControl::reportInterval(const label step) const
{
    return boundedLabelOrDefault(
        time_.controlDict(), "reportInterval", step < 5000 ? 10 : 100, 1, labelMax);
}

bool Foam::mpm::timeStepControl::rebuilds() const
{
    const label interval =
        boundedLabelOrDefault(time_.controlDict(), "rebuildInterval", 0, 0, labelMax);
    return interval > 0 && nSteps_ > 0 && time_.timeIndex() % interval == 0;
}

bool Foam::mpm::timeStepControl::reports() const
{
    return time_.timeIndex() % reportInterval(time_.timeIndex()) == 0 || time_.writeTime() || last_
        || time_.value() > time_.endTime().value() - 0.5 * time_.deltaTValue();
}

void Foam::mpm::timeStepControl::announce()
{
    const label step = time_.timeIndex() + 1;
    const scalar next = time_.value() + time_.deltaTValue();
    if (step % reportInterval(step) == 0
        || next > time_.endTime().value() - 0.5 * time_.deltaTValue())
    {
        announced_ = Time::timeName(next);
        Info << "Time = " << announced_ << nl << endl;
    }
}

void Foam::mpm::timeStepControl::printTime()
{
    if (announced_ != time_.timeName())
    {
        Info << "Time = " << time_.timeName() << nl << endl;
    }
    announced_.clear();
}

Foam::scalar Foam::mpm::timeStepControl::secondsLeft()
{
    const auto now = clock::now();
    const scalar seconds = std::chrono::duration<scalar>(now - passed_.first().second()).count();
    const scalar way = time_.value() - passed_.first().first();
    const scalar left = min(time_.endTime().value(), GREAT) - time_.value();

    // The last half minute, or the last two reports
    passed_.append(Tuple2<scalar, clock::time_point>(time_.value(), now));
    while (passed_.size() > 2
           && std::chrono::duration<scalar>(now - passed_[1].second()).count() > 30)
    {
        passed_.remove(0);
    }
    return way > 0 ? max(left, scalar(0)) * seconds / way : 0;
}

void Foam::mpm::timeStepControl::report()
{
    ++nSteps_;
    if (!reports())
    {
        return;
    }
    const scalar end = endTime_ < GREAT ? endTime_ : min(time_.endTime().value(), GREAT);
    const scalar done = (time_.value() - startTime_) / max(end - startTime_, VSMALL);

    Info << "Progress: " << 100 * min(done, scalar(1)) << " %, step " << time_.timeIndex()
         << timeLeft().c_str() << nl << "ExecutionTime = " << time_.elapsedCpuTime() << " s of CPU,"
         << " ClockTime = " << time_.elapsedClockTime() << " s passed" << nl << endl;
    watchEnergy();
}

void Foam::mpm::timeStepControl::end() const
{
    if (!nSteps_ && time_.value() < time_.endTime().value() - 1e-9 * mag(time_.endTime().value()))
    {
        FatalIOErrorInFunction(time_.controlDict())
            << "No step was taken from time " << time_.timeName() << ": deltaT "
            << time_.deltaTValue() << " is more than twice"
            << " the time to endTime " << time_.endTime().value() << "." << exit(FatalIOError);
    }
    Info << "Steps: " << nSteps_ << " of this run" << nl << "End\n" << endl;
}
