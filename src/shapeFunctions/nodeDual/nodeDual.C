/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "nodeDual.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::nodeDual::makeRow
(
    const pointGrid& grid,
    const cellSimplices& cells,
    const label m,
    DynamicList<entry>& row
)
{
    const int nDim = grid.nDim();
    DynamicList<scalar> SdS;
    row.clear();
    for (const label celli : grid.nodes().cellsOf(m))
    {
        const label n = cells.nVertices(celli);
        SdS.setSize(nDim*n);
        for (label i = 0; i < n; ++i)
        {
            if (cells.nodes(celli)[i] != m)
            {
                continue;
            }
            const scalar share = cells.integral(celli, i)/n;
            cells.integrals(celli, i, SdS.begin());
            for (label j = 0; j < n; ++j)
            {
                vector d(Zero), G(Zero);
                for (int c = 0; c < nDim; ++c)
                {
                    d[c] =
                        cells.position(celli, j)[c]
                      - cells.position(celli, i)[c];
                    G[c] = SdS[nDim*j + c];
                }

                // A node that a cyclic side brings to two places is two entries
                label at = 0;
                while
                (
                    at < row.size()
                 && (
                        row[at].node != cells.nodes(celli)[j]
                     || magSqr(row[at].d - d) > 1e-6*magSqr(d)
                    )
                )
                {
                    ++at;
                }
                if (at == row.size())
                {
                    row.append
                    (
                        entry{cells.nodes(celli)[j], d, vector(Zero), 0}
                    );
                }
                row[at].G += G;
                row[at].N += share;
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::nodeDual::nodeDual
(
    const pointGrid& grid,
    const cellSimplices& cells
)
:
    nDim_(grid.nDim()),
    volume_(grid.nNodes(), Zero),
    width_(grid.nDim()*grid.nNodes(), Zero),
    start_(grid.nNodes() + 1, Zero),
    reduced_(grid.nNodes(), false)
{
    for (label celli = 0; celli < grid.nCells(); ++celli)
    {
        for (label i = 0; i < cells.nVertices(celli); ++i)
        {
            volume_[cells.nodes(celli)[i]] += cells.integral(celli, i);
        }
    }

    const labelListList faces(boundaryFaces(grid));
    DynamicList<label> nodes(16*grid.nNodes());
    DynamicList<scalar> G(nDim_*16*grid.nNodes()), W(16*grid.nNodes());
    DynamicList<entry> row;
    for (label m = 0; m < grid.nNodes(); ++m)
    {
        makeRow(grid, cells, m, row);
        for (const entry& e : row)
        {
            nodes.append(e.node);
            for (int d = 0; d < nDim_; ++d)
            {
                G.append(e.G[d]/volume_[m]);
                width_[nDim_*m + d] += 2*e.N*sqr(e.d[d])/volume_[m];
            }
        }
        for (int d = 0; d < nDim_; ++d)
        {
            width_[nDim_*m + d] = std::sqrt(width_[nDim_*m + d]);
        }
        reduced_[m] = faces[m].size();
        const tensor P
        (
            faces[m].size()
          ? makeRing(grid, m, faces[m], row)
          : directions(nDim_)
        );
        start_[m + 1] = nodes.size();
        W.setSize(nodes.size());
        solve(nDim_, m, P, row, W.begin() + start_[m]);
    }
    node_.transfer(nodes);
    W_.transfer(W);
    G_.transfer(G);
    sortRows();
    findRuns();
}

// ************************************************************************* //
