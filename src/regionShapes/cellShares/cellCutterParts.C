// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "cellCutter.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

namespace
{

//- Halvings in each direction: of several curved surfaces, of other shapes
constexpr int mostCurved = 6, mostOther = 4;

//- Planes tried for one with a given volume below it, as near as this
constexpr int nPlanes = 16;
constexpr Foam::scalar nearEnough = 1e-4;

//- From these on a part that has all of its corners on one side lies there
constexpr int fewest = 2;

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::mpm::cellCutter::evaluate(const label celli, const states& s) const
{
    List<int> inside(label(leaves_.size()));
    forAll(inside, i)
    {
        const leaf& l = leaves_[i];
        inside[i] = l.known;
        if (l.known == 2)
        {
            int all = 1;
            for (label j = l.first; j < l.last; ++j)
            {
                all = s[j] == 0 ? 0 : all == 0 ? 0 : s[j] == 2 ? 2 : all;
            }
            inside[i] = all == 2 || !l.inverse ? all : 1 - all;
        }
    }
    return formula_.evaluate(celli, inside);
}

bool Foam::mpm::cellCutter::contains(const label celli, const atom& a, point x) const
{
    switch (a.kind)
    {
    case atom::plane:
        return a.h.distance(x) <= 0;
    case atom::ball:
        return magSqr(x - a.centre) <= sqr(a.R);
    case atom::tube:
        return magSqr((x - a.centre) ^ a.axis) <= sqr(a.R);
    case atom::formula:
    {
        scalar y[3] = {0, 0, 0};
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            y[d] = x[grid_.direction(d)];
        }
        return formula_.surfaceAt(a.surface).value(y) <= 0;
    }
    default:
    {
        // In the mid-plane
        const point middle(grid_.mesh().bounds().midpoint());
        const vector in(a.body->computed(x - middle));
        return a.body->contains(celli, middle + in);
    }
    }
}

int Foam::mpm::cellCutter::stateOf(
    const label celli, const atom& a, const polytope& p, const bool last) const
{
    if (a.kind == atom::facets)
    {
        return a.columns->cuts(p) ? 2 : int(contains(celli, a, p.middle()));
    }
    bool all = true, none = true;
    if (a.kind == atom::plane)
    {
        point low, high;
        p.bounds(low, high);
        const scalar tol = 1e-14 * mag(high - low);
        for (const point& x : p.corners())
        {
            const scalar d = a.h.distance(x);
            all = all && d <= tol;
            none = none && d >= -tol;
        }
        return all ? 1 : none ? 0 : 2;
    }
    for (const point& x : p.corners())
    {
        const bool in = contains(celli, a, x);
        all = all && in;
        none = none && !in;
    }
    if (!tells(a))
    {
        const bool in = contains(celli, a, p.middle());
        return last && ((all && in) || (none && !in)) ? int(in) : 2;
    }
    if (all || !none)
    {
        return all ? 1 : 2;
    }
    // Far from it?
    point low, high;
    p.bounds(low, high);
    const vector r(0.5 * (low + high) - a.centre);
    const scalar away = a.kind == atom::ball
        ? mag(max(low - a.centre, max(a.centre - high, point::zero)))
        : mag(r ^ a.axis) - 0.5 * mag(high - low);
    return away >= a.R ? 0 : 2;
}

Foam::mpm::volumeMoment
Foam::mpm::cellCutter::inside(const atom& a, const polytope& p, const volumeMoment& m) const
{
    if (a.kind == atom::facets)
    {
        return a.columns->inside(p);
    }
    volumeMoment sum;
    sum.V = a.kind == atom::ball ? p.inBall(a.centre, a.R) : p.inTube(a.centre, a.axis, a.R);
    if (!moments_ || !(sum.V > 0) || !(m.V > 0))
    {
        return sum;
    }
    // Below the plane with as much of the body below it
    vector n(m.X / m.V - a.centre);
    n -= a.kind == atom::tube ? (n & a.axis) * a.axis : vector(Zero);
    n /= max(mag(n), VSMALL);
    scalar low = VGREAT, high = -VGREAT;
    for (const point& x : p.corners())
    {
        low = min(low, n & x);
        high = max(high, n & x);
    }
    // Regula falsi, halved on the side that stays (Illinois)
    polytope in, out;
    volumeMoment below(m);
    scalar vLow = -sum.V, vHigh = m.V - sum.V;
    for (int i = 0, side = 0; i < nPlanes && high > low; ++i)
    {
        const scalar at = (low * vHigh - high * vLow) / (vHigh - vLow);
        p.split({n, at}, in, out);
        below = in.moment();
        const scalar over = below.V - sum.V;
        if (mag(over) < nearEnough * m.V)
        {
            break;
        }
        const int now = over > 0 ? 1 : -1;
        (over > 0 ? high : low) = at;
        (over > 0 ? vHigh : vLow) = over;
        (over > 0 ? vLow : vHigh) *= side == now ? 0.5 : 1;
        side = now;
    }
    sum.X = sum.V * (below.V > 0 ? below.X / below.V : m.X / m.V);
    return sum;
}

bool Foam::mpm::cellCutter::tooRound(const atom& a, const polytope& p) const
{
    if (!moments_ || a.kind == atom::facets)
    {
        return false;
    }
    point low, high;
    p.bounds(low, high);
    scalar size = 0;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        size = max(size, (high - low)[grid_.direction(d)]);
    }
    return size > 0.5 * a.R;
}

bool Foam::mpm::cellCutter::concentric(const atom& a, const atom& b)
{
    if (a.kind != b.kind || a.kind == atom::facets || !tells(a))
    {
        return false;
    }
    const scalar tol = 1e-12 * (a.R + b.R);
    const vector r(b.centre - a.centre);
    return a.kind == atom::ball ? mag(r) < tol
                                : mag(r ^ a.axis) < tol && mag(a.axis ^ b.axis) < 1e-12;
}

Foam::mpm::volumeMoment Foam::mpm::cellCutter::cutShells(
    const label celli, const polytope& p, states s, std::vector<label> some) const
{
    std::sort(
        some.begin(), some.end(),
        [&](const label a, const label b) { return atoms_[a].R < atoms_[b].R; });
    // From the innermost out
    for (const label i : some)
    {
        s[i] = 1;
    }
    const volumeMoment all(p.moment());
    volumeMoment before, sum;
    for (const label i : some)
    {
        volumeMoment in(inside(atoms_[i], p, all));
        in = in.V < before.V ? before : in.V > all.V ? all : in;
        if (evaluate(celli, s) == 1)
        {
            sum.add(1, in);
            sum.add(-1, before);
        }
        s[i] = 0;
        before = in;
    }
    if (evaluate(celli, s) == 1)
    {
        sum.add(1, all);
        sum.add(-1, before);
    }
    return sum;
}

Foam::mpm::volumeMoment Foam::mpm::cellCutter::cutLast(
    const label celli, const polytope& p, states s, const std::vector<label>& some) const
{
    const point middle(p.middle());
    for (const label i : some)
    {
        const atom& a = atoms_[i];
        vector n(Zero);
        if (a.kind == atom::ball || a.kind == atom::tube)
        {
            n = middle - a.centre;
            n -= a.kind == atom::tube ? (n & a.axis) * a.axis : vector(Zero);
        }
        if (mag(n) > 0)
        {
            n /= mag(n);
            polytope in, out;
            p.split({n, (n & a.centre) + a.R}, in, out);
            std::vector<label> rest;
            std::copy_if(
                some.begin(), some.end(), std::back_inserter(rest),
                [&](const label j) { return j != i; });
            volumeMoment sum;
            for (const bool inner : {true, false})
            {
                const polytope& part = inner ? in : out;
                s[i] = inner;
                sum.add(1, part.empty() ? volumeMoment() : cutLast(celli, part, s, rest));
            }
            return sum;
        }
        s[i] = contains(celli, a, middle);
    }
    return evaluate(celli, s) == 1 ? p.moment() : volumeMoment();
}

Foam::mpm::volumeMoment
Foam::mpm::cellCutter::cut(const label celli, const polytope& p, states s, const int depth) const
{
    const int nDim = grid_.nDim();
    std::vector<label> some;
    label plane = -1;
    for (std::size_t i = 0; i < atoms_.size(); ++i)
    {
        if (s[i] == 2)
        {
            s[i] = stateOf(celli, atoms_[i], p, depth >= fewest * nDim);
        }
        if (s[i] == 2)
        {
            some.push_back(i);
            plane = atoms_[i].kind == atom::plane && plane < 0 ? i : plane;
        }
    }
    const int known = evaluate(celli, s);
    if (known < 2)
    {
        return known ? p.moment() : volumeMoment();
    }
    polytope in, out;
    if (plane >= 0)
    {
        p.split(atoms_[plane].h, in, out);
        volumeMoment sum;
        for (const bool inner : {true, false})
        {
            s[plane] = inner;
            const polytope& part = inner ? in : out;
            sum.add(1, part.empty() ? volumeMoment() : cut(celli, part, s, depth));
        }
        return sum;
    }

    bool together = tells(atoms_[some[0]]), other = false;
    for (const label i : some)
    {
        together = together && (i == some[0] || concentric(atoms_[i], atoms_[some[0]]));
        other = other || !tells(atoms_[i]);
    }
    if (together && (depth >= nDim * mostOther || !tooRound(atoms_[some[0]], p)))
    {
        return cutShells(celli, p, s, some);
    }
    if (depth >= nDim * (other ? mostOther : mostCurved))
    {
        return cutLast(celli, p, s, some);
    }
    point low, high;
    p.bounds(low, high);
    int longest = grid_.direction(0);
    for (int d = 1; d < nDim; ++d)
    {
        const int c = grid_.direction(d);
        longest = high[c] - low[c] > high[longest] - low[longest] ? c : longest;
    }
    vector n(Zero);
    n[longest] = 1;
    p.split({n, 0.5 * (low[longest] + high[longest])}, in, out);
    volumeMoment sum;
    sum.add(1, cut(celli, in, s, depth + 1));
    sum.add(1, cut(celli, out, s, depth + 1));
    return sum;
}
