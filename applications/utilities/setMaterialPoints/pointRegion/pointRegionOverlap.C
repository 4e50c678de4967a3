/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointRegion.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::pointRegion::overlaps
(
    const pointRegion& other,
    const label k,
    const label otherK,
    point& where
) const
{
    if (byCorners_ || byElements_ || other.byElements_)
    {
        return cornersOverlap(other, k, where);
    }
    const label celli = cells_[k];
    const hexMap map(grid_, celli);

    // Rows of a box fill what lies in it
    const label n = rows_ ? nSub_ : start_[k + 1] - start_[k];
    for (label j = 0; j < n; ++j)
    {
        const label sub = rows_ ? j : sub_[start_[k] + j];

        // Positions away from the shapes' sides, which they may share
        for (label sample = 0; sample < nSamples_; ++sample)
        {
            scalar xi[3];
            local(sub, sample, xi);

            // Has the other region a point here?
            label otherSub = 0, stride = 1;
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                const label i = label(xi[d]*other.n_[d]);
                otherSub += stride*min(i, other.n_[d] - 1);
                stride *= other.n_[d];
            }
            if
            (
                !other.rows_
             && !std::binary_search
                (
                    other.sub_.begin() + other.start_[otherK],
                    other.sub_.begin() + other.start_[otherK + 1],
                    otherSub
                )
            )
            {
                continue;
            }

            where = map.position(xi);
            if
            (
                shape_->contains(celli, where)
             && other.shape_->contains(celli, where)
            )
            {
                return true;
            }
        }
    }
    return false;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::pointRegion::overlap
(
    const pointRegion& other,
    point& where
) const
{
    if (mayOverlap_ || other.mayOverlap_)
    {
        return -1;
    }

    label j = 0;
    forAll(cells_, k)
    {
        while (j < other.cells_.size() && other.cells_[j] < cells_[k])
        {
            ++j;
        }
        if (j == other.cells_.size())
        {
            return -1;
        }

        // Both ways: sub-cells may be of different size
        if
        (
            other.cells_[j] == cells_[k]
         && (
                overlaps(other, k, j, where)
             || other.overlaps(*this, j, k, where)
            )
        )
        {
            return cells_[k];
        }
    }
    return -1;
}


void Foam::mpm::pointRegion::checkOverlap(const pointRegion& other) const
{
    point where;
    const label celli = overlap(other, where);
    if (celli >= 0)
    {
        FatalIOErrorInFunction(dict_)
            << "Regions " << other.name_ << " and " << name_
            << " overlap: both have points at " << where << " (cell "
            << celli << "), and their phases share a velocity field."
            << nl << "Change a shape, or write  overlap allow;  in one of"
            << " the regions if that is meant." << exit(FatalIOError);
    }
}

// ************************************************************************* //
