// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testShapes.H"
#include "failureModel.H"
#include "IStringStream.H"
#include <random>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

//- Identities of shapeConcept.H at random points of random cells, with
//  many of them in wall cells and on sides
scalar worstIdentity(
    const pointGrid& grid, const word& name, const scalar halfSizeOfCell, scalar& smallest)
{
    const auto p(passes(name, grid));
    std::mt19937 gen(7);
    std::uniform_real_distribution<scalar> u(0, 1);
    const int D = grid.nDim();

    scalar worst = 0;
    smallest = 0;
    DynamicList<label> nodes;
    DynamicList<scalar> S, dS;

    for (int trial = 0; trial < 4000; ++trial)
    {
        const label celli = trial % 2 ? label(u(gen) * grid.nCells()) % grid.nCells()
                                      : (trial / 2 % 2 ? 0 : grid.nCells() - 1);
        scalar corner[24], x[3] = {0, 0, 0}, xi[3], l[3];
        grid.hexes().cornerPositions(celli, corner);
        for (int d = 0; d < D; ++d)
        {
            xi[d] = u(gen);
            if (trial % 7 == 0)
                xi[d] = 0;
            if (trial % 11 == 0)
                xi[d] = 1 - 1e-13;
            l[d] = halfSizeOfCell * grid.width(celli, d);
        }
        for (int n = 0; n < (1 << D); ++n)
        {
            scalar w = 1;
            for (int d = 0; d < D; ++d)
                w *= (n >> d) & 1 ? xi[d] : 1 - xi[d];
            for (int d = 0; d < D; ++d)
                x[d] += w * corner[D * n + d];
        }
        p->weights(celli, x, l, nodes, S, dS);

        scalar sum = 0, sumX[3] = {0, 0, 0}, sumG[3] = {0, 0, 0}, sumGX[9] = {};
        forAll(nodes, i)
        {
            const point& at = grid.mesh().points()[grid.nodePoint()[nodes[i]]];
            sum += S[i];
            smallest = min(smallest, S[i]);
            for (int d = 0; d < D; ++d)
            {
                const scalar xn = at[grid.direction(d)];
                sumX[d] += S[i] * xn;
                sumG[d] += dS[D * i + d];
                for (int e = 0; e < D; ++e)
                {
                    sumGX[3 * d + e] += xn * dS[D * i + e];
                }
            }
        }
        worst = max(worst, mag(sum - 1));
        for (int d = 0; d < D; ++d)
        {
            const scalar h = grid.width(celli, d);
            worst = max(worst, mag(sumX[d] - x[d]));
            worst = max(worst, mag(sumG[d]) * h);
            for (int e = 0; e < D; ++e)
            {
                worst = max(worst, mag(sumGX[3 * d + e] - (d == e ? 1 : 0)) * 0.1);
            }
        }
    }
    return worst;
}

}

TEST_CASE("nodes and lattice of 1D, 2D and 3D meshes")
{
    const testMesh m1(7, 0, 0, uniform(vector(2, 1, 1)));
    CHECK(m1.grid().nDim() == 1);
    CHECK(m1.grid().nNodes() == 8);
    const testMesh m2(0, 5, 4, uniform(vector(2, 1, 1)));
    CHECK(m2.grid().nDim() == 2);
    CHECK(m2.grid().direction(0) == 1);
    CHECK(m2.grid().direction(1) == 2);
    CHECK(m2.grid().nNodes() == 30);
    CHECK(m2.grid().hasLattice());
    const testMesh m3(3, 4, 5, graded);
    CHECK(m3.grid().nNodes() == 120);
    CHECK(m3.grid().hasLattice());
    const testMesh ms(3, 4, 5, skewed);
    CHECK(!ms.grid().hasLattice());
}

TEST_CASE("half-open cells: a side belongs to the upper cell, the last is closed")
{
    const testMesh m(4, 3, 0, [](const point& p) { return p; });
    const pointGrid& g = m.grid();
    scalar x[3] = {0.25, 1.0 / 3, 0};
    CHECK(g.find(x) == 5);
    x[0] = 0.25 - 1e-15;
    CHECK(g.find(x) == 4);
    x[0] = 1;
    x[1] = 1;
    CHECK(g.find(x) == 11);
    x[0] = 0;
    x[1] = 0;
    CHECK(g.find(x) == 0);
    x[0] = -1e-15;
    CHECK(g.find(x) == -1);
    x[0] = 1 + 1e-15;
    CHECK(g.find(x) == -1);
    // By walking from far away
    x[0] = 0.99;
    x[1] = 0.99;
    CHECK(g.locate(0, x) == 11);
}

TEST_CASE("identities of the shape functions")
{
    // sum S = 1, sum S x = x, sum grad S = 0, sum x grad S = I, S >= 0
    struct item
    {
        const char* name;
        const char* shape;
        testMesh mesh;
        scalar l;
    };
    const item items[] = {
        {"1D uniform", "linear", {9, 0, 0, uniform(vector(1, 1, 1))}, 0},
        {"2D graded", "linear", {6, 5, 0, graded}, 0},
        {"3D graded", "linear", {4, 5, 3, graded}, 0},
        {"2D skewed", "linear", {6, 5, 0, skewed2}, 0},
        {"3D skewed", "linear", {4, 3, 4, skewed}, 0},
        {"1D uniform", "GIMP", {9, 0, 0, uniform(vector(1, 1, 1))}, 0.25},
        {"1D graded", "GIMP", {9, 0, 0, graded}, 0.25},
        {"1D one cell", "GIMP", {1, 0, 0, graded}, 0.25},
        {"1D wide points", "GIMP", {9, 0, 0, graded}, 0.7},
        {"2D graded", "GIMP", {6, 5, 0, graded}, 0.25},
        {"2D yz", "GIMP", {0, 5, 6, graded}, 0.5},
        {"3D uniform", "GIMP", {4, 4, 4, uniform(vector(1, 2, 3))}, 0.25},
        {"3D graded", "GIMP", {4, 5, 3, graded}, 0.125},
        {"1D uniform", "quadraticBSpline", {9, 0, 0, uniform(vector(1, 1, 1))}, 0},
        {"1D one cell", "quadraticBSpline", {1, 0, 0, uniform(vector(2, 1, 1))}, 0},
        {"1D two cells", "quadraticBSpline", {2, 0, 0, uniform(vector(2, 1, 1))}, 0},
        {"2D widths differ", "quadraticBSpline", {6, 5, 0, uniform(vector(1, 3, 1))}, 0},
        {"2D yz", "quadraticBSpline", {0, 5, 6, uniform(vector(1, 1, 0.5))}, 0},
        {"3D uniform", "quadraticBSpline", {4, 4, 4, uniform(vector(1, 1, 1))}, 0},
        {"3D widths differ", "quadraticBSpline", {4, 5, 3, uniform(vector(1, 2, 3))}, 0},
        {"1D uniform", "cubicBSpline", {9, 0, 0, uniform(vector(1, 1, 1))}, 0},
        {"1D one cell", "cubicBSpline", {1, 0, 0, uniform(vector(2, 1, 1))}, 0},
        {"1D two cells", "cubicBSpline", {2, 0, 0, uniform(vector(2, 1, 1))}, 0},
        {"2D widths differ", "cubicBSpline", {6, 5, 0, uniform(vector(1, 3, 1))}, 0},
        {"2D yz", "cubicBSpline", {0, 5, 6, uniform(vector(1, 1, 0.5))}, 0},
        {"3D uniform", "cubicBSpline", {4, 4, 4, uniform(vector(1, 1, 1))}, 0},
        {"3D widths differ", "cubicBSpline", {4, 5, 3, uniform(vector(1, 2, 3))}, 0}};
    for (const item& i : items)
    {
        CAPTURE(i.name);
        CAPTURE(i.shape);
        scalar smallest;
        CHECK(worstIdentity(i.mesh.grid(), i.shape, i.l, smallest) <= 1e-12);
        CHECK(smallest >= -1e-14);
    }
}

TEST_CASE("GIMP at a wall: S_0(wall) = 1, graded too")
{
    for (const bool gradedMesh : {false, true})
    {
        const testMesh m(
            8, 0, 0,
            gradedMesh ? std::function<point(const point&)>(graded) : uniform(vector(1, 1, 1)));
        const pointGrid& g = m.grid();
        const auto p(passes("GIMP", g));
        DynamicList<label> nodes;
        DynamicList<scalar> S, dS;
        for (const label celli : {0, 7})
        {
            scalar corner[24], l[3];
            g.hexes().cornerPositions(celli, corner);
            l[0] = 0.25 * g.width(celli, 0);
            const int side = celli ? 1 : 0;
            p->weights(celli, corner + side, l, nodes, S, dS);
            scalar atWall = 0;
            forAll(nodes, i)
            {
                if (nodes[i] == g.hexes().corners(celli)[side])
                    atWall += S[i];
            }
            CHECK(atWall == doctest::Approx(1).epsilon(1e-13));
        }
    }
}

TEST_CASE("GIMP refuses meshes by reason, linear takes all hexahedra")
{
    const testMesh m(3, 3, 0, skewed2);
    CHECK_THROWS_AS(passes("GIMP", m.grid()), Foam::IOerror);
    CHECK_THROWS_AS(passes("gimp", m.grid()), Foam::IOerror);
    CHECK_NOTHROW(passes("linear", m.grid()));
}

TEST_CASE("B-splines at a wall: S_0(wall) = 1, all other weights 0")
{
    const testMesh m(8, 0, 0, uniform(vector(1, 1, 1)));
    const pointGrid& g = m.grid();
    for (const char* shape : {"quadraticBSpline", "cubicBSpline"})
    {
        CAPTURE(shape);
        const auto p(passes(shape, g));
        CHECK(!p->hasExtent());
        CHECK(p->reach() == 1);
        DynamicList<label> nodes;
        DynamicList<scalar> S, dS;
        for (const label celli : {0, 7})
        {
            scalar corner[24];
            g.hexes().cornerPositions(celli, corner);
            const int side = celli ? 1 : 0;
            p->weights(celli, corner + side, nullptr, nodes, S, dS);
            scalar atWall = 0, elsewhere = 0;
            forAll(nodes, i)
            {
                CHECK(S[i] >= 0);
                (nodes[i] == g.hexes().corners(celli)[side] ? atWall : elsewhere) += S[i];
            }
            CHECK(atWall == doctest::Approx(1).epsilon(1e-13));
            CHECK(elsewhere <= 1e-13);
        }
    }
    CHECK(passes("GIMP", g)->reach() == 1);
    CHECK(passes("linear", g)->reach() == 0);
}

TEST_CASE("B-splines: exact values inside")
{
    const testMesh m(8, 0, 0, uniform(vector(4, 1, 1)));
    const pointGrid& g = m.grid();
    const label celli = 4;
    scalar corner[24];
    g.hexes().cornerPositions(celli, corner);

    struct item
    {
        const char* shape;
        scalar xi, S[4], dS[4];
    };
    const item items[] = {
        {"quadraticBSpline", 0.25, {1 / 32.0, 11 / 16.0, 9 / 32.0, 0}, {-0.25, -0.5, 0.75, 0}},
        {"quadraticBSpline", 0.75, {0, 9 / 32.0, 11 / 16.0, 1 / 32.0}, {0, -0.75, 0.5, 0.25}},
        {"quadraticBSpline", 0.5, {0, 0.5, 0.5, 0}, {0, -1, 1, 0}},
        {"cubicBSpline", 0, {1 / 6.0, 2 / 3.0, 1 / 6.0, 0}, {-0.5, 0, 0.5, 0}},
        {"cubicBSpline",
         0.5,
         {1 / 48.0, 23 / 48.0, 23 / 48.0, 1 / 48.0},
         {-0.125, -0.625, 0.625, 0.125}}};
    for (const item& it : items)
    {
        CAPTURE(it.shape);
        CAPTURE(it.xi);
        DynamicList<label> nodes;
        DynamicList<scalar> S, dS;
        const scalar x = corner[0] + 0.5 * it.xi;
        passes(it.shape, g)->weights(celli, &x, nullptr, nodes, S, dS);
        REQUIRE(nodes.size() == 4);
        for (int i = 0; i < 4; ++i)
        {
            CHECK(mag(S[i] - it.S[i]) <= 1e-14);
            CHECK(mag(dS[i] - it.dS[i] / 0.5) <= 1e-13);
        }
    }

    // The unused slot holds nothing at all
    DynamicList<label> nodes;
    DynamicList<scalar> S, dS;
    for (const scalar xi : {0.1, 0.3, 0.6, 0.9})
    {
        const scalar x = corner[0] + 0.5 * xi;
        passes("quadraticBSpline", g)->weights(celli, &x, nullptr, nodes, S, dS);
        CHECK(S[xi < 0.5 ? 3 : 0] == 0.0);
        CHECK(dS[xi < 0.5 ? 3 : 0] == 0.0);
    }
}

TEST_CASE("B-splines: S, its slope and (cubic) its curvature pass cell sides")
{
    // By node, for x on a side from the cell below and from the cell above
    const testMesh m(6, 0, 0, uniform(vector(3, 1, 1)));
    const pointGrid& g = m.grid();
    const scalar h = 0.5, e = 1e-5 * h;
    for (const char* shape : {"quadraticBSpline", "cubicBSpline"})
    {
        CAPTURE(shape);
        const auto p(passes(shape, g));
        const auto at = [&](const label celli, const scalar x, scalarList& S, scalarList& dS)
        {
            DynamicList<label> nodes;
            DynamicList<scalar> s, ds;
            p->weights(celli, &x, nullptr, nodes, s, ds);
            S.setSize(g.nNodes());
            dS.setSize(g.nNodes());
            S = 0.0;
            dS = 0.0;
            forAll(nodes, i)
            {
                S[nodes[i]] += s[i];
                dS[nodes[i]] += ds[i];
            }
        };
        for (label celli = 0; celli < 5; ++celli)
        {
            CAPTURE(celli);
            scalar corner[24];
            g.hexes().cornerPositions(celli + 1, corner);
            const scalar x = corner[0];
            scalarList S0, dS0, S1, dS1, Sm, dSm, Sp, dSp;
            at(celli, x, S0, dS0);
            at(celli + 1, x, S1, dS1);
            at(celli, x - e, Sm, dSm);
            at(celli + 1, x + e, Sp, dSp);
            forAll(S0, n)
            {
                CHECK(mag(S0[n] - S1[n]) <= 1e-14);
                CHECK(mag(dS0[n] - dS1[n]) * h <= 1e-13);
                // The slope is that of S
                CHECK(mag((S0[n] - Sm[n]) / e - dS0[n]) * h <= 2e-5);
                CHECK(mag((Sp[n] - S1[n]) / e - dS1[n]) * h <= 2e-5);
                if (word(shape) == "cubicBSpline")
                {
                    const scalar below = (dS0[n] - dSm[n]) / e;
                    const scalar above = (dSp[n] - dS1[n]) / e;
                    CHECK(mag(below - above) * h * h <= 1e-4);
                }
            }

            // The quadratic spline changes its formula at the middle
            at(celli, x - 0.5 * h * (1 - 1e-12), S0, dS0);
            at(celli, x - 0.5 * h * (1 + 1e-12), S1, dS1);
            forAll(S0, n)
            {
                CHECK(mag(S0[n] - S1[n]) <= 1e-11);
                CHECK(mag(dS0[n] - dS1[n]) * h <= 1e-11);
            }
        }
    }
}

TEST_CASE("B-splines refuse graded and skewed meshes by reason")
{
    const auto yGraded = [](const point& p)
    { return point(p.x(), p.y() + 0.01 * p.y() * p.y(), p.z()); };
    // As a mesh comes from a file of 6 digits
    const auto rounded = [](const point& p)
    { return point(1e-6 * std::round(1e6 * p.x()), p.y(), p.z()); };
    for (const char* shape : {"quadraticBSpline", "cubicBSpline"})
    {
        CAPTURE(shape);
        const testMesh graded2(3, 3, 0, yGraded), skew(3, 3, 0, skewed2);
        const testMesh fromFile(30, 0, 0, rounded);
        CHECK_THROWS_AS(passes(shape, skew.grid()), Foam::IOerror);
        CHECK_NOTHROW(passes(shape, fromFile.grid()));
        std::string message;
        try
        {
            passes(shape, graded2.grid());
        }
        catch (const Foam::IOerror& error)
        {
            message = error.message();
        }
        CHECK(message.find("direction y is graded") != std::string::npos);
    }
}
