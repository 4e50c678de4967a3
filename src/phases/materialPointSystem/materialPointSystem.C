// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "phaseDamping.H"
#include "rigidBodies.H"
#include "dictionaryTools.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(materialPointSystem, 0);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::materialPointSystem::indexOf(const word& phase) const
{
    forAll(phases_, phasei)
    {
        if (phases_[phasei].name() == phase)
        {
            return phasei;
        }
    }
    return -1;
}

Foam::label Foam::mpm::materialPointSystem::nPoints() const
{
    label n = 0;
    for (const materialPointPhase& phase : phases_)
    {
        n += phase.cloud().size();
    }
    return returnReduce(n, sumOp<label>());
}

Foam::scalar Foam::mpm::materialPointSystem::bytesPerPoint() const
{
    scalar bytes = 0;
    label n = 0;
    forAll(phases_, phasei)
    {
        const materialPointCloud& cloud = phases_[phasei].cloud();
        bytes += cloud.bytesPerPoint() * cloud.size();
        bytes += cellChanges_[phasei].capacity() * sizeof(materialPointCloud::cellChange);
        n += cloud.size();
    }
    reduce(bytes, sumOp<scalar>());
    reduce(n, sumOp<label>());
    return bytes / max(n, label(1));
}

Foam::scalar Foam::mpm::materialPointSystem::gridBytes() const
{
    scalar bytes = 0;
    for (const velocityField& field : fields_)
    {
        bytes += field.bytes();
    }
    return returnReduce(bytes, sumOp<scalar>());
}

bool Foam::mpm::materialPointSystem::damps() const { return parts_.find<phaseDamping>()->damps(); }

void Foam::mpm::materialPointSystem::couple(pointCoupling& coupling)
{
    if (stressUpdate_->early())
    {
        FatalIOErrorInFunction(mesh_.solutionDict().subDict("materialPoints"))
            << "stressUpdate " << stressUpdate_->type() << " does not work in"
            << " a gas, which has to act on the stress of the start of the"
            << " step." << nl << "Valid choice: MUSL" << exit(FatalIOError);
    }
    if (outflow_)
    {
        FatalIOErrorInFunction(properties_.subDict("outflow"))
            << "There is an outflow, which does not work in a gas: the cell of"
            << " a point that leaves would have its gas expand at once into the"
            << " free volume." << nl << "Remove outflow, and make the mesh"
            << " larger or keep points inside by the boundary conditions of"
            << " their velocity." << exit(FatalIOError);
    }
    if (damps())
    {
        FatalIOErrorInFunction(properties_)
            << "damping does not work in a gas, whose drag has to take what"
            << " the points lose." << exit(FatalIOError);
    }
    const bool shares = rigid_->shares();
    coupling_ = &coupling;
    parts_.add(coupling);
    if (shares)
    {
        // In a gas rigid bodies do not share nodes
        startNodes();
    }
}

void Foam::mpm::materialPointSystem::addImpulse(const label fieldi, scalar* impulse)
{
    velocityField& field = fields_[fieldi];
    field.sumColumn(impulse);
    if (energy_->active())
    {
        energy_->addImpulse(fieldi, impulse);
    }
    const scalar work = field.addImpulse(impulse, energy_->active());
    if (energy_->active())
    {
        energy_->book(energy_->sums().step.boundary, work);
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::readNumerics()
{
    if (!from_ && !mesh_.solutionDict().found("materialPoints"))
    {
        FatalIOErrorInFunction(mesh_.solutionDict())
            << "Entry materialPoints is missing in " << mesh_.solutionDict().name()
            << ". It has the numerics of the"
            << " phases " << flatOutput(materialPointPhase::names(properties_))
            << ", which are of material points: they have neither  type gas"
            << "  nor  type fluid  in constant/phaseProperties." << exit(FatalIOError);
    }
    const dictionary& dict =
        from_ ? from_->numerics : requiredDict(mesh_.solutionDict(), "materialPoints");

    checkNumerics(dict);
    numerics_ = dict;
    if (!dict.found("shapeFunction"))
    {
        numerics_.add("shapeFunction", pointGridTransfer::usual(grid_));
    }
    numericsRead_ = from_ ? from_->numericsRead : dict;
    transfer_ = transferScheme::New(numerics_);
    stressUpdate_ = stressUpdate::New(dict);
    readLimits(dict);
}

void Foam::mpm::materialPointSystem::readLimits(const dictionary& dict)
{
    maxTravel_ = boundedOrDefault(dict, "maxTravel", 0.5, 1e-3, 0.9);
    maxStrain_ = boundedOrDefault(dict, "maxStrain", 0.2, 1e-4, 1);
    pressureFilter_ = boundedOrDefault(dict, "pressureFilter", 0, 0, 1);
    turnSides_ = dict.getOrDefault<bool>("turnSides", false);
}

void Foam::mpm::materialPointSystem::checkNumerics(const dictionary& dict)
{
    wordList valid(transferScheme::keywordsOfAll(dict));
    valid.append(wordList(
        {"shapeFunction", "dilatation", "pressureFilter", "turnSides", "stressUpdate",
         "energyBudget", "maxTravel", "maxStrain"}));
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::readModified()
{
    if (!mesh_.time().runTimeModifiable())
    {
        return;
    }
    dictionary dict(requiredDict(mesh_.solutionDict(), "materialPoints"));
    if (numericsRead_ == dict)
    {
        return;
    }
    numericsRead_ = dict;
    if (!dict.found("shapeFunction"))
    {
        dict.add("shapeFunction", pointGridTransfer::usual(grid_));
    }

    // Entries that are fixed during a run; if the transfer has changed, its own
    // entries too
    wordList fixed({"shapeFunction", "dilatation", "transfer", "stressUpdate"});
    if (dict.getOrDefault<word>("transfer", "") != numerics_.getOrDefault<word>("transfer", ""))
    {
        fixed = transferScheme::keywordsOfAll(dict);
        fixed.append(wordList({"shapeFunction", "dilatation", "stressUpdate"}));
    }
    if (energy_->active())
    {
        fixed.append("energyBudget");
    }
    wordList keys(dict.toc());
    for (const word& key : numerics_.toc())
    {
        if (!keys.found(key))
        {
            keys.append(key);
        }
    }
    dictionary now(dict);
    wordList acts, later;
    for (const word& key : keys)
    {
        const entry* a = numerics_.findEntry(key);
        const entry* b = dict.findEntry(key);
        if (a && b && *a == *b)
        {
            continue;
        }
        (fixed.found(key) ? later : acts).append(key);
        if (fixed.found(key) && a)
        {
            now.set(a->clone(now).ptr());
        }
        else if (fixed.found(key))
        {
            now.remove(key);
        }
    }
    checkNumerics(dict);
    transfer_ = transferScheme::New(now);
    readLimits(now);
    if (now.getOrDefault<bool>("energyBudget", false))
    {
        energy_->startBudget();
    }
    if (acts.size())
    {
        Info << "fvSolution.materialPoints has changed: " << flatOutput(acts) << " act from time "
             << mesh_.time().timeName() << " on" << nl << endl;
    }
    if (later.size())
    {
        WarningInFunction << "fvSolution.materialPoints has changed: " << flatOutput(later)
                          << " act only in a new run; this one keeps the old ones." << endl;
    }
    numerics_ = now;
}
