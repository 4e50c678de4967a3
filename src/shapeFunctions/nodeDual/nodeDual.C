/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "nodeDual.H"
#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::nodeDual::nodeDual
(
    const pointGrid& grid,
    const cellSimplices& cells
)
:
    grid_(grid),
    cells_(cells),
    nDim_(grid.nDim()),
    volume_(grid.nNodes(), Zero),
    width_(grid.nDim()*grid.nNodes(), Zero),
    start_(grid.nNodes() + 1, Zero),
    reduced_(grid.nNodes(), false),
    hasOffsets_(false)
{
    const nodeRows rows(grid, cells);
    DynamicList<label> nodes(16*grid.nNodes());
    DynamicList<scalar> G(nDim_*16*grid.nNodes()), W(16*grid.nNodes());
    nodeRows::row row;
    for (label m = 0; m < grid.nNodes(); ++m)
    {
        rows.get(m, row);
        for (const nodeRows::entry& e : row.entries)
        {
            nodes.append(e.node);
            for (int d = 0; d < nDim_; ++d)
            {
                G.append(e.G[d]/row.volume);
                width_[nDim_*m + d] += 2*e.N*sqr(e.d[d])/row.volume;
            }
        }
        for (int d = 0; d < nDim_; ++d)
        {
            width_[nDim_*m + d] = std::sqrt(width_[nDim_*m + d]);
        }
        start_[m + 1] = nodes.size();
        volume_[m] = row.volume;
        reduced_[m] = row.faces.size();
        if (row.entries.size())
        {
            const tensor P(makeRing(nDim_, row));
            W.setSize(nodes.size());
            solve(nDim_, m, P, row.entries, W.begin() + start_[m]);
        }
    }
    node_.transfer(nodes);
    W_.transfer(W);
    G_.transfer(G);
    sortRows();
    findRuns();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::scalarList& Foam::mpm::nodeDual::offsets() const
{
    if (!hasOffsets_)
    {
        const nodeRows rows(grid_, cells_);
        nodeRows::row row;
        offset_.setSize(nDim_*node_.size());
        label at = 0;
        for (label m = 0; m < grid_.nNodes(); ++m)
        {
            rows.get(m, row);
            const tensor P(makeRing(nDim_, row));

            // As sortRows()
            std::stable_sort
            (
                row.entries.begin(),
                row.entries.end(),
                [](const nodeRows::entry& a, const nodeRows::entry& b)
                {
                    return a.node < b.node;
                }
            );
            for (const nodeRows::entry& e : row.entries)
            {
                const vector d(P & e.d);
                for (int c = 0; c < nDim_; ++c)
                {
                    offset_[at++] = d[c];
                }
            }
        }
        hasOffsets_ = true;
    }
    return offset_;
}

// ************************************************************************* //
