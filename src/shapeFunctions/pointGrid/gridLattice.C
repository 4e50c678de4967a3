// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "gridLattice.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::gridLattice::sizeLattice()
{
    const polyMesh& mesh = mesh_;

    // Cells on the window with one ghost ring
    label nLattice = 1, nLatticeNodes = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        if (refused_.empty()
            && scalar(nLatticeNodes) * (nCells_[d] + 3) > 50.0 * mesh.nCells() + 1e6)
        {
            refused_ = "the cells fill too little of their common lattice";
        }
        nLattice *= refused_.empty() ? nCells_[d] + 2 : 1;
        nLatticeNodes *= refused_.empty() ? nCells_[d] + 3 : 1;
    }
    if (anyRefusal())
    {
        return false;
    }
    latticeCell_.setSize(nLattice, -1);
    latticeNode_.setSize(nLatticeNodes, -1);
    return true;
}

Foam::label Foam::mpm::gridLattice::latticeIndex(const label* ijk, const label extra) const
{
    label n = ijk[0], stride = 1;
    for (int d = 1; d < nDim_; ++d)
    {
        stride *= nCells_[d - 1] + extra;
        n += stride * ijk[d];
    }
    return n;
}

void Foam::mpm::gridLattice::placeInLattice(const label* ijk, const label celli, const label* nodes)
{
    const label nc = label(1) << nDim_;
    latticeCell_[latticeIndex(ijk, 2)] = celli;
    for (label n = 0; n < nc; ++n)
    {
        label corner[3] = {0, 0, 0};
        for (int d = 0; d < nDim_; ++d)
        {
            corner[d] = ijk[d] + ((n >> d) & 1);
        }
        latticeNode_[latticeIndex(corner, 3)] = nodes[n];
    }
}

void Foam::mpm::gridLattice::placeGhosts(gridNodes& nodes, ghostCells& ghosts)
{
    const polyMesh& mesh = mesh_;
    const label nc = label(1) << nDim_;

    // Their neighbours: ghosts, and own cells across cyclic sides
    DynamicList<label> ghostNodes;
    const std::unordered_map<int64_t, label> places(latticeGhosts(nodes, ghosts, ghostNodes));
    const int nAround = nDim_ == 1 ? 3 : nDim_ == 2 ? 9 : 27;

    forAll(mesh.cells(), celli)
    {
        for (int n = 0; n < nAround; ++n)
        {
            label at[3] = {0, 0, 0}, own[3] = {0, 0, 0};
            int rest = n;
            bool inWindow = true;
            for (int d = 0; d < nDim_; ++d)
            {
                own[d] = at[d] = ijk(celli, d) + rest % 3 - 1;
                rest /= 3;
                if (period_[d] > 0 && nCells_[d] == nAllCells_[d])
                {
                    own[d] = (at[d] - 1 + nCells_[d]) % nCells_[d] + 1;
                }
                inWindow = inWindow && own[d] >= 1 && own[d] <= nCells_[d];
            }
            if (latticeCell_[latticeIndex(at, 2)] >= 0)
            {
                continue;
            }
            const label c = inWindow ? latticeCell_[latticeIndex(own, 2)] : -1;
            if (c >= 0 && c < mesh_.nCells())
            {
                placeInLattice(at, c, cells_.corners(c));
                continue;
            }
            const int64_t all = places.empty() ? -1 : allIndex(at);
            const auto iter = all < 0 ? places.end() : places.find(all);
            if (iter != places.end())
            {
                const label g = iter->second;
                placeInLattice(at, g, ghostNodes.cdata() + nc * (g - mesh_.nCells()));
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gridLattice::gridLattice(
    const polyMesh& mesh, const gridAxes& axes, const hexCells& cells, gridNodes& nodes,
    ghostCells& ghosts) :
    mesh_(mesh),
    axes_(axes),
    cells_(cells),
    nDim_(axes.nDim()),
    nCells_{0, 0, 0},
    window_{0, 0, 0},
    nAllCells_{0, 0, 0},
    period_{0, 0, 0},
    lowest_{0, 0, 0},
    highest_{0, 0, 0},
    cellIjk_(nDim_ * mesh.nCells())
{
    const cellExtents e(extents());
    refuseSkewed(e);
    if (anyRefusal())
    {
        return;
    }

    // Planes of all processors and the window of this one
    for (int d = 0; d < nDim_; ++d)
    {
        makePlanes(d, e);
    }
    if (anyRefusal() || !sizeLattice())
    {
        return;
    }

    forAll(mesh.cells(), celli)
    {
        const label* ijk = cellIjk_.cdata() + nDim_ * celli;
        if (latticeCell_[latticeIndex(ijk, 2)] >= 0)
        {
            refused_ = "cells overlap";
        }
        placeInLattice(ijk, celli, cells.corners(celli));
    }
    if (anyRefusal())
    {
        return;
    }
    placeGhosts(nodes, ghosts);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::gridLattice::sameWidth() const
{
    // Over planes of all processors: the same number on each
    bool same = true;
    scalar shortest = GREAT;
    for (int d = 0; d < nDim_; ++d)
    {
        scalar least = GREAT, most = 0;
        for (label i = 1; i <= nCells_[d]; ++i)
        {
            const scalar h = planes_[d][i + 1] - planes_[d][i];
            least = min(least, h);
            most = max(most, h);
        }
        reduce(least, minOp<scalar>());
        reduce(most, maxOp<scalar>());
        same = same && most < (1 + 1e-9) * least;
        shortest = min(shortest, least);
    }
    return same ? shortest : 0;
}

void Foam::mpm::gridLattice::addGhostPositions(const labelList& points, pointField& x) const
{
    label at[3] = {0, 0, 0};
    label nPlanes[3] = {1, 1, 1};
    for (int d = 0; d < nDim_; ++d)
    {
        nPlanes[d] = planes_[d].size();
    }
    for (at[2] = 0; at[2] < nPlanes[2]; ++at[2])
    {
        for (at[1] = 0; at[1] < nPlanes[1]; ++at[1])
        {
            for (at[0] = 0; at[0] < nPlanes[0]; ++at[0])
            {
                const label n = nodeAt(at);
                if (n >= 0 && points[n] < 0)
                {
                    for (int d = 0; d < nDim_; ++d)
                    {
                        x[n][axes_.direction(d)] = planes_[d][at[d]];
                    }
                }
            }
        }
    }
}

Foam::label Foam::mpm::gridLattice::locate(const label from, scalar* x) const
{
    label at[3] = {0, 0, 0};
    scalar beyond[3] = {0, 0, 0};
    for (int d = 0; d < nDim_; ++d)
    {
        const scalarList& X = planes_[d];
        const label n = nCells_[d];

        // Where to look: beyond the window of a processor that has not
        // the whole period, ghosts repeat the planes
        const bool whole = n == nAllCells_[d];
        scalar y = x[d];
        if (period_[d] > 0)
        {
            // Once is enough for a point that moves less than the domain
            if (x[d] < lowest_[d])
            {
                x[d] += period_[d];
                // Rounding may land on the closed end: that is the start
                if (x[d] >= highest_[d])
                {
                    y = x[d] = lowest_[d];
                }
            }
            else if (x[d] >= highest_[d])
            {
                x[d] = max(x[d] - period_[d], lowest_[d]);
            }
            y = whole ? x[d] : y;
        }
        if (!(y >= X[0] && y <= X[n + 2]))
        {
            return -1;
        }
        label i = from >= 0
            ? ijk(from, d)
            : label(std::upper_bound(X.begin(), X.begin() + n + 3, y) - X.begin()) - 1;
        i = min(max(i, label(0)), n + 1);
        while (i > 0 && y < X[i])
            --i;
        while (i < n + 1 && y >= X[i + 1])
            ++i;
        at[d] = i;
        beyond[d] = y;
    }

    const label celli = cellAt(at);
    if (celli >= 0)
    {
        return celli;
    }

    // On the upper plane of the mesh: no cell above, outermost and closed
    for (int n = 1; n < (1 << nDim_); ++n)
    {
        label lower[3] = {at[0], at[1], at[2]};
        bool possible = true;
        for (int d = 0; d < nDim_; ++d)
        {
            if ((n >> d) & 1)
            {
                possible = possible && at[d] > 0 && beyond[d] == planes_[d][at[d]];
                --lower[d];
            }
        }
        if (possible && cellAt(lower) >= 0)
        {
            return cellAt(lower);
        }
    }
    return -1;
}

Foam::label Foam::mpm::gridLattice::wallFace(const label celli, const int d, const int side) const
{
    const label dir = axes_.direction(d);
    for (const label facei : mesh_.cells()[celli])
    {
        if (mesh_.isInternalFace(facei))
        {
            continue;
        }
        const vector n(normalised(mesh_.faceAreas()[facei]));
        if ((side ? n[dir] : -n[dir]) > 0.7)
        {
            return facei;
        }
    }
    return -1;
}

bool Foam::mpm::gridLattice::leaves(const label from, scalar* x, wayOut& out) const
{
    label celli = from;
    for (int step = 0; step < 100 && celli >= 0 && celli < mesh_.nCells(); ++step)
    {
        label next = -1;
        int nextD = 0, nextSide = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            const label i = ijk(celli, d);
            for (int side = 0; side < 2; ++side)
            {
                const scalar beyond = side ? x[d] - planes_[d][i + 1] : planes_[d][i] - x[d];
                if (!(beyond > 0))
                {
                    continue;
                }
                if (walls(celli) >> (2 * d + side) & 1)
                {
                    out.cell = celli;
                    out.face = wallFace(celli, d, side);
                    out.beyond = beyond;
                    std::fill_n(out.normal, 3, 0);
                    out.normal[d] = side ? 1 : -1;
                    return out.face >= 0;
                }
                next = neighbour(celli, d, side);
                nextD = d;
                nextSide = side;
            }
        }
        if (next >= 0)
        {
            cells_.shift(celli, nextD, nextSide, x);
        }
        celli = next;
    }
    return false;
}
