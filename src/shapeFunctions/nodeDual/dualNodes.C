/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "dualNodes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::dualNodes::reached(const label l) const
{
    for (label e = dual_.begin(l); e < dual_.begin(l + 1); ++e)
    {
        const label m = dual_.node(e);
        if (!here_[m])
        {
            continue;
        }
        if (m == l || !dual_.reduced(m))
        {
            return true;
        }
        for (label i = dual_.begin(m); i < dual_.begin(m + 1); ++i)
        {
            if (dual_.node(i) == l && dual_.W(i) > 0)
            {
                return true;
            }
        }
    }
    return false;
}


bool Foam::mpm::dualNodes::addWall(const label m)
{
    const label start = hasMass_.size();
    bool all = true;
    for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
    {
        const label l = dual_.node(e);
        hasMass_.append(here_[l] || dual_.W(e) > 0 || reached(l));
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
        const bool follows =
            ranges_.size() && ranges_.last().end == m
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
        if
        (
            n && !alike && !ranges_[n - 1].alike
         && ranges_[n - 1].end == r.first
        )
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

Foam::mpm::dualNodes::dualNodes(const label nNodes, const nodeDual& dual)
:
    dual_(dual),
    found_(false),
    here_(nNodes, char(0))
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::dualNodes::update
(
    const labelList& cells,
    const cellSimplices& vertices,
    const labelUList& always
)
{
    if (found_ && cells == cells_)
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
    for (const label m : always)
    {
        mark(m);
    }
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
    findRanges();
}

// ************************************************************************* //
