// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "timeStepControl.H"
#include "pointEnergy.H"
#include "pointErosion.H"
#include "dictionaryTools.H"
#include "deltaTAdvice.H"
#include <cstring>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::timeStepControl::stop(const string& reason)
{
    if (time_.stopAt() == Time::stopAtControls::saWriteNow)
    {
        return;
    }
    const scalar end = time_.endTime().value();
    if (!openEnd() && time_.value() >= end - 0.5 * time_.deltaTValue())
    {
        Info << nl << reason.c_str() << nl << endl;
        return;
    }
    endTime_ = min(end, GREAT);
    Info << nl << reason.c_str() << nl << "The run ends after this step, which is written." << nl
         << endl;
    time_.stopAt(Time::stopAtControls::saWriteNow);
    last_ = true;
}

Foam::string Foam::mpm::timeStepControl::limiter() const
{
    const scalar pointRate = points() ? points()->courantRate() : 0;
    const scalar gasRate = gas() ? gas()->courantRate() : 0;
    const dictionary& dict = time_.controlDict();
    OStringStream os;
    if (dict.getOrDefault<bool>("adjustTimeStep", false))
    {
        const scalar most = dict.getOrDefault<scalar>("maxDeltaT", GREAT);
        const scalar courant = courantDeltaT();
        if (growFrom_ < min(courant, most))
        {
            os << "growth after a step that was redone; then by ";
        }
        else if (most < courant)
        {
            os << "maxDeltaT; then by ";
        }
        if (poreDeltaT() <= courant)
        {
            os << "what flows in the pores of light points; FLIP, APIC and B-splines bear"
                  " longer steps than FMPM and XPIC";
            return os.str();
        }
        if (points() && gas() && maxGasSubSteps() > 1)
        {
            const scalar several = severalGasDeltaT();
            if (several < pointsDeltaT())
            {
                os << "the " << flows() << ": Courant number " << gasRate * several << ", "
                   << (several < (1 - 1e-9) * maxGasSubSteps() * gasDeltaT()
                           ? "as much as its pressure may change before the"
                             " points feel it"
                           : "maxGasSubSteps");
                return os.str();
            }
        }
        else if (
            gas()
            && gasRate / dict.getOrDefault<scalar>("maxCoGas", 0.4)
                > pointRate / (maxSubSteps() * max(dict.getOrDefault<scalar>("maxCo", 1), VSMALL)))
        {
            os << "the " << flows() << ": Courant number " << gasRate * time_.deltaTValue();
            return os.str();
        }
    }
    else
    {
        os << "deltaT of controlDict; the least is that of ";
    }
    os << (points() ? points()->limiter() : "the " + word(flows())).c_str();
    return os.str();
}

void Foam::mpm::timeStepControl::announceSteps() const
{
    const scalar left = time_.endTime().value() - time_.value();
    const scalar n = left / time_.deltaTValue();
    if (openEnd() || !(left > 0) || !(n < labelMax))
    {
        return;
    }
    Info << "About " << label(std::ceil(n)) << (n > 1 ? " steps of " : " step of ")
         << time_.deltaTValue() << " s to endTime " << time_.endTime().value() << " s" << nl;
    if (n > 1e7)
    {
        WarningInFunction << "The run would take " << n << " steps: endTime "
                          << time_.endTime().value() << " s of system/controlDict by time"
                          << " steps of " << time_.deltaTValue() << " s, set by "
                          << limiter().c_str() << "." << nl
                          << "    Is endTime in s? The first lines with  Progress  say how"
                          << " long the run will take." << endl;
    }
}

Foam::string Foam::mpm::timeStepControl::timeLeft()
{
    const scalar seconds = secondsLeft();
    const scalar end = time_.endTime().value();
    if (last_ || time_.value() > end - 0.5 * time_.deltaTValue())
    {
        return "";
    }
    OStringStream os;
    os.precision(6);
    os << ", about ";
    if (seconds < 120)
    {
        os << max(std::round(seconds), scalar(1)) << " s";
    }
    else if (seconds < 7200)
    {
        os << std::round(seconds / 60) << " minutes";
    }
    else if (seconds < 48 * 3600)
    {
        os << std::round(seconds / 3600) << " hours";
    }
    else
    {
        os << std::round(seconds / 86400) << " days";
    }
    os << " left";
    return os.str();
}

void Foam::mpm::timeStepControl::watchDeltaT()
{
    const scalar dt = time_.deltaTValue();
    largest_ = max(largest_, dt);

    const dictionary& dict = time_.controlDict();
    const scalar least = boundedOrDefault(dict, "minDeltaT", 0, 0, GREAT);
    const bool fallen = !fallen_ && dt < 1e-3 * largest_;
    if (!fallen && !(dt < least))
    {
        return;
    }
    const string by(limiter());
    if (fallen)
    {
        fallen_ = true;
        WarningInFunction << "The time step has fallen from " << largest_ << " s to " << dt
                          << " s at time " << time_.timeName() << ". It is set by " << by.c_str()
                          << "." << nl
                          << "Erosion { type timeStep; limit ...; } of the phase removes such"
                          << " points; minDeltaT in system/controlDict ends the run with"
                          << " its state written." << endl;
    }
    if (dt < least)
    {
        stop(
            "The time step is below minDeltaT of system/controlDict; it is set"
            " by "
            + by + ".");
    }
}

void Foam::mpm::timeStepControl::watchCourant(const scalar Co)
{
    if (!(Co > 1 && Co >= 2 * warnedCo_))
    {
        return;
    }
    const string advice(deltaTAdvice(time_.deltaTValue(), Co));
    WarningInFunction << "The Courant number " << Co << " is above 1: waves outrun the"
                      << " time step. " << advice.c_str() << endl;
    if (!warnedCo_)
    {
        deltaTHint_ =
            "The Courant number has been above 1 since time " + time_.timeName() + ": " + advice;
    }
    warnedCo_ = Co;
}

void Foam::mpm::timeStepControl::watchPores()
{
    if (warnedPores_ || !(time_.deltaTValue() > poreDeltaT()))
    {
        return;
    }
    WarningInFunction << "The time step " << time_.deltaTValue() << " s is longer than "
                      << poreDeltaT() << " s, up to which light points bear what flows in their"
                      << " pores (gasCoupling.H)." << nl
                      << "Write  adjustTimeStep yes;  or a smaller deltaT; FLIP, APIC and B-splines"
                      << " bear longer steps than FMPM and XPIC." << endl;
    warnedPores_ = true;
}

void Foam::mpm::timeStepControl::watchEnergy()
{
    if (!points())
    {
        return;
    }
    const scalar growth = points()->energy().growth();
    const dictionary& dict = time_.controlDict();
    const scalar most = boundedOrDefault(dict, "maxEnergyGrowth", GREAT, 0, GREAT);
    if (!grown_ && growth > 0.1)
    {
        grown_ = true;
        WarningInFunction << "Energy has grown by " << 100 * growth << " % without a source, at"
                          << " time " << time_.timeName()
                          << (points()->energy().active()
                                  ? ": transfer + remap + residual + contact of the energy"
                                    " budget, less the work of prescribed bodies, has risen"
                                    " above its least value by this share of the largest energy"
                                    " of the points, or of what sources have exchanged if that"
                                    " is more."
                                  : ": the total of the points, since the first report.")
                          << nl << "A smaller maxCo or deltaT keeps a run stable, in place of"
                          << " FLIP and APIC also a transfer that dissipates (FMPM,"
                          << " PICfraction); maxEnergyGrowth in system/controlDict ends it"
                          << " with its state written." << endl;
    }
    if (growth > most)
    {
        OStringStream os;
        os << "Energy has grown by the share " << growth << " without a"
           << " source, more than maxEnergyGrowth of system/controlDict.";
        stop(os.str());
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::timeStepControl::endStep()
{
    if (const int number = signal_.received())
    {
        stop("Signal " + Foam::name(number) + " (" + strsignal(number) + ") was received.");
    }
    if (points() && points()->erosion().empty() && !gas())
    {
        stop("All material points have left through the patches of outflow.");
    }

    // As Time::run() will find after this step
    const scalar dt = time_.deltaTValue();
    if (!openEnd() && time_.value() + dt >= time_.endTime().value() - 0.5 * dt)
    {
        last_ = true;
        time_.writeOnce();
    }
}
