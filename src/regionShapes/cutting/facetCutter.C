// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "facetCutter.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

typedef std::array<scalar, 3> corner;

//- The part of a polygon with side*(x_d - at) <= 0
std::vector<corner>
clipped(const std::vector<corner>& p, const int d, const scalar at, const scalar side)
{
    std::vector<corner> q;
    q.reserve(p.size() + 1);
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const corner& a = p[i];
        const corner& b = p[(i + 1) % p.size()];
        const scalar fa = side * (a[d] - at), fb = side * (b[d] - at);
        if (fa <= 0)
        {
            q.push_back(a);
        }
        if ((fa < 0 && fb > 0) || (fa > 0 && fb < 0))
        {
            corner c;
            for (int e = 0; e < 3; ++e)
            {
                c[e] = a[e] + (b[e] - a[e]) * (fa / (fa - fb));
            }
            c[d] = at;
            q.push_back(c);
        }
    }
    return q;
}

//- Call f(corner, weight) for positions whose weighted sum is the integral over
//  the polygon's area seen along direction 0, exact to the fifth degree
template<class Function>
void sumOver(const std::vector<corner>& p, const Function& f)
{
    // Radon's rule of 7 points
    const scalar s = std::sqrt(15.0);
    const scalar a = (6 - s) / 21, b = (6 + s) / 21;
    const scalar wa = (155 - s) / 1200, wb = (155 + s) / 1200;
    const scalar rule[7][3] = {{1.0 / 3, 1.0 / 3, 9.0 / 40},
                               {a, a, wa},
                               {1 - 2 * a, a, wa},
                               {a, 1 - 2 * a, wa},
                               {b, b, wb},
                               {1 - 2 * b, b, wb},
                               {b, 1 - 2 * b, wb}};
    for (std::size_t i = 2; i < p.size(); ++i)
    {
        corner u, v;
        for (int e = 0; e < 3; ++e)
        {
            u[e] = p[i - 1][e] - p[0][e];
            v[e] = p[i][e] - p[0][e];
        }
        const scalar area = 0.5 * (u[1] * v[2] - u[2] * v[1]);
        for (const auto& r : rule)
        {
            corner x;
            for (int e = 0; e < 3; ++e)
            {
                x[e] = p[0][e] + r[0] * u[e] + r[1] * v[e];
            }
            f(x, r[2] * area);
        }
    }
}

//- First interval of ascending planes that reaches beyond x, and the last that
//  begins before y
void span(const scalarList& planes, const scalar x, const scalar y, label& first, label& last)
{
    const auto begin = planes.begin(), end = planes.end();
    first = label(std::upper_bound(begin, end, x) - begin) - 1;
    last = label(std::lower_bound(begin, end, y) - begin) - 1;
    first = max(first, label(0));
    last = min(max(last, first), planes.size() - 2);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::facetCutter::growth(const int d, const label i) const
{
    const scalar a = planes_[d][i], b = planes_[d][i + 1];
    return d == grid_.radial() ? (b - a) / (b + a) : 0;
}

void Foam::mpm::facetCutter::addFull(const scalar (&value)[5], const label j, cutMoments& m) const
{
    const scalar radial = grid_.radial() == 1 ? growth(1, j) : 0;
    m.value[0] += 2 * (value[0] + radial * value[1]);
    m.value[1] += 2 * value[0];
    m.value[3] += 2 * value[1];
    m.value[4] += 2 * value[2];
    m.value[5] += 2.0 / 3 * value[0];
    m.value[6] += 2 * value[3];
    m.value[7] += 2 * value[4];
}

void Foam::mpm::facetCutter::cutColumn(polygon p, const label j, const label k, const label facet)
{
    scalar low = GREAT, high = -GREAT;
    for (const corner& c : p)
    {
        low = min(low, c[0]);
        high = max(high, c[0]);
    }
    const scalarList& X = planes_[0];
    if (high < X[0])
    {
        return;
    }

    const auto addStep = [&](const polygon& above, const label below)
    {
        step s;
        s.below = below;
        std::fill(s.value, s.value + 5, scalar(0));
        sumOver(
            above,
            [&](const corner& x, const scalar w)
            {
                s.value[0] += w;
                s.value[1] += w * x[1];
                s.value[2] += w * x[2];
                s.value[3] += w * x[1] * x[1];
                s.value[4] += w * x[2] * x[2];
            });
        columns_[columnOf(j, k)].push_back(s);
    };
    if (low >= X.last())
    {
        addStep(p, size(0));
        return;
    }

    label first, last;
    span(X, low, high, first, last);
    const scalar radial = grid_.radial() == 1 ? growth(1, j) : 0;
    for (label i = first; i <= last; ++i)
    {
        const scalar centre = 0.5 * (X[i] + X[i + 1]);
        const scalar half = 0.5 * (X[i + 1] - X[i]);
        polygon part(clipped(clipped(p, 0, X[i], -1), 0, X[i + 1], 1));
        if (part.empty())
        {
            continue;
        }
        piece& here = pieces_[i + size(0) * columnOf(j, k)];
        here.facets.push_back(facet);
        const scalar along = growth(0, i);
        sumOver(
            part,
            [&](const corner& x, const scalar w)
            {
                const scalar xi = (x[0] - centre) / half;
                const scalar length = xi + 1, first = 0.5 * (xi * xi - 1);
                cutMoments& m = here.m;
                m.value[0] += w * (length * (1 + radial * x[1]) + along * first);
                m.value[1] += w * length;
                m.value[2] += w * first;
                m.value[3] += w * length * x[1];
                m.value[4] += w * length * x[2];
                m.value[5] += w * (xi * xi * xi + 1) / 3;
                m.value[6] += w * length * x[1] * x[1];
                m.value[7] += w * length * x[2] * x[2];
            });
        // Below this sub-cell it is full
        addStep(part, i);
    }
    if (high > X.last())
    {
        addStep(clipped(p, 0, X.last(), -1), size(0));
    }
}

void Foam::mpm::facetCutter::cut(const polygon& p, const label facet)
{
    scalar low[3] = {GREAT, GREAT, GREAT}, high[3] = {-GREAT, -GREAT, -GREAT};
    for (const corner& c : p)
    {
        for (int d = 0; d < 3; ++d)
        {
            low[d] = min(low[d], c[d]);
            high[d] = max(high[d], c[d]);
        }
    }
    for (int d = 1; d < 3; ++d)
    {
        if (high[d] < planes_[d][0] || low[d] > planes_[d].last())
        {
            return;
        }
    }

    const auto strip = [&](const polygon& from, const int d, const label i)
    {
        const scalar a = planes_[d][i], b = planes_[d][i + 1];
        polygon q(clipped(clipped(from, d, a, -1), d, b, 1));
        for (corner& c : q)
        {
            c[d] = (2 * c[d] - a - b) / (b - a);
        }
        return q;
    };
    label j0, j1;
    span(planes_[1], low[1], high[1], j0, j1);
    for (label j = j0; j <= j1; ++j)
    {
        const polygon row(strip(p, 1, j));
        if (row.empty())
        {
            continue;
        }
        label k0, k1;
        span(planes_[2], low[2], high[2], k0, k1);
        for (label k = k0; k <= k1; ++k)
        {
            const polygon q(strip(row, 2, k));
            if (!q.empty())
            {
                cutColumn(q, j, k, facet);
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::facetCutter::facetCutter(
    const pointGrid& grid, const label* nSub, const triSurface& surface) :
    grid_(grid), surface_(surface), n_{1, 1, 1}, volume_(0)
{
    for (int d = 0; d < 3; ++d)
    {
        if (d >= grid_.nDim())
        {
            planes_[d] = scalarList({-1, 1});
            continue;
        }
        n_[d] = nSub[d];
        const label nCells = grid_.lattice().nLatticeCells(d);
        planes_[d].setSize(nCells * n_[d] + 1);
        for (label i = 0; i < nCells; ++i)
        {
            const scalar a = grid_.lattice().planes(d)[i + 1], b = grid_.lattice().planes(d)[i + 2];
            for (label s = 0; s <= n_[d]; ++s)
            {
                planes_[d][i * n_[d] + s] = s == n_[d] ? b : a + (scalar(s) / n_[d]) * (b - a);
            }
        }
    }

    forAll(surface_, facet)
    {
        const point x[3] = {
            surface_.points()[surface_[facet][0]], surface_.points()[surface_[facet][1]],
            surface_.points()[surface_[facet][2]]};
        addFacet(facet, x, (x[1] - x[0]) ^ (x[2] - x[0]));
    }

    // Of a column from its end on
    for (auto& column : columns_)
    {
        std::vector<step>& steps = column.second;
        std::sort(
            steps.begin(), steps.end(),
            [](const step& a, const step& b) { return a.below > b.below; });
        for (std::size_t i = 1; i < steps.size(); ++i)
        {
            for (int c = 0; c < 5; ++c)
            {
                steps[i].value[c] += steps[i - 1].value[c];
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::facetCutter::integrate(
    const label celli, const label* sub, cutMoments& m, DynamicList<label>& facets) const
{
    label ijk[3] = {0, 0, 0};
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        ijk[d] = (grid_.lattice().ijk(celli, d) - 1) * n_[d] + sub[d];
    }

    m = cutMoments();
    facets.clear();
    const auto column = columns_.find(columnOf(ijk[1], ijk[2]));
    if (column == columns_.end())
    {
        return;
    }
    const auto found = pieces_.find(ijk[0] + size(0) * columnOf(ijk[1], ijk[2]));
    if (found != pieces_.end())
    {
        m = found->second.m;
        for (const label facet : found->second.facets)
        {
            facets.append(facet);
        }
    }

    // Steps whose place is beyond: the last of them has the sum
    const std::vector<step>& steps = column->second;
    const auto end = std::partition_point(
        steps.begin(), steps.end(), [&](const step& s) { return s.below > ijk[0]; });
    if (end != steps.begin())
    {
        addFull((end - 1)->value, ijk[1], m);
    }

    // Directions that are not computed are drawn out from -1 to 1
    const scalar drawn = 1.0 / (1 << (3 - grid_.nDim()));
    for (scalar& v : m.value)
    {
        v *= drawn;
    }
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Where the edges cross a plane, of which the upper side owns its places
List<point> section(const List<point>& q, const int e, const scalar at)
{
    DynamicList<point> crossing;
    forAll(q, i)
    {
        const point& a = q[i];
        const point& b = q[(i + 1) % q.size()];
        if ((a[e] >= at) != (b[e] >= at))
        {
            // From below, whatever the order: facets fit together
            const point& u = a[e] < at ? a : b;
            const point& v = a[e] < at ? b : a;
            crossing.append(u + (v - u) * ((at - u[e]) / (v[e] - u[e])));
        }
    }
    return List<point>(crossing);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::facetCutter::corner Foam::mpm::facetCutter::computed(const point& q) const
{
    corner c = {0, 0, 0};
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        c[d] = q[grid_.direction(d)];
    }
    return c;
}

void Foam::mpm::facetCutter::addFacet(const label facet, const point (&x)[3], const vector& n)
{
    const int D = grid_.nDim();
    const point middle(grid_.mesh().bounds().midpoint());

    if (D == 3)
    {
        polygon p;
        for (const point& q : x)
        {
            p.push_back(computed(q));
        }
        // From the middle of the mesh: little cancels
        const vector a(x[0] - middle), b(x[1] - middle), c(x[2] - middle);
        volume_ += ((a ^ b) & c) / 6;
        cut(p, facet);
        return;
    }

    int across[2], nAcross = 0;
    for (int c = 0; c < 3; ++c)
    {
        bool isComputed = false;
        for (int d = 0; d < D; ++d)
        {
            isComputed = isComputed || grid_.direction(d) == c;
        }
        if (!isComputed)
        {
            across[nAcross++] = c;
        }
    }
    const List<point> q(section({x[0], x[1], x[2]}, across[0], middle[across[0]]));
    if (q.size() == 2 && D == 2)
    {
        addEdge(facet, computed(q[0]), computed(q[1]), n, middle);
    }
    else if (q.size() == 2)
    {
        addPlace(facet, q[0], q[1], across[1], n, middle);
    }
}

void Foam::mpm::facetCutter::addEdge(
    const label facet, corner a, corner b, const vector& n, const point& middle)
{
    const scalar turn =
        (b[1] - a[1]) * n[grid_.direction(0)] - (b[0] - a[0]) * n[grid_.direction(1)];
    if (turn < 0)
    {
        std::swap(a, b);
    }
    const int r = grid_.radial();
    if (r < 0)
    {
        const scalar ox = middle[grid_.direction(0)];
        const scalar oy = middle[grid_.direction(1)];
        volume_ += 0.5 * ((a[0] - ox) * (b[1] - oy) - (b[0] - ox) * (a[1] - oy));
    }
    else
    {
        // int r da = -/+ int r^2/2 along the edge
        const scalar sign = r == 0 ? 0.5 : -0.5;
        volume_ += grid_.sector() * sign * (b[1 - r] - a[1 - r])
            * (a[r] * a[r] + a[r] * b[r] + b[r] * b[r]) / 3;
    }
    polygon p = {a, b, b, a};
    p[0][2] = p[1][2] = -1;
    p[2][2] = p[3][2] = 1;
    cut(p, facet);
}

void Foam::mpm::facetCutter::addPlace(
    const label facet, const point& q0, const point& q1, const int e, const vector& n,
    const point& middle)
{
    // Two places of a line: in 1D one
    if ((q0[e] >= middle[e]) == (q1[e] >= middle[e]))
    {
        return;
    }
    const point& u = q0[e] < middle[e] ? q0 : q1;
    const point& v = q0[e] < middle[e] ? q1 : q0;
    const corner a = computed(u + (v - u) * ((middle[e] - u[e]) / (v[e] - u[e])));
    const scalar sign = n[grid_.direction(0)] > 0 ? 1 : -1;
    volume_ += sign * (a[0] - middle[grid_.direction(0)]);
    polygon p = {a, a, a, a};
    const scalar y[4] = {-1, 1, 1, -1}, z[4] = {-1, -1, 1, 1};
    for (int i = 0; i < 4; ++i)
    {
        p[i][1] = sign * y[i];
        p[i][2] = z[i];
    }
    cut(p, facet);
}
