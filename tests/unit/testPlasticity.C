/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "testPoints.H"
#include "failureModel.H"
#include "IFstream.H"
#include <cstdlib>
#include <unsupported/Eigen/MatrixFunctions>

namespace
{

const scalar G = 46e9, K = 129e9;

//- OFHC copper without what a test gives itself
const std::string copper
(
    "rho 8960; G 46e9; A 90e6; B 292e6; n 0.31; referenceRate 1;"
    " referenceTemperature 294; meltTemperature 1356; cp 383; "
);

//- J2 with linear pressure
std::string J2(const std::string& hardening)
{
    return "type J2Plasticity; rho 8960; G 46e9; K 129e9; yield 100e6; "
        + hardening;
}

const std::string soil
(
    " rho 2000; E 20e6; nu 0.1; cohesion 10e3; frictionAngle 30; "
);

//- Equivalent stress of a point
scalar mises(const points& p, const label i)
{
    const auto inv(p.invariants(i));
    return std::sqrt(max(1.5*(inv[1] - inv[0]*inv[0]/3), 0.0));
}

scalar meanStress(const points& p, const label i)
{
    return p.invariants(i)[0]/3;
}

//- A root of a falling function between two values
template<class F>
scalar root(const F& f, scalar a, scalar b)
{
    for (int i = 0; i < 200; ++i)
    {
        const scalar c = 0.5*(a + b);
        (f(c) > 0 ? a : b) = c;
    }
    return 0.5*(a + b);
}

//- n equal steps of a velocity gradient
void walk
(
    points& p,
    const constitutiveModel& law,
    std::vector<scalar> L,
    const int n
)
{
    for (scalar& l : L) l /= n;
    for (int i = 0; i < n; ++i) p.apply(law, L);
}

}


TEST_CASE("J2Plasticity: uniaxial strain against the closed form")
{
    // sigma_eq = 2 G |h| - 3 G eps = Y(eps) once 2 G |h| > Y: proportional, so
    // exact for any number of steps. p = K (exp(-h) - 1)
    struct { std::string text; scalar H, B, n; } kinds[] =
    {
        {"hardening none;", 0, 0, 1},
        {"hardening linear; H 500e6;", 500e6, 0, 1},
        {"hardening power; B 292e6; n 0.31;", 0, 292e6, 0.31}
    };
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
        { return 100e6 + kind.H*e + kind.B*std::pow(e, kind.n); };
        const scalar q0 = 2*G*std::abs(h);
        const scalar eps = q0 > 100e6
          ? root([&](scalar e) { return q0 - 3*G*e - Y(e); }, 0, q0/(3*G)) : 0;
        const scalar q = q0 - 3*G*eps, sign = h > 0 ? 1 : -1;
        const scalar mean = -K*(std::exp(-h) - 1);
        const scalar size = std::abs(mean) + q;
        for (label i = 0; i < p.n; ++i)
        {
            CHECK(std::abs(p.stress[0][i] - mean - sign*2.0/3*q) <= 1e-10*size);
            CHECK(std::abs(p.stress[1][i] - mean + sign*q/3) <= 1e-10*size);
            CHECK(std::abs(p.stress[2][i] - mean + sign*q/3) <= 1e-10*size);
            CHECK(p.history[nStress(D)][i] == doctest::Approx(eps).epsilon(1e-9));
        }
    }
}


TEST_CASE("J2Plasticity: small strain is linear elasticity, stored energy too")
{
    const auto law(lawOf(J2("hardening none;")));
    const scalar E = 9*K*G/(3*K + G), nu = (3*K - 2*G)/(2*(3*K + G));
    const auto linear
    (
        lawOf
        (
            "type linearElastic; rho 8960; E " + std::to_string(E) + "; nu "
          + std::to_string(nu) + ";"
        )
    );
    CHECK(law->waveSpeed() == doctest::Approx(linear->waveSpeed()).epsilon(1e-5));
    CHECK(law->elasticModulus() == doctest::Approx(E).epsilon(1e-12));
    const std::vector<scalar> all
        ({0.7, 0.9, -0.2, 0.1, -0.5, 0.4, 0.3, -0.6, 0.8});
    for (int D = 1; D <= 3; ++D)
    {
        points a(D, 9, 8960), b(D, 9, 8960);
        std::vector<scalar> L(9, 0);
        for (int i = 0; i < D*D; ++i) L[i] = 3e-4*all[i];
        a.apply(*law, L);
        b.apply(*linear, L);
        for (int i = 0; i < nStress(D); ++i)
        {
            CHECK(std::abs(a.stress[i][8] - b.stress[i][8]) <= 1e-3*E*3e-4);
        }
        CHECK
        (
            law->strainEnergy(a.block())
         == doctest::Approx(linear->strainEnergy(b.block())).epsilon(2e-3)
        );
    }
}


TEST_CASE("laws of small elastic strain: a superposed rotation turns the stress")
{
    // Steps f of a wild path, and R_k+1 f R_k^T with unrelated rotations: the
    // second stress is the first one turned
    typedef Eigen::MatrixXd matrix;
    const std::string laws[] =
    {
        J2("hardening power; B 292e6; n 0.31;"),
        "type JohnsonCook; C 0.025; m 1.09; beta 0.9; " + copper
      + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }"
        " bulkViscosity { linear 0.06; quadratic 1.5; }",
        "type DruckerPrager; match inner; dilationAngle 10;" + soil,
        "type MohrCoulomb; dilationAngle 10; tensionCutoff 8e3;" + soil,
        "type MooneyRivlin; rho 1000; c10 1e6; c01 3e5; K 1e8;",
        "type NewtonianFluid; rho 1000; mu 0.1; K 2e9;"
    };
    for (const std::string& text : laws)
    for (int D = 2; D <= 3; ++D)
    {
        const auto law(lawOf(text));
        points a(D, 3, law->rho()), b(D, 3, law->rho());
        a.dt = b.dt = 1e-6;
        law->start(*std::make_unique<pointBlock>(a.block()));
        law->start(*std::make_unique<pointBlock>(b.block()));
        matrix R(matrix::Identity(D, D));
        unsigned seed = 1;
        const auto draw = [&]()
        {
            seed = seed*1664525u + 1013904223u;
            return seed/4294967296.0 - 0.5;
        };
        scalar size = 0;
        for (int step = 0; step < 40; ++step)
        {
            matrix L(D, D), w(D, D);
            for (int i = 0; i < D*D; ++i)
            {
                L(i/D, i % D) = 0.05*draw();
                w(i/D, i % D) = 0.8*draw();
            }
            const matrix S((w - w.transpose()).eval());
            const matrix turn(S.exp()*R);
            const matrix M((turn*L.exp()*R.transpose()).log());
            R = turn;
            std::vector<scalar> La(9, 0), Lb(9, 0);
            for (int i = 0; i < D*D; ++i)
            {
                La[i] = L(i/D, i % D);
                Lb[i] = M(i/D, i % D);
            }
            a.apply(*law, La);
            b.apply(*law, Lb);

            matrix s(D, D), t(D, D);
            for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j)
            {
                s(i, j) = a.stress[symmSlot(i, j)][2];
                t(i, j) = b.stress[symmSlot(i, j)][2];
            }
            size = max(size, s.norm());
            CHECK((t - R*s*R.transpose()).norm() <= 1e-10*size);
            for (int i = D; i < 3; ++i)
            {
                CHECK(std::abs(a.stress[i][2] - b.stress[i][2]) <= 1e-10*size);
            }
        }
        CHECK(size > 0);
    }
}


TEST_CASE("JohnsonCook: the stress is on the surface of the published formula")
{
    const auto law
    (
        lawOf
        ("type JohnsonCook; K 129e9; C 0.025; m 1.09; beta 0.9; " + copper)
    );
    for (int D = 2; D <= 3; ++D)
    for (const scalar rate : {1e-3, 10.0, 1e4, 1e6})
    {
        points p(D, 5, 8960);
        p.dt = 0.01/rate;
        law->start(*std::make_unique<pointBlock>(p.block()));
        std::vector<scalar> L(9, 0);
        L[0] = 0.01; L[D + 1] = -0.01;
        for (int i = 0; i < 30; ++i)
        {
            const scalar e0 = p.history[nStress(D)][1];
            const scalar T0 = p.history[nStress(D) + 1][1];
            p.apply(*law, L);
            const scalar e = p.history[nStress(D)][1];
            const scalar fast = max((e - e0)/p.dt, 1.0);
            const scalar Y =
                (90e6 + 292e6*std::pow(e, 0.31))*(1 + 0.025*std::log(fast))
               *(1 - std::pow((T0 - 294)/(1356 - 294), 1.09));
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
    const auto law
    (
        lawOf("type JohnsonCook; K 129e9; C 0; m 1; beta 0.9; " + copper)
    );
    scalar last = 0;
    for (const int n : {500, 2000})
    {
        points p(3, 1, 8960);
        law->start(*std::make_unique<pointBlock>(p.block()));
        std::vector<scalar> L(9, 0);
        L[0] = 3; L[4] = -3;
        walk(p, *law, L, n);
        const scalar e = p.history[6][0];
        const scalar a = 0.9/(8960*383*(1356 - 294.0));
        const scalar t = 1 - std::exp(-a*(90e6*e + 292e6*std::pow(e, 1.31)/1.31));
        const scalar error = (p.history[7][0] - 294)/(1356 - 294) - t;
        CHECK(std::abs(error) < (n == 500 ? 0.004 : 0.001)*t);
        if (n == 2000) CHECK(std::abs(error) < 0.3*std::abs(last));
        last = error;
    }

    // beta 0: no heat
    const auto cold
    (
        lawOf("type JohnsonCook; K 129e9; C 0; m 1; beta 0; " + copper)
    );
    points p(3, 1, 8960);
    cold->start(*std::make_unique<pointBlock>(p.block()));
    std::vector<scalar> L(9, 0);
    L[0] = 1; L[4] = -1;
    walk(p, *cold, L, 10);
    CHECK(p.history[7][0] == 294);
}


TEST_CASE("JohnsonCook: molten metal has pressure alone")
{
    const auto law
    (
        lawOf
        (
            "type JohnsonCook; K 129e9; C 0.025; m 1.09; beta 0.9;"
            " initialTemperature 1400; " + copper
        )
    );
    points p(3, 9, 8960);
    law->start(*std::make_unique<pointBlock>(p.block()));
    std::vector<scalar> L(9, 0);
    L[0] = -0.1; L[1] = 0.2;
    p.apply(*law, L);
    for (label i = 0; i < p.n; ++i)
    {
        CHECK(mises(p, i) <= 1e-7*K);
        CHECK(meanStress(p, i) == doctest::Approx(-K*(std::exp(0.1) - 1)).epsilon(1e-10));
    }
}


TEST_CASE("internal energy: second order, and equal to the work of the stress")
{
    // Compression with shear; the fine walk is the reference, and the energy is
    // the sum of the stress power
    const auto law
    (
        lawOf
        (
            "type JohnsonCook; C 0; m 1.09; beta 0.9; " + copper
          + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }"
        )
    );
    std::vector<scalar> L(9, 0);
    L[0] = -0.25; L[1] = 0.05; L[4] = 0.02;
    const auto energy = [&](const int n)
    {
        points p(3, 1, 8960);
        law->start(*std::make_unique<pointBlock>(p.block()));
        scalar work = 0;
        for (int i = 0; i < n; ++i)
        {
            const auto power = [&]()
            {
                return p.volume[0]/8960/n
                   *(p.stress[0][0]*L[0] + p.stress[3][0]*L[1] + p.stress[1][0]*L[4]);
            };
            std::vector<scalar> dL(L);
            for (scalar& l : dL) l /= n;
            work += 0.5*power();
            p.apply(*law, dL);
            work += 0.5*power();
        }
        CHECK(p.history[8][0] == doctest::Approx(work).epsilon(0.2/n/n + 2e-4/n));
        return p.history[8][0];
    };
    const scalar exact = energy(6400);
    const scalar coarse = std::abs(energy(50) - exact);
    const scalar fine = std::abs(energy(100) - exact);
    CHECK(coarse < 1e-3*exact);
    CHECK(fine < 0.35*coarse);
}


TEST_CASE("perfectGas as a fluid: isentropic compression, second order")
{
    const auto law
    (
        lawOf
        (
            "type NewtonianFluid; rho 1.2; mu 0;"
            " equationOfState { type perfectGas; gamma 1.4; p0 1e5; }"
        )
    );
    scalar last = 0;
    for (const int n : {20, 40})
    {
        points p(3, 9, 1.2);
        law->start(*std::make_unique<pointBlock>(p.block()));
        std::vector<scalar> L(9, 0);
        L[0] = L[4] = L[8] = -0.3;
        walk(p, *law, L, n);
        const scalar exact = 1e5*std::exp(1.4*0.9);
        const scalar error = -p.stress[0][8]/exact - 1;
        CHECK(std::abs(error) < 1e-3);
        if (n == 40) CHECK(std::abs(error) < 0.3*std::abs(last));
        last = error;

        std::fill(p.dL[0].begin(), p.dL[0].end(), 0);
        std::fill(p.dL[4].begin(), p.dL[4].end(), 0);
        std::fill(p.dL[8].begin(), p.dL[8].end(), 0);
        pointBlock b(p.block());
        law->correct(b);
        CHECK(b.waveSpeed == doctest::Approx(std::sqrt(1.4*exact/1.2*std::exp(-0.9))).epsilon(2e-3));
    }
}


TEST_CASE("NewtonianFluid: shear flow, heat, pMin")
{
    const scalar mu = 0.3, rate = 20, dt = 1e-5;
    const auto law
    (
        lawOf
        (
            "type NewtonianFluid; rho 1.2; mu 0.3;"
            " equationOfState { type perfectGas; gamma 1.4; p0 1e5; }"
        )
    );
    for (int D = 2; D <= 3; ++D)
    {
        points p(D, 6, 1.2);
        p.dt = dt;
        law->start(*std::make_unique<pointBlock>(p.block()));
        const scalar e0 = p.history[1][0];
        std::vector<scalar> L(9, 0);
        L[1] = rate*dt;
        for (int i = 0; i < 100; ++i) p.apply(*law, L);
        CHECK(p.stress[3][5] == doctest::Approx(mu*rate).epsilon(1e-6));
        CHECK(p.stress[0][5] == doctest::Approx(-1e5).epsilon(1e-4));
        CHECK(p.history[1][5] - e0 == doctest::Approx(mu*rate*rate*100*dt/1.2).epsilon(1e-4));
    }

    const auto water(lawOf("type NewtonianFluid; rho 1000; mu 0; K 2e9; pMin 0;"));
    points p(2, 3, 1000);
    std::vector<scalar> L(9, 0);
    L[0] = 0.01;
    p.apply(*water, L);
    CHECK(p.stress[0][1] == 0);
    L[0] = -0.02;
    p.apply(*water, L);
    CHECK(p.stress[0][1] == doctest::Approx(-2e9*(std::exp(0.01) - 1)).epsilon(1e-12));
}


TEST_CASE("bulk viscosity: pressure, heat, only in compression")
{
    const std::string gas
    (
        "type NewtonianFluid; rho 1.2; mu 0;"
        " equationOfState { type perfectGas; gamma 1.4; p0 1e5; } "
    );
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
        const scalar rho = 1.2*std::exp(-d), l = 0.01, rate = -d/1e-7;
        const scalar c = std::sqrt(1.4*1e5/1.2);
        const scalar q = d < 0 ? rho*l*rate*(0.06*c + 1.5*l*rate) : 0;
        CHECK(b.stress[0][1] - a.stress[0][1] == doctest::Approx(q).epsilon(1e-3));
        CHECK
        (
            a.history[1][1] - b.history[1][1]
         == doctest::Approx(q*(1/1.2 - 1/rho)).epsilon(1e-3)
        );
    }
}


TEST_CASE("split laws: initial stress")
{
    const std::string laws[] =
    {
        J2("hardening none;"),
        "type JohnsonCook; C 0.025; m 1.09; beta 0.9; " + copper
      + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }",
        "type DruckerPrager; match outer; dilationAngle 0; rho 1; E 1e10; nu 0.2;"
        " cohesion 1e9; frictionAngle 20;",
        "type MohrCoulomb; dilationAngle 0; rho 1; E 1e10; nu 0.2;"
        " cohesion 1e9; frictionAngle 20;",
        "type MooneyRivlin; rho 1000; c10 1e8; c01 3e7; K 1e10;"
    };
    for (const std::string& text : laws)
    for (int D = 1; D <= 3; ++D)
    {
        const auto law(lawOf(text));
        points p(D, 9, law->rho());
        for (label i = 0; i < p.n; ++i)
        {
            p.stress[0][i] = 4e7 - 5e6*i; p.stress[1][i] = -1e7; p.stress[2][i] = 2e7;
            for (int k = 3; k < nStress(D); ++k) p.stress[k][i] = 3e6*k;
        }
        const auto before(p.stress);
        pointBlock b(p.block());
        law->start(b);
        law->initialise(b);
        p.apply(*law, std::vector<scalar>(9, 0));
        for (int k = 0; k < nStress(D); ++k)
        for (label i = 0; i < p.n; ++i)
        {
            CHECK(std::abs(p.stress[k][i] - before[k][i]) <= 1e-9*4e7);
        }
    }
    const auto gas
    (
        lawOf
        (
            "type NewtonianFluid; rho 1.2; mu 0;"
            " equationOfState { type perfectGas; gamma 1.4; p0 1e5; }"
        )
    );
    points p(2, 3, 1.2);
    for (int k = 0; k < 3; ++k) p.stress[k][1] = -3e5;
    for (int k = 0; k < 3; ++k) p.stress[k][0] = p.stress[k][2] = -1e5;
    pointBlock b(p.block());
    gas->start(b);
    gas->initialise(b);
    p.apply(*gas, std::vector<scalar>(9, 0));
    CHECK(p.stress[1][1] == doctest::Approx(-3e5).epsilon(1e-12));
    p.stress[0][1] = 1e5;
    CHECK_THROWS_AS(gas->initialise(b), Foam::error);
}


TEST_CASE("DruckerPrager: uniaxial strain against the closed form")
{
    // Totals of a proportional path: T = 2 G |h|/sqrt(3), S = K h and
    // g = (T + a S - k)/(G + K a b)
    const scalar E = 20e6, nu = 0.1, Ks = E/(3*(1 - 2*nu)), Gs = E/(2*(1 + nu));
    const scalar sn = 0.5, cs = std::sqrt(0.75), s10 = std::sin(std::atan(1.0)/4.5);
    for (const int sign : {-1, 1})
    for (int D = 1; D <= 3; ++D)
    {
        const std::string match(sign < 0 ? "outer" : "inner");
        const auto law
        (
            lawOf("type DruckerPrager; dilationAngle 10; match " + match + ";" + soil)
        );
        const auto slope = [&](const scalar s)
        { return 6*s/(std::sqrt(3.0)*(3 + sign*s)); };
        const scalar a = slope(sn), b = slope(s10);
        const scalar k = 6*10e3*cs/(std::sqrt(3.0)*(3 + sign*sn));
        const scalar h = -0.02;
        points p(D, 11, 2000);
        std::vector<scalar> L(9, 0);
        L[0] = h;
        walk(p, *law, L, 9);

        const scalar T = 2*Gs*std::abs(h)/std::sqrt(3.0), S = Ks*h;
        const scalar g = max((T + a*S - k)/(Gs + Ks*a*b), 0.0);
        const scalar t = T - Gs*g, s = S - Ks*b*g;
        for (label i = 0; i < p.n; ++i)
        {
            CHECK(meanStress(p, i) == doctest::Approx(s).epsilon(1e-10));
            CHECK(mises(p, i) == doctest::Approx(std::sqrt(3.0)*t).epsilon(1e-10));
            CHECK(p.history[nStress(D)][i] == doctest::Approx(g/std::sqrt(3.0)).epsilon(1e-9));
        }
        CHECK(g > 0);
    }
}


TEST_CASE("frictional laws: apex and tension cut-off")
{
    // Pulled apart: mean stress stays at c/tan(phi), or at the cut-off
    for (const std::string& cut : {"", "tensionCutoff 2e3;"})
    for (const std::string& type : {"DruckerPrager; match outer;", "MohrCoulomb;"})
    for (int D = 1; D <= 3; ++D)
    {
        const auto law(lawOf("type " + type + cut + "dilationAngle 30;" + soil));
        points p(D, 9, 2000);
        std::vector<scalar> L(9, 0);
        for (int d = 0; d < D; ++d) L[d*(D + 1)] = 0.02;
        if (D == 1) L[0] = 0.3;
        walk(p, *law, L, 20);
        const scalar limit = cut.empty() ? 10e3/std::tan(std::atan(1.0)/1.5) : 2e3;
        if (D == 3)
        {
            CHECK(meanStress(p, 8) == doctest::Approx(limit).epsilon(1e-9));
            CHECK(mises(p, 8) <= 1e-9*limit);
        }
        CHECK(meanStress(p, 8) <= limit*(1 + 1e-9));
    }
}


TEST_CASE("MohrCoulomb: pure shear, triaxial strength, yield on wild paths")
{
    const scalar E = 20e6, nu = 0.1, Ks = E/(3*(1 - 2*nu)), Gs = E/(2*(1 + nu));
    const scalar c = 10e3, sn = 0.5, cs = std::sqrt(0.75);
    const scalar s10 = std::sin(std::atan(1.0)/4.5);

    // Stretches (e, -e): main plane, g = f/a from the totals
    const auto law(lawOf("type MohrCoulomb; dilationAngle 10;" + soil));
    const scalar e = 2e-3;
    for (int D = 2; D <= 3; ++D)
    {
        points p(D, 9, 2000);
        std::vector<scalar> L(9, 0);
        L[0] = e; L[D + 1] = -e;
        walk(p, *law, L, 5);
        const scalar g =
            (4*Gs*e - 2*c*cs)/(4*Gs*(1 + sn*s10/3) + 4*Ks*sn*s10);
        CHECK(g > 0);
        const scalar s1 = 2*Gs*e - (2*Gs*(1 + s10/3) + 2*Ks*s10)*g;
        const scalar s3 = -2*Gs*e + (2*Gs*(1 - s10/3) - 2*Ks*s10)*g;
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
        const scalar q = (6*c*cs + 6*Ks*0.02*sn)/(3 - sn);
        CHECK(meanStress(p, 7) == doctest::Approx(-Ks*0.02).epsilon(1e-9));
        CHECK(mises(p, 7) == doctest::Approx(q).epsilon(1e-9));
        CHECK(p.stress[1][7] == doctest::Approx(-Ks*0.02 - 2.0/3*q).epsilon(1e-9));
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
            seed = seed*1664525u + 1013904223u;
            p.dL[i][k] = 5e-3*(seed/4294967296.0 - 0.5);
        }
        pointBlock b(p.block());
        cut->correct(b);
        for (label k = 0; k < p.n; ++k)
        {
            double s[9];
            fullStress(b, k, s);
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver
            (Eigen::Map<Eigen::Matrix3d>(s, 3, 3).eval());
            const auto v(solver.eigenvalues());
            const scalar size = v.cwiseAbs().maxCoeff() + c;
            CHECK(v(2) - v(0) + (v(2) + v(0))*sn - 2*c*cs <= 1e-9*size);
            CHECK(v(2) <= 5e3 + 1e-9*size);
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
        const scalar size = c10*(g + g*g*g*g);
        CHECK(std::abs(p.stress[3][8] - 2*(c10 + c01)*g) <= 1e-9*size);
        CHECK(std::abs(xx - yy - 2*(c10 + c01)*g*g) <= 1e-9*size);
        CHECK(std::abs(yy - zz + 2*c01*g*g) <= 1e-9*size);
        CHECK(law->strainEnergy(p.block())/9 == doctest::Approx((c10 + c01)*g*g).epsilon(1e-6));
    }
    for (int D = 1; D <= 3; ++D)
    for (const scalar F : {0.5, 0.9, 1.1, 2.0})
    {
        points p(D, 9, 1000);
        std::vector<scalar> L(9, 0);
        L[0] = std::log(F);
        walk(p, *law, L, 5);
        const scalar r = std::pow(F, -2.0/3), b1 = r*F*F, b2 = r;
        const scalar t1 = c10*b1 + c01*b1*2*b2, t2 = c10*b2 + c01*b2*(b1 + b2);
        const scalar mean = (t1 + 2*t2)/3;
        CHECK(p.stress[0][8] == doctest::Approx((2*(t1 - mean) + Kr*std::log(F))/F).epsilon(1e-10));
        CHECK(p.stress[2][8] == doctest::Approx((2*(t2 - mean) + Kr*std::log(F))/F).epsilon(1e-10));
    }
    CHECK(law->waveSpeed() == doctest::Approx(std::sqrt((Kr + 4.0/3*2.6e6)/1000)).epsilon(1e-12));
}


TEST_CASE("points of a block do not see each other")
{
    for (const std::string& text :
    {
        J2("hardening power; B 292e6; n 0.31;"),
        "type JohnsonCook; C 0.025; m 1.09; beta 0.9; " + copper
      + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }",
        "type MohrCoulomb; dilationAngle 10;" + soil,
        std::string("type NewtonianFluid; rho 1000; mu 1; K 2e9;")
    })
    for (int D = 1; D <= 3; ++D)
    {
        const auto law(lawOf(text));
        points all(D, 300, law->rho());
        all.dt = 1e-6;
        pointBlock b(all.block());
        law->start(b);
        for (label i = 0; i < all.n; ++i)
        {
            all.dL[0][i] = 0.1*std::sin(1.0*i);
            if (D > 1) all.dL[1][i] = 1e-3*(i % 17);
        }
        law->correct(b);
        for (const label i : {0, 1, 126, 127, 128, 131, 299})
        {
            points one(D, 1, law->rho());
            one.dt = 1e-6;
            pointBlock b1(one.block());
            law->start(b1);
            for (int k = 0; k < D*D; ++k) one.dL[k][0] = all.dL[k][i];
            law->correct(b1);
            for (int k = 0; k < nStress(D); ++k)
            {
                CHECK(std::abs(one.stress[k][0] - all.stress[k][i]) <= 1e-12*K);
            }
        }
    }
}


TEST_CASE("input errors of plastic laws and fluids")
{
    for (const std::string& text :
    {
        J2("hardening none; yield -1;"), J2("hardening soft;"),
        J2("hardening linear;"), J2("hardening linear; H -1;"),
        J2("hardening none; H 1;"), J2("hardening power; B 1; n 1.5;"),
        J2("hardening none; E 1e9;"),
        std::string("type J2Plasticity; rho 1; G 1; yield 1; hardening none;"),
        J2("hardening none; equationOfState { type linear; K 1; }"),
        J2("hardening none; bulkViscosity { linear 0.06; }"),
        "type JohnsonCook; K 1; C 0.1; m 1; beta 1.1; " + copper,
        "type JohnsonCook; K 1; C 0.1; m 1; " + copper,
        "type JohnsonCook; K 1; C -0.1; m 1; beta 0.9; " + copper,
        "type JohnsonCook; K 1; C 0.1; m 1; beta 0.9; A -1; " + copper.substr(0, 19)
      + copper.substr(26),
        "type DruckerPrager; dilationAngle 0;" + soil,
        "type DruckerPrager; match outer; dilationAngle 31;" + soil,
        "type MohrCoulomb; dilationAngle 0; match outer;" + soil,
        std::string("type MohrCoulomb; rho 1; E 1; nu 0.3; cohesion -1; frictionAngle 0; dilationAngle 0;"),
        std::string("type MooneyRivlin; rho 1; c10 -1; c01 0; K 1;"),
        std::string("type MooneyRivlin; rho 1; c10 1; c01 0; K 1; E 2;"),
        std::string("type NewtonianFluid; rho 1; mu -1; K 1;"),
        std::string("type NewtonianFluid; rho 1; mu 1;"),
        std::string("type NewtonianFluid; rho 1; mu 1; K 1; G 1;")
    })
    {
        CAPTURE(text);
        CHECK_THROWS_AS(lawOf(text), Foam::IOerror);
    }
}


TEST_CASE("etc/materials: the files are laws with the published constants")
{
    // A, B, n, C, m; rho, cp, Tm, G; C0, S, Gamma0 of Uintah's MaterialData;
    // D1 to D5, 0 without
    struct
    {
        const char* name;
        scalar jc[5], other[4], shock[3], damage[5];
    } materials[] =
    {
        {"copperOFHC", {90e6, 292e6, 0.31, 0.025, 1.09}, {8960, 383, 1356, 46e9},
            {3940, 1.489, 2.02}, {0.54, 4.89, -3.03, 0.014, 1.12}},
        {"ironArmco", {175e6, 380e6, 0.32, 0.06, 1.44}, {7890, 452, 1811, 80e9},
            {3574, 1.92, 1.69}, {-2.20, 5.43, -0.47, 0.016, 0.63}},
        {"steel4340", {792e6, 510e6, 0.26, 0.014, 1.03}, {7830, 477, 1793, 77e9},
            {3574, 1.92, 1.69}, {0.05, 3.44, -2.12, 0.002, 0.61}},
        {"aluminium6061T6", {324e6, 114e6, 0.42, 0.002, 1.34}, {2700, 896, 925, 26e9},
            {5386, 1.339, 1.99}, {-0.77, 1.45, -0.47, 0, 1.60}},
        {"steelHzB", {1500e6, 569e6, 0.22, 0.003, 1.17}, {7850, 477, 1793, 77.8e9},
            {3574, 1.92, 1.69}, {0, 0, 0, 0, 0}},
        {"tungstenAlloy", {1506.96e6, 176.64e6, 0.12, 0.016, 1}, {17000, 134, 3695, 124e9},
            {3980, 1.24, 1.54}, {0, 0, 0, 0, 0}}
    };
    const std::string folder(std::string(std::getenv("MPM_PROJECT_DIR")) + "/etc/materials/");
    for (const auto& m : materials)
    {
        IFstream is(folder + m.name);
        const dictionary dict(is);
        const auto law(constitutiveModel::New(dict));
        const char* jc[] = {"A", "B", "n", "C", "m"};
        for (int i = 0; i < 5; ++i) CHECK(dict.get<scalar>(jc[i]) == m.jc[i]);
        const char* other[] = {"rho", "cp", "meltTemperature", "G"};
        for (int i = 0; i < 4; ++i) CHECK(dict.get<scalar>(other[i]) == m.other[i]);
        const char* shock[] = {"C0", "S", "Gamma0"};
        for (int i = 0; i < 3; ++i)
        {
            CHECK(dict.subDict("equationOfState").get<scalar>(shock[i]) == m.shock[i]);
        }
        CHECK
        (
            law->waveSpeed()
         == doctest::Approx
            (std::sqrt(sqr(m.shock[0]) + 4.0/3*m.other[3]/m.other[0])).epsilon(1e-10)
        );
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
