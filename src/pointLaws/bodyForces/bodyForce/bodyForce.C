/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "bodyForce.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(bodyForce, 0);
    defineRunTimeSelectionTable(bodyForce, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::bodyForce>
Foam::mpm::bodyForce::New(const dictionary& dict)
{
    return selectFromTable<bodyForce>
    (
        dict,
        dictionaryConstructorTablePtr_,
        dict
    );
}

// ************************************************************************* //
