/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "stressUpdate.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(stressUpdate, 0);
    defineRunTimeSelectionTable(stressUpdate, word);
}
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::stressUpdate>
Foam::mpm::stressUpdate::New(const dictionary& dict)
{
    const word name
    (
        oneOfOrDefault
        (
            dict,
            "stressUpdate",
            "MUSL",
            wordConstructorTablePtr_->sortedToc()
        )
    );
    return wordConstructorTablePtr_->cfind(name).val()();
}

// ************************************************************************* //
