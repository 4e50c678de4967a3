// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "cellCutter.H"
#include "principalAxes.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::cellCutter::addSurface(const label i)
{
    // In the coordinates of the mesh: f = x.A x + b.x + c
    const quadratic& q = formula_.surfaceAt(i);
    const int nDim = grid_.nDim();
    tensor A(Zero);
    vector b(Zero);
    for (int d = 0; d < nDim; ++d)
    {
        b[grid_.direction(d)] = q.gradient(d);
        for (int e = 0; e < nDim; ++e)
        {
            A(grid_.direction(d), grid_.direction(e)) = q.matrix(d, e);
        }
    }
    leaf l{label(atoms_.size()), 0, false, 2};
    atom a{atom::formula, {Zero, 0}, Zero, Zero, 0, nullptr, nullptr, i};
    const auto addPlane = [&](const vector& n, const scalar c)
    {
        a.kind = atom::plane;
        a.h = {n, c};
        atoms_.push_back(a);
    };
    const principalAxes<3> axes(A.cdata());
    const double* k = axes.value;
    const scalar largest = max(mag(k[0]), mag(k[2])), tol = 1e-12 * largest;
    const auto axisOf = [&](const int j)
    {
        const double* n = axes.direction[j];
        return vector(n[0], n[1], n[2]);
    };
    vector round(Zero), free(Zero);
    int nRound = 0;
    bool alike = true;
    scalar K = 0;
    for (int j = 0; j < 3; ++j)
    {
        if (mag(k[j]) > tol)
        {
            ++nRound;
            alike = alike && (K == 0 || mag(k[j] - K) < tol);
            K = K == 0 ? k[j] : K;
            round = axisOf(j);
        }
        else
        {
            free = axisOf(j);
        }
    }
    if (largest == 0)
    {
        if (mag(b) > 0)
        {
            addPlane(b / mag(b), -q.constant() / mag(b));
        }
        else
        {
            l.known = q.constant() <= 0 ? 1 : 0;
        }
        l.last = atoms_.size();
        leaves_.push_back(l);
        return;
    }
    // |x - centre|^2 <= R^2 in the round directions
    const vector along(
        nRound == 3       ? vector(Zero)
            : nRound == 2 ? (b & free) * free
                          : b - (b & round) * round);
    const vector centre(-(b - along) / (2 * K));
    const scalar R2 = magSqr(centre) - q.constant() / K;
    if (!alike || mag(along) > 1e-12 * (mag(b) + largest))
    {
        atoms_.push_back(a);
    }
    else if (R2 <= 0)
    {
        l.known = K > 0 ? 0 : 1;
    }
    else if (nRound == 1)
    {
        l.inverse = K < 0;
        addPlane(round, (round & centre) + std::sqrt(R2));
        addPlane(-round, -(round & centre) + std::sqrt(R2));
    }
    else
    {
        l.inverse = K < 0;
        a.kind = nRound == 3 ? atom::ball : atom::tube;
        a.centre = centre;
        a.axis = free;
        a.R = std::sqrt(R2);
        atoms_.push_back(a);
    }
    l.last = atoms_.size();
    leaves_.push_back(l);
}

void Foam::mpm::cellCutter::addBody(const pointRegionShape& shape, columns& shared)
{
    leaf l{label(atoms_.size()), 0, false, 2};
    atom a{atom::shape, {Zero, 0}, Zero, Zero, 0, nullptr, &shape, -1};
    if (const triSurface* s = shape.facets())
    {
        auto& columns = shared[s];
        if (!columns)
        {
            columns = std::make_shared<facetColumns>(grid_, *s);
        }
        a.kind = atom::facets;
        a.columns = columns.get();
    }
    atoms_.push_back(a);
    l.last = atoms_.size();
    leaves_.push_back(l);
}

bool Foam::mpm::cellCutter::isConvex(const label celli) const
{
    const polyMesh& mesh = grid_.mesh();
    const labelList& corners = mesh.cellPoints()[celli];
    const point& centre = mesh.cellCentres()[celli];
    scalar size = 0;
    for (const label i : corners)
    {
        size = max(size, mag(mesh.points()[i] - centre));
    }
    const scalar tol = 1e-13 * size + 1e-15 * mag(centre);
    for (const label f : mesh.cells()[celli])
    {
        const vector& S = mesh.faceAreas()[f];
        if (!(mag(S) > 0))
        {
            continue;
        }
        const vector n((mesh.faceOwner()[f] == celli ? 1 : -1) * S / mag(S));
        const scalar c = n & mesh.points()[mesh.faces()[f][0]];
        for (const label i : corners)
        {
            if ((n & mesh.points()[i]) > c + tol)
            {
                return false;
            }
        }
        for (const label i : mesh.faces()[f])
        {
            if (mag((n & mesh.points()[i]) - c) > tol)
            {
                return false;
            }
        }
    }
    return true;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::cellCutter::cellCutter(
    const pointGrid& grid, const shapeFormula& formula, columns& shared) :
    grid_(grid), formula_(formula), moments_(false)
{
    for (label i = 0; i < formula.nSurfaces(); ++i)
    {
        addSurface(i);
    }
    for (const pointRegionShape* shape : formula.bodies())
    {
        addBody(*shape, shared);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::cellCutter::share(const label celli) const
{
    // Shares as near to 0 and 1 are that
    constexpr scalar rounding = 1e-13;

    const polyMesh& mesh = grid_.mesh();
    const states unknown(atoms_.size(), 2);
    scalar V = 0, in = 0;
    const auto cornersOf = [&](const label f)
    {
        std::vector<point> x;
        for (const label i : mesh.faces()[f])
        {
            x.push_back(mesh.points()[i]);
        }
        if (mesh.faceOwner()[f] != celli)
        {
            std::reverse(x.begin(), x.end());
        }
        return x;
    };
    if (isConvex(celli))
    {
        polytope p;
        for (const label f : mesh.cells()[celli])
        {
            p.addFace(cornersOf(f));
        }
        V = p.volume();
        in = cut(celli, p, unknown, 0).V;
    }
    else
    {
        const point& apex = mesh.cellCentres()[celli];
        const auto add = [&](const point& a, const point& b, const point& c)
        {
            polytope p;
            p.addFace({a, b, c});
            p.addFace({b, a, apex});
            p.addFace({c, b, apex});
            p.addFace({a, c, apex});
            scalar v = p.volume();
            V += v;
            if (v < 0)
            {
                // A folded cell: what lies beyond a face counts less
                polytope turned;
                turned.addFace({a, c, b});
                turned.addFace({a, b, apex});
                turned.addFace({b, c, apex});
                turned.addFace({c, a, apex});
                in -= cut(celli, turned, unknown, 0).V;
                return;
            }
            in += cut(celli, p, unknown, 0).V;
        };
        for (const label f : mesh.cells()[celli])
        {
            const std::vector<point> x(cornersOf(f));
            const label n = x.size();
            if (n == 3)
            {
                add(x[0], x[1], x[2]);
                continue;
            }
            const point& middle = mesh.faceCentres()[f];
            for (label i = 0; i < n; ++i)
            {
                add(x[i], x[(i + 1) % n], middle);
            }
        }
    }
    const scalar share = in / V;
    return share < rounding ? scalar(0) : share > 1 - rounding ? scalar(1) : share;
}

Foam::mpm::volumeMoment Foam::mpm::cellCutter::part(const label celli, const polytope& p) const
{
    moments_ = true;
    const volumeMoment m(cut(celli, p, states(atoms_.size(), 2), 0));
    moments_ = false;
    return m;
}

Foam::scalar Foam::mpm::cellCutter::volumeInBounds() const
{
    const boundBox& bb = grid_.mesh().bounds();
    polytope p(bb.min(), bb.max());
    if (grid_.radial() >= 0)
    {
        // The sector: |third| <= sector/2 radius
        const int r = grid_.direction(grid_.radial());
        const int a = grid_.direction(1 - grid_.radial());
        point low(bb.min());
        low[r] = min(low[r], scalar(0));
        point high(bb.max());
        polytope in, out;
        p = polytope(low, high);
        for (const int side : {1, -1})
        {
            vector n(Zero);
            n[3 - r - a] = side;
            n[r] = -0.5 * grid_.sector();
            p.split({n / mag(n), 0}, in, out);
            std::swap(p, in);
        }
    }
    return cut(0, p, states(atoms_.size(), 2), 0).V;
}
