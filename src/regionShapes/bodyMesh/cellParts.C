// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "cellParts.H"

// * * * * * * * * * * * *  Protected Member Functions * * * * * * * * * * * //

void Foam::mpm::cellParts::add(
    const label i, const scalar v, const point& mean, const int n, const FixedList<point, 4>& x)
{
    volume_[i] += v;
    moment_[i] += v * mean;
    simplices_.append(simplex{i, n, x, v});
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::mpm::cellParts::simplex::sample(const label m, label i, scalar& weight) const
{
    // u from x[0] to x[1], v of that to x[2], w to x[3]
    point at(x[0]);
    weight = 1;
    for (int k = 1; k < n; ++k)
    {
        const scalar s = (i % m + 0.5) / m;
        i /= m;
        at += s * (x[k] - at);
        weight *= k * std::pow(1 - s, k - 1);
    }
    return at;
}
