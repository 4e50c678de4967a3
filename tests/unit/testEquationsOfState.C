// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "equationOfState.H"
#include "laneMath.H"
#include "IFstream.H"
#include "IStringStream.H"
#include "OSspecific.H"
#include <cmath>
#include <string>
#include <vector>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

autoPtr<equationOfState> equation(const std::string& text, const scalar rho0)
{
    IStringStream is(text);
    return equationOfState::New(dictionary(is), rho0);
}

//- A file of etc/materials
dictionary material(const std::string& name)
{
    IFstream is(getEnv("MPM_PROJECT_DIR") / "etc/materials" / name);
    return dictionary(is);
}

const char* const all[] = {
    "type linear; K 140e9;",
    "type Tait; K 2.15e9; n 7.15; p0 1e5;",
    "type perfectGas; gamma 1.4; p0 1e5;",
    "type stiffenedGas; gamma 4.4; pInf 6e8; p0 1e5;",
    "type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02;",
    "type MieGrueneisen; C0 3940; S 1.489; Gamma0 0;",
    "type JWL; A 371.2e9; B 3.231e9; R1 4.15; R2 0.95; omega 0.3; E0 7e9;",
    "type CochranChan; A 12.87e9; B 13.42e9; E1 4.1; E2 3.1; Gamma0 0.93; p0 1e5;",
    "type vanDerWaals; gamma 1.4; a 5; b 1e-4; p0 1e8;",
    "type nobleAbelStiffenedGas; gamma 1.19; pInf 7.028e8; b 3e-4; q -1177788; p0 1e5;"};

}

TEST_CASE("lanes: exp, log and power against the library's")
{
    scalar worstExp = 0, worstLog = 0, worstPow = 0;
    for (int i = 0; i < 20000; ++i)
    {
        lanes<8> x, y;
        for (int l = 0; l < 8; ++l)
        {
            x[l] = -700 + 1400 * (i + 0.125 * l) / 20000;
            y[l] = std::exp(0.5 * x[l]);
        }
        const lanes<8> e = laneExp(x), n = laneLog(y), w = lanePow(y, 0.31);
        for (int l = 0; l < 8; ++l)
        {
            worstExp = max(worstExp, std::abs(e[l] / std::exp(x[l]) - 1));
            worstLog = max(
                worstLog, std::abs(n[l] - std::log(y[l])) / max(std::abs(std::log(y[l])), 1e-3));
            worstPow = max(worstPow, std::abs(w[l] / std::pow(y[l], 0.31) - 1));
        }
    }
    CHECK(worstExp < 4e-16);
    CHECK(worstLog < 1e-15);
    CHECK(worstPow < 4e-14);
}

TEST_CASE("equations of state: slopes and sound speed by differences")
{
    for (const char* text : all)
    {
        const scalar rho0 = 1630;
        const auto eos(equation(text, rho0));
        for (const scalar x : {0.7, 0.9, 0.999, 1.001, 1.2, 1.5})
        {
            const scalar rho = x * rho0, d = 1e-6 * rho;
            const auto t(eos->at(rho)), up(eos->at(rho + d)), down(eos->at(rho - d));
            const scalar size = std::abs(t.dA) + 1e-9 * std::abs(t.A) / rho + 1;
            CHECK(
                std::abs((up.A - down.A) / (2 * d) - t.dA)
                <= 1e-6 * size + 1e-9 * std::abs(t.A) / d * 1e-3);
            CHECK((up.B - down.B) / (2 * d) == doctest::Approx(t.dB).epsilon(1e-6));

            // c^2 = dp/drho along de = p drho/rho^2
            const scalar e = 2e5 + eos->e0();
            const scalar p = eos->p(rho, e);
            const scalar de = p / (rho * rho) * d;
            const scalar c2 = (eos->p(rho + d, e + de) - eos->p(rho - d, e - de)) / (2 * d);
            if (c2 > 0)
            {
                CHECK(sqr(eos->c(rho, e)) == doctest::Approx(c2).epsilon(1e-5));
            }
            CHECK(eos->usesEnergy() == (t.B != 0));

            // Work of compression, Simpson's rule over 2000 steps
            if (!eos->usesEnergy())
            {
                const int n = 2000;
                scalar w = 0;
                for (int i = 0; i <= n; ++i)
                {
                    const scalar r = rho0 + (rho - rho0) * i / n;
                    w += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * eos->p(r, 0) / (r * r);
                }
                w *= (rho - rho0) / (3 * n);
                CHECK(eos->storedEnergy(rho) == doctest::Approx(w).epsilon(1e-8));
            }
        }
    }
}

TEST_CASE("MieGrueneisen: the Hugoniot, copper at 400 m/s 7.594 GPa")
{
    // Symmetric impact at 400 m/s: up 200 m/s, p = rho0 (C0 + S up) up
    const scalar rho0 = 8960, C0 = 3940, S = 1.489;
    const auto eos(equation("type MieGrueneisen; C0 3940; S 1.489; Gamma0 2.02;", rho0));
    for (const scalar up : {1.0, 200.0, 800.0, 2000.0})
    {
        const scalar Us = C0 + S * up;
        const scalar p = eos->p(rho0 * Us / (Us - up), 0.5 * up * up);
        CHECK(p == doctest::Approx(rho0 * Us * up).epsilon(1e-10));
        if (up == 200)
        {
            CHECK(p == doctest::Approx(7.594e9).epsilon(1e-4));
        }
    }
    CHECK(eos->c(rho0, 0) == doctest::Approx(C0).epsilon(1e-12));

    // Beyond the pole it still rises
    CHECK(eos->p(10 * rho0, 0) > eos->p(5 * rho0, 0));
    CHECK(std::isfinite(eos->p(1e6 * rho0, 0)));
}

TEST_CASE("stiffenedGas: isentrope of water from 1 GPa")
{
    // Water | air shock tube: star state 14.1905 MPa at 804.445 kg/m3 (exact
    // solver of the Riemann problem), sound speed gamma (p + pInf)/rho
    const auto eos(equation("type stiffenedGas; gamma 4.4; pInf 6e8; p0 1e9;", 1000));
    scalar rho = 1000, e = eos->e0();
    CHECK(eos->p(rho, e) == doctest::Approx(1e9).epsilon(1e-12));
    CHECK(eos->c(rho, e) == doctest::Approx(std::sqrt(4.4 * 1.6e6)).epsilon(1e-12));
    const int n = 20000;
    const scalar d = (804.445 - 1000) / n;
    for (int i = 0; i < n; ++i)
    {
        const scalar half = e + 0.5 * d * eos->p(rho, e) / sqr(rho);
        e += d * eos->p(rho + 0.5 * d, half) / sqr(rho + 0.5 * d);
        rho += d;
    }
    CHECK(eos->p(rho, e) == doctest::Approx(14.1905e6).epsilon(1e-4));
}

TEST_CASE("perfectGas and Tait: closed forms")
{
    const auto air(equation("type perfectGas; gamma 1.4; p0 101325;", 1.2));
    CHECK(air->p(1.2, air->e0()) == doctest::Approx(101325).epsilon(1e-12));
    CHECK(air->c(1.2, air->e0()) == doctest::Approx(std::sqrt(1.4 * 101325 / 1.2)).epsilon(1e-12));

    const auto water(equation("type Tait; K 2.15e9; n 7.15; p0 1e5;", 1000));
    CHECK(
        water->p(1100, 0)
        == doctest::Approx(1e5 + 2.15e9 / 7.15 * (std::pow(1.1, 7.15) - 1)).epsilon(1e-12));
    CHECK(water->c(1000, 0) == doctest::Approx(std::sqrt(2.15e6)).epsilon(1e-12));
}

TEST_CASE("JWL: explosives of etc/materials at the Chapman-Jouguet point")
{
    // Density, speed of detonation, pressure as published with the constants:
    // V from the Rayleigh line, e from the jump of the energy
    struct charge
    {
        const char* name;
        scalar rho0, D, p;
    };
    for (const charge& c :
         {charge{"TNT", 1630, 6930, 21e9}, charge{"C4", 1601, 8193, 28e9},
          charge{"PETN", 1770, 8300, 33.5e9}})
    {
        const dictionary dict(material(c.name));
        CHECK(dict.get<scalar>("rho") == c.rho0);
        const auto eos(equationOfState::New(dict.subDict("equationOfState"), c.rho0));
        const scalar V = 1 - c.p / (c.rho0 * c.D * c.D);
        const scalar e = eos->e0() + 0.5 * c.p * (1 - V) / c.rho0;
        CHECK(eos->p(c.rho0 / V, e) == doctest::Approx(c.p).epsilon(1e-3));

        // There the products' flow is sonic: c = D V
        CHECK(eos->c(c.rho0 / V, e) == doctest::Approx(c.D * V).epsilon(1e-3));
    }
}

TEST_CASE("CochranChan: energy of the start is that of the published Cv at 298 K")
{
    struct solid
    {
        const char* text;
        scalar rho0, Cv;
    };
    for (const solid& s :
         {solid{
              "type CochranChan; A 145.67e9; B 147.75e9; E1 2.99; E2 1.99;"
              " Gamma0 2; p0 1e5;",
              8900, 393},
          solid{all[7], 1840, 1087}})
    {
        const auto eos(equation(s.text, s.rho0));
        CHECK(eos->e0() / s.Cv == doctest::Approx(298).epsilon(0.01));
        CHECK(eos->coldEnergy(s.rho0) == 0);
        CHECK(eos->p(s.rho0, eos->e0()) == doctest::Approx(1e5).epsilon(1e-4));
    }

    // Copper's speed of sound: sqrt(K/rho) of 140 GPa within 5 %
    const auto copper(equation(
        "type CochranChan; A 145.67e9; B 147.75e9; E1 2.99; E2 1.99;"
        " Gamma0 2; p0 1e5;",
        8900));
    CHECK(copper->c(8900, copper->e0()) == doctest::Approx(3966).epsilon(0.05));
}

TEST_CASE("vanDerWaals, nobleAbelStiffenedGas: closed forms, limits, the pole")
{
    // Speeds of sound of the headers; p of the law with temperature
    const auto gas(equation("type vanDerWaals; gamma 1.4; a 5; b 1e-3; p0 1e5;", 50));
    const auto water(equation(
        "type nobleAbelStiffenedGas; gamma 1.19; pInf 7.028e8;"
        " b 6.61e-4; q -1177788; p0 1e5;",
        1050));
    for (const scalar p : {1e5, 1e7, 1e9})
    {
        const scalar rho = 60, v = 1 - 1e-3 * rho, e = gas->e(rho, p);
        const scalar K = 1.4 * (p + 5 * rho * rho) / v - 2 * 5 * rho * rho;
        CHECK(rho * gas->c2(rho, e) == doctest::Approx(K).epsilon(1e-12));
        const scalar thermal = e - gas->coldEnergy(rho);
        CHECK(
            0.4 * thermal / (1 / rho - 1e-3) - 5 * rho * rho == doctest::Approx(p).epsilon(1e-12));

        const scalar r = 1050, w = 1 - 6.61e-4 * r, f = water->e(r, p);
        CHECK(water->c2(r, f) == doctest::Approx(1.19 * (p + 7.028e8) / (r * w)).epsilon(1e-12));

        // v = b + (gamma - 1) Cv T/(p + pInf), Cv 3610 J/kg/K
        const scalar T = (f - water->coldEnergy(r)) / 3610;
        CHECK(1 / r == doctest::Approx(6.61e-4 + 0.19 * 3610 * T / (p + 7.028e8)).epsilon(1e-10));
    }

    // Without a, b, q: perfectGas, stiffenedGas
    const auto thin(equation("type vanDerWaals; gamma 1.4; a 0; b 0; p0 1e5;", 1.2));
    const auto air(equation("type perfectGas; gamma 1.4; p0 1e5;", 1.2));
    CHECK(thin->p(2, 3e5) == air->p(2, 3e5));
    CHECK(thin->c(2, 3e5) == doctest::Approx(air->c(2, 3e5)).epsilon(1e-14));
    const auto plain(equation(
        "type nobleAbelStiffenedGas; gamma 4.4; pInf 6e8; b 0; q 0;"
        " p0 1e5;",
        1000));
    const auto stiff(equation(all[3], 1000));
    CHECK(plain->p(1100, plain->e0()) == stiff->p(1100, stiff->e0()));
    scalar gamma = 0, pInf = 0;
    CHECK(plain->isStiffened(gamma, pInf));
    CHECK(gamma == 4.4);
    CHECK(!water->isStiffened(gamma, pInf));

    // Pressure rises up to the pole and beyond
    for (const auto* eos : {&gas, &water})
    {
        scalar last = -GREAT;
        const scalar e = (*eos)->e0();
        for (scalar rho = 900; rho < 4000; rho *= 1.01)
        {
            const scalar p = (*eos)->p(rho, e);
            CHECK(p > last);
            CHECK((*eos)->c2(rho, e) > 0);
            last = p;
        }
    }
}

TEST_CASE("equations of state: the state of a pressure")
{
    for (const char* text : all)
    {
        const auto eos(equation(text, 1630));
        for (const scalar p : {2e5, 1e7, 5e8})
        {
            scalar rho, e;
            CHECK(eos->stateOf(p, rho, e));
            CHECK(eos->p(rho, e) == doctest::Approx(p).epsilon(1e-9));
            CHECK((rho == 1630) == eos->pressureByEnergy());
        }
    }
    scalar rho, e;
    CHECK(!equation(all[2], 1)->stateOf(-1, rho, e));
    CHECK(!equation(all[1], 1)->stateOf(-1e12, rho, e));
}

TEST_CASE("equations of state: runs, energy of a pressure, density of a pressure")
{
    // More than one run of the functions
    const label n = 600;
    for (const char* text : all)
    {
        const scalar rho0 = 1630;
        const auto eos(equation(text, rho0));
        std::vector<scalar> rho(n), e(n), p(n), c2(n), Gamma(n), back(n), again(n);
        for (label i = 0; i < n; ++i)
        {
            rho[i] = rho0 * (0.8 + 0.5 * i / n);
            e[i] = eos->usesEnergy() ? eos->e0() + 1e5 + 100 * i : 0;
        }
        eos->pressures(n, rho.data(), e.data(), p.data(), c2.data(), Gamma.data());
        eos->energies(n, rho.data(), p.data(), back.data(), again.data(), Gamma.data());
        scalar worst = 0;
        for (label i = 0; i < n; ++i)
        {
            const auto t(eos->at(rho[i]));
            const scalar size = std::abs(t.A) + std::abs(t.B * e[i]) + 1;
            worst = max(worst, std::abs(p[i] - eos->p(rho[i], e[i])) / size);
            worst = max(worst, std::abs(c2[i] - eos->c2(rho[i], e[i])) * rho[i] / size);
            worst = max(worst, std::abs(Gamma[i] - t.B / rho[i]));
            worst = max(worst, std::abs(t.B * (back[i] - e[i])) / size);
            worst = max(worst, std::abs(t.B * (eos->e(rho[i], p[i]) - e[i])) / size);
        }
        CHECK(worst < 1e-14);

        if (!eos->usesEnergy())
        {
            // From far off, and none where there is none
            std::vector<scalar> found(n, 0.3 * rho0);
            found[1] = 4 * rho0;
            eos->densities(n, p.data(), found.data());
            scalar off = 0;
            for (label i = 0; i < n; ++i)
            {
                off = max(off, std::abs(found[i] / rho[i] - 1));
            }
            CHECK(off < 1e-14);
            const scalar low = -1e12;
            found[0] = rho0;
            eos->densities(1, &low, found.data());
            CHECK(found[0] <= 0);
        }
    }
}

TEST_CASE("equations of state: the cold curve is an isentrope")
{
    for (const char* text : all)
    {
        const auto eos(equation(text, 1630));
        if (!eos->hasTemperature())
        {
            continue;
        }
        for (const scalar rho : {800.0, 1630.0, 2000.0})
        {
            const scalar d = 1e-5 * rho;
            const scalar slope = (eos->coldEnergy(rho + d) - eos->coldEnergy(rho - d)) / (2 * d);
            const scalar p = eos->p(rho, eos->coldEnergy(rho));
            const scalar size = std::abs(eos->at(rho).A) + 1;
            CHECK(std::abs(slope * rho * rho - p) <= 1e-8 * size);
        }
    }
}

TEST_CASE("equations of state: input errors")
{
    for (const char* text :
         {"type glue;",
          "type linear; K -1;",
          "type linear; K 1; n 2;",
          "type Tait; K 1; n 7;",
          "type Tait; K 1; n 0.5; p0 0;",
          "type perfectGas; gamma 1; p0 1;",
          "type perfectGas; gamma 1.4; p0 0;",
          "type stiffenedGas; gamma 4.4; p0 0;",
          "type MieGrueneisen; C0 3940; S -1; Gamma0 2;",
          "type MieGrueneisen; S 1; Gamma0 2;",
          "type JWL; A 1; B 1; R1 4; R2 1; omega 0.3; E0 -1;",
          "type CochranChan; A 1; B 1; E1 1; E2 2; Gamma0 1; p0 0;",
          "type CochranChan; A 1; B 1; E1 2; E2 2; Gamma0 1; p0 -1;",
          "type CochranChan; A 1; B 1; R1 2; R2 2; Gamma0 1; p0 0;",
          "type vanDerWaals; gamma 1.4; a 1; b 1; p0 1;",
          "type vanDerWaals; gamma 1.4; a 1; b 0; p0 0.1;",
          "type vanDerWaals; gamma 1.4; b 0; p0 1;",
          "type nobleAbelStiffenedGas; gamma 1.19; pInf 1; b 1; q 0; p0 0;",
          "type nobleAbelStiffenedGas; gamma 1.19; pInf -1; b 0; q 0; p0 0;",
          "type nobleAbelStiffenedGas; gamma 1.19; pInf 1; b 0; p0 0;"})
    {
        CHECK_THROWS_AS(equation(text, 1), Foam::IOerror);
    }
}
