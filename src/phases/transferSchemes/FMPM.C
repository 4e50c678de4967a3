/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "FMPM.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(FMPM, 0);
    addToRunTimeSelectionTable(transferScheme, FMPM, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The full filter for points without extent: see materialPointSystem
scalar strainFilter(const dictionary& dict)
{
    const word shape(dict.getOrDefault<word>("shapeFunction", ""));
    return
        shape == "quadraticBSpline" || shape == "cubicBSpline"
     || shape == "nodeDual" ? 1 : 0.75;
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::FMPM::FMPM(const dictionary& dict)
:
    filteredScheme(dict, ::strainFilter(dict))
{
    if (order() > 4)
    {
        WarningInFunction
            << "FMPM of order " << order() << " rings at shocks: in plate"
            << " impacts with strainFilter 1 order 8 grew without bound."
            << " Order 2 is what to use." << endl;
    }
}

// ************************************************************************* //
