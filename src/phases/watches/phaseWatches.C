// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "phaseWatches.H"
#include "materialPointSystem.H"
#include "pointContact.H"
#include "dictionaryTools.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::phaseWatches::phaseWatches(materialPointSystem& points) :
    stepPart("watches"),
    points_(points),
    warned_(points.fields().size() < 2),
    watches_(points.phases().size())
{
    if (const pointContact* contact = points.parts().find<pointContact>())
    {
        warned_ = true;
        for (label a = 0; a < points.fields().size(); ++a)
        {
            for (label b = a + 1; b < points.fields().size(); ++b)
            {
                warned_ = warned_ && contact->between(a, b);
            }
        }
    }
    checkOverlap();
    readWeights();
    forAll(points.phases(), phasei)
    {
        const materialPointPhase& phase = points.phases()[phasei];
        if (!phase.motion() && phase.law().holdsTogether())
        {
            watches_.set(phasei, new separationWatch(phase));
        }
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::phaseWatches::readWeights()
{
    IOobject header(
        "cellWeights", points_.mesh().time().timeName(), points_.mesh(), IOobject::MUST_READ,
        IOobject::AUTO_WRITE);
    const fieldStates* states = points_.startFields();
    const bool found =
        states ? states->found(header.name()) : header.typeHeaderOk<volScalarField>(true);
    if (returnReduce(found, andOp<bool>()))
    {
        weights_.reset(
            new volScalarField(fileOrState<volScalarField>(header, points_.mesh(), states)));
    }
}

void Foam::mpm::phaseWatches::updateWeights()
{
    if (!weights_)
    {
        return;
    }

    // The weights that setMaterialPoints -cellWeights writes
    weights_->primitiveFieldRef() = 0.02;
    for (const materialPointPhase& phase : points_.phases())
    {
        const materialPointCloud& cloud = phase.cloud();
        forAll(cloud.cells(), k)
        {
            (*weights_)[cloud.cells()[k]] += cloud.start()[k + 1] - cloud.start()[k];
        }
    }
}

void Foam::mpm::phaseWatches::checkOverlap()
{
    if (warned_)
    {
        return;
    }
    const pointContact* contact = points_.parts().find<pointContact>();
    const pointGrid& grid = points_.grid();
    labelList owner(grid.nNodes(), label(-1));
    labelList rigidOf(grid.nNodes(), label(-1));
    forAll(points_.fields(), fieldi)
    {
        const velocityField& field = points_.fields()[fieldi];
        for (const label n : field.rigid().nodes())
        {
            rigidOf[n] = fieldi;
        }
        for (const label n : field.active())
        {
            if (grid.nodePoint()[n] < 0
                || (rigidOf[n] != fieldi
                    && !(field.momentum()[field.stride() * n + grid.nDim()] > 0)))
            {
                continue;
            }
            if (owner[n] >= 0 && !warned_ && !(contact && contact->between(owner[n], fieldi)))
            {
                warned_ = true;
                warnOfOverlap(owner[n], fieldi, n);
            }
            owner[n] = fieldi;
        }
    }
}

void Foam::mpm::phaseWatches::warnOfOverlap(const label a, const label b, const label node)
{
    WarningInFunction << "The velocity fields " << points_.fields()[a].name() << " and "
                      << points_.fields()[b].name() << " share the mesh point "
                      << points_.mesh().points()[points_.grid().nodePoint()[node]] << " at time "
                      << points_.time().timeName()
                      << ": points of both reach it, from up to two cells away."
                      << " Nothing acts between them: phases with own velocity fields pass"
                      << " through each other. Give them the same velocityField in"
                      << " constant/phaseProperties to let them stick and push, or add"
                      << " contact { ... }; there." << endl;
}

Foam::dictionary Foam::mpm::phaseWatches::material(const materialPointPhase& phase) const
{
    dictionary now;
    now.add("rho", phase.rho());
    now.add("modulus", phase.rho() * sqr(phase.law().waveSpeed()));
    now.add("referencePressure", phase.referencePressure());
    now.add("failureModel", phase.failure() ? phase.failure()->type() : "none");
    return now;
}

void Foam::mpm::phaseWatches::warnOfChange(
    const word& phase, const dictionary& old, const dictionary& now) const
{
    const word time(points_.time().timeName());
    const struct
    {
        const char* key;
        const char* advice;
    } numbers[] = {
        {"rho",
         " kg/m3: the points keep their mass. For another density run"
         " setMaterialPoints again."},
        {"modulus",
         " Pa (rho c^2): the strains of the points come from the"
         " old one."},
        {"referencePressure", " Pa: the strains of the points come from the old one."}};
    for (const auto& n : numbers)
    {
        // States of older versions have no referencePressure
        const scalar before = boundedOrDefault(old, n.key, 0, 0, GREAT);
        const scalar after = now.get<scalar>(n.key);
        if (mag(after - before) > 1e-6 * before)
        {
            WarningInFunction << "Since time " << time << " was written " << n.key << " of phase "
                              << phase << " has changed from " << before << " to " << after
                              << n.advice << endl;
        }
    }
    const word before(required<word>(old, "failureModel"));
    if (before != "none" && now.get<word>("failureModel") == "none")
    {
        WarningInFunction << "Points of phase " << phase << " have the damage of the"
                          << " failureModel " << before << " at time " << time << ", but the"
                          << " phase has no failureModel now: they would carry again what"
                          << " they had lost." << endl;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::phaseWatches::addState(dictionary& state) const
{
    dictionary materials;
    for (const materialPointPhase& phase : points_.phases())
    {
        if (!phase.motion())
        {
            materials.add(phase.name(), material(phase));
        }
    }
    state.add("materials", materials);
}

void Foam::mpm::phaseWatches::setState(const dictionary& state)
{
    // States of older versions have no record
    if (!state.found("materials"))
    {
        return;
    }
    const dictionary& materials = requiredDict(state, "materials");
    DynamicList<word> names;
    for (const materialPointPhase& phase : points_.phases())
    {
        if (!phase.motion())
        {
            const dictionary& before = requiredDict(materials, phase.name());
            checkKeywords(before, {"rho", "modulus", "referencePressure", "failureModel"});
            warnOfChange(phase.name(), before, material(phase));
            names.append(phase.name());
        }
    }
    checkKeywords(materials, wordList(names));
}

void Foam::mpm::phaseWatches::addFields(fieldStates& fields) const
{
    if (weights_)
    {
        fields.set(weights_->name(), fieldDictionary(*weights_));
    }
}

void Foam::mpm::phaseWatches::write()
{
    forAll(watches_, phasei)
    {
        if (watches_.set(phasei))
        {
            watches_[phasei].look(points_.phases()[phasei]);
        }
    }
    updateWeights();
}
