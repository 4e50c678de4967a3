// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "gridNodes.H"
#include "processorPolyPatch.H"
#include "PstreamBuffers.H"
#include "globalIndex.H"
#include "syncTools.H"
#include "IndirectList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gridNodes::makeShared(const labelUList& root)
{
    const polyMesh& mesh = mesh_;

    // The smallest number of all points that are one node, on all processors
    const globalIndex numbering(mesh.nPoints());
    labelList key(mesh.nPoints());
    forAll(key, pointi)
    {
        key[pointi] = numbering.toGlobal(root[pointi]);
    }
    bool changed = true;
    while (changed)
    {
        const labelList before(key);
        syncTools::syncPointList(mesh, key, minEqOp<label>(), labelMax);

        labelList least(mesh.nPoints(), labelMax);
        forAll(key, pointi)
        {
            least[root[pointi]] = min(least[root[pointi]], key[pointi]);
        }
        forAll(key, pointi)
        {
            key[pointi] = least[root[pointi]];
        }
        changed = returnReduce(key != before, orOp<bool>());
    }

    // Nodes in the order of their first point
    Map<label> nodeOfKey(2 * mesh.nPoints());
    pointToNode_.setSize(mesh.nPoints());
    DynamicList<label> first(mesh.nPoints());
    key_.clear();
    forAll(key, pointi)
    {
        const auto iter = nodeOfKey.cfind(key[pointi]);
        if (iter.good())
        {
            pointToNode_[pointi] = iter.val();
        }
        else
        {
            pointToNode_[pointi] = first.size();
            nodeOfKey.insert(key[pointi], first.size());
            key_.append(key[pointi]);
            first.append(pointi);
        }
    }
    nodePoint_.transfer(first);
}

Foam::labelList Foam::mpm::gridNodes::coupled() const
{
    bitSet coupled(size());
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<processorPolyPatch>(pp))
        {
            for (const label pointi : pp.meshPoints())
            {
                coupled.set(pointToNode_[pointi]);
            }
        }
    }
    return coupled.sortedToc();
}

Foam::labelList Foam::mpm::gridNodes::candidates(const label reach) const
{
    bitSet candidate(size());
    candidate.set(coupled());
    if (reach)
    {
        for (const label celli : cellsAtCoupled())
        {
            for (const label n : ofCell(celli))
            {
                candidate.set(n);
            }
        }
        for (const label node : ofGhosts_)
        {
            candidate.set(node);
        }
    }
    return candidate.sortedToc();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::mpm::gridNodes::cellsAtCoupled() const
{
    bitSet coupled(size());
    coupled.set(this->coupled());

    DynamicList<label> cells;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        bool touches = false;
        for (const label n : ofCell(celli))
        {
            touches = touches || coupled.test(n);
        }
        if (touches)
        {
            cells.append(celli);
        }
    }
    return labelList(std::move(cells));
}

void Foam::mpm::gridNodes::addGhost(
    const label* keys, const label n, Map<label>& nodeOfKey, label* nodes)
{
    for (label i = 0; i < n; ++i)
    {
        const auto iter = nodeOfKey.cfind(keys[i]);
        label node = iter.good() ? iter.val() : -1;
        if (node < 0)
        {
            node = key_.size();
            nodeOfKey.insert(keys[i], node);
            key_.append(keys[i]);
        }
        nodes[i] = node;
        ofGhosts_.append(node);
    }
}

void Foam::mpm::gridNodes::closeGhosts() { nodePoint_.setSize(key_.size(), -1); }

void Foam::mpm::gridNodes::addRing()
{
    if (!Pstream::parRun())
    {
        return;
    }

    // To each neighbour the nodes of the cells at the nodes shared with it
    const sharedNodes& common = shared(0);
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(common.procs(), i)
    {
        labelHashSet around;
        for (const label node : common.with(i))
        {
            for (const label celli : cellsOf(node))
            {
                for (const label n : ofCell(celli))
                {
                    around.insert(n);
                }
            }
        }
        const labelList nodes(around.sortedToc());
        UOPstream to(common.procs()[i], buffers);
        to << labelList(labelUIndList(key_, nodes)()) << pointField(positions(), nodes);
    }
    buffers.finishedSends();

    Map<label> nodeOfKey(2 * size());
    forAll(key_, n)
    {
        nodeOfKey.insert(key_[n], n);
    }
    for (const label proci : common.procs())
    {
        UIPstream from(proci, buffers);
        const labelList keys(from);
        const pointField x(from);
        labelList nodes(keys.size());
        const label nBefore = key_.size();
        addGhost(keys.cdata(), keys.size(), nodeOfKey, nodes.data());
        forAll(nodes, k)
        {
            if (nodes[k] >= nBefore)
            {
                ghostPoints_.append(x[k]);
            }
        }
    }
    closeGhosts();

    // Made with fewer nodes
    cellStart_.clear();
    cells_.clear();
}

const Foam::mpm::sharedNodes& Foam::mpm::gridNodes::shared(const label reach) const
{
    if (!shared_[reach])
    {
        labelList nodes, keys;
        if (Pstream::parRun())
        {
            nodes = candidates(reach);
            keys = labelUIndList(key_, nodes)();
        }
        shared_[reach].reset(new sharedNodes(nodes, keys));
    }
    return *shared_[reach];
}
