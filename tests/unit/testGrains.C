// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testPoints.H"

namespace
{

// grains() of testPoints.H
const scalar Kg = 1e8 / (3 * (1 - 0.4)), Gg = 1e8 / 2.4, rhoS = 2500, d = 1e-3;

scalar friction(const scalar I) { return 0.383 + (0.643 - 0.383) / (1 + 0.279 / I); }

//- sqrt(J2) of a point
scalar shear(const points& p, const label i) { return mises(p, i) / std::sqrt(3.0); }

//- Points in all directions under a pressure, without shear
points pressed(const int D, const scalar pressure, const constitutiveModel& law)
{
    points p(D, 7, law.rho());
    for (int k = 0; k < 3; ++k)
        std::fill(p.stress[k].begin(), p.stress[k].end(), -pressure);
    pointBlock b(p.block());
    law.initialise(b);
    return p;
}

}

TEST_CASE("muI: steady simple shear has tau = mu(I) p and dissipates tau times the rate")
{
    const scalar pressure = 1e3;
    for (const scalar I : {1e-4, 1e-2, 0.1, 0.5, 5.0})
        for (const bool viscous : {false, true})
            for (int D = 2; D <= 3; ++D)
            {
                // eta of the liquid: that Iv at 1 1/s; grains' stress is that of m/rho
                const scalar eta = I * 0.6 * pressure;
                const auto law(
                    lawOf(grains(viscous ? "viscosity " + std::to_string(eta) + ";" : "")));
                const scalar rate = viscous ? 1 : I * std::sqrt(pressure / rhoS) / d;
                points p(pressed(D, pressure, *law));
                p.dt = 1e-5 / rate;
                std::vector<scalar> L(9, 0);
                L[1] = 1e-5;
                for (int i = 0; i < 300; ++i)
                    p.apply(*law, L);
                const scalar tau = friction(I) * pressure;
                CHECK(p.stress[3][6] == doctest::Approx(tau).epsilon(1e-4));
                CHECK(-meanStress(p, 6) == doctest::Approx(pressure).epsilon(1e-6));

                std::vector<scalar> lost(p.n, 0);
                const scalar before = law->strainEnergy(p.block());
                pointBlock b(p.block());
                b.dissipated = lost.data();
                law->correct(b);
                CHECK(lost[6] == doctest::Approx(tau * 1e-5).epsilon(1e-4));
                CHECK(mag(law->strainEnergy(p.block()) - before) < 1e-4 * 7 * tau * 1e-5);
            }
}

TEST_CASE("muI: one step of any size ends on the yield surface of its own rate")
{
    const auto law(lawOf(grains("")));
    const scalar pressure = 1e3;
    for (const scalar e : {1e-6, 5e-6, 1e-5, 1e-3, 1e-1})
        for (const scalar dt : {1e-8, 1e-5, 1e-2})
        {
            points p(pressed(3, pressure, *law));
            p.dt = dt;
            std::vector<scalar> L(9, 0);
            L[0] = e;
            L[4] = -e;
            p.apply(*law, L);
            const scalar trial = 2 * Gg * e, t = shear(p, 3), g = (trial - t) / Gg;
            if (trial <= 0.383 * pressure)
            {
                CHECK(t == doctest::Approx(trial).epsilon(1e-9));
                continue;
            }
            const scalar I = d * g / dt / std::sqrt(pressure / rhoS);
            CHECK(t == doctest::Approx(friction(I) * pressure).epsilon(1e-7));
            CHECK(p.history[6][3] == doctest::Approx(g / std::sqrt(3.0)).epsilon(1e-7));
        }
}

TEST_CASE("muI: grains do not pull and remember how far they have parted")
{
    for (const std::string more : {"", "dilatancy { phiC 0.58; K2 0.2; K3 0; }"})
        for (int D = 1; D <= 3; ++D)
        {
            const auto law(lawOf(grains(more)));
            const int open = law->columnOf("openStrain", D);
            points p(pressed(D, 1e5, *law));
            std::vector<scalar> L(9, 0);
            const auto stretch = [&](const scalar volume)
            {
                for (int k = 0; k < D; ++k)
                    L[k * (D + 1)] = volume / D;
                walk(p, *law, L, 5);
            };
            const scalar first = 1e5 / Kg;
            stretch(0.02);
            CHECK(p.invariants(2)[1] == 0);
            CHECK(p.history[open][2] == doctest::Approx(0.02 - first).epsilon(1e-9));
            stretch(-0.015);
            CHECK(p.invariants(2)[1] == 0);
            CHECK(p.history[open][2] == doctest::Approx(0.005 - first).epsilon(1e-9));
            stretch(-0.007);
            CHECK(p.history[open][2] == 0);
            CHECK(-meanStress(p, 2) == doctest::Approx(Kg * (0.002 + first)).epsilon(1e-9));
        }
}

TEST_CASE("muI, dilatancy at constant volume: dense gains pressure, loose loses it")
{
    // Slow: dp = K b dg with b = K3 (phi - phiC), t = (muS + b) p, g that of the flow
    const auto law(lawOf(grains("dilatancy { phiC 0.58; K2 0; K3 4; }")));
    for (const scalar phi : {0.605, 0.545})
    {
        const scalar b = 4 * (phi - 0.58), pressure = 1e4;
        points p(pressed(3, pressure, *law));
        std::fill(p.volume.begin(), p.volume.end(), 0.6 / phi);
        p.dt = 1e3;
        std::vector<scalar> L(9, 0);
        const scalar strain = 8e-4;
        L[1] = strain / 500;
        const scalar v = p.volume[0];
        for (int i = 0; i < 500; ++i)
            p.apply(*law, L);
        CHECK(p.volume[0] == v);
        const scalar g = strain - p.stress[3][1] / Gg, exact = pressure + Kg * b * g;
        CHECK(std::abs(exact / pressure - 1) > 0.3);
        CHECK(-meanStress(p, 1) == doctest::Approx(exact).epsilon(2e-3));
        CHECK(p.stress[3][1] == doctest::Approx((0.383 + b) * exact).epsilon(2e-3));
    }

    // Loose and sheared on: no effective stress is left
    points p(pressed(3, 1e4, *law));
    std::fill(p.volume.begin(), p.volume.end(), 0.6 / 0.545);
    p.dt = 1e3;
    std::vector<scalar> L(9, 0);
    L[1] = 1e-5;
    for (int i = 0; i < 1000; ++i)
        p.apply(*law, L);
    CHECK(-meanStress(p, 1) >= 0);
    CHECK(-meanStress(p, 1) < 1e-4 * 1e4);
    CHECK(shear(p, 1) < 1e-4 * 1e4);
}

TEST_CASE("muI, dilatancy: steady flow of loose grains carries itself (Bagnold)")
{
    // phi = phiEq(I): p = rhoS (d g K2/(phiC - phi))^2, t = mu(I) p
    const scalar phi = 0.56, I = (0.58 - phi) / 0.2;
    const auto law(lawOf(grains("dilatancy { phiC 0.58; K2 0.2; K3 4; }")));
    for (const scalar start : {3e2, 3e3})
    {
        points p(pressed(3, start, *law));
        std::fill(p.volume.begin(), p.volume.end(), 0.6 / phi);
        const scalar pressure = 1e3, rate = I * std::sqrt(pressure / rhoS) / d;
        p.dt = 1e-5 / rate;
        std::vector<scalar> L(9, 0);
        L[1] = 1e-5;
        for (int i = 0; i < 2000; ++i)
            p.apply(*law, L);
        CHECK(-meanStress(p, 5) == doctest::Approx(pressure).epsilon(1e-3));
        CHECK(p.stress[3][5] == doctest::Approx(friction(I) * pressure).epsilon(1e-3));
    }
}

TEST_CASE("muI, dilatancy at constant pressure: the way to the critical state")
{
    // Slow: d phi/d g = -phi K3 (phi - phiC), so that phi/(phi - phiC) grows by
    // exp(K3 phiC g)
    const auto law(lawOf(grains("dilatancy { phiC 0.58; K2 0; K3 4; }")));
    for (const scalar start : {0.6, 0.55})
    {
        const scalar pressure = 1e3, step = 2e-5;
        points p(pressed(3, pressure, *law));
        std::fill(p.volume.begin(), p.volume.end(), 0.6 / start);
        p.dt = 1e3;
        std::vector<scalar> L(9, 0);
        L[1] = step;
        for (int i = 0; i < 20000; ++i)
        {
            const scalar b = 4 * (0.6 / p.volume[0] - 0.58);
            const scalar open = (b * step + (-meanStress(p, 0) / pressure - 1) * pressure / Kg) / 3;
            L[0] = L[4] = L[8] = open;
            p.apply(*law, L);
        }
        const scalar r = start / (start - 0.58) * std::exp(4 * 0.58 * 20000 * step);
        const scalar exact = 0.58 * r / (r - 1);
        CHECK(0.6 / p.volume[0] - 0.58 == doctest::Approx(exact - 0.58).epsilon(1e-2));
        CHECK(-meanStress(p, 0) == doctest::Approx(pressure).epsilon(1e-2));
    }
}

namespace
{

//- Grains of e and density 1500 at packing 0.6 with collisions, of volume fraction phi
points colliding(const int D, const constitutiveModel& law, const scalar phi)
{
    points p(D, 5, law.rho());
    std::fill(p.volume.begin(), p.volume.end(), 0.6 / phi);
    // Parted: friction has nothing to say
    std::fill(
        p.history[law.columnOf("openStrain", D)].begin(),
        p.history[law.columnOf("openStrain", D)].end(), 10);
    pointBlock b(p.block());
    law.start(b);
    return p;
}

std::string collisions(const std::string& e, const std::string& T0)
{
    return "collisions { e " + e + "; alphaMax 0.65; granularTemperature " + T0 + "; }";
}

//- Radial distribution at contact
scalar g0(const scalar phi) { return 1 / (1 - std::cbrt(phi / 0.65)); }

const scalar pi = 4 * std::atan(1.0);

}

TEST_CASE("muI, collisions: grains at rest cool after Haff's law, at any step")
{
    for (const scalar phi : {0.01, 0.3, 0.6})
        for (const scalar dt : {1e-4, 1e-2})
        {
            const auto law(lawOf(grains(collisions("0.9", "0.25"))));
            points p(colliding(3, *law, phi));
            p.dt = dt;
            const int T = law->columnOf("granularTemperature", 3), n = int(0.1 / dt + 0.5);
            std::vector<scalar> lost(p.n, 0);
            const scalar before = law->strainEnergy(p.block());
            for (int i = 0; i < n; ++i)
            {
                pointBlock b(p.block());
                b.dissipated = lost.data();
                law->correct(b);
            }
            // dT/dt = -8 (1 - e^2) phi g0 T^(3/2)/(d sqrt(pi)) from T0 = 0.25
            const scalar rate = 4 * (1 - 0.81) * phi * g0(phi) / (d * std::sqrt(pi));
            const scalar exact = 0.25 / sqr(1 + rate * 0.5 * 0.1);
            CHECK(p.history[T][2] == doctest::Approx(exact).epsilon(1e-10));
            CHECK(-meanStress(p, 2) > p.mass[2] / p.volume[2] * exact);
            CHECK(
                lost[0] * p.n + law->strainEnergy(p.block())
                == doctest::Approx(before).epsilon(1e-12));
        }
}

TEST_CASE("muI, collisions: steady shear has the temperature and stress of Lun et al.")
{
    // Production mu g^2 = loss: T = M g^2/N, from any start
    for (const scalar phi : {0.05, 0.2, 0.4, 0.55})
        for (const std::string start : {"0", "1"})
            for (int D = 2; D <= 3; ++D)
            {
                const auto law(lawOf(grains(collisions("0.8", start))));
                points p(colliding(D, *law, phi));
                const scalar rate = 50, k = 1.8, g = phi * g0(phi);
                p.dt = 2e-4;
                std::vector<scalar> L(9, 0), lost(p.n, 0);
                L[1] = rate * p.dt;
                for (int i = 0; i < 20000; ++i)
                    p.apply(*law, L);
                const scalar M = 10 * d * std::sqrt(pi) / (96 * k * g) * sqr(1 + 0.8 * k * g)
                    + 0.8 * g * d * k / std::sqrt(pi);
                const scalar N = 12 * (1 - 0.64) * g / (d * std::sqrt(pi));
                const scalar T = M * sqr(rate) / N, rho = 2500 * phi;
                CHECK(
                    p.history[law->columnOf("granularTemperature", D)][1]
                    == doctest::Approx(T).epsilon(1e-6));
                CHECK(
                    p.stress[3][1] == doctest::Approx(rho * M * std::sqrt(T) * rate).epsilon(1e-6));
                CHECK(
                    -meanStress(p, 1) == doctest::Approx(rho * T * (1 + 2 * k * g)).epsilon(1e-6));
                pointBlock b(p.block());
                b.dissipated = lost.data();
                law->correct(b);
                CHECK(
                    lost[1]
                    == doctest::Approx(p.volume[1] * p.stress[3][1] * rate * p.dt).epsilon(1e-6));
            }
}

TEST_CASE("muI, collisions: the wave speed is that of an adiabatic change of the volume")
{
    // c^2 = dp/drho without loss, by the pressures after a small step in and out
    const auto law(lawOf(grains(collisions("1", "0.25"))));
    for (const scalar phi : {0.1, 0.4, 0.58})
    {
        points p(colliding(3, *law, phi)), q(colliding(3, *law, phi));
        std::fill(p.width.begin(), p.width.end(), 1e9);
        std::fill(q.width.begin(), q.width.end(), 1e9);
        // So slow that viscosity does nothing
        p.dt = q.dt = 1e8;
        const scalar step = 1e-6;
        p.apply(*law, {-step / 3, 0, 0, 0, -step / 3, 0, 0, 0, -step / 3});
        q.apply(*law, {step / 3, 0, 0, 0, step / 3, 0, 0, 0, step / 3});
        const scalar dp = meanStress(q, 0) - meanStress(p, 0);
        const scalar dRho = p.mass[0] / p.volume[0] - q.mass[0] / q.volume[0];
        points r(colliding(3, *law, phi));
        std::fill(r.width.begin(), r.width.end(), 1e9);
        pointBlock b(r.block());
        law->correct(b);
        CHECK(sqr(b.waveSpeed - law->waveSpeed()) == doctest::Approx(dp / dRho).epsilon(1e-4));
    }
}

TEST_CASE("muI, collisions: thin elastic grains are a gas of gamma 5/3")
{
    const auto law(lawOf(grains(collisions("1", "0.25"))));
    for (int D = 1; D <= 3; ++D)
    {
        points p(colliding(D, *law, 1e-7));
        const int T = law->columnOf("granularTemperature", D), n = 4000;
        std::vector<scalar> L(9, 0);
        for (int k = 0; k < D; ++k)
            L[k * (D + 1)] = std::log(0.5) / D;
        // So slow that viscosity does nothing
        p.dt = 1e8;
        walk(p, *law, L, n);
        CHECK(p.volume[0] == doctest::Approx(0.5 * 0.6 / 1e-7).epsilon(1e-9));
        // c^2 = 5/3 T; beside it the bed's elastic waves and a viscous part
        pointBlock b(p.block());
        law->correct(b);
        CHECK(b.waveSpeed > law->waveSpeed() + std::sqrt(5.0 / 3 * p.history[T][0]));
        CHECK(p.history[T][0] == doctest::Approx(0.25 * std::pow(2, 2.0 / 3)).epsilon(1e-3));
    }
}
