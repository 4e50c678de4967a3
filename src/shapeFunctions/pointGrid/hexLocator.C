// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "hexLocator.H"
#include "meshCheck.H"
#include "polyMesh.H"
#include "FixedList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Derivatives of a map from coordinates xi: J[k][e] = dx_e/dxi_k
typedef FixedList<vector, 3> jacobian;

jacobian unity() { return {vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)}; }

//- det J times dxi_k/dx
vector cofactors(const jacobian& J, const int k) { return J[(k + 1) % 3] ^ J[(k + 2) % 3]; }

scalar determinant(const jacobian& J) { return J[0] & cofactors(J, 0); }

//- At corner n
jacobian atCorner(const int nDim, const scalar* corner, const label n)
{
    jacobian J(unity());
    for (int k = 0; k < nDim; ++k)
    {
        for (int e = 0; e < nDim; ++e)
        {
            J[k][e] = corner[nDim * (n | (label(1) << k)) + e]
                - corner[nDim * (n & ~(label(1) << k)) + e];
        }
    }
    return J;
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::hexLocator::hexLocator(
    const polyMesh& mesh, const gridAxes& axes, const hexCells& cells) :
    mesh_(mesh), axes_(axes), cells_(cells), nDim_(axes.nDim())
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::hexLocator::localCoordinates(const label celli, const scalar* x, scalar* xi) const
{
    const label nc = label(1) << nDim_;
    scalar corner[24];
    cells_.cornerPositions(celli, corner);

    for (int d = 0; d < nDim_; ++d)
    {
        xi[d] = 0.5;
    }
    for (int iter = 0; iter < 20; ++iter)
    {
        jacobian J(unity());
        vector r(Zero);
        for (int d = 0; d < nDim_; ++d)
        {
            r[d] = x[d];
            J[d][d] = 0;
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
                r[e] -= w * corner[nDim_ * n + e];
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
                    J[d][e] += dw * corner[nDim_ * n + e];
                }
            }
        }
        const scalar detJ = determinant(J);
        scalar largest = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            // Far outside the map need not be one to one: stay near
            const scalar dxi = (r & cofactors(J, d)) / detJ;
            xi[d] = min(max(xi[d] + dxi, scalar(-2)), scalar(3));
            largest = max(largest, mag(dxi));
        }
        if (largest < 1e-14)
        {
            break;
        }
    }
}

Foam::label Foam::mpm::hexLocator::locate(const label from, scalar* x) const
{
    // Through the side that is violated most
    label celli = from;
    for (int step = 0; step < 50 && celli >= 0; ++step)
    {
        if (celli >= mesh_.nCells())
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
                const label nbr = cells_.neighbour(celli, d, s);
                // A little beyond a boundary side is rounding of the inverse
                const bool out = nbr < 0 ? beyond > 1e-10 : beyond > 0;
                if (out && beyond > worst)
                {
                    worst = beyond;
                    next = nbr;
                    through = 2 * d + s;
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
        if (onSide && (celli > next || next >= mesh_.nCells()))
        {
            return celli;
        }
        if (next >= 0)
        {
            cells_.shift(celli, through / 2, through % 2, x);
        }
        celli = next;
        if (onSide)
        {
            return celli;
        }
    }
    return -1;
}

Foam::label Foam::mpm::hexLocator::find(scalar* x) const
{
    point p(Zero);
    // The missing coordinates: those of any mesh point's cell centre
    p = mesh_.cellCentres()[0];
    for (int d = 0; d < nDim_; ++d)
    {
        p[axes_.direction(d)] = x[d];
    }
    const label near = mesh_.findNearestCell(p);
    return near < 0 ? -1 : locate(near, x);
}

Foam::scalar Foam::mpm::hexLocator::width(const label celli, const int d) const
{
    // Smallest distance between the two sides: 1/|grad xi_d| at the corners.
    // On sheared cells it is much less than the edges, and it is what limits
    // the time step
    const label nc = label(1) << nDim_;
    scalar corner[24];
    cells_.cornerPositions(celli, corner);
    scalar shortest = GREAT;
    for (label n = 0; n < nc; ++n)
    {
        const jacobian J(atCorner(nDim_, corner, n));
        shortest = min(shortest, mag(determinant(J)) / mag(cofactors(J, d)));
    }
    return shortest;
}

Foam::string Foam::mpm::hexLocator::folded() const
{
    const label nc = label(1) << nDim_;
    scalar corner[24];
    OStringStream reason;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        cells_.cornerPositions(celli, corner);
        scalar least = VGREAT, most = 0;
        for (label n = 0; n < nc; ++n)
        {
            const scalar detJ = determinant(atCorner(nDim_, corner, n));
            least = min(least, detJ);
            most = max(most, detJ);
        }
        if (!(least > 1e-9 * most))
        {
            reason << "Cell " << celli << " at " << mesh_.cellCentres()[celli]
                   << " is folded over at a corner: the determinants of its map go"
                   << " from " << least << " to " << most;
            break;
        }
    }
    return firstFound(reason.str());
}
