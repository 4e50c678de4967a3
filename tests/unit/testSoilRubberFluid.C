// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testPoints.H"
#include "principalAxes.H"

TEST_CASE("perfectGas as a fluid: isentropic compression, second order")
{
    const auto law(lawOf("type NewtonianFluid; rho 1.2; mu 0;"
                         " equationOfState { type perfectGas; gamma 1.4; p0 1e5; }"));
    scalar last = 0;
    for (const int n : {20, 40})
    {
        points p(3, 9, 1.2);
        law->start(*std::make_unique<pointBlock>(p.block()));
        std::vector<scalar> L(9, 0);
        L[0] = L[4] = L[8] = -0.3;
        walk(p, *law, L, n);
        const scalar exact = 1e5 * std::exp(1.4 * 0.9);
        const scalar error = -p.stress[0][8] / exact - 1;
        CHECK(std::abs(error) < 1e-3);
        if (n == 40)
            CHECK(std::abs(error) < 0.3 * std::abs(last));
        last = error;

        std::fill(p.dL[0].begin(), p.dL[0].end(), 0);
        std::fill(p.dL[4].begin(), p.dL[4].end(), 0);
        std::fill(p.dL[8].begin(), p.dL[8].end(), 0);
        pointBlock b(p.block());
        law->correct(b);
        CHECK(
            b.waveSpeed
            == doctest::Approx(std::sqrt(1.4 * exact / 1.2 * std::exp(-0.9))).epsilon(2e-3));
    }
}

TEST_CASE("vanDerWaals, nobleAbelStiffenedGas, CochranChan as fluids: isentropes")
{
    // (p + a rho^2)(1/rho - b)^gamma, (p + pInf)(1/rho - b)^gamma and
    // (p - p_c)/rho^(1 + Gamma0) stay
    struct fluid
    {
        const char* text;
        scalar rho0, scale;
        scalar (*p)(const scalar);
    };
    for (const fluid& f :
         {fluid{
              "vanDerWaals; gamma 1.4; a 5; b 1e-3; p0 1e5;", 50, 1e5,
              [](const scalar r)
              {
                  const scalar v = (1 / r - 1e-3) / (1 / 50.0 - 1e-3);
                  return (1e5 + 5 * 2500) * std::pow(v, -1.4) - 5 * r * r;
              }},
          fluid{
              "nobleAbelStiffenedGas; gamma 1.19; pInf 7.028e8; b 6.61e-4;"
              " q -1177788; p0 1e5;",
              1050, 7e8,
              [](const scalar r)
              {
                  const scalar v = (1 / r - 6.61e-4) / (1 / 1050.0 - 6.61e-4);
                  return (1e5 + 7.028e8) * std::pow(v, -1.19) - 7.028e8;
              }},
          fluid{
              "CochranChan; A 12.87e9; B 13.42e9; E1 4.1; E2 3.1; Gamma0 0.93;"
              " p0 1e5;",
              1840, 1e10,
              [](const scalar r)
              {
                  const scalar x = r / 1840;
                  return 12.87e9 * std::pow(x, 4.1) - 13.42e9 * std::pow(x, 3.1)
                      + (1e5 + 0.55e9) * std::pow(x, 1.93);
              }}})
    {
        const std::string rho = std::to_string(f.rho0);
        const auto law(lawOf(
            "type NewtonianFluid; rho " + rho
            + "; mu 0;"
              " equationOfState { type "
            + f.text + " }"));
        scalar last = 0;
        for (const int n : {20, 40})
        {
            points p(3, 9, f.rho0);
            law->start(*std::make_unique<pointBlock>(p.block()));
            std::vector<scalar> L(9, 0);
            L[0] = L[4] = L[8] = -0.05;
            walk(p, *law, L, n);
            const scalar error = (-p.stress[0][8] - f.p(f.rho0 * std::exp(0.15))) / f.scale;
            CHECK(std::abs(error) < 1e-3);
            if (n == 40)
                CHECK(std::abs(error) < 0.3 * std::abs(last));
            last = error;
        }
    }
}

TEST_CASE("NewtonianFluid: shear flow, heat, pMin")
{
    const scalar mu = 0.3, rate = 20, dt = 1e-5;
    const auto law(lawOf("type NewtonianFluid; rho 1.2; mu 0.3;"
                         " equationOfState { type perfectGas; gamma 1.4; p0 1e5; }"));
    for (int D = 2; D <= 3; ++D)
    {
        points p(D, 6, 1.2);
        p.dt = dt;
        law->start(*std::make_unique<pointBlock>(p.block()));
        const scalar e0 = p.history[1][0];
        std::vector<scalar> L(9, 0);
        L[1] = rate * dt;
        for (int i = 0; i < 100; ++i)
            p.apply(*law, L);
        CHECK(p.stress[3][5] == doctest::Approx(mu * rate).epsilon(1e-6));
        CHECK(p.stress[0][5] == doctest::Approx(-1e5).epsilon(1e-4));
        CHECK(
            p.history[1][5] - e0
            == doctest::Approx(mu * rate * rate * 100 * dt / 1.2).epsilon(1e-4));
    }

    const auto water(lawOf("type NewtonianFluid; rho 1000; mu 0; K 2e9; pMin 0;"));
    points p(2, 3, 1000);
    std::vector<scalar> L(9, 0);
    L[0] = 0.01;
    p.apply(*water, L);
    CHECK(p.stress[0][1] == 0);
    L[0] = -0.02;
    p.apply(*water, L);
    CHECK(p.stress[0][1] == doctest::Approx(-2e9 * (std::exp(0.01) - 1)).epsilon(1e-12));
}

TEST_CASE("bulk viscosity: pressure, heat, only in compression")
{
    const std::string gas("type NewtonianFluid; rho 1.2; mu 0;"
                          " equationOfState { type perfectGas; gamma 1.4; p0 1e5; } ");
    const auto viscous(lawOf(gas + "bulkViscosity { linear 0.06; quadratic 1.5; }"));
    const auto plain(lawOf(gas));
    CHECK(viscous->needsWidth());
    CHECK(!plain->needsWidth());
    for (const scalar d : {-1e-4, 1e-4})
    {
        points a(1, 3, 1.2), b(1, 3, 1.2);
        a.dt = b.dt = 1e-7;
        std::fill(a.width.begin(), a.width.end(), 0.01);
        viscous->start(*std::make_unique<pointBlock>(a.block()));
        plain->start(*std::make_unique<pointBlock>(b.block()));
        a.apply(*viscous, {d});
        b.apply(*plain, {d});
        const scalar rho = 1.2 * std::exp(-d), l = 0.01, rate = -d / 1e-7;
        const scalar c = std::sqrt(1.4 * 1e5 / 1.2);
        const scalar q = d < 0 ? rho * l * rate * (0.06 * c + 1.5 * l * rate) : 0;
        CHECK(b.stress[0][1] - a.stress[0][1] == doctest::Approx(q).epsilon(1e-3));
        CHECK(
            a.history[1][1] - b.history[1][1]
            == doctest::Approx(q * (1 / 1.2 - 1 / rho)).epsilon(1e-3));
    }
}

TEST_CASE("DruckerPrager: uniaxial strain against the closed form")
{
    // Totals of a proportional path: T = 2 G |h|/sqrt(3), S = K h and
    // g = (T + a S - k)/(G + K a b)
    const scalar E = 20e6, nu = 0.1, Ks = E / (3 * (1 - 2 * nu)), Gs = E / (2 * (1 + nu));
    const scalar sn = 0.5, cs = std::sqrt(0.75), s10 = std::sin(std::atan(1.0) / 4.5);
    for (const int sign : {-1, 1})
        for (int D = 1; D <= 3; ++D)
        {
            const std::string match(sign < 0 ? "outer" : "inner");
            const auto law(
                lawOf("type DruckerPrager; dilationAngle 10; match " + match + ";" + soil));
            const auto slope = [&](const scalar s)
            { return 6 * s / (std::sqrt(3.0) * (3 + sign * s)); };
            const scalar a = slope(sn), b = slope(s10);
            const scalar k = 6 * 10e3 * cs / (std::sqrt(3.0) * (3 + sign * sn));
            const scalar h = -0.02;
            points p(D, 11, 2000);
            std::vector<scalar> L(9, 0);
            L[0] = h;
            walk(p, *law, L, 9);

            const scalar T = 2 * Gs * std::abs(h) / std::sqrt(3.0), S = Ks * h;
            const scalar g = max((T + a * S - k) / (Gs + Ks * a * b), 0.0);
            const scalar t = T - Gs * g, s = S - Ks * b * g;
            for (label i = 0; i < p.n; ++i)
            {
                CHECK(meanStress(p, i) == doctest::Approx(s).epsilon(1e-10));
                CHECK(mises(p, i) == doctest::Approx(std::sqrt(3.0) * t).epsilon(1e-10));
                CHECK(
                    p.history[nStress(D)][i] == doctest::Approx(g / std::sqrt(3.0)).epsilon(1e-9));
            }
            CHECK(g > 0);
        }
}

TEST_CASE("frictional laws: apex and tension cut-off")
{
    // Pulled apart: mean stress stays at c/tan(phi), or at the cut-off
    for (const std::string cut : {"", "tensionCutoff 2e3;"})
        for (const std::string type : {"DruckerPrager; match outer;", "MohrCoulomb;"})
            for (int D = 1; D <= 3; ++D)
            {
                const auto law(lawOf("type " + type + cut + "dilationAngle 30;" + soil));
                points p(D, 9, 2000);
                std::vector<scalar> L(9, 0);
                for (int d = 0; d < D; ++d)
                    L[d * (D + 1)] = 0.02;
                if (D == 1)
                    L[0] = 0.3;
                walk(p, *law, L, 20);
                const scalar limit = cut.empty() ? 10e3 / std::tan(std::atan(1.0) / 1.5) : 2e3;
                if (D == 3)
                {
                    CHECK(meanStress(p, 8) == doctest::Approx(limit).epsilon(1e-9));
                    CHECK(mises(p, 8) <= 1e-9 * limit);
                }
                CHECK(meanStress(p, 8) <= limit * (1 + 1e-9));
            }
}

TEST_CASE("MohrCoulomb: pure shear, triaxial strength, yield on wild paths")
{
    const scalar E = 20e6, nu = 0.1, Ks = E / (3 * (1 - 2 * nu)), Gs = E / (2 * (1 + nu));
    const scalar c = 10e3, sn = 0.5, cs = std::sqrt(0.75);
    const scalar s10 = std::sin(std::atan(1.0) / 4.5);

    // Stretches (e, -e): main plane, g = f/a from the totals
    const auto law(lawOf("type MohrCoulomb; dilationAngle 10;" + soil));
    const scalar e = 2e-3;
    for (int D = 2; D <= 3; ++D)
    {
        points p(D, 9, 2000);
        std::vector<scalar> L(9, 0);
        L[0] = e;
        L[D + 1] = -e;
        walk(p, *law, L, 5);
        const scalar g =
            (4 * Gs * e - 2 * c * cs) / (4 * Gs * (1 + sn * s10 / 3) + 4 * Ks * sn * s10);
        CHECK(g > 0);
        const scalar s1 = 2 * Gs * e - (2 * Gs * (1 + s10 / 3) + 2 * Ks * s10) * g;
        const scalar s3 = -2 * Gs * e + (2 * Gs * (1 - s10 / 3) - 2 * Ks * s10) * g;
        CHECK(p.stress[0][8] == doctest::Approx(s1).epsilon(1e-9));
        CHECK(p.stress[1][8] == doctest::Approx(s3).epsilon(1e-9));
    }

    // Compressed in one direction without dilation: the edge, where
    // sigma_eq = (6 c cos + 6 p sin)/(3 - sin), p elastic; outer cone the same
    const auto pyramid(lawOf("type MohrCoulomb; dilationAngle 0;" + soil));
    const auto cone(lawOf("type DruckerPrager; match outer; dilationAngle 0;" + soil));
    for (const constitutiveModel* m : {&*pyramid, &*cone})
    {
        points p(3, 9, 2000);
        std::vector<scalar> L(9, 0);
        L[4] = -0.02;
        walk(p, *m, L, 6);
        const scalar q = (6 * c * cs + 6 * Ks * 0.02 * sn) / (3 - sn);
        CHECK(meanStress(p, 7) == doctest::Approx(-Ks * 0.02).epsilon(1e-9));
        CHECK(mises(p, 7) == doctest::Approx(q).epsilon(1e-9));
        CHECK(p.stress[1][7] == doctest::Approx(-Ks * 0.02 - 2.0 / 3 * q).epsilon(1e-9));
    }

    // No state outside, whatever the path
    const auto cut(lawOf("type MohrCoulomb; dilationAngle 20; tensionCutoff 5e3;" + soil));
    points p(3, 64, 2000);
    unsigned seed = 7;
    for (int step = 0; step < 30; ++step)
    {
        for (int i = 0; i < 9; ++i)
            for (label k = 0; k < p.n; ++k)
            {
                seed = seed * 1664525u + 1013904223u;
                p.dL[i][k] = 5e-3 * (seed / 4294967296.0 - 0.5);
            }
        pointBlock b(p.block());
        cut->correct(b);
        for (label k = 0; k < p.n; ++k)
        {
            double s[9];
            fullStress(b, k, s);
            const principalAxes<3> axes(s);
            const double least = axes.value[0], largest = axes.value[2];
            const scalar size = max(mag(least), mag(largest)) + c;
            CHECK(largest - least + (largest + least) * sn - 2 * c * cs <= 1e-9 * size);
            CHECK(largest <= 5e3 + 1e-9 * size);
        }
    }
}

TEST_CASE("MooneyRivlin: simple shear and uniaxial strain")
{
    // Rivlin: sigma_xy = 2 (c10 + c01) g, xx - yy = 2 (c10 + c01) g^2,
    // yy - zz = -2 c01 g^2, W = (c10 + c01) g^2
    const scalar c10 = 1e6, c01 = 3e5, Kr = 1e8;
    const auto law(lawOf("type MooneyRivlin; rho 1000; c10 1e6; c01 3e5; K 1e8;"));
    for (int D = 2; D <= 3; ++D)
        for (const scalar g : {1e-3, 0.1, 1.0, 3.0})
        {
            points p(D, 9, 1000);
            std::vector<scalar> L(9, 0);
            L[1] = g;
            walk(p, *law, L, 10);
            const scalar xx = p.stress[0][8], yy = p.stress[1][8], zz = p.stress[2][8];
            const scalar size = c10 * (g + g * g * g * g);
            CHECK(std::abs(p.stress[3][8] - 2 * (c10 + c01) * g) <= 1e-9 * size);
            CHECK(std::abs(xx - yy - 2 * (c10 + c01) * g * g) <= 1e-9 * size);
            CHECK(std::abs(yy - zz + 2 * c01 * g * g) <= 1e-9 * size);
            CHECK(
                law->strainEnergy(p.block()) / 9
                == doctest::Approx((c10 + c01) * g * g).epsilon(1e-6));
        }
    for (int D = 1; D <= 3; ++D)
        for (const scalar F : {0.5, 0.9, 1.1, 2.0})
        {
            points p(D, 9, 1000);
            std::vector<scalar> L(9, 0);
            L[0] = std::log(F);
            walk(p, *law, L, 5);
            const scalar r = std::pow(F, -2.0 / 3), b1 = r * F * F, b2 = r;
            const scalar t1 = c10 * b1 + c01 * b1 * 2 * b2, t2 = c10 * b2 + c01 * b2 * (b1 + b2);
            const scalar mean = (t1 + 2 * t2) / 3;
            CHECK(
                p.stress[0][8]
                == doctest::Approx((2 * (t1 - mean) + Kr * std::log(F)) / F).epsilon(1e-10));
            CHECK(
                p.stress[2][8]
                == doctest::Approx((2 * (t2 - mean) + Kr * std::log(F)) / F).epsilon(1e-10));
        }
    CHECK(
        law->waveSpeed()
        == doctest::Approx(std::sqrt((Kr + 4.0 / 3 * 2.6e6) / 1000)).epsilon(1e-12));
}
