/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexMap.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::hexMap::hexMap(const pointGrid& grid, const label celli)
:
    grid_(grid),
    centre_(grid.mesh().cellCentres()[celli])
{
    const int nDim = grid_.nDim();
    const label nCorners = label(1) << nDim;

    for (label n = 0; n < nCorners; ++n)
    {
        corner_[n] = centre_;
    }

    if (grid_.hasLattice())
    {
        for (label n = 0; n < nCorners; ++n)
        {
            for (int d = 0; d < nDim; ++d)
            {
                const label i = grid_.lattice().ijk(celli, d) + ((n >> d) & 1);
                corner_[n][grid_.direction(d)] = grid_.lattice().planes(d)[i];
            }
        }
        return;
    }

    // From the cell's own points: a node on a cyclic side has two positions
    const label* nodes = grid_.hexes().corners(celli);
    for (label n = 0; n < nCorners; ++n)
    {
        label found = 0;
        for (const label pointi : grid_.mesh().cellPoints()[celli])
        {
            if (grid_.pointToNode()[pointi] == nodes[n])
            {
                ++found;
                const point& p = grid_.mesh().points()[pointi];
                for (int d = 0; d < nDim; ++d)
                {
                    corner_[n][grid_.direction(d)] = p[grid_.direction(d)];
                }
            }
        }
        // On the axis of a wedge there is one
        if (found > (label(8) >> nDim))
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << centre_ << " lies between"
                << " two cyclic sides; a mesh without a lattice needs at"
                << " least two cells there." << exit(FatalError);
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::mpm::hexMap::bounds() const
{
    boundBox bb(corner_[0], corner_[0]);
    for (label n = 1; n < (label(1) << grid_.nDim()); ++n)
    {
        bb.min() = min(bb.min(), corner_[n]);
        bb.max() = max(bb.max(), corner_[n]);
    }
    return bb;
}


Foam::point Foam::mpm::hexMap::position(const scalar* xi) const
{
    const int nDim = grid_.nDim();
    point x(centre_);

    if (grid_.hasLattice())
    {
        for (int d = 0; d < nDim; ++d)
        {
            const int c = grid_.direction(d);
            const scalar lower = corner_[0][c];
            x[c] = lower + xi[d]*(corner_[label(1) << d][c] - lower);
        }
        return x;
    }

    for (int d = 0; d < nDim; ++d)
    {
        const int c = grid_.direction(d);
        x[c] = 0;
        for (label n = 0; n < (label(1) << nDim); ++n)
        {
            scalar w = 1;
            for (int e = 0; e < nDim; ++e)
            {
                w *= (n >> e) & 1 ? xi[e] : 1 - xi[e];
            }
            x[c] += w*corner_[n][c];
        }
    }
    return x;
}


Foam::vector Foam::mpm::hexMap::tangent(const scalar* xi, const int d) const
{
    const int nDim = grid_.nDim();
    vector t(Zero);

    for (label n = 0; n < (label(1) << nDim); ++n)
    {
        if ((n >> d) & 1)
        {
            scalar w = 1;
            for (int e = 0; e < nDim; ++e)
            {
                if (e != d)
                {
                    w *= (n >> e) & 1 ? xi[e] : 1 - xi[e];
                }
            }
            t += w*(corner_[n] - corner_[n - (label(1) << d)]);
        }
    }
    return t;
}


Foam::scalar Foam::mpm::hexMap::determinant(const scalar* xi) const
{
    // Tangents in the order of the axes; along an empty axis the unit vector
    vector t[3] = {vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)};
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        t[grid_.direction(d)] = tangent(xi, d);
    }
    return t[0] & (t[1] ^ t[2]);
}

// ************************************************************************* //
