/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "uniformBodyForce.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(uniformBodyForce, 0);
    addToRunTimeSelectionTable(bodyForce, uniformBodyForce, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::uniformBodyForce::uniformBodyForce(const dictionary& dict)
{
    checkKeywords(dict, {"type", "acceleration", "accelerationCoeffs"});
    requireKeyword(dict, "acceleration");
    acceleration_ = Function1<vector>::New("acceleration", dict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::uniformBodyForce::correct(bodyForceBlock& b) const
{
    const vector a(acceleration_->value(b.time));
    for (int d = 0; d < b.nDim; ++d)
    {
        std::fill(b.b[d], b.b[d] + b.n, a[b.axis[d]]);
    }
}

// ************************************************************************* //
