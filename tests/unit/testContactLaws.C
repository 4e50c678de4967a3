/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Contact laws: largest tangential impulse and its slope.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "contactLaw.H"
#include "IStringStream.H"

using namespace Foam;
using namespace Foam::mpm;

namespace
{

autoPtr<contactLaw> contactLawOf(const std::string& text)
{
    IStringStream is(text);
    return contactLaw::New(dictionary(is));
}

//- Without a slope of its own
struct squareLaw : public contactLaw
{
    squareLaw() : contactLaw(dictionary(), wordList()) {}

    scalar limit(const state& s) const override { return 3 * sqr(s.Jn) * s.slip(); }
};

} // End namespace

TEST_CASE("contact laws: largest tangential impulse")
{
    // J_n 2, slip 0.7/0.1 = 7
    const contactLaw::state s{2, 0.7, 0.1, 1e-3};
    CHECK(s.slip() == doctest::Approx(7).epsilon(1e-14));
    CHECK(contactLawOf("type frictionless;")->limit(s) == 0);
    CHECK(contactLawOf("type Coulomb; mu 0.3;")->limit(s) == 0.3 * 2);
    CHECK(contactLawOf("type Coulomb; mu 0.3;")->slope(s) == 0.3);
    CHECK(contactLawOf("type stick;")->limit(s) > 1e100);
}

TEST_CASE("contact laws: the slope of a law that gives none")
{
    const squareLaw law;
    const contactLaw::state s{2, 0.7, 0.1, 1e-3};
    // 6 J_n slip
    CHECK(law.slope(s) == doctest::Approx(84).epsilon(1e-8));
}
