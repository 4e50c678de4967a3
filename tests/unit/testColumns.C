/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    The cloud as a registry of columns: one that is added by a line goes
    wherever its points go.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "testMesh.H"
#include "materialPointCloud.H"
#include "IOField.H"
#include "OSspecific.H"
#include <algorithm>
#include <map>
#include <random>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

//- The line
column& wear(materialPointCloud& cloud)
{
    return cloud.need("wear", column::vectors, columnRules(columnRules::sinceRun).initial(2.5));
}

//- Values that need all digits of a double, of a point's id
scalar wearOf(const scalar id, const int c) { return 1 / (id + 3) + c; }

void mark(materialPointCloud& cloud, column& w)
{
    for (label p = 0; p < cloud.size(); ++p)
    {
        for (int c = 0; c < 2; ++c)
            w[c][p] = wearOf(cloud.id()[0][p], c);
    }
}

//- Points before end whose wear is not that of their ids
label wrong(const materialPointCloud& cloud, const column& w, const label end)
{
    label n = 0;
    for (label p = 0; p < end; ++p)
    {
        for (int c = 0; c < 2; ++c)
        {
            n += w[c][p] != wearOf(cloud.id()[0][p], c);
        }
    }
    return n;
}

List<materialPointCloud::newPoint> somePoints(const label n)
{
    std::mt19937 gen(7);
    std::uniform_real_distribution<scalar> u(0, 1);
    List<materialPointCloud::newPoint> points(n);
    for (auto& p : points)
    {
        p.x = point(u(gen), u(gen), 0.5);
        p.U = vector(u(gen), u(gen), 0);
        p.mass = 1 + u(gen);
        p.volume = 1e-3 * (1 + u(gen));
        p.sigma = symmTensor(u(gen), u(gen), 0, u(gen), 0, u(gen));
        p.halfSize = vector::one;
        p.T = 300;
    }
    return points;
}

const label N = 401;

testMesh square()
{
    return testMesh(6, 5, 0, [](const point& p) { return p; });
}

}

TEST_CASE("a column of one line starts, is ordered, put back and sent with its points")
{
    const testMesh m(square());
    const pointGrid& g = m.grid();
    materialPointCloud cloud(g, "worn");
    column& w = wear(cloud);
    CHECK(&w == &wear(cloud));
    CHECK(&w == cloud.findColumn("wear"));
    CHECK(cloud.findColumn("tear") == nullptr);
    CHECK_THROWS(cloud.need("wear", column::scalars, columnRules()));
    CHECK_THROWS(cloud.needHistory("wear", column::vectors));

    cloud.add(somePoints(N));
    for (label p = 0; p < N; ++p)
        REQUIRE(w[1][p] == 2.5);
    mark(cloud, w);

    std::mt19937 gen(3);
    std::uniform_real_distribution<scalar> u(0, 1);
    for (int round = 0; round < 6; ++round)
    {
        DynamicList<materialPointCloud::cellChange> changes;
        cloud.forCells(
            [&](const label p, const label celli)
            {
                scalar x[3] = {u(gen), u(gen), 0};
                for (int d = 0; d < 2; ++d)
                {
                    cloud.xNew()[d][p] = x[d];
                    cloud.UNew()[d][p] = cloud.U()[d][p];
                }
                const label to = g.find(x);
                if (to != celli)
                {
                    changes.append(materialPointCloud::cellChange{p, to});
                }
            });
        REQUIRE(changes.size() > N / 2);
        cloud.sort(changes);
        CHECK(wrong(cloud, w, N) == 0);
        if (round % 2)
            cloud.reject();
        else
            cloud.accept();
        CHECK(wrong(cloud, w, N) == 0);
    }

    // The row of a message, read by another cloud with the same columns
    materialPointCloud other(g, "other");
    column& w2 = wear(other);
    other.add(somePoints(1));
    const label p = N / 3;
    for (int d = 0; d < 2; ++d)
        cloud.xNew()[d][p] = 0.1 + d;
    DynamicList<scalar> row;
    cloud.toRow(p, row);
    // x, U, m, V, sigma, id, wear
    CHECK(row.size() == 2 + 2 + 1 + 1 + 4 + 1 + 2);
    CHECK(row.size() == other.rowSize());
    other.fromRow(row.cdata(), 0);
    other.accept();
    CHECK(other.id()[0][0] == cloud.id()[0][p]);
    CHECK(other.x()[1][0] == 1.1);
    CHECK(wrong(other, w2, 1) == 0);

    // All points as rows, taken by a cloud with another column before
    materialPointCloud third(g, "third");
    column& late = third.need("late", column::scalars, columnRules().initial(7));
    column& w3 = wear(third);
    CHECK(third.setRows(cloud.rows()) == N);
    CHECK(wrong(third, w3, N) == 0);
    CHECK(third.cells() == cloud.cells());
    CHECK(third.start() == cloud.start());
    label differing = 0;
    for (label p = 0; p < N; ++p)
    {
        differing += third.id()[0][p] != cloud.id()[0][p];
        differing += third.x()[0][p] != cloud.x()[0][p];
        differing += third.x()[1][p] != cloud.x()[1][p];
        differing += late[0][p] != 7;
    }
    CHECK(differing == 0);
}

TEST_CASE("a column of one line goes with removed points, and may come late")
{
    const testMesh m(square());
    materialPointCloud cloud(m.grid(), "worn"), debris(m.grid(), "debris");
    materialPointCloud plain(m.grid(), "plain");
    column& w = wear(cloud);
    column& w2 = wear(debris);
    column& own = debris.need("age", column::scalars, columnRules().initial(-1));
    cloud.add(somePoints(N));
    mark(cloud, w);

    boolList gone(N, false);
    DynamicList<label> cells;
    cloud.forCells(
        [&](const label p, const label celli)
        {
            gone[p] = p % 3 == 0;
            if (gone[p])
                cells.append(celli);
        });
    CHECK(cloud.remove(gone) == cells.size());
    debris.take(cloud, cells);
    plain.take(cloud, cells);
    CHECK(cloud.size() + debris.size() == N);
    CHECK(plain.size() == debris.size());
    CHECK(wrong(cloud, w, cloud.size()) == 0);
    CHECK(wrong(debris, w2, debris.size()) == 0);
    for (label p = 0; p < debris.size(); ++p)
        REQUIRE(own[0][p] == -1);

    const scalar before = cloud.bytesPerPoint();
    column& late = cloud.need("late", column::tensors, columnRules().initial(7));
    for (label p = 0; p < cloud.size(); ++p)
        REQUIRE(late[3][p] == 7);
    const scalar perDouble = 8.0 * (cloud.capacity() + column::padding) / cloud.size();
    CHECK(cloud.bytesPerPoint() - before == doctest::Approx(4 * perDouble));
    CHECK(wrong(cloud, w, cloud.size()) == 0);
}

TEST_CASE("a column of one line is written and read bit by bit, by its rules")
{
    const testMesh m(square());
    const pointGrid& g = m.grid();
    const fileName folder(m().time().path() / "0" / "lagrangian" / "worn");
    typedef std::map<scalar, scalar> values;
    values stress;
    {
        materialPointCloud cloud(g, "worn");
        column& w = wear(cloud);
        cloud.need("idle", column::scalars, columnRules());
        cloud.add(somePoints(N));
        mark(cloud, w);
        for (label p = 0; p < N; ++p)
        {
            stress[cloud.id()[0][p]] = cloud.stress()[3][p];
        }
        cloud.writePoints();
    }
    CHECK(isFile(folder / "wear"));
    CHECK(!isFile(folder / "idle"));
    {
        // Directions that are not computed: the cell's centre
        materialPointCloud cloud(g, "worn");
        const IOField<vector> x(cloud.columnObject("x", IOobject::MUST_READ));
        REQUIRE(x.size() == N);
        for (const point& at : x)
            REQUIRE(at.z() == doctest::Approx(0.5));
    }

    const auto reads = [&](const char* name, const column::kinds kind, const columnRules& rules)
    {
        materialPointCloud cloud(g, "worn");
        cloud.need(name, kind, rules);
        return cloud.readPoints();
    };
    const auto wearBy = [&](const columnRules& rules)
    { return reads("wear", column::vectors, rules); };
    {
        materialPointCloud cloud(g, "worn");
        column& w = wear(cloud);
        CHECK(cloud.readPoints() == N);
        CHECK(wrong(cloud, w, N) == 0);
        label nWrong = 0;
        for (label p = 0; p < N; ++p)
        {
            nWrong += stress[cloud.id()[0][p]] != cloud.stress()[3][p];
        }
        CHECK(nWrong == 0);
    }

    // Values by their rules: between 0 and 1.34
    CHECK(wearBy(columnRules(columnRules::required).positive(2, "")) == N);
    CHECK_THROWS(wearBy(columnRules(columnRules::required).positive(1, "")));
    CHECK_THROWS(wearBy(columnRules(columnRules::required).fraction()));

    // A file that is not there
    const auto asked = [&](const columnRules& rules)
    { return reads("tear", column::scalars, rules); };
    CHECK(asked(columnRules(columnRules::optional)) == N);
    CHECK(asked(columnRules(columnRules::sinceRun)) == N);
    CHECK_THROWS(asked(columnRules(columnRules::sinceStart)));
    CHECK_THROWS(asked(columnRules(columnRules::required)));
    {
        rm(folder / "wear");
        materialPointCloud cloud(g, "worn");
        column& w = wear(cloud);
        column& from = cloud.need(
            "from", column::vectors, columnRules(columnRules::sinceRun).position().orElse("x"));
        CHECK(cloud.readPoints() == N);
        for (label p = 0; p < N; ++p)
        {
            REQUIRE(w[0][p] == 2.5);
            REQUIRE(from[1][p] == cloud.x()[1][p]);
        }
    }
    rmDir(m().time().path());
}

TEST_CASE("a column in another order: few points and many, from one on")
{
    std::mt19937 gen(4);
    for (const label n : {7, 519, 520, 521, 528, 1501})
    {
        for (const label first : {0, 5})
        {
            column c("of", column::vectors, 2);
            c.reserve(n, 0);
            alignedArray scratch(n + column::padding);
            labelList from(identity(n));
            std::shuffle(from.begin() + first, from.end(), gen);
            for (label p = 0; p < n; ++p)
            {
                c[0][p] = p;
                c[1][p] = -p;
            }
            c.permute(from.cdata(), first, n, scratch);
            label nWrong = 0;
            for (label p = 0; p < n; ++p)
            {
                nWrong += c[0][p] != from[p] || c[1][p] != -from[p];
            }
            CHECK(nWrong == 0);
        }
    }
}
