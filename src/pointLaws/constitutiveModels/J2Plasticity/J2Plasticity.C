/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "J2Plasticity.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(J2Plasticity, 0);
    addToRunTimeSelectionTable(constitutiveModel, J2Plasticity, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Keywords of the hardening, which must exist
wordList hardeningKeywords(const dictionary& dict)
{
    const word hardening
    (
        mpm::oneOf(dict, "hardening", {"none", "linear", "power"})
    );
    wordList keys({"yield", "hardening"});
    keys.append
    (
        hardening == "linear" ? wordList({"H"})
      : hardening == "power" ? wordList({"B", "n"})
      : wordList()
    );
    return keys;
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::J2Plasticity::J2Plasticity(const dictionary& dict)
:
    deviatoricPlasticity<J2Plasticity>(dict, hardeningKeywords(dict)),
    yield_(positive(dict, "yield")),
    B_(0),
    n_(0)
{
    const word hardening(dict.get<word>("hardening"));
    if (hardening == "linear")
    {
        B_ = bounded(dict, "H", 0, GREAT);
    }
    else if (hardening == "power")
    {
        B_ = bounded(dict, "B", 0, GREAT);
        n_ = bounded(dict, "n", 1e-6, 1);
    }
}

// ************************************************************************* //
