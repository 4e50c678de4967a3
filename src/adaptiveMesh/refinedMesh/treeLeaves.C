// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "treeLeaves.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::treeLeaves::grow(
    const labelUList& levels, label& next, const label celli, const label level,
    const FixedList<label, 3>& at)
{
    if (next >= levels.size() || levels[next] < level || levels[next] > maxLevel)
    {
        FatalErrorInFunction << "The levels of the refined cells are no trees over the "
                             << base_.size() << " cells of the base mesh, in cell " << celli
                             << "; cellLevel and the base mesh are of different runs."
                             << exit(FatalError);
    }
    if (levels[next] == level)
    {
        cell_[next] = celli;
        at_[next] = at;
        ++next;
        return;
    }
    const baseHexes::hex& h = base_[celli];
    const label w = full >> (level + 1);
    for (label child = 0, bits = h.nChildren(); child < bits; ++child)
    {
        FixedList<label, 3> of(at);
        label left = child;
        for (label a = 0; a < 3; ++a)
        {
            if (h.halved[a])
            {
                of[a] += (left & 1) * w;
                left >>= 1;
            }
        }
        grow(levels, next, celli, level + 1, of);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::treeLeaves::treeLeaves(const baseHexes& base, const labelUList& levels) :
    base_(base), level_(levels), cell_(levels.size()), start_(base.size() + 1), at_(levels.size())
{
    label next = 0;
    for (label celli = 0; celli < base.size(); ++celli)
    {
        start_[celli] = next;
        grow(levels, next, celli, 0, {0, 0, 0});
    }
    start_.last() = next;
    if (next != levels.size())
    {
        FatalErrorInFunction << "There are " << levels.size() << " levels of refined cells for "
                             << next << " cells." << exit(FatalError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::treeLeaves::isFirstOfBrothers(const label leaf) const
{
    const label l = level_[leaf], n = base_[cell_[leaf]].nChildren();
    if (l == 0 || leaf + n > start_[cell_[leaf] + 1])
    {
        return false;
    }
    const label w = full >> (l - 1);
    for (label a = 0; a < 3; ++a)
    {
        if (base_[cell_[leaf]].halved[a] && at_[leaf][a] % w)
        {
            return false;
        }
    }
    for (label i = 1; i < n; ++i)
    {
        if (level_[leaf + i] != l)
        {
            return false;
        }
    }
    return true;
}

Foam::labelList Foam::mpm::treeLeaves::changed(const labelUList& change) const
{
    DynamicList<label> levels(size());
    for (label leaf = 0; leaf < size(); ++leaf)
    {
        const label n = base_[cell_[leaf]].nChildren();
        if (change[leaf] > 0)
        {
            for (label i = 0; i < n; ++i)
            {
                levels.append(level_[leaf] + 1);
            }
            continue;
        }
        bool all = change[leaf] < 0 && isFirstOfBrothers(leaf);
        for (label i = 1; all && i < n; ++i)
        {
            all = change[leaf + i] < 0;
        }
        levels.append(level_[leaf] - all);
        leaf += all ? n - 1 : 0;
    }
    return labelList(std::move(levels));
}

Foam::List<Foam::Pair<Foam::label>> Foam::mpm::treeLeaves::sources(const treeLeaves& before) const
{
    List<Pair<label>> from(size());
    for (label celli = 0; celli < base_.size(); ++celli)
    {
        // Both walk through the cell; parts of it left over, in those of the last level
        const label bits = base_[celli].nChildren();
        const auto share = [&](const label level)
        {
            label s = 1;
            for (label l = level; l < maxLevel; ++l)
            {
                s *= bits;
            }
            return s;
        };
        label old = before.start_[celli], oldEnd = share(before.level_[old]), at = 0;
        for (label leaf = start_[celli]; leaf < start_[celli + 1]; ++leaf)
        {
            const label first = old;
            at += share(level_[leaf]);
            while (oldEnd < at)
            {
                oldEnd += share(before.level_[++old]);
            }
            from[leaf] = Pair<label>(first, old + 1);
            if (oldEnd == at && old + 1 < before.start_[celli + 1])
            {
                oldEnd += share(before.level_[++old]);
            }
        }
    }
    return from;
}
