/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "velocityField.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar* Foam::mpm::velocityField::load()
{
    if (!load_.data())
    {
        load_ = alignedArray(stride_*grid_.nNodes());
    }
    return load_.data();
}


void Foam::mpm::velocityField::addLoad()
{
    if (!load_.data())
    {
        return;
    }
    sumColumn(load_.data());
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            f_.data()[stride_*n + d] += load_.data()[stride_*n + d];
        }
    }
}


Foam::scalar Foam::mpm::velocityField::loadWork(const scalar dt) const
{
    scalar work = 0;
    for (label i = 0; load_.data() && i < active_.size(); ++i)
    {
        const label n = active_[i];
        for (int d = 0; d < nDim_; ++d)
        {
            work +=
                part(n)*dt*load_.data()[stride_*n + d]
               *(
                    U_.data()[stride_*n + d]
                  + 0.5*dU_.data()[stride_*n + d]
                );
        }
    }
    return work;
}


const Foam::scalarList& Foam::mpm::velocityField::nodeVolume
(
    const pointGridTransfer& transfer
)
{
    if (nodeVolume_.empty())
    {
        nodeVolume_ = transfer.nodeVolumes(grid_, false);
    }
    return nodeVolume_;
}

// ************************************************************************* //
