/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gasCoupling::loadRigid(const scalar dt)
{
    forAll(points_.phases(), phasei)
    {
        if (points_.phases()[phasei].motion())
        {
            points_.fields()[points_.fieldOf(phasei)].rigid().addLoad
            (
                phasei,
                dt*push_[phasei]
            );
        }
    }
}


void Foam::mpm::gasCoupling::pushBody
(
    freeBody& body,
    materialPointCloud& cloud,
    const vector& force
) const
{
    const int D = sums_.grid().nDim();
    vector torque(Zero);
    for (label p = 0; p < cloud.size(); ++p)
    {
        vector arm(Zero), F(Zero);
        for (int d = 0; d < D; ++d)
        {
            const int c = sums_.grid().direction(d);
            arm[c] = cloud.x()[d][p] - body.centre(false)[c];
            F[c] = (*cloud.gasForce())[d][p];
        }
        torque += arm ^ F;
    }
    body.setPush(force, torque);
}


void Foam::mpm::gasCoupling::bookRigid()
{
    const int D = sums_.grid().nDim();
    for (materialPointPhase& phase : points_.phases())
    {
        if (!phase.prescribed())
        {
            continue;
        }
        materialPointCloud& cloud = phase.cloud();
        for (int d = 0; d < D; ++d)
        {
            const scalar* F = (*cloud.gasForce())[d];
            const scalar* way = (*cloud.displacement())[d];
            for (label p = 0; p < cloud.size(); ++p)
            {
                rigidWork_ -= F[p]*way[p];
            }
        }
    }
}


void Foam::mpm::gasCoupling::bookDry()
{
    forAll(points_.phases(), phasei)
    {
        materialPointCloud& cloud = points_.phases()[phasei].cloud();
        if (!cloud.damage())
        {
            continue;
        }

        // The pressure where the points are now; start() sets it anew
        kernels_->gather(cloud, P_.cdata(), G_.cdata());
        const scalar* damage = (*cloud.damage())[0];
        const scalar* P = (*cloud.gasPressure())[0];
        const scalar* v = (*cloud.gasVolume())[0];
        for (label p = 0; p < cloud.size(); ++p)
        {
            if (damage[p] >= 1)
            {
                budget_.dry +=
                    (1 - eps_)*P[p]*(v[p] - oldVolume_[phasei][p]);
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::gasCoupling::needEnergy() const
{
    if (!gas_.thermo().hasEnergy())
    {
        FatalErrorInFunction
            << "An energy budget needs a gas with an energy: the thermo of "
            << gas_.name() << " is isentropic. Remove energyBudget from"
            << " fvSolution.materialPoints and function objects of type"
            << " materialPointEnergy, or use perfectGas." << exit(FatalError);
    }
}


void Foam::mpm::gasCoupling::startBudget()
{
    books_ = true;
    gas_.startBudget();
    budget_ = gasBudget();
    budget_.mass0 = gas_.mass();
    budget_.momentum0 = gas_.momentum();
    budget_.energy0 = gas_.energy();
}


Foam::mpm::gasBudget Foam::mpm::gasCoupling::balance() const
{
    gasBudget b(budget_);
    const eulerianGas::flows& gained = gas_.gained();
    b.mass = gas_.mass();
    b.momentum = gas_.momentum();
    b.energy = gas_.energy();
    b.massIn += gained.mass;
    b.boundaryImpulse += gained.impulse;
    b.gravityImpulse += gained.gravityImpulse;
    b.boundary += gained.energy;
    b.external += gained.gravityWork;
    b.fixups += gained.fixups;
    b.reduceAll();
    return b;
}


void Foam::mpm::gasCoupling::setBalance(const gasBudget& sums)
{
    startBudget();
    budget_ = Pstream::master() ? sums : gasBudget();
}

// ************************************************************************* //
