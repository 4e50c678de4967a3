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
            step[phasei] = phases_[phasei].erode(dt);
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
            if (budget_.active)
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


void Foam::mpm::pointPhaseSystem::countStarted()
{
    started_ = nPoints() + nEroded();
}


Foam::label Foam::mpm::pointPhaseSystem::nEroded() const
{
    label n = 0;
    for (const erodedPoints& e : eroded_)
    {
        n += e.n;
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
                << e.stored << endl;
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
