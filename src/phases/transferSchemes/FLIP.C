/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "FLIP.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(FLIP, 0);
    addToRunTimeSelectionTable(transferScheme, FLIP, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::FLIP::FLIP(const dictionary& dict)
:
    fraction_(boundedOrDefault(dict, "PICfraction", 0, 0, 1)),
    fractionOfGrains_(boundedOrDefault(dict, "PICfraction", 0.1, 0, 1)),
    filter_(boundedOrDefault(dict, "massFilter", 0, 0, 1))
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::moveCoefficients
Foam::mpm::FLIP::coefficients(const step& s) const
{
    const scalar most = s.grains ? fractionOfGrains_ : fraction_;
    const scalar a = most < 1 ? -std::expm1(std::log1p(-most)*s.Co/0.4) : 1;

    return {1 - a, 1, a, 0, s.mean ? -0.5 : 0, 1, 0};
}


void Foam::mpm::FLIP::write(Ostream& os, const bool grains) const
{
    os  << "transfer FLIP with PIC fraction " << fraction_;
    if (grains && fractionOfGrains_ > fraction_)
    {
        os  << " (of grains " << fractionOfGrains_ << ")";
    }
    if (filter_ > 0)
    {
        os  << ", mass filter " << filter_;
    }
    os  << ": x moves with u^L" << nl;
}

// ************************************************************************* //
