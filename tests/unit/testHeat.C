/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Nusselt numbers and the pressure of grains: numbers worked out by hand
    from the sources' formulas.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "heatTransferModel.H"
#include "granularPressure.H"
#include "IStringStream.H"
#include <cmath>
#include <string>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

//- Nu from H = 6 theta_s k Nu/d^2; Re = rho u d/mu of the gas between grains
scalar Nusselt(const char* type, const scalar Re, const scalar Pr, const scalar thetaG)
{
    IStringStream is(std::string("type ") + type + "; d 1e-3;");
    const scalar rho = 1.2, mu = 1.8e-5, Cp = 1005, d = 1e-3;
    const scalar H =
        heatTransferModel::New(dictionary(is))
            ->H(heatTransferModel::state{1 - thetaG, thetaG, rho, mu, Cp, Pr, Re * mu / (rho * d)});
    return H * sqr(d) * Pr / (6 * (1 - thetaG) * mu * Cp);
}

}

TEST_CASE("heat: Ranz-Marshall")
{
    // 2 + 0.6 Re^1/2 Pr^1/3; 0.71^(1/3) = 0.8921121
    CHECK(Nusselt("RanzMarshall", 0, 0.71, 0.9) == doctest::Approx(2).epsilon(1e-12));
    CHECK(Nusselt("RanzMarshall", 100, 1, 0.9) == doctest::Approx(8).epsilon(1e-12));
    CHECK(
        Nusselt("RanzMarshall", 100, 0.71, 0.9)
        == doctest::Approx(2 + 6 * 0.8921121).epsilon(1e-6));
}

TEST_CASE("heat: Gunn")
{
    // A lone sphere: Nu 2 at rest; at Re 100, Pr 1: 2 (1 + 0.7*2.5118864) +
    // 0.13*25.1188643
    CHECK(Nusselt("Gunn", 0, 1, 1 - 1e-9) == doctest::Approx(2).epsilon(1e-6));
    CHECK(Nusselt("Gunn", 100, 1, 1 - 1e-9) == doctest::Approx(8.7820936).epsilon(1e-6));

    // Packed bed, e = 0.4: 7 - 4 + 0.8 = 3.8 at rest; Re of the superficial
    // velocity 100: 3.8 (1 + 0.7*2.5118864) + 0.562*25.1188643
    CHECK(Nusselt("Gunn", 0, 1, 0.4) == doctest::Approx(3.8).epsilon(1e-9));
    CHECK(Nusselt("Gunn", 250, 1, 0.4) == doctest::Approx(24.598419).epsilon(1e-6));
}

TEST_CASE("heat: constant")
{
    IStringStream is("type constant; value 50;");
    const scalar H = heatTransferModel::New(dictionary(is))
                         ->H(heatTransferModel::state{0.4, 0.6, 1, 0, 0, 0, 0});
    CHECK(H == doctest::Approx(12).epsilon(1e-12));
}

TEST_CASE("granular pressure: Johnson-Jackson")
{
    IStringStream is("type JohnsonJackson; alphaMin 0.5; alphaMax 0.65;");
    const autoPtr<granularPressure> lawPtr(granularPressure::New(dictionary(is)));
    const granularPressure& law = *lawPtr;
    CHECK(law.p(0.5) == 0);
    CHECK(law.slope(0.45) == 0);

    // 0.1*0.6*0.1^2/0.05^5 = 6e-4/3.125e-7
    CHECK(law.p(0.6) == doctest::Approx(1920).epsilon(1e-9));

    // The slope is that of the curve, and the tangent goes on from its end
    for (const scalar a : {0.55, 0.6, 0.635, 0.645, 0.66})
    {
        const scalar h = 1e-6;
        CHECK(
            (law.p(a + h) - law.p(a - h)) / (2 * h) == doctest::Approx(law.slope(a)).epsilon(1e-5));
    }
    CHECK(law.slope(0.66) == law.slope(0.645));

    // rho a J (c + 4 J) where grains touch and come closer
    const double rho = 2500, J = 3, c = std::sqrt(law.slope(0.6) / rho);
    CHECK(law.q(0.6, rho, J) == doctest::Approx(rho * 0.6 * J * (c + 4 * J)).epsilon(1e-12));
    CHECK(law.q(0.5, rho, J) == 0);
    CHECK(law.q(0.6, rho, -J) == 0);
}
