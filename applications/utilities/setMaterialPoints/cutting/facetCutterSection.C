/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "facetCutter.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::facetCutter::addFacet
(
    const label facet,
    const point (&x)[3],
    const vector& n
)
{
    const int D = grid_.nDim();
    const point middle(grid_.mesh().bounds().midpoint());
    polygon p;
    const auto computed = [&](const point& q)
    {
        corner c = {0, 0, 0};
        for (int d = 0; d < D; ++d)
        {
            c[d] = q[grid_.direction(d)];
        }
        return c;
    };

    if (D == 3)
    {
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

    // Where the edges cross a plane, of which the upper side owns its places
    const auto section = [](const List<point>& q, const int e, const scalar at)
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
    };
    List<point> q({x[0], x[1], x[2]});
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
    q = section(q, across[0], middle[across[0]]);
    if (q.size() != 2)
    {
        return;
    }
    if (D == 2)
    {
        corner a = computed(q[0]), b = computed(q[1]);
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
            volume_ +=
                0.5*((a[0] - ox)*(b[1] - oy) - (b[0] - ox)*(a[1] - oy));
        }
        else
        {
            // int r da = -/+ int r^2/2 along the edge
            const scalar sign = r == 0 ? 0.5 : -0.5;
            volume_ +=
                grid_.sector()*sign*(b[1 - r] - a[1 - r])
               *(a[r]*a[r] + a[r]*b[r] + b[r]*b[r])/3;
        }
        p = {a, b, b, a};
        p[0][2] = p[1][2] = -1;
        p[2][2] = p[3][2] = 1;
        cut(p, facet);
        return;
    }

    // Two places of a line: in 1D one
    if ((q[0][across[1]] >= middle[across[1]])
     == (q[1][across[1]] >= middle[across[1]]))
    {
        return;
    }
    const label lower = q[0][across[1]] < middle[across[1]] ? 0 : 1;
    const point& u = q[lower];
    const point& v = q[1 - lower];
    const corner a = computed
    (
        u + (v - u)
       *((middle[across[1]] - u[across[1]])/(v[across[1]] - u[across[1]]))
    );
    const scalar sign = n[grid_.direction(0)] > 0 ? 1 : -1;
    volume_ += sign*(a[0] - middle[grid_.direction(0)]);
    p = {a, a, a, a};
    const scalar y[4] = {-1, 1, 1, -1}, z[4] = {-1, -1, 1, 1};
    for (int i = 0; i < 4; ++i)
    {
        p[i][1] = sign*y[i];
        p[i][2] = z[i];
    }
    cut(p, facet);
}

// ************************************************************************* //
