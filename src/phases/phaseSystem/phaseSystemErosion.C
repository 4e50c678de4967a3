/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "phaseSystem.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointPhaseSystem::erode(const scalar dt)
{
    if (!erodes_)
    {
        return;
    }
    const noTraps guard;

    List<erodedPoints> step(phases_.size());
    label n = 0;
    forAll(phases_, phasei)
    {
        if (phases_[phasei].erosion())
        {
            const label to = debris_[phasei];
            step[phasei] = phases_[phasei].erode
            (
                dt,
                to < 0 ? nullptr : &phases_[to].cloud()
            );
            n += step[phasei].n;
        }
    }
    if (!returnReduce(n, sumOp<label>()))
    {
        return;
    }

    label nLeft = 0;
    forAll(phases_, phasei)
    {
        if (phases_[phasei].erosion())
        {
            step[phasei].reduceAll();
            eroded_[phasei] += step[phasei];
            if (budget_.active && debris_[phasei] < 0)
            {
                budget_.erodedKinetic += step[phasei].kinetic;
                budget_.erodedStored += step[phasei].stored;
            }
        }
        if (!phases_[phasei].motion())
        {
            nLeft += phases_[phasei].cloud().size();
        }
    }
    if (!returnReduce(nLeft, sumOp<label>()))
    {
        FatalErrorInFunction
            << "All points have eroded in the step of " << dt
            << " s after time " << mesh_.time().timeName()
            << ": nothing is left to compute." << nl
            << "Look at the limits of erosion in constant/phaseProperties."
            << exit(FatalError);
    }

    // The nodes know only those that are left
    projectAnew(dt);
}


void Foam::mpm::pointPhaseSystem::connectDebris()
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
        const dictionary& dict =
            properties_.subDict(names[phasei]).subDict("erosion");
        const label to = names.find(debris);
        if (to < 0 || to == phasei || phases_[to].motion())
        {
            FatalIOErrorInFunction(dict)
                << "The eroded points of " << names[phasei] << " go to "
                << debris << ", which is no other phase of material points."
                << nl << "The phases are: " << names << exit(FatalIOError);
        }
        if (debris_.found(to))
        {
            FatalIOErrorInFunction(dict)
                << "The eroded points of " << names[phasei] << " and of "
                << names[debris_.find(to)] << " both go to " << debris
                << ": their ids would be the same." << nl
                << "Give each a phase of its own; they may share a"
                << " velocityField." << exit(FatalIOError);
        }
        const wordList own(phases_[phasei].cloud().columnNames());
        const wordList its(phases_[to].cloud().columnNames());
        if (own != its || phases_[phasei].law().type() != phases_[to].law().type())
        {
            FatalIOErrorInFunction(dict)
                << "The eroded points of " << names[phasei] << " go to "
                << debris << ", whose law or columns are others." << nl
                << names[phasei] << ": " << phases_[phasei].law().type()
                << ' ' << own << nl
                << debris << ": " << phases_[to].law().type() << ' ' << its
                << nl << "Give " << debris << " the constitutiveModel and the"
                << " failureModel of " << names[phasei] << '.'
                << exit(FatalIOError);
        }
        debris_[phasei] = to;
    }
}


void Foam::mpm::pointPhaseSystem::countStarted()
{
    started_ = nPoints() + nEroded();
}


Foam::label Foam::mpm::pointPhaseSystem::nEroded() const
{
    label n = 0;
    forAll(eroded_, phasei)
    {
        n += debris_[phasei] < 0 ? eroded_[phasei].n : 0;
    }
    return n;
}


void Foam::mpm::pointPhaseSystem::reportErosion(const label nPresent) const
{
    if (nPresent + nEroded() != started_)
    {
        FatalErrorInFunction
            << "There are " << nPresent << " material points and " << nEroded()
            << " have eroded, but " << started_ << " were there at the start."
            << exit(FatalError);
    }
    forAll(phases_, phasei)
    {
        const erodedPoints& e = eroded_[phasei];
        if (phases_[phasei].erosion() || e.n)
        {
            Info<< "Eroded " << phases_[phasei].name() << ": " << e.n
                << " points, mass " << e.mass << ", momentum " << e.momentum
                << ", energy: kinetic " << e.kinetic << ", stored "
                << e.stored;
            if (debris_[phasei] >= 0)
            {
                Info<< ", to " << phases_[debris_[phasei]].name();
            }
            Info<< endl;
        }
    }
}


void Foam::mpm::pointPhaseSystem::addErosionState(dictionary& state) const
{
    dictionary eroded;
    forAll(phases_, phasei)
    {
        if (phases_[phasei].erosion() || eroded_[phasei].n)
        {
            eroded.add(phases_[phasei].name(), eroded_[phasei].state());
        }
    }
    if (eroded.size())
    {
        state.add("eroded", eroded);
    }
}


void Foam::mpm::pointPhaseSystem::setErosionState(const dictionary& state)
{
    if (state.found("eroded"))
    {
        const dictionary& eroded = requiredDict(state, "eroded");
        DynamicList<word> names;
        forAll(phases_, phasei)
        {
            names.append(phases_[phasei].name());
            if (eroded.found(names.last()))
            {
                eroded_[phasei].setState(requiredDict(eroded, names.last()));
            }
        }
        checkKeywords(eroded, wordList(names));
    }
    countStarted();
}

// ************************************************************************* //
