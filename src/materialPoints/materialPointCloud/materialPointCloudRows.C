/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointCloud.H"
#include "PstreamReduceOps.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::pointRows Foam::mpm::materialPointCloud::rows()
{
    pointRows rows;
    forCarried
    (
        [&](const column& c)
        {
            rows.columns.append(c.name());
            rows.nComponents.append(c.nComponents());
        }
    );
    const label size = rows.rowSize();
    rows.values.setSize(size*n_);
    label at = 0;
    forCarried
    (
        [&](const column& c)
        {
            for (int i = 0; i < c.nComponents(); ++i, ++at)
            {
                for (label p = 0; p < n_; ++p)
                {
                    rows.values[size*p + at] = c[i][p];
                }
            }
        }
    );
    return rows;
}


Foam::label Foam::mpm::materialPointCloud::setRows(const pointRows& rows)
{
    // Collective, so before processors without points go their own way
    grid_.mesh().tetBasePtIs();

    const label n = rows.size();
    n_ = 0;
    reserve(n);
    n_ = n;
    for (cloudColumn& c : columns_)
    {
        c.fill(0, n);
        c.fromFile() = c.rules().inFiles() != columnRules::none;
    }

    const label size = rows.rowSize();
    label at = 0;
    forAll(rows.columns, columni)
    {
        const label nComponents = rows.nComponents[columni];
        cloudColumn* c = findColumn(rows.columns[columni]);

        // A column that nobody asks for is left behind
        for (int i = 0; c && i < min(nComponents, c->nComponents()); ++i)
        {
            for (label p = 0; p < n; ++p)
            {
                (*c)[i][p] = rows.values[size*p + at + i];
            }
        }
        at += nComponents;
    }
    const scalar* id = id_[0];
    nextId_ = n ? *std::max_element(id, id + n) + 1 : 0;
    reduce(nextId_, maxOp<scalar>());

    pointField x(n);
    forAll(x, p)
    {
        x[p] = vectorOf(x_, p);
    }
    labelList cell(n, label(-1));
    findCells(x, cell);
    order(cell);

    return returnReduce(n_, sumOp<label>());
}

// ************************************************************************* //
