// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "polytope.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

namespace
{

//- Corners as near to a plane, over the size, lie in it
constexpr Foam::scalar flat = 1e-14;

//- Sides of a box; corner i: bit d set where coordinate d is the larger
constexpr int sidesOfBox[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::polytope::addCut(std::vector<point>& corners, const vector& n)
{
    // Around their mean, in the sense of n
    point middle(Zero);
    for (const point& x : corners)
    {
        middle += x / corners.size();
    }
    const vector across(mag(n.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0));
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
    std::sort(
        order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
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
        S += 0.5 * ((x_[i] - x0) ^ (x_[i + 1] - x0));
    }
    return S;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::polytope::polytope(const point& min, const point& max) : polytope()
{
    for (const auto& s : sidesOfBox)
    {
        const auto at = [&](const int i) {
            return point(
                i & 1 ? max.x() : min.x(), i & 2 ? max.y() : min.y(), i & 4 ? max.z() : min.z());
        };
        addFace({at(s[0]), at(s[1]), at(s[2]), at(s[3])});
    }
}

std::vector<Foam::mpm::polytope> Foam::mpm::polytope::ofHexahedron(const point (&x)[8])
{
    // In the order of axes that do not turn right the sides look inwards
    const bool turned = (((x[1] - x[0]) ^ (x[2] - x[0])) & (x[4] - x[0])) < 0;
    const auto corner = [&](const int side, const int i)
    { return x[sidesOfBox[side][turned ? 3 - i : i]]; };

    point middle(Zero);
    scalar size = 0;
    for (const point& y : x)
    {
        middle += y / 8;
        size = max(size, mag(y - x[0]));
    }
    bool convex = true;
    polytope whole;
    std::vector<polytope> parts;
    for (int s = 0; s < 6; ++s)
    {
        const point a(corner(s, 0)), b(corner(s, 1)), c(corner(s, 2)), d(corner(s, 3));
        const vector S(0.5 * ((c - a) ^ (d - b)));
        const scalar tol = 1e-13 * size * mag(S);
        for (const point& y : {a, b, c, d})
        {
            convex = convex && mag((y - a) & S) <= tol;
        }
        for (const point& y : x)
        {
            convex = convex && ((y - a) & S) <= tol;
        }
        whole.addFace({a, b, c, d});
    }
    if (convex)
    {
        return {whole};
    }
    for (int s = 0; s < 6; ++s)
    {
        const point centre(0.25 * (corner(s, 0) + corner(s, 1) + corner(s, 2) + corner(s, 3)));
        for (int i = 0; i < 4; ++i)
        {
            const point a(corner(s, i)), b(corner(s, (i + 1) % 4));
            polytope tet;
            tet.addFace({a, b, centre});
            tet.addFace({b, a, middle});
            tet.addFace({centre, b, middle});
            tet.addFace({a, centre, middle});
            parts.push_back(tet);
        }
    }
    return parts;
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
    return sum / scalar(x_.size());
}

Foam::mpm::volumeMoment Foam::mpm::polytope::moment() const
{
    volumeMoment sum;
    if (empty())
    {
        return sum;
    }
    const point middle(this->middle());
    for (label f = 0; f + 1 < label(start_.size()); ++f)
    {
        const vector a(x_[start_[f]] - middle);
        for (label i = start_[f] + 1; i + 1 < start_[f + 1]; ++i)
        {
            const vector b(x_[i] - middle), c(x_[i + 1] - middle);
            const scalar V = a & (b ^ c);
            sum.V += V;
            sum.X += V * (a + b + c);
        }
    }
    sum.V /= 6;
    sum.X = sum.X / 24 + sum.V * middle;
    return sum;
}

void Foam::mpm::polytope::split(const halfSpace& h, polytope& in, polytope& out) const
{
    in = out = polytope();
    if (empty())
    {
        return;
    }
    std::vector<scalar> d(x_.size());
    point low, high;
    bounds(low, high);
    const scalar least = flat * mag(high - low);
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
            if (d[i] * d[j] < 0)
            {
                // The same point from both faces of the edge
                const label a = d[i] < 0 ? i : j, b = d[i] < 0 ? j : i;
                const point x(x_[a] + (d[a] / (d[a] - d[b])) * (x_[b] - x_[a]));
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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

//- A place of a plane
struct place
{
    scalar x, y;

    scalar dot(const place& b) const { return x * b.x + y * b.y; }
    scalar cross(const place& b) const { return x * b.y - y * b.x; }
};

//- Parts of an edge p-q of a face as seen from the centre of a circle of the
//  square r2 of its radius: inside(a, b) and outside(a, b)
template<class Inside, class Outside>
void alongEdge(
    const place& p, const place& q, const scalar r2, const Inside& inside, const Outside& outside)
{
    const place d{q.x - p.x, q.y - p.y};
    const scalar length2 = d.dot(d);
    if (length2 == 0)
    {
        return;
    }
    // Distance of the line from the centre, without cancellation
    const scalar s = p.cross(d), D = r2 * length2 - s * s;
    if (r2 <= 0 || D <= 0)
    {
        outside(p, q);
        return;
    }
    const scalar middle = -p.dot(d) / length2, half = std::sqrt(D) / length2;
    const scalar t1 = middle - half, t2 = middle + half;
    if (t1 >= 1 || t2 <= 0)
    {
        outside(p, q);
        return;
    }
    const auto at = [&](const scalar t) { return place{p.x + t * d.x, p.y + t * d.y}; };
    const place a(t1 > 0 ? at(t1) : p), b(t2 < 1 ? at(t2) : q);
    if (t1 > 0)
    {
        outside(p, a);
    }
    inside(a, b);
    if (t2 < 1)
    {
        outside(b, q);
    }
}

//- Axes of a plane with this normal
void axes(const Foam::vector& n, Foam::vector& e, Foam::vector& f)
{
    const Foam::vector across(
        Foam::mag(n.x()) < 0.6 ? Foam::vector(1, 0, 0) : Foam::vector(0, 1, 0));
    e = n ^ across;
    e /= Foam::mag(e);
    f = n ^ e;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::polytope::faceInBall(
    const point* x, const label n, const vector& normal, const point& centre, const scalar R)
{
    const scalar h = normal & (x[0] - centre);
    if (h == 0)
    {
        return 0;
    }
    const scalar d = mag(h), r2 = (R - d) * (R + d);
    vector e, f;
    axes(normal, e, f);

    scalar area = 0, angle = 0;
    const auto inside = [&](const place& a, const place& b) { area += 0.5 * a.cross(b); };
    const auto outside = [&](const place& a, const place& b)
    {
        const scalar A = std::sqrt(a.dot(a) + h * h);
        const scalar B = std::sqrt(b.dot(b) + h * h);
        const scalar dot = a.dot(b), cross = a.cross(b);
        angle += 2 * std::atan2(cross, A * B + d * (A + B) + dot + h * h);
        if (r2 > 0)
        {
            const scalar phi = std::atan2(cross, dot);
            area += 0.5 * r2 * phi;
            angle -= phi * (1 - d / R);
        }
    };
    place p{(x[n - 1] - centre) & e, (x[n - 1] - centre) & f};
    for (label i = 0; i < n; ++i)
    {
        const place q{(x[i] - centre) & e, (x[i] - centre) & f};
        alongEdge(p, q, r2, inside, outside);
        p = q;
    }
    return (h * area + (h > 0 ? 1 : -1) * pow3(R) * angle) / 3;
}

Foam::scalar Foam::mpm::polytope::faceInTube(
    const point* x, const label n, const vector& normal, const point& centre, const vector& axis,
    const scalar R)
{
    // Steeper faces have a shadow of rounding
    constexpr scalar steep = 1e-10;

    const scalar along = normal & axis;
    if (mag(along) < steep)
    {
        return 0;
    }
    vector e, f;
    axes(axis, e, f);

    // int 1, x, y
    scalar I = 0, X = 0, Y = 0;
    const auto inside = [&](const place& a, const place& b)
    {
        const scalar A = 0.5 * a.cross(b);
        I += A;
        X += A * (a.x + b.x) / 3;
        Y += A * (a.y + b.y) / 3;
    };
    const auto outside = [&](const place& a, const place& b)
    {
        const scalar A = std::sqrt(a.dot(a)), B = std::sqrt(b.dot(b));
        if (A > 0 && B > 0)
        {
            I += 0.5 * sqr(R) * std::atan2(a.cross(b), a.dot(b));
            X += pow3(R) / 3 * (b.y / B - a.y / A);
            Y -= pow3(R) / 3 * (b.x / B - a.x / A);
        }
    };
    place p{(x[n - 1] - centre) & e, (x[n - 1] - centre) & f};
    for (label i = 0; i < n; ++i)
    {
        const place q{(x[i] - centre) & e, (x[i] - centre) & f};
        alongEdge(p, q, sqr(R), inside, outside);
        p = q;
    }
    // Height z = z0 + gx x + gy y of the plane
    const scalar gx = -(normal & e) / along, gy = -(normal & f) / along;
    const scalar z0 =
        ((x[0] - centre) & axis) - gx * ((x[0] - centre) & e) - gy * ((x[0] - centre) & f);
    return z0 * I + gx * X + gy * Y;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::polytope::inBall(const point& centre, const scalar R) const
{
    scalar V = 0;
    for (label f = 0; f + 1 < label(start_.size()); ++f)
    {
        const vector S(area(f));
        if (mag(S) > 0)
        {
            V += faceInBall(&x_[start_[f]], start_[f + 1] - start_[f], S / mag(S), centre, R);
        }
    }
    return V;
}

Foam::scalar
Foam::mpm::polytope::inTube(const point& centre, const vector& axis, const scalar R) const
{
    // Heights from the body: those from afar would cancel
    const point near(centre + ((middle() - centre) & axis) * axis);
    scalar V = 0;
    for (label f = 0; f + 1 < label(start_.size()); ++f)
    {
        const vector S(area(f));
        if (mag(S) > 0)
        {
            V += faceInTube(&x_[start_[f]], start_[f + 1] - start_[f], S / mag(S), near, axis, R);
        }
    }
    return V;
}
