/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "stiffenedGasEquation.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(stiffenedGasEquation, 0);
    addToRunTimeSelectionTable(equationOfState, stiffenedGasEquation, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::stiffenedGasEquation::stiffenedGasEquation
(
    const dictionary& dict,
    const scalar rho0
)
:
    inlineEquation<stiffenedGasEquation>(rho0),
    softened_(0)
{
    checkKeywords(dict, {"type", "gamma", "pInf", "soundSpeed", "p0"});
    gamma_ = bounded(dict, "gamma", 1.000001, 100);
    if (!dict.found("soundSpeed"))
    {
        pInf_ = positive(dict, "pInf");
        p0_ = bounded(dict, "p0", -pInf_, GREAT);
        return;
    }
    if (dict.found("pInf"))
    {
        FatalIOErrorInFunction(dict)
            << "Entries pInf and soundSpeed in " << dict.name()
            << " say the same thing; give just one of them."
            << exit(FatalIOError);
    }
    softened_ = positive(dict, "soundSpeed");
    p0_ = bounded(dict, "p0", -GREAT, GREAT);
    pInf_ = rho0*sqr(softened_)/gamma_ - p0_;
    if (!(pInf_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry soundSpeed " << softened_ << " in " << dict.name()
            << " is too small for the pressure p0 " << p0_ << " Pa: at "
            << rho0 << " kg/m3 it must be above sqrt(gamma p0/rho) "
            << std::sqrt(gamma_*p0_/rho0) << " m/s." << exit(FatalIOError);
    }
}

// ************************************************************************* //
