// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "liveCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::mpm::liveCells::cellAt(const label place) const
{
    const label c = lattice_.grid().lattice().cells()[place];
    return c < lattice_.grid().nCells() ? c : -1;
}

void Foam::mpm::liveCells::add(const label celli, const label step)
{
    if (reached_[celli] < 0)
    {
        cells_.append(celli);
        changed_ = true;
    }
    reached_[celli] = max(reached_[celli], step);
}

void Foam::mpm::liveCells::reach(const label place)
{
    if (isShared_.size() && isShared_[place])
    {
        mark_[place] = 1;
    }
    const label c = cellAt(place);
    if (c >= 0)
    {
        add(c, now_);
    }
    if (group_[place] >= 0)
    {
        for (const label other : lattice_.same()[group_[place]])
        {
            const label at = cellAt(other);
            if (at >= 0)
            {
                add(at, now_);
            }
        }
    }
}

void Foam::mpm::liveCells::reachByOthers()
{
    if (!Pstream::parRun())
    {
        return;
    }
    lattice_.sum(mark_.data(), 1);
    for (const label place : lattice_.shared())
    {
        if (mark_[place] > 0)
        {
            reach(place);
        }
    }
    for (const label place : lattice_.shared())
    {
        mark_[place] = 0;
    }
    for (const labelList& places : lattice_.same())
    {
        for (const label place : places)
        {
            mark_[place] = 0;
        }
    }
}

void Foam::mpm::liveCells::listPlace(const label place)
{
    if (placeListed_[place] == listing_)
    {
        return;
    }
    placeListed_[place] = listing_;
    places_.append(place);
    if (group_[place] >= 0)
    {
        listGroup(group_[place]);
    }
}

void Foam::mpm::liveCells::listGroup(const label group)
{
    if (groupListed_[group] == listing_)
    {
        return;
    }
    groupListed_[group] = listing_;
    groups_.append(group);
    for (const label place : lattice_.same()[group])
    {
        listPlace(place);
    }
}

void Foam::mpm::liveCells::listPlaces()
{
    const int D = lattice_.grid().nDim();
    ++listing_;
    places_.clear();
    groups_.clear();
    for (const label c : cells_)
    {
        const label place = lattice_.place(c);
        listPlace(place);
        for (int d = 0; d < D; ++d)
        {
            listPlace(place + lattice_.stride(d));
        }
    }
    if (Pstream::parRun())
    {
        for (const label place : lattice_.shared())
        {
            listPlace(place);
        }
        forAll(lattice_.same(), i)
        {
            listGroup(i);
        }
    }
}

void Foam::mpm::liveCells::listFaces()
{
    if (!changed_)
    {
        return;
    }
    changed_ = false;
    const polyMesh& mesh = lattice_.grid().mesh();
    const labelUList& own = mesh.faceOwner();
    const label nInternal = mesh.nInternalFaces();
    const auto list = [&](const label f)
    {
        if (lattice_.direction(f) >= 0)
        {
            faces_.append(f);
        }
    };
    faces_.clear();
    if (2 * cells_.size() > reached_.size())
    {
        for (label f = 0; f < mesh.nFaces(); ++f)
        {
            list(f);
        }
        return;
    }
    for (const label c : cells_)
    {
        for (const label f : mesh.cells()[c])
        {
            if (f >= nInternal || own[f] == c || !has(own[f]))
            {
                list(f);
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::liveCells::liveCells(materialPointSystem& points, const fractionLattice& lattice) :
    points_(points),
    lattice_(lattice),
    group_(lattice.nPlaces(), label(-1)),
    reached_(lattice.grid().nCells(), label(-1)),
    now_(0),
    listing_(0),
    placeListed_(lattice.nPlaces(), label(-1)),
    groupListed_(lattice.same().size(), label(-1)),
    changed_(true)
{
    const int D = lattice_.grid().nDim();
    around_.setSize(D == 1 ? 3 : D == 2 ? 9 : 27);
    forAll(around_, n)
    {
        around_[n] = 0;
        label rest = n;
        for (int d = 0; d < D; ++d)
        {
            around_[n] += (rest % 3 - 1) * lattice_.stride(d);
            rest /= 3;
        }
    }

    forAll(lattice_.same(), i)
    {
        for (const label place : lattice_.same()[i])
        {
            group_[place] = i;
        }
    }

    if (Pstream::parRun())
    {
        mark_.setSize(lattice.nPlaces(), scalar(0));
        isShared_.setSize(lattice.nPlaces(), false);
        for (const label place : lattice_.shared())
        {
            isShared_[place] = true;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::liveCells::update(const bool moved)
{
    const label* cellOf = lattice_.grid().lattice().cells().cdata();
    const label nCells = reached_.size();
    now_ += moved;
    for (const materialPointPhase& phase : points_.phases())
    {
        for (const label c : phase.cloud().cells())
        {
            const label place = lattice_.place(c);
            for (const label step : around_)
            {
                const label at = cellOf[place + step];
                if (at < 0 || at >= nCells || reached_[at] != now_
                    || (isShared_.size() && isShared_[place + step]))
                {
                    reach(place + step);
                }
            }
        }
    }
    reachByOthers();
    listPlaces();
    if (!moved)
    {
        listFaces();
        return;
    }
    label n = 0;
    for (const label c : cells_)
    {
        if (reached_[c] >= now_ - last_)
        {
            cells_[n++] = c;
        }
        else
        {
            reached_[c] = -1;
        }
    }
    changed_ = changed_ || n < cells_.size();
    cells_.setSize(n);
    listFaces();
}
