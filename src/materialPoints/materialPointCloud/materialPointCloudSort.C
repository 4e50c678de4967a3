// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointCloud.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Fetch the value of the cell of change i, if it is one here
void expect(
    const UList<mpm::materialPointCloud::cellChange>& cellChanges, const label i,
    const labelList& ofCells)
{
    if (i < cellChanges.size())
    {
        const label celli = cellChanges[i].cell;
        __builtin_prefetch(ofCells.cdata() + min(celli, ofCells.size() - 1));
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointCloud::permute(const labelList& from, const label first)
{
    // The current x, U and C stay in the old order: they are what reject()
    // needs and accept() throws away
    forCarried([&](cloudColumn& c)
               { c.tentative().permute(from.cdata(), first, from.size(), scratch_); });
}

void Foam::mpm::materialPointCloud::order(const labelList& cell)
{
    // Order by cell, then by id
    labelList order(identity(n_));
    const scalar* id = id_[0];
    std::sort(
        order.begin(), order.end(),
        [&](const label a, const label b)
        { return cell[a] != cell[b] ? cell[a] < cell[b] : id[a] < id[b]; });
    forCarried([&](column& c) { c.permute(order.cdata(), 0, n_, scratch_); });

    DynamicList<label> cells, start;
    forAll(order, i)
    {
        if (i == 0 || cell[order[i]] != cell[order[i - 1]])
        {
            cells.append(cell[order[i]]);
            start.append(i);
        }
    }
    start.append(n_);
    cells_.transfer(cells);
    start_.transfer(start);
}

Foam::label Foam::mpm::materialPointCloud::countPoints(
    const UList<cellChange>& cellChanges, DynamicList<label>& fresh)
{
    forAll(cells_, k)
    {
        // The extra 1 marks a listed cell, so that an emptied cell is noticed
        count_[cells_[k]] = 1 + start_[k + 1] - start_[k];
    }
    label nLeft = 0;
    const auto comes = [&](const label celli)
    {
        if (celli >= grid_.nCells())
        {
            ++nLeft;
            return;
        }
        label& c = count_[celli];
        if (c == 0)
        {
            c = 1;
            fresh.append(celli);
        }
        ++c;
    };
    label m = 0;
    forAll(cells_, k)
    {
        for (; m < cellChanges.size() && cellChanges[m].point < start_[k + 1]; ++m)
        {
            expect(cellChanges, m + 16, count_);
            --count_[cells_[k]];
            comes(cellChanges[m].cell);
        }
    }
    for (; m < cellChanges.size(); ++m)
    {
        // Points that came from other processors
        comes(cellChanges[m].cell);
    }
    Foam::sort(fresh);
    return nLeft;
}

Foam::labelList Foam::mpm::materialPointCloud::cellsAfter(const labelUList& fresh)
{
    DynamicList<label> cells(oldCells_.size() + fresh.size());
    for (label a = 0, b = 0; a < oldCells_.size() || b < fresh.size();)
    {
        const bool takeOld = b == fresh.size() || (a < oldCells_.size() && oldCells_[a] < fresh[b]);
        const label celli = takeOld ? oldCells_[a++] : fresh[b++];
        if (count_[celli] > 1)
        {
            cells.append(celli);
        }
        else
        {
            count_[celli] = 0;
        }
    }
    return labelList(std::move(cells));
}

void Foam::mpm::materialPointCloud::findOrder(
    const UList<cellChange>& cellChanges, const labelUList& cells, const label nLeft)
{
    // Stayers in their order, then cellChanges; points that have left stand
    // behind all others until the state is accepted
    from_.setSize(n_ + nLeft);
    label left = n_, m = 0;
    forAll(oldCells_, k)
    {
        const label celli = oldCells_[k];
        label to = count_[celli], p = oldStart_[k];
        const label end = oldStart_[k + 1];
        for (; m < cellChanges.size() && cellChanges[m].point < end; ++m)
        {
            for (; p < cellChanges[m].point; ++p)
            {
                from_[to++] = p;
            }
            ++p;
        }
        for (; p < end; ++p)
        {
            from_[to++] = p;
        }
        count_[celli] = to;
    }
    const scalar* id = id_[0];
    forAll(cellChanges, i)
    {
        const cellChange& mv = cellChanges[i];
        expect(cellChanges, i + 16, count_);
        expect(cellChanges, i + 16, first_);
        if (i + 8 < cellChanges.size())
        {
            const label celli = cellChanges[i + 8].cell;
            const label at = celli < grid_.nCells() ? count_[celli] : 0;
            if (at > 0)
            {
                __builtin_prefetch(&from_[at - 1]);
            }
        }
        if (i + 4 < cellChanges.size())
        {
            const label celli = cellChanges[i + 4].cell;
            if (celli < grid_.nCells() && count_[celli] > first_[celli])
            {
                __builtin_prefetch(id + from_[count_[celli] - 1]);
            }
        }
        if (mv.cell >= grid_.nCells())
        {
            from_[left++] = mv.point;
            continue;
        }
        // Insert by id among the points already in the cell
        const label celli = mv.cell;
        const label first = first_[celli];
        label at = count_[celli]++;
        while (at > first && id[from_[at - 1]] > id[mv.point])
        {
            from_[at] = from_[at - 1];
            --at;
        }
        from_[at] = mv.point;
    }
    for (const label celli : cells)
    {
        count_[celli] = 0;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::materialPointCloud::sort(const UList<cellChange>& cellChanges)
{
    sorted_ = false;
    if (cellChanges.empty())
    {
        return false;
    }

    oldCells_ = cells_;
    oldStart_ = start_;

    DynamicList<label> fresh;
    const label nLeft = countPoints(cellChanges, fresh);
    labelList cells(cellsAfter(fresh));
    const bool changed = fresh.size() || cells.size() != oldCells_.size();

    // Turn counts into places
    start_.setSize(cells.size() + 1);
    label n = 0;
    forAll(cells, k)
    {
        start_[k] = n;
        const label nHere = count_[cells[k]] - 1;
        count_[cells[k]] = first_[cells[k]] = n;
        n += nHere;
    }
    start_[cells.size()] = n;

    oldN_ = n_;
    n_ += nArrived_ - nLeft;
    nArrived_ = 0;
    findOrder(cellChanges, cells, nLeft);
    cells_.transfer(cells);

    firstMoved_ = 0;
    while (firstMoved_ < from_.size() && from_[firstMoved_] == firstMoved_)
    {
        ++firstMoved_;
    }

    permute(from_, firstMoved_);
    sorted_ = true;

    return changed;
}

Foam::label Foam::mpm::materialPointCloud::remove(const boolList& gone)
{
    labelList order(n_);
    DynamicList<label> cells(cells_.size()), start(start_.size());
    label n = 0;
    forAll(cells_, k)
    {
        const label first = n;
        for (label p = start_[k]; p < start_[k + 1]; ++p)
        {
            if (!gone[p])
            {
                order[n++] = p;
            }
        }
        if (n > first)
        {
            cells.append(cells_[k]);
            start.append(first);
        }
    }
    start.append(n);
    label last = n;
    for (label p = 0; p < n_; ++p)
    {
        if (gone[p])
        {
            order[last++] = p;
        }
    }
    forCarried([&](column& c) { c.permute(order.cdata(), 0, n_, scratch_); });
    cells_.transfer(cells);
    start_.transfer(start);
    sorted_ = false;

    const label nGone = n_ - n;
    n_ = n;
    return nGone;
}

void Foam::mpm::materialPointCloud::accept()
{
    for (cloudColumn& c : columns_)
    {
        c.accept();
    }
    sorted_ = false;
}

void Foam::mpm::materialPointCloud::reject()
{
    if (!sorted_)
    {
        return;
    }

    labelList back(from_.size());
    forAll(from_, i)
    {
        back[from_[i]] = i;
    }
    permute(back, firstMoved_);
    n_ = oldN_;
    cells_ = oldCells_;
    start_ = oldStart_;
    sorted_ = false;
}
