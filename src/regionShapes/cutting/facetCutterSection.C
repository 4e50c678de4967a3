/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "facetCutter.H"

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
            crossing.append(u + (v - u)*((at - u[e])/(v[e] - u[e])));
        }
    }
    return List<point>(crossing);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::facetCutter::corner
Foam::mpm::facetCutter::computed(const point& q) const
{
    corner c = {0, 0, 0};
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        c[d] = q[grid_.direction(d)];
    }
    return c;
}


void Foam::mpm::facetCutter::addFacet
(
    const label facet,
    const point (&x)[3],
    const vector& n
)
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
        volume_ += ((a ^ b) & c)/6;
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
    const List<point> q
    (
        section({x[0], x[1], x[2]}, across[0], middle[across[0]])
    );
    if (q.size() == 2 && D == 2)
    {
        addEdge(facet, computed(q[0]), computed(q[1]), n, middle);
    }
    else if (q.size() == 2)
    {
        addPlace(facet, q[0], q[1], across[1], n, middle);
    }
}


void Foam::mpm::facetCutter::addEdge
(
    const label facet,
    corner a,
    corner b,
    const vector& n,
    const point& middle
)
{
    const scalar turn =
        (b[1] - a[1])*n[grid_.direction(0)]
      - (b[0] - a[0])*n[grid_.direction(1)];
    if (turn < 0)
    {
        std::swap(a, b);
    }
    const int r = grid_.radial();
    if (r < 0)
    {
        const scalar ox = middle[grid_.direction(0)];
        const scalar oy = middle[grid_.direction(1)];
        volume_ += 0.5*((a[0] - ox)*(b[1] - oy) - (b[0] - ox)*(a[1] - oy));
    }
    else
    {
        // int r da = -/+ int r^2/2 along the edge
        const scalar sign = r == 0 ? 0.5 : -0.5;
        volume_ +=
            grid_.sector()*sign*(b[1 - r] - a[1 - r])
           *(a[r]*a[r] + a[r]*b[r] + b[r]*b[r])/3;
    }
    polygon p = {a, b, b, a};
    p[0][2] = p[1][2] = -1;
    p[2][2] = p[3][2] = 1;
    cut(p, facet);
}


void Foam::mpm::facetCutter::addPlace
(
    const label facet,
    const point& q0,
    const point& q1,
    const int e,
    const vector& n,
    const point& middle
)
{
    // Two places of a line: in 1D one
    if ((q0[e] >= middle[e]) == (q1[e] >= middle[e]))
    {
        return;
    }
    const point& u = q0[e] < middle[e] ? q0 : q1;
    const point& v = q0[e] < middle[e] ? q1 : q0;
    const corner a = computed(u + (v - u)*((middle[e] - u[e])/(v[e] - u[e])));
    const scalar sign = n[grid_.direction(0)] > 0 ? 1 : -1;
    volume_ += sign*(a[0] - middle[grid_.direction(0)]);
    polygon p = {a, a, a, a};
    const scalar y[4] = {-1, 1, 1, -1}, z[4] = {-1, -1, 1, 1};
    for (int i = 0; i < 4; ++i)
    {
        p[i][1] = sign*y[i];
        p[i][2] = z[i];
    }
    cut(p, facet);
}

// ************************************************************************* //
