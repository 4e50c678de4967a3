/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexGrid.H"
#include "processorPolyPatch.H"
#include "globalIndex.H"
#include "syncTools.H"
#include "bitSet.H"
#include "ListOps.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::hexGrid::makeSharedNodes(const labelUList& root)
{
    const polyMesh& mesh = this->mesh();

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
    Map<label> nodeOfKey(2*mesh.nPoints());
    pointToNode_.setSize(mesh.nPoints());
    DynamicList<label> first(mesh.nPoints());
    nodeKey_.clear();
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
            nodeKey_.append(key[pointi]);
            first.append(pointi);
        }
    }
    nodePoint_.transfer(first);
}


Foam::labelList Foam::mpm::hexGrid::coupledNodes() const
{
    bitSet coupled(nNodes());
    for (const polyPatch& pp : mesh().boundaryMesh())
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


Foam::label Foam::mpm::hexGrid::ghost(const label proci, const label celli)
{
    label& g = ghostOf_(labelPair(proci, celli), label(-1));
    if (g < 0)
    {
        g = nCells() + ghostProc_.size();
        ghostProc_.append(proci);
        ghostCell_.append(celli);
    }
    return g;
}


Foam::labelList Foam::mpm::hexGrid::cellsAtCoupledNodes() const
{
    bitSet coupled(nNodes());
    coupled.set(coupledNodes());

    const label nc = label(1) << nDim_;
    DynamicList<label> cells;
    for (label celli = 0; celli < nCells(); ++celli)
    {
        bool touches = false;
        for (label n = 0; n < nc; ++n)
        {
            touches = touches || coupled.test(corners(celli)[n]);
        }
        if (touches)
        {
            cells.append(celli);
        }
    }
    return labelList(std::move(cells));
}


std::unordered_map<int64_t, Foam::label> Foam::mpm::hexGrid::latticeGhosts()
{
    std::unordered_map<int64_t, label> place;
    if (!Pstream::parRun())
    {
        return place;
    }

    // Label, place in the lattice and keys of the nodes of each cell that
    // others may want
    const label nc = label(1) << nDim_;
    const label row = 1 + nDim_ + nc;
    labelListList published(Pstream::nProcs());
    {
        const labelList cells(cellsAtCoupledNodes());
        labelList& mine = published[Pstream::myProcNo()];
        mine.setSize(row*cells.size());
        label* to = mine.data();
        for (const label celli : cells)
        {
            *to++ = celli;
            for (int d = 0; d < nDim_; ++d)
            {
                *to++ = window_[d] + ijk(celli, d);
            }
            for (label n = 0; n < nc; ++n)
            {
                *to++ = nodeKey_[corners(celli)[n]];
            }
        }
    }
    Pstream::gatherList(published);
    Pstream::scatterList(published);

    Map<label> nodeOfKey(2*nNodes());
    forAll(nodeKey_, n)
    {
        nodeOfKey.insert(nodeKey_[n], n);
    }
    const label nOwn = nNodes();

    forAll(published, proci)
    {
        if (proci == Pstream::myProcNo())
        {
            continue;
        }
        const labelList& rows = published[proci];
        for (label at = 0; at < rows.size(); at += row)
        {
            const label* keys = rows.cdata() + at + 1 + nDim_;
            bool touches = false;
            for (label n = 0; n < nc; ++n)
            {
                const auto iter = nodeOfKey.cfind(keys[n]);
                touches = touches || (iter.good() && iter.val() < nOwn);
            }
            if (!touches)
            {
                continue;
            }
            const label g = ghost(proci, rows[at]);
            label ijk[3] = {0, 0, 0};
            for (int d = 0; d < nDim_; ++d)
            {
                ijk[d] = rows[at + 1 + d] - window_[d];
            }
            place[allIndex(ijk)] = g;

            ghostNodes_.setSize(nc*ghostProc_.size(), -1);
            for (label n = 0; n < nc; ++n)
            {
                const auto iter = nodeOfKey.cfind(keys[n]);
                label node = iter.good() ? iter.val() : -1;
                if (node < 0)
                {
                    node = nodeKey_.size();
                    nodeOfKey.insert(keys[n], node);
                    nodeKey_.append(keys[n]);
                }
                ghostNodes_[nc*(g - nCells()) + n] = node;
            }
        }
    }
    nodePoint_.setSize(nodeKey_.size(), -1);

    return place;
}


int64_t Foam::mpm::hexGrid::allIndex(const label* ijk) const
{
    int64_t n = 0, stride = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        // From 1 on
        label i = window_[d] + ijk[d];
        if (period_[d] > 0)
        {
            i = (i - 1 + 2*nAllCells_[d]) % nAllCells_[d] + 1;
        }
        if (i < 1 || i > nAllCells_[d])
        {
            return -1;
        }
        n += stride*(i - 1);
        stride *= nAllCells_[d];
    }
    return n;
}


Foam::scalarList Foam::mpm::hexGrid::allPlanes
(
    const UList<scalar>& own,
    const scalar h
)
{
    // The smallest value stands for the plane, so that both cells at a plane
    // compare with the same number
    const auto cluster = [h](const UList<scalar>& x)
    {
        DynamicList<scalar> planes;
        for (const scalar xi : x)
        {
            if (planes.empty() || xi > planes.last() + 1e-3*h)
            {
                planes.append(xi);
            }
        }
        return scalarList(std::move(planes));
    };

    List<scalarList> planes(Pstream::nProcs());
    planes[Pstream::myProcNo()] = cluster(own);
    Pstream::gatherList(planes);
    Pstream::scatterList(planes);

    DynamicList<scalar> all;
    for (const scalarList& x : planes)
    {
        all.append(x);
    }
    std::sort(all.begin(), all.end());
    return cluster(all);
}


bool Foam::mpm::hexGrid::anyRefusal()
{
    List<string> reasons(Pstream::nProcs());
    reasons[Pstream::myProcNo()] = noLattice_;
    Pstream::gatherList(reasons);
    Pstream::scatterList(reasons);
    for (const string& reason : reasons)
    {
        if (!reason.empty())
        {
            noLattice_ = reason;
            return true;
        }
    }
    return false;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::mpm::hexGrid::candidateNodes(const label reach) const
{
    bitSet candidate(nNodes());
    candidate.set(coupledNodes());
    if (reach)
    {
        const label nc = label(1) << nDim_;
        for (const label celli : cellsAtCoupledNodes())
        {
            for (label n = 0; n < nc; ++n)
            {
                candidate.set(corners(celli)[n]);
            }
        }
        for (const label node : ghostNodes_)
        {
            if (node >= 0)
            {
                candidate.set(node);
            }
        }
    }
    return candidate.sortedToc();
}


const Foam::mpm::sharedNodes&
Foam::mpm::hexGrid::shared(const label reach) const
{
    if (!shared_[reach])
    {
        shared_[reach].reset(new sharedNodes(*this, reach));
    }
    return *shared_[reach];
}


Foam::labelList Foam::mpm::hexGrid::ghostProcs() const
{
    labelHashSet procs;
    procs.insert(ghostProc_);
    return procs.sortedToc();
}

// ************************************************************************* //
