/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gridLattice.H"
#include "ListOps.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::unordered_map<int64_t, Foam::label>
Foam::mpm::gridLattice::latticeGhosts
(
    gridNodes& nodes,
    ghostCells& ghosts,
    DynamicList<label>& ghostNodes
)
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
                *to++ = nodes.keys()[cells_.corners(celli)[n]];
            }
        }
    }
    Pstream::gatherList(published);
    Pstream::scatterList(published);

    Map<label> nodeOfKey(2*nodes.size());
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

            ghostNodes.setSize(nc*ghosts.size(), -1);
            nodes.addGhost
            (
                keys,
                nc,
                nodeOfKey,
                ghostNodes.data() + nc*(g - mesh_.nCells())
            );
        }
    }
    nodes.closeGhosts();

    return place;
}


Foam::scalarList Foam::mpm::gridLattice::allPlanes
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

// ************************************************************************* //
