// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "facetColumns.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::halfSpace
Foam::mpm::facetColumns::sideOf(const int d, const scalar x, const bool below) const
{
    vector n(Zero);
    n[dir_[d]] = below ? 1 : -1;
    return {n, below ? x : -x};
}

void Foam::mpm::facetColumns::setBounds(column& c, const point* x, const int n) const
{
    const int nDim = grid_.nDim();
    for (int d = 0; d < 3; ++d)
    {
        c.min[d] = d < nDim ? VGREAT : -VGREAT;
        c.max[d] = -c.min[d];
        for (int i = 0; i < n && d < nDim; ++i)
        {
            c.min[d] = Foam::min(c.min[d], x[i][dir_[d]]);
            c.max[d] = Foam::max(c.max[d], x[i][dir_[d]]);
        }
    }
}

void Foam::mpm::facetColumns::addFacet(const point (&x)[3])
{
    vector n((x[1] - x[0]) ^ (x[2] - x[0]));
    if (!(mag(n) > 0) || n[dir_[0]] == 0)
    {
        return;
    }
    n /= mag(n);
    column c;
    c.sign = n[dir_[0]] > 0 ? 1 : -1;
    c.n = 4;
    c.sides[0] = {c.sign * n, c.sign * (n & x[0])};
    for (int i = 0; i < 3; ++i)
    {
        // Of both facets of an edge from the same end
        point a(x[i]), b(x[(i + 1) % 3]);
        const bool turned = std::lexicographical_compare(&b[0], &b[0] + 3, &a[0], &a[0] + 3);
        if (turned)
        {
            std::swap(a, b);
        }
        vector axis(Zero);
        axis[dir_[0]] = 1;
        vector side((b - a) ^ axis);
        if (!(mag(side) > 0))
        {
            return;
        }
        side /= mag(side);
        const scalar way = turned == (c.sign > 0) ? -1 : 1;
        c.sides[i + 1] = {way * side, way * (side & a)};
    }
    setBounds(c, x, 3);
    columns_.push_back(c);
}

void Foam::mpm::facetColumns::addEdge(point a, point b, const vector& n, const point& middle)
{
    if (grid_.nDim() == 1)
    {
        const bool above[2] = {a[dir_[1]] >= middle[dir_[1]], b[dir_[1]] >= middle[dir_[1]]};
        if (above[0] != above[1])
        {
            const scalar t = (middle[dir_[1]] - a[dir_[1]]) / (b[dir_[1]] - a[dir_[1]]);
            addPlace(a + t * (b - a), n[dir_[0]]);
        }
        return;
    }
    if (a[dir_[1]] == b[dir_[1]])
    {
        return;
    }
    if (a[dir_[1]] > b[dir_[1]])
    {
        std::swap(a, b);
    }
    vector third(Zero);
    third[dir_[2]] = 1;
    vector across((b - a) ^ third);
    across /= mag(across);
    across *= across[dir_[0]] > 0 ? 1 : -1;
    column c;
    c.sign = (across & n) > 0 ? 1 : -1;
    c.n = 3;
    c.sides[0] = {across, across & a};
    c.sides[1] = sideOf(1, a[dir_[1]], false);
    c.sides[2] = sideOf(1, b[dir_[1]], true);
    const point ends[2] = {a, b};
    setBounds(c, ends, 2);
    columns_.push_back(c);
}

void Foam::mpm::facetColumns::addPlace(const point& x, const scalar n)
{
    column c;
    c.sign = n > 0 ? 1 : -1;
    c.n = 1;
    c.sides[0] = sideOf(0, x[dir_[0]], true);
    setBounds(c, &x, 1);
    columns_.push_back(c);
}

void Foam::mpm::facetColumns::binsOf(
    const scalar* min, const scalar* max, int (&first)[2], int (&last)[2]) const
{
    for (int d = 0; d < 2; ++d)
    {
        const auto at = [&](const scalar x)
        {
            const scalar i = (x - low_[d]) / width_[d];
            return int(Foam::min(Foam::max(i, scalar(0)), scalar(nBins_[d] - 1)));
        };
        first[d] = at(min[d + 1]);
        last[d] = at(max[d + 1]);
    }
}

void Foam::mpm::facetColumns::sort()
{
    const int nDim = grid_.nDim();
    const int most = int(std::sqrt(scalar(columns_.size()))) + 1;
    for (int d = 0; d < 2; ++d)
    {
        low_[d] = 0;
        width_[d] = 1;
        nBins_[d] = 1;
        if (d + 1 < nDim && columns_.size())
        {
            scalar high = -VGREAT;
            low_[d] = VGREAT;
            for (const column& c : columns_)
            {
                low_[d] = min(low_[d], c.min[d + 1]);
                high = max(high, c.max[d + 1]);
            }
            nBins_[d] = most;
            width_[d] = max(high - low_[d], VSMALL) / most;
        }
    }
    bins_.resize(nBins_[0] * nBins_[1]);
    for (std::size_t i = 0; i < columns_.size(); ++i)
    {
        int first[2], last[2];
        binsOf(columns_[i].min, columns_[i].max, first, last);
        for (int j = first[0]; j <= last[0]; ++j)
        {
            for (int k = first[1]; k <= last[1]; ++k)
            {
                bins_[j + nBins_[0] * k].push_back(i);
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::facetColumns::facetColumns(const pointGrid& grid, const triSurface& surface) :
    grid_(grid)
{
    const int nDim = grid.nDim();
    bool used[3] = {false, false, false};
    for (int d = 0; d < nDim; ++d)
    {
        dir_[d] = grid.direction(d);
        used[dir_[d]] = true;
    }
    for (int d = nDim, c = 0; d < 3; ++d)
    {
        while (used[c])
        {
            ++c;
        }
        dir_[d] = c;
        used[c] = true;
    }
    const point middle(grid.mesh().bounds().midpoint());
    for (const labelledTri& t : surface)
    {
        const point x[3] = {surface.points()[t[0]], surface.points()[t[1]], surface.points()[t[2]]};
        if (nDim == 3)
        {
            addFacet(x);
            continue;
        }
        // Its edge in the mid-plane
        const vector n((x[1] - x[0]) ^ (x[2] - x[0]));
        const int e = dir_[2];
        point ends[2];
        int nEnds = 0;
        for (int i = 0; i < 3; ++i)
        {
            point a(x[i]), b(x[(i + 1) % 3]);
            if ((a[e] >= middle[e]) != (b[e] >= middle[e]) && nEnds < 2)
            {
                if (a[e] > b[e])
                {
                    std::swap(a, b);
                }
                ends[nEnds++] = a + ((middle[e] - a[e]) / (b[e] - a[e])) * (b - a);
            }
        }
        if (nEnds == 2)
        {
            addEdge(ends[0], ends[1], n, middle);
        }
    }
    sort();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::facetColumns::cuts(const polytope& p) const
{
    point low, high;
    p.bounds(low, high);
    scalar min[3], max[3];
    for (int d = 0; d < 3; ++d)
    {
        min[d] = low[dir_[d]];
        max[d] = high[dir_[d]];
    }
    int first[2], last[2];
    binsOf(min, max, first, last);
    for (int j = first[0]; j <= last[0]; ++j)
    {
        for (int k = first[1]; k <= last[1]; ++k)
        {
            for (const label i : bins_[j + nBins_[0] * k])
            {
                bool apart = false;
                for (int d = 0; d < 3; ++d)
                {
                    apart = apart || columns_[i].min[d] > max[d] || columns_[i].max[d] < min[d];
                }
                if (!apart)
                {
                    return true;
                }
            }
        }
    }
    return false;
}

Foam::mpm::volumeMoment Foam::mpm::facetColumns::inside(const polytope& p) const
{
    point low, high;
    p.bounds(low, high);
    scalar min[3], max[3];
    for (int d = 0; d < 3; ++d)
    {
        min[d] = low[dir_[d]];
        max[d] = high[dir_[d]];
    }
    int first[2], last[2];
    binsOf(min, max, first, last);
    std::vector<label> found;
    for (int j = first[0]; j <= last[0]; ++j)
    {
        for (int k = first[1]; k <= last[1]; ++k)
        {
            const auto& bin = bins_[j + nBins_[0] * k];
            found.insert(found.end(), bin.begin(), bin.end());
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());

    volumeMoment sum;
    for (const label i : found)
    {
        const column& c = columns_[i];
        if (c.max[0] <= min[0] || c.min[1] >= max[1] || c.max[1] <= min[1] || c.min[2] >= max[2]
            || c.max[2] <= min[2])
        {
            continue;
        }
        polytope part(p), in, out;
        for (int s = 0; s < c.n && !part.empty(); ++s)
        {
            part.split(c.sides[s], in, out);
            std::swap(part, in);
        }
        sum.add(c.sign, part.moment());
    }
    return sum;
}
