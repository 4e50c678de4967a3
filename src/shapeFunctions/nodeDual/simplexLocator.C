// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "simplexLocator.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- In the order of their coordinates
bool before(const scalar* a, const scalar* b)
{
    return a[0] != b[0] ? a[0] < b[0] : a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}

scalar along(const scalar* n, const scalar* from, const scalar* to)
{
    return n[0] * (to[0] - from[0]) + n[1] * (to[1] - from[1]) + n[2] * (to[2] - from[2]);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::simplexLocator::setOpposite()
{
    const label n = nDim_ + 1;
    opposite_.setSize(n * mesh_.nCells(), -1);
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        if (!cells_.isSimplex(celli))
        {
            continue;
        }
        for (const label facei : mesh_.cells()[celli])
        {
            if (isEmpty_.test(facei) || !mesh_.isInternalFace(facei))
            {
                continue;
            }
            // The vertex that the face has not
            for (label i = 0; i < n; ++i)
            {
                bool found = false;
                for (const label pointi : mesh_.faces()[facei])
                {
                    found = found || nodes_.ofPoints()[pointi] == cells_.nodes(celli)[i];
                }
                if (!found)
                {
                    opposite_[n * celli + i] = behind(celli, facei);
                }
            }
        }
    }
}

template<int DIM>
void Foam::mpm::simplexLocator::follow(const label n, label* cell, const scalar* x) const
{
    // One cell of the way of each point after the other: the next one is on
    // its way from memory meanwhile
    label going[largestGroup];
    label nGoing = 0;
    for (label i = 0; i < n; ++i)
    {
        going[nGoing++] = i;
    }
    for (label step = 0; nGoing > 0; ++step)
    {
        label nNext = 0;
        for (label j = 0; j < nGoing; ++j)
        {
            const label i = going[j];
            const scalar* map = cells_.map(cell[i]);
            scalar y[DIM], least = 1, S0 = 1;
            label at = 0;
            for (int d = 0; d < DIM; ++d)
            {
                y[d] = x[3 * i + d] - map[d];
            }
            for (int k = 1; k <= DIM; ++k)
            {
                scalar S = map[DIM * k] * y[0];
                for (int d = 1; d < DIM; ++d)
                {
                    S += map[DIM * k + d] * y[d];
                }
                S0 -= S;
                at = S < least ? k : at;
                least = min(S, least);
            }
            at = S0 < least ? 0 : at;
            least = min(S0, least);
            if (least > 1e-9)
            {
                continue;
            }
            const label next = opposite_[(DIM + 1) * cell[i] + at];
            cell[i] = least < -1e-9 && step < 50 ? next : -1;
            if (cell[i] >= 0)
            {
                const char* to = reinterpret_cast<const char*>(cells_.map(next));
                __builtin_prefetch(to);
                __builtin_prefetch(to + 64);
                going[nNext++] = i;
            }
        }
        nGoing = nNext;
    }
}

Foam::scalar Foam::mpm::simplexLocator::beyondSimplex(
    const label celli, const label s, const scalar* x, scalar* normal) const
{
    const label* corner = cells_.corners(celli) + 3 * s;
    const scalar* p[3];
    for (int k = 0; k < 3; ++k)
    {
        p[k] = cells_.position(celli, corner[k]);
    }
    for (const int k : {0, 1, 0})
    {
        if (before(p[k + 1], p[k]))
        {
            std::swap(p[k], p[k + 1]);
        }
    }
    const scalar a[3] = {p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2]};
    const scalar b[3] = {p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2]};
    const scalar n[3] = {
        a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const scalar size = std::sqrt(sqr(n[0]) + sqr(n[1]) + sqr(n[2]));
    const scalar d = along(n, p[0], x) / size;
    const bool outward = along(n, p[0], cells_.origin(celli)) < 0;
    for (int k = 0; normal && k < 3; ++k)
    {
        normal[k] = (outward ? n[k] : -n[k]) / size;
    }
    return outward ? d : -d;
}

void Foam::mpm::simplexLocator::normal(
    const label celli, const label facei, const scalar* x, scalar* n) const
{
    if (nDim_ == 3 && mesh_.faces()[facei].size() > 3 && !cells_.isSimplex(celli))
    {
        beyondSimplex(celli, cells_.simplexOf(celli, x), x, n);
        return;
    }
    const vector& S = mesh_.faceAreas()[facei];
    scalar size = 0;
    for (int d = 0; d < nDim_; ++d)
    {
        size += sqr(S[axes_.direction(d)]);
    }
    size = std::sqrt(max(size, VSMALL));
    for (int d = 0; d < nDim_; ++d)
    {
        n[d] = (mesh_.faceOwner()[facei] == celli ? 1 : -1) * S[axes_.direction(d)] / size;
    }
}

Foam::label
Foam::mpm::simplexLocator::exit(const label celli, const scalar* x, scalar& beyond) const
{
    label through = -1;
    beyond = 0;
    const auto ask = [&](const label facei, const scalar out)
    {
        const bool inside = mesh_.isInternalFace(facei);
        const scalar allowed =
            inside ? 0 : (behind(celli, facei) < 0 ? 1e-10 : 1e-12) * width(celli, 0);
        const bool onFace = inside && out == 0 && mesh_.faceOwner()[facei] != celli;
        if (out > max(allowed, beyond) || (onFace && through < 0))
        {
            beyond = out;
            through = facei;
        }
    };
    if (!cells_.isSimplex(celli))
    {
        const label s = cells_.simplexOf(celli, x);
        const label facei = cells_.faceOf(celli, s);
        if (facei < 0)
        {
            // The axis of a wedge
            return -1;
        }
        const bool plane = nDim_ < 3 || mesh_.faces()[facei].size() == 3;
        ask(facei, plane ? faceLocator::beyond(celli, facei, x) : beyondSimplex(celli, s, x));
        return through;
    }
    for (const label facei : mesh_.cells()[celli])
    {
        if (!isEmpty_.test(facei))
        {
            ask(facei, faceLocator::beyond(celli, facei, x));
        }
    }
    return through;
}

Foam::label Foam::mpm::simplexLocator::search(const scalar* x) const
{
    scalar beyond;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        if (exit(celli, x, beyond) < 0)
        {
            return celli;
        }
    }
    return -1;
}

Foam::label Foam::mpm::simplexLocator::around(const label celli, const scalar* x) const
{
    scalar beyond;
    for (const label n : nodes_.ofCell(celli))
    {
        for (const label c : nodes_.cellsOf(n))
        {
            if (exit(c, x, beyond) < 0)
            {
                return c;
            }
        }
    }
    return -1;
}

Foam::label Foam::mpm::simplexLocator::inCircle(const label celli, const scalar* x) const
{
    label c = celli, lowest = celli;
    scalar worst = 0;
    do
    {
        scalar out;
        c = behind(c, exit(c, x, out));
        worst = max(worst, out);
        lowest = min(lowest, c);
    } while (c != celli);

    const label found = worst > 1e-12 * width(celli, 0) ? search(x) : -1;
    return found < 0 && worst < 1e-9 * width(celli, 0) ? lowest : found;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::simplexLocator::simplexLocator(
    const polyMesh& mesh, const gridAxes& axes, const gridNodes& nodes, const cellSimplices& cells,
    ghostCells& ghosts) :
    faceLocator(mesh, axes, ghosts), nodes_(nodes), cells_(cells)
{
    if (cells.hasMaps())
    {
        setOpposite();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::simplexLocator::locate(const label from, scalar* x) const
{
    // A circle of cells is found by a cell that is kept for 2, 4, 8... steps
    label celli = from, kept = -1, until = 2;
    for (label step = 0; step < 10000; ++step)
    {
        if (celli >= mesh_.nCells())
        {
            // Its processor goes on
            return celli;
        }
        if (celli == kept)
        {
            return inCircle(celli, x);
        }
        if (step == until)
        {
            kept = celli;
            until *= 2;
        }

        scalar out;
        const label facei = exit(celli, x, out);
        if (facei < 0)
        {
            return celli;
        }
        const label next = behind(celli, facei);
        if (next < 0)
        {
            return around(celli, x);
        }
        if (!mesh_.isInternalFace(facei))
        {
            pass(facei, x);
            kept = -1;
        }
        celli = next;
    }
    return -1;
}

void Foam::mpm::simplexLocator::locateAll(const label n, label* cell, scalar* x) const
{
    for (label first = 0; first < n; first += largestGroup)
    {
        const label m = min(n - first, largestGroup);
        label* from = cell + first;
        scalar* at = x + 3 * first;
        label to[largestGroup];
        std::fill_n(to, m, -1);
        if (opposite_.size())
        {
            std::copy_n(from, m, to);
            nDim_ == 1       ? follow<1>(m, to, at)
                : nDim_ == 2 ? follow<2>(m, to, at)
                             : follow<3>(m, to, at);
        }
        for (label i = 0; i < m; ++i)
        {
            from[i] = to[i] >= 0 ? to[i] : locate(from[i], at + 3 * i);
        }
    }
}

Foam::label Foam::mpm::simplexLocator::find(scalar* x) const
{
    scalar at[3] = {0, 0, 0};
    std::copy_n(x, nDim_, at);
    const label celli = faceLocator::find(x);
    if (celli < 0)
    {
        std::copy_n(at, nDim_, x);
        return search(x);
    }
    return celli;
}

Foam::label Foam::mpm::simplexLocator::patchOut(const label celli, const scalar* x) const
{
    scalar at[3] = {0, 0, 0};
    std::copy_n(x, nDim_, at);
    wayOut out;
    return leaves(celli, at, out) ? mesh_.boundaryMesh().whichPatch(out.face) : -1;
}

bool Foam::mpm::simplexLocator::leaves(const label from, scalar* x, wayOut& out) const
{
    label celli = from;
    for (int step = 0; step < 100 && celli < mesh_.nCells(); ++step)
    {
        const label facei = exit(celli, x, out.beyond);
        if (facei < 0)
        {
            return false;
        }
        const label next = behind(celli, facei);
        if (next < 0)
        {
            out.cell = celli;
            out.face = facei;
            normal(celli, facei, x, out.normal);
            return true;
        }
        if (!mesh_.isInternalFace(facei))
        {
            pass(facei, x);
        }
        celli = next;
    }
    return false;
}
