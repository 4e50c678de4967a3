// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "liveCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::mpm::liveCells::cellAt(const label place) const
{
    const label c = lattice_.grid().lattice().cellOf(place);
    return c < lattice_.grid().nCells() ? c : -1;
}

void Foam::mpm::liveCells::add(const label celli, const label step)
{
    if (reached_[celli] < 0)
    {
        cells_.append(celli);
    }
    reached_[celli] = max(reached_[celli], step);
}

void Foam::mpm::liveCells::reach(const label place)
{
    const label c = cellAt(place);
    if (c >= 0 && reached_[c] == now_)
    {
        return;
    }
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

void Foam::mpm::liveCells::listPlaces()
{
    const int D = lattice_.grid().nDim();
    places_.clear();
    const auto list = [&](const label place)
    {
        if (listed_[place] != now_)
        {
            listed_[place] = now_;
            places_.append(place);
        }
    };
    for (const label c : cells_)
    {
        const label place = lattice_.place(c);
        list(place);
        for (int d = 0; d < D; ++d)
        {
            list(place + lattice_.stride(d));
        }
    }
    for (const label place : joined_)
    {
        list(place);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::liveCells::liveCells(materialPointSystem& points, const fractionLattice& lattice) :
    points_(points),
    lattice_(lattice),
    group_(lattice.nPlaces(), label(-1)),
    reached_(lattice.grid().nCells(), label(-1)),
    now_(0),
    listed_(lattice.nPlaces(), label(-1))
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
            joined_.append(place);
        }
    }

    // Points of others reach, unseen from here, the cells around these places
    joined_.append(lattice_.shared());
    const labelHashSet shared(lattice_.shared());
    forAll(reached_, c)
    {
        for (const label step : around_)
        {
            if (shared.found(lattice_.place(c) + step))
            {
                add(c, always_);
                break;
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::liveCells::update()
{
    ++now_;
    for (const materialPointPhase& phase : points_.phases())
    {
        for (const label c : phase.cloud().cells())
        {
            const label place = lattice_.place(c);
            for (const label step : around_)
            {
                reach(place + step);
            }
        }
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
    cells_.setSize(n);
    listPlaces();
}
