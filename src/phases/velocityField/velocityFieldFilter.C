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
                U_.data()[stride_*n + d]
              + UL_.data()[2*stride_*n + stride_ + d];
            to[stride_*n + d] = u + weight*(UL_.data()[2*stride_*n + d] - u);
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


void Foam::mpm::velocityField::startFilter(const series s)
{
    // work = [increments v in 2 stride per node][sum of m S S^T v]
    if (!work_.data())
    {
        work_ = alignedArray(3*stride_*grid_.nNodes());
    }
    const scalar* from =
        s == FMPM ? UL_.data() : s == XPIC ? U_.data() : Ustrain_.data();
    const int step = s == FMPM ? 2*stride_ : stride_;
    scalar* v = work_.data();
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            v[2*stride_*n + d] = from[step*n + d];
        }
    }
}


Foam::scalar* Foam::mpm::velocityField::zeroProduct()
{
    scalar* Mv = work_.data() + 2*stride_*grid_.nNodes();
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
    scalar* v = work_.data();
    const scalar* Mv = v + 2*stride_*grid_.nNodes();

    for (const label n : active_)
    {
        const scalar m = mU[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            v[2*stride_*n + d] -= rm*Mv[stride_*n + d];
        }
    }

    // The sum keeps the fixed velocities: increments have none there
    const bool takes = reactions_ && s != strain;
    if (takes)
    {
        reactions_->add(active_, -1, v, 2*stride_, mU, stride_);
    }
    rigid_.takeIncrement(v, 2*stride_, mU, stride_, s != strain);
    if (s != strain)
    {
        rigid_.addImpulse(v, 2*stride_, true, mU, stride_);
    }
    constrain(v, 2*stride_, true, false);
    if (takes)
    {
        reactions_->add(active_, 1, v, 2*stride_, mU, stride_);
    }
}


void Foam::mpm::velocityField::addIncrement(const series s, const scalar weight)
{
    const scalar* v = work_.data();
    scalar* to = s == strain ? Ustrain_.data() : UL_.data();
    const int step = s == strain ? stride_ : 2*stride_;
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            to[step*n + d] += weight*v[2*stride_*n + d];
        }
    }
}

// ************************************************************************* //
