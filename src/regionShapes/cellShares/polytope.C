/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "polytope.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

namespace
{

//- Corners as near to a plane, over the size, lie in it
constexpr Foam::scalar flat = 1e-14;

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::polytope::addCut(std::vector<point>& corners, const vector& n)
{
    // Around their mean, in the sense of n
    point middle(Zero);
    for (const point& x : corners)
    {
        middle += x/corners.size();
    }
    const vector across
    (
        mag(n.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0)
    );
    vector e(n ^ across);
    e /= mag(e);
    const vector f(n ^ e);
    std::vector<std::pair<scalar, point>> order;
    order.reserve(corners.size());
    for (const point& x : corners)
    {
        const vector r(x - middle);
        order.emplace_back(std::atan2(r & f, r & e), x);
    }
    std::sort
    (
        order.begin(),
        order.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; }
    );
    corners.clear();
    for (const auto& o : order)
    {
        if (corners.empty() || corners.back() != o.second)
        {
            corners.push_back(o.second);
        }
    }
    addFace(corners);
}


Foam::vector Foam::mpm::polytope::area(const label f) const
{
    const point& x0 = x_[start_[f]];
    vector S(Zero);
    for (label i = start_[f] + 1; i + 1 < start_[f + 1]; ++i)
    {
        S += 0.5*((x_[i] - x0) ^ (x_[i + 1] - x0));
    }
    return S;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::polytope::polytope(const point& min, const point& max)
:
    polytope()
{
    // Corner i: bit d set where coordinate d is the larger
    const auto at = [&](const int i)
    {
        return point
        (
            i & 1 ? max.x() : min.x(),
            i & 2 ? max.y() : min.y(),
            i & 4 ? max.z() : min.z()
        );
    };
    const int sides[6][4] =
    {
        {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
    };
    for (const auto& s : sides)
    {
        addFace({at(s[0]), at(s[1]), at(s[2]), at(s[3])});
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::polytope::addFace(const std::vector<point>& corners)
{
    if (corners.size() > 2)
    {
        x_.insert(x_.end(), corners.begin(), corners.end());
        start_.push_back(x_.size());
    }
}


void Foam::mpm::polytope::bounds(point& min, point& max) const
{
    min = max = x_[0];
    for (const point& x : x_)
    {
        min = Foam::min(min, x);
        max = Foam::max(max, x);
    }
}


Foam::point Foam::mpm::polytope::middle() const
{
    point sum(Zero);
    for (const point& x : x_)
    {
        sum += x;
    }
    return sum/scalar(x_.size());
}


Foam::scalar Foam::mpm::polytope::volume() const
{
    if (empty())
    {
        return 0;
    }
    const point middle(this->middle());
    scalar V = 0;
    for (label f = 0; f + 1 < label(start_.size()); ++f)
    {
        const point& x0 = x_[start_[f]];
        for (label i = start_[f] + 1; i + 1 < start_[f + 1]; ++i)
        {
            V += (x0 - middle) & ((x_[i] - x0) ^ (x_[i + 1] - x0));
        }
    }
    return V/6;
}


void Foam::mpm::polytope::split
(
    const halfSpace& h,
    polytope& in,
    polytope& out
) const
{
    in = out = polytope();
    if (empty())
    {
        return;
    }
    std::vector<scalar> d(x_.size());
    point low, high;
    bounds(low, high);
    const scalar least = flat*mag(high - low);
    bool below = false, above = false;
    for (std::size_t i = 0; i < x_.size(); ++i)
    {
        d[i] = h.distance(x_[i]);
        d[i] = mag(d[i]) < least ? 0 : d[i];
        below = below || d[i] < 0;
        above = above || d[i] > 0;
    }
    if (!below || !above)
    {
        (above ? out : in) = *this;
        return;
    }
    std::vector<point> inFace, outFace, cut;
    for (label f = 0; f + 1 < label(start_.size()); ++f)
    {
        inFace.clear();
        outFace.clear();
        for (label i = start_[f]; i < start_[f + 1]; ++i)
        {
            const label j = i + 1 < start_[f + 1] ? i + 1 : start_[f];
            if (d[i] <= 0)
            {
                inFace.push_back(x_[i]);
            }
            if (d[i] >= 0)
            {
                outFace.push_back(x_[i]);
            }
            if (d[i] == 0)
            {
                cut.push_back(x_[i]);
            }
            if (d[i]*d[j] < 0)
            {
                // The same point from both faces of the edge
                const label a = d[i] < 0 ? i : j, b = d[i] < 0 ? j : i;
                const point x
                (
                    x_[a] + (d[a]/(d[a] - d[b]))*(x_[b] - x_[a])
                );
                inFace.push_back(x);
                outFace.push_back(x);
                cut.push_back(x);
            }
        }
        in.addFace(inFace);
        out.addFace(outFace);
    }
    std::vector<point> same(cut);
    in.addCut(cut, h.n);
    out.addCut(same, -h.n);
}

// ************************************************************************* //
