/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Energy of points that fail, and what laws dissipate.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "testPoints.H"
#include "failureModel.H"

namespace
{

autoPtr<failureModel> modelOf(const std::string& text)
{
    IStringStream is(text);
    return failureModel::New(dictionary(is));
}

//- One step with failure as the solver makes it; returns the mean stress work
scalar step(
    points& p, const constitutiveModel& law, const failureModel& model,
    const std::vector<scalar>& L)
{
    const int N = nStress(p.nDim);
    std::vector<scalar> old(6), now(6);
    scalar tr = 0;
    for (int i = 0; i < p.nDim * p.nDim; ++i)
    {
        std::fill(p.dL[i].begin(), p.dL[i].end(), L[i]);
        tr += i % (p.nDim + 1) ? 0 : L[i];
    }
    for (scalar& v : p.volume)
        v *= std::exp(tr);
    pointBlock b(p.block());
    for (int i = 0; i < N; ++i)
        old[i] = p.stress[i][0];
    model.start(b);
    law.correct(b);
    model.finish(b);
    for (int i = 0; i < N; ++i)
        now[i] = p.stress[i][0];
    return 0.5 * stressWork(b, 0, volumeBefore(b, 0), old.data(), 1)
        + 0.5 * stressWork(b, 0, b.volume[0], now.data(), 1);
}

const std::string
    hot("type JohnsonCook; " + copper
        + "C 0; m 1; beta 0.9;"
          " equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }");

}

TEST_CASE("failed points store what their stress gives back")
{
    for (const std::string& text :
         {std::string("type linearElastic; rho 2700; E 70e9; nu 0.3;"),
          std::string("type linearElastic; rho 2700; E 70e9; nu 0.3; stress Kirchhoff;"),
          std::string("type neoHookean; rho 2700; E 70e9; nu 0.3;"),
          std::string("type MooneyRivlin; rho 2700; c10 10e9; c01 3e9; K 60e9;"),
          J2("hardening none;"),
          std::string("type MohrCoulomb; rho 2700; E 70e9; nu 0.3; cohesion 50e6; frictionAngle "
                      "30; dilationAngle 10;"),
          std::string("type DruckerPrager; rho 2700; E 70e9; nu 0.3; cohesion 50e6; frictionAngle "
                      "30; dilationAngle 10; match inner;"),
          std::string("type NewtonianFluid; rho 2700; mu 0; K 60e9;")})
        for (int D = 1; D <= 3; ++D)
        {
            CAPTURE(text);
            CAPTURE(D);
            const auto law(lawOf(text));
            auto model(modelOf("type maxPrincipalStress; strength 1e3;"));
            model->connect(*law, D);
            points p(D, 1, law->rho());
            std::vector<scalar> L(9, 0);

            // Torn open far beyond any elastic strain
            L[0] = 0.02;
            for (int i = 0; i < 20; ++i)
                step(p, *law, *model, L);
            CHECK(p.damage[0] == 1);
            pointBlock b(p.block());
            CHECK(model->storedEnergy(b) <= 1e-12 * 1e9);

            // Closed and pressed in all directions: all that the law has
            points q(D, 1, law->rho());
            q.damage[0] = 1;
            for (int d = 0; d < D; ++d)
                L[d * (D + 1)] = -1e-3;
            step(q, *law, *model, L);
            pointBlock c(q.block());
            const scalar all = law->strainEnergy(c);
            CHECK(all > 0);
            CHECK(model->storedEnergy(c) == doctest::Approx(all).epsilon(3e-3));
        }
}

TEST_CASE("softening points store (1 - d) of the law's energy")
{
    const auto law(lawOf("type neoHookean; rho 2700; E 70e9; nu 0;"));
    auto model(modelOf("type maxPrincipalStress; strength 70e6; Gf 1000;"));
    model->connect(*law, 2);
    points p(2, 1, 2700);
    p.width[0] = 1e-3;
    scalar work = 0;
    for (int i = 0; i < 400; ++i)
    {
        work += step(p, *law, *model, {1e-5, 0, 0, 0});
    }
    const scalar d = p.damage[0];
    CHECK(d > 0.5);
    CHECK(d < 1);
    pointBlock b(p.block());
    const scalar stored = model->storedEnergy(b), whole = law->strainEnergy(b);
    CHECK(stored == doctest::Approx((1 - d) * whole).epsilon(5e-3));

    // What is gone is the part of Gf that column crack says
    CHECK(model->history()[0].name == "crack");
    const scalar spent = p.history[law->nColumns(2)][0];
    CHECK((work - stored) * 1e-3 == doctest::Approx(spent * 1000).epsilon(0.01));
    CHECK(spent > 0.05);
}

TEST_CASE("failed points: e is the work of the carried stress, nothing else heats")
{
    for (const std::string failed : {"compression", "nothing"})
        for (int D = 2; D <= 3; ++D)
        {
            CAPTURE(failed);
            const auto law(lawOf(hot));
            auto model(modelOf("type maxPrincipalStress; strength 1e8; failed " + failed + ";"));
            model->connect(*law, D);
            points p(D, 1, 8960);
            pointBlock start(p.block());
            law->start(start);
            const int eps = nStress(D), T = eps + 1, e = eps + 2;
            std::vector<scalar> L(9, 0);
            scalar work = 0;
            const auto run = [&](const int n, const scalar along, const scalar shear)
            {
                L[0] = along;
                L[1] = shear;
                for (int i = 0; i < n; ++i)
                    work += step(p, *law, *model, L);
            };

            // Sheared and stretched until it fails, then torn and sheared
            run(20, 5e-4, 1e-3);
            CHECK(p.damage[0] == 1);
            const scalar T0 = p.history[T][0], eps0 = p.history[eps][0];
            const scalar e0 = p.history[e][0];
            CHECK(p.history[e][0] * p.mass[0] == doctest::Approx(work).epsilon(0.02));
            run(100, 5e-3, 1e-2);
            if (failed == "nothing")
            {
                CHECK(p.history[T][0] == T0);
                CHECK(p.history[eps][0] == eps0);
                CHECK(p.history[e][0] == e0);
            }
            else
            {
                // Open by half: next to nothing is carried
                CHECK(p.history[T][0] - T0 < 20);
                CHECK(p.history[eps][0] - eps0 < 0.1);
            }

            // Pressed beyond its closing
            run(100, -6e-3, -1e-2);
            CHECK(p.history[e][0] * p.mass[0] == doctest::Approx(work).epsilon(0.02));
            CHECK(p.history[T][0] > 290);
        }
}

TEST_CASE("maxPrincipalStrain: total strain of laws with an elastic strain")
{
    for (int D = 1; D <= 3; ++D)
    {
        const auto law(lawOf(J2("hardening none;")));
        auto model(modelOf("type maxPrincipalStrain; strain 0.1;"));
        model->connect(*law, D);
        points p(D, 2, 8960);
        std::vector<scalar> L(9, 0);
        L[0] = 1e-3;
        if (D > 1)
            L[D + 1] = -1e-3;
        int n = 0;
        while (p.damage[1] < 1 && n < 1000)
        {
            step(p, *law, *model, L);
            ++n;
        }
        CHECK(n == doctest::Approx(100).epsilon(0.011));
    }
}

TEST_CASE("a law's work is stored or dissipated")
{
    for (const std::string& text :
         {J2("hardening none;"), J2("hardening none; bulkViscosity { linear 0.5; quadratic 1.5; }"),
          std::string("type MohrCoulomb; rho 2700; E 70e9; nu 0.3; cohesion 50e6; frictionAngle "
                      "30; dilationAngle 10;"),
          std::string("type DruckerPrager; rho 2700; E 70e9; nu 0.3; cohesion 50e6; frictionAngle "
                      "30; dilationAngle 10; match inner;"),
          std::string("type NewtonianFluid; rho 2700; mu 1e6; K 60e9; pMin -1e7;")})
        for (int D = 2; D <= 3; ++D)
        {
            CAPTURE(text);
            CAPTURE(D);
            const auto law(lawOf(text));
            points p(D, 1, law->rho());
            p.dt = 1e-6;
            std::vector<scalar> L(9, 0), old(6), now(6), sum(1, 0);
            scalar work = 0;
            for (int i = 0; i < 400; ++i)
            {
                L[0] = -2e-5 + (i > 200 ? 4e-5 : 0);
                L[1] = 4e-5;
                scalar tr = L[0];
                for (int k = 0; k < D * D; ++k)
                    p.dL[k][0] = L[k];
                p.volume[0] *= std::exp(tr);
                for (int k = 0; k < nStress(D); ++k)
                    old[k] = p.stress[k][0];
                pointBlock b(p.block());
                b.dissipated = sum.data();
                law->correct(b);
                for (int k = 0; k < nStress(D); ++k)
                    now[k] = p.stress[k][0];
                work += 0.5 * stressWork(b, 0, volumeBefore(b, 0), old.data(), 1)
                    + 0.5 * stressWork(b, 0, b.volume[0], now.data(), 1);
            }
            pointBlock b(p.block());
            CHECK(sum[0] > 0.1 * work);
            CHECK(sum[0] + law->strainEnergy(b) == doctest::Approx(work).epsilon(5e-3));
        }
}

TEST_CASE("a fluid stores nothing below pMin")
{
    for (const char* const pMin : {"0", "-1e6"})
    {
        const auto law(
            lawOf("type NewtonianFluid; rho 1000; mu 0; K 2e9; pMin " + std::string(pMin) + ";"));
        points p(2, 1, 1000);
        const scalar least = std::stod(pMin);
        p.apply(*law, {0.5, 0, 0, 0});
        CHECK(p.stress[0][0] == doctest::Approx(-least));
        pointBlock b(p.block());
        // Work of the tension -pMin over the volume that it opens
        const scalar most = -least * (p.volume[0] - 1);
        CHECK(law->strainEnergy(b) <= most + 1e-9);
        CHECK(law->strainEnergy(b) >= 0.99 * most);
        p.apply(*law, {-0.501, 0, 0, 0});
        pointBlock c(p.block());
        CHECK(law->strainEnergy(c) == doctest::Approx(0.5 * 2e9 * 1e-6).epsilon(0.01));
    }
}

TEST_CASE("failed points that have opened have no fast waves")
{
    for (const std::string& text : {J2("hardening none;"), hot})
        for (int D = 1; D <= 3; ++D)
        {
            CAPTURE(text);
            CAPTURE(D);
            const auto law(lawOf(text));
            const auto speed = [&](const scalar damage, const scalar lnV)
            {
                points p(D, 1, law->rho());
                p.damage[0] = damage;
                for (int d = 0; d < D; ++d)
                {
                    std::fill(p.dL[d * (D + 1)].begin(), p.dL[d * (D + 1)].end(), lnV / D);
                }
                for (scalar& v : p.volume)
                    v *= std::exp(lnV);
                pointBlock b(p.block());
                law->correct(b);
                return b.waveSpeed;
            };
            CHECK(speed(0, 2) > 1.2 * law->waveSpeed());
            CHECK(speed(1, 2) <= law->waveSpeed() * (1 + 1e-12));
            CHECK(speed(1, -0.05) == speed(0, -0.05));
            CHECK(speed(0.9, 2) == speed(0, 2));
        }
}
