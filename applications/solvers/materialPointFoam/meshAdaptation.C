// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "meshAdaptation.H"
#include "ownedFields.H"
#include "rowsRefinement.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::meshAdaptation::meshAdaptation(fvMesh& mesh) :
    mesh_(mesh), adaptive_(mesh), look_(-1), nChanges_(0), seconds_(0)
{
    if (adaptive_.active())
    {
        Info << "Adaptive mesh: a look every " << adaptive_.interval() << " steps; cells of the"
             << " base mesh are halved up to " << adaptive_.maxLevel() << " times" << nl << endl;
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::meshAdaptation::change(simulation& of)
{
    const labelList change(adaptive_.change(false));
    autoPtr<treeLeaves> to(adaptive_.changed(change));
    if (!returnReduce(to->level() != adaptive_.leaves().level(), orOp<bool>()))
    {
        return false;
    }
    simulation::rows state(of.takeDown());
    ownedFields owned(mesh_);
    rowsRefinement rows(mesh_, adaptive_, to(), state, owned.states);
    meshChange changed(adaptive_.make(std::move(to)));
    rows.move(state, owned.states);
    owned.make(mesh_);
    of = simulation(mesh_, std::move(state));
    changed.tellFunctionObjects();
    ++nChanges_;
    return true;
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
    label n = 0;
    while (n < (first ? adaptive_.maxLevel() : 1) && change(of))
    {
        ++n;
    }
    if (n)
    {
        Info << "Adaptive mesh: " << returnReduce(mesh_.nCells(), sumOp<label>()) << " cells" << nl
             << endl;
    }
}

void Foam::mpm::meshAdaptation::report() const
{
    if (adaptive_.active())
    {
        Info << "Adaptive mesh: " << nChanges_ << " changes in " << seconds_ << " s" << nl << endl;
    }
}
