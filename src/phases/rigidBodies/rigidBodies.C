// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "rigidBodies.H"
#include "materialPointSystem.H"
#include "pointContact.H"
#include "pointEnergy.H"
#include "dictionaryTools.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::rigidBodies::sharesNodes(const label phasei) const
{
    const materialPointPhase& phase = points_.phases()[phasei];
    if (!phase.prescribed() || !phase.motion()->moves() || points_.coupling())
    {
        return false;
    }
    const pointContact* contact = points_.parts().find<pointContact>();
    return !(contact && contact->has(points_.fieldOf(phasei)));
}

void Foam::mpm::rigidBodies::reach(const label phasei, const pointGridTransfer::states state)
{
    materialPointPhase& phase = points_.phases()[phasei];
    velocityField& field = points_.fields()[points_.fieldOf(phasei)];
    const pointGridTransfer& transfer = points_.gridTransfer();

    scalar* mass = field.rigid().clearMass(field.activeNew(), field.stride());
    transfer.project(phase.cloud(), state, mass);
    field.sumWithMass(mass);
    const bool shares = sharesNodes(phasei);
    if (shares)
    {
        field.rigid().startShares(
            transfer, phase.cloud(), field.nodeVolume(transfer), field.activeNew(), field.stride());
        field.largestOfShared(mass, field.stride(), 1);
    }
    field.rigid().add(
        phasei, *phase.motion(), phase.largestMass(),
        shares ? &field.nodeVolume(transfer) : nullptr, field.activeNew(), field.stride());
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::rigidBodies::rigidBodies(materialPointSystem& points) :
    stepPart("rigid"), points_(points)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::rigidBodies::shares() const
{
    forAll(points_.phases(), phasei)
    {
        if (sharesNodes(phasei))
        {
            return true;
        }
    }
    return false;
}

Foam::vector Foam::mpm::rigidBodies::impulse(const label phasei) const
{
    return points_.fields()[points_.fieldOf(phasei)].rigid().impulse(phasei);
}

Foam::vector Foam::mpm::rigidBodies::stepImpulse(const label phasei) const
{
    return points_.fields()[points_.fieldOf(phasei)].rigid().stepImpulse(phasei);
}

void Foam::mpm::rigidBodies::constrain(const scalar dt)
{
    const scalar time = points_.time().value();
    forAll(points_.phases(), phasei)
    {
        if (rigidMotion* motion = points_.phases()[phasei].motion())
        {
            motion->advance(time, time + dt);
            if (!motion->free())
            {
                points_.fields()[points_.fieldOf(phasei)].rigid().newVelocity(phasei, *motion);
            }
        }
    }
}

void Foam::mpm::rigidBodies::summedForce(const scalar)
{
    forAll(points_.fields(), fieldi)
    {
        velocityField& field = points_.fields()[fieldi];
        bool shares = false;
        forAll(points_.phases(), phasei)
        {
            shares = shares || (points_.fieldOf(phasei) == fieldi && sharesNodes(phasei));
        }
        field.rigid().setShares(shares);
        if (!shares)
        {
            continue;
        }
        scalar* q = field.rigid().clearSums(field.active());
        forAll(points_.phases(), phasei)
        {
            if (points_.fieldOf(phasei) == fieldi)
            {
                field.rigid().addSums(
                    points_.gridTransfer(), points_.phases()[phasei].cloud(),
                    points_.phases()[phasei].motion());
            }
        }
        field.sumShared(q, rigidNodes::nSums, rigidNodes::nSums);
        field.rigid().addTraction(field.stride(), field.force());
    }
}

void Foam::mpm::rigidBodies::moving(const scalar dt)
{
    scalar work = 0, gravityWork = 0;
    forAll(points_.phases(), phasei)
    {
        rigidMotion* motion = points_.phases()[phasei].motion();
        if (motion && motion->free())
        {
            freeBody& b = *motion->free();
            b.finish(dt, points_.projectedShare(points_.fieldOf(phasei)));
            work += b.work();
            gravityWork += b.gravityWork();
        }
    }
    points_.energy().sums().all += work;
    points_.energy().sums().step.external += gravityWork;
}

void Foam::mpm::rigidBodies::projected(const pointGridTransfer::states state)
{
    for (velocityField& field : points_.fields())
    {
        field.rigid().clear();
    }
    forAll(points_.phases(), phasei)
    {
        if (points_.phases()[phasei].motion())
        {
            reach(phasei, state);
        }
    }

    // Count the impulse on a node of several processors once
    boolList done(points_.fields().size(), false);
    forAll(points_.phases(), phasei)
    {
        const label fieldi = points_.fieldOf(phasei);
        if (points_.phases()[phasei].motion() && !done[fieldi])
        {
            velocityField& field = points_.fields()[fieldi];
            scalar* marks = field.rigid().marks(field.activeNew(), field.stride());
            field.sumColumn(marks);
            field.rigid().setParts(marks, field.stride());
            done[fieldi] = true;
        }
    }
}

void Foam::mpm::rigidBodies::accepted(const scalar)
{
    for (materialPointPhase& phase : points_.phases())
    {
        if (phase.motion())
        {
            phase.motion()->accept();
        }
    }
}

bool Foam::mpm::rigidBodies::drives() const
{
    for (const materialPointPhase& phase : points_.phases())
    {
        if (phase.prescribed() && phase.motion()->type() != "fixed")
        {
            return true;
        }
    }
    return false;
}

bool Foam::mpm::rigidBodies::timeDependent() const
{
    for (const materialPointPhase& phase : points_.phases())
    {
        if (phase.motion())
        {
            return true;
        }
    }
    return false;
}

void Foam::mpm::rigidBodies::addState(dictionary& state) const
{
    dictionary rigid;
    forAll(points_.phases(), phasei)
    {
        if (const rigidMotion* motion = points_.phases()[phasei].motion())
        {
            dictionary body(motion->state());
            body.add("impulse", impulse(phasei));
            rigid.add(points_.phases()[phasei].name(), body);
        }
    }
    state.add("rigid", rigid);
}

void Foam::mpm::rigidBodies::setState(const dictionary& state)
{
    DynamicList<word> names;
    forAll(points_.phases(), phasei)
    {
        materialPointPhase& phase = points_.phases()[phasei];
        if (rigidMotion* motion = phase.motion())
        {
            names.append(phase.name());
            const dictionary& body = requiredDict(requiredDict(state, "rigid"), phase.name());
            motion->setState(points_.time().value(), body);
            points_.fields()[points_.fieldOf(phasei)].rigid().setImpulse(
                phasei, required<vector>(body, "impulse"));
        }
    }
    if (state.found("rigid"))
    {
        checkKeywords(requiredDict(state, "rigid"), wordList(names));
    }
}

void Foam::mpm::rigidBodies::report() const
{
    forces_.setSize(points_.phases().size());
    forAll(points_.phases(), phasei)
    {
        if (points_.phases()[phasei].motion())
        {
            const vector sum(impulse(phasei));
            const vector force(forces_[phasei].next(
                sum, points_.time().value(), stepImpulse(phasei), points_.deltaT()));
            Info << "Load on " << points_.phases()[phasei].name() << ": force " << force
                 << " N, impulse " << sum << " N s" << endl;
        }
    }
}
