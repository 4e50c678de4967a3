// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "quadratic.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

//- Zeros of a t^2 + b t + c. Their number
int zeros(const scalar a, const scalar b, const scalar c, scalar* t)
{
    const scalar D = b * b - 4 * a * c;
    if (D < 0 || (a == 0 && b == 0))
    {
        return 0;
    }
    // Without cancellation
    const scalar q = -0.5 * (b + (b < 0 ? -std::sqrt(D) : std::sqrt(D)));
    int n = 0;
    if (a != 0)
    {
        t[n++] = q / a;
    }
    if (q != 0)
    {
        t[n++] = c / q;
    }
    return n;
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::quadratic::quadratic() : A_{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, b_{0, 0, 0}, c_(0) {}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::quadratic::addSquare(const int d, const scalar centre, const scalar factor)
{
    A_[d][d] += factor;
    b_[d] -= 2 * factor * centre;
    c_ += factor * centre * centre;
}

void Foam::mpm::quadratic::addSquare(const scalar* from, const scalar* along, const scalar factor)
{
    scalar shift = 0;
    for (int d = 0; d < 3; ++d)
    {
        shift += from[d] * along[d];
    }
    for (int d = 0; d < 3; ++d)
    {
        for (int e = 0; e < 3; ++e)
        {
            A_[d][e] += factor * along[d] * along[e];
        }
        b_[d] -= 2 * factor * shift * along[d];
    }
    c_ += factor * shift * shift;
}

void Foam::mpm::quadratic::addLinear(const int d, const scalar from, const scalar factor)
{
    b_[d] += factor;
    c_ -= factor * from;
}

Foam::scalar Foam::mpm::quadratic::value(const scalar* x) const
{
    scalar f = c_;
    for (int d = 0; d < 3; ++d)
    {
        scalar Ax = 0;
        for (int e = 0; e < 3; ++e)
        {
            Ax += A_[d][e] * x[e];
        }
        f += x[d] * (Ax + b_[d]);
    }
    return f;
}

void Foam::mpm::quadratic::gradient(const scalar* x, scalar* g) const
{
    for (int d = 0; d < 3; ++d)
    {
        g[d] = b_[d];
        for (int e = 0; e < 3; ++e)
        {
            g[d] += 2 * A_[d][e] * x[e];
        }
    }
}

Foam::mpm::quadratic Foam::mpm::quadratic::local(const scalar* centre, const scalar* half) const
{
    quadratic q;
    gradient(centre, q.b_);
    q.c_ = value(centre);
    for (int d = 0; d < 3; ++d)
    {
        q.b_[d] *= half[d];
        for (int e = 0; e < 3; ++e)
        {
            q.A_[d][e] = A_[d][e] * half[d] * half[e];
        }
    }
    return q;
}

int Foam::mpm::quadratic::sign() const
{
    scalar range = 0;
    for (int d = 0; d < 3; ++d)
    {
        range += std::abs(b_[d]);
        for (int e = 0; e < 3; ++e)
        {
            range += std::abs(A_[d][e]);
        }
    }
    return std::abs(c_) < range * (1 - 1e-11) ? 0 : c_ < 0 ? -1 : c_ > 0 ? 1 : 0;
}

bool Foam::mpm::quadratic::linear() const
{
    for (int d = 0; d < 3; ++d)
    {
        for (int e = 0; e < 3; ++e)
        {
            if (A_[d][e] != 0)
            {
                return false;
            }
        }
    }
    return true;
}

bool Foam::mpm::quadratic::dependsOn(const int d) const
{
    return b_[d] != 0 || A_[d][0] != 0 || A_[d][1] != 0 || A_[d][2] != 0;
}

Foam::mpm::quadratic Foam::mpm::quadratic::fixed(const int d, const scalar value) const
{
    quadratic q(*this);
    q.c_ += value * (b_[d] + value * A_[d][d]);
    q.b_[d] = 0;
    for (int e = 0; e < 3; ++e)
    {
        if (e != d)
        {
            q.b_[e] += 2 * value * A_[d][e];
        }
        q.A_[d][e] = q.A_[e][d] = 0;
    }
    return q;
}

Foam::mpm::quadratic Foam::mpm::quadratic::discriminant(const int d) const
{
    // a t^2 + B(x) t + C(x): B^2 - 4 a C
    const scalar a = A_[d][d];
    scalar B[3] = {0, 0, 0};
    for (int e = 0; e < 3; ++e)
    {
        B[e] = e == d ? 0 : 2 * A_[d][e];
    }
    const quadratic C(fixed(d, 0));

    quadratic q;
    for (int e = 0; e < 3; ++e)
    {
        for (int f = 0; f < 3; ++f)
        {
            q.A_[e][f] = B[e] * B[f] - 4 * a * C.A_[e][f];
        }
        q.b_[e] = 2 * b_[d] * B[e] - 4 * a * C.b_[e];
    }
    q.c_ = b_[d] * b_[d] - 4 * a * C.c_;
    return q;
}

Foam::mpm::quadratic Foam::mpm::quadratic::resultant(const quadratic& plane, const int d) const
{
    // t = m.x + k on the plane
    scalar m[3] = {0, 0, 0};
    for (int e = 0; e < 3; ++e)
    {
        m[e] = e == d ? 0 : -plane.b_[e] / plane.b_[d];
    }
    const scalar k = -plane.c_ / plane.b_[d], a = A_[d][d];

    quadratic q(fixed(d, 0));
    for (int e = 0; e < 3; ++e)
    {
        const scalar Be = e == d ? 0 : 2 * A_[d][e];
        for (int f = 0; f < 3; ++f)
        {
            const scalar Bf = f == d ? 0 : 2 * A_[d][f];
            q.A_[e][f] += a * m[e] * m[f] + 0.5 * (Be * m[f] + Bf * m[e]);
        }
        q.b_[e] += 2 * a * k * m[e] + b_[d] * m[e] + k * Be;
    }
    q.c_ += k * (a * k + b_[d]);
    return q;
}

Foam::mpm::quadratic Foam::mpm::quadratic::minus(const quadratic& other) const
{
    quadratic q(*this);
    scalar size = 0;
    for (int d = 0; d < 3; ++d)
    {
        for (int e = 0; e < 3; ++e)
        {
            size = std::max(size, std::abs(A_[d][e]));
        }
    }
    for (int d = 0; d < 3; ++d)
    {
        for (int e = 0; e < 3; ++e)
        {
            q.A_[d][e] -= other.A_[d][e];
            if (std::abs(q.A_[d][e]) <= 1e-14 * size)
            {
                q.A_[d][e] = 0;
            }
        }
        q.b_[d] -= other.b_[d];
    }
    q.c_ -= other.c_;
    return q;
}

int Foam::mpm::quadratic::roots(const int d, const scalar* x, scalar* t) const
{
    scalar y[3] = {x[0], x[1], x[2]};
    y[d] = 0;
    const scalar a = A_[d][d], c = value(y);
    scalar b = b_[d];
    for (int e = 0; e < 3; ++e)
    {
        b += 2 * A_[d][e] * y[e];
    }

    return zeros(a, b, c, t);
}

int Foam::mpm::quadratic::rootsAlong(const scalar* x, const scalar* along, scalar* t) const
{
    scalar g[3], a = 0, b = 0;
    gradient(x, g);
    for (int d = 0; d < 3; ++d)
    {
        b += g[d] * along[d];
        for (int e = 0; e < 3; ++e)
        {
            a += A_[d][e] * along[d] * along[e];
        }
    }
    return zeros(a, b, value(x), t);
}
