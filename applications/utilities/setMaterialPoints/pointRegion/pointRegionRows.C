// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointRegion.H"

#include <algorithm>
#include <numeric>
#include "cornerRegions.H"
#include "meshShape.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The largest fraction of cells between points in a row without an end, less 1;
//  s: their distance in cells
Foam::scalar excess(const Foam::scalar s)
{
    constexpr int nPlaces = 32;

    Foam::scalar most = 0;
    for (int k = 0; k < nPlaces; ++k)
    {
        Foam::scalar sum = 0;
        for (Foam::scalar x = s * k / nPlaces - s * std::ceil(1.5 / s + 1); x < 1.5; x += s)
        {
            const Foam::scalar r = std::abs(x);
            sum += r < 0.5 ? s * (0.75 - r * r) : r < 1.5 ? s * 0.5 * (1.5 - r) * (1.5 - r) : 0;
        }
        most = std::max(most, sum);
    }
    return most - 1;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::pointRegion::standsInRows(const pointGrid& grid, const pointRegionShape& shape)
{
    if (!grid.hasLattice() || shape.type() != "box")
    {
        return false;
    }
    const int r = grid.radial();
    return r < 0 || shape.bounds().min()[grid.direction(r)] >= grid.lattice().planes(r)[2];
}

void Foam::mpm::pointRegion::setRings()
{
    const int d = grid_.radial();
    if (d < 0 || !inGas_ || !grid_.hasLattice())
    {
        return;
    }
    // What the points of a cell give to the cells beside (pointKernels) is as
    // much as they get: the first one of each cell is where that holds
    const scalarList& r = grid_.lattice().planes(d);
    const label n = n_[d];
    rings_.setSize((r.size() - 1) * n, Zero);
    scalar given = 0;
    for (label i = 1; i < r.size() - 2; ++i)
    {
        const scalar s = (r[i + 1] - r[i]) / n;
        const scalar below = sqr(r[i]) - sqr(max(r[i - 1], scalar(0)));
        const scalar above = sqr(r[i + 1]) - sqr(max(r[i], scalar(0)));
        for (label j = 0; j < n; ++j)
        {
            rings_[i * n + j] = r[i] + (j + 0.5) * s;
        }
        scalar& first = rings_[i * n];
        if (i > 1 && below > 0)
        {
            const scalar volume = first * s;
            scalar missing = given;
            for (label j = 1; j < n; ++j)
            {
                const scalar x = rings_[i * n + j];
                const scalar c = max(1 - (sqr(x) - sqr(r[i])) / below, scalar(0));
                missing -= 0.5 * sqr(c) * x * s;
            }
            const scalar c = std::sqrt(2 * max(missing, scalar(0)) / volume);
            const scalar x = std::sqrt(sqr(r[i]) + below * max(1 - c, scalar(0)));
            first = mag(x - first) < 0.25 * s ? x : first;
        }
        given = 0;
        for (label j = 0; j < n; ++j)
        {
            const scalar c = max(1 - (sqr(r[i + 1]) - sqr(rings_[i * n + j])) / above, scalar(0));
            given += 0.5 * sqr(c) * (r[i] + (j + 0.5) * s) * s;
        }
    }
}

void Foam::mpm::pointRegion::unequalRow(
    const int d, const scalar low, const scalar high, DynamicList<rowPoint>& row) const
{
    // Half-sizes at the sides over those of the sub-cell
    constexpr scalar least = 0.2;

    const scalarList& planes = grid_.lattice().planes(d);
    const bool rings = d == grid_.radial();
    scalar lost = 0;
    for (label i = 1; i < planes.size() - 2; ++i)
    {
        const scalar s = (planes[i + 1] - planes[i]) / n_[d];
        for (label j = 0; j < n_[d]; ++j)
        {
            const scalar x = planes[i] + (j + 0.5) * s;
            const scalar a = max(low, x - 0.5 * s), b = min(high, x + 0.5 * s);
            if (!(a < b))
            {
                continue;
            }
            const scalar length = (b - a) * (rings ? 0.5 * (a + b) : 1);
            if (b - a < smallPart * s && high - low > s)
            {
                row.size() ? row.last().length += length : lost = length;
                continue;
            }
            row.append(rowPoint{rings ? rings_[i * n_[d] + j] : x, 0.5 * s, length + lost});
            lost = 0;
        }
    }
    // The ends: with mass and centre of mass of the centres of sub-cells
    const label last = row.size() - 1;
    for (const bool upper : {false, true})
    {
        if (last < 0)
        {
            break;
        }
        rowPoint& p = row[upper ? last : 0];
        const scalar depth = upper ? high - p.x : p.x - low;
        if (depth >= least * p.l)
        {
            // Also where the point is not in the middle
            p.l = depth < 1.1 * p.l ? depth : p.l;
        }
        else if (last == 0)
        {
            p = {0.5 * (low + high), 0.5 * (high - low), p.length};
        }
        else
        {
            rowPoint& q = row[upper ? last - 1 : 1];
            p.l *= least;
            const scalar x = upper ? high - p.l : low + p.l;
            const scalar t = (x - p.x) / (q.x - p.x), more = t / (1 - t) * p.length;
            p.x = x;
            p.length += more;
            q.length -= more;
        }
    }
}

Foam::DynamicList<Foam::mpm::pointRegion::rowPoint> Foam::mpm::pointRegion::row(const int d) const
{
    constexpr scalar tolerance = 1e-9, most = 1e-3;

    // Cells of the mesh; planes have one more at each end
    const scalarList& planes = grid_.lattice().planes(d);
    const label nCells = planes.size() - 3;
    const int c = grid_.direction(d);
    const scalar low = max(shape_->bounds().min()[c], planes[1]);
    const scalar high = min(shape_->bounds().max()[c], planes[nCells + 1]);
    const scalar h = (planes[nCells + 1] - planes[1]) / nCells;

    bool equal = d != grid_.radial();
    for (label i = 1; i <= nCells; ++i)
    {
        equal = equal && mag(planes[i + 1] - planes[i] - h) < tolerance * h;
    }

    // No point is wider than a cell, and in all directions together no cell that
    // the box covers gets much too much
    DynamicList<rowPoint> row;
    const label n =
        max(label((high - low) / h * n_[d] + 0.5), label(std::ceil((high - low) / h - tolerance)));
    const bool tooMuch = high - low > 3 * h && grid_.nDim() * excess((high - low) / n / h) > most;
    if (low < high && equal && !tooMuch)
    {
        for (label i = 0; i < n; ++i)
        {
            const scalar x = low + (i + 0.5) / n * (high - low), s = (high - low) / n;
            row.append(rowPoint{x, 0.5 * s, s});
        }
    }
    else if (low < high)
    {
        unequalRow(d, low, high, row);
    }
    return row;
}

void Foam::mpm::pointRegion::fillRows(const scalar rho)
{
    const int nDim = grid_.nDim();
    const int radial = grid_.radial();

    DynamicList<rowPoint> rows[3];
    label n = 1;
    for (int d = 0; d < nDim; ++d)
    {
        rows[d] = row(d);
        n *= rows[d].size();
    }

    DynamicList<materialPointCloud::newPoint> points(n);
    labelList cellOf(n, -1);
    for (label i = 0; i < n; ++i)
    {
        materialPointCloud::newPoint p;
        p.x = p.U = p.halfSize = Zero;
        p.sigma = sigma_;
        p.T = T_;
        p.volume = volumeFraction_ * (radial < 0 ? shape_->section() : grid_.sector());
        scalar x[3] = {0, 0, 0};
        label rest = i;
        for (int d = 0; d < nDim; ++d)
        {
            const int c = grid_.direction(d);
            const rowPoint& at = rows[d][rest % rows[d].size()];
            rest /= rows[d].size();
            x[d] = p.x[c] = at.x;
            p.halfSize[c] = at.l;
            p.volume *= at.length;
        }
        p.mass = rho * p.volume;
        cellOf[i] = grid_.find(x);
        points.append(p);
    }

    store(points, cellOf);
}

void Foam::mpm::pointRegion::store(
    const UList<materialPointCloud::newPoint>& points, const labelUList& cellOf)
{
    // In the order of cells
    labelList order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
        order.begin(), order.end(),
        [&](const label a, const label b) { return cellOf[a] < cellOf[b]; });
    for (const label i : order)
    {
        const label celli = cellOf[i];
        if (celli < 0)
        {
            continue;
        }
        materialPointCloud::newPoint p(points[i]);
        for (int e = 0; e < 3; ++e)
        {
            if (p.halfSize[e] == 0)
            {
                p.x[e] = grid_.mesh().cellCentres()[celli][e];
            }
        }
        if (cells_.empty() || cells_.last() != celli)
        {
            cells_.append(celli);
            const label from = start_.last(); // append() may move the list
            start_.append(from);
        }
        points_.append(p);
        ++start_.last();
    }
}

Foam::label Foam::mpm::pointRegion::find(const point& at, const label near, point& moved) const
{
    scalar x[3] = {0, 0, 0};
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        x[d] = at[grid_.direction(d)];
    }

    // Elements beside each other follow each other in most files
    label celli = grid_.locatesAtOnce() ? label(-1) : grid_.locate(max(near, label(0)), x);
    if (celli < 0)
    {
        celli = grid_.find(x);
    }
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        // On a cyclic mesh
        moved[grid_.direction(d)] = x[d];
    }
    return celli;
}

void Foam::mpm::pointRegion::fillElements(const scalar rho)
{
    const bodyMesh& body = refCast<const meshShape>(*shape_).body();
    const int nDim = grid_.nDim();
    const int radial = grid_.radial();

    DynamicList<materialPointCloud::newPoint> points(nSub_ * body.size());
    DynamicList<label> cellOf(points.capacity());
    label celli = 0;
    for (label e = 0; e < body.size(); ++e)
    {
        const autoPtr<cellParts> parts(body.parts(e, n_[0]));
        const cellParts& r = *parts;
        const cornerRegions* c = isA<cornerRegions>(r);
        const bool whole = n_[0] == 1;
        for (label i = 0; i < (whole ? 1 : r.size()); ++i)
        {
            const scalar size = whole ? r.whole() : r.volume()[i];
            const point centre(whole ? r.centre() : r.centre(i));
            materialPointCloud::newPoint p;
            p.x = centre;
            p.U = p.halfSize = Zero;
            p.sigma = sigma_;
            p.T = T_;
            p.volume = size * volumeFraction_
                * (radial < 0 ? shape_->section()
                              : grid_.sector() * centre[grid_.direction(radial)]);
            p.mass = rho * p.volume;

            // Those of a cube (square) of its size, up to the outside
            vector l(Zero);
            for (int d = 0; d < nDim; ++d)
            {
                l[grid_.direction(d)] = 0.5 * std::pow(size, 1.0 / nDim);
            }
            const scalar fit = body.fit(e, whole || !c ? -1 : c->corners()[i], centre, l);
            p.halfSize = (bySimplices_ ? min(fit, scalar(1)) : fit) * l;

            celli = find(centre, celli, p.x);
            cellOf.append(celli);
            points.append(p);
        }
    }
    store(points, cellOf);
}
