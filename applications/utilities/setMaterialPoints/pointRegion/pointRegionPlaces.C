// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointRegion.H"
#include "triPointRef.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

namespace
{

//- As far beyond a surface another region may begin, in half-sizes
constexpr Foam::scalar beyond = 1e-3;

//- Half-sizes at a surface, over those of the sub-cell, are this at least
constexpr Foam::scalar least = 0.2;

//- Of parts of cells of any kind they are between these
constexpr Foam::scalar thinnest = 1e-6, most = 2;

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::mpm::pointRegion::cellOf(const label p) const
{
    return std::upper_bound(start_.begin(), start_.end(), p) - start_.begin() - 1;
}

Foam::point Foam::mpm::pointRegion::positionOf(const scalar* x, const point& other) const
{
    point at(other);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        at[grid_.direction(d)] = x[d];
    }
    return at;
}

bool Foam::mpm::pointRegion::goesOn(const label celli, const point& x) const
{
    for (const pointRegionShape* shape : joined_)
    {
        if (shape->contains(celli, x))
        {
            return true;
        }
    }
    return false;
}

Foam::scalar Foam::mpm::pointRegion::fit(
    const label celli, const cutPoint& c, const point& x, const vector& l, const bool inBody,
    vector& way) const
{
    const int nDim = grid_.nDim();
    scalar factor = 1, least = GREAT;
    for (int d = 0; d < nDim; ++d)
    {
        least = min(least, l[grid_.direction(d)]);
    }
    way = Zero;
    const auto touch = [&](const scalar distance, const vector& n)
    {
        const scalar R = mag(cmptMultiply(l, n));
        if (distance < factor * R
            && !(inBody && goesOn(celli, x + (distance + beyond * least) * n)))
        {
            factor = distance / R;
            way = (distance - R) * n;
        }
    };

    if (formula_ || shares_)
    {
        const shapeFormula& formula = formula_ ? *formula_ : whole_;
        scalar at[3] = {0, 0, 0}, g[3], along[3], foot[3], t[2];
        for (int d = 0; d < nDim; ++d)
        {
            at[d] = x[grid_.direction(d)];
        }
        for (const label i : c.surfaces)
        {
            const quadratic& f = formula.surfaceAt(i);
            f.gradient(at, g);
            vector n(Zero);
            for (int d = 0; d < nDim; ++d)
            {
                n[grid_.direction(d)] = g[d];
            }
            if (!(mag(n) > 0))
            {
                continue;
            }
            n /= mag(n);
            for (int d = 0; d < 3; ++d)
            {
                along[d] = d < nDim ? n[grid_.direction(d)] : 0;
            }
            // Along the normal and beyond: does the shape end there?
            const int nRoots = f.rootsAlong(at, along, t);
            for (int r = 0; r < nRoots; ++r)
            {
                const scalar side = t[r] < 0 ? -1 : 1;
                bool inside[2];
                for (int s = 0; s < 2; ++s)
                {
                    const scalar eps = 1e-6 * least * side;
                    for (int d = 0; d < 3; ++d)
                    {
                        foot[d] = at[d] + along[d] * (t[r] + (s ? eps : -eps));
                    }
                    inside[s] = formula_ ? formula_->contains(celli, foot)
                                         : shape_->contains(celli, positionOf(foot, x));
                }
                if (inside[0] && !inside[1])
                {
                    touch(mag(t[r]), side * n);
                }
            }
        }
    }
    else if (cutter_)
    {
        const triSurface& s = *shape_->facets();
        for (const label i : c.surfaces)
        {
            const triPointRef facet(s.points()[s[i][0]], s.points()[s[i][1]], s.points()[s[i][2]]);
            const vector n(shape_->computed(facet.nearestPoint(x).rawPoint() - x));
            if (mag(n) > 0)
            {
                touch(mag(n), n / mag(n));
            }
        }
    }
    point foot;
    if (shares_ && shape_->nearest(x, foot))
    {
        const vector n(shape_->computed(foot - x));
        if (mag(n) > 0)
        {
            touch(mag(n), n / mag(n));
        }
    }
    return factor > 1 - 1e-9 ? 1 : factor;
}

void Foam::mpm::pointRegion::placeCutPoints()
{
    constexpr label nTries = 30;

    for (const cutPoint& c : cut_)
    {
        if (c.point < 0)
        {
            continue;
        }
        materialPointCloud::newPoint& p = points_[c.point];
        const label k = cellOf(c.point);

        const vector l(boxOf(c));
        p.x = c.mean;
        if (isBox(cells_[k], c))
        {
            p.halfSize = l;
            continue;
        }

        // The box need not be full where another region goes on
        vector way;
        if (joined_.size() && fit(cells_[k], c, p.x, p.halfSize, true, way) == 1)
        {
            p.halfSize = l;
            continue;
        }

        // A full box is drawn in, surface by surface
        bool fits = false;
        for (label i = 0; i < nTries && !fits; ++i)
        {
            fits = fit(cells_[k], c, p.x, p.halfSize, true, way) == 1;
            p.x += fits ? vector(Zero) : way;
        }
        scalar x[3];
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            x[d] = p.x[grid_.direction(d)];
        }
        if (!fits || !shape_->contains(cells_[k], p.x)
            || (grid_.locate(cells_[k], x) < 0 && grid_.find(x) < 0))
        {
            // Too thin for it, or the mesh ends here
            p.x = c.mean;
            p.halfSize = max(fit(cells_[k], c, p.x, l, true, way), least) * l;
        }
    }
}

Foam::scalar Foam::mpm::pointRegion::room(
    const label k, const cutPoint& c, const point& x, const vector& l) const
{
    vector way;
    return shape_->contains(cells_[k], x) || goesOn(cells_[k], x)
        ? fit(cells_[k], c, x, l, true, way)
        : scalar(0);
}

bool Foam::mpm::pointRegion::drawIn(const cutPoint& c, const label k, const boolList& stays)
{
    // The points around, those first that lie along the way inwards
    constexpr scalar along = 0.3, farthest = 0.8, mostTaken = 0.5;
    constexpr int nHalvings = 8;

    materialPointCloud::newPoint& p = points_[c.point];
    const vector inwards(shape_->computed(c.mean - p.x));
    DynamicList<std::pair<scalar, label>> around;
    const int nAround = grid_.nDim() == 1 ? 3 : grid_.nDim() == 2 ? 9 : 27;
    for (int n = 0; n < nAround; ++n)
    {
        label q = c.point;
        for (int d = 0, rest = n; d < grid_.nDim() && q >= 0; ++d, rest /= 3)
        {
            q = rest % 3 == 1 ? q : beside(cellOf(q), sub_[q], d, rest % 3 == 2);
        }
        if (q >= 0 && q != c.point && stays[q])
        {
            const vector way(shape_->computed(points_[q].x - p.x));
            const scalar cosine = (way & inwards) / max(mag(way) * mag(inwards), VSMALL);
            if (cosine > along)
            {
                around.append({-cosine, q});
            }
        }
    }
    std::sort(around.begin(), around.end());

    for (const auto& a : around)
    {
        materialPointCloud::newPoint& q = points_[a.second];
        const point from(p.x);
        const auto at = [&](const scalar t) { return point(from + t * (q.x - from)); };
        scalar low = 0, high = farthest;
        if (room(k, c, at(high), p.halfSize) < least)
        {
            continue;
        }
        for (int i = 0; i < nHalvings; ++i)
        {
            const scalar t = 0.5 * (low + high);
            (room(k, c, at(t), p.halfSize) < least ? low : high) = t;
        }
        const scalar part = high / (1 - high);
        if (part * p.volume > mostTaken * q.volume)
        {
            continue;
        }
        q.volume -= part * p.volume;
        q.mass -= part * p.mass;
        p.volume *= 1 + part;
        p.mass *= 1 + part;
        p.x = at(high);
        p.halfSize *= room(k, c, p.x, p.halfSize);
        return true;
    }
    return false;
}

void Foam::mpm::pointRegion::placeInGas()
{
    boolList stays(points_.size(), true);
    for (const cutPoint& c : cut_)
    {
        if (c.point >= 0)
        {
            materialPointCloud::newPoint& p = points_[c.point];
            const scalar r = room(cellOf(c.point), c, p.x, p.halfSize);
            stays[c.point] = r >= least;
            p.halfSize *= stays[c.point] ? r : scalar(1);
        }
    }
    for (const cutPoint& c : cut_)
    {
        if (c.point < 0 || stays[c.point] || drawIn(c, cellOf(c.point), stays))
        {
            continue;
        }
        // Too thin for it
        materialPointCloud::newPoint& p = points_[c.point];
        const vector l(boxOf(c));
        p.x = c.mean;
        p.halfSize = max(room(cellOf(c.point), c, p.x, l), least) * l;
    }
}

void Foam::mpm::pointRegion::fitParts()
{
    constexpr scalar largest = 4;

    // Cells that are cut, those beside them and beside cells without points
    labelHashSet near;
    const labelHashSet filled(cells_);
    for (const label celli : cells_)
    {
        for (const label other : grid_.mesh().cellCells()[celli])
        {
            if (!filled.found(other))
            {
                near.insert(celli);
            }
        }
    }
    for (const cutPoint& c : cut_)
    {
        if (c.point < 0)
        {
            continue;
        }
        const label k = cellOf(c.point);
        materialPointCloud::newPoint& p = points_[c.point];
        const scalar r = largest * room(k, c, p.x, largest * p.halfSize);
        p.halfSize *= r < largest ? min(max(r, thinnest), most) : 1;
        near.insert(cells_[k]);
        near.insert(grid_.mesh().cellCells()[cells_[k]]);
    }
    cutPoint whole;
    whole.addSurfaces(whole_.nSurfaces());
    forAll(cells_, k)
    {
        for (label p = start_[k]; near.found(cells_[k]) && p < start_[k + 1]; ++p)
        {
            if (!cutOf_.found(p))
            {
                vector& l = points_[p].halfSize;
                l *= max(room(k, whole, points_[p].x, l), thinnest);
            }
        }
    }
}
