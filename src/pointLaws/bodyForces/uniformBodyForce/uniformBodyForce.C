/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::uniformBodyForce

Description
    The same acceleration for all points of a phase, constant or a function of
    time: a shaken or a spun-up body, a load on one phase only.

Usage
    \table
        Property     | Description                            | Required | Unit
        type         | uniform                                | yes      |
        acceleration | a vector, or a Function1 of time       | yes      | m/s2
    \endtable

\*---------------------------------------------------------------------------*/

#include "bodyForce.H"
#include "Function1.H"
#include <algorithm>

namespace Foam::mpm
{

class uniformBodyForce : public bodyForce
{
    const dictionary dict_;

    autoPtr<Function1<vector>> acceleration_;

public:
    TypeName("uniform");

    explicit uniformBodyForce(const dictionary& dict) : dict_(dict)
    {
        checkKeywords(dict, {"type", "acceleration", "accelerationCoeffs"});
        requireKeyword(dict, "acceleration");
        acceleration_ = Function1<vector>::New("acceleration", dict);
    }

    void correct(bodyForceBlock& b) const override
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
                << " type empty or wedge); it must be 0 there." << exit(FatalIOError);
        }
        for (int d = 0; d < b.nDim; ++d)
        {
            std::fill(b.b[d], b.b[d] + b.n, a[b.axis[d]]);
        }
    }
};

defineTypeNameAndDebug(bodyForce, 0);
defineRunTimeSelectionTable(bodyForce, dictionary);

defineTypeNameAndDebug(uniformBodyForce, 0);
addToRunTimeSelectionTable(bodyForce, uniformBodyForce, dictionary);

} // End namespace Foam::mpm
