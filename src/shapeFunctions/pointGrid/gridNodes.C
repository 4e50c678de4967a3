// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "gridNodes.H"
#include "emptyPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "wedgePolyPatch.H"
#include "EdgeMap.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sets of joined labels; the smallest label stands for the set
class joinedLabels
{
    labelList parent_;

public:
    explicit joinedLabels(const label n) : parent_(identity(n)) {}

    label root(label i)
    {
        while (parent_[i] != i)
        {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    void join(const label i, const label j)
    {
        const label a = root(i), b = root(j);
        parent_[max(a, b)] = min(a, b);
    }
};

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gridNodes::makeNodes(const gridAxes& axes)
{
    const polyMesh& mesh = mesh_;
    const int nDim = axes.nDim();
    const bitSet isEmpty(emptyFaces(mesh));

    joinedLabels joined(mesh.nPoints());

    if (nDim == 1)
    {
        // A cross-section is a face that is not empty
        forAll(mesh.faces(), facei)
        {
            if (!isEmpty.test(facei))
            {
                const face& f = mesh.faces()[facei];
                for (label i = 1; i < f.size(); ++i)
                {
                    joined.join(f[0], f[i]);
                }
            }
        }
    }
    else if (nDim == 2)
    {
        // Front and back are joined by the edges that lie in no empty (wedge)
        // face. On the axis of a wedge they are one point
        EdgeMap<bool> inEmpty(4 * mesh.nCells());
        forAll(mesh.faces(), facei)
        {
            if (isEmpty.test(facei))
            {
                const face& f = mesh.faces()[facei];
                forAll(f, i)
                {
                    inEmpty.insert(f.faceEdge(i), true);
                }
            }
        }
        forAll(mesh.faces(), facei)
        {
            if (!isEmpty.test(facei))
            {
                const face& f = mesh.faces()[facei];
                forAll(f, i)
                {
                    const edge e(f.faceEdge(i));
                    if (!inEmpty.found(e))
                    {
                        joined.join(e.first(), e.second());
                    }
                }
            }
        }
    }

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(pp))
        {
            const cyclicPolyPatch& cpp = refCast<const cyclicPolyPatch>(pp);
            if (!cpp.owner())
            {
                continue;
            }
            if (!cpp.parallel())
            {
                FatalErrorInFunction << "Cyclic patch " << pp.name() << " is rotational;"
                                     << " material points need a translational one."
                                     << exit(FatalError);
            }
            const labelList& own = cpp.meshPoints();
            const labelList& nbr = cpp.neighbPatch().meshPoints();
            for (const edge& e : cpp.coupledPoints())
            {
                joined.join(own[e[0]], nbr[e[1]]);
            }
        }
    }

    if (Pstream::parRun())
    {
        labelList root(mesh.nPoints());
        forAll(root, pointi)
        {
            root[pointi] = joined.root(pointi);
        }
        makeShared(root);
        return;
    }

    // Compact numbering in the order of the first point
    pointToNode_.setSize(mesh.nPoints());
    DynamicList<label> first(mesh.nPoints());
    forAll(pointToNode_, pointi)
    {
        const label root = joined.root(pointi);
        if (root == pointi)
        {
            pointToNode_[pointi] = first.size();
            first.append(pointi);
        }
        else
        {
            pointToNode_[pointi] = pointToNode_[root];
        }
    }
    nodePoint_.transfer(first);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gridNodes::gridNodes(const polyMesh& mesh, const gridAxes& axes) : mesh_(mesh)
{
    makeNodes(axes);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::bitSet Foam::mpm::gridNodes::emptyFaces(const polyMesh& mesh)
{
    bitSet isEmpty(mesh.nFaces());
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp))
        {
            forAll(pp, i)
            {
                isEmpty.set(pp.start() + i);
            }
        }
    }
    return isEmpty;
}

void Foam::mpm::gridNodes::setOfCells(const label n, labelList&& nodes)
{
    start_.setSize(mesh_.nCells() + 1);
    forAll(start_, celli)
    {
        start_[celli] = n * celli;
    }
    ofCells_.transfer(nodes);
}

void Foam::mpm::gridNodes::joinPoints()
{
    start_.setSize(mesh_.nCells() + 1);
    start_[0] = 0;
    DynamicList<label> nodes(8 * mesh_.nCells());
    labelHashSet had;
    forAll(mesh_.cells(), celli)
    {
        had.clear();
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            if (had.insert(pointToNode_[pointi]))
            {
                nodes.append(pointToNode_[pointi]);
            }
        }
        start_[celli + 1] = nodes.size();
    }
    ofCells_.transfer(nodes);
}

const Foam::SubList<Foam::label> Foam::mpm::gridNodes::cellsOf(const label node) const
{
    if (cellStart_.empty())
    {
        // A cell that has a node twice (cyclic) counts once
        cellStart_.setSize(size() + 1, 0);
        const auto forPairs = [&](const auto& f)
        {
            for (label celli = 0; celli < mesh_.nCells(); ++celli)
            {
                const SubList<label> nodes(ofCell(celli));
                forAll(nodes, i)
                {
                    bool first = true;
                    for (label j = 0; j < i; ++j)
                    {
                        first = first && nodes[j] != nodes[i];
                    }
                    if (first)
                    {
                        f(celli, nodes[i]);
                    }
                }
            }
        };
        forPairs([&](const label, const label n) { ++cellStart_[n + 1]; });
        for (label n = 0; n < size(); ++n)
        {
            cellStart_[n + 1] += cellStart_[n];
        }
        cells_.setSize(cellStart_.last());
        labelList next(cellStart_);
        forPairs([&](const label c, const label n) { cells_[next[n]++] = c; });
    }
    return SubList<label>(cells_, cellStart_[node + 1] - cellStart_[node], cellStart_[node]);
}

Foam::pointField Foam::mpm::gridNodes::positions() const
{
    pointField x(size(), point(Zero));
    const label nOwn = size() - ghostPoints_.size();
    forAll(x, n)
    {
        if (nodePoint_[n] >= 0)
        {
            x[n] = mesh_.points()[nodePoint_[n]];
        }
        else if (ghostPoints_.size())
        {
            x[n] = ghostPoints_[n - nOwn];
        }
    }
    return x;
}
