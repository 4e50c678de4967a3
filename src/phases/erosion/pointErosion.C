// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointErosion.H"
#include "pointCoupling.H"
#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "dictionaryTools.H"
#include "largestOfAll.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointErosion::pointErosion(materialPointSystem& points) :
    stepPart("erosion"),
    points_(points),
    phases_(points.phases()),
    erodes_(false),
    eroded_(phases_.size()),
    left_(phases_.size()),
    empty_(false),
    started_(0),
    debris_(phases_.size(), -1)
{
    for (const materialPointPhase& phase : phases_)
    {
        erodes_ = erodes_ || phase.erosion();
    }
    connectDebris();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::pointErosion::erodes() const { return erodes_ || points_.outflow(); }

void Foam::mpm::pointErosion::end(const scalar dt)
{
    if (!erodes_)
    {
        return;
    }
    const noTraps guard;
    if (points_.coupling())
    {
        points_.coupling()->removing(dt);
    }

    // Phases whose points go to another phase come last: these points have
    // taken their step already
    labelList order;
    for (const bool gives : {false, true})
    {
        forAll(phases_, phasei)
        {
            if (phases_[phasei].erosion() && (debris_[phasei] >= 0) == gives)
            {
                order.append(phasei);
            }
        }
    }

    List<erodedPoints> step(phases_.size());
    label n = 0;
    for (const label phasei : order)
    {
        const label to = debris_[phasei];
        step[phasei] = phases_[phasei].erode(dt, to < 0 ? nullptr : &phases_[to].cloud());
        n += step[phasei].n;
    }
    if (!onAny(n > 0))
    {
        return;
    }
    if (points_.coupling())
    {
        points_.coupling()->removed();
    }

    label nLeft = 0;
    forAll(phases_, phasei)
    {
        if (phases_[phasei].erosion())
        {
            step[phasei].reduceAll();
            eroded_[phasei] += step[phasei];
            if (debris_[phasei] < 0)
            {
                bookLoss(step[phasei]);
            }
        }
        if (!phases_[phasei].motion())
        {
            nLeft += phases_[phasei].cloud().size();
        }
    }
    if (!onAny(nLeft > 0))
    {
        FatalErrorInFunction << "All points have eroded in the step of " << dt << " s after time "
                             << points_.time().timeName() << ": nothing is left to compute." << nl
                             << "Look at the limits of erosion in constant/phaseProperties."
                             << exit(FatalError);
    }

    // Make the nodes anew from the points that are left
    points_.projectAnew(dt);
}

void Foam::mpm::pointErosion::bookLoss(const erodedPoints& loss)
{
    if (points_.energy().active())
    {
        points_.energy().sums().erodedKinetic += loss.kinetic;
        points_.energy().sums().erodedStored += loss.stored;
    }
}

void Foam::mpm::pointErosion::accepted(const scalar)
{
    if (!points_.outflow())
    {
        return;
    }
    const noTraps guard;
    List<erodedPoints> step(phases_.size());
    label n = 0;
    forAll(phases_, phasei)
    {
        if (!phases_[phasei].motion())
        {
            step[phasei] = phases_[phasei].leave(points_.cellChanges(phasei));
            n += step[phasei].n;
        }
    }
    if (!onAny(n > 0))
    {
        return;
    }

    label nLeft = 0;
    forAll(phases_, phasei)
    {
        step[phasei].reduceAll();
        left_[phasei] += step[phasei];
        bookLoss(step[phasei]);
        nLeft += phases_[phasei].motion() ? 0 : phases_[phasei].cloud().size();
    }
    empty_ = !onAny(nLeft > 0);
}

Foam::mpm::erodedPoints Foam::mpm::pointErosion::eroded(const label phasei) const
{
    erodedPoints sums(left_[phasei]);
    if (debris_[phasei] < 0)
    {
        sums += eroded_[phasei];
    }
    return sums;
}

void Foam::mpm::pointErosion::connectDebris()
{
    wordList names(phases_.size());
    forAll(phases_, phasei)
    {
        names[phasei] = phases_[phasei].name();
    }
    forAll(phases_, phasei)
    {
        const word& debris = phases_[phasei].debris();
        if (debris.empty())
        {
            continue;
        }
        const dictionary& dict = points_.properties().subDict(names[phasei]).subDict("erosion");
        const label to = names.find(debris);
        if (to < 0 || to == phasei || phases_[to].motion())
        {
            FatalIOErrorInFunction(dict) << "The eroded points of " << names[phasei] << " go to "
                                         << debris << ", not another phase of material points."
                                         << nl << "The phases are: " << names << exit(FatalIOError);
        }
        if (!phases_[to].debris().empty())
        {
            FatalIOErrorInFunction(dict)
                << "The eroded points of " << names[phasei] << " go to " << debris
                << ", whose own go to " << phases_[to].debris() << "." << nl
                << "Points may change phase once: " << debris
                << " may have erosion without to. If it begins with  $" << names[phasei]
                << ";  it has the erosion of that too (an"
                << " entry erosion of its own is merged into it): take it out"
                << " with  #remove erosion  in the next line." << exit(FatalIOError);
        }
        if (debris_.found(to))
        {
            FatalIOErrorInFunction(dict)
                << "The eroded points of " << names[phasei] << " and of " << names[debris_.find(to)]
                << " both go to " << debris << ": their ids would be the same." << nl
                << "Give each a phase of its own; they may share a"
                << " velocityField." << exit(FatalIOError);
        }
        for (const word key : {"constitutiveModel", "failureModel"})
        {
            const dictionary& from = points_.properties().subDict(names[phasei]);
            const dictionary& into = points_.properties().subDict(debris);
            if (from.found(key) != into.found(key)
                || (from.found(key) && from.subDict(key) != into.subDict(key)))
            {
                FatalIOErrorInFunction(dict)
                    << "The eroded points of " << names[phasei] << " go to " << debris << ", whose "
                    << key << " differs: their"
                    << " columns and energy cannot be transferred." << nl << "Give " << debris
                    << " the " << key << " of " << names[phasei] << ", entry by entry."
                    << exit(FatalIOError);
            }
        }
        if (phases_[to].referencePressure() != phases_[phasei].referencePressure())
        {
            FatalIOErrorInFunction(dict)
                << "The eroded points of " << names[phasei] << " go to " << debris
                << ", whose referencePressure differs: give " << debris << " that of "
                << names[phasei] << ", " << phases_[phasei].referencePressure() << " Pa."
                << exit(FatalIOError);
        }
        debris_[phasei] = to;
    }
}

void Foam::mpm::pointErosion::checkDebris() const
{
    forAll(debris_, phasei)
    {
        const label to = debris_[phasei];
        if (to < 0)
        {
            continue;
        }
        const label there = returnReduce(phases_[to].cloud().size(), sumOp<label>()) + nGone(to);
        if (there != eroded_[phasei].n)
        {
            FatalErrorInFunction << "Phase " << phases_[to].name() << " has " << there
                                 << " material points, but " << eroded_[phasei].n
                                 << " have come from " << phases_[phasei].name() << "." << nl
                                 << "It may hold only those, and they keep their ids: no region"
                                 << " of setMaterialPointsDict may fill it, and a restart needs"
                                 << " its folder." << exit(FatalError);
        }
    }
}

void Foam::mpm::pointErosion::countStarted() { started_ = points_.nPoints() + nEroded(); }

Foam::label Foam::mpm::pointErosion::nEroded() const
{
    label n = 0;
    forAll(eroded_, phasei)
    {
        n += eroded(phasei).n;
    }
    return n;
}

void Foam::mpm::pointErosion::report() const
{
    const label nPresent = points_.nPoints();
    if (nPresent + nEroded() != started_)
    {
        FatalErrorInFunction << "There are " << nPresent << " material points and " << nEroded()
                             << " have eroded or left, but " << started_
                             << " were there at the start." << exit(FatalError);
    }
    checkDebris();
    const auto line = [](const char* what, const word& name, const erodedPoints& e)
    {
        Info << what << ' ' << name << ": " << e.n << " points, mass " << e.mass << ", momentum "
             << e.momentum << ", energy: kinetic " << e.kinetic << ", stored " << e.stored;
    };
    forAll(phases_, phasei)
    {
        const materialPointPhase& phase = phases_[phasei];
        if (left_[phasei].n)
        {
            line("Outflow", phase.name(), left_[phasei]);
            Info << endl;
        }
        if (phase.erosion() || eroded_[phasei].n)
        {
            line("Eroded", phase.name(), eroded_[phasei]);
            if (debris_[phasei] >= 0)
            {
                Info << ", to " << phases_[debris_[phasei]].name();
            }
            Info << endl;
        }
    }
}

void Foam::mpm::pointErosion::addState(dictionary& state) const
{
    dictionary eroded, left;
    forAll(phases_, phasei)
    {
        if (phases_[phasei].erosion() || eroded_[phasei].n)
        {
            eroded.add(phases_[phasei].name(), eroded_[phasei].state());
        }
        if (left_[phasei].n)
        {
            left.add(phases_[phasei].name(), left_[phasei].state());
        }
    }
    if (eroded.size())
    {
        state.add("eroded", eroded);
    }
    if (left.size())
    {
        state.add("outflow", left);
    }
}

void Foam::mpm::pointErosion::setState(const dictionary& state)
{
    const auto read = [&](const word& key, List<erodedPoints>& sums)
    {
        if (!state.found(key))
        {
            return;
        }
        const dictionary& dict = requiredDict(state, key);
        DynamicList<word> names;
        forAll(phases_, phasei)
        {
            names.append(phases_[phasei].name());
            if (dict.found(names.last()))
            {
                sums[phasei].setState(requiredDict(dict, names.last()));
            }
        }
        checkKeywords(dict, wordList(names));
    };
    read("eroded", eroded_);
    read("outflow", left_);
    countStarted();
    checkDebris();

    label n = 0;
    for (const materialPointPhase& phase : phases_)
    {
        n += phase.motion() ? 0 : phase.cloud().size();
    }
    empty_ = points_.outflow() && !onAny(n > 0);
}
