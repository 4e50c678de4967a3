/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexGrid.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::hexGrid::cellExtents Foam::mpm::hexGrid::extents() const
{
    // Corners of a cell are taken from its own points: on a cyclic side a node
    // has two positions
    const polyMesh& mesh = this->mesh();
    const pointField& points = mesh.points();
    cellExtents e
    {
        scalarField(nDim_*mesh.nCells()),
        scalarField(nDim_*mesh.nCells()),
        {GREAT, GREAT, GREAT}
    };
    forAll(mesh.cells(), celli)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            scalar lo = GREAT, hi = -GREAT;
            for (const label p : mesh.cellPoints()[celli])
            {
                lo = min(lo, points[p][dir_[d]]);
                hi = max(hi, points[p][dir_[d]]);
            }
            e.lower[nDim_*celli + d] = lo;
            e.upper[nDim_*celli + d] = hi;
            e.shortest[d] = min(e.shortest[d], hi - lo);
        }
    }
    for (int d = 0; d < nDim_; ++d)
    {
        reduce(e.shortest[d], minOp<scalar>());
    }
    return e;
}


void Foam::mpm::hexGrid::refuseSkewed(const cellExtents& e)
{
    // Each point must lie on the lower or upper plane of each cell
    const polyMesh& mesh = this->mesh();
    const pointField& points = mesh.points();
    forAll(mesh.cells(), celli)
    {
        for (const label p : mesh.cellPoints()[celli])
        {
            for (int d = 0; d < nDim_; ++d)
            {
                const scalar x = points[p][dir_[d]];
                const scalar tol = 1e-4*e.shortest[d];
                if
                (
                    noLattice_.empty()
                 && mag(x - e.lower[nDim_*celli + d]) > tol
                 && mag(x - e.upper[nDim_*celli + d]) > tol
                )
                {
                    OStringStream s;
                    s   << "cell " << celli << " at "
                        << mesh.cellCentres()[celli]
                        << " is not a box along the axes";
                    noLattice_ = s.str();
                }
            }
        }
    }
}


void Foam::mpm::hexGrid::makePlanes(const int d, const cellExtents& e)
{
    const polyMesh& mesh = this->mesh();
    scalarList x(2*mesh.nCells());
    forAll(mesh.cells(), celli)
    {
        x[2*celli] = e.lower[nDim_*celli + d];
        x[2*celli + 1] = e.upper[nDim_*celli + d];
    }
    std::sort(x.begin(), x.end());
    const scalarList all(allPlanes(x, e.shortest[d]));

    const auto indexOf = [&](const scalar xi)
    {
        const auto iter = std::upper_bound
        (
            all.begin(),
            all.end(),
            xi + 1e-2*e.shortest[d]
        );
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
        const label i = indexOf(e.lower[nDim_*celli + d]);
        const label j = indexOf(e.upper[nDim_*celli + d]);
        if (j != i + 1 && noLattice_.empty())
        {
            OStringStream s;
            s   << "cell " << celli << " at "
                << mesh.cellCentres()[celli]
                << " spans planes of other cells";
            noLattice_ = s.str();
        }
        cellIjk_[nDim_*celli + d] = i - window_[d];
    }

    findPeriod(d);
    addGhostPlanes(d, all);
}


void Foam::mpm::hexGrid::findPeriod(const int d)
{
    // Cyclic: the lowest and highest plane are one
    label nCyclic = 0, nSide = 0;
    forAll(mesh().cells(), celli)
    {
        if (window_[d] == 0 && ijk(celli, d) == 1)
        {
            ++nSide;
            if (neighbour(celli, d, 0) >= 0)
            {
                ++nCyclic;
            }
        }
    }
    reduce(nCyclic, sumOp<label>());
    reduce(nSide, sumOp<label>());
    if (nCyclic && nCyclic != nSide)
    {
        noLattice_ = "a cyclic patch covers only a part of its side";
    }
    period_[d] = nCyclic ? highest_[d] - lowest_[d] : 0;
}


void Foam::mpm::hexGrid::addGhostPlanes(const int d, const scalarList& all)
{
    // One ghost plane at each end: the next plane, repeated on a cyclic
    // side, or mirrored
    planes_[d].setSize(nCells_[d] + 3);
    const label nAll = nAllCells_[d];
    for (label i = 0; i < nCells_[d] + 3; ++i)
    {
        const label j = window_[d] + i - 1;
        planes_[d][i] =
            j < 0
          ? (
                period_[d] > 0
              ? all[nAll - 1] - period_[d]
              : 2*all[0] - all[1]
            )
          : j > nAll
          ? (
                period_[d] > 0
              ? all[1] + period_[d]
              : 2*all[nAll] - all[nAll - 1]
            )
          : all[j];
    }
    invWidth_[d].setSize(nCells_[d] + 2);
    for (label i = 0; i < nCells_[d] + 2; ++i)
    {
        invWidth_[d][i] = 1/(planes_[d][i + 1] - planes_[d][i]);
    }
}


bool Foam::mpm::hexGrid::sizeLattice()
{
    const polyMesh& mesh = this->mesh();

    // Cells on the window with one ghost ring
    label nLattice = 1, nLatticeNodes = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        if
        (
            noLattice_.empty()
         && scalar(nLatticeNodes)*(nCells_[d] + 3) > 50.0*mesh.nCells() + 1e6
        )
        {
            noLattice_ = "the cells fill too little of their common lattice";
        }
        nLattice *= noLattice_.empty() ? nCells_[d] + 2 : 1;
        nLatticeNodes *= noLattice_.empty() ? nCells_[d] + 3 : 1;
    }
    if (anyRefusal())
    {
        return false;
    }
    latticeCell_.setSize(nLattice, -1);
    latticeNode_.setSize(nLatticeNodes, -1);
    return true;
}


Foam::label Foam::mpm::hexGrid::latticeIndex
(
    const label* ijk,
    const label extra
) const
{
    label n = ijk[0], stride = 1;
    for (int d = 1; d < nDim_; ++d)
    {
        stride *= nCells_[d - 1] + extra;
        n += stride*ijk[d];
    }
    return n;
}


void Foam::mpm::hexGrid::placeInLattice
(
    const label* ijk,
    const label celli,
    const label* nodes
)
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


void Foam::mpm::hexGrid::placeGhosts()
{
    const polyMesh& mesh = this->mesh();
    const label nc = label(1) << nDim_;

    // Their neighbours: ghosts, and own cells across cyclic sides
    const std::unordered_map<int64_t, label> ghosts(latticeGhosts());
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
            if (c >= 0 && c < nCells())
            {
                placeInLattice(at, c, corners(c));
                continue;
            }
            const int64_t all = ghosts.empty() ? -1 : allIndex(at);
            const auto iter = all < 0 ? ghosts.end() : ghosts.find(all);
            if (iter != ghosts.end())
            {
                const label g = iter->second;
                placeInLattice(at, g, ghostNodes_.cdata() + nc*(g - nCells()));
            }
        }
    }
}


void Foam::mpm::hexGrid::makeLattice()
{
    const polyMesh& mesh = this->mesh();
    cellIjk_.setSize(nDim_*mesh.nCells());

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
        const label* ijk = cellIjk_.cdata() + nDim_*celli;
        if (latticeCell_[latticeIndex(ijk, 2)] >= 0)
        {
            noLattice_ = "cells overlap";
        }
        placeInLattice(ijk, celli, corners(celli));
    }
    if (anyRefusal())
    {
        return;
    }
    placeGhosts();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::mpm::hexGrid::nodePositions() const
{
    pointField x(nNodes(), point(Zero));
    forAll(x, n)
    {
        if (nodePoint_[n] >= 0)
        {
            x[n] = mesh().points()[nodePoint_[n]];
        }
    }
    if (!hasLattice())
    {
        return x;
    }

    // Those of other processors' cells, by the planes of the lattice
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
                if (n >= 0 && nodePoint_[n] < 0)
                {
                    for (int d = 0; d < nDim_; ++d)
                    {
                        x[n][dir_[d]] =
                            planes_[d][at[d]];
                    }
                }
            }
        }
    }
    return x;
}

// ************************************************************************* //
