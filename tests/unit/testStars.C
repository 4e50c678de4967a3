/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Areas that points block on the faces of tetrahedra, prisms, hexahedra with
    warped faces, polyhedra and triangles of a wedge (starOperators):
    divergence of g and B, area of a full body, force of random points against
    that on the faces.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "testShapes.H"
#include "testCells.H"
#include "starOperators.H"
#include <random>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

//- Rings of triangles about x, 1 to 2 from it, of n x n squares whose inner
//  points are moved
class ringMesh : public memoryMesh
{
public:
    explicit ringMesh(const label n)
    {
        std::mt19937 gen(5);
        std::uniform_real_distribution<scalar> u(-0.15, 0.15);
        const label behind = (n + 1) * (n + 1);
        pointField points(2 * behind);
        for (label p = 0; p < behind; ++p)
        {
            const label i = p % (n + 1), j = p / (n + 1);
            const scalar x = (i + (i % n ? u(gen) : 0)) / n;
            const scalar r = 1 + (j + (j % n ? u(gen) : 0)) / n;
            points[p] = point(x, r, -0.05 * r);
            points[p + behind] = point(x, r, 0.05 * r);
        }
        cellShapeList cells;
        faceListList sides(2);
        for (label c = 0; c < n * n; ++c)
        {
            const label a = c % n + (n + 1) * (c / n), b = a + 1;
            for (const labelList& l :
                 {labelList({a, b, b + n + 1}), labelList({a, b + n + 1, a + n + 1})})
            {
                labelList all(l), up(l);
                for (label& p : up)
                    p += behind;
                all.append(up);
                cells.append(cellShape(cellModel::ref(cellModel::PRISM), all));
                sides[0].append(face(l).reverseFace());
                sides[1].append(face(up));
            }
        }
        make(
            std::move(points), cells, sides, wordList({"back", "front"}),
            wordList({"wedge", "wedge"}));
    }
};

void stars(const pointGrid& g, const scalar size)
{
    const int D = g.nDim();
    const polyMesh& mesh = g.mesh();
    const starOperators all(g);
    const cellSimplices& cells = all.cells();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const auto across = [&](const label f)
    { return f < mesh.nInternalFaces() ? nei[f] : own[all.mate(f)]; };

    // Random sums of the points of each vertex and node
    std::mt19937 gen(7);
    std::uniform_real_distribution<scalar> u(0, 1);
    scalarList E(all.nVertices()), P(mesh.nCells()), Pl;
    for (scalar& e : E)
        e = u(gen);
    for (scalar& p : P)
        p = u(gen);
    all.toNodes(P, Pl);
    scalar power = 0;
    forAll(E, v)
    {
        const label c = all.cellOf(v);
        power += E[v] * Pl[cells.nodes(c)[v - all.start(c)]];
    }

    scalar divergence = 0, ofB = 0, onFaces = 0;
    vectorField full(mesh.nFaces(), Zero);
    boolList wall(g.nNodes(), false);
    for (label l = 0; l < g.nNodes(); ++l)
    {
        const auto faces = all.facesOf(l);
        const auto vertices = all.verticesOf(l);
        const starOperators::star& s = all.ofNode(l);
        vector gradient(Zero);
        forAll(vertices, i)
        {
            const label c = all.cellOf(vertices[i]);
            const vector e(all.surfaceSum(c, vertices[i] - all.start(c)));
            gradient += e;
            Map<scalar> sum;
            forAll(faces, k)
            {
                const scalar flux = s.g[faces.size() * i + k];
                sum(own[faces[k]], 0) += flux;
                sum(across(faces[k]), 0) -= flux;
                onFaces += E[vertices[i]] * flux * (P[own[faces[k]]] - P[across(faces[k])]);
                full[faces[k]] += flux * e;
            }
            forAll(vertices, j)
            {
                const label h = all.cellOf(vertices[j]);
                sum(h, 0) += all.vertexVolume(vertices[j]) / all.nodeVolume(l);
            }
            sum(c, 0) -= 1;
            forAllConstIters(sum, iter) { divergence = max(divergence, mag(iter.val())); }
        }
        wall[l] = mag(gradient) > 1e-6 * pow(size, D - 1);
        Map<vector> ofCells;
        forAll(faces, k)
        {
            vector B(Zero);
            for (int d = 0; d < D; ++d)
            {
                B[g.direction(d)] = s.B[D * k + d] * all.nodeVolume(l);
            }
            full[faces[k]] -= B;
            ofCells(own[faces[k]], Zero) += B;
            ofCells(across(faces[k]), Zero) -= B;
        }
        forAllConstIters(ofCells, iter) { ofB = max(ofB, mag(iter.val()) / pow(size, D - 1)); }
    }

    // A face of a full body away from walls
    scalar area = 0;
    label nFull = 0;
    for (label f = 0; f < mesh.nInternalFaces(); ++f)
    {
        bool inside = true;
        for (const label p : mesh.faces()[f])
        {
            inside = inside && !wall[g.pointToNode()[p]];
        }
        if (inside)
        {
            vector S(Zero);
            for (int d = 0; d < D; ++d)
            {
                S[g.direction(d)] = mesh.faceAreas()[f][g.direction(d)];
            }
            area = max(area, mag(full[f] - S) / mag(S));
            ++nFull;
        }
    }

    // sum_v E P_l = sum_f flux jumps: -sum_f A (P_N - P_O), without the node's
    // own sinks, which the sum of a node's E over its star has in P_l again
    INFO(
        "divergence " << divergence << " of B " << ofB << " full " << area << " faces " << nFull
                      << " power " << power << " " << onFaces);
    CHECK(divergence < 1e-12);
    CHECK(ofB < 1e-12);
    CHECK(nFull > 0);
    CHECK(area < 1e-12);
    scalar expected = 0;
    forAll(E, v)
    {
        const label c = all.cellOf(v);
        expected += E[v] * (P[c] - Pl[cells.nodes(c)[v - all.start(c)]]);
    }
    CHECK(mag(onFaces - expected) < 1e-11 * mag(power));
}

}

TEST_CASE("areas blocked by points on any cells")
{
    for (const auto kind : {cellMesh::tets, cellMesh::prisms, cellMesh::hexes, cellMesh::polyhedra})
    {
        CAPTURE(kind);
        const cellMesh m(kind, 4);
        stars(m.grid(), 0.25);
    }
    const ringMesh rings(5);
    stars(rings.grid(), 0.2);
}
