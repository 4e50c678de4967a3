// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testPoints.H"
#include "failureModel.H"
#include <sstream>

namespace
{

autoPtr<failureModel> failureOf(const std::string& text)
{
    IStringStream is(text);
    return failureModel::New(dictionary(is));
}

const char* const elasticLaw("type linearElastic; rho 2700; E 70e9; nu 0;");

const char* const copperLaw("type JohnsonCook; rho 8960; G 46e9; K 129e9; A 90e6; B 292e6; n 0.31;"
                            " C 0.025; m 1.09; referenceRate 1; referenceTemperature 294;"
                            " meltTemperature 1356; cp 383; beta 0;");

const std::string
    copperDamage("type JohnsonCookDamage; D1 0.54; D2 4.89; D3 -3.03; D4 0.014; D5 1.12;"
                 " referenceRate 1; referenceTemperature 294; meltTemperature 1356;");

}

TEST_CASE("failed nothing: a failed point has no stress")
{
    auto model(failureOf("type maxPrincipalStress; strength 1e6; failed nothing;"));
    points p(2, 2, 1);
    p.stress[0][0] = 2e6;
    p.stress[1][0] = -5e6;
    p.stress[3][0] = 1e6;
    p.stress[1][1] = -5e6;
    pointBlock b(p.block());
    CHECK(model->correct(b) == 1);
    for (int k = 0; k < 4; ++k)
        CHECK(p.stress[k][0] == 0);
    CHECK(p.stress[1][1] == -5e6);
}

TEST_CASE("2D points lose the tension that 3D points lose")
{
    // Closed form in the plane against Eigen, whole, softening and failed, with
    // and without a gas; all signs of the principal values
    for (const std::string& gas : {"", "ambientPressure 3e5;"})
        for (const scalar d : {0.4, 1.0})
            for (int k = 0; k < 200; ++k)
            {
                auto model(failureOf("type maxPrincipalStress; strength 1e12; " + gas));
                points p(2, 1, 1), q(3, 1, 1);
                for (int i = 0; i < 4; ++i)
                {
                    const scalar s = 2e6 * (uniformOf(7, uint64_t(4 * k + i)) - 0.5);
                    p.stress[i][0] = q.stress[i][0] = k == 0 ? 1e6 * (i < 2) : s;
                }
                p.damage[0] = q.damage[0] = d;
                pointBlock b(p.block()), c(q.block());
                model->correct(b);
                model->correct(c);
                for (int i = 0; i < 4; ++i)
                {
                    CHECK(std::abs(p.stress[i][0] - q.stress[i][0]) < 1e-6);
                }
            }
}

TEST_CASE("crack band: a band oblique to the cells is wider")
{
    // Uniaxial stress at 30 degrees: l = h (cos + sin), in 2D as in 3D
    const scalar f = 10e6, Gf = 500, E = 70e9, h = 0.1, s = 3 * f;
    const scalar c = std::sqrt(0.75), t = 0.5;
    const scalar r = 2 * E * Gf / (f * f * h * (c + t));
    for (int D = 2; D <= 3; ++D)
    {
        const auto law(lawOf(elasticLaw));
        auto model(failureOf("type maxPrincipalStress; strength 10e6; Gf 500;"));
        model->connect(*law, D);
        points p(D, 1, 2700);
        p.width[0] = h;
        p.stress[0][0] = s * c * c;
        p.stress[1][0] = s * t * t;
        p.stress[3][0] = -s * c * t;
        pointBlock b(p.block());
        model->correct(b);
        CHECK(p.damage[0] == doctest::Approx(r / (r - 1) * (1 - f / s)).epsilon(1e-9));
    }
}

TEST_CASE("crack band: the energy of a crack is Gf for every cell width")
{
    // Uniaxial strain with nu = 0, so E is the modulus; h = ln F, and the work
    // per area is width times int sigma dF, with the Cauchy stress
    const scalar f = 10e6, Gf = 500, E = 70e9;
    for (int D = 1; D <= 3; ++D)
        for (const scalar width : {1e-3, 0.1, 0.4})
        {
            const auto law(lawOf(elasticLaw));
            auto model(failureOf("type maxPrincipalStress; strength 10e6; Gf 500;"));
            model->connect(*law, D);
            CHECK(model->needsWidth());
            points p(D, 3, 2700);
            std::fill(p.width.begin(), p.width.end(), width);
            const scalar end = 2 * Gf / (f * width) * 1.01;
            const int n = 20000;
            scalar work = 0, largest = 0, old = 0;
            label failed = 0;
            std::vector<scalar> L(9, 0);
            L[0] = end / n;
            for (int i = 0; i < n; ++i)
            {
                p.apply(*law, L);
                pointBlock b(p.block());
                failed += model->correct(b);
                work += 0.5 * (old + p.stress[0][1]) * end / n * width;
                old = p.stress[0][1];
                largest = max(largest, old);
            }
            CHECK(work == doctest::Approx(Gf).epsilon(2e-3));
            CHECK(largest == doctest::Approx(f).epsilon(1e-3 + E * end / n / f));
            CHECK(failed == 3);
            CHECK(std::abs(p.stress[0][1]) <= 1e-9 * f);
        }

    // Halfway: unloading goes to the origin, compression is whole
    const auto law(lawOf(elasticLaw));
    auto model(failureOf("type maxPrincipalStress; strength 10e6; Gf 500;"));
    model->connect(*law, 1);
    points p(1, 1, 2700);
    p.width[0] = 0.1;
    p.apply(*law, {4 * f / E});
    pointBlock b(p.block());
    CHECK(model->correct(b) == 0);
    const scalar d = p.damage[0];
    CHECK(d > 0.5);
    CHECK(d < 1);
    p.apply(*law, {-2 * f / E});
    model->correct(b);
    CHECK(p.stress[0][0] == doctest::Approx((1 - d) * 2 * f).epsilon(1e-3));
    CHECK(p.damage[0] == d);
    p.apply(*law, {-4 * f / E});
    model->correct(b);
    CHECK(p.stress[0][0] == doctest::Approx(-2 * f).epsilon(1e-3));

    // A cell too wide
    p.width[0] = 1.01 * 2 * E * Gf / (f * f);
    p.apply(*law, {4 * f / E});
    CHECK_THROWS_AS(model->correct(b), Foam::error);
}

TEST_CASE("maxPrincipalStrain: total strain of elastic laws")
{
    for (const std::string& text :
         {std::string(elasticLaw),
          std::string("type J2Plasticity; rho 2700; E 70e9; nu 0.2; yield 1e12; hardening none;")})
        for (int D = 2; D <= 3; ++D)
        {
            const auto law(lawOf(text));
            auto model(failureOf("type maxPrincipalStrain; strain 0.05;"));
            model->connect(*law, D);
            points p(D, 2, 2700);
            std::vector<scalar> L(9, 0);
            L[0] = -0.2;
            L[D + 1] = 0.0499;
            p.apply(*law, L);
            pointBlock b(p.block());
            CHECK(model->correct(b) == 0);
            L[0] = 0;
            L[D + 1] = 0.0002;
            p.apply(*law, L);
            CHECK(model->correct(b) == 2);
            CHECK(p.damage[1] == 1);
        }
    auto model(failureOf("type maxPrincipalStrain; strain 0.05;"));
    CHECK_THROWS_AS(
        model->connect(*lawOf("type NewtonianFluid; rho 1; mu 0; K 1;"), 2), Foam::error);
}

TEST_CASE("TulerButcher: time to failure under constant stress")
{
    // t = impulse/(s - strength)^exponent; the strength alone never fails
    for (const scalar over : {1e8, 2e8})
    {
        const auto law(lawOf(elasticLaw));
        auto model(failureOf("type TulerButcher; strength 1e9; exponent 2; impulse 1e10;"));
        model->connect(*law, 1);
        CHECK(model->history().size() == 1);
        points p(1, 2, 2700);
        p.dt = 1e-9;
        scalar t = 0;
        for (int i = 0; i < 3000 && p.damage[1] < 1; ++i)
        {
            p.stress[0][0] = 1e9;
            p.stress[0][1] = 1e9 + over;
            pointBlock b(p.block());
            model->correct(b);
            t += p.dt;
        }
        CHECK(t == doctest::Approx(1e10 / (over * over)).epsilon(0.01));
        CHECK(p.damage[0] == 0);
        CHECK(p.stress[0][1] == 0);
    }
}

TEST_CASE("GradyKipp: stress at fragmentation over the strain rate")
{
    // Uniaxial, small strains at a constant rate: the closed form of the header
    const scalar E = 70e9, k = 1e28, c = 2000;
    for (const scalar m : {6.0, 9.0})
        for (const scalar rate : {10.0, 1e3})
        {
            const auto law(lawOf(elasticLaw));
            std::ostringstream text;
            text << "type GradyKipp; k " << k << "; m " << m << "; crackSpeed " << c << ";";
            auto model(failureOf(text.str()));
            model->connect(*law, 1);
            CHECK(model->softens());
            const scalar A = 8 * std::acos(-1.0) * k * c * c * c / ((m + 1) * (m + 2) * (m + 3));
            const scalar ef = std::pow(rate * rate * rate / ((m + 4) * A), 1 / (m + 3));

            points p(1, 2, 2700);
            const int n = 20000;
            p.dt = 2 * ef / rate / n;
            std::vector<scalar> L(9, 0);
            L[0] = rate * p.dt;
            scalar largest = 0, at = 0;
            label failed = 0;
            for (int i = 0; i < n; ++i)
            {
                p.apply(*law, L);
                pointBlock b(p.block());
                failed += model->correct(b);
                if (p.stress[0][1] > largest)
                {
                    largest = p.stress[0][1];
                    at = p.damage[1];
                }
            }
            CHECK(largest == doctest::Approx(E * ef * (m + 3) / (m + 4)).epsilon(2e-3 + ef));
            CHECK(at == doctest::Approx(1 / (m + 4)).epsilon(0.02));
            CHECK(failed == 2);
            CHECK(std::abs(p.stress[0][1]) < 1);
        }

    // Compression grows no crack
    const auto law(lawOf(elasticLaw));
    auto model(failureOf("type GradyKipp; k 1e28; m 9; crackSpeed 2000;"));
    model->connect(*law, 2);
    points p(2, 1, 2700);
    p.apply(*law, {-0.01, 0, 0, -0.01});
    pointBlock b(p.block());
    model->correct(b);
    CHECK(p.damage[0] == 0);
}

namespace
{

//- Plastic strain in steps to failure at a fixed stress state (von Mises stress 1), rate and T.
//  Columns are elasticStrain (6), plasticStrain, T, damageStrain
scalar strainToFailure(
    failureModel& model, const scalar mean, const scalar rate, const scalar T, const scalar step)
{
    points p(3, 1, 8960);
    p.dt = step / rate;
    int n = 0;
    for (; n < 100000 && p.damage[0] < 1; ++n)
    {
        for (int k = 0; k < 3; ++k)
            p.stress[k][0] = mean;
        p.stress[3][0] = std::sqrt(1.0 / 3);
        p.history[6][0] += step;
        p.history[7][0] = T;
        pointBlock b(p.block());
        model.correct(b);
    }
    return n * step;
}

}

TEST_CASE("JohnsonCookDamage: strain to failure")
{
    const auto law(lawOf(copperLaw));
    auto model(failureOf(copperDamage));
    model->connect(*law, 3);
    CHECK(model->history()[0].name == "damageStrain");

    struct
    {
        scalar mean, rate, T, epsF;
    } states[] = {
        {0, 1, 294, 0.54 + 4.89},
        {1.0 / 3, 1, 294, 0.54 + 4.89 * std::exp(-3.03 / 3)},
        {-1.0 / 3, 1, 294, 0.54 + 4.89 * std::exp(3.03 / 3)},
        {3, 1, 294, 0.54 + 4.89 * std::exp(-3.03 * 1.5)},
        {0, 1e4, 294, (0.54 + 4.89) * (1 + 0.014 * std::log(1e4))},
        {0, 1, 825, (0.54 + 4.89) * (1 + 1.12 * 0.5)}};
    for (const auto& s : states)
    {
        const scalar step = 1e-3;
        CHECK(
            strainToFailure(*model, s.mean, s.rate, s.T, step)
            == doctest::Approx(s.epsF).epsilon(1e-3 + step / s.epsF));
    }

    // 6061-T6: none above a triaxiality of ln(0.77/1.45)/-0.47
    const std::string aluminium(
        "type JohnsonCookDamage; D1 -0.77; D2 1.45; D3 -0.47; D4 0; D5 1.6;"
        " referenceRate 1; referenceTemperature 294; meltTemperature 925; ");
    for (const scalar least : {1e-6, 0.02})
    {
        auto brittle(failureOf(aluminium + "minFailureStrain " + std::to_string(least) + ";"));
        brittle->connect(*law, 3);
        CHECK(
            strainToFailure(*brittle, 1.34, 1, 294, 1e-5)
            == doctest::Approx(std::max(least, -0.77 + 1.45 * std::exp(-0.47 * 1.34)))
                   .epsilon(0.01));
        CHECK(
            strainToFailure(*brittle, 1.36, 1, 294, 1e-6) == doctest::Approx(least).epsilon(0.01));
    }

    CHECK_THROWS_AS(model->connect(*lawOf(elasticLaw), 3), Foam::error);
    CHECK_THROWS_AS(
        model->connect(*lawOf("type J2Plasticity; rho 1; G 1; K 1; yield 1; hardening none;"), 3),
        Foam::error);
}

TEST_CASE("Weibull: larger points are weaker")
{
    auto model(failureOf("type maxPrincipalStress; strength 1e6;"
                         " weibull { modulus 5; seed 3; referenceVolume 1e-9; }"));
    // A point of 32 times the volume has half the strength
    CHECK(
        model->strength(4, 32e-9)
        == doctest::Approx(0.5 * model->strength(4, 1e-9)).epsilon(1e-12));

    // Weakest of 32 points is a point of 32 times the volume: the means agree
    scalar weakest = 0, large = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i)
    {
        scalar least = GREAT;
        for (int k = 0; k < 32; ++k)
        {
            least = min(least, model->strength(uint64_t(32 * i + k), 1e-9));
        }
        weakest += least / n;
        large += model->strength(uint64_t(i), 32e-9) / n;
    }
    CHECK(weakest == doctest::Approx(large).epsilon(0.01));
}

TEST_CASE("input errors of failure models")
{
    for (const std::string& text :
         {std::string("type maxPrincipalStress; strength -1;"),
          std::string("type maxPrincipalStress; strength 1; failed all;"),
          std::string("type maxPrincipalStress; strength 1; Gf 0;"),
          std::string("type maxPrincipalStress; strength 1; weibull { modulus 5; seed 1; "
                      "referenceVolume 0; }"),
          std::string("type maxPrincipalStrain; strength 1;"),
          std::string("type maxPrincipalStrain; strain 0;"),
          std::string("type TulerButcher; strength 1; exponent 2;"),
          std::string("type TulerButcher; strength 1; exponent 0; impulse 1;"),
          std::string("type GradyKipp; k 0; m 9; crackSpeed 1;"),
          std::string("type GradyKipp; k 1; m 0; crackSpeed 1;"),
          std::string("type GradyKipp; k 1; m 9;"), copperDamage + "limitOn total;",
          copperDamage.substr(0, copperDamage.find("D5")) + "meltTemperature 1356;"})
    {
        CAPTURE(text);
        CHECK_THROWS_AS(failureOf(text), Foam::IOerror);
    }
}

TEST_CASE("maxPrincipalStress: fails at the limit, keeps compression only")
{
    IStringStream is("type maxPrincipalStress; strength 400e6;");
    const auto model(failureModel::New(dictionary(is)));

    points p(3, 4, 2700);
    // Just below, just above in a turned direction, compression
    const scalar c = std::cos(0.4), s = std::sin(0.4);
    const auto turned = [&](label i, scalar a, scalar b)
    {
        p.stress[0][i] = a * c * c + b * s * s;
        p.stress[1][i] = a * s * s + b * c * c;
        p.stress[3][i] = (a - b) * c * s;
    };
    turned(0, 399.9e6, -100e6);
    turned(1, 400.1e6, -100e6);
    turned(2, -500e6, -600e6);
    turned(3, 500e6, 450e6);

    pointBlock b(p.block());
    CHECK(model->correct(b) == 2);
    CHECK(p.damage[0] == 0);
    CHECK(p.damage[1] == 1);
    CHECK(p.damage[2] == 0);
    CHECK(p.damage[3] == 1);

    // What point 1 keeps is -100 MPa along its second direction
    CHECK(p.stress[0][1] == doctest::Approx(-100e6 * s * s).epsilon(1e-9));
    CHECK(p.stress[1][1] == doctest::Approx(-100e6 * c * c).epsilon(1e-9));
    CHECK(p.stress[3][1] == doctest::Approx(100e6 * c * s).epsilon(1e-9));
    CHECK(std::abs(p.stress[0][3]) < 1e-3);
}

TEST_CASE("Weibull strengths: by id only, with the right distribution")
{
    IStringStream is("type maxPrincipalStress; strength 1e6; weibull { modulus 5; seed 3; }");
    const auto model(failureModel::New(dictionary(is)));
    CHECK(model->scatters());

    const int n = 200000;
    scalar mean = 0, below = 0;
    for (int i = 0; i < n; ++i)
    {
        const scalar s = model->strength(uint64_t(i), 1);
        mean += s / n;
        below += s < 1e6 ? 1.0 / n : 0;
    }
    // Mean Gamma(1 + 1/5), P(s < scale) = 1 - 1/e; three standard errors
    CHECK(mean == doctest::Approx(1e6 * std::tgamma(1.2)).epsilon(0.002));
    CHECK(below == doctest::Approx(1 - std::exp(-1.0)).epsilon(0.006));
    CHECK(model->strength(17, 1) == model->strength(17, 1));
    CHECK(model->strength(17, 1) != model->strength(18, 1));
}
