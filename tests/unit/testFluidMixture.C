// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "fluidMixture.H"
#include "IFstream.H"
#include "IStringStream.H"
#include "OSspecific.H"
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

//- A fluid of the tests: densities, and energies above the cold ones, that it
//  may have at pressures of 1 kPa to 10 GPa; can it fill any volume
struct kind
{
    const char* text;
    scalar least, most, coldest, hottest;
    bool gas;
};

//- van der Waals' gas from three times its critical temperature on (colder, it
//  would condense in expansion, and there is no state), solids below melting
const std::vector<kind> kinds = {
    {"thermo perfectGas; R 287; gamma 1.4;", 1e-2, 1e3, 0, 5e7, true},
    {"rho 1000; equationOfState { type stiffenedGas; gamma 4.4; pInf 6e8;"
     " p0 1e5; }",
     800, 1300, 0, 5e7, false},
    {"rho 1630; equationOfState { type JWL; A 371.2e9; B 3.231e9; R1 4.15;"
     " R2 0.95; omega 0.3; E0 7e9; }",
     1, 2000, 0, 5e7, true},
    {"rho 8900; equationOfState { type CochranChan; A 145.67e9; B 147.75e9;"
     " E1 2.99; E2 1.99; Gamma0 2; p0 1e5; }",
     8700, 10500, 0, 4e5, false},
    {"rho 1840; equationOfState { type CochranChan; A 12.87e9; B 13.42e9;"
     " E1 4.1; E2 3.1; Gamma0 0.93; p0 1e5; }",
     1700, 2600, 0, 6e5, false},
    {"rho 8960; equationOfState { type MieGrueneisen; C0 3940; S 1.489;"
     " Gamma0 2.02; }",
     8800, 10500, 0, 5e7, false},
    {"rho 50; equationOfState { type vanDerWaals; gamma 1.4; a 5; b 1e-3;"
     " p0 1e5; }",
     0.1, 900, 3 * 8 * 5 / (27 * 1e-3 * 0.4), 5e7, true},
    {"rho 1050; equationOfState { type nobleAbelStiffenedGas; gamma 1.19;"
     " pInf 7.028e8; b 6.61e-4; q -1177788; p0 1e5; }",
     900, 1300, 0, 5e7, false}};

struct mixture
{
    autoPtr<fluidMixture> fluids;

    explicit mixture(const std::vector<label>& which)
    {
        std::string text;
        wordList names;
        for (const label k : which)
        {
            names.append("f" + std::to_string(names.size()));
            text += names.last() + " { type fluid; " + kinds[k].text + " }\n";
        }
        IStringStream is(text);
        fluids.reset(new fluidMixture(dictionary(is), names));
    }
};

std::mt19937_64 generator(7);

scalar between(const scalar a, const scalar b)
{
    return std::uniform_real_distribution<scalar>(a, b)(generator);
}

//- Uniform in the logarithm
scalar spread(const scalar a, const scalar b)
{
    return std::exp(between(std::log(a), std::log(b)));
}

//- Density that the kind may have at a pressure; -1: none was found
scalar density(const fluidMixture& f, const label k, const kind& of, const scalar p)
{
    const gasThermo& thermo = f.thermo(k);
    const bool cold = !thermo.isGammaLaw() && thermo.equation().hasTemperature();
    for (int i = 0; i < 2000; ++i)
    {
        const scalar rho = spread(of.least, of.most);
        const auto t(f.at(k, rho));
        const scalar e = (p - t.A) / t.B;
        const scalar warm = e - (cold ? thermo.equation().coldEnergy(rho) : 0);
        if (fluidMixture::c2(t, rho, p) > 0 && warm > of.coldest && warm < of.hottest)
        {
            return rho;
        }
    }
    return -1;
}

//- The worst of many relaxations
struct measured
{
    scalar theta = 0, energy = 0, pressure = 0, looks = 0;
    label runs = 0, most = 0;
    bool positive = true;
};

//- Relax and measure: sum of the volumes, energy of each over the largest of
//  its terms, pressure over P and Wood's modulus (P: the known one, or 0)
void relax(
    const fluidMixture& f, const std::vector<fluidMixture::share>& s, const scalar theta,
    const scalar P, measured& worst)
{
    std::vector<scalar> thetas(f.size());
    label looks = 0;
    const scalar p = f.relax(s.data(), theta, thetas.data(), &looks);
    worst.looks += looks;
    worst.most = max(worst.most, looks);
    ++worst.runs;
    scalar sum = 0, soft = 0;
    for (label k = 0; k < f.size(); ++k)
    {
        sum += thetas[k];
        const scalar rho = s[k].m / thetas[k];
        const auto t(f.at(k, rho));
        const scalar K = rho * fluidMixture::c2(t, rho, p);
        worst.positive = worst.positive && thetas[k] > 0 && K > 0;
        const scalar e = thetas[k] * fluidMixture::energy(t, rho, p);
        const scalar size =
            thetas[k] * (std::abs(t.A * rho / t.B) + K) + std::abs(s[k].e0) + std::abs(p * s[k].A);
        const scalar error = std::abs(e - s[k].e0 + p * (thetas[k] - s[k].A)) / size;
        worst.energy = error <= worst.energy ? worst.energy : error;
        soft += thetas[k] / K;
    }
    worst.theta = max(worst.theta, std::abs(sum / theta - 1));
    if (P > 0)
    {
        worst.pressure = max(worst.pressure, std::abs(p - P) / (sum / soft + P));
    }
}

//- Shares of a random state of all at one pressure P, their volumes A moved
//  off, or each at a pressure of its own (P 0); false: none was found. gentle:
//  as between two steps of a run
bool state(
    const fluidMixture& f, const std::vector<label>& which, const scalar P, const bool tiny,
    const bool gentle, std::vector<fluidMixture::share>& s, scalar& theta)
{
    theta = 0;
    bool gas = false;
    for (size_t k = 0; k < which.size(); ++k)
    {
        const kind& of = kinds[which[k]];
        gas = gas || of.gas;
        const scalar p = P > 0 ? P : spread(1e3, 1e10);
        const scalar rho = density(f, k, of, p);
        if (rho < 0)
        {
            return false;
        }
        const scalar part = k + 1 == which.size() ? 1 : tiny ? spread(1e-8, 1) : between(0.01, 1);
        const scalar off = gentle ? 1e-3 : of.gas ? 0.2 : 0.02;
        const scalar e = fluidMixture::energy(f.at(k, rho), rho, p);
        s[k].m = part * rho;
        s[k].A = part * (1 + (P > 0 ? between(-off, off) : 0));
        s[k].e0 = part * e + (P > 0 ? p * (part - s[k].A) : 0);
        theta += part;
    }

    // Liquids alone are only compressed
    theta *= P > 0 ? 1 : between(0.98, gas ? 1.02 : 1);
    return true;
}

}

TEST_CASE("fluidMixture: relaxation of all pairs and triples to one pressure")
{
    const label n = kinds.size();
    std::vector<std::vector<label>> all;
    for (label i = 0; i < n; ++i)
    {
        for (label j = i; j < n; ++j)
        {
            all.push_back({i, j});
            for (label k = j; k < n; ++k)
            {
                all.push_back({i, j, k});
            }
        }
    }
    label made = 0;
    scalar looks = 0, gentleLooks = 0, others = 0;
    for (const auto& which : all)
    {
        const mixture m(which);
        const fluidMixture& f = *m.fluids;
        label curved = 0;
        std::string name;
        for (size_t k = 0; k < which.size(); ++k)
        {
            curved += !f.isStiff(k);
            name += " " + std::to_string(which[k]);
        }
        measured known, own, gentle;
        std::vector<fluidMixture::share> s(which.size());
        scalar theta = 0;
        for (int run = 0; run < 200; ++run)
        {
            const bool tiny = run % 2;
            scalar P = spread(1e3, 1e10);
            if (state(f, which, P, tiny, false, s, theta))
            {
                relax(f, s, theta, P, known);
            }
            if (state(f, which, 0, tiny, false, s, theta))
            {
                relax(f, s, theta, 0, own);
            }
            P = spread(1e4, 1e10);
            if (state(f, which, P, tiny, true, s, theta))
            {
                relax(f, s, theta, P, gentle);
            }
        }
        for (const measured* of : {&known, &own, &gentle})
        {
            INFO("fluids", name, ", kind of states ", of == &known ? 0 : of == &own ? 1 : 2);
            CHECK(of->runs > 20);
            CHECK(of->theta < 1e-15);
            CHECK(of->energy < 1e-12);
            CHECK(of->pressure < 1e-12);
            CHECK(of->positive);

            // Enclosed states included
            CHECK(of->most <= 400 * curved);
            CHECK((of->most > 0) == (curved > 0));
            made += of->runs;
        }
        CHECK(gentle.looks <= 5.0 * curved * gentle.runs);
        looks += known.looks + own.looks;
        gentleLooks += gentle.looks;
        others += scalar(curved) * gentle.runs;
    }
    MESSAGE(
        made << " relaxations; evaluations of an equation of state that is no"
             << " stiffened gas: " << gentleLooks / others << " per fluid where volumes"
             << " are 0.1 % off");
}

TEST_CASE("fluids of etc/materials: states of the start, alone and together")
{
    const wordList names({"TNT", "C4", "PETN", "water", "air"});
    dictionary all;
    for (const word& name : names)
    {
        IFstream is(getEnv("MPM_PROJECT_DIR") / "etc/materials" / name);
        all.add(name, dictionary(is));
    }
    const fluidMixture f(all, names);
    std::vector<fluidMixture::share> s;
    for (label k = 0; k < f.size(); ++k)
    {
        const bool isAir = names[k] == "air";
        const scalar rho = isAir ? 1.2 : f.rho0(k);
        const auto t(f.at(k, rho));
        const scalar e = isAir ? 1e5 / t.B : f.thermo(k).equation().e0();
        const scalar p = t.A + t.B * e;
        s.push_back({0.2, 0.2 * rho, 0.2 * rho * e});

        // c of water and air as known, of products at constant volume 5 km/s
        const scalar c = std::sqrt(fluidMixture::c2(t, rho, p));
        CHECK(
            c
            == doctest::Approx(
                   isAir                     ? 341.6
                       : names[k] == "water" ? 1625
                                             : 5000)
                   .epsilon(isAir || names[k] == "water" ? 1e-3 : 0.25));
    }
    std::vector<scalar> thetas(f.size());
    const scalar p = f.relax(s.data(), 1, thetas.data());
    CHECK(p > 1e5);
    for (const scalar theta : thetas)
    {
        CHECK(theta > 0);
    }
}

TEST_CASE("explosive that burns: pressure, slopes, relaxation with a gas")
{
    IStringStream is("tnt { type fluid; rho 1630; equationOfState { type JWL; A 371.2e9;"
                     " B 3.231e9; R1 4.15; R2 0.95; omega 0.3; E0 7e9; } detonation { type"
                     " programmedBurn; points ((0 0 0)); velocity 6930; K 1e10; n 7; } }"
                     " air { type fluid; thermo perfectGas; R 287; gamma 1.4; }");
    const fluidMixture f(dictionary(is), wordList({"tnt", "air"}));
    const scalar rho0 = 1630, q = 7e9 / rho0;
    const equationOfState& products = f.thermo(0).equation();

    // Unburnt at rest: no pressure with q alone, the bulk modulus; burnt: JWL
    const auto start(f.at(0, rho0, 0));
    CHECK(std::abs(start.A + start.B * q) < 1e-5);
    CHECK(rho0 * fluidMixture::c2(start, rho0, 0) == doctest::Approx(1e10));
    CHECK(f.at(0, 1500, 1).A == products.at(1500).A);

    // Cold compression of the unburnt follows Murnaghan
    scalar e = q;
    const int n = 20000;
    for (int i = 0; i < n; ++i)
    {
        const scalar rho = rho0 * (1 + 0.3 * (i + 0.5) / n);
        e += 1e10 / 7 * (std::pow(rho / rho0, 7) - 1) / sqr(rho) * 0.3 * rho0 / n;
    }
    const auto pressed(f.at(0, 1.3 * rho0, 0));
    CHECK(
        pressed.A + pressed.B * e
        == doctest::Approx(1e10 / 7 * (std::pow(1.3, 7) - 1)).epsilon(1e-7));

    for (const scalar F : {0.0, 0.005, 0.4, 0.99, 1.0})
    {
        for (const scalar x : {0.3, 0.8, 0.995, 1.1, 1.6})
        {
            const scalar rho = x * rho0, d = 1e-5 * rho;
            const auto t(f.at(0, rho, F));
            const auto up(f.at(0, rho + d, F)), down(f.at(0, rho - d, F));
            const scalar size = std::abs(t.A) / rho + 1e10 / rho0;
            CHECK(std::abs((up.A - down.A) / (2 * d) - t.dA) < 1e-7 * size);
            CHECK(std::abs((up.B - down.B) / (2 * d) - t.dB) < 1e-9);
        }
    }

    for (int i = 0; i < 2000; ++i)
    {
        const scalar F = i % 4 ? between(0, 1) : i % 8 / 4, A = spread(1e-6, 0.999);
        const scalar p = spread(1e5, 2e10), rho = rho0 * between(1, 1.3);
        const auto own(f.at(0, rho, F));
        const scalar air = spread(1, 50);
        const fluidMixture::share s[] = {
            {A, A * rho, A * fluidMixture::energy(own, rho, p), F},
            {1 - A, (1 - A) * air, (1 - A) * 1e5 / 0.4, 1}};
        scalar theta[2];
        bool common = false;
        const scalar P = f.relax(s, 1, theta, nullptr, &common);
        CHECK(common);
        CHECK(theta[0] + theta[1] == doctest::Approx(1).epsilon(1e-14));
        const scalar r = s[0].m / theta[0];
        const scalar eps = theta[0] * fluidMixture::energy(f.at(0, r, F), r, P);
        CHECK(eps == doctest::Approx(s[0].e0 - P * (theta[0] - A)).epsilon(1e-9));
    }
}

TEST_CASE("products that burn on: exact over a step of constant pressure, in parts as at once")
{
    const auto law = [](const std::string& entries)
    {
        IStringStream is(
            "tnt { type fluid; rho 1630; equationOfState { type JWL; A 371.2e9;"
            " B 3.231e9; R1 4.15; R2 0.95; omega 0.3; E0 7e9; } afterburn { type"
            " Miller; Q 1e7; "
            + entries + " } }");
        return autoPtr<fluidMixture>(new fluidMixture(dictionary(is), wordList({"tnt"})));
    };
    const scalar a = 95.4, p = 3e6;
    for (const scalar m : {0.0, 0.5, 1.0, 1.7})
    {
        const auto f(law("a 95.4; m " + std::to_string(m) + ";"));
        const afterburn& on = *f->burnsOn(0);
        CHECK(on.Q() == 1e7);

        // By its slope, with n = 1/6
        const scalar x = 0.3, dt = 1e-9;
        const scalar slope = a * std::pow(1 - x, m) * std::pow(p, 1.0 / 6);
        CHECK((on.burn(x, p, dt) - x) / dt == doctest::Approx(slope).epsilon(1e-5));

        scalar parts = x;
        for (int i = 0; i < 100; ++i)
        {
            parts = on.burn(parts, p, 2e-6);
        }
        CHECK(parts == doctest::Approx(on.burn(x, p, 2e-4)).epsilon(1e-12));

        // It ends, or never does; nothing burns without pressure
        CHECK((on.burn(x, p, 0.01) == 1) == (m < 1));
        CHECK(on.burn(1, p, 1) == 1);
        CHECK(on.burn(x, -p, 1) == doctest::Approx(x).epsilon(1e-14));
    }
    CHECK(law("a 1;")->detonates(0) == nullptr);
}
