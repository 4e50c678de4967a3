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
:
    dict_(dict)
{
    checkKeywords(dict, {"type", "acceleration", "accelerationCoeffs"});
    requireKeyword(dict, "acceleration");
    acceleration_ = Function1<vector>::New("acceleration", dict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::uniformBodyForce::correct(bodyForceBlock& b) const
{
    const vector a(acceleration_->value(b.time));
    vector across(a);
    for (int d = 0; d < b.nDim; ++d)
    {
        across[b.axis[d]] = 0;
    }
    if (across != vector::zero)
    {
        FatalIOErrorInFunction(dict_)
            << "The acceleration is " << a << " at " << b.time << " s: it acts"
            << " along a direction that the mesh does not compute (patches of"
            << " type empty or wedge); it must be 0 there."
            << exit(FatalIOError);
    }
    for (int d = 0; d < b.nDim; ++d)
    {
        std::fill(b.b[d], b.b[d] + b.n, a[b.axis[d]]);
    }
}

// ************************************************************************* //
