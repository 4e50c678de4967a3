/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Drag models: numbers worked out by hand from the sources' formulas, and
    the terminal velocity and minimum fluidisation that follow from them.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>
#include "dragModel.H"
#include "IStringStream.H"
#include <cmath>
#include <functional>
#include <string>

using namespace Foam;
using namespace Foam::mpm;

namespace
{

autoPtr<dragModel> drag(const std::string& text)
{
    IStringStream is(text);
    return dragModel::New(dictionary(is));
}

//- C_D of a lone sphere: K = 3/4 C_D theta_s rho u/d at theta_s -> 0
scalar dragCoefficient(const char* type, const scalar Re)
{
    const scalar thetaS = 1e-9, rho = 1.2, mu = 1.8e-5, d = 1e-3;
    const scalar u = Re * mu / (rho * d);
    const scalar K = drag(std::string("type ") + type + "; d 1e-3;")
                         ->K(dragModel::state{thetaS, 1 - thetaS, rho, mu, u});
    return K / (0.75 * thetaS * rho * u / d);
}

//- Root of a rising function
scalar solve(const std::function<scalar(scalar)>& f)
{
    scalar low = 1e-12, high = 1e3;
    for (int i = 0; i < 200; ++i)
    {
        const scalar middle = std::sqrt(low * high);
        (f(middle) < 0 ? low : high) = middle;
    }
    return low;
}

//- Velocity at which the drag on the solid carries its weight in the fluid:
//  K u = theta_g theta_s (rho_s - rho) g, as the pressure has the rest of the
//  buoyancy; for a lone sphere theta_g = 1
scalar carried(
    const std::string& text, const scalar thetaS, const scalar rhoS, const scalar rho,
    const scalar mu)
{
    const autoPtr<dragModel> model(drag(text));
    const scalar g = 9.81;
    return solve(
        [&](const scalar u)
        {
            return u * model->K(dragModel::state{thetaS, 1 - thetaS, rho, mu, u})
                - (1 - thetaS) * thetaS * (rhoS - rho) * g;
        });
}

} // End namespace

TEST_CASE("drag: Schiller-Naumann, C_D of a sphere")
{
    // 24/Re (1 + 0.15 Re^0.687): 100^0.687 = 23.6592, 1^0.687 = 1
    CHECK(dragCoefficient("SchillerNaumann", 100) == doctest::Approx(1.0917312).epsilon(1e-6));
    CHECK(dragCoefficient("SchillerNaumann", 1) == doctest::Approx(27.6).epsilon(1e-9));
    CHECK(dragCoefficient("SchillerNaumann", 1e-6) * 1e-6 == doctest::Approx(24).epsilon(1e-4));
    CHECK(dragCoefficient("SchillerNaumann", 5000) == doctest::Approx(0.44).epsilon(1e-9));

    // Published: 1.09 at Re 100
    CHECK(std::round(100 * dragCoefficient("SchillerNaumann", 100)) == 109);

    // Wen and Yu's is the same where there are few spheres
    CHECK(dragCoefficient("WenYu", 100) == doctest::Approx(1.0917312).epsilon(1e-6));
}

TEST_CASE("drag: Ergun, Wen-Yu, Gidaspow, Darcy by hand")
{
    // Packed: theta_s 0.6, theta_g 0.4, rho 1.2, mu 1.8e-5, u 0.5, d 5e-4
    const dragModel::state packed{0.6, 0.4, 1.2, 1.8e-5, 0.5};
    // 150*0.36*1.8e-5/(0.4*2.5e-7) = 9720; 1.75*0.6*1.2*0.5/5e-4 = 1260
    CHECK(drag("type Ergun; d 5e-4;")->K(packed) == doctest::Approx(10980).epsilon(1e-12));
    CHECK(drag("type Gidaspow; d 5e-4;")->K(packed) == doctest::Approx(10980).epsilon(1e-12));

    // Thin: theta_g 0.9, u 1/3: theta_g Re = 0.9*1.2/3*5e-4/1.8e-5 = 10,
    // 10^0.687 = 4.864072, C_D = 2.4*1.7296108 = 4.1510660;
    // K = 0.75*C_D*0.1*0.9*1.2/3/5e-4 0.9^-2.65, 0.9^-2.65 = 1.3220788
    const dragModel::state thin{0.1, 0.9, 1.2, 1.8e-5, 1.0 / 3};
    const scalar K = 0.75 * 4.1510660 * 0.1 * 0.9 * 1.2 / 3 / 5e-4 * 1.3220788;
    CHECK(drag("type WenYu; d 5e-4;")->K(thin) == doctest::Approx(K).epsilon(1e-6));
    CHECK(drag("type Gidaspow; d 5e-4;")->K(thin) == doctest::Approx(K).epsilon(1e-6));

    // theta_g^2 mu/permeability = 0.16*1.8e-5/1e-9
    CHECK(
        drag("type Darcy; permeability 1e-9;")->K(packed) == doctest::Approx(2880).epsilon(1e-12));
    CHECK(drag("type constant; value 50;")->K(packed) == doctest::Approx(12).epsilon(1e-12));
    CHECK(drag("type none;")->K(packed) == 0);
    CHECK(drag("type stick;")->K(packed) >= 1e20);

    // At rest nothing divides by the velocity
    dragModel::state still(packed);
    still.U = 0;
    CHECK(drag("type SchillerNaumann; d 5e-4;")->K(still) > 0);
    CHECK(drag("type WenYu; d 5e-4;")->K(still) > 0);
}

TEST_CASE("drag: terminal velocity of a sphere")
{
    // 48 um of 2340 kg/m3 in water, 500 um of 2500 kg/m3 in air
    CHECK(
        carried("type SchillerNaumann; d 48e-6;", 1e-9, 2340, 1000, 1e-3)
        == doctest::Approx(1.638e-3).epsilon(1e-3));
    CHECK(
        carried("type SchillerNaumann; d 5e-4;", 1e-9, 2500, 1.2, 1.8e-5)
        == doctest::Approx(3.706).epsilon(1e-3));
}

TEST_CASE("drag: minimum fluidisation by Ergun")
{
    // Superficial velocity theta_g u; the quadratic worked out here:
    // 150 (1 - e)/e^3 mu/(d^2) U + 1.75/e^3 rho/d U^2 = (rho_s - rho) g
    const scalar e = 0.4, d = 5e-4, rhoS = 2500, rho = 1.2, mu = 1.8e-5;
    const scalar A = 1.75 * rho / (d * e * e * e), B = 150 * (1 - e) * mu / (e * e * e * d * d);
    const scalar C = (rhoS - rho) * 9.81;
    const scalar U = (std::sqrt(B * B + 4 * A * C) - B) / (2 * A);
    CHECK(
        e * carried("type Ergun; d 5e-4;", 1 - e, rhoS, rho, mu)
        == doctest::Approx(U).epsilon(1e-9));
    CHECK(U == doctest::Approx(0.2128).epsilon(1e-3));
}
