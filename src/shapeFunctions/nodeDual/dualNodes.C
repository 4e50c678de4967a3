// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "dualNodes.H"
#include "largestOfAll.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::dualNodes::findMass()
{
    for (const label l : withMass_)
    {
        mass_[l] = 0;
    }
    withMass_.clear();
    if (!boundary_.any)
    {
        return;
    }
    const auto mark = [&](const label l)
    {
        if (!mass_[l])
        {
            mass_[l] = 1;
            withMass_.append(l);
        }
    };
    for (const label m : nodes_)
    {
        if (!boundary_.feeds[m])
        {
            continue;
        }
        for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
        {
            if (dual_.W(e) > 0)
            {
                mark(dual_.node(e));
            }
        }
    }
    if (toShare_.size())
    {
        for (const label l : boundary_.shared.nodes())
        {
            toShare_[l] = mass_[l];
        }
        boundary_.shared.largest(toShare_.begin(), 1, 1);
        for (const label l : boundary_.shared.nodes())
        {
            if (toShare_[l] > 0)
            {
                mark(l);
            }
        }
    }
}

bool Foam::mpm::dualNodes::addWall(const label m)
{
    const label start = hasMass_.size();
    bool all = true;
    for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
    {
        hasMass_.append(mass_[dual_.node(e)]);
        all = all && hasMass_.last();
    }
    if (all)
    {
        hasMass_.setSize(start);
        return false;
    }
    walls_.append(m);
    wallStart_.append(start);
    return true;
}

Foam::label Foam::mpm::dualNodes::wall(const label m) const
{
    if (!dual_.reduced(m))
    {
        return -1;
    }
    const auto at = std::lower_bound(walls_.begin(), walls_.end(), m);
    return at != walls_.end() && *at == m ? label(at - walls_.begin()) : -1;
}

void Foam::mpm::dualNodes::findRanges()
{
    ranges_.clear();
    walls_.clear();
    wallStart_.clear();
    hasMass_.clear();
    for (const label m : nodes_)
    {
        if (dual_.reduced(m) && addWall(m))
        {
            continue;
        }
        const bool follows = ranges_.size() && ranges_.last().end == m
            && dual_.alike(ranges_.last().first) == dual_.alike(m);
        if (follows)
        {
            ++ranges_.last().end;
        }
        else
        {
            ranges_.append(rowRange{m, m + 1, false});
        }
    }

    // Short ones that follow each other go together, row by row
    label n = 0;
    for (const rowRange& r : ranges_)
    {
        const bool alike = r.end - r.first >= fewest;
        if (n && !alike && !ranges_[n - 1].alike && ranges_[n - 1].end == r.first)
        {
            ranges_[n - 1].end = r.end;
        }
        else
        {
            ranges_[n++] = rowRange{r.first, r.end, alike};
        }
    }
    ranges_.setSize(n);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::dualNodes::boundary::boundary(const nodeDual& dual, const sharedNodes& sums) :
    shared(sums), any(false), feeds(dual.nRows(), false)
{
    scalarList ofBoundary(dual.nRows(), Zero);
    for (label m = 0; m < dual.nRows(); ++m)
    {
        if (dual.reduced(m))
        {
            any = true;
            for (label e = dual.begin(m); e < dual.begin(m + 1); ++e)
            {
                ofBoundary[dual.node(e)] = 1;
            }
        }
    }
    reduce(any, orOp<bool>());
    shared.largest(ofBoundary.begin(), 1, 1);
    for (label m = 0; m < dual.nRows(); ++m)
    {
        for (label e = dual.begin(m); e < dual.begin(m + 1); ++e)
        {
            feeds[m] = feeds[m] || (dual.W(e) > 0 && ofBoundary[dual.node(e)] > 0);
        }
    }
}

Foam::mpm::dualNodes::dualNodes(const nodeDual& dual, const boundary& edge) :
    dual_(dual),
    boundary_(edge),
    found_(false),
    here_(dual.nRows(), char(0)),
    mass_(dual.nRows(), char(0)),
    toShare_(Pstream::parRun() ? dual.nRows() : 0, Zero)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::dualNodes::update(const labelList& cells, const cellSimplices& vertices)
{
    // Points of others give mass to nodes here
    const bool together = boundary_.any && Pstream::parRun();
    if (together && !asks_)
    {
        return;
    }
    asks_ = false;
    const bool change = !found_ || cells != cells_;
    if (!(together ? onAny(change) : change))
    {
        return;
    }
    found_ = true;
    cells_ = cells;

    for (const label m : nodes_)
    {
        here_[m] = 0;
    }
    label lowest = here_.size(), highest = -1;
    const auto mark = [&](const label m)
    {
        here_[m] = 1;
        lowest = min(lowest, m);
        highest = max(highest, m);
    };
    for (const label celli : cells)
    {
        const label* nodes = vertices.nodes(celli);
        const label n = vertices.nVertices(celli);
        for (label i = 0; i < n; ++i)
        {
            mark(nodes[i]);
        }
    }
    nodes_.clear();
    for (label m = lowest; m <= highest; ++m)
    {
        if (here_[m])
        {
            nodes_.append(m);
        }
    }
    findMass();
    findRanges();
}
