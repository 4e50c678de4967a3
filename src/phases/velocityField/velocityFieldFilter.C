/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "velocityField.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::velocityField::strainFromU(const bool copy)
{
    strainIsU_ = !copy;
    if (copy)
    {
        scalar* to = strainMomentum();
        for (const label n : active_)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                to[stride_*n + d] = U_.data()[stride_*n + d];
            }
        }
    }
}


void Foam::mpm::velocityField::strainFromUL(const scalar weight)
{
    scalar* to = strainMomentum();
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            const scalar u =
                U_.data()[stride_*n + d] + dU_.data()[stride_*n + d];
            to[stride_*n + d] = u + weight*(UL_.data()[stride_*n + d] - u);
        }
    }
}


void Foam::mpm::velocityField::addChangeToStrain()
{
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            Ustrain_.data()[stride_*n + d] += dU_.data()[stride_*n + d];
        }
    }
}


Foam::scalar* Foam::mpm::velocityField::strainMomentum()
{
    strainIsU_ = false;
    if (!Ustrain_.data())
    {
        Ustrain_ = alignedArray(stride_*grid_.nNodes());
    }
    for (const label n : active_)
    {
        for (int c = 0; c < stride_; ++c)
        {
            Ustrain_.data()[stride_*n + c] = 0;
        }
    }
    return Ustrain_.data();
}


void Foam::mpm::velocityField::strainFromMomentum()
{
    scalar* u = Ustrain_.data();
    shared_.sum(u, stride_, nDim_ + 1);
    for (const label n : active_)
    {
        const scalar m = u[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            u[stride_*n + d] *= rm;
        }
    }
    constrain(u, stride_, false, false);
}


void Foam::mpm::velocityField::startFilter
(
    const series s,
    const scalar scale
)
{
    filtered_ = s;
    if (!increment_.data())
    {
        increment_ = alignedArray(stride_*grid_.nNodes());
        product_ = alignedArray(stride_*grid_.nNodes());
    }
    const scalar* from =
        s == ofUL ? UL_.data()
      : s == ofU ? U_.data()
      : s == ofDU ? dU_.data()
      : Ustrain_.data();
    scalar* v = increment_.data();
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            v[stride_*n + d] = scale*from[stride_*n + d];
        }
    }
}


Foam::scalar* Foam::mpm::velocityField::zeroProduct()
{
    scalar* Mv = product_.data();
    for (const label n : active_)
    {
        for (int c = 0; c < stride_; ++c)
        {
            Mv[stride_*n + c] = 0;
        }
    }
    return Mv;
}


void Foam::mpm::velocityField::nextIncrement(const series s)
{
    const scalar* mU = mU_.data();
    scalar* v = increment_.data();
    const scalar* Mv = product_.data();

    for (const label n : active_)
    {
        const scalar m = mU[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            v[stride_*n + d] -= rm*Mv[stride_*n + d];
        }
    }

    // Increments are zero at fixed nodes: the sum keeps their velocity
    rigid_.takeIncrement(v, mU, stride_, s != ofStrain);
    if (s == ofStrain)
    {
        constrain(v, stride_, true, false);
    }
    else
    {
        constrainStep(v, true);
    }
}


void Foam::mpm::velocityField::addToIncrement(const scalar* impulse)
{
    const scalar* mU = mU_.data();
    scalar* v = increment_.data();
    for (const label n : active_)
    {
        const scalar m = mU[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            v[stride_*n + d] += rm*impulse[stride_*n + d];
        }
    }
    constrainStep(v, true);
}


void Foam::mpm::velocityField::addIncrement(const series s, const scalar weight)
{
    const scalar* v = increment_.data();
    scalar* to = s == ofStrain ? Ustrain_.data() : UL_.data();
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            to[stride_*n + d] += weight*v[stride_*n + d];
            if (s == ofDU)
            {
                dU_.data()[stride_*n + d] += weight*v[stride_*n + d];
            }
        }
    }
}

// ************************************************************************* //
