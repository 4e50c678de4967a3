// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "simplexParts.H"
#include "pointGrid.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Parts along each edge of the simplices of a cell that is one or not
label alongEdges(const bool isSimplex, const label n) { return isSimplex ? n - 1 : n / 2; }

label alongEdges(const Foam::mpm::cellSimplices& cells, const label celli, const label n)
{
    return cells.isBox(celli) ? n : alongEdges(cells.isSimplex(celli), n);
}

//- Simplices that are divided, a box as one
label nWhole(const Foam::mpm::cellSimplices& cells, const label celli)
{
    return cells.isBox(celli) ? label(1) : cells.nSimplices(celli);
}

label nParts(const int nDim, const label k) { return nDim == 3 ? k * k * k : k * k; }

label nTriangles(const faceList& faces)
{
    label n = 0;
    for (const face& f : faces)
    {
        n += f.size() == 3 ? 1 : f.size();
    }
    return n;
}

scalar volumeOf(const FixedList<point, 4>& y)
{
    return mag((y[1] - y[0]) & ((y[2] - y[0]) ^ (y[3] - y[0]))) / 6;
}

scalar areaOf(const FixedList<point, 4>& y) { return 0.5 * mag((y[1] - y[0]) ^ (y[2] - y[0])); }

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::simplexParts::simplexParts(const int nDim, const label k, const label nSimplices) :
    cellParts(nSimplices * nParts(nDim, k)), k_(k), n_(0)
{
}

void Foam::mpm::simplexParts::divide(
    const int nDim, const FixedList<point, 4>& y, const scalar volume, const bool box)
{
    const label all = nParts(nDim, k_);
    for (label cube = 0; cube < all; ++cube)
    {
        int order[3] = {0, 1, 2};
        do
        {
            // Along one edge of the cube after the other
            label z[3] = {cube % k_, cube / k_ % k_, nDim == 3 ? cube / (k_ * k_) : 0};
            bool inside = true;
            FixedList<point, 4> x;
            point mean(Zero);
            for (int v = 0; v <= nDim; ++v)
            {
                x[v] = y[0];
                for (int i = 0; i < nDim; ++i)
                {
                    x[v] += (scalar(z[i]) / k_) * (y[i + 1] - y[i]);
                    inside = inside && (box || i == 0 || z[i - 1] >= z[i]);
                }
                mean += x[v] / (nDim + 1);
                if (v < nDim)
                {
                    ++z[order[v]];
                }
            }
            if (inside)
            {
                x[3] = x[nDim];
                add(box ? cube : n_++, volume / (box ? nDim * (nDim - 1) * all : all), mean,
                    nDim + 1, x);
            }
        } while (std::next_permutation(order, order + nDim));
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::simplexParts::number(const pointGrid& grid, const label celli, const label n)
{
    const cellSimplices& cells = grid.simplices();
    return nWhole(cells, celli) * nParts(grid.nDim(), alongEdges(cells, celli, n));
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::simplexParts::simplexParts(const pointGrid& grid, const label celli, const label n) :
    simplexParts(
        grid.nDim(), alongEdges(grid.simplices(), celli, n), nWhole(grid.simplices(), celli))
{
    const cellSimplices& cells = grid.simplices();
    const int nDim = grid.nDim();
    const auto place = [&](const scalar* x)
    {
        point at(grid.mesh().cellCentres()[celli]);
        for (int d = 0; d < nDim; ++d)
        {
            at[grid.direction(d)] = x[d];
        }
        return at;
    };
    if (cells.isBox(celli))
    {
        FixedList<point, 4> y(place(cells.position(celli, 0)));
        scalar volume = 1;
        for (int i = 1; i <= nDim; ++i)
        {
            y[i] = place(cells.position(celli, (1 << i) - 1));
            volume *= mag(y[i] - y[i - 1]);
        }
        divide(nDim, y, volume, true);
        return;
    }
    for (label s = 0; s < cells.nSimplices(celli); ++s)
    {
        FixedList<point, 4> y(place(cells.origin(celli)));
        for (int i = 0; i < nDim; ++i)
        {
            const label corner = cells.corners(celli)[nDim * s + i];
            y[i + 1] = place(cells.position(celli, corner));
        }
        divide(nDim, y, cells.volumes(celli)[s]);
    }
}

Foam::mpm::simplexParts::simplexParts(
    const labelUList& corners, const faceList& faces, const UList<point>& points, const label n) :
    simplexParts(
        3, alongEdges(corners.size() == 4, n), corners.size() == 4 ? label(1) : nTriangles(faces))
{
    if (corners.size() == 4)
    {
        FixedList<point, 4> y;
        forAll(y, i)
        {
            y[i] = points[corners[i]];
        }
        divide(3, y, volumeOf(y));
        return;
    }
    const auto meanOf = [&](const labelUList& some)
    {
        point mean(Zero);
        for (const label i : some)
        {
            mean += points[i] / some.size();
        }
        return mean;
    };
    const point O(meanOf(corners));
    for (const face& f : faces)
    {
        const point F(meanOf(f));
        for (label i = 0; i < (f.size() == 3 ? 1 : f.size()); ++i)
        {
            const edge e(f.faceEdge(i));
            const FixedList<point, 4> y(
                {O, f.size() == 3 ? points[f[2]] : F, points[e.first()], points[e.second()]});
            divide(3, y, volumeOf(y));
        }
    }
}

Foam::mpm::simplexParts::simplexParts(const face& f, const pointField& points, const label n) :
    simplexParts(2, alongEdges(f.size() == 3, n), f.size() == 3 ? label(1) : f.size())
{
    const point O(f.average(points, points));
    for (label i = 0; i < (f.size() == 3 ? 1 : f.size()); ++i)
    {
        const edge e(f.faceEdge(i));
        const point& last = points[e.second()];
        const FixedList<point, 4> y(
            {f.size() == 3 ? points[f[2]] : O, points[e.first()], last, last});
        divide(2, y, areaOf(y));
    }
}
