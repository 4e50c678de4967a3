// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "meshAdaptation.H"
#include "ownedFields.H"
#include "rowsDistribution.H"
#include "rowsRefinement.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::meshAdaptation::meshAdaptation(fvMesh& mesh) :
    mesh_(mesh),
    adaptive_(mesh),
    look_(mesh.time().timeIndex() > 0 ? mesh.time().timeIndex() : label(-1)),
    nChanges_(0),
    seconds_(0)
{
    if (adaptive_.active())
    {
        Info << "Adaptive mesh: a look every " << adaptive_.interval() << " steps; cells of the"
             << " base mesh are halved up to " << adaptive_.maxLevel() << " times" << nl << endl;
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::mpm::meshAdaptation::frozen(simulation& of) const
{
    if (!of.points() || !of.gas())
    {
        return boolList();
    }
    // Less than this is rounding, which must not decide
    constexpr scalar none = 1e-10;
    boolList at(mesh_.nCells());
    const scalarField& theta = of.gas()->theta();
    forAll(at, c)
    {
        at[c] = mag(theta[c] - 1) > none;
    }
    for (const materialPointPhase& phase : of.points()->phases())
    {
        UIndirectList<bool>(at, phase.cloud().cells()) = true;
    }
    return at;
}

void Foam::mpm::meshAdaptation::change(simulation& of, autoPtr<treeLeaves>&& to)
{
    wordList split;
    for (label i = 0; adaptive_.splitsPoints() && of.points() && i < of.points()->phases().size();
         ++i)
    {
        const materialPointPhase& phase = of.points()->phases()[i];
        if (!phase.motion())
        {
            split.append(phase.name());
        }
    }
    simulation::rows state(of.takeDown());
    ownedFields owned(mesh_);
    const label nCells = mesh_.nCells(), nFaces = mesh_.nFaces(), nPoints = mesh_.nPoints();
    while (to)
    {
        rowsRefinement rows(mesh_, adaptive_, to(), state, owned.states, split);
        adaptive_.make(std::move(to));
        rows.move(state, owned.states);
        to = adaptive_.next();
    }
    owned.make(mesh_);
    of = simulation(mesh_, std::move(state));
    meshChange(mesh_, nCells, nFaces, nPoints).tellFunctionObjects();
    ++nChanges_;
}

template<class Move>
void Foam::mpm::meshAdaptation::distribute(
    simulation& of, const labelList& to, meshDistribution&& numbers, const Move& moveTrees)
{
    rowsDistribution rows(mesh_, to);
    simulation::rows state(of.takeDown());
    ownedFields owned(mesh_);
    const meshDistribution::maps maps(numbers.move(to));
    rows.move(state, maps);
    rows.move(owned.states, maps);
    moveTrees();
    state.places = meshPlaces(mesh_);
    owned.make(mesh_);
    of = simulation(mesh_, std::move(state));
    maps.change.tellFunctionObjects();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::meshAdaptation::update(simulation& of)
{
    const label now = mesh_.time().timeIndex();
    const bool first = look_ < 0;
    if (!adaptive_.active() || (!first && (now % adaptive_.interval() || now == look_)))
    {
        return;
    }
    look_ = now;
    const timer t(seconds_);
    if (returnReduce(adaptive_.whole().size() > 0, orOp<bool>()))
    {
        distribute(
            of, labelList(adaptive_.whole()), meshDistribution(mesh_),
            [&]() { adaptive_.makeWhole(); });
    }

    // At the start fields show what they need when cells are fine
    for (label i = 0; i < (first ? adaptive_.maxLevel() : 1); ++i)
    {
        if (!adaptive_.look(false, first, frozen(of)))
        {
            break;
        }
        autoPtr<treeLeaves> to(adaptive_.next());
        if (to)
        {
            change(of, std::move(to));
            Info << "Adaptive mesh: " << returnReduce(mesh_.nCells(), sumOp<label>()) << " cells"
                 << nl << endl;
        }
    }
}

void Foam::mpm::meshAdaptation::move(simulation& of, const labelList& toProc, labelList& values)
{
    distribute(
        of, adaptive_.ofCells(toProc), std::move(*adaptive_.numbers()),
        [&]() { adaptive_.move(toProc, values); });
}

void Foam::mpm::meshAdaptation::report() const
{
    if (adaptive_.active())
    {
        Info << "Adaptive mesh: " << nChanges_ << " changes, looks and changes took " << seconds_
             << " s" << nl << endl;
    }
}
