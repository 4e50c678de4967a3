/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "polytope.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

//- A place of a plane
struct place
{
    scalar x, y;

    scalar dot(const place& b) const { return x*b.x + y*b.y; }
    scalar cross(const place& b) const { return x*b.y - y*b.x; }
};


//- Parts of an edge p-q of a face as seen from the centre of a circle of the
//  square r2 of its radius: inside(a, b) and outside(a, b)
template<class Inside, class Outside>
void alongEdge
(
    const place& p,
    const place& q,
    const scalar r2,
    const Inside& inside,
    const Outside& outside
)
{
    const place d{q.x - p.x, q.y - p.y};
    const scalar length2 = d.dot(d);
    if (length2 == 0)
    {
        return;
    }
    // Distance of the line from the centre, without cancellation
    const scalar s = p.cross(d), D = r2*length2 - s*s;
    if (r2 <= 0 || D <= 0)
    {
        outside(p, q);
        return;
    }
    const scalar middle = -p.dot(d)/length2, half = std::sqrt(D)/length2;
    const scalar t1 = middle - half, t2 = middle + half;
    if (t1 >= 1 || t2 <= 0)
    {
        outside(p, q);
        return;
    }
    const auto at = [&](const scalar t)
    {
        return place{p.x + t*d.x, p.y + t*d.y};
    };
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
    const Foam::vector across
    (
        Foam::mag(n.x()) < 0.6
      ? Foam::vector(1, 0, 0)
      : Foam::vector(0, 1, 0)
    );
    e = n ^ across;
    e /= Foam::mag(e);
    f = n ^ e;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::polytope::faceInBall
(
    const point* x,
    const label n,
    const vector& normal,
    const point& centre,
    const scalar R
)
{
    const scalar h = normal & (x[0] - centre);
    if (h == 0)
    {
        return 0;
    }
    const scalar d = mag(h), r2 = (R - d)*(R + d);
    vector e, f;
    axes(normal, e, f);

    scalar area = 0, angle = 0;
    const auto inside = [&](const place& a, const place& b)
    {
        area += 0.5*a.cross(b);
    };
    const auto outside = [&](const place& a, const place& b)
    {
        const scalar A = std::sqrt(a.dot(a) + h*h);
        const scalar B = std::sqrt(b.dot(b) + h*h);
        const scalar dot = a.dot(b), cross = a.cross(b);
        angle += 2*std::atan2(cross, A*B + d*(A + B) + dot + h*h);
        if (r2 > 0)
        {
            const scalar phi = std::atan2(cross, dot);
            area += 0.5*r2*phi;
            angle -= phi*(1 - d/R);
        }
    };
    place p{(x[n - 1] - centre) & e, (x[n - 1] - centre) & f};
    for (label i = 0; i < n; ++i)
    {
        const place q{(x[i] - centre) & e, (x[i] - centre) & f};
        alongEdge(p, q, r2, inside, outside);
        p = q;
    }
    return (h*area + (h > 0 ? 1 : -1)*pow3(R)*angle)/3;
}


Foam::scalar Foam::mpm::polytope::faceInTube
(
    const point* x,
    const label n,
    const vector& normal,
    const point& centre,
    const vector& axis,
    const scalar R
)
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
        const scalar A = 0.5*a.cross(b);
        I += A;
        X += A*(a.x + b.x)/3;
        Y += A*(a.y + b.y)/3;
    };
    const auto outside = [&](const place& a, const place& b)
    {
        const scalar A = std::sqrt(a.dot(a)), B = std::sqrt(b.dot(b));
        if (A > 0 && B > 0)
        {
            I += 0.5*sqr(R)*std::atan2(a.cross(b), a.dot(b));
            X += pow3(R)/3*(b.y/B - a.y/A);
            Y -= pow3(R)/3*(b.x/B - a.x/A);
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
    const scalar gx = -(normal & e)/along, gy = -(normal & f)/along;
    const scalar z0 =
        ((x[0] - centre) & axis)
      - gx*((x[0] - centre) & e) - gy*((x[0] - centre) & f);
    return z0*I + gx*X + gy*Y;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::polytope::inBall
(
    const point& centre,
    const scalar R
) const
{
    scalar V = 0;
    for (label f = 0; f + 1 < label(start_.size()); ++f)
    {
        const vector S(area(f));
        if (mag(S) > 0)
        {
            V += faceInBall
            (
                &x_[start_[f]], start_[f + 1] - start_[f], S/mag(S), centre, R
            );
        }
    }
    return V;
}


Foam::scalar Foam::mpm::polytope::inTube
(
    const point& centre,
    const vector& axis,
    const scalar R
) const
{
    // Heights from the body: those from afar would cancel
    const point near(centre + ((middle() - centre) & axis)*axis);
    scalar V = 0;
    for (label f = 0; f + 1 < label(start_.size()); ++f)
    {
        const vector S(area(f));
        if (mag(S) > 0)
        {
            V += faceInTube
            (
                &x_[start_[f]],
                start_[f + 1] - start_[f],
                S/mag(S),
                near,
                axis,
                R
            );
        }
    }
    return V;
}

// ************************************************************************* //
