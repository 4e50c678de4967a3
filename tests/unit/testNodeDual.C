/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Node-dual functions on tetrahedra, prisms, hexahedra with warped faces,
    polyhedra and boxes, in 1D to 3D: identities of the operators, rings of
    walls, edges and corners; two-level passes against the explicit functions;
    points found in cells with warped faces; cells that do not work.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "testShapes.H"
#include "testCells.H"
#include "nodeDual.H"
#include "simplexShape.H"
#include "constitutiveModel.H"
#include <random>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

constexpr cellMesh::kinds allKinds[] = {
    cellMesh::tets, cellMesh::prisms, cellMesh::hexes, cellMesh::polyhedra, cellMesh::halfCubes};

//- Position of a node in the computed directions
vector place(const pointGrid& g, const label node)
{
    vector x(Zero);
    for (int d = 0; d < g.nDim(); ++d)
    {
        x[d] = g.mesh().points()[g.nodePoint()[node]][g.direction(d)];
    }
    return x;
}

//- From a position to a node of the unit cube, whose x may be cyclic
vector way(const pointGrid& g, const vector& from, const label to, bool cyclic)
{
    vector d(place(g, to) - from);
    d.x() -= cyclic ? std::round(d.x()) : 0;
    return d;
}

//- Largest errors of the identities of W and G, and the volume; cyclic
//  directions are left out
void identities(
    const pointGrid& g, const scalar volume, const scalar size,
    const cellSimplices::kinds kind = cellSimplices::boxes, const bool cyclic = false)
{
    const int D = g.nDim();
    const cellSimplices cells(g, kind);
    const nodeDual dual(g, cells);
    scalar sum = 0, least = 0, centre = 0, grad = 0, unit = 0, all = 0, push = 0;
    label alone = 0;
    vectorField rest(g.nNodes(), Zero);
    for (label m = 0; m < g.nNodes(); ++m)
    {
        scalar W = -1;
        vector d(Zero), G(Zero);
        tensor I(Zero);
        for (int c = 0; c < D; ++c)
        {
            I[4 * c] = -1;
        }
        scalar own = 0;
        for (label e = dual.begin(m); e < dual.begin(m + 1); ++e)
        {
            const vector x(way(g, place(g, m), dual.node(e), cyclic));
            vector Ge(Zero);
            for (int c = 0; c < D; ++c)
            {
                Ge[c] = dual.G(e)[c];
            }
            W += dual.W(e);
            least = min(least, dual.W(e));
            d += dual.W(e) * x;
            G += Ge;
            rest[dual.node(e)] += dual.volume(m) * Ge;
            I += x * Ge;
            own += dual.node(e) == m ? dual.W(e) : 0;
        }
        alone += own > 1 - 1e-12;
        sum = max(sum, mag(W));
        centre = max(centre, mag(d) / size);
        grad = max(grad, mag(G) * size);
        unit = max(unit, mag(I));
        all += dual.volume(m);
    }

    // The force of a uniform stress inside
    for (label m = 0; m < g.nNodes(); ++m)
    {
        push = max(push, dual.reduced(m) ? 0 : mag(rest[m]) / std::pow(size, D - 1));
    }
    INFO(
        "sum " << sum << " centre " << centre << " grad " << grad << " unit " << unit << " volume "
               << all / volume - 1 << " corners " << alone << " at rest " << push);
    CHECK(sum < 1e-12);
    CHECK(least >= 0);
    CHECK(centre < 1e-12);
    CHECK(grad < 1e-12);
    CHECK(unit < 1e-12);
    CHECK(push < 1e-12);
    CHECK(mag(all / volume - 1) < 1e-12);
    CHECK(alone == (cyclic ? 0 : label(1) << D));
}

//- Random points in simplices of random cells; inner: of those without walls
List<materialPointCloud::newPoint>
randomPoints(const pointGrid& g, const label n, std::mt19937& gen, const bool inner)
{
    const int D = g.nDim();
    const cellSimplices cells(g);
    std::uniform_real_distribution<scalar> u(-1, 1), share(0.01, 1);
    std::uniform_int_distribution<label> some(0, g.nCells() - 1);
    List<materialPointCloud::newPoint> points(n);
    for (auto& p : points)
    {
        label celli = some(gen);
        while (inner && g.hexes().walls(celli))
        {
            celli = some(gen);
        }
        const label s = std::uniform_int_distribution<label>(0, cells.nSimplices(celli) - 1)(gen);
        scalar w[4], sum = 0;
        for (int k = 0; k <= D; ++k)
            sum += w[k] = share(gen);
        p.x = g.mesh().cellCentres()[celli];
        for (int d = 0; d < D; ++d)
        {
            scalar& x = p.x[g.direction(d)];
            x = w[D] / sum * cells.origin(celli)[d];
            for (int k = 0; k < D; ++k)
            {
                x += w[k] / sum * cells.position(celli, cells.corners(celli)[D * s + k])[d];
            }
            p.U[g.direction(d)] = u(gen);
        }
        p.mass = 1 + 0.5 * u(gen);
        p.volume = 1 + 0.5 * u(gen);
        p.sigma = Zero;
        for (int i = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j)
            {
                const int a = min(g.direction(i), g.direction(j));
                const int b = max(g.direction(i), g.direction(j));
                const int slot[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
                p.sigma[slot[a][b]] = u(gen);
            }
        }
        p.halfSize = vector(0.02, 0.02, 0.02);
    }
    return points;
}

//- Passes against sums with weights()
template<int D>
void explicitSums(
    const pointGrid& g, const unsigned seed, const bool inner = false, const bool cyclic = false)
{
    constexpr int P = nodeStride<D>;
    CAPTURE(seed);
    std::mt19937 gen(seed);
    std::uniform_real_distribution<scalar> u(-1, 1);
    const auto pass = passes("nodeDual", g);
    materialPointCloud cloud(g, "test");
    cloud.add(randomPoints(g, 300, gen, inner));
    REQUIRE(cloud.size() == 300);

    const label N = g.nNodes();
    alignedArray mU(P * N), f(P * N), fNew(P * N), Mv(P * N), v(P * N);
    scalarField mU0(P * N, Zero), f0(P * N, Zero), Mv0(P * N, Zero);
    for (label n = 0; n < N; ++n)
    {
        for (int d = 0; d < D; ++d)
            v.data()[P * n + d] = u(gen);
    }

    scalar identity = 0, power = 0, powerSum = 0;
    DynamicList<label> nodes;
    DynamicList<scalar> S, dS;
    List<tensor> L(cloud.size(), tensor(Zero));
    forAll(cloud.cells(), k)
    {
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            scalar x[3];
            for (int d = 0; d < D; ++d)
                x[d] = cloud.x()[d][p];
            pass->weights(cloud.cells()[k], x, nullptr, nodes, S, dS);
            scalar sum = -1, vp[3] = {0, 0, 0}, unit[9] = {};
            vector at(Zero), from(Zero);
            for (int d = 0; d < D; ++d)
                from[d] = x[d];
            const scalar m = cloud.mass()[0][p];
            forAll(nodes, i)
            {
                const vector X(way(g, from, nodes[i], cyclic));
                sum += S[i];
                CHECK(S[i] >= 0);
                for (int d = 0; d < D; ++d)
                {
                    at[d] += S[i] * X[d];
                    vp[d] += S[i] * v.data()[P * nodes[i] + d];
                    mU0[P * nodes[i] + d] += m * S[i] * cloud.U()[d][p];
                    for (int c = 0; c < D; ++c)
                    {
                        unit[3 * c + d] += X[c] * dS[D * i + d];
                        L[p][3 * c + d] += v.data()[P * nodes[i] + c] * dS[D * i + d];
                    }
                }
                mU0[P * nodes[i] + D] += m * S[i];
            }
            identity = max(identity, mag(sum));
            const symmTensor sigma(cloud.sigma(p));
            const int slot[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
            for (int d = 0; d < D; ++d)
            {
                identity = max(identity, mag(at[d]));
                for (int c = 0; c < D; ++c)
                {
                    identity = max(identity, 0.1 * mag(unit[3 * c + d] - (c == d)));
                    const int a = min(g.direction(c), g.direction(d));
                    const int b = max(g.direction(c), g.direction(d));
                    const scalar vs = -cloud.volume()[0][p] * sigma[slot[a][b]];
                    power += vs * L[p][3 * c + d];
                    powerSum += mag(vs * L[p][3 * c + d]);
                    forAll(nodes, i)
                    {
                        f0[P * nodes[i] + c] += vs * dS[D * i + d];
                    }
                }
                forAll(nodes, i)
                    Mv0[P * nodes[i] + d] += m * S[i] * vp[d];
            }
        }
    }
    CHECK(identity < 1e-12);

    pass->project(cloud, pointGridTransfer::current, mU.data());
    pass->force(cloud, f.data());
    pass->massTimes(cloud, false, v.data(), Mv.data());
    scalar wrong = 0, largest = 0, nodePower = 0, total = 0, mass = 0;
    vector sumF(Zero);
    for (label i = 0; i < P * N; ++i)
    {
        const bool isMass = i % P == D;
        largest = max(largest, mag(f0[i]));
        wrong = max(wrong, mag(mU.data()[i] - mU0[i]));
        wrong = max(wrong, mag(Mv.data()[i] - Mv0[i]));
        wrong = max(wrong, 0.01 * mag(f.data()[i] - f0[i]));
        nodePower += i % P < D ? f.data()[i] * v.data()[i] : 0;
        mass += isMass ? mU.data()[i] : 0;
        if (i % P < D)
            sumF[i % P] += f.data()[i];
    }
    for (label p = 0; p < cloud.size(); ++p)
        total += cloud.mass()[0][p];
    INFO("wrong " << wrong << " largest force " << largest);
    CHECK(wrong < 1e-12);
    CHECK(mag(mass - total) < 1e-12 * total);
    CHECK(mag(sumF) < 1e-10 * largest);
    CHECK(mag(nodePower - power) < 1e-12 * powerSum);

    // Strain: the work of an elastic law in a small step from no stress, and
    // the force of the new stress as force() gives it
    IStringStream is("type linearElastic; rho 1; E 1; nu 0.3;");
    const auto law(constitutiveModel::New(dictionary(is)));
    scalarField before(cloud.size());
    for (label p = 0; p < cloud.size(); ++p)
        before[p] = cloud.volume()[0][p];
    cloud.needHistory("leftStretch", column::stresses);
    cloud.history()[0].reserve(cloud.capacity(), 0);
    const scalar dt = 1e-4;
    pass->correctStress(cloud, *law, nullptr, dt, 0, v.data(), fNew.data(), nullptr);
    scalar dilation = 0;
    for (label p = 0; p < cloud.size(); ++p)
    {
        scalar tr = 0;
        for (int d = 0; d < D; ++d)
            tr += L[p][4 * d];
        dilation = max(dilation, mag(std::log(cloud.volume()[0][p] / before[p]) - dt * tr));
    }
    CHECK(dilation < 1e-13);
    for (label i = 0; i < P * N; ++i)
        f.data()[i] = 0;
    pass->force(cloud, f.data());
    scalar change = 0;
    for (label i = 0; i < P * N; ++i)
    {
        change = max(change, mag(f.data()[i] - fNew.data()[i]));
    }
    CHECK(change < 1e-12 * largest);
}

//- A random position in a simplex of a cell, or on its outer side
void inSimplex(
    const cellSimplices& cells, const label celli, const label s, const bool onSide,
    std::mt19937& gen, scalar* x)
{
    std::uniform_real_distribution<scalar> share(0.01, 1);
    scalar w[4], sum = 0;
    for (int k = 0; k < 4; ++k)
        sum += w[k] = k == 3 && onSide ? 0 : share(gen);
    for (int d = 0; d < 3; ++d)
    {
        x[d] = w[3] / sum * cells.origin(celli)[d];
        for (int k = 0; k < 3; ++k)
        {
            x[d] += w[k] / sum * cells.position(celli, cells.corners(celli)[3 * s + k])[d];
        }
    }
}

//- Points in all simplices, on their outer sides, in vertices and on edges
void foundByCells(const pointGrid& g)
{
    const cellSimplices& cells = g.simplices();
    const polyMesh& mesh = g.mesh();
    std::mt19937 gen(7);
    std::uniform_int_distribution<label> some(0, g.nCells() - 1);
    label wrong = 0, far = 0, sides = 0, outside = 0, others = 0;
    scalar x[3];
    const auto lambdaOfOrigin = [&](const label celli)
    {
        const label s = cells.simplexOf(celli, x);
        const scalar* I = cells.inverses(celli) + 9 * s;
        scalar lambda = 1;
        for (int k = 0; k < 9; ++k)
        {
            lambda -= I[k] * (x[k % 3] - cells.origin(celli)[k % 3]);
        }
        return lambda;
    };
    for (label celli = 0; celli < g.nCells(); ++celli)
    {
        for (label s = 0; s < cells.nSimplices(celli); ++s)
        {
            inSimplex(cells, celli, s, false, gen, x);
            wrong += g.find(x) != celli;
            far += g.locate(some(gen), x) != celli;

            inSimplex(cells, celli, s, true, gen, x);
            const label facei = cells.faceOf(celli, s);
            const label found = g.locate(celli, x);
            if (facei >= 0 && mesh.isInternalFace(facei))
            {
                const label a = mesh.faceOwner()[facei];
                const label b = mesh.faceNeighbour()[facei];
                sides += found != g.locate(a, x) || found != g.locate(b, x)
                    || (found != a && found != b);
                outside += lambdaOfOrigin(found) < -1e-13;
            }
            else if (facei >= 0)
            {
                sides += found != celli;
            }
        }
        for (const label edgei : mesh.cellEdges()[celli])
        {
            // Cells around an edge may each have it to rounding
            const point e(mesh.edges()[edgei].centre(mesh.points()));
            std::copy_n(&e[0], 3, x);
            const label found = g.locate(celli, x);
            others += found < 0 || lambdaOfOrigin(found) < -1e-12;
        }
    }
    INFO(
        "wrong " << wrong << " from far " << far << " sides " << sides << " not in the cell "
                 << outside << " edges " << others);
    CHECK(wrong == 0);
    CHECK(far == 0);
    CHECK(sides == 0);
    CHECK(outside == 0);
    CHECK(others == 0);
    scalar beyond[3] = {0.5, 0.5, 1.001};
    CHECK(g.find(beyond) == -1);
}

//- Points that are located together have the cells of each alone: inside,
//  outside, in vertices, on faces and all but on them
void locatedTogether(const pointGrid& g)
{
    g.simplices();
    const polyMesh& mesh = g.mesh();
    std::mt19937 gen(5);
    std::uniform_int_distribution<label> some(0, g.nCells() - 1);
    std::uniform_real_distribution<scalar> u(-0.2, 1.2);
    DynamicList<label> cells, from;
    DynamicList<scalar> x;
    const auto add = [&](const label celli, const point& p)
    {
        from.append(celli);
        for (int d = 0; d < 3; ++d)
        {
            x.append(d < g.nDim() ? p[g.direction(d)] : 0);
        }
    };
    for (label i = 0; i < 2000; ++i)
    {
        add(some(gen), point(u(gen), u(gen), u(gen)));
    }
    forAll(mesh.faces(), facei)
    {
        const label own = mesh.faceOwner()[facei];
        const point& c = mesh.faceCentres()[facei];
        const point& inside = mesh.cellCentres()[own];
        for (const scalar part : {0.0, 1e-15, -1e-15, 1e-10, -1e-10, 1e-3, -1e-3})
        {
            add(own, c + part * (inside - c));
            add(some(gen), c + part * (inside - c));
        }
    }
    for (const point& p : mesh.points())
    {
        add(some(gen), p);
    }
    scalarList together(x), alone(x);
    labelList found(from);
    g.locateAll(found.size(), found.begin(), together.begin());
    label wrong = 0, moved = 0, nInside = 0;
    forAll(from, i)
    {
        wrong += found[i] != g.locate(from[i], alone.begin() + 3 * i);
        nInside += found[i] >= 0;
    }
    forAll(x, i)
    {
        moved += together[i] != alone[i];
    }
    CHECK(wrong == 0);
    CHECK(moved == 0);
    CHECK(nInside > found.size() / 2);
    CHECK(nInside < found.size());
}

}

TEST_CASE("node-dual operators: identities on all kinds of cells")
{
    identities(cellMesh(cellMesh::tets, 5).grid(), 1, 0.2);
    identities(cellMesh(cellMesh::prisms, 5).grid(), 1, 0.2);
    identities(cellMesh(cellMesh::hexes, 5).grid(), 1, 0.2);
    identities(cellMesh(cellMesh::polyhedra, 5).grid(), 1, 0.2);
    identities(cellMesh(cellMesh::halfCubes, 5).grid(), 1, 0.2);
    for (const auto kind : allKinds)
    {
        CAPTURE(int(kind));
        identities(cellMesh(kind, 6, false, true).grid(), 1, 0.2, cellSimplices::boxes, true);
    }
    identities(testMesh(7, 5, 0, graded).grid(), 1.4 * 3, 0.2);
    identities(testMesh(7, 5, 0, graded).grid(), 1.4 * 3, 0.2, cellSimplices::linear);
    identities(testMesh(7, 0, 0, graded).grid(), 1.4, 0.2);
    const scalar volume = 1.4 * 3 * (std::exp(1) - 1);
    identities(testMesh(7, 5, 4, graded).grid(), volume, 0.2, cellSimplices::products);
    identities(testMesh(9, 5, 4, uniform(vector(1, 1, 1))).grid(), 1, 0.2, cellSimplices::products);
    identities(testMesh(7, 5, 0, graded).grid(), 1.4 * 3, 0.2, cellSimplices::products);
    identities(testMesh(7, 0, 0, graded).grid(), 1.4, 0.2, cellSimplices::products);
}

TEST_CASE("node-dual cells: points are found by the triangles of warped faces")
{
    foundByCells(cellMesh(cellMesh::tets, 4).grid());
    foundByCells(cellMesh(cellMesh::prisms, 4).grid());
    foundByCells(cellMesh(cellMesh::hexes, 4).grid());
    foundByCells(cellMesh(cellMesh::polyhedra, 4).grid());
    foundByCells(cellMesh(cellMesh::halfCubes, 4).grid());
}

TEST_CASE("node-dual functions: passes in two levels are sums over the functions")
{
    explicitSums<3>(cellMesh(cellMesh::tets, 3).grid(), 1);
    explicitSums<3>(cellMesh(cellMesh::prisms, 3, true).grid(), 2);
    explicitSums<3>(cellMesh(cellMesh::hexes, 3, true).grid(), 3);
    explicitSums<3>(cellMesh(cellMesh::polyhedra, 3, true).grid(), 4);
    explicitSums<3>(cellMesh(cellMesh::tets, 6, false, true).grid(), 7, false, true);
    const cellMesh joined(cellMesh::polyhedra, 6, true, true);
    explicitSums<3>(joined.grid(), 8, false, true);
    explicitSums<3>(cellMesh(cellMesh::halfCubes, 4).grid(), 11);
    explicitSums<3>(cellMesh(cellMesh::halfCubes, 6, false, true).grid(), 12, false, true);
    explicitSums<2>(testMesh(6, 5, 0, graded).grid(), 5);
    explicitSums<1>(testMesh(9, 0, 0, graded).grid(), 6);

    // Rows that are alike, up to the walls and beside empty cells
    const auto cube = uniform(vector(1, 1, 1));
    for (const bool inner : {false, true})
    {
        explicitSums<3>(testMesh(4, 4, 5, graded).grid(), 7, inner);
        explicitSums<3>(testMesh(12, 5, 4, cube).grid(), 8, inner);
        explicitSums<2>(testMesh(90, 6, 0, cube).grid(), 9, inner);
        explicitSums<1>(testMesh(80, 0, 0, cube).grid(), 10, inner);
    }
}

TEST_CASE("node-dual cells: points located together are where each alone is")
{
    for (const auto kind : allKinds)
    {
        CAPTURE(int(kind));
        locatedTogether(cellMesh(kind, 4).grid());
        locatedTogether(cellMesh(kind, 4, false, true).grid());
    }
    locatedTogether(testMesh(5, 4, 3, graded).grid());
}
