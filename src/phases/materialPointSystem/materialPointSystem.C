/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "phaseDamping.H"
#include "rigidBodies.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(materialPointSystem, 0);
}
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::materialPointSystem::indexOf(const word& phase) const
{
    forAll(phases_, phasei)
    {
        if (phases_[phasei].name() == phase)
        {
            return phasei;
        }
    }
    return -1;
}


Foam::label Foam::mpm::materialPointSystem::nPoints() const
{
    label n = 0;
    for (const materialPointPhase& phase : phases_)
    {
        n += phase.cloud().size();
    }
    return returnReduce(n, sumOp<label>());
}


Foam::scalar Foam::mpm::materialPointSystem::bytesPerPoint() const
{
    scalar bytes = 0;
    label n = 0;
    forAll(phases_, phasei)
    {
        const materialPointCloud& cloud = phases_[phasei].cloud();
        bytes += cloud.bytesPerPoint()*cloud.size();
        bytes +=
            cellChanges_[phasei].capacity()*sizeof(materialPointCloud::cellChange);
        n += cloud.size();
    }
    reduce(bytes, sumOp<scalar>());
    reduce(n, sumOp<label>());
    return bytes/max(n, label(1));
}


Foam::scalar Foam::mpm::materialPointSystem::gridBytes() const
{
    scalar bytes = 0;
    for (const velocityField& field : fields_)
    {
        bytes += field.bytes();
    }
    return returnReduce(bytes, sumOp<scalar>());
}


bool Foam::mpm::materialPointSystem::damps() const
{
    return parts_.find<phaseDamping>()->damps();
}


void Foam::mpm::materialPointSystem::couple(pointCoupling& coupling)
{
    if (stressUpdate_->early())
    {
        FatalIOErrorInFunction
        (
            mesh_.solutionDict().subDict("materialPoints")
        )   << "stressUpdate " << stressUpdate_->type() << " does not work in"
            << " a gas, which has to act on the stress of the start of the"
            << " step." << nl << "Valid choice: MUSL" << exit(FatalIOError);
    }
    if (outflow_)
    {
        FatalIOErrorInFunction(properties_.subDict("outflow"))
            << "There is an outflow, which does not work in a gas: the cell of"
            << " a point that leaves would have its gas expand at once into the"
            << " free volume." << nl << "Remove outflow, and make the mesh"
            << " larger or keep points inside by the boundary conditions of"
            << " their velocity." << exit(FatalIOError);
    }
    if (damps())
    {
        FatalIOErrorInFunction(properties_)
            << "damping does not work in a gas, whose drag has to take what"
            << " the points lose." << exit(FatalIOError);
    }
    const bool shares = rigid_->shares();
    coupling_ = &coupling;
    parts_.add(coupling);
    if (shares)
    {
        // In a gas rigid bodies do not share nodes
        startNodes();
    }
}


void Foam::mpm::materialPointSystem::addImpulse
(
    const label fieldi,
    scalar* impulse
)
{
    velocityField& field = fields_[fieldi];
    field.sumColumn(impulse);
    const scalar work = field.addImpulse(impulse, energy_->active());
    if (energy_->active())
    {
        energy_->sums().step.boundary += returnReduce(work, sumOp<scalar>());
    }
}

// ************************************************************************* //
