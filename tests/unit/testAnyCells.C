/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    The grid on cells that are no hexahedra, and a shape function with a number
    of nodes that is known at run time: linear functions of tetrahedra, six to
    a cube whose points are moved.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "testShapes.H"
#include "testCells.H"
#include "shapeTransfer.H"
#include "stencilShape.H"
#include "faceLocator.H"
#include "tensor.H"
#include <random>

using namespace Foam;
using namespace Foam::mpm;

namespace testShapes
{

//- S_i = S_i(x_0) + g_i.(x - x_0) on cells with DIM + 1 nodes, of up to 8
template<int DIM>
struct simplexShape : stencilShape<DIM, 8, simplexShape<DIM>>
{
    typedef stencilShape<DIM, 8, simplexShape<DIM>> base;
    typedef typename base::T T;

    struct stencil : base::baseStencil
    {
        double g[DIM + 1][DIM], ih[DIM];
    };

    const pointGrid& grid;

    explicit simplexShape(const pointGrid& g) : grid(g) {}

    static string refuses(const pointGrid& g)
    {
        for (label celli = 0; celli < g.nCells(); ++celli)
        {
            if (g.nodesOf(celli).size() != DIM + 1)
            {
                return "a cell is no simplex";
            }
        }
        return string();
    }

    MPM_INLINE void prepare(const label celli, stencil& s) const
    {
        base::setNodes(grid, celli, s);
        tensor J(tensor::I);
        for (int i = 0; i < DIM; ++i)
        {
            for (int d = 0; d < DIM; ++d)
            {
                J(d, i) = s.x[i + 1][d] - s.x[0][d];
            }
            s.ih[i] = 1 / grid.width(celli, i);
        }
        const tensor inverse(inv(J));
        for (int d = 0; d < DIM; ++d)
        {
            s.g[0][d] = 0;
            for (int i = 0; i < DIM; ++i)
            {
                s.g[i + 1][d] = inverse(i, d);
                s.g[0][d] -= inverse(i, d);
            }
        }
    }

    double inverseWidth(const stencil& s, const int d) const { return s.ih[d]; }

    template<bool GRADIENT>
    MPM_INLINE void
    functions(const stencil& s, const T (&x)[DIM], const T*, T* S, T (*dS)[DIM]) const
    {
        for (int i = 0; i < s.n; ++i)
        {
            S[i] = broadcast<base::W>(i == 0);
            for (int d = 0; d < DIM; ++d)
            {
                S[i] += s.g[i][d] * (x[d] - s.x[0][d]);
                if (GRADIENT)
                {
                    dS[i][d] = broadcast<base::W>(s.g[i][d]);
                }
            }
        }
    }

    MPM_INLINE auto left(const stencil& s, const T (&x)[DIM]) const
    {
        T S[8], (*none)[DIM] = nullptr;
        functions<false>(s, x, nullptr, S, none);
        auto in = S[0] > 0.0;
        for (int i = 1; i < s.n; ++i)
        {
            in = in & (S[i] > 0.0);
        }
        return ~in;
    }
};

struct simplexPasses
{
    static autoPtr<pointGridTransfer> New(const pointGrid& grid)
    {
        return autoPtr<pointGridTransfer>(new shapeTransfer<simplexShape, 3>(grid));
    }
};

addNamedToRunTimeSelectionTable(pointGridTransfer, simplexPasses, grid, testSimplex);

//- A random position in a tetrahedron
void inside(const pointGrid& g, const label celli, std::mt19937& gen, scalar* x)
{
    std::uniform_real_distribution<scalar> u(0.01, 1);
    scalar w[4], sum = 0;
    for (scalar& wi : w)
        sum += wi = u(gen);
    for (int d = 0; d < 3; ++d)
    {
        x[d] = 0;
        forAll(g.nodesOf(celli), i)
        {
            const label p = g.nodePoint()[g.nodesOf(celli)[i]];
            x[d] += w[i] / sum * g.mesh().points()[p][d];
        }
    }
}

}

using namespace testShapes;

TEST_CASE("tetrahedra: nodes of cells, cells of nodes, points found through faces")
{
    const cellMesh m(cellMesh::tets, 4);
    const pointGrid& g = m.grid();
    CHECK(!g.hasLattice());
    CHECK(g.nNodes() == 125);
    CHECK(g.nCells() == 384);

    label pairs = 0;
    for (label n = 0; n < g.nNodes(); ++n)
    {
        for (const label celli : g.nodes().cellsOf(n))
        {
            ++pairs;
            CHECK(g.nodesOf(celli).found(n));
        }
    }
    CHECK(pairs == 4 * 384);

    std::mt19937 gen(11);
    label wrong = 0;
    for (label celli = 0; celli < g.nCells(); ++celli)
    {
        scalar x[3];
        inside(g, celli, gen, x);
        wrong += g.find(x) != celli;
        for (const label from : {label(0), label(200), label(383)})
        {
            wrong += g.locate(from, x) != celli;
        }
    }
    CHECK(wrong == 0);

    // On a face both cells say the same; outside is outside
    const polyMesh& mesh = g.mesh();
    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        point c(mesh.faceCentres()[facei]);
        wrong += g.locate(mesh.faceOwner()[facei], &c[0])
            != g.locate(mesh.faceNeighbour()[facei], &c[0]);
    }
    CHECK(wrong == 0);
    scalar beyond[3] = {0.5, 0.5, 1.001};
    CHECK(g.find(beyond) == -1);
}

TEST_CASE("through the faces of boxes: cells and widths of the lattice")
{
    const testMesh m(5, 4, 3, graded);
    const pointGrid& g = m.grid();
    ghostCells ghosts(m());
    const faceLocator faces(m(), g, ghosts);

    std::mt19937 gen(2);
    std::uniform_real_distribution<scalar> u(0, 1);
    for (label celli = 0; celli < g.nCells(); ++celli)
    {
        scalar corner[24], x[3];
        g.hexes().cornerPositions(celli, corner);
        for (int d = 0; d < 3; ++d)
        {
            x[d] = corner[d] + u(gen) * g.width(celli, d);
            CHECK(mag(faces.width(celli, d) - g.width(celli, d)) < 1e-13);
            for (int side = 0; side < 2; ++side)
            {
                CHECK(faces.neighbour(celli, d, side) == g.neighbour(celli, d, side));
            }
        }
        CHECK(faces.locate(0, x) == celli);
        CHECK(g.locate(0, x) == celli);
    }
}

TEST_CASE("a shape of run-time size on tetrahedra: identities, sums, adjoint")
{
    const cellMesh m(cellMesh::tets, 3);
    const pointGrid& g = m.grid();
    const auto pass = passes("testSimplex", g);

    std::mt19937 gen(5);
    std::uniform_real_distribution<scalar> u(-1, 1);
    materialPointCloud cloud(g, "test");
    List<materialPointCloud::newPoint> points(701);
    for (auto& p : points)
    {
        scalar x[3];
        inside(g, label(0.5 * (u(gen) + 1) * g.nCells()) % g.nCells(), gen, x);
        p.x = point(x[0], x[1], x[2]);
        p.U = vector(u(gen), u(gen), u(gen));
        p.mass = 1 + 0.5 * u(gen);
        p.volume = 1 + 0.5 * u(gen);
        p.sigma = symmTensor(u(gen), u(gen), u(gen), u(gen), u(gen), u(gen));
        p.halfSize = vector(0.02, 0.02, 0.02);
    }
    cloud.add(points);
    CHECK(cloud.size() == 701);

    const label N = g.nNodes();
    alignedArray mU(4 * N), f(4 * N), v(4 * N);
    pass->project(cloud, pointGridTransfer::current, mU.data());
    pass->force(cloud, f.data());
    for (label i = 0; i < 4 * N; ++i)
        v.data()[i] = u(gen);

    scalar worst = 0, mass = 0, power = 0, scale = 0;
    vector momentum(Zero);
    DynamicList<label> nodes;
    DynamicList<scalar> S, dS;
    forAll(cloud.cells(), k)
    {
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            scalar x[3];
            for (int d = 0; d < 3; ++d)
                x[d] = cloud.x()[d][p];
            pass->weights(cloud.cells()[k], x, nullptr, nodes, S, dS);
            scalar sum = -1;
            vector at(-x[0], -x[1], -x[2]);
            tensor unit(-tensor::I), L(Zero);
            forAll(nodes, i)
            {
                const point& X = g.mesh().points()[g.nodePoint()[nodes[i]]];
                const vector grad(dS[3 * i], dS[3 * i + 1], dS[3 * i + 2]);
                const scalar* w = v.data() + 4 * nodes[i];
                sum += S[i];
                at += S[i] * X;
                unit += X * grad;
                L += grad * vector(w[0], w[1], w[2]);
            }
            worst = max(worst, max(mag(sum), max(mag(at), 0.1 * mag(unit))));
            const scalar part = -cloud.volume()[0][p] * (cloud.sigma(p) && L);
            power += part;
            scale += mag(part);
            mass += cloud.mass()[0][p];
            for (int d = 0; d < 3; ++d)
            {
                momentum[d] += cloud.mass()[0][p] * cloud.U()[d][p];
            }
        }
    }
    CHECK(worst < 1e-13);

    // Sums to the nodes, and the power of the forces is that of the stresses
    scalar nodePower = 0;
    for (label n = 0; n < N; ++n)
    {
        mass -= mU.data()[4 * n + 3];
        for (int d = 0; d < 3; ++d)
        {
            momentum[d] -= mU.data()[4 * n + d];
            nodePower += f.data()[4 * n + d] * v.data()[4 * n + d];
        }
    }
    CHECK(mag(mass) < 1e-12 * 701);
    CHECK(mag(momentum) < 1e-12 * 701);
    CHECK(mag(power - nodePower) < 1e-13 * scale);

    // Other shape functions refuse these cells, and this one other cells
    CHECK_THROWS(passes("GIMP", g));
    const testMesh boxes(3, 3, 3, graded);
    CHECK_THROWS(passes("testSimplex", boxes.grid()));
}
