/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::mpm::materialPointSystem::state() const
{
    dictionary state;
    state.add("rate", rate_);
    state.add("waveRate", waveRate_);
    state.add("stepsRedone", nRedone_);
    dictionary failed;
    for (const materialPointPhase& phase : phases_)
    {
        failed.add
        (
            phase.name(),
            returnReduce
            (
                const_cast<materialPointPhase&>(phase).nFailed(),
                sumOp<label>()
            )
        );
    }
    state.add("failed", failed);
    addErosionState(state);
    dictionary rigid;
    forAll(phases_, phasei)
    {
        if (const rigidMotion* motion = phases_[phasei].motion())
        {
            dictionary body(motion->state());
            body.add("impulse", rigidImpulse(phasei));
            rigid.add(phases_[phasei].name(), body);
        }
    }
    state.add("rigid", rigid);
    if (contact_)
    {
        state.add("contact", contact_->state());
    }
    if (damps())
    {
        state.add("damping", dampingState());
    }
    if (budget_.active)
    {
        dictionary energy;
        energy.add("kinetic0", budget_.kinetic0);
        energy.add("strain0", budget_.strain0);
        energy.add("internal", budget_.work.internal);
        energy.add("external", budget_.work.external);
        energy.add("boundary", budget_.work.boundary);
        pointLosses losses(losses_);
        losses.reduceAll();
        energy.add("failure", losses.failure);
        energy.add("dissipation", losses.dissipation);
        energy.add("stressWork", losses.work);
        energy.add("erodedKinetic", budget_.erodedKinetic);
        energy.add("erodedStored", budget_.erodedStored);
        if (coupling_)
        {
            energy.add("gas", coupling_->balance().state());
        }
        energy.add("contact", budget_.work.contact);
        energy.add("damping", budget_.damping);
        state.add("energy", energy);
    }
    return state;
}


void Foam::mpm::materialPointSystem::setState(const dictionary& state)
{
    checkKeywords
    (
        state,
        {
            "rate", "waveRate", "stepsRedone", "failed", "eroded", "outflow",
            "rigid", "contact", "energy", "damping"
        }
    );

    // The laws may have changed since
    rate_ = bounded
    (
        state,
        "rate",
        0,
        waveRate_ > 0 ? 1e3*(rate_ + waveRate_) : GREAT
    );
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
    if (waveRate >= least*waveRate_ && waveRate <= most*waveRate_)
    {
        waveRate_ = waveRate;
    }
    requireKeyword(state, "stepsRedone");
    nRedone_ = boundedLabelOrDefault(state, "stepsRedone", 0, 0, labelMax);

    const dictionary& failed = requiredDict(state, "failed");
    DynamicList<word> names, rigid;
    for (materialPointPhase& phase : phases_)
    {
        names.append(phase.name());
        if (phase.motion())
        {
            rigid.append(phase.name());
        }
        requireKeyword(failed, phase.name());
        const label n =
            boundedLabelOrDefault(failed, phase.name(), 0, 0, labelMax);
        phase.nFailed() = Pstream::master() ? n : 0;
    }
    checkKeywords(failed, wordList(names));
    setErosionState(state);
    if (state.found("rigid"))
    {
        checkKeywords(requiredDict(state, "rigid"), wordList(rigid));
    }

    if (contact_ && state.found("contact"))
    {
        contact_->setState(requiredDict(state, "contact"));
    }

    if (state.found("damping"))
    {
        setDampingState(requiredDict(state, "damping"));
    }

    if (state.found("energy"))
    {
        budget_.active = true;
        const dictionary& energy = requiredDict(state, "energy");
        budget_.kinetic0 = required<scalar>(energy, "kinetic0");
        budget_.strain0 = required<scalar>(energy, "strain0");
        budget_.work.internal = required<scalar>(energy, "internal");
        budget_.work.external = required<scalar>(energy, "external");
        budget_.work.boundary = required<scalar>(energy, "boundary");
        budget_.erodedKinetic =
            energy.getOrDefault<scalar>("erodedKinetic", 0);
        budget_.erodedStored =
            energy.getOrDefault<scalar>("erodedStored", 0);
        losses_ = pointLosses();
        if (Pstream::master())
        {
            losses_.failure = energy.getOrDefault<scalar>("failure", 0);
            losses_.dissipation = energy.getOrDefault<scalar>("dissipation", 0);
            losses_.work = energy.getOrDefault<scalar>
            (
                "stressWork", -budget_.work.internal
            );
        }
        if (coupling_)
        {
            coupling_->startBudget();
            if (energy.found("gas"))
            {
                gasBudget sums;
                sums.setState(requiredDict(energy, "gas"));
                coupling_->setBalance(sums);
            }
        }
        budget_.work.contact = energy.getOrDefault<scalar>("contact", 0);
        budget_.damping = energy.getOrDefault<scalar>("damping", 0);
    }
    if (!timeDependent())
    {
        return;
    }
    forAll(phases_, phasei)
    {
        if (rigidMotion* motion = phases_[phasei].motion())
        {
            const dictionary& body = requiredDict
            (
                requiredDict(state, "rigid"),
                phases_[phasei].name()
            );
            motion->setState(mesh_.time().value(), body);
            fields_[fieldOf_[phasei]].rigid().setImpulse
            (
                phasei,
                required<vector>(body, "impulse")
            );
        }
    }
    startNodes();
}

// ************************************************************************* //
