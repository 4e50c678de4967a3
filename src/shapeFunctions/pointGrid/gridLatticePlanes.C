// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "gridLattice.H"
#include "ListOps.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::gridLattice::cellExtents Foam::mpm::gridLattice::extents() const
{
    // Corners of a cell are taken from its own points: on a cyclic side a node
    // has two positions
    const polyMesh& mesh = mesh_;
    const pointField& points = mesh.points();
    cellExtents e{
        scalarField(nDim_ * mesh.nCells()),
        scalarField(nDim_ * mesh.nCells()),
        {GREAT, GREAT, GREAT}};
    forAll(mesh.cells(), celli)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            scalar lo = GREAT, hi = -GREAT;
            for (const label p : mesh.cellPoints()[celli])
            {
                lo = min(lo, points[p][axes_.direction(d)]);
                hi = max(hi, points[p][axes_.direction(d)]);
            }
            e.lower[nDim_ * celli + d] = lo;
            e.upper[nDim_ * celli + d] = hi;
            e.shortest[d] = min(e.shortest[d], hi - lo);
        }
    }
    for (int d = 0; d < nDim_; ++d)
    {
        reduce(e.shortest[d], minOp<scalar>());
    }
    return e;
}

void Foam::mpm::gridLattice::refuseSkewed(const cellExtents& e)
{
    // Each point must lie on the lower or upper plane of each cell
    const polyMesh& mesh = mesh_;
    const pointField& points = mesh.points();
    forAll(mesh.cells(), celli)
    {
        for (const label p : mesh.cellPoints()[celli])
        {
            for (int d = 0; d < nDim_; ++d)
            {
                const scalar x = points[p][axes_.direction(d)];
                const scalar tol = 1e-4 * e.shortest[d];
                if (refused_.empty() && mag(x - e.lower[nDim_ * celli + d]) > tol
                    && mag(x - e.upper[nDim_ * celli + d]) > tol)
                {
                    OStringStream s;
                    s << "cell " << celli << " at " << mesh.cellCentres()[celli]
                      << " is not a box along the axes";
                    refused_ = s.str();
                }
            }
        }
    }
}

void Foam::mpm::gridLattice::makePlanes(const int d, const cellExtents& e)
{
    const polyMesh& mesh = mesh_;
    scalarList x(2 * mesh.nCells());
    forAll(mesh.cells(), celli)
    {
        x[2 * celli] = e.lower[nDim_ * celli + d];
        x[2 * celli + 1] = e.upper[nDim_ * celli + d];
    }
    std::sort(x.begin(), x.end());
    const scalarList all(allPlanes(x, e.shortest[d]));

    const auto indexOf = [&](const scalar xi)
    {
        const auto iter = std::upper_bound(all.begin(), all.end(), xi + 1e-2 * e.shortest[d]);
        return label(iter - all.begin());
    };

    const label first = x.size() ? indexOf(x.first()) : 1;
    const label last = x.size() ? indexOf(x.last()) : 1;
    window_[d] = first - 1;
    nCells_[d] = last - first;
    nAllCells_[d] = all.size() - 1;
    lowest_[d] = all.first();
    highest_[d] = all.last();

    forAll(mesh.cells(), celli)
    {
        const label i = indexOf(e.lower[nDim_ * celli + d]);
        const label j = indexOf(e.upper[nDim_ * celli + d]);
        if (j != i + 1 && refused_.empty())
        {
            OStringStream s;
            s << "cell " << celli << " at " << mesh.cellCentres()[celli]
              << " spans planes of other cells";
            refused_ = s.str();
        }
        cellIjk_[nDim_ * celli + d] = i - window_[d];
    }

    findPeriod(d);
    addGhostPlanes(d, all);
}

void Foam::mpm::gridLattice::findPeriod(const int d)
{
    // Cyclic: the lowest and highest plane are one
    label nCyclic = 0, nSide = 0;
    forAll(mesh_.cells(), celli)
    {
        if (window_[d] == 0 && ijk(celli, d) == 1)
        {
            ++nSide;
            if (cells_.neighbour(celli, d, 0) >= 0)
            {
                ++nCyclic;
            }
        }
    }
    reduce(nCyclic, sumOp<label>());
    reduce(nSide, sumOp<label>());
    if (nCyclic && nCyclic != nSide)
    {
        refused_ = "a cyclic patch covers only a part of its side";
    }
    period_[d] = nCyclic ? highest_[d] - lowest_[d] : 0;
}

void Foam::mpm::gridLattice::addGhostPlanes(const int d, const scalarList& all)
{
    // One ghost plane at each end: the next plane, repeated on a cyclic
    // side, or mirrored
    planes_[d].setSize(nCells_[d] + 3);
    const label nAll = nAllCells_[d];
    for (label i = 0; i < nCells_[d] + 3; ++i)
    {
        const label j = window_[d] + i - 1;
        planes_[d][i] = j < 0 ? (period_[d] > 0 ? all[nAll - 1] - period_[d] : 2 * all[0] - all[1])
            : j > nAll ? (period_[d] > 0 ? all[1] + period_[d] : 2 * all[nAll] - all[nAll - 1])
                       : all[j];
    }
    invWidth_[d].setSize(nCells_[d] + 2);
    for (label i = 0; i < nCells_[d] + 2; ++i)
    {
        invWidth_[d][i] = 1 / (planes_[d][i + 1] - planes_[d][i]);
    }
}

std::unordered_map<int64_t, Foam::label> Foam::mpm::gridLattice::latticeGhosts(
    gridNodes& nodes, ghostCells& ghosts, DynamicList<label>& ghostNodes)
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
        const labelList cells(nodes.cellsAtCoupled());
        labelList& mine = published[Pstream::myProcNo()];
        mine.setSize(row * cells.size());
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
                *to++ = nodes.keys()[cells_.corners(celli)[n]];
            }
        }
    }
    Pstream::gatherList(published);
    Pstream::scatterList(published);

    Map<label> nodeOfKey(2 * nodes.size());
    forAll(nodes.keys(), n)
    {
        nodeOfKey.insert(nodes.keys()[n], n);
    }
    const label nOwn = nodes.size();

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
            const label g = ghosts.add(proci, rows[at]);
            label ijk[3] = {0, 0, 0};
            for (int d = 0; d < nDim_; ++d)
            {
                ijk[d] = rows[at + 1 + d] - window_[d];
            }
            place[allIndex(ijk)] = g;

            ghostNodes.setSize(nc * ghosts.size(), -1);
            nodes.addGhost(keys, nc, nodeOfKey, ghostNodes.data() + nc * (g - mesh_.nCells()));
        }
    }
    nodes.closeGhosts();

    return place;
}

Foam::scalarList Foam::mpm::gridLattice::allPlanes(const UList<scalar>& own, const scalar h)
{
    // The smallest value stands for the plane, so that both cells at a plane
    // compare with the same number
    const auto cluster = [h](const UList<scalar>& x)
    {
        DynamicList<scalar> planes;
        for (const scalar xi : x)
        {
            if (planes.empty() || xi > planes.last() + 1e-3 * h)
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

bool Foam::mpm::gridLattice::anyRefusal()
{
    List<string> reasons(Pstream::nProcs());
    reasons[Pstream::myProcNo()] = refused_;
    Pstream::gatherList(reasons);
    Pstream::scatterList(reasons);
    for (const string& reason : reasons)
    {
        if (!reason.empty())
        {
            refused_ = reason;
            return true;
        }
    }
    return false;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int64_t Foam::mpm::gridLattice::allIndex(const label* ijk) const
{
    int64_t n = 0, stride = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        // From 1 on
        label i = window_[d] + ijk[d];
        if (period_[d] > 0)
        {
            i = (i - 1 + 2 * nAllCells_[d]) % nAllCells_[d] + 1;
        }
        if (i < 1 || i > nAllCells_[d])
        {
            return -1;
        }
        n += stride * (i - 1);
        stride *= nAllCells_[d];
    }
    return n;
}
