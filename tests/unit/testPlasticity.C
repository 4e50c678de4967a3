// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testPoints.H"
#include "failureModel.H"
#include "IFstream.H"
#include <cstdlib>

TEST_CASE("J2Plasticity: uniaxial strain against the closed form")
{
    // sigma_eq = 2 G |h| - 3 G eps = Y(eps) once 2 G |h| > Y: proportional, so
    // exact for any number of steps. p = K (exp(-h) - 1)
    struct
    {
        std::string text;
        scalar H, B, n;
    } kinds[] = {
        {"hardening none;", 0, 0, 1},
        {"hardening linear; H 500e6;", 500e6, 0, 1},
        {"hardening power; B 292e6; n 0.31;", 0, 292e6, 0.31}};
    for (const auto& kind : kinds)
        for (int D = 1; D <= 3; ++D)
            for (const scalar h : {1e-3, 0.01, -0.03, 0.3, -0.6})
            {
                const auto law(lawOf(J2(kind.text)));
                points p(D, 11, 8960);
                std::vector<scalar> L(9, 0);
                L[0] = h;
                walk(p, *law, L, 7);

                const auto Y = [&](const scalar e)
                { return 100e6 + kind.H * e + kind.B * std::pow(e, kind.n); };
                const scalar q0 = 2 * G * std::abs(h);
                const scalar eps = q0 > 100e6
                    ? root([&](scalar e) { return q0 - 3 * G * e - Y(e); }, 0, q0 / (3 * G))
                    : 0;
                const scalar q = q0 - 3 * G * eps, sign = h > 0 ? 1 : -1;
                const scalar mean = -K * (std::exp(-h) - 1);
                const scalar size = std::abs(mean) + q;
                for (label i = 0; i < p.n; ++i)
                {
                    CHECK(std::abs(p.stress[0][i] - mean - sign * 2.0 / 3 * q) <= 1e-10 * size);
                    CHECK(std::abs(p.stress[1][i] - mean + sign * q / 3) <= 1e-10 * size);
                    CHECK(std::abs(p.stress[2][i] - mean + sign * q / 3) <= 1e-10 * size);
                    CHECK(p.history[nStress(D)][i] == doctest::Approx(eps).epsilon(1e-9));
                }
            }
}

TEST_CASE("J2Plasticity: small strain is linear elasticity, stored energy too")
{
    const auto law(lawOf(J2("hardening none;")));
    const scalar E = 9 * K * G / (3 * K + G), nu = (3 * K - 2 * G) / (2 * (3 * K + G));
    const auto linear(lawOf(
        "type linearElastic; rho 8960; E " + std::to_string(E) + "; nu " + std::to_string(nu)
        + ";"));
    CHECK(law->waveSpeed() == doctest::Approx(linear->waveSpeed()).epsilon(1e-5));
    CHECK(law->elasticModulus() == doctest::Approx(E).epsilon(1e-12));
    const std::vector<scalar> all({0.7, 0.9, -0.2, 0.1, -0.5, 0.4, 0.3, -0.6, 0.8});
    for (int D = 1; D <= 3; ++D)
    {
        points a(D, 9, 8960), b(D, 9, 8960);
        std::vector<scalar> L(9, 0);
        for (int i = 0; i < D * D; ++i)
            L[i] = 3e-4 * all[i];
        a.apply(*law, L);
        b.apply(*linear, L);
        for (int i = 0; i < nStress(D); ++i)
        {
            CHECK(std::abs(a.stress[i][8] - b.stress[i][8]) <= 1e-3 * E * 3e-4);
        }
        CHECK(
            law->strainEnergy(a.block())
            == doctest::Approx(linear->strainEnergy(b.block())).epsilon(2e-3));
    }
}

TEST_CASE("JohnsonCook: the stress is on the surface of the published formula")
{
    const auto law(lawOf("type JohnsonCook; K 129e9; C 0.025; m 1.09; beta 0.9; " + copper));
    for (int D = 2; D <= 3; ++D)
        for (const scalar rate : {1e-3, 10.0, 1e4, 1e6})
        {
            points p(D, 5, 8960);
            p.dt = 0.01 / rate;
            law->start(*std::make_unique<pointBlock>(p.block()));
            std::vector<scalar> L(9, 0);
            L[0] = 0.01;
            L[D + 1] = -0.01;
            for (int i = 0; i < 30; ++i)
            {
                const scalar e0 = p.history[nStress(D)][1];
                const scalar T0 = p.history[nStress(D) + 1][1];
                p.apply(*law, L);
                const scalar e = p.history[nStress(D)][1];
                const scalar fast = max((e - e0) / p.dt, 1.0);
                const scalar Y = (90e6 + 292e6 * std::pow(e, 0.31)) * (1 + 0.025 * std::log(fast))
                    * (1 - std::pow((T0 - 294) / (1356 - 294), 1.09));
                CHECK(mises(p, 1) == doctest::Approx(Y).epsilon(1e-10));
            }
            CHECK(p.history[nStress(D)][1] > 0.3);
            CHECK(p.history[nStress(D) + 1][1] > 310);
        }
}

TEST_CASE("JohnsonCook: adiabatic heating against the closed form")
{
    // C = 0, m = 1: with t = (T - T0)/(Tm - T0), dt/deps = a (A + B eps^n)(1 - t),
    // so t = 1 - exp(-a (A eps + B eps^(n+1)/(n+1)))
    const auto law(lawOf("type JohnsonCook; K 129e9; C 0; m 1; beta 0.9; " + copper));
    scalar last = 0;
    for (const int n : {500, 2000})
    {
        points p(3, 1, 8960);
        law->start(*std::make_unique<pointBlock>(p.block()));
        std::vector<scalar> L(9, 0);
        L[0] = 3;
        L[4] = -3;
        walk(p, *law, L, n);
        const scalar e = p.history[6][0];
        const scalar a = 0.9 / (8960 * 383 * (1356 - 294.0));
        const scalar t = 1 - std::exp(-a * (90e6 * e + 292e6 * std::pow(e, 1.31) / 1.31));
        const scalar error = (p.history[7][0] - 294) / (1356 - 294) - t;
        CHECK(std::abs(error) < (n == 500 ? 0.004 : 0.001) * t);
        if (n == 2000)
            CHECK(std::abs(error) < 0.3 * std::abs(last));
        last = error;
    }

    // beta 0: no heat
    const auto cold(lawOf("type JohnsonCook; K 129e9; C 0; m 1; beta 0; " + copper));
    points p(3, 1, 8960);
    cold->start(*std::make_unique<pointBlock>(p.block()));
    std::vector<scalar> L(9, 0);
    L[0] = 1;
    L[4] = -1;
    walk(p, *cold, L, 10);
    CHECK(p.history[7][0] == 294);
}

TEST_CASE("JohnsonCook: molten metal has pressure alone")
{
    const auto law(lawOf(
        "type JohnsonCook; K 129e9; C 0.025; m 1.09; beta 0.9;"
        " initialTemperature 1400; "
        + copper));
    points p(3, 9, 8960);
    law->start(*std::make_unique<pointBlock>(p.block()));
    std::vector<scalar> L(9, 0);
    L[0] = -0.1;
    L[1] = 0.2;
    p.apply(*law, L);
    for (label i = 0; i < p.n; ++i)
    {
        CHECK(mises(p, i) <= 1e-7 * K);
        CHECK(meanStress(p, i) == doctest::Approx(-K * (std::exp(0.1) - 1)).epsilon(1e-10));
    }
}

TEST_CASE("internal energy: second order, and equal to the work of the stress")
{
    // Compression with shear; the fine walk is the reference, and the energy is
    // the sum of the stress power
    const auto law(lawOf(
        "type JohnsonCook; C 0; m 1.09; beta 0.9; " + copper
        + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }"));
    std::vector<scalar> L(9, 0);
    L[0] = -0.25;
    L[1] = 0.05;
    L[4] = 0.02;
    const auto energy = [&](const int n)
    {
        points p(3, 1, 8960);
        law->start(*std::make_unique<pointBlock>(p.block()));
        scalar work = 0;
        for (int i = 0; i < n; ++i)
        {
            const auto power = [&]()
            {
                return p.volume[0] / 8960 / n
                    * (p.stress[0][0] * L[0] + p.stress[3][0] * L[1] + p.stress[1][0] * L[4]);
            };
            std::vector<scalar> dL(L);
            for (scalar& l : dL)
                l /= n;
            work += 0.5 * power();
            p.apply(*law, dL);
            work += 0.5 * power();
        }
        CHECK(p.history[8][0] == doctest::Approx(work).epsilon(0.2 / n / n + 2e-4 / n));
        return p.history[8][0];
    };
    const scalar exact = energy(6400);
    const scalar coarse = std::abs(energy(50) - exact);
    const scalar fine = std::abs(energy(100) - exact);
    CHECK(coarse < 1e-3 * exact);
    CHECK(fine < 0.35 * coarse);
}

TEST_CASE("etc/materials: the files are laws with the published constants")
{
    // A, B, n, C, m; rho, cp, Tm, G; C0, S, Gamma0 of Uintah's MaterialData;
    // D1 to D5, 0 without
    struct
    {
        const char* name;
        scalar jc[5], other[4], shock[3], damage[5];
    } materials[] = {
        {"copperOFHC",
         {90e6, 292e6, 0.31, 0.025, 1.09},
         {8960, 383, 1356, 46e9},
         {3940, 1.489, 2.02},
         {0.54, 4.89, -3.03, 0.014, 1.12}},
        {"ironArmco",
         {175e6, 380e6, 0.32, 0.06, 1.44},
         {7890, 452, 1811, 80e9},
         {3574, 1.92, 1.69},
         {-2.20, 5.43, -0.47, 0.016, 0.63}},
        {"steel4340",
         {792e6, 510e6, 0.26, 0.014, 1.03},
         {7830, 477, 1793, 77e9},
         {3574, 1.92, 1.69},
         {0.05, 3.44, -2.12, 0.002, 0.61}},
        {"aluminium6061T6",
         {324e6, 114e6, 0.42, 0.002, 1.34},
         {2700, 896, 925, 26e9},
         {5386, 1.339, 1.99},
         {-0.77, 1.45, -0.47, 0, 1.60}},
        {"steelHzB",
         {1500e6, 569e6, 0.22, 0.003, 1.17},
         {7850, 477, 1793, 77.8e9},
         {3574, 1.92, 1.69},
         {0, 0, 0, 0, 0}},
        {"tungstenAlloy",
         {1506.96e6, 176.64e6, 0.12, 0.016, 1},
         {17000, 134, 3695, 124e9},
         {3980, 1.24, 1.54},
         {0, 0, 0, 0, 0}}};
    const std::string folder(std::string(std::getenv("MPM_PROJECT_DIR")) + "/etc/materials/");
    for (const auto& m : materials)
    {
        IFstream is(folder + m.name);
        const dictionary dict(is);
        const auto law(constitutiveModel::New(dict));
        const char* jc[] = {"A", "B", "n", "C", "m"};
        for (int i = 0; i < 5; ++i)
            CHECK(dict.get<scalar>(jc[i]) == m.jc[i]);
        const char* other[] = {"rho", "cp", "meltTemperature", "G"};
        for (int i = 0; i < 4; ++i)
            CHECK(dict.get<scalar>(other[i]) == m.other[i]);
        const char* shock[] = {"C0", "S", "Gamma0"};
        for (int i = 0; i < 3; ++i)
        {
            CHECK(dict.subDict("equationOfState").get<scalar>(shock[i]) == m.shock[i]);
        }
        CHECK(
            law->waveSpeed()
            == doctest::Approx(std::sqrt(sqr(m.shock[0]) + 4.0 / 3 * m.other[3] / m.other[0]))
                   .epsilon(1e-10));
        if (m.damage[1] != 0)
        {
            IFstream damage(folder + m.name + "Damage");
            const dictionary d(damage);
            CHECK_NOTHROW(failureModel::New(d));
            for (int i = 0; i < 5; ++i)
            {
                CHECK(d.get<scalar>("D" + std::to_string(i + 1)) == m.damage[i]);
            }
        }
    }
}
