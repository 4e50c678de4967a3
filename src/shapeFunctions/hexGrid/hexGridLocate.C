/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexGrid.H"
#include <Eigen/LU>
#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::hexGrid::localCoordinates
(
    const label celli,
    const scalar* x,
    scalar* xi
) const
{
    if (hasLattice())
    {
        for (int d = 0; d < nDim_; ++d)
        {
            const label i = ijk(celli, d);
            xi[d] = (x[d] - planes_[d][i])*invWidth_[d][i];
        }
        return;
    }

    const label nc = label(1) << nDim_;
    scalar corner[24];
    cornerPositions(celli, corner);

    for (int d = 0; d < nDim_; ++d)
    {
        xi[d] = 0.5;
    }
    Eigen::Matrix3d J;
    Eigen::Vector3d r;
    for (int iter = 0; iter < 20; ++iter)
    {
        J.setIdentity();
        r.setZero();
        for (int d = 0; d < nDim_; ++d)
        {
            r(d) = x[d];
            J(d, d) = 0;
        }
        for (label n = 0; n < nc; ++n)
        {
            scalar w = 1;
            for (int d = 0; d < nDim_; ++d)
            {
                w *= (n >> d) & 1 ? xi[d] : 1 - xi[d];
            }
            for (int e = 0; e < nDim_; ++e)
            {
                r(e) -= w*corner[nDim_*n + e];
            }
            for (int d = 0; d < nDim_; ++d)
            {
                scalar dw = (n >> d) & 1 ? 1 : -1;
                for (int e = 0; e < nDim_; ++e)
                {
                    if (e != d)
                    {
                        dw *= (n >> e) & 1 ? xi[e] : 1 - xi[e];
                    }
                }
                for (int e = 0; e < nDim_; ++e)
                {
                    J(e, d) += dw*corner[nDim_*n + e];
                }
            }
        }
        const Eigen::Vector3d dxi(J.partialPivLu().solve(r));
        scalar largest = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            // Far outside the map need not be one to one: stay near
            xi[d] = min(max(xi[d] + dxi(d), scalar(-2)), scalar(3));
            largest = max(largest, mag(dxi(d)));
        }
        if (largest < 1e-14)
        {
            break;
        }
    }
}


Foam::label Foam::mpm::hexGrid::locateInLattice
(
    const label from,
    scalar* x
) const
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
        label i =
            from >= 0
          ? ijk(from, d)
          : label
            (
                std::upper_bound(X.begin(), X.begin() + n + 3, y)
              - X.begin()
            ) - 1;
        i = min(max(i, label(0)), n + 1);
        while (i > 0 && y < X[i]) --i;
        while (i < n + 1 && y >= X[i + 1]) ++i;
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
                possible =
                    possible
                 && at[d] > 0
                 && beyond[d] == planes_[d][at[d]];
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


Foam::label Foam::mpm::hexGrid::locate(const label from, scalar* x) const
{
    if (hasLattice())
    {
        return locateInLattice(from, x);
    }

    // General hexahedra: through the side that is violated most
    label celli = from;
    for (int step = 0; step < 50 && celli >= 0; ++step)
    {
        if (celli >= nCells())
        {
            // Its processor goes on
            return celli;
        }
        scalar xi[3];
        localCoordinates(celli, x, xi);

        label next = -1, through = -1;
        scalar worst = 0;
        bool outside = false;
        for (int d = 0; d < nDim_; ++d)
        {
            for (int s = 0; s < 2; ++s)
            {
                const scalar beyond = s ? xi[d] - 1 : -xi[d];
                const label nbr = neighbour(celli, d, s);
                // A little beyond a boundary side is rounding of the inverse
                const bool out = nbr < 0 ? beyond > 1e-10 : beyond > 0;
                if (out && beyond > worst)
                {
                    worst = beyond;
                    next = nbr;
                    through = 2*(nDim_*celli + d) + s;
                    outside = true;
                }
            }
        }
        if (!outside)
        {
            return celli;
        }
        // On the common side to rounding: the higher cell owns it
        const bool onSide = next >= 0 && worst < 1e-12;
        if (onSide && (celli > next || next >= nCells()))
        {
            return celli;
        }
        if (next >= 0 && shift_.size())
        {
            for (int d = 0; d < nDim_; ++d)
            {
                x[d] += shift_[through][dir_[d]];
            }
        }
        celli = next;
        if (onSide)
        {
            return celli;
        }
    }
    return -1;
}


Foam::label Foam::mpm::hexGrid::find(scalar* x) const
{
    if (hasLattice())
    {
        return locate(-1, x);
    }

    point p(Zero);
    // The missing coordinates: those of any mesh point's cell centre
    p = mesh().cellCentres()[0];
    for (int d = 0; d < nDim_; ++d)
    {
        p[dir_[d]] = x[d];
    }
    const label near = mesh().findNearestCell(p);
    return near < 0 ? -1 : locate(near, x);
}

// ************************************************************************* //
