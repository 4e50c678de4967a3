/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexGrid.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::hexGrid::makeLattice()
{
    const polyMesh& mesh = this->mesh();
    const pointField& points = mesh.points();
    const label nc = label(1) << nDim_;

    // Shortest side and misalignment of the cells. Corners of a cell are
    // taken from its own points: on a cyclic side a node has two positions
    cellIjk_.setSize(nDim_*mesh.nCells());

    scalarField lower(nDim_*mesh.nCells()), upper(nDim_*mesh.nCells());
    scalar shortest[3] = {GREAT, GREAT, GREAT};

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
            lower[nDim_*celli + d] = lo;
            upper[nDim_*celli + d] = hi;
            shortest[d] = min(shortest[d], hi - lo);
        }
    }

    // Each point must lie on the lower or upper plane of each cell
    forAll(mesh.cells(), celli)
    {
        for (const label p : mesh.cellPoints()[celli])
        {
            for (int d = 0; d < nDim_; ++d)
            {
                const scalar x = points[p][dir_[d]];
                const scalar tol = 1e-4*shortest[d];
                if
                (
                    mag(x - lower[nDim_*celli + d]) > tol
                 && mag(x - upper[nDim_*celli + d]) > tol
                )
                {
                    OStringStream s;
                    s   << "cell " << celli << " at "
                        << mesh.cellCentres()[celli]
                        << " is no box along the axes";
                    noLattice_ = s.str();
                    return;
                }
            }
        }
    }

    // Planes: clusters of coordinates. The smallest value stands for the
    // plane, so that both cells at a plane compare with the same number
    for (int d = 0; d < nDim_; ++d)
    {
        scalarList x(2*mesh.nCells());
        forAll(mesh.cells(), celli)
        {
            x[2*celli] = lower[nDim_*celli + d];
            x[2*celli + 1] = upper[nDim_*celli + d];
        }
        std::sort(x.begin(), x.end());

        DynamicList<scalar> planes;
        for (const scalar xi : x)
        {
            if (planes.empty() || xi > planes.last() + 1e-3*shortest[d])
            {
                planes.append(xi);
            }
        }

        nCells_[d] = planes.size() - 1;
        planes_[d].setSize(planes.size() + 2);
        forAll(planes, i)
        {
            planes_[d][i + 1] = planes[i];
        }

        const auto indexOf = [&](const scalar xi)
        {
            const auto iter = std::upper_bound
            (
                planes.begin(),
                planes.end(),
                xi + 1e-2*shortest[d]
            );
            return label(iter - planes.begin());
        };

        forAll(mesh.cells(), celli)
        {
            const label i = indexOf(lower[nDim_*celli + d]);
            const label j = indexOf(upper[nDim_*celli + d]);
            if (j != i + 1)
            {
                OStringStream s;
                s   << "cell " << celli << " at "
                    << mesh.cellCentres()[celli]
                    << " spans planes of other cells";
                noLattice_ = s.str();
                return;
            }
            cellIjk_[nDim_*celli + d] = i;
        }
    }

    // Cells on the lattice with one ghost ring
    label nLattice = 1, nLatticeNodes = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        if (scalar(nLatticeNodes)*(nCells_[d] + 3) > 50.0*mesh.nCells() + 1e6)
        {
            noLattice_ = "the cells fill too little of their common lattice";
            return;
        }
        nLattice *= nCells_[d] + 2;
        nLatticeNodes *= nCells_[d] + 3;
    }
    latticeCell_.setSize(nLattice, -1);
    latticeNode_.setSize(nLatticeNodes, -1);

    const auto index = [&](const label* ijk, const label extra)
    {
        label n = ijk[0], stride = 1;
        for (int d = 1; d < nDim_; ++d)
        {
            stride *= nCells_[d - 1] + extra;
            n += stride*ijk[d];
        }
        return n;
    };

    forAll(mesh.cells(), celli)
    {
        const label* ijk = cellIjk_.cdata() + nDim_*celli;
        label& at = latticeCell_[index(ijk, 2)];
        if (at >= 0)
        {
            noLattice_ = "cells overlap";
            return;
        }
        at = celli;

        for (label n = 0; n < nc; ++n)
        {
            label corner[3] = {0, 0, 0};
            for (int d = 0; d < nDim_; ++d)
            {
                corner[d] = ijk[d] + ((n >> d) & 1);
            }
            latticeNode_[index(corner, 3)] = cellNodes_[nc*celli + n];
        }
    }

    // Cyclic directions: the lowest and highest plane are one
    for (int d = 0; d < nDim_; ++d)
    {
        period_[d] = 0;
        label nCyclic = 0, nSide = 0;
        forAll(mesh.cells(), celli)
        {
            if (ijk(celli, d) == 1)
            {
                ++nSide;
                if (neighbour(celli, d, 0) >= 0)
                {
                    ++nCyclic;
                }
            }
        }
        if (nCyclic)
        {
            if (nCyclic != nSide)
            {
                noLattice_ = "a cyclic patch covers only a part of its side";
                return;
            }
            period_[d] = planes_[d][nCells_[d] + 1] - planes_[d][1];
        }
    }

    // Ghost planes and ghost ring
    for (int d = 0; d < nDim_; ++d)
    {
        scalarList& x = planes_[d];
        const label n = nCells_[d];
        if (period_[d] > 0)
        {
            x[0] = x[n] - period_[d];
            x[n + 2] = x[2] + period_[d];
        }
        else
        {
            x[0] = 2*x[1] - x[2];
            x[n + 2] = 2*x[n + 1] - x[n];
        }
        invWidth_[d].setSize(n + 2);
        for (label i = 0; i < n + 2; ++i)
        {
            invWidth_[d][i] = 1/(x[i + 1] - x[i]);
        }
    }

    for (int d = 0; d < nDim_; ++d)
    {
        if (period_[d] <= 0)
        {
            continue;
        }
        // All entries of the ring of direction d from the other end
        const label n = nCells_[d];
        forAll(latticeCell_, i)
        {
            label rest = i, stride = 1, at = 0;
            for (int e = 0; e <= d; ++e)
            {
                at = rest % (nCells_[e] + 2);
                rest /= nCells_[e] + 2;
                if (e < d) stride *= nCells_[e] + 2;
            }
            if (at == 0) latticeCell_[i] = latticeCell_[i + n*stride];
            if (at == n + 1) latticeCell_[i] = latticeCell_[i - n*stride];
        }
        forAll(latticeNode_, i)
        {
            label rest = i, stride = 1, at = 0;
            for (int e = 0; e <= d; ++e)
            {
                at = rest % (nCells_[e] + 3);
                rest /= nCells_[e] + 3;
                if (e < d) stride *= nCells_[e] + 3;
            }
            if (at == 0) latticeNode_[i] = latticeNode_[i + n*stride];
            if (at == n + 2) latticeNode_[i] = latticeNode_[i - n*stride];
        }
    }
}

// ************************************************************************* //
