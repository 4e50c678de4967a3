/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "DruckerPrager.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(DruckerPrager, 0);
    addToRunTimeSelectionTable(constitutiveModel, DruckerPrager, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::DruckerPrager::DruckerPrager(const dictionary& dict)
:
    frictionalLaw<DruckerPrager>(dict, wordList({"match"}))
{
    const word match(oneOf(dict, "match", {"outer", "inner", "planeStrain"}));
    const auto slope = [&](const scalar angle)
    {
        return
            match == "planeStrain"
          ? 3*std::tan(angle)/std::sqrt(9 + 12*sqr(std::tan(angle)))
          : 6*std::sin(angle)
           /(std::sqrt(3.0)*(3 + (match == "inner" ? 1 : -1)*std::sin(angle)));
    };
    a_ = slope(phi_);
    b_ = slope(psi_);
    k_ =
        match == "planeStrain"
      ? 3*c_/std::sqrt(9 + 12*sqr(std::tan(phi_)))
      : 6*c_*std::cos(phi_)
       /(std::sqrt(3.0)*(3 + (match == "inner" ? 1 : -1)*std::sin(phi_)));
    sMax_ = min(tension_, a_ > 0 ? k_/a_ : GREAT);
}

// ************************************************************************* //
