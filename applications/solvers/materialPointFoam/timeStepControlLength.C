// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "timeStepControl.H"
#include "pointErosion.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

namespace
{

//- Must the write times of a dictionary be met?
bool isAdjustable(const Foam::dictionary& dict)
{
    const Foam::word control(dict.getOrDefault<Foam::word>("writeControl", "timeStep"));
    return control == "adjustableRunTime" || control == "adjustable";
}

//- Does fitDeltaT meet the write times of a function object? Not those that OpenFOAM ramps to
bool isFitted(const Foam::dictionary& dict)
{
    return isAdjustable(dict) && !dict.found("deltaTCoeff");
}

} // namespace

Foam::scalar Foam::mpm::timeStepControl::nextMultiple(const scalar interval) const
{
    const scalar passed = (time_.value() - origin_) / interval;
    return origin_ + (std::floor(passed + 1e-9) + 1) * interval;
}

Foam::scalar Foam::mpm::timeStepControl::meetFunctions()
{
    scalar next = GREAT;
    auto& functions = const_cast<functionObjectList&>(time_.functionObjects());
    const dictionary* entries = time_.controlDict().findDict("functions");
    if (!entries || entries->empty() || !functions.status())
    {
        return next;
    }
    if (functions.empty())
    {
        // Before the first step
        functions.read();
    }
    for (label i = 0; i < functions.size(); ++i)
    {
        const dictionary* own = entries->findDict(functions[i].name());
        if (!own || !isFitted(*own))
        {
            // May set a step of its own
            functions[i].adjustTimeStep();
            continue;
        }
        const scalar from = own->getOrDefault<scalar>("timeStart", -GREAT);
        const scalar to = own->getOrDefault<scalar>("timeEnd", GREAT);
        const scalar its = nextMultiple(positive(*own, "writeInterval"));
        if (time_.value() >= from && its <= to)
        {
            next = min(next, its);
        }
    }
    return next;
}

void Foam::mpm::timeStepControl::fitDeltaT(const scalar largest)
{
    // Not by Time or the function objects: they take the nearest whole number of steps, which may
    // make the step half as large again, and count from the last start, so that a restarted run
    // would round differently
    time_.setDeltaT(largest, false);
    scalar next = meetFunctions();
    scalar dt = min(largest, time_.deltaTValue());

    const dictionary& dict = time_.controlDict();
    if (isAdjustable(dict))
    {
        const scalar interval = positive(dict, "writeInterval");
        next = min(next, nextMultiple(interval));
        const scalar end = time_.endTime().value();
        // A start at the end may be less than it by the last digit
        const scalar rounding = 1e-9 * min(min(largest, interval), mag(end));
        if (!openEnd() && end - time_.value() > rounding)
        {
            next = min(next, end);
        }
    }
    const scalar left = next - time_.value();
    if (left > 0 && left < labelMax * dt)
    {
        dt = left / std::ceil(left / dt - 1e-9);
    }
    time_.setDeltaT(dt, false);
}

Foam::scalar Foam::mpm::timeStepControl::pointsDeltaT() const
{
    // The rate of a rigid body at rest is 0
    return points()
        ? bounded(time_.controlDict(), "maxCo", 1e-6, 1) / max(points()->courantRate(), VSMALL)
        : GREAT;
}

Foam::scalar Foam::mpm::timeStepControl::gasDeltaT() const
{
    return gas()
        ? boundedOrDefault(time_.controlDict(), "maxCoGas", 0.4, 1e-6, 1) / gas()->courantRate()
        : GREAT;
}

Foam::label Foam::mpm::timeStepControl::maxSubSteps() const
{
    return boundedLabelOrDefault(time_.controlDict(), "maxSubSteps", 1, 1, 100);
}

Foam::label Foam::mpm::timeStepControl::maxGasSubSteps() const
{
    return boundedLabelOrDefault(time_.controlDict(), "maxGasSubSteps", 1, 1, 100);
}

Foam::scalar Foam::mpm::timeStepControl::severalGasDeltaT() const
{
    const scalar dt = gasDeltaT();
    if (!gas() || maxGasSubSteps() == 1)
    {
        return dt;
    }
    const scalar lag = 1 / max(simulation_.lagRate(), VSMALL);
    return max(dt, min(maxGasSubSteps() * dt, lag));
}

Foam::scalar Foam::mpm::timeStepControl::poreDeltaT() const
{
    return points() && gas() ? 1 / max(simulation_.poreRate(), VSMALL) : GREAT;
}

Foam::scalar Foam::mpm::timeStepControl::courantDeltaT() const
{
    const scalar dt = pointsDeltaT();
    if (!gas() || maxSubSteps() == 1)
    {
        return min(min(dt, severalGasDeltaT()), poreDeltaT());
    }

    // The solid sweeps no more of a cell in a step of the gas than gas may
    const scalar swept = boundedOrDefault(time_.controlDict(), "maxCoGas", 0.4, 1e-6, 1)
        / max(points()->speedRate(), VSMALL);
    return min(min(dt * maxSubSteps(), max(swept, dt)), min(gasDeltaT(), poreDeltaT()));
}

void Foam::mpm::timeStepControl::checkSubSteps() const
{
    const dictionary& dict = time_.controlDict();
    if (maxSubSteps() == 1 && maxGasSubSteps() == 1)
    {
        return;
    }
    const char* name = maxSubSteps() > 1 ? "maxSubSteps" : "maxGasSubSteps";
    const char* lacking = !points() || !gas() ? "a gas or fluids beside material points"
        : !dict.getOrDefault<bool>("adjustTimeStep", false) ? "adjustTimeStep yes"
                                                            : nullptr;
    if (lacking)
    {
        FatalIOErrorInFunction(dict) << "Entry " << name << " has no effect without " << lacking
                                     << "." << nl << "Remove it." << exit(FatalIOError);
    }
    if (maxSubSteps() > 1 && maxGasSubSteps() > 1)
    {
        FatalIOErrorInFunction(dict)
            << "There are maxSubSteps " << maxSubSteps() << " and"
            << " maxGasSubSteps " << maxGasSubSteps() << ": one of them may be"
            << " greater than 1." << nl << "maxSubSteps is for points that need"
            << " a smaller step than the gas, maxGasSubSteps for a gas that"
            << " needs a smaller step than the points." << exit(FatalIOError);
    }
}

void Foam::mpm::timeStepControl::setSubSteps()
{
    nSub_ = 1;
    if (gas() && maxSubSteps() > 1)
    {
        // The gas limits: no more steps than the points need
        const scalar n = time_.deltaTValue() / pointsDeltaT();
        nSub_ = max(label(std::ceil(n - 1e-9)), label(1));
    }
    start_ = time_.value();
    done_ = 0;
    gasDone_ = 0;
    whole_ = time_.deltaTValue();
    sub_ = whole_ / nSub_;
    nGas_ = 0;
    severalOfGas_ = maxGasSubSteps() > 1 && whole_ > (1 + 1e-9) * gasDeltaT();
}

void Foam::mpm::timeStepControl::setPointTime()
{
    if (nSub_ > 1)
    {
        time_.setTime(start_ + (pointsLeft() ? done_ : 0), time_.timeIndex());
    }
}

Foam::scalar Foam::mpm::timeStepControl::startGas()
{
    if (nSub_ > 1)
    {
        time_.setTime(start_ + gasDone_, time_.timeIndex());
    }
    gasStep_ = done_ - gasDone_;
    if (severalOfGas_)
    {
        gasStep_ /= max(std::ceil(gasStep_ / gasDeltaT() - 1e-9), scalar(1));
        showGasStep(true);
    }
    return gasStep_;
}

void Foam::mpm::timeStepControl::showGasStep(const bool show)
{
    if (severalOfGas_)
    {
        time_.setDeltaT(show ? gasStep_ : whole_, false);
    }
}

void Foam::mpm::timeStepControl::gasDone()
{
    if (!severalOfGas_)
    {
        gasDone_ = done_;
        setPointTime();
        return;
    }

    // Fields that keep their old values do so by the index: another one each
    // time, until that of the whole step
    const label index = time_.timeIndex() - (nGas_ ? nGas_ + 1 : 0);
    const bool last = lastOfGas();
    gasDone_ = last ? whole_ : gasDone_ + gasStep_;
    ++nGas_;
    if (last)
    {
        time_.setTime(start_, index);
        showGasStep(false);
    }
    else
    {
        time_.setTime(start_ + gasDone_, index + nGas_ + 1);
    }
}

void Foam::mpm::timeStepControl::pointsDone()
{
    const scalar dt = time_.deltaTValue();
    if (nSub_ == 1 || sub_ >= dt - done_)
    {
        done_ = dt;
    }
    else
    {
        done_ += sub_;
        if (dt - done_ < 1.000001 * sub_)
        {
            sub_ = dt - done_;
        }
    }

    // Motions and boundary values depend on time
    setPointTime();
}

void Foam::mpm::timeStepControl::checkFirst(const scalar dt) const
{
    const scalar run = time_.endTime().value() - time_.startTime().value();
    // Nothing moves: there is no limit
    const bool limited = dt < ROOTVGREAT;
    if (!nSteps_ && !time_.startTimeIndex() && !openEnd() && limited && run > 0 && dt > run)
    {
        WarningInFunction << "The first time step that maxCo allows, " << dt << " s, is longer"
                          << " than the whole run of " << run << " s. It is set by "
                          << limiter().c_str() << "." << nl
                          << "    Nothing will be resolved: look for a wrong unit (E in Pa,"
                          << " rho in kg/m3, the mesh in m, endTime in s)." << endl;
    }
}

void Foam::mpm::timeStepControl::checkWrites() const
{
    const dictionary& dict = time_.controlDict();
    const word control(dict.getOrDefault<word>("writeControl", "timeStep"));
    const scalar interval = dict.getOrDefault<scalar>("writeInterval", 0);
    const scalar run = time_.endTime().value() - time_.startTime().value();
    const bool inTime =
        control == "runTime" || control == "adjustableRunTime" || control == "adjustable";
    if (inTime && !openEnd() && run > 0 && interval > 1.001 * time_.endTime().value())
    {
        IOWarningInFunction(dict) << "writeInterval " << interval << " s is beyond endTime "
                                  << time_.endTime().value() << " s: only its end will be"
                                  << " written." << endl;
    }
}

Foam::scalar Foam::mpm::timeStepControl::printDeltaT()
{
    const scalar CoPoints = points() ? points()->courantRate() * sub_ : 0;
    const scalar CoGas = gas()
        ? gas()->courantRate() * (severalOfGas_ ? min(whole_, gasDeltaT()) : time_.deltaTValue())
        : 0;
    const scalar Co = max(CoPoints, CoGas);
    if (!nSteps_ || reports())
    {
        Info << "Courant Number mean: " << Co << " max: " << Co << nl;
        if (points() && gas())
        {
            Info << "Courant Number of points: " << CoPoints << ", of the " << flows() << ": "
                 << CoGas << nl;
            if (nSub_ > 1)
            {
                Info << "Steps of the points in this one of the " << flows() << ": " << nSub_ << nl;
            }
            if (severalOfGas_)
            {
                Info << "Steps of the " << flows()
                     << " in this one of the points: " << std::ceil(whole_ / gasDeltaT() - 1e-9)
                     << nl;
            }
        }
        Info << "deltaT = " << time_.deltaTValue() << nl << "deltaT set by " << limiter().c_str()
             << endl;
    }
    return Co;
}

void Foam::mpm::timeStepControl::setDeltaT()
{
    if (last_)
    {
        // Time::run() ends by the time step of the last step
        setSubSteps();
        return;
    }
    if (points() && points()->erosion().empty() && !gas())
    {
        // Read like this: the run before has ended with it
        Info << "All material points have left through the patches of outflow." << nl << endl;
        time_.setEndTime(time_.value());
        last_ = true;
        return;
    }
    const dictionary& dict = time_.controlDict();
    const bool adjust = dict.getOrDefault<bool>("adjustTimeStep", false);

    nRedo_ = 0;
    checkSubSteps();

    const scalar end = time_.endTime().value();
    if (!nSteps_ && time_.value() >= end - 1e-9 * mag(end))
    {
        WarningInFunction << "endTime " << end << " is not after the time of the start, "
                          << time_.timeName() << ": nothing to do. Set a later endTime in"
                          << " system/controlDict, or remove the times of the last run." << endl;
    }
    if (!(time_.deltaTValue() > 0))
    {
        FatalIOErrorInFunction(dict) << "Entry deltaT is " << time_.deltaTValue()
                                     << "; it must be greater than 0." << exit(FatalIOError);
    }

    if (adjust)
    {
        const scalar maxDeltaT = boundedOrDefault(dict, "maxDeltaT", GREAT, VSMALL, GREAT);

        // After a step that was redone smaller, grow again by a fifth per step
        const scalar dt = min(courantDeltaT(), maxDeltaT);
        checkFirst(dt);
        if (dt <= 1.2 * growFrom_)
        {
            growFrom_ = GREAT;
            fitDeltaT(dt);
        }
        else
        {
            growFrom_ *= 1.2;
            fitDeltaT(growFrom_);
        }
    }

    else
    {
        const word Co(dict.found("maxCo") || !dict.found("maxCoGas") ? "maxCo" : "maxCoGas");
        if (dict.found(Co) && !dict.found("adjustTimeStep"))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << Co << " has no effect without adjustTimeStep." << nl
                << "Write  adjustTimeStep yes;  or, for a fixed deltaT, no." << exit(FatalIOError);
        }

        // A redone step may have made it smaller
        fixedDeltaT_ = max(fixedDeltaT_, time_.deltaTValue());
        growFrom_ *= 1.2;
        if (growFrom_ >= fixedDeltaT_)
        {
            growFrom_ = GREAT;
        }
        time_.setDeltaT(min(fixedDeltaT_, growFrom_), false);
    }

    if (!nSteps_)
    {
        announceSteps();
        checkWrites();
    }
    setSubSteps();
    watchDeltaT();
    checkAdvances();

    const scalar Co = printDeltaT();
    if (!adjust)
    {
        watchCourant(Co);
        if (!nSteps_ || reports())
        {
            watchPores();
        }
    }
}

void Foam::mpm::timeStepControl::redo(const scalar factor)
{
    const scalar dt = sub_;

    if (++nRedo_ > 20)
    {
        FatalErrorInFunction << "The step at time " << time_.timeName() << " was redone 20"
                             << " times down to " << dt << " s and still breaks maxTravel or"
                             << " maxStrain of fvSolution.materialPoints." << nl
                             << "The step is set by " << limiter().c_str() << "." << nl
                             << "The state is bad: check the last written time; a smaller"
                             << " maxCo in system/controlDict often avoids this."
                             << exit(FatalError);
    }

    if (nSub_ > 1)
    {
        sub_ *= factor;
    }
    else
    {
        fitDeltaT(factor * dt);
        growFrom_ = factor * dt;
        checkAdvances();
        setSubSteps();
    }
    Info << "Step redone: deltaT = " << sub_ << endl;
}

void Foam::mpm::timeStepControl::checkAdvances() const
{
    const scalar dt = time_.deltaTValue();
    const scalar nLeft = dt > 0 ? (time_.endTime().value() - time_.value()) / dt : GREAT;

    if (!(time_.value() + dt > time_.value()) || (!openEnd() && nLeft > labelMax))
    {
        FatalErrorInFunction << "The time step " << dt << " s at time " << time_.timeName()
                             << " would take " << nLeft << " steps to the end. It is set by "
                             << limiter().c_str() << "." << nl << deltaTHint_.c_str()
                             << (deltaTHint_.empty() ? "" : "\n")
                             << (deltaTHint_.empty() ? "It follows" : "Otherwise it follows")
                             << " from maxCo, maxDeltaT or deltaT in"
                             << " system/controlDict, the wave speeds and velocities of the"
                             << " points and the size of the cells: look for a wrong unit in"
                             << " constant/phaseProperties, setMaterialPointsDict or the"
                             << " boundary values of 0/U.<velocityField>, or endTime (s)."
                             << exit(FatalError);
    }
}
