// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testShapes.H"
#include "failureModel.H"
#include "IStringStream.H"
#include <random>

using namespace Foam;
using namespace Foam::mpm;

TEST_CASE("P2G and G2P: mass, momentum, force, adjoint operators")
{
    struct item
    {
        const char* name;
        const char* shape;
        testMesh mesh;
    };
    const item items[] = {
        {"1D", "linear", {9, 0, 0, graded}},
        {"1D", "GIMP", {9, 0, 0, graded}},
        {"2D", "linear", {6, 5, 0, graded}},
        {"2D", "GIMP", {6, 5, 0, graded}},
        {"2Dskew", "linear", {6, 5, 0, skewed2}},
        {"3D", "linear", {4, 5, 3, graded}},
        {"3D", "GIMP", {4, 5, 3, graded}},
        {"3Dskew", "linear", {4, 5, 3, skewed}},
        {"1D", "quadraticBSpline", {9, 0, 0, uniform(vector(1, 1, 1))}},
        {"2D", "quadraticBSpline", {6, 5, 0, uniform(vector(1, 2, 1))}},
        {"3D", "quadraticBSpline", {4, 5, 3, uniform(vector(1, 2, 1.5))}},
        {"1D", "cubicBSpline", {9, 0, 0, uniform(vector(1, 1, 1))}},
        {"2D", "cubicBSpline", {6, 5, 0, uniform(vector(1, 2, 1))}},
        {"3D", "cubicBSpline", {4, 5, 3, uniform(vector(1, 2, 1.5))}}};
    for (const item& it : items)
    {
        CAPTURE(it.name);
        CAPTURE(it.shape);
        const pointGrid& g = it.mesh.grid();
        const int D = g.nDim();
        const int P = D == 1 ? 2 : 4;
        const auto passesPtr(passes(it.shape, g));
        const pointGridTransfer& pass = *passesPtr;

        materialPointCloud cloud(g, "test");
        if (pass.hasExtent())
            cloud.needHalfSize();

        std::mt19937 gen(5);
        std::uniform_real_distribution<scalar> u(-1, 1);
        List<materialPointCloud::newPoint> points(517);
        for (auto& p : points)
        {
            const label celli = label(0.5 * (u(gen) + 1) * g.nCells()) % g.nCells();
            scalar corner[24], x[3] = {0, 0, 0};
            g.hexes().cornerPositions(celli, corner);
            p.x = g.mesh().cellCentres()[celli];
            scalar xi[3];
            for (int d = 0; d < D; ++d)
                xi[d] = 0.5 * (u(gen) + 1);
            for (int n = 0; n < (1 << D); ++n)
            {
                scalar w = 1;
                for (int d = 0; d < D; ++d)
                    w *= (n >> d) & 1 ? xi[d] : 1 - xi[d];
                for (int d = 0; d < D; ++d)
                    x[d] += w * corner[D * n + d];
            }
            for (int d = 0; d < D; ++d)
                p.x[g.direction(d)] = x[d];
            p.U = vector(u(gen), u(gen), u(gen));
            p.mass = 1 + 0.5 * u(gen);
            p.volume = 1 + 0.5 * u(gen);
            p.sigma = symmTensor(u(gen), u(gen), u(gen), u(gen), u(gen), u(gen));
            p.halfSize = vector(0.02, 0.02, 0.02);
        }
        cloud.add(points);
        CHECK(cloud.size() == 517);

        const label N = g.nNodes();
        alignedArray mU(P * N), f(P * N), q(P * N), Mu(P * N);
        pass.project(cloud, pointGridTransfer::current, mU.data());
        pass.force(cloud, f.data());

        scalar mass = 0, p0[3] = {}, nodeMass = 0, np[3] = {}, nf[3] = {};
        scalar size = 0;
        for (label p = 0; p < cloud.size(); ++p)
        {
            mass += cloud.mass()[0][p];
            for (int d = 0; d < D; ++d)
                p0[d] += cloud.mass()[0][p] * cloud.U()[d][p];
        }
        for (label n = 0; n < N; ++n)
        {
            nodeMass += mU.data()[P * n + D];
            CHECK(mU.data()[P * n + D] >= 0);
            for (int d = 0; d < D; ++d)
            {
                np[d] += mU.data()[P * n + d];
                nf[d] += f.data()[P * n + d];
                size = max(size, mag(f.data()[P * n + d]));
            }
        }
        CHECK(mag(nodeMass - mass) <= 1e-12 * mass);
        for (int d = 0; d < D; ++d)
        {
            CHECK(mag(np[d] - p0[d]) <= 1e-12 * mass);
            // sum_l grad S_l = 0: no net force
            CHECK(mag(nf[d]) <= 1e-11 * size);
        }

        // Power: sum_l f_l.u_l = -sum_p v_p sigma_p : grad u(x_p), with
        // grad u from the same weights one point at a time
        for (label n = 0; n < N; ++n)
        {
            for (int d = 0; d < D; ++d)
            {
                q.data()[P * n + d] = u(gen);
            }
        }
        scalar nodePower = 0, pointPower = 0, power = 0;
        for (label n = 0; n < N; ++n)
        {
            for (int d = 0; d < D; ++d)
                nodePower += f.data()[P * n + d] * q.data()[P * n + d];
        }
        pass.massTimes(cloud, false, q.data(), Mu.data());
        scalar nodeMuu = 0, pointMuu = 0;
        for (label n = 0; n < N; ++n)
        {
            for (int d = 0; d < D; ++d)
                nodeMuu += Mu.data()[P * n + d] * q.data()[P * n + d];
        }
        DynamicList<label> nodes;
        DynamicList<scalar> S, dS;
        forAll(cloud.cells(), k)
        {
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                scalar x[3], l[3] = {0.02, 0.02, 0.02}, L[9] = {}, up[3] = {};
                for (int d = 0; d < D; ++d)
                    x[d] = cloud.x()[d][p];
                pass.weights(cloud.cells()[k], x, l, nodes, S, dS);
                forAll(nodes, i)
                {
                    for (int a = 0; a < D; ++a)
                    {
                        up[a] += S[i] * q.data()[P * nodes[i] + a];
                        for (int b = 0; b < D; ++b)
                        {
                            L[3 * a + b] += q.data()[P * nodes[i] + a] * dS[D * i + b];
                        }
                    }
                }
                for (int a = 0; a < D; ++a)
                {
                    pointMuu += cloud.mass()[0][p] * sqr(up[a]);
                    for (int b = 0; b < D; ++b)
                    {
                        const scalar w =
                            cloud.volume()[0][p] * cloud.stress()[symmSlot(a, b)][p] * L[3 * a + b];
                        pointPower -= w;
                        power += mag(w);
                    }
                }
            }
        }
        CHECK(mag(nodePower - pointPower) <= 1e-12 * power);
        CHECK(mag(nodeMuu - pointMuu) <= 1e-12 * mag(pointMuu));

        // A linear velocity field gives its gradient at every point, whatever
        // the number of points of a cell
        IStringStream is("type linearElastic; rho 1; E 1; nu 0;");
        const auto law(constitutiveModel::New(dictionary(is)));
        for (label n = 0; n < N; ++n)
        {
            const point& at = g.mesh().points()[g.nodePoint()[n]];
            for (int a = 0; a < D; ++a)
            {
                q.data()[P * n + a] = 0;
                for (int b = 0; b < D; ++b)
                {
                    q.data()[P * n + a] += 1e-3 * (1 + a + 2 * b) * at[g.direction(b)];
                }
            }
        }
        cloud.needHistory("leftStretch", column::stresses);
        cloud.history()[0].reserve(cloud.capacity(), 0);
        for (label p = 0; p < cloud.size(); ++p)
        {
            for (int s = 0; s < nStress(D); ++s)
                cloud.stress()[s][p] = 0;
            cloud.mass()[0][p] = cloud.volume()[0][p] = 1;
        }
        pass.correctStress(cloud, *law, nullptr, 1e-4, 0, q.data(), f.data(), nullptr);
        scalar least = GREAT, most = -GREAT, trace = 0;
        for (int a = 0; a < D; ++a)
            trace += 1e-7 * (1 + 3 * a);
        for (label p = 0; p < cloud.size(); ++p)
        {
            least = min(least, cloud.volume()[0][p]);
            most = max(most, cloud.volume()[0][p]);
        }
        CHECK(mag(least - std::exp(trace)) <= 1e-14);
        CHECK(mag(most - std::exp(trace)) <= 1e-14);
        // sigma_xx = E h_xx: of each point
        scalar worst = 0;
        for (label p = 0; p < cloud.size(); ++p)
        {
            worst = max(worst, mag(cloud.stress()[0][p] - 1e-7));
        }
        CHECK(worst <= 1e-13);
    }
}

TEST_CASE("sort brings every column along and reject restores every bit")
{
    const testMesh m(8, 7, 0, [](const point& p) { return p; });
    const pointGrid& g = m.grid();
    materialPointCloud cloud(g, "test");
    cloud.needDamage();
    cloud.needHistory("h", column::tensors);

    std::mt19937 gen(11);
    std::uniform_real_distribution<scalar> u(0, 1);
    List<materialPointCloud::newPoint> points(601);
    for (auto& p : points)
    {
        p.x = point(0.2 + 0.4 * u(gen), 0.3 + 0.4 * u(gen), 0.5);
        p.U = vector(u(gen), u(gen), 0);
        p.mass = u(gen);
        p.volume = u(gen);
        p.sigma = symmTensor(u(gen), 0, 0, u(gen), 0, u(gen));
        p.halfSize = vector::one;
    }
    cloud.add(points);
    const label n = cloud.size();

    // Every column gets a value that its id knows
    const auto mark = [&]()
    {
        for (label p = 0; p < n; ++p)
        {
            const scalar id = cloud.id()[0][p];
            (*cloud.damage())[0][p] = 2 * id;
            for (int c = 0; c < 4; ++c)
                cloud.history()[0][c][p] = id + 0.1 * c;
            cloud.mass()[0][p] = 3 * id + 1;
        }
    };
    mark();

    for (int round = 0; round < 30; ++round)
    {
        std::vector<scalar> ids, x0, y0;
        for (label p = 0; p < n; ++p)
        {
            ids.push_back(cloud.id()[0][p]);
            x0.push_back(cloud.x()[0][p]);
            y0.push_back(cloud.x()[1][p]);
        }
        const labelList cells0(cloud.cells()), start0(cloud.start());

        // Random walk, reflected
        DynamicList<materialPointCloud::cellChange> cellChanges;
        forAll(cells0, k)
        {
            for (label p = start0[k]; p < start0[k + 1]; ++p)
            {
                scalar x[3];
                for (int d = 0; d < 2; ++d)
                {
                    x[d] = cloud.x()[d][p] + 0.2 * (u(gen) - 0.5);
                    x[d] = mag(x[d]);
                    if (x[d] > 1)
                        x[d] = 2 - x[d];
                    cloud.xNew()[d][p] = x[d];
                    cloud.UNew()[d][p] = cloud.id()[0][p];
                }
                const label to = g.locate(cells0[k], x);
                REQUIRE(to >= 0);
                if (to != cells0[k])
                {
                    cellChanges.append(materialPointCloud::cellChange{p, to});
                }
            }
        }
        cloud.sort(cellChanges);

        if (round % 3 == 2)
        {
            cloud.reject();
            REQUIRE(cloud.cells() == cells0);
            REQUIRE(cloud.start() == start0);
            for (label p = 0; p < n; ++p)
            {
                REQUIRE(cloud.id()[0][p] == ids[p]);
                REQUIRE(cloud.x()[0][p] == x0[p]);
                REQUIRE(cloud.x()[1][p] == y0[p]);
                REQUIRE(cloud.mass()[0][p] == 3 * ids[p] + 1);
            }
            continue;
        }
        cloud.accept();

        label counted = 0;
        forAll(cloud.cells(), k)
        {
            REQUIRE((k == 0 || cloud.cells()[k] > cloud.cells()[k - 1]));
            REQUIRE(cloud.start()[k + 1] > cloud.start()[k]);
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                ++counted;
                scalar x[3] = {cloud.x()[0][p], cloud.x()[1][p], 0};
                REQUIRE(g.find(x) == cloud.cells()[k]);
                const scalar id = cloud.id()[0][p];
                REQUIRE((p == cloud.start()[k] || id > cloud.id()[0][p - 1]));
                REQUIRE(cloud.U()[0][p] == id);
                REQUIRE((*cloud.damage())[0][p] == 2 * id);
                REQUIRE(cloud.mass()[0][p] == 3 * id + 1);
                for (int c = 0; c < 4; ++c)
                {
                    REQUIRE(cloud.history()[0][c][p] == id + 0.1 * c);
                }
            }
        }
        REQUIRE(counted == n);
    }
}

TEST_CASE("APIC: points that turn as a rigid body give nodes and a gradient that do")
{
    // sym grad u over omega of the projected velocity, at all points of a disk
    const scalar omega = 3.7;
    const auto deformation =
        [&](const pointGrid& g, const word& name, const bool withMatrix, const bool moment)
    {
        const int D = g.nDim(), P = D == 1 ? 2 : 4;
        materialPointCloud cloud(g, "test");
        cloud.needHalfSize();
        cloud.needAffine();

        // Mean of the mesh's points is the middle of the disk or ball
        const point c(average(g.mesh().points()));
        std::mt19937 gen(3);
        std::uniform_real_distribution<scalar> u(-1, 1);
        DynamicList<materialPointCloud::newPoint> points;
        while (points.size() < 700)
        {
            materialPointCloud::newPoint p;
            vector r(u(gen), u(gen), D > 2 ? u(gen) : 0);
            if (mag(r) > 1)
            {
                continue;
            }
            r *= 0.3;
            p.x = c + r;
            p.U = omega * vector(-r.y(), r.x(), 0);
            p.mass = 1 + 0.5 * u(gen);
            p.volume = 1;
            p.sigma = Zero;
            p.halfSize = vector(0.02, 0.02, 0.02);
            points.append(p);
        }
        cloud.add(points);
        for (label p = 0; withMatrix && p < cloud.size(); ++p)
        {
            (*cloud.affine())[1][p] = -omega;
            (*cloud.affine())[D][p] = omega;
        }

        const autoPtr<pointGridTransfer> passPtr(passes(name, g));
        alignedArray mU(P * g.nNodes());
        passPtr->project(cloud, pointGridTransfer::current, mU.data());
        scalar* q = mU.data();
        for (label n = 0; n < g.nNodes(); ++n)
        {
            const scalar m = q[P * n + D];
            for (int d = 0; d < D; ++d)
            {
                q[P * n + d] = m > 0 ? q[P * n + d] / m : 0;
            }
        }
        passPtr->affine(cloud, moment, q, 0);

        scalar worst = 0;
        const column& C = *cloud.affineNew();
        for (label p = 0; p < cloud.size(); ++p)
        {
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j)
                {
                    worst = max(worst, mag(C[i * D + j][p] + C[j * D + i][p]) / 2);
                }
            }
        }
        return worst / omega;
    };

    const auto unit = [](const point& p) { return p; };
    const testMesh lattice(12, 11, 0, unit), block(9, 8, 7, unit);
    for (const word name : {"linear", "GIMP", "quadraticBSpline", "cubicBSpline"})
    {
        for (const testMesh* m : {&lattice, &block})
        {
            CAPTURE(std::string(name));
            CHECK(deformation(m->grid(), name, true, false) <= 1e-12);
            CHECK(deformation(m->grid(), name, true, true) <= 1e-12);
            const scalar FLIP = deformation(m->grid(), name, false, false);
            MESSAGE("sym L/omega of FLIP, ", std::string(name), ": ", FLIP);
            CHECK(FLIP > 1e-3);
        }
    }
    const testMesh skew(12, 11, 0, skewed2), skew3(9, 8, 7, skewed);
    for (const testMesh* m : {&skew, &skew3})
    {
        CHECK(deformation(m->grid(), "linear", true, false) <= 1e-12);
    }
}

TEST_CASE("move: (7) and (8) with any coefficients, point by point")
{
    const testMesh square(12, 11, 0, [](const point& p) { return p; });
    const testMesh block(5, 6, 4, [](const point& p) { return p; });
    std::mt19937 gen(7);
    std::uniform_real_distribution<scalar> u(-1, 1);
    for (const testMesh* m : {&square, &block})
    {
        for (const word name : {"linear", "GIMP", "quadraticBSpline"})
        {
            CAPTURE(std::string(name));
            const pointGrid& g = m->grid();
            const int D = g.nDim(), P = D == 1 ? 2 : 4;
            const autoPtr<pointGridTransfer> pass(passes(name, g));
            materialPointCloud cloud(g, "test");
            cloud.needHalfSize();
            const point c(average(g.mesh().points()));
            List<materialPointCloud::newPoint> points(101);
            for (auto& p : points)
            {
                p.x = c + 0.3 * vector(u(gen), u(gen), D > 2 ? u(gen) : 0);
                p.U = vector(u(gen), u(gen), u(gen));
                p.mass = 1 + 0.5 * u(gen);
                p.volume = 1;
                p.sigma = Zero;
                p.halfSize = vector(0.02, 0.02, 0.02);
            }
            cloud.add(points);

            alignedArray U(P * g.nNodes()), UL(P * g.nNodes()), dU(P * g.nNodes());
            for (label i = 0; i < P * g.nNodes(); ++i)
            {
                U.data()[i] = u(gen);
                UL.data()[i] = u(gen);
                dU.data()[i] = u(gen);
            }
            const scalar* node[] = {U.data(), UL.data(), dU.data()};

            // All terms, and each scheme's pattern of zeroes
            for (const moveCoefficients c :
                 {moveCoefficients{0.7, 1.1, 0.4, 0.3, -0.6, 0.8, 0.9},
                  moveCoefficients{1, 1, 0, 0, 0, 1, 0},
                  moveCoefficients{0.9, 1, 0.1, 0, -0.5, 1, 0},
                  moveCoefficients{0, 0, 1, 0.5, 0, 0.5, 0}, moveCoefficients{0, 0, 1, 0, 0, 1, 0},
                  moveCoefficients{1, 1, 0, 0, 0, 0, 1}})
            {
                for (const bool energy : {false, true})
                {
                    pointGridTransfer::moveRule rule;
                    rule.dt = 1e-2;
                    rule.take = c;
                    rule.energy = energy;
                    rule.bodyForce = nullptr;
                    rule.outflow = nullptr;
                    DynamicList<materialPointCloud::cellChange> changes;
                    const auto result(
                        pass->move(cloud, rule, {U.data(), UL.data(), dU.data()}, changes));
                    CHECK(result.badPoint == -1);

                    scalar worst = 0, work = 0, size = 0;
                    DynamicList<label> nodes;
                    DynamicList<scalar> S, dS;
                    forAll(cloud.cells(), k)
                    {
                        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                        {
                            scalar x[3], l[3] = {0.02, 0.02, 0.02};
                            for (int d = 0; d < D; ++d)
                                x[d] = cloud.x()[d][p];
                            pass->weights(cloud.cells()[k], x, l, nodes, S, dS);
                            for (int d = 0; d < D; ++d)
                            {
                                scalar q[3] = {0, 0, 0};
                                for (int i = 0; i < 3; ++i)
                                {
                                    forAll(nodes, n)
                                    {
                                        q[i] += S[n] * node[i][P * nodes[n] + d];
                                    }
                                }
                                const scalar v = cloud.U()[d][p];
                                const scalar w = cloud.mass()[0][p] * (v + 0.5 * q[2]);
                                work += w * q[2];
                                size += mag(w * q[2]);
                                worst =
                                    max(worst,
                                        mag(c.a0 * (v + c.a1 * q[2]) + c.a2 * q[1]
                                            - cloud.UNew()[d][p]));
                                worst = max(
                                    worst,
                                    mag(x[d]
                                        + rule.dt
                                            * (c.b0 * v + c.b1 * q[2] + c.b2 * q[1] + c.b3 * q[0])
                                        - cloud.xNew()[d][p]));
                            }
                        }
                    }
                    CHECK(worst <= 1e-14);
                    CHECK(mag(result.work - (energy ? work : 0)) <= 1e-13 * size);
                }
            }
        }
    }
}
