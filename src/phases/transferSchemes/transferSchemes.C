// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "APIC.H"
#include "FLIP.H"
#include "FMPM.H"
#include "XPIC.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(FLIP, 0);
defineTypeNameAndDebug(FMPM, 0);
defineTypeNameAndDebug(XPIC, 0);
defineTypeNameAndDebug(APIC, 0);
addToRunTimeSelectionTable(transferScheme, FLIP, dictionary);
addToRunTimeSelectionTable(transferScheme, FMPM, dictionary);
addToRunTimeSelectionTable(transferScheme, XPIC, dictionary);
addToRunTimeSelectionTable(transferScheme, APIC, dictionary);
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

bool isBSpline(const word& shape) { return shape == "quadraticBSpline" || shape == "cubicBSpline"; }

//- The full filter for points without extent: see materialPointSystem
scalar usualStrainFilter(const dictionary& dict)
{
    const word shape(dict.getOrDefault<word>("shapeFunction", ""));
    return isBSpline(shape) || shape == "nodeDual" ? 1 : 0.75;
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::filteredScheme::filteredScheme(const dictionary& dict, const scalar strainFilter) :
    order_(boundedLabelOrDefault(dict, "order", 2, 1, 100)),
    strainFilter_(boundedOrDefault(dict, "strainFilter", strainFilter, 0, 1)),
    smooth_(isBSpline(dict.getOrDefault<word>("shapeFunction", "")))
{
}

Foam::mpm::FLIP::FLIP(const dictionary& dict) :
    fraction_(boundedOrDefault(dict, "PICfraction", 0, 0, 1)),
    fractionOfGrains_(boundedOrDefault(dict, "PICfraction", 0.1, 0, 1)),
    filter_(boundedOrDefault(dict, "massFilter", 0, 0, 1))
{
}

Foam::mpm::FMPM::FMPM(const dictionary& dict) : filteredScheme(dict, usualStrainFilter(dict))
{
    if (order() > 4)
    {
        WarningInFunction << "FMPM of order " << order() << " rings at shocks: in plate"
                          << " impacts with strainFilter 1 order 8 grew without bound."
                          << " Order 2 is what to use." << endl;
    }
}

Foam::mpm::APIC::APIC(const dictionary& dict) :
    affine_(
        oneOfOrDefault(dict, "affineMatrix", "gradient", {"gradient", "moment"}) == "moment"
            ? moment
            : gradient)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::moveCoefficients Foam::mpm::filteredScheme::coefficients(const step& s) const
{
    if (s.mean)
    {
        return {0, 0, 1, 0.5, 0, 0.5, 0};
    }
    return {0, 0, 1, 0, 0, 1, 0};
}

void Foam::mpm::filteredScheme::write(Ostream& os, const bool) const
{
    os << "transfer " << type() << " of order " << order_
       << ": x moves with the new velocity of the point, in a gas or fluids with the mean of old "
          "and"
       << " new" << nl;
    if (order_ > 1)
    {
        os << "    increments of the filters meet the homogeneous boundary"
           << " conditions; strainFilter " << strainFilter_ << nl;
    }
}

Foam::mpm::moveCoefficients Foam::mpm::FLIP::coefficients(const step& s) const
{
    const scalar most = s.grains ? fractionOfGrains_ : fraction_;
    const scalar a = most < 1 ? -std::expm1(std::log1p(-most) * s.Co / 0.4) : 1;

    return {1 - a, 1, a, 0, s.mean ? -0.5 : 0, 1, 0};
}

void Foam::mpm::FLIP::write(Ostream& os, const bool grains) const
{
    os << "transfer FLIP with PIC fraction " << fraction_;
    if (grains && fractionOfGrains_ > fraction_)
    {
        os << " (of grains " << fractionOfGrains_ << ")";
    }
    if (filter_ > 0)
    {
        os << ", mass filter " << filter_;
    }
    os << ": x moves with u^L, in a gas or fluids with the mean of u^n and u^L" << nl;
}

void Foam::mpm::APIC::write(Ostream& os, const bool) const
{
    os << "transfer APIC, affine matrix from the "
       << (affine_ == moment ? "moments of u^L" : "gradient of u^n")
       << ": x moves with u^L, in fluids with the mean of u^n and u^L" << nl;
}
