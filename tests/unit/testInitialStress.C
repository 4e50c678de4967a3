// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include <doctest/doctest.h>
#include "testLaws.H"
#include "IOstreams.H"

using namespace Foam;
using namespace Foam::mpm;

TEST_CASE("initial stress: zero strain leaves it, a rotation turns it")
{
    // Any stress, also one that plane strain alone could not have, and J that
    // is not 1. Cauchy, Kirchhoff and neoHookean
    for (const word name : {"Cauchy", "Kirchhoff", "neoHookean"})
        for (int D = 1; D <= 3; ++D)
            for (const scalar J : {1.0, 0.95, 1.1})
            {
                const autoPtr<constitutiveModel> law(
                    name == "neoHookean" ? neo::create(0.3) : elastic(0.3, name));
                points p(D, 11, 2700);
                const scalar normal[3] = {1.3e9, -0.7e9, 0.4e9};
                const scalar shear[6] = {0, 0, 0, 0.5e9, -0.3e9, 0.8e9};
                for (label i = 0; i < p.n; ++i)
                {
                    p.volume[i] = J;
                    for (int k = 0; k < 3; ++k)
                        p.stress[k][i] = normal[k] * (1 - 0.1 * i);
                    for (int k = 3; k < nStress(D); ++k)
                        p.stress[k][i] = shear[k] * (1 - 0.15 * i);
                }
                const std::vector<std::vector<scalar>> before(p.stress);
                pointBlock b(p.block());
                law->initialise(b);
                p.apply(*law, std::vector<scalar>(9, 0));
                for (int k = 0; k < nStress(D); ++k)
                {
                    for (label i = 0; i < p.n; ++i)
                    {
                        CHECK(std::abs(p.stress[k][i] - before[k][i]) <= 1e-12 * 1.3e9);
                    }
                }
                CHECK(law->strainEnergy(p.block()) > 0);

                if (D == 1)
                    continue;

                // One radian about z in 100 steps: sigma <- R sigma R^T
                std::vector<scalar> L(9, 0);
                L[1] = -0.01;
                L[D] = 0.01;
                for (int i = 0; i < 100; ++i)
                    p.apply(*law, L);
                const scalar cs = std::cos(1.0), sn = std::sin(1.0);
                const scalar R[9] = {cs, -sn, 0, sn, cs, 0, 0, 0, 1};
                for (label i = 0; i < p.n; ++i)
                {
                    points old(D, 1, 2700);
                    for (int k = 0; k < 6; ++k)
                        old.stress[k][0] = before[k][i];
                    scalar s0[9], s1[9];
                    fullStress(old.block(), 0, s0);
                    fullStress(p.block(), i, s1);
                    for (int r = 0; r < 3; ++r)
                        for (int c = 0; c < 3; ++c)
                        {
                            scalar turned = 0;
                            for (int k = 0; k < 3; ++k)
                                for (int l = 0; l < 3; ++l)
                                {
                                    turned += R[3 * r + k] * s0[3 * k + l] * R[3 * c + l];
                                }
                            CHECK(std::abs(s1[3 * r + c] - turned) <= 1e-10 * 1.3e9);
                        }
                }
            }
}

TEST_CASE("initial stress: a further strain adds what the law says")
{
    // A uniaxial stretch from a hydrostatic start, in plane strain: the strain
    // of the start stays in the missing direction
    const scalar nu = 0.3, p0 = 2e9, step = 1e-3;
    const scalar lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), mu = E / (2 * (1 + nu));
    for (int D = 1; D <= 3; ++D)
    {
        const auto law(elastic(nu));
        points p(D, 5, 2700);
        for (int k = 0; k < 3; ++k)
        {
            std::fill(p.stress[k].begin(), p.stress[k].end(), -p0);
        }
        pointBlock b(p.block());
        law->initialise(b);
        std::vector<scalar> L(9, 0);
        L[0] = step;
        p.apply(*law, L);
        for (label i = 0; i < p.n; ++i)
        {
            CHECK(p.stress[0][i] == doctest::Approx(-p0 + (lambda + 2 * mu) * step).epsilon(1e-12));
            CHECK(p.stress[1][i] == doctest::Approx(-p0 + lambda * step).epsilon(1e-12));
            CHECK(p.stress[2][i] == doctest::Approx(-p0 + lambda * step).epsilon(1e-12));
        }
    }
}

TEST_CASE("initial stress: what no strain can carry is refused")
{
    const scalar nan = std::sqrt(scalar(-1)), inf = 1e300 * 1e300;
    for (const word name : {"Cauchy", "Kirchhoff", "neoHookean"})
        for (int D = 1; D <= 3; ++D)
            for (const scalar bad : {nan, inf, -inf, -1e14})
            {
                const autoPtr<constitutiveModel> law(
                    name == "neoHookean" ? neo::create(0.3) : elastic(0.3, name));
                points p(D, 3, 2700);
                p.stress[0][1] = bad;
                pointBlock b(p.block());
                CHECK_THROWS_AS(law->initialise(b), Foam::error);
            }
}
