/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "fluidMixture.H"
#include "IStringStream.H"
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

//- A fluid of the tests and its densities at pressures of 1 kPa to 10 GPa
struct kind
{
    const char* text;
    scalar least, most;
};

const std::vector<kind> kinds =
{
    {"thermo perfectGas; R 287; gamma 1.4;", 1e-2, 1e3},
    {"rho 1000; equationOfState { type stiffenedGas; gamma 4.4; pInf 6e8;"
     " p0 1e5; }", 800, 1300},
    {"rho 1630; equationOfState { type JWL; A 371.2e9; B 3.231e9; R1 4.15;"
     " R2 0.95; omega 0.3; E0 7e9; }", 1, 2000},
    {"rho 8900; equationOfState { type CochranChan; A 145.67e9; B 147.75e9;"
     " E1 2.99; E2 1.99; Gamma0 2; p0 1e5; }", 8700, 10500},
    {"rho 1840; equationOfState { type CochranChan; A 12.87e9; B 13.42e9;"
     " E1 4.1; E2 3.1; Gamma0 0.93; p0 1e5; }", 1700, 2600},
    {"rho 8960; equationOfState { type MieGrueneisen; C0 3940; S 1.489;"
     " Gamma0 2.02; }", 8800, 10500},
    {"rho 50; equationOfState { type vanDerWaals; gamma 1.4; a 5; b 1e-3;"
     " p0 1e5; }", 0.1, 900},
    {"rho 1050; equationOfState { type nobleAbelStiffenedGas; gamma 1.19;"
     " pInf 7.028e8; b 6.61e-4; q -1177788; p0 1e5; }", 900, 1300}
};

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

std::mt19937_64 random(7);

scalar between(const scalar a, const scalar b)
{
    return std::uniform_real_distribution<scalar>(a, b)(random);
}

//- Uniform in the logarithm
scalar spread(const scalar a, const scalar b)
{
    return std::exp(between(std::log(a), std::log(b)));
}

//- Density that the kind may have at a pressure
scalar density(const fluidMixture& f, const label k, const kind& of, const scalar p)
{
    for (int i = 0; i < 1000; ++i)
    {
        const scalar rho = spread(of.least, of.most);
        const auto t(f.at(k, rho));
        const scalar e = (p - t.A)/t.B;
        const scalar c2 = fluidMixture::c2(t, rho, p);

        // Not colder than cold, no gas of 1e5 K
        if (c2 > 1e4 && c2 < 1e8 && std::abs(e) < 5e7)
        {
            return rho;
        }
    }
    return -1;
}

struct found
{
    scalar theta = 0, energy = 0, pressure = 0;
    label looks = 0, runs = 0, most = 0, refused = 0;
    bool positive = true;
};

//- Relax and measure: sum of the volumes, energy of each over rho c^2, from
//  shares of their own pressure; P: the known pressure or 0
void relax
(
    const fluidMixture& f,
    const std::vector<fluidMixture::share>& s,
    const scalar theta,
    const scalar guess,
    const scalar P,
    found& worst
)
{
    const label n = f.size();
    std::vector<scalar> thetas(n), rho(n);
    for (label k = 0; k < n; ++k)
    {
        rho[k] = s[k].m/s[k].A;
    }
    label looks = 0;
    const scalar p = f.relax(s.data(), theta, thetas.data(), &looks);
    worst.looks += looks;
    worst.most = max(worst.most, looks);
    ++worst.runs;
    scalar sum = 0, stiff = 0;
    scalar energy = 0, soft = 0;
    for (label k = 0; k < n; ++k)
    {
        sum += thetas[k];
        const scalar r = s[k].m/thetas[k];
        const auto t(f.at(k, r));
        const scalar K = r*fluidMixture::c2(t, r, p);
        worst.positive = worst.positive && thetas[k] > 0 && K > 0;
        const scalar e = thetas[k]*fluidMixture::energy(t, r, p);
        const scalar size =
            thetas[k]*(std::abs(t.A*r/t.B) + K) + std::abs(s[k].e0)
          + std::abs(p*s[k].A);
        energy = max
        (
            energy,
            std::abs(e - s[k].e0 + p*(thetas[k] - s[k].A))/size
        );
        soft += thetas[k]/K;
        stiff = max(stiff, K);
    }
    if (!(energy <= 1e-9) || !(std::abs(sum/theta - 1) < 1e-9)) ++worst.refused;
    worst.energy = energy <= worst.energy ? worst.energy : energy;
    worst.theta = max(worst.theta, std::abs(sum/theta - 1));
    if (P > 0)
    {
        worst.pressure = max
        (
            worst.pressure,
            std::abs(p - P)/(theta/soft + P)
        );
    }
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
    for (const auto& which : all)
    {
        const mixture m(which);
        const fluidMixture& f = *m.fluids;
        found known, own;
        for (int run = 0; run < 200; ++run)
        {
            // Known: all at P, volumes A moved off by up to 20 % (5 % of
            // liquids and solids). Own: each starts at a pressure of its own
            for (const bool isKnown : {true, false})
            {
                std::vector<fluidMixture::share> s(which.size());
                const scalar P = spread(1e3, 1e10);
                scalar theta = 0;
                bool made = true;
                for (size_t k = 0; k < which.size(); ++k)
                {
                    const scalar p = isKnown ? P : spread(1e3, 1e10);
                    const scalar r = density(f, k, kinds[which[k]], p);
                    made = made && r > 0;
                    const scalar part =
                        k + 1 == which.size() ? 1
                      : run % 2 ? spread(1e-8, 1) : between(0.01, 1);
                    const auto t(f.at(k, r));
                    const scalar e = fluidMixture::energy(t, r, p);
                    const scalar off =
                        kinds[which[k]].most > 2*kinds[which[k]].least ? 0.2
                      : 0.02;
                    s[k].m = part*r;
                    s[k].A = part*(1 + (isKnown ? between(-off, off) : 0));
                    s[k].e0 = part*e + (isKnown ? p*(part - s[k].A) : 0);
                    theta += part;
                }
                if (made)
                {
                    relax
                    (
                        f,
                        s,
                        isKnown ? theta : theta*between(0.98, 1.02),
                        1e5,
                        isKnown ? P : 0,
                        isKnown ? known : own
                    );
                }
            }
        }
        std::string name;
        for (const label k : which) name += " " + std::to_string(k);
        std::printf("%-8s known: n %3d bad %3d theta %.1e e %.1e P %.1e looks %.1f most %d | own: n %3d bad %3d theta %.1e e %.1e looks %.1f most %d%s%s\n",
            name.c_str(), known.runs, known.refused, known.theta, known.energy, known.pressure,
            double(known.looks)/max(known.runs,1), known.most,
            own.runs, own.refused, own.theta, own.energy, double(own.looks)/max(own.runs,1), own.most,
            known.positive ? "" : " NEG", own.positive ? "" : " NEGOWN");
    }
}
