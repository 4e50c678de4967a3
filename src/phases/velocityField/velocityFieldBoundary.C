// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "velocityField.H"
#include "valuePointPatchField.H"
#include "calculatedPointPatchField.H"
#include "zeroGradientPointPatchField.H"
#include "coupledPointPatchField.H"
#include "emptyPointPatchField.H"
#include "wedgePointPatchField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::velocityField::checkBoundary() const
{
    forAll(Ufield_.boundaryField(), patchi)
    {
        const pointPatchField<vector>& pf = Ufield_.boundaryField()[patchi];

        if (isA<emptyPointPatchField<vector>>(pf) || isA<wedgePointPatchField<vector>>(pf)
            || isA<coupledPointPatchField<vector>>(pf) || isA<calculatedPointPatchField<vector>>(pf)
            || isA<zeroGradientPointPatchField<vector>>(pf) || isA<valuePointPatchField<vector>>(pf)
            || slipVelocity::is(pf))
        {
            continue;
        }
        FatalErrorInFunction << "Patch " << pf.patch().name() << " of " << Ufield_.name() << " ("
                             << Ufield_.objectPath() << ") has the type " << pf.type()
                             << ", which material points do not know." << nl
                             << "Valid types: fixedValue, timeVaryingUniformFixedValue and"
                             << " others with a value (fixed velocity); slip, symmetry,"
                             << " symmetryPlane (no normal velocity); calculated, zeroGradient"
                             << " (free); cyclic; empty; wedge." << exit(FatalError);
    }
}

void Foam::mpm::velocityField::turnWithWalls()
{
    const labelHashSet rigid(rigid_.nodes());
    DynamicList<label> turning;
    for (const label n : active_)
    {
        const scalar m = mU_.data()[stride_ * n + nDim_];
        if (!slip_.turns(n) || !(m > 0) || rigid.found(n))
        {
            continue;
        }
        turning.append(n);
        for (int d = 0; d < nDim_; ++d)
        {
            dU_.data()[stride_ * n + d] +=
                U_.data()[stride_ * n + d] - mU_.data()[stride_ * n + d] / m;
        }
    }
    turning_.transfer(turning);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::velocityField::drives() const
{
    for (const pointPatchField<vector>& pf : Ufield_.boundaryField())
    {
        if (const auto* value = isA<valuePointPatchField<vector>>(pf))
        {
            if (value->size() && pf.type() != "fixedValue")
            {
                return true;
            }
            for (const vector& U : *value)
            {
                if (U != vector::zero)
                {
                    return true;
                }
            }
        }
    }
    return false;
}

bool Foam::mpm::velocityField::holds(const label patchi) const
{
    const pointPatchField<vector>& pf = Ufield_.boundaryField()[patchi];
    return slipVelocity::is(pf) || isA<valuePointPatchField<vector>>(pf);
}
