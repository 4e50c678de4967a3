// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pressureForce.H"
#include "granularForce.H"
#include "pointEnergy.H"
#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pressureForce::sumLoad(const label phasei)
{
    const pointGrid& grid = points_.grid();
    const int D = grid.nDim();
    materialPointCloud& cloud = points_.phases()[phasei].cloud();
    vector& load = load_[phasei];
    load = Zero;
    for (int d = 0; d < D; ++d)
    {
        const scalar* F = (*cloud.gasForce())[d];
        load[grid.direction(d)] = std::accumulate(F, F + cloud.size(), scalar(0));
    }

    freeBody* body = points_.phases()[phasei].motion()->free();
    if (!body)
    {
        return;
    }
    vector torque(Zero);
    for (label p = 0; p < cloud.size(); ++p)
    {
        vector arm(Zero), F(Zero);
        for (int d = 0; d < D; ++d)
        {
            const int c = grid.direction(d);
            arm[c] = cloud.x()[d][p] - body->centre(false)[c];
            F[c] = (*cloud.gasForce())[d][p];
        }
        torque += arm ^ F;
    }
    body->setPush(load, torque);
}

void Foam::mpm::pressureForce::gatherApart(const label phasei, const scalarField& pOwn)
{
    materialPointCloud& cloud = points_.phases()[phasei].cloud();
    const int D = points_.grid().nDim();
    if (!grainPush_.set(phasei))
    {
        grainPush_.set(phasei, new column("grainPush", column::vectors, D));
    }
    column& push = grainPush_[phasei];
    if (push.capacity() < cloud.size())
    {
        push.reserve(cloud.size(), 0);
    }
    fraction_.gather(phasei, nullptr);
    for (int d = 0; d < D; ++d)
    {
        const scalar* F = (*cloud.gasForce())[d];
        std::copy(F, F + cloud.size(), push[d]);
    }
    fraction_.gather(phasei, &pOwn);
    const scalar* m = cloud.mass()[0];
    for (int d = 0; d < D; ++d)
    {
        const scalar* F = (*cloud.gasForce())[d];
        scalar* b = push[d];
        for (label p = 0; p < cloud.size(); ++p)
        {
            b[p] = (F[p] - b[p]) / m[p];
        }
    }
}

Foam::scalar Foam::mpm::pressureForce::grainWork(const label phasei, const scalar dt)
{
    const velocityField& field = points_.fields()[points_.fieldOf(phasei)];
    const int D = points_.grid().nDim(), stride = field.stride();
    nodeForce_.setSize(stride * points_.grid().nNodes());
    nodeForce_ = 0;
    points_.gridTransfer().addBodyForce(
        points_.phases()[phasei].cloud(), grainPush_[phasei], nodeForce_.data());
    const scalarList& u = points_.energy().meanVelocity(points_.fieldOf(phasei));

    // Of own points only: nodes that processors share need no sum
    scalar work = 0;
    for (const label n : field.active())
    {
        for (label i = stride * n; i < stride * n + D; ++i)
        {
            work += nodeForce_[i] * u[i];
        }
    }
    return dt * work;
}

void Foam::mpm::pressureForce::dryPressure(const label phasei)
{
    materialPointCloud& cloud = points_.phases()[phasei].cloud();
    scalar* pressure = (*cloud.gasPressure())[0];
    if (points_.phases()[phasei].grains())
    {
        std::fill(pressure, pressure + cloud.size(), scalar(0));
    }
    else
    {
        const scalar* v = cloud.volume()[0];
        const scalar* ofGas = (*cloud.gasVolume())[0];
        for (label p = 0; p < cloud.size(); ++p)
        {
            if (ofGas[p] < v[p])
            {
                pressure[p] = 0;
            }
        }
    }
    if (const column* damage = cloud.damage())
    {
        for (label p = 0; p < cloud.size(); ++p)
        {
            if ((*damage)[0][p] >= 1)
            {
                pressure[p] = 0;
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pressureForce::pressureForce(
    materialPointSystem& points, const eulerianFlow& gas, solidFraction& fraction) :
    points_(points),
    gas_(gas),
    fraction_(fraction),
    load_(points.phases().size(), Zero),
    work_(0),
    grainPush_(points.phases().size()),
    grainWork_(0)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pressureForce::start(
    granularForce& grains, const bool books, const pressureOverSteps& last, const scalar dt)
{
    const List<gasState>& W = gas_.states();
    const List<gasState>& Wb = gas_.boundaryStates();
    p_.setSize(W.size());
    forAll(W, c)
    {
        p_[c] = W[c].p;
    }
    pBehind_.setSize(Wb.size());
    forAll(Wb, i)
    {
        pBehind_[i] = Wb[i].p;
    }
    if (last.acts())
    {
        last.addTo(dt, p_, pBehind_);
    }
    fraction_.setPressure(p_, pBehind_);

    forAll(points_.phases(), phasei)
    {
        const scalarField* pOwn = grains.pressure(phasei);
        if (books && pOwn && !points_.phases()[phasei].motion())
        {
            gatherApart(phasei, *pOwn);
        }
        else
        {
            fraction_.gather(phasei, pOwn);
        }
        if (points_.phases()[phasei].motion())
        {
            sumLoad(phasei);
        }
        else
        {
            dryPressure(phasei);
        }
    }
}

void Foam::mpm::pressureForce::load(const scalar dt)
{
    forAll(points_.phases(), phasei)
    {
        if (points_.phases()[phasei].motion())
        {
            points_.fields()[points_.fieldOf(phasei)].rigid().addLoad(phasei, dt * load_[phasei]);
        }
    }
}

void Foam::mpm::pressureForce::sumWork(const scalar dt)
{
    grainWork_ = 0;
    forAll(grainPush_, phasei)
    {
        if (grainPush_.set(phasei))
        {
            grainWork_ += grainWork(phasei, dt);
        }
    }
    work_ = 0;
    scalar toPoints = 0;
    for (materialPointPhase& phase : points_.phases())
    {
        materialPointCloud& cloud = phase.cloud();
        scalar work = 0;
        for (int d = 0; d < points_.grid().nDim(); ++d)
        {
            const scalar* F = (*cloud.gasForce())[d];
            const scalar* dx = (*cloud.displacement())[d];
            for (label p = 0; p < cloud.size(); ++p)
            {
                work += F[p] * dx[p];
            }
        }
        work_ -= phase.prescribed() ? work : 0;
        toPoints += phase.prescribed() ? 0 : work;
    }
    points_.energy().book(points_.energy().sums().step.pressure, toPoints);
}

void Foam::mpm::pressureForce::addWork(gasBudget& sums)
{
    sums.rigid += work_;
    sums.granular += grainWork_;
    scalar compression = 0;
    forAll(points_.phases(), phasei)
    {
        materialPointCloud& cloud = points_.phases()[phasei].cloud();
        const scalar* P = (*cloud.gasPressure())[0];
        const scalar* v = (*cloud.gasVolume())[0];
        for (label p = 0; !points_.phases()[phasei].motion() && p < cloud.size(); ++p)
        {
            compression += P[p] * (v[p] - fraction_.oldVolume(phasei)[p]);
        }
    }
    points_.energy().book(points_.energy().sums().compression, compression);
    forAll(points_.phases(), phasei)
    {
        // Dry ones have no pressure in the step (dryPressure)
        const materialPointPhase& phase = points_.phases()[phasei];
        materialPointCloud& cloud = points_.phases()[phasei].cloud();
        const column* damage = cloud.damage();
        const scalar* P = (*cloud.gasPressure())[0];
        const bool apart = !phase.grains() && !phase.motion();
        DynamicList<label> dry;
        for (label p = 0; p < cloud.size(); ++p)
        {
            if ((damage && (*damage)[0][p] >= 1) || (apart && P[p] == 0))
            {
                dry.append(p);
            }
        }
        if (dry.empty())
        {
            continue;
        }

        // The pressure where the points are now; start() sets it anew
        fraction_.gather(phasei, nullptr);
        const scalar* v = (*cloud.gasVolume())[0];
        for (const label p : dry)
        {
            sums.dry += (1 - fraction_.eps()) * P[p] * (v[p] - fraction_.oldVolume(phasei)[p]);
        }
    }
}
