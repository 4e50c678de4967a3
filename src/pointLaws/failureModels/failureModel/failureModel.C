/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "failureModel.H"
#include "selector.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(failureModel, 0);
    defineRunTimeSelectionTable(failureModel, dictionary);
}
}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::uniformOf(const uint64_t seed, const uint64_t id)
{
    // Two rounds of a mixing function with full avalanche on 64 bits
    uint64_t z = seed*0x9e3779b97f4a7c15ULL + id + 1;
    for (int round = 0; round < 2; ++round)
    {
        z ^= z >> 30;
        z *= 0xbf58476d1ce4e5b9ULL;
        z ^= z >> 27;
        z *= 0x94d049bb133111ebULL;
        z ^= z >> 31;
    }
    // 53 bits, centred in their interval: neither 0 nor 1 occurs
    return (scalar(z >> 11) + 0.5)/9007199254740992.0;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::failureModel::failureModel(const dictionary& dict)
:
    strength_(positive(dict, "strength")),
    modulus_(0),
    seed_(0),
    ambient_(boundedOrDefault(dict, "ambientPressure", 0, 0, GREAT)),
    effective_
    (
        oneOfOrDefault(dict, "limitOn", "total", {"total", "effective"})
     == "effective"
    )
{
    if (dict.found("weibull"))
    {
        const dictionary& w = requiredDict(dict, "weibull");
        checkKeywords(w, {"modulus", "seed"});
        modulus_ = positive(w, "modulus");
        requireKeyword(w, "seed");
        seed_ = uint64_t(boundedLabelOrDefault(w, "seed", 0, 0, labelMax));
    }
}


Foam::autoPtr<Foam::mpm::failureModel>
Foam::mpm::failureModel::New(const dictionary& dict)
{
    return selectFromTable<failureModel>
    (
        dict,
        dictionaryConstructorTablePtr_,
        dict
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::failureModel::strength(const uint64_t id) const
{
    if (!scatters())
    {
        return strength_;
    }
    return
        strength_
       *std::pow(-std::log1p(-uniformOf(seed_, id)), scalar(1)/modulus_);
}

// ************************************************************************* //
