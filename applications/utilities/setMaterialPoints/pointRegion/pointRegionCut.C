// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointRegion.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

namespace
{

//- A box below this goes to a point beside: at faces along the axes it keeps
//  its size, which then is small; others are drawn in
constexpr Foam::scalar smallBox = 0.1;

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::mpm::pointRegion::cutSubCell(
    const label celli, const hexMap& map, const label sub, cutPoint& c, scalar& part) const
{
    if (!formula_ && !cutter_)
    {
        return shares_ ? shareSubCell(celli, map, sub, c, part)
                       : sampleSubCell(celli, map, sub, c, part);
    }

    const int nDim = grid_.nDim();
    label ijk[3] = {0, 0, 0}, rest = sub;
    scalar xi[3], x[3] = {0, 0, 0}, half[3] = {0, 0, 0};
    centre(sub, xi);
    c.mean = map.position(xi);
    c.whole = 1;
    for (int d = 0; d < nDim; ++d)
    {
        ijk[d] = rest % n_[d];
        rest /= n_[d];
        x[d] = c.mean[grid_.direction(d)];
        half[d] = 0.5 * grid_.width(celli, d) / n_[d];
        c.whole *= 2 * half[d];
    }

    cutMoments m;
    if (formula_)
    {
        const int found = formula_->integrate(celli, nDim, grid_.radial(), x, half, m, c.surfaces);
        if (found < 2)
        {
            return found;
        }
    }
    else
    {
        cutter_->integrate(celli, ijk, m, c.surfaces);
    }

    const scalar all = scalar(1 << nDim);
    if (m.area() < tolerance * all)
    {
        return 0;
    }
    if (m.area() > (1 - tolerance) * all)
    {
        return 1;
    }
    part = m.ring() / all;
    c.area = c.whole * m.area() / all;
    c.variance = Zero;
    for (int d = 0; d < nDim; ++d)
    {
        const scalar mean = m.first(d) / m.area();
        c.mean[grid_.direction(d)] += half[d] * mean;
        c.variance[grid_.direction(d)] =
            sqr(half[d]) * max(m.second(d) / m.area() - sqr(mean), scalar(0));
    }
    return 2;
}

int Foam::mpm::pointRegion::sampleSubCell(
    const label celli, const hexMap& map, const label sub, cutPoint& c, scalar& part) const
{
    scalar xi[3];
    pointField x(nSamples_);
    forAll(x, i)
    {
        local(sub, i, xi);
        x[i] = map.position(xi);
    }
    const boolList inside(shape_->contains(celli, x));

    label n = 0;
    c.mean = Zero;
    forAll(x, i)
    {
        if (inside[i])
        {
            ++n;
            c.mean += x[i];
        }
    }
    if (n == 0 || n == nSamples_)
    {
        return n == 0 ? 0 : 1;
    }
    part = scalar(n) / nSamples_;
    c.mean /= n;
    centre(sub, xi);
    c.whole = 1;
    c.variance = Zero;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        const scalar half = mag(map.tangent(xi, d)) / (2 * n_[d]);
        c.whole *= 2 * half;
        c.variance[grid_.direction(d)] = sqr(half) / 3 * std::pow(part, 2.0 / grid_.nDim());
    }
    c.area = part * c.whole;
    c.mean = map.position(xi);
    c.variance *= std::pow(part, -2.0 / grid_.nDim());
    return 2;
}

Foam::label
Foam::mpm::pointRegion::beside(const label k, const label sub, const int d, const int side) const
{
    label stride = 1;
    for (int e = 0; e < d; ++e)
    {
        stride *= n_[e];
    }
    const label i = (sub / stride) % n_[d];

    label celli = cells_[k], other = sub + (side ? stride : -stride);
    if (i == (side ? n_[d] - 1 : 0))
    {
        // Of a mesh without a lattice cells turn their directions
        celli = grid_.hasLattice() ? grid_.neighbour(celli, d, side) : label(-1);
        other = sub + (side ? -1 : 1) * stride * (n_[d] - 1);
    }
    if (celli < 0 || grid_.period(d) > 0)
    {
        return -1;
    }
    const auto cell = std::lower_bound(cells_.begin(), cells_.end(), celli);
    if (cell == cells_.end() || *cell != celli)
    {
        return -1;
    }
    const label otherK = cell - cells_.begin();
    const auto end = sub_.begin() + start_[otherK + 1];
    const auto p = std::lower_bound(sub_.begin() + start_[otherK], end, other);
    return p == end || *p != other ? -1 : label(p - sub_.begin());
}

Foam::vector Foam::mpm::pointRegion::boxOf(const cutPoint& c) const
{
    vector l(Zero);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        const int e = grid_.direction(d);
        l[e] = std::sqrt(3 * c.variance[e]);
    }
    return l;
}

bool Foam::mpm::pointRegion::isBox(const label celli, const cutPoint& c) const
{
    // It reaches the surfaces and not beyond
    const vector l(boxOf(c));
    vector way;
    return sampled_
        || (fit(celli, c, c.mean, l, false, way) == 1
            && fit(celli, c, c.mean, (1 + 1e-6) * l, false, way) < 1);
}

Foam::label Foam::mpm::pointRegion::fullestBeside(
    const label k, const label p, const boolList& gone, scalar& part) const
{
    label best = -1;
    part = 0;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        for (int side = 0; side < 2; ++side)
        {
            const label q = beside(k, sub_[p], d, side);
            if (q < 0 || gone[q])
            {
                continue;
            }
            const auto cut = cutOf_.cfind(q);
            const scalar area = cut.good() ? cut_[*cut].area / cut_[*cut].whole : scalar(1);
            if (area > part)
            {
                part = area;
                best = q;
            }
        }
    }
    return best;
}

void Foam::mpm::pointRegion::join(const label p, const label best)
{
    materialPointCloud::newPoint& to = points_[best];
    if (!cutOf_.found(best))
    {
        cutPoint full;
        full.point = best;
        full.whole = 1;
        full.mean = to.x;
        full.variance = cmptMultiply(to.halfSize, to.halfSize) / 3;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            full.whole *= 2 * to.halfSize[grid_.direction(d)];
        }
        full.area = full.whole;
        cutOf_.insert(best, cut_.size());
        cut_.append(full);
    }
    cutPoint& a = cut_[cutOf_[best]];
    const cutPoint& b = cut_[cutOf_[p]];
    const scalar area = a.area + b.area;
    const vector apart(b.mean - a.mean);
    a.variance = (a.area * a.variance + b.area * b.variance) / area
        + a.area * b.area / sqr(area) * cmptMultiply(apart, apart);
    a.mean += (b.area / area) * apart;
    a.area = area;
    for (const label s : b.surfaces)
    {
        if (!a.surfaces.found(s))
        {
            a.surfaces.append(s);
        }
    }
    to.volume += points_[p].volume;
    to.mass += points_[p].mass;
}

void Foam::mpm::pointRegion::joinSmallParts()
{
    if (byCorners_)
    {
        return;
    }
    boolList gone(points_.size(), false);
    bool any = false;

    forAll(cells_, k)
    {
        for (label p = start_[k]; p < start_[k + 1]; ++p)
        {
            const auto small = cutOf_.cfind(p);
            if (!small.good())
            {
                continue;
            }
            const cutPoint& c = cut_[*small];
            const scalar part = c.area / c.whole;
            if (part >= (!inGas_ && isBox(cells_[k], c) ? smallBox : smallPart))
            {
                continue;
            }
            scalar partOfBest;
            const label best = fullestBeside(k, p, gone, partOfBest);
            if (best >= 0 && partOfBest > part)
            {
                join(p, best);
                gone[p] = any = true;
            }
        }
    }
    if (any)
    {
        remove(gone);
    }
}

void Foam::mpm::pointRegion::remove(const boolList& gone)
{
    labelList now(points_.size(), -1);
    label n = 0, nCells = 0, first = 0;
    forAll(cells_, k)
    {
        const label last = start_[k + 1];
        const label nBefore = n;
        for (label p = first; p < last; ++p)
        {
            if (!gone[p])
            {
                now[p] = n;
                points_[n] = points_[p];
                sub_[n++] = sub_[p];
            }
        }
        first = last;
        if (n > nBefore)
        {
            cells_[nCells++] = cells_[k];
            start_[nCells] = n;
        }
    }
    points_.resize(n);
    sub_.resize(n);
    cells_.resize(nCells);
    start_.resize(nCells + 1);
    cutOf_.clear();
    forAll(cut_, i)
    {
        cutPoint& c = cut_[i];
        c.point = c.point < 0 ? c.point : now[c.point];
        if (c.point >= 0)
        {
            cutOf_.insert(c.point, i);
        }
    }
}
