// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "adaptiveMesh.H"
#include "refinedMesh.H"
#include "dictionaryTools.H"
#include "labelIOList.H"
#include "syncTools.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::adaptiveMesh::readSettings()
{
    const IOdictionary dict(IOobject(
        "adaptiveMeshDict", mesh_.time().system(), mesh_.time(), IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE, false));
    if (dict.empty())
    {
        return false;
    }
    checkKeywords(dict, {"maxLevel", "refine", "buffer", "keep", "interval", "splitPoints"});
    requireKeyword(dict, "maxLevel");
    maxLevel_ = boundedLabelOrDefault(dict, "maxLevel", 1, 1, treeLeaves::maxLevel);
    buffer_ = boundedLabelOrDefault(dict, "buffer", 6, 0, 100);
    keep_ = boundedLabelOrDefault(dict, "keep", 2, 0, 100);
    interval_ = boundedLabelOrDefault(dict, "interval", 5, 1, labelMax);
    splitPoints_ = dict.getOrDefault<bool>("splitPoints", false);
    const dictionary& refine = requiredDict(dict, "refine");
    criteria_.setSize(refine.size());
    label i = 0;
    for (const entry& e : refine)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(refine)
                << "Entry " << e.keyword() << " of refine is no dictionary; write  " << e.keyword()
                << " { type ...; }" << exit(FatalIOError);
        }
        criteria_.set(i++, refinementCriterion::New(e.dict(), maxLevel_));
    }
    if (criteria_.empty())
    {
        FatalIOErrorInFunction(refine) << "There are no criteria." << exit(FatalIOError);
    }
    return true;
}

const Foam::mpm::cellLayers& Foam::mpm::adaptiveMesh::layers() const
{
    if (!layers_)
    {
        layers_.reset(new cellLayers(mesh_));
    }
    return layers_();
}

Foam::labelList Foam::mpm::adaptiveMesh::around(const labelUList& marked, const label nLayers) const
{
    labelList all(marked.size(), 0);
    labelHashSet levels;
    for (const refinementCriterion& criterion : criteria_)
    {
        const label level = criterion.level();
        if (!levels.insert(level))
        {
            continue;
        }

        // Layers of cells of this level: what is left of them behind each cell
        labelList left(marked.size()), size(marked.size());
        forAll(left, c)
        {
            size[c] = 1 << max(level - leaves_->level()[c], label(0));
            left[c] = marked[c] >= level ? nLayers : label(-1000);
        }
        labelList raised(identity(left.size()));
        for (label i = 0; i < nLayers; ++i)
        {
            DynamicList<label> from;
            for (const label c : raised)
            {
                if (left[c] > 0)
                {
                    from.append(c);
                }
            }
            raised = layers().spread(left, size, from);
        }
        forAll(left, c)
        {
            // The near side lies within them
            const bool in = marked[c] >= level || left[c] + size[c] > 0;
            all[c] = max(all[c], in ? level : 0);
        }
    }
    return all;
}

Foam::labelList Foam::mpm::adaptiveMesh::keepBrothers(labelList& wanted) const
{
    DynamicList<label> kept;
    boolList goes(wanted.size(), false);
    for (label c = 0; c < wanted.size(); ++c)
    {
        if (leaves_->isFirstOfBrothers(c))
        {
            const label n = hexes_()[leaves_->cell()[c]].nChildren();
            bool all = true;
            for (label i = 0; i < n; ++i)
            {
                all = all && wanted[c + i] < leaves_->level()[c];
            }
            SubList<bool>(goes, n, c) = all;
        }
    }
    forAll(wanted, c)
    {
        if (wanted[c] < leaves_->level()[c] && !goes[c])
        {
            wanted[c] = leaves_->level()[c];
            kept.append(c);
        }
    }
    return labelList(std::move(kept));
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::adaptiveMesh::adaptiveMesh(polyMesh& mesh) :
    mesh_(mesh),
    maxLevel_(0),
    buffer_(0),
    keep_(0),
    interval_(0),
    splitPoints_(false),
    changed_(false),
    baseWritten_(false),
    warned_(false)
{
    if (readSettings())
    {
        readBase();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::adaptiveMesh::look(const bool atStart, const bool always, const boolList& frozen)
{
    // Layers that must be fine, and the part of the cells that must be superfluous
    constexpr label margin = 2;
    constexpr scalar worth = 0.2;

    labelList marked(mesh_.nCells(), 0), keeps(marked);
    for (const refinementCriterion& criterion : criteria_)
    {
        scalarField need(mesh_.nCells(), 0);
        if (atStart)
        {
            criterion.markStart(mesh_, need);
        }
        else
        {
            criterion.mark(refCast<const fvMesh>(mesh_), need);
        }
        forAll(need, c)
        {
            marked[c] = max(marked[c], need[c] >= 1 ? criterion.level() : 0);
            keeps[c] = max(keeps[c], need[c] > 1.0 / 3 ? criterion.level() : 0);
        }
    }
    frozen_ = labelList(mesh_.nCells(), 0);
    if (returnReduce(frozen.size() > 0, orOp<bool>()))
    {
        forAll(frozen, c)
        {
            frozen_[c] = frozen[c];
        }
        layers().spread(
            frozen_, labelList(mesh_.nCells(), 0), labelList(findIndices(frozen, true)));
    }

    // First with few layers: most looks end here
    const labelList& level = leaves_->level();
    const labelList least(around(marked, min(margin, buffer_)));
    scalarList n(2, Zero);
    forAll(least, c)
    {
        n[frozen_[c]] += least[c] > level[c];
    }
    reduce(n, sumOp<scalarList>());
    if (n[1] > 0 && !warned_)
    {
        WarningInFunction << label(n[1]) << " cells at material points in a fluid are coarser than "
                          << "system/adaptiveMeshDict wants; cells at points keep their size"
                          << " beside a fluid. Valid choices: adaptMesh before"
                          << " setMaterialPoints; a criterion points with a larger buffer." << endl;
        warned_ = true;
    }
    const bool needed = always || n[0] > 0;
    if (!needed && (mesh_.time().timeIndex() / interval_) % 4)
    {
        return false;
    }
    kept_ = around(keeps, buffer_ + keep_);
    n = 0;
    forAll(kept_, c)
    {
        n[0] += kept_[c] < level[c] && !frozen_[c];
        n[1] += 1;
    }
    reduce(n, sumOp<scalarList>());
    if (!needed && n[0] <= worth * n[1])
    {
        return false;
    }
    wanted_ = around(marked, buffer_);
    return true;
}

Foam::autoPtr<Foam::mpm::treeLeaves> Foam::mpm::adaptiveMesh::next()
{
    const labelList& level = leaves_->level();
    labelList to(level);
    forAll(to, c)
    {
        to[c] += wanted_[c] > level[c] ? 1 : kept_[c] < level[c] ? -1 : 0;
    }

    // Beside what stays as it is nothing is finer by two levels
    const labelList one(to.size(), 1);
    labelList most(to.size(), -treeLeaves::maxLevel), from(findIndices(frozen_, 1));
    for (const label c : from)
    {
        most[c] = -level[c];
    }
    for (label i = 0; i < treeLeaves::maxLevel; ++i)
    {
        from = layers().spread(most, one, from);
    }
    forAll(to, c)
    {
        to[c] = frozen_[c] ? level[c] : min(to[c], -most[c]);
    }
    from = identity(to.size());
    bool again = true;
    while (again)
    {
        from.append(keepBrothers(to));
        from = layers().spread(to, one, from);
        again = returnReduce(from.size() > 0, orOp<bool>());
    }
    bool any = false;
    forAll(to, c)
    {
        to[c] -= level[c];
        any = any || to[c];
    }
    autoPtr<treeLeaves> leaves;
    if (returnReduce(any, orOp<bool>()))
    {
        leaves.reset(new treeLeaves(hexes_(), leaves_->changed(to)));
        const List<Pair<label>> from(leaves->sources(leaves_()));
        labelList wanted(from.size()), kept(from.size()), frozen(from.size());
        forAll(from, c)
        {
            frozen[c] = frozen_[from[c][0]];
            for (label o = from[c][0]; o < from[c][1]; ++o)
            {
                wanted[c] = max(wanted_[o], o > from[c][0] ? wanted[c] : 0);
                kept[c] = max(kept_[o], o > from[c][0] ? kept[c] : 0);
            }
        }
        wanted_.transfer(wanted);
        kept_.transfer(kept);
        frozen_.transfer(frozen);
    }
    return leaves;
}

void Foam::mpm::adaptiveMesh::make(autoPtr<treeLeaves>&& leaves)
{
    leaves_ = std::move(leaves);
    layers_.clear();
    refinedMesh made(leaves_());
    refinedMesh::primitives& p = made.made();
    baseFace_.transfer(p.baseFace);
    meshChange to(mesh_);
    to.set(std::move(p.points), std::move(p.faces), std::move(p.owner), std::move(p.neighbour));
    PtrList<dictionary> patches(meshChange::patches(base_()));
    to.setPatches(base_->boundaryMesh().names(), patches, p.patchSizes);

    const cellZoneMesh& zones = base_->cellZones();
    List<boolList> in(zones.size(), boolList(mesh_.nCells(), false));
    forAll(zones, i)
    {
        boolList inBase(base_->nCells(), false);
        UIndirectList<bool>(inBase, zones[i]) = true;
        forAll(in[i], c)
        {
            in[i][c] = inBase[leaves_->cell()[c]];
        }
    }
    to.setZones(zones.names(), in);
    changed_ = true;
}

void Foam::mpm::adaptiveMesh::makeWhole()
{
    make(autoPtr<treeLeaves>(new treeLeaves(leaves_())));
    whole_.clear();
}

Foam::scalarField Foam::mpm::adaptiveMesh::ofBase(const scalarField& values) const
{
    scalarField sums(base_->nCells(), 0);
    forAll(values, c)
    {
        sums[leaves_->cell()[c]] += values[c];
    }
    return sums;
}

Foam::labelList Foam::mpm::adaptiveMesh::ofCells(const labelUList& values) const
{
    return labelList(UIndirectList<label>(values, leaves_->cell()));
}

void Foam::mpm::adaptiveMesh::write(const fileName& instance)
{
    // Old times are removed: each must have its mesh
    const word purge("purgeWrite");
    const bool purged = mesh_.time().controlDict().getOrDefault<label>(purge, 0) > 0;
    if (!(changed_ || (purged && baseWritten_)))
    {
        return;
    }
    if (purged && distribution_)
    {
        baseWritten_ = false;
    }
    if (!baseWritten_ && distribution_)
    {
        distribution_->write(word(instance));
    }
    else if (!baseWritten_)
    {
        const fileName first(base_->facesInstance());
        base_->setInstance(first);
        base_->write();
        base_->setInstance(first, IOobject::NO_WRITE);
    }
    baseWritten_ = true;
    mesh_.setInstance(instance);
    mesh_.write();
    mesh_.setInstance(instance, IOobject::NO_WRITE);
    labelIOList(
        IOobject(
            "cellLevel", mesh_.facesInstance(), polyMesh::meshSubDir, mesh_, IOobject::NO_READ,
            IOobject::NO_WRITE, false),
        leaves_->level())
        .write();
    changed_ = false;
}
