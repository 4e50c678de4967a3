/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pressureClosure.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(pressureClosure, 0);
    defineRunTimeSelectionTable(pressureClosure, dictionary);
}
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::pressureClosure> Foam::mpm::pressureClosure::New
(
    const dictionary& dict,
    const gasThermo& thermo
)
{
    const word name
    (
        oneOfOrDefault
        (
            dict,
            "pressureClosure",
            "ownPressure",
            dictionaryConstructorTablePtr_->sortedToc()
        )
    );
    return dictionaryConstructorTablePtr_->cfind(name).val()(dict, thermo);
}

// ************************************************************************* //
