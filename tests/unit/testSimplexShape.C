/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    The first level of node-dual functions (simplexShape): products in boxes
    among other cells and their integrals; what is remembered of a point.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "testShapes.H"
#include "testCells.H"
#include "simplexShape.H"
#include <random>

using namespace Foam;
using namespace Foam::mpm;

TEST_CASE("functions of boxes among other cells: products, and the integrals of these")
{
    typedef Foam::mpm::simplexShape<3> shape;
    typedef shape::T T;
    const label n = 5;
    const cellMesh mesh(cellMesh::halfCubes, n);
    const shape functions(mesh.grid());
    const cellSimplices& cells = functions.cells;
    label nBoxes = 0;
    scalar wrong = 0, ofIntegral = 0;
    for (label celli = 0; celli < mesh.grid().nCells(); ++celli)
    {
        if (!cells.isBox(celli))
        {
            continue;
        }
        ++nBoxes;
        shape::stencil s;
        functions.prepare(celli, s);
        REQUIRE(s.n == 8);
        const scalar h = 1.0 / n;
        const auto at = [&](const scalar(&xi)[3], const int i)
        {
            T x[3], l[1] = {};
            scalar S = 1;
            for (int d = 0; d < 3; ++d)
            {
                x[d] = broadcast<shape::W>(cells.origin(celli)[d] + h * xi[d]);
                const scalar side = cells.position(celli, i)[d] - cells.origin(celli)[d];
                S *= 0.5 + xi[d] * sign(side);
            }
            shape::weights of;
            functions.evaluate(s, x, l, of);
            wrong = max(wrong, mag(shape::weight(of, i)[0] - S));
            return shape::weight(of, i)[0];
        };

        // Gauss points, which have S_i dS_j/dx exactly; the derivatives by differences
        scalar volume[8] = {}, SdS[8][24] = {}, given[24];
        for (int g = 0; g < 8; ++g)
        {
            scalar xi[3], S[8];
            for (int d = 0; d < 3; ++d)
            {
                xi[d] = ((g >> d) % 2 ? 0.5 : -0.5) / std::sqrt(3.0);
            }
            for (int i = 0; i < 8; ++i)
            {
                S[i] = at(xi, i);
                volume[i] += S[i] * pow3(h) / 8;
            }
            for (int j = 0; j < 24; ++j)
            {
                scalar up[3] = {xi[0], xi[1], xi[2]}, down[3] = {xi[0], xi[1], xi[2]};
                up[j % 3] = 0.4;
                down[j % 3] = -0.4;
                const scalar dS = (at(up, j / 3) - at(down, j / 3)) / (0.8 * h);
                for (int i = 0; i < 8; ++i)
                {
                    SdS[i][j] += S[i] * dS * pow3(h) / 8;
                }
            }
        }
        for (int i = 0; i < 8; ++i)
        {
            cells.integrals(celli, i, given);
            ofIntegral = max(ofIntegral, mag(cells.integral(celli, i) - volume[i]) / pow3(h));
            for (int j = 0; j < 24; ++j)
            {
                ofIntegral = max(ofIntegral, mag(given[j] - SdS[i][j]) / sqr(h));
            }
        }
    }
    CHECK(nBoxes == n * n * (n / 2) - 8);
    CHECK(wrong < 1e-12);
    CHECK(ofIntegral < 1e-12);
}

TEST_CASE("functions of simplices: what is remembered of a point changes none of them")
{
    typedef Foam::mpm::simplexShape<3> shape;
    typedef shape::T T;
    constexpr int W = shape::W;
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> random(0, 1);
    scalar sum = 0, centre = 0;
    label differ = 0, asked = 0;
    for (const auto kind : {cellMesh::prisms, cellMesh::hexes, cellMesh::polyhedra})
    {
        const cellMesh mesh(kind, 3, true);
        const shape functions(mesh.grid());
        const cellSimplices& cells = functions.cells;
        for (label celli = 0; celli < mesh.grid().nCells(); ++celli)
        {
            shape::stencil s;
            functions.prepare(celli, s);

            // Points in a simplex, in each third cell on a side between two, on an edge of
            // several
            const label* corner = s.corners + 3 * label(random(engine) * s.nSimplices);
            T x[3] = {};
            for (int p = 0; p < W; ++p)
            {
                scalar share[3] = {random(engine), random(engine), random(engine)};
                for (int k = 0; k < celli % 3; ++k)
                {
                    share[k] = 0;
                }
                const scalar scale = 0.9 / (share[0] + share[1] + share[2]) * random(engine);
                for (int d = 0; d < 3; ++d)
                {
                    x[d][p] = s.O[d];
                    for (int k = 0; k < 3; ++k)
                    {
                        x[d][p] +=
                            scale * share[k] * (cells.position(celli, corner[k])[d] - s.O[d]);
                    }
                }
            }
            T first[64];
            for (label known = 0; known <= s.nSimplices + 1; ++known)
            {
                T l[3] = {};
                l[0] += known <= s.nSimplices ? scalar(known) : std::nan("");
                shape::weights S;
                functions.evaluate(s, x, l, S);
                for (int i = 0; i < s.n; ++i)
                {
                    const T w = shape::weight(S, i);
                    first[i] = known == 0 ? w : first[i];
                    for (int p = 0; p < W; ++p)
                    {
                        differ += w[p] != first[i][p];
                        ++asked;
                    }
                }
            }
            for (int p = 0; p < W; ++p)
            {
                scalar one = 0, at[3] = {0, 0, 0};
                for (int i = 0; i < s.n; ++i)
                {
                    one += first[i][p];
                    for (int d = 0; d < 3; ++d)
                    {
                        at[d] += first[i][p] * cells.position(celli, i)[d];
                    }
                }
                sum = max(sum, mag(one - 1));
                for (int d = 0; d < 3; ++d)
                {
                    centre = max(centre, mag(at[d] - x[d][p]));
                }
            }
        }
    }
    CHECK(asked > 10000);
    CHECK(differ == 0);
    CHECK(sum < 1e-14);
    CHECK(centre < 1e-11);
}
