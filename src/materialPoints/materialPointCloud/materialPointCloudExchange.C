// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointCloud.H"
#include "outflowPatches.H"
#include "wallPatches.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "PstreamReduceOps.H"
#include "SubList.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointCloud::pack(const UList<cellChange>& cellChanges)
{
    for (DynamicList<scalar>& rows : leaving_)
    {
        rows.clear();
    }
    for (const cellChange& mv : cellChanges)
    {
        if (mv.cell < grid_.nCells() || mv.cell == outflowPatches::gone)
        {
            continue;
        }
        DynamicList<scalar>& rows = leaving_[findSortedIndex(procs_, grid_.ghostProc(mv.cell))];

        rows.append(grid_.ghostCell(mv.cell));
        toRow(mv.point, rows);
    }
}

void Foam::mpm::materialPointCloud::sendRows()
{
    const int tag = UPstream::msgType();
    const auto receive = [&](const label i, void* to, const std::size_t bytes)
    {
        UIPstream::read(
            UPstream::commsTypes::nonBlocking, procs_[i], static_cast<char*>(to), bytes, tag);
    };
    const auto send = [&](const label i, const void* from, const std::size_t bytes)
    {
        UOPstream::write(
            UPstream::commsTypes::nonBlocking, procs_[i], static_cast<const char*>(from), bytes,
            tag);
    };

    // First the number of values, then the values
    labelList nSend(procs_.size()), nReceive(procs_.size(), label(0));
    label request = UPstream::nRequests();
    forAll(procs_, i)
    {
        nSend[i] = leaving_[i].size();
        receive(i, &nReceive[i], sizeof(label));
    }
    forAll(procs_, i)
    {
        send(i, &nSend[i], sizeof(label));
    }
    UPstream::waitRequests(request);

    request = UPstream::nRequests();
    forAll(procs_, i)
    {
        arriving_[i].setSize(nReceive[i]);
        if (nReceive[i])
        {
            receive(i, arriving_[i].data(), nReceive[i] * sizeof(scalar));
        }
    }
    forAll(procs_, i)
    {
        if (nSend[i])
        {
            send(i, leaving_[i].cdata(), nSend[i] * sizeof(scalar));
        }
    }
    UPstream::waitRequests(request);
}

void Foam::mpm::materialPointCloud::unpack(
    DynamicList<cellChange>& cellChanges, const wallPatches* walls, const bool last)
{
    // A row is the cell followed by all columns
    const label row = 1 + rowSize();
    label n = 0;
    for (const DynamicList<scalar>& rows : arriving_)
    {
        n += rows.size() / row;
    }
    if (!n)
    {
        return;
    }
    reserve(n_ + nArrived_ + n);

    for (const DynamicList<scalar>& rows : arriving_)
    {
        for (label at = 0; at < rows.size(); at += row)
        {
            const scalar* from = rows.cdata() + at;
            const label p = n_ + nArrived_++;
            const label announced = label(from[0]);
            fromRow(from + 1, p);

            scalar x[3] = {0, 0, 0};
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                x[d] = xNew_[d][p];
            }
            label celli = last ? -1 : grid_.locate(announced, x);
            if (celli < 0 && walls && !last)
            {
                scalar shift[3] = {0, 0, 0};
                for (int d = 0; d < grid_.nDim(); ++d)
                {
                    x[d] = xNew_[d][p];
                }
                celli = walls->putBack(announced, x, shift);
                for (int d = 0; displacement_ && d < grid_.nDim(); ++d)
                {
                    (*displacement_)[d][p] += shift[d];
                }
            }
            if (celli < 0 || (grid_.locatesAtOnce() && celli >= grid_.nCells()))
            {
                // Outside the announced cell by rounding only
                celli = announced;
            }
            else
            {
                for (int d = 0; d < grid_.nDim(); ++d)
                {
                    xNew_[d][p] = x[d];
                }
            }
            cellChanges.append(cellChange{p, celli});
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::materialPointCloud::rowSize()
{
    label n = 0;
    forCarried([&](const column& c) { n += c.nComponents(); });
    return n;
}

void Foam::mpm::materialPointCloud::toRow(const label pointi, DynamicList<scalar>& row)
{
    forCarried(
        [&](cloudColumn& c)
        {
            const column& from = c.tentative();
            for (int i = 0; i < from.nComponents(); ++i)
            {
                row.append(from[i][pointi]);
            }
        });
}

void Foam::mpm::materialPointCloud::fromRow(const scalar* row, const label pointi)
{
    forCarried(
        [&](cloudColumn& c)
        {
            column& to = c.tentative();
            for (int i = 0; i < to.nComponents(); ++i)
            {
                to[i][pointi] = *row++;
            }
        });
}

bool Foam::mpm::materialPointCloud::exchange(
    DynamicList<cellChange>& cellChanges, const label round, const wallPatches* walls)
{
    if (leaving_.empty())
    {
        procs_ = grid_.ghostProcs();
        leaving_.setSize(procs_.size());
        arriving_.setSize(procs_.size());
    }
    if (round == 1)
    {
        seen_ = 0;
    }
    pack(SubList<cellChange>(cellChanges, cellChanges.size() - seen_, seen_));
    seen_ = cellChanges.size();
    sendRows();

    // One between the planes of warped faces, which no cell wants, stays at last
    unpack(cellChanges, walls, round == 20);

    bool more = false;
    for (label m = seen_; m < cellChanges.size(); ++m)
    {
        more = more
            || (cellChanges[m].cell >= grid_.nCells()
                && cellChanges[m].cell != outflowPatches::gone);
    }
    return more;
}

Foam::mpm::pointRows Foam::mpm::materialPointCloud::rows()
{
    pointRows rows;
    forCarried(
        [&](const column& c)
        {
            rows.columns.append(c.name());
            rows.nComponents.append(c.nComponents());
        });
    const label size = rows.rowSize();
    rows.values.setSize(size * n_);
    label at = 0;
    forCarried(
        [&](const column& c)
        {
            for (int i = 0; i < c.nComponents(); ++i, ++at)
            {
                for (label p = 0; p < n_; ++p)
                {
                    rows.values[size * p + at] = c[i][p];
                }
            }
        });
    rows.cells.setSize(n_);
    forAll(cells_, k)
    {
        for (label p = start_[k]; p < start_[k + 1]; ++p)
        {
            rows.cells[p] = cells_[k];
        }
    }
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
        c.fromFile() = c.rules().inFiles != columnRules::none;
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
                (*c)[i][p] = rows.values[size * p + at + i];
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
    labelList cell(rows.cells);
    if (cell.size() != n)
    {
        cell = labelList(n, label(-1));
    }
    if (n && min(cell) < 0)
    {
        findCells(x, cell);
    }
    order(cell);

    return returnReduce(n_, sumOp<label>());
}
