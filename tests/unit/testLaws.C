// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testLaws.H"
#include "failureModel.H"
#include "IOstreams.H"

using namespace Foam;
using namespace Foam::mpm;

TEST_CASE("linearElastic: uniaxial strain against the closed form")
{
    // s = (lambda + 2 mu) ln F, lateral lambda ln F; s = sigma or F sigma.
    // Work done: int sigma dF, with M = lambda + 2 mu:
    // M (F ln F - F + 1) or M (ln F)^2/2
    const scalar nu = 0.3;
    const scalar lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), mu = E / (2 * (1 + nu));

    for (const bool kirchhoff : {false, true})
        for (int D = 1; D <= 3; ++D)
        {
            const auto law(elastic(nu, kirchhoff ? "Kirchhoff" : "Cauchy"));
            for (const scalar step : {1e-3, -1e-3, 0.02, -0.02, 0.3})
            {
                points p(D, 11, 2700);
                std::vector<scalar> L(9, 0);
                L[0] = step;
                for (int i = 0; i < 5; ++i)
                    p.apply(*law, L);

                const scalar h = 5 * step, F = std::exp(h), J = kirchhoff ? F : 1;
                const scalar axial = (lambda + 2 * mu) * h / J, side = lambda * h / J;
                for (label i = 0; i < p.n; ++i)
                {
                    CHECK(p.stress[0][i] == doctest::Approx(axial).epsilon(1e-11));
                    CHECK(p.stress[1][i] == doctest::Approx(side).epsilon(1e-11));
                    CHECK(p.stress[2][i] == doctest::Approx(side).epsilon(1e-11));
                }
                pointBlock b(p.block());
                CHECK(
                    law->strainEnergy(b)
                    == doctest::Approx(
                           p.n * (lambda + 2 * mu) * (kirchhoff ? 0.5 * h * h : F * h - F + 1))
                           .epsilon(1e-9));
            }
        }
}

TEST_CASE("linearElastic: simple shear in logarithmic strain")
{
    // F = (1 g; 0 1): h has principal values +-asinh(g/2), so
    // |tau_dev| = 2 mu sqrt(2) asinh(g/2), trace 0
    const auto law(elastic(0.25));
    const scalar mu = E / 2.5;
    for (int D = 2; D <= 3; ++D)
    {
        for (const scalar g : {1e-4, 0.1, 1.0, 4.0})
        {
            points p(D, 9, 2700);
            std::vector<scalar> L(9, 0);
            const int n = g > 0.5 ? 10 : 1;
            L[1] = g / n;
            for (int i = 0; i < n; ++i)
                p.apply(*law, L);
            const std::vector<scalar> inv(p.invariants(3));
            const scalar expected = std::sqrt(8.0) * mu * std::asinh(g / 2);
            CHECK(std::sqrt(inv[1]) == doctest::Approx(expected).epsilon(1e-9));
            CHECK(std::abs(inv[0]) <= 1e-9 * expected);
        }
    }
}

TEST_CASE("linearElastic: invariants under 1e5 exact incremental rotations")
{
    const auto law(elastic(0.3));
    for (int D = 2; D <= 3; ++D)
    {
        points p(D, 5, 2700);
        std::vector<scalar> L(9, 0);
        L[0] = 0.01;
        L[1] = 0.004;
        L[D] = -0.002;
        L[D + 1] = -0.006;
        if (D == 3)
        {
            L[2] = 0.003;
            L[8] = 0.002;
        }
        p.apply(*law, L);
        const std::vector<scalar> before(p.invariants(0));

        // exp(dt W) of a skew W is a rotation by |w|
        std::fill(L.begin(), L.end(), 0);
        L[1] = -0.0123;
        L[D] = 0.0123;
        if (D == 3)
        {
            L[2] = 0.007;
            L[6] = -0.007;
            L[5] = -0.004;
            L[7] = 0.004;
        }
        for (int i = 0; i < 100000; ++i)
            p.apply(*law, L);

        const std::vector<scalar> after(p.invariants(0));
        const scalar size = std::sqrt(before[1]);
        for (label i = 0; i < p.n; ++i)
        {
            CHECK(std::abs(after[0] - before[0]) <= 1e-10 * size);
            CHECK(std::abs(after[1] - before[1]) <= 1e-10 * size * size);
            CHECK(std::abs(after[2] - before[2]) <= 1e-10 * size * size * size);
        }
        CHECK(p.volume[0] == doctest::Approx(std::exp(D == 3 ? 0.006 : 0.004)).epsilon(1e-12));
    }
}

TEST_CASE("linearElastic: superposed rotation turns the stress")
{
    // Stretch then quarter turn about z: xx and yy change places
    const auto law(elastic(0.2));
    points p(3, 8, 2700);
    std::vector<scalar> L(9, 0);
    L[0] = 0.02;
    L[4] = -0.01;
    p.apply(*law, L);
    const scalar xx = p.stress[0][0], yy = p.stress[1][0];
    std::fill(L.begin(), L.end(), 0);
    const scalar angle = 2 * std::atan(1.0) / 50;
    L[1] = -angle;
    L[3] = angle;
    for (int i = 0; i < 50; ++i)
        p.apply(*law, L);
    CHECK(p.stress[0][0] == doctest::Approx(yy).epsilon(1e-12));
    CHECK(p.stress[1][0] == doctest::Approx(xx).epsilon(1e-12));
    CHECK(std::abs(p.stress[3][0]) <= 1e-11 * std::abs(xx));
}

TEST_CASE("linearElastic: initial stress gives the strain that carries it")
{
    const auto law(elastic(0.3));
    for (int D = 1; D <= 3; ++D)
    {
        points p(D, 7, 2700);
        const scalar nu = 0.3;
        const scalar lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), mu = E / (2 * (1 + nu));
        // A stress that plane strain can have
        const scalar hx = 1e-3;
        for (label i = 0; i < p.n; ++i)
        {
            p.stress[0][i] = (lambda + 2 * mu) * hx;
            p.stress[1][i] = p.stress[2][i] = lambda * hx;
        }
        pointBlock b(p.block());
        law->initialise(b);
        const std::vector<scalar> before(p.invariants(2));
        p.apply(*law, std::vector<scalar>(9, 0));
        const std::vector<scalar> after(p.invariants(2));
        CHECK(after[0] == doctest::Approx(before[0]).epsilon(1e-12));
        CHECK(after[1] == doctest::Approx(before[1]).epsilon(1e-12));
    }
}

TEST_CASE("neoHookean: uniaxial strain against the closed form")
{
    for (const scalar nu : {0.0, 0.3, -0.4})
        for (int D = 1; D <= 3; ++D)
        {
            const neo m(nu);
            CHECK(
                m.law->waveSpeed()
                == doctest::Approx(std::sqrt((m.lambda + 2 * m.mu) / 2700)).epsilon(1e-13));
            for (const scalar F : {0.2, 0.5, 0.7, 0.999, 1.001, 1.3, 2.0, 4.0})
            {
                points p(D, 11, 2700);
                std::vector<scalar> L(9, 0);
                L[0] = std::log(F) / 5;
                for (int i = 0; i < 5; ++i)
                    p.apply(*m.law, L);

                const scalar side = m.lambda * std::log(F) / F;
                const scalar axial = side + m.mu * (F - 1 / F);
                for (label i = 0; i < p.n; ++i)
                {
                    CHECK(p.stress[0][i] == doctest::Approx(axial).epsilon(1e-11));
                    CHECK(p.stress[1][i] == doctest::Approx(side).epsilon(1e-11));
                    CHECK(p.stress[2][i] == doctest::Approx(side).epsilon(1e-11));
                }
                const scalar W = 0.5 * m.mu * (F * F - 1) - m.mu * std::log(F)
                    + 0.5 * m.lambda * sqr(std::log(F));
                CHECK(m.law->strainEnergy(p.block()) == doctest::Approx(p.n * W).epsilon(1e-9));
            }
        }
}

TEST_CASE("neoHookean: simple shear")
{
    // F = (1 g; 0 1): sigma = mu (g^2 g; g 0), W = mu g^2/2
    const neo m(0.25);
    for (int D = 2; D <= 3; ++D)
    {
        for (const scalar g : {1e-4, 0.1, 1.0, 4.0})
        {
            points p(D, 9, 2700);
            std::vector<scalar> L(9, 0);
            L[1] = g / 10;
            for (int i = 0; i < 10; ++i)
                p.apply(*m.law, L);
            for (label i = 0; i < p.n; ++i)
            {
                const scalar xx = p.stress[0][i], yy = p.stress[1][i];
                CHECK(p.stress[3][i] == doctest::Approx(m.mu * g).epsilon(1e-12));
                CHECK(xx - yy == doctest::Approx(m.mu * g * g).epsilon(1e-10));
                CHECK(std::abs(yy) <= 1e-13 * m.mu * (1 + g * g));
                CHECK(std::abs(p.stress[2][i]) <= 1e-13 * m.mu);
            }
            CHECK(
                m.law->strainEnergy(p.block())
                == doctest::Approx(p.n * 0.5 * m.mu * g * g).epsilon(1e-8));
        }
    }
}

TEST_CASE("neoHookean: invariants under 1e5 exact incremental rotations")
{
    const neo m(0.3);
    for (int D = 2; D <= 3; ++D)
    {
        points p(D, 5, 2700);
        std::vector<scalar> L(9, 0);
        L[0] = 0.3;
        L[1] = 0.1;
        L[D] = -0.05;
        L[D + 1] = -0.2;
        if (D == 3)
        {
            L[2] = 0.08;
            L[8] = 0.1;
        }
        p.apply(*m.law, L);
        const std::vector<scalar> before(p.invariants(0));

        std::fill(L.begin(), L.end(), 0);
        L[1] = -0.0123;
        L[D] = 0.0123;
        if (D == 3)
        {
            L[2] = 0.007;
            L[6] = -0.007;
            L[5] = -0.004;
            L[7] = 0.004;
        }
        for (int i = 0; i < 100000; ++i)
            p.apply(*m.law, L);

        const scalar size = std::sqrt(before[1]);
        for (label i = 0; i < p.n; ++i)
        {
            const std::vector<scalar> after(p.invariants(i));
            CHECK(std::abs(after[0] - before[0]) <= 1e-10 * size);
            CHECK(std::abs(after[1] - before[1]) <= 1e-10 * size * size);
            CHECK(std::abs(after[2] - before[2]) <= 1e-10 * size * size * size);
        }
    }
}

TEST_CASE("neoHookean: superposed rotation turns the stress")
{
    // Stretch then quarter turn about z: xx and yy change places
    const neo m(0.2);
    for (int D = 2; D <= 3; ++D)
    {
        points p(D, 9, 2700);
        std::vector<scalar> L(9, 0);
        L[0] = 0.4;
        L[D + 1] = -0.3;
        p.apply(*m.law, L);
        const scalar xx = p.stress[0][0], yy = p.stress[1][0];
        const scalar zz = p.stress[2][0];
        std::fill(L.begin(), L.end(), 0);
        const scalar angle = 2 * std::atan(1.0) / 50;
        L[1] = -angle;
        L[D] = angle;
        for (int i = 0; i < 50; ++i)
            p.apply(*m.law, L);
        CHECK(p.stress[0][8] == doctest::Approx(yy).epsilon(1e-12));
        CHECK(p.stress[1][8] == doctest::Approx(xx).epsilon(1e-12));
        CHECK(p.stress[2][8] == doctest::Approx(zz).epsilon(1e-12));
        CHECK(std::abs(p.stress[3][8]) <= 1e-12 * std::abs(xx));
    }
}

TEST_CASE("neoHookean: stored energy is the work of a non-proportional path")
{
    // Shear, then stretch with spin, then back in another order: trapezoidal
    // sum of V sigma : dt L
    const neo m(0.3);
    for (int D = 2; D <= 3; ++D)
    {
        points p(D, 3, 2700);
        const int n = 4000;
        scalar work = 0, wMax = 0;
        const auto power = [&](const std::vector<scalar>& L)
        {
            scalar s = 0;
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j)
                {
                    s += p.stress[symmSlot(i, j)][1] * L[i * D + j];
                }
            }
            return s * p.volume[1];
        };
        for (int leg = 0; leg < 3; ++leg)
        {
            std::vector<scalar> L(9, 0);
            if (leg == 0)
            {
                L[1] = 0.8;
                if (D == 3)
                    L[5] = -0.3;
            }
            else if (leg == 1)
            {
                L[0] = 0.5;
                L[D + 1] = -0.7;
                L[1] = 0.4;
                L[D] = -0.4;
                if (D == 3)
                {
                    L[8] = 0.4;
                }
            }
            else
            {
                L[0] = 0.1;
                L[D] = -0.9;
            }
            for (scalar& l : L)
                l /= n;
            for (int i = 0; i < n; ++i)
            {
                work += 0.5 * power(L);
                p.apply(*m.law, L);
                work += 0.5 * power(L);
            }
            wMax = max(wMax, work);
            const scalar W = m.law->strainEnergy(p.block()) / p.n;
            CHECK(W > 0);
            CHECK(std::abs(W - work) <= 1e-6 * W);
        }
        CHECK(wMax > 0.1 * m.mu);
    }
}

TEST_CASE("neoHookean: small strain is linear elasticity to first order")
{
    // The difference falls as the square of the strain, the energy's as the
    // cube
    const neo m(0.3);
    const auto linear(elastic(0.3));
    for (int D = 1; D <= 3; ++D)
    {
        for (const scalar size : {1e-3, 1e-5, 1e-7})
        {
            points a(D, 13, 2700), b(D, 13, 2700);
            std::vector<scalar> L(9, 0);
            const scalar all[9] = {0.7, 0.9, -0.2, 0.1, -0.5, 0.4, 0.3, -0.6, 0.8};
            for (int i = 0; i < D * D; ++i)
                L[i] = size * all[i];
            a.apply(*m.law, L);
            b.apply(*linear, L);
            for (label p = 0; p < a.n; ++p)
            {
                for (int i = 0; i < nStress(D); ++i)
                {
                    CHECK(
                        std::abs(a.stress[i][p] - b.stress[i][p]) <= E * (5 * size * size + 1e-15));
                }
                CHECK(std::abs(a.stress[0][p]) >= 0.5 * E * size);
            }
            const scalar W = linear->strainEnergy(b.block());
            CHECK(std::abs(m.law->strainEnergy(a.block()) - W) <= W * (5 * size + 1e-8));
        }
    }
}

TEST_CASE("neoHookean: points of a block do not see each other")
{
    // Volumes from J = 1/5 to 5 in one block leave the logarithm's series
    const neo m(0.3);
    for (int D = 1; D <= 3; ++D)
    {
        points all(D, 19, 2700);
        for (label i = 0; i < all.n; ++i)
        {
            const scalar h = std::log(5.0) * (i - 9) / 9;
            all.dL[0][i] = h;
            if (D > 1)
                all.dL[1][i] = 0.1 * i;
            all.volume[i] = std::exp(h);
        }
        pointBlock b(all.block());
        m.law->correct(b);

        for (label i = 0; i < all.n; ++i)
        {
            points one(D, 1, 2700);
            for (int k = 0; k < D * D; ++k)
                one.dL[k][0] = all.dL[k][i];
            one.volume[0] = all.volume[i];
            pointBlock b1(one.block());
            m.law->correct(b1);
            for (int k = 0; k < nStress(D); ++k)
            {
                CHECK(std::abs(one.stress[k][0] - all.stress[k][i]) <= 1e-13 * E);
            }
            for (int k = 0; k < nStress(D); ++k)
            {
                CHECK(
                    std::abs(one.history[k][0] - all.history[k][i])
                    <= 1e-13 * (1 + std::abs(one.history[k][0])));
            }
        }
    }
}

TEST_CASE("neoHookean: initial stress gives the left stretch that carries it")
{
    const neo m(0.3);
    for (int D = 1; D <= 3; ++D)
    {
        for (const scalar J : {1.0, 0.9, 1.2})
        {
            points p(D, 11, 2700);
            const scalar across = m.lambda * std::log(J) / J;
            for (label i = 0; i < p.n; ++i)
            {
                p.volume[i] = J;
                for (int k = 0; k < 3; ++k)
                    p.stress[k][i] = across;
                for (int k = 0; k < D; ++k)
                    p.stress[k][i] = (k - 0.5) * 1e9 - 1e8 * i;
                for (int k = 3; k < nStress(D); ++k)
                    p.stress[k][i] = 2e8 * k;
            }
            const std::vector<std::vector<scalar>> before(p.stress);
            pointBlock b(p.block());
            m.law->initialise(b);
            p.apply(*m.law, std::vector<scalar>(9, 0));
            for (int k = 0; k < nStress(D); ++k)
            {
                for (label i = 0; i < p.n; ++i)
                {
                    CHECK(std::abs(p.stress[k][i] - before[k][i]) <= 1e-14 * E);
                }
            }
            CHECK(m.law->strainEnergy(b) > 0);
        }

        // Pressure above mu: no left stretch can carry it
        points p(D, 2, 2700);
        for (int k = 0; k < D; ++k)
            p.stress[k][1] = -1.01 * m.mu;
        pointBlock b(p.block());
        CHECK_THROWS_AS(m.law->initialise(b), Foam::error);
        for (int k = 0; k < D; ++k)
            p.stress[k][1] = -0.99 * m.mu;
        CHECK_NOTHROW(m.law->initialise(b));
    }
}

TEST_CASE("input errors of laws name what is valid")
{
    const auto from = [](const char* s)
    {
        IStringStream is(s);
        return constitutiveModel::New(dictionary(is));
    };
    CHECK_THROWS_AS(from("type linearElasticc; rho 1; E 1; nu 0;"), Foam::IOerror);
    CHECK_THROWS_AS(from("type linearElastic; rho -1; E 1; nu 0;"), Foam::IOerror);
    CHECK_THROWS_AS(from("type linearElastic; rho 1; E 1; nu 0.5;"), Foam::IOerror);
    CHECK_THROWS_AS(from("type linearElastic; rho 1; E 1;"), Foam::IOerror);
    CHECK_THROWS_AS(from("type linearElastic; rho 1; E 1; nu 0; foo 1;"), Foam::IOerror);
    CHECK_NOTHROW(from("type neoHookean; rho 1; E 1; nu 0.3;"));
    CHECK_THROWS_AS(from("type neoHookean; rho 1; E -1; nu 0;"), Foam::IOerror);
    CHECK_THROWS_AS(from("type neoHookean; rho 1; E 1; nu 0.5;"), Foam::IOerror);
    CHECK_THROWS_AS(from("type neoHookean; rho 1; E 1;"), Foam::IOerror);
    CHECK_THROWS_AS(from("type neoHookean; rho 1; E 1; nu 0; stress Cauchy;"), Foam::IOerror);
}
