// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testPoints.H"
#include "tensor.H"

namespace
{

//- Series of exp for a tensor of norm < 2
tensor expOf(const tensor& A)
{
    tensor sum(tensor::I), term(tensor::I);
    for (int k = 1; k < 25; ++k)
    {
        term = (term & A) / k;
        sum += term;
    }
    return sum;
}

//- Logarithm: square roots (Denman and Beavers) until the series of 2 artanh(z),
//  z = (A - 1)(A + 1)^-1, is short
tensor logOf(tensor A)
{
    scalar factor = 2;
    for (; mag(A - tensor::I) > 0.1; factor *= 2)
    {
        tensor root(A), other(tensor::I);
        for (int k = 0; k < 10; ++k)
        {
            const tensor next(0.5 * (root + inv(other)));
            other = 0.5 * (other + inv(root));
            root = next;
        }
        A = root;
    }
    const tensor z((A - tensor::I) & inv(A + tensor::I));
    tensor sum(Zero), power(z);
    for (int k = 1; k < 20; k += 2)
    {
        sum += power / k;
        power = power & z & z;
    }
    return factor * sum;
}

}

TEST_CASE("laws of small elastic strain: a superposed rotation turns the stress")
{
    // Steps f of a wild path, and R_k+1 f R_k^T with unrelated rotations: the
    // second stress is the first one turned
    const std::string laws[] = {
        J2("hardening power; B 292e6; n 0.31;"),
        "type JohnsonCook; C 0.025; m 1.09; beta 0.9; " + copper
            + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }"
              " bulkViscosity { linear 0.06; quadratic 1.5; }",
        "type DruckerPrager; match inner; dilationAngle 10;" + soil,
        "type MohrCoulomb; dilationAngle 10; tensionCutoff 8e3;" + soil,
        grains(""),
        grains("dilatancy { phiC 0.58; K2 0.2; K3 4; }"),
        "type MooneyRivlin; rho 1000; c10 1e6; c01 3e5; K 1e8;",
        "type NewtonianFluid; rho 1000; mu 0.1; K 2e9;"};
    for (const std::string& text : laws)
        for (int D = 2; D <= 3; ++D)
        {
            const auto law(lawOf(text));
            points a(D, 3, law->rho()), b(D, 3, law->rho());
            a.dt = b.dt = 1e-6;
            law->start(*std::make_unique<pointBlock>(a.block()));
            law->start(*std::make_unique<pointBlock>(b.block()));
            tensor R(tensor::I);
            unsigned seed = 1;
            const auto draw = [&]()
            {
                seed = seed * 1664525u + 1013904223u;
                return seed / 4294967296.0 - 0.5;
            };
            scalar size = 0;
            for (int step = 0; step < 40; ++step)
            {
                tensor L(Zero), w(Zero);
                for (int i = 0; i < D * D; ++i)
                {
                    L(i / D, i % D) = 0.05 * draw();
                    w(i / D, i % D) = 0.8 * draw();
                }
                const tensor turn(expOf(w - w.T()) & R);
                const tensor M(logOf(turn & expOf(L) & R.T()));
                R = turn;
                std::vector<scalar> La(9, 0), Lb(9, 0);
                for (int i = 0; i < D * D; ++i)
                {
                    La[i] = L(i / D, i % D);
                    Lb[i] = M(i / D, i % D);
                }
                a.apply(*law, La);
                b.apply(*law, Lb);

                tensor s(Zero), t(Zero);
                for (int i = 0; i < D; ++i)
                    for (int j = 0; j < D; ++j)
                    {
                        s(i, j) = a.stress[symmSlot(i, j)][2];
                        t(i, j) = b.stress[symmSlot(i, j)][2];
                    }
                size = max(size, mag(s));
                CHECK(mag(t - (R & s & R.T())) <= 1e-10 * size);
                for (int i = D; i < 3; ++i)
                {
                    CHECK(std::abs(a.stress[i][2] - b.stress[i][2]) <= 1e-10 * size);
                }
            }
            CHECK(size > 0);
        }
}

TEST_CASE("hoop strain of an axisymmetric block: as the same path in 3D")
{
    const std::string laws[] = {
        "type linearElastic; rho 2700; E 70e9; nu 0.3;",
        "type neoHookean; rho 2700; E 70e9; nu 0.3;",
        J2("hardening power; B 292e6; n 0.31;"),
        "type JohnsonCook; C 0.025; m 1.09; beta 0.9; " + copper
            + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }"
              " bulkViscosity { linear 0.06; quadratic 1.5; }",
        "type DruckerPrager; match inner; dilationAngle 10;" + soil,
        "type MohrCoulomb; dilationAngle 10; tensionCutoff 8e3;" + soil,
        grains(""),
        grains("dilatancy { phiC 0.58; K2 0.2; K3 4; }"),
        "type MooneyRivlin; rho 1000; c10 1e6; c01 3e5; K 1e8;",
        "type NewtonianFluid; rho 1000; mu 0.1; K 2e9;"};
    for (const std::string& text : laws)
        for (const scalar size : {-1e-4, -0.05})
        {
            const auto law(lawOf(text));
            points plane(2, 7, law->rho()), full(3, 7, law->rho());
            plane.dt = full.dt = 1e-6;
            law->start(*std::make_unique<pointBlock>(plane.block()));
            law->start(*std::make_unique<pointBlock>(full.block()));
            scalar largest = 0;
            for (int step = 0; step < 6; ++step)
            {
                const scalar a = size * std::cos(step), b = size * std::sin(2 * step);
                const scalar hoop = size * std::cos(3 * step);
                full.apply(*law, {a, b, 0, -2 * b, -a / 2, 0, 0, 0, hoop});

                const scalar L[] = {a, b, -2 * b, -a / 2};
                for (int i = 0; i < 4; ++i)
                {
                    std::fill(plane.dL[i].begin(), plane.dL[i].end(), L[i]);
                }
                const std::vector<scalar> h(plane.n, hoop);
                for (scalar& v : plane.volume)
                    v *= std::exp(a / 2 + hoop);
                pointBlock block(plane.block());
                block.hoop = h.data();
                law->correct(block);

                for (int i = 0; i < 4; ++i)
                {
                    largest = max(largest, std::abs(full.stress[i][2]));
                }
                for (int i = 0; i < 4; ++i)
                    for (label p = 0; p < plane.n; ++p)
                    {
                        INFO(text);
                        CHECK(std::abs(plane.stress[i][p] - full.stress[i][p]) <= 1e-10 * largest);
                    }
            }
            CHECK(largest > 0);
        }
}

TEST_CASE("split laws: initial stress")
{
    const std::string laws[] = {
        J2("hardening none;"),
        "type JohnsonCook; C 0.025; m 1.09; beta 0.9; " + copper
            + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }",
        "type DruckerPrager; match outer; dilationAngle 0; rho 1; E 1e10; nu 0.2;"
        " cohesion 1e9; frictionAngle 20;",
        "type MohrCoulomb; dilationAngle 0; rho 1; E 1e10; nu 0.2;"
        " cohesion 1e9; frictionAngle 20;",
        "type MooneyRivlin; rho 1000; c10 1e8; c01 3e7; K 1e10;"};
    for (const std::string& text : laws)
        for (int D = 1; D <= 3; ++D)
        {
            const auto law(lawOf(text));
            points p(D, 9, law->rho());
            for (label i = 0; i < p.n; ++i)
            {
                p.stress[0][i] = 4e7 - 5e6 * i;
                p.stress[1][i] = -1e7;
                p.stress[2][i] = 2e7;
                for (int k = 3; k < nStress(D); ++k)
                    p.stress[k][i] = 3e6 * k;
            }
            const auto before(p.stress);
            pointBlock b(p.block());
            law->start(b);
            law->initialise(b);
            p.apply(*law, std::vector<scalar>(9, 0));
            for (int k = 0; k < nStress(D); ++k)
                for (label i = 0; i < p.n; ++i)
                {
                    CHECK(std::abs(p.stress[k][i] - before[k][i]) <= 1e-9 * 4e7);
                }
        }
    const auto gas(lawOf("type NewtonianFluid; rho 1.2; mu 0;"
                         " equationOfState { type perfectGas; gamma 1.4; p0 1e5; }"));
    points p(2, 3, 1.2);
    for (int k = 0; k < 3; ++k)
        p.stress[k][1] = -3e5;
    for (int k = 0; k < 3; ++k)
        p.stress[k][0] = p.stress[k][2] = -1e5;
    pointBlock b(p.block());
    gas->start(b);
    gas->initialise(b);
    p.apply(*gas, std::vector<scalar>(9, 0));
    CHECK(p.stress[1][1] == doctest::Approx(-3e5).epsilon(1e-12));
    p.stress[0][1] = 1e5;
    CHECK_THROWS_AS(gas->initialise(b), Foam::error);
}

TEST_CASE("points of a block do not see each other")
{
    for (const std::string& text :
         {J2("hardening power; B 292e6; n 0.31;"),
          "type JohnsonCook; C 0.025; m 1.09; beta 0.9; " + copper
              + "equationOfState { type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02; }",
          "type MohrCoulomb; dilationAngle 10;" + soil,
          grains("dilatancy { phiC 0.58; K2 0.2; K3 4; }"),
          std::string("type NewtonianFluid; rho 1000; mu 1; K 2e9;")})
        for (int D = 1; D <= 3; ++D)
        {
            const auto law(lawOf(text));
            points all(D, 300, law->rho());
            all.dt = 1e-6;
            pointBlock b(all.block());
            law->start(b);
            for (label i = 0; i < all.n; ++i)
            {
                all.dL[0][i] = 0.1 * std::sin(1.0 * i);
                if (D > 1)
                    all.dL[1][i] = 1e-3 * (i % 17);
            }
            law->correct(b);
            for (const label i : {0, 1, 126, 127, 128, 131, 299})
            {
                points one(D, 1, law->rho());
                one.dt = 1e-6;
                pointBlock b1(one.block());
                law->start(b1);
                for (int k = 0; k < D * D; ++k)
                    one.dL[k][0] = all.dL[k][i];
                law->correct(b1);
                for (int k = 0; k < nStress(D); ++k)
                {
                    CHECK(std::abs(one.stress[k][0] - all.stress[k][i]) <= 1e-12 * K);
                }
            }
        }
}

TEST_CASE("input errors of plastic laws and fluids")
{
    for (const std::string& text :
         {J2("hardening none; yield -1;"),
          J2("hardening soft;"),
          J2("hardening linear;"),
          J2("hardening linear; H -1;"),
          J2("hardening none; H 1;"),
          J2("hardening power; B 1; n 1.5;"),
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
          std::string("type MohrCoulomb; rho 1; E 1; nu 0.3; cohesion -1; frictionAngle 0; "
                      "dilationAngle 0;"),
          grains("viscosity 0;"),
          grains("cohesion 1;"),
          grains("dilatancy { phiC 0.58; K2 0.2; }"),
          grains("dilatancy { phiC 0.58; K2 0.2; K3 4; K1 1; }"),
          std::string("type muI; rho 1; E 1; nu 0; muS 0.4; mu2 0.3; I0 1; d 1; packing 0.6;"),
          std::string("type muI; rho 1; E 1; nu 0; muS 0.4; mu2 0.6; I0 0; d 1; packing 0.6;"),
          std::string("type muI; rho 1; E 1; nu 0; muS 0.4; mu2 0.6; I0 1; packing 0.6;"),
          std::string("type muI; rho 1; E 1; nu 0; muS 0.4; mu2 0.6; I0 1; d 1; packing 2;"),
          std::string("type MooneyRivlin; rho 1; c10 -1; c01 0; K 1;"),
          std::string("type MooneyRivlin; rho 1; c10 1; c01 0; K 1; E 2;"),
          std::string("type NewtonianFluid; rho 1; mu -1; K 1;"),
          std::string("type NewtonianFluid; rho 1; mu 1;"),
          std::string("type NewtonianFluid; rho 1; mu 1; K 1; G 1;")})
    {
        CAPTURE(text);
        CHECK_THROWS_AS(lawOf(text), Foam::IOerror);
    }
}
