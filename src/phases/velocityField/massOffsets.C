// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "massOffsets.H"

namespace
{

//- a x b/m of three components
void crossOver(const Foam::scalar* a, const Foam::scalar* b, const Foam::scalar m, Foam::scalar* to)
{
    for (int i = 0; i < 3; ++i)
    {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i] = (a[j] * b[k] - a[k] * b[j]) / m;
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar* Foam::mpm::massOffsets::zero(alignedArray& q) const
{
    const int P = field_.stride();
    for (const label l : field_.active())
    {
        std::fill_n(q.data() + P * l, P, 0.0);
    }
    return q.data();
}

void Foam::mpm::massOffsets::update()
{
    if (hold_)
    {
        return;
    }
    hold_ = true;
    const int P = field_.stride(), D = field_.nDim();
    scalar* d = zero(d_);
    scalar* volume = zero(part_);
    forAll(clouds_, i)
    {
        passes_.addOffsets(clouds_[i], rho_[i], d, volume);
    }
    field_.sumWithMass(d);
    field_.sumShared(volume, P, 1);
    const scalarList& whole = field_.nodeVolume(transfer_);
    turning_.clear();
    for (const label l : field_.active())
    {
        const scalar full = volume[P * l] / whole[l], m = d[P * l + D];
        const scalar share = m > 0 ? min(max(10 * (0.95 - full), scalar(0)), scalar(1)) / m : 0;
        for (int i = 0; i < D; ++i)
        {
            d[P * l + i] *= share;
        }
        if (share > 0)
        {
            turning_.append(l);
        }
    }
    for (const materialPointCloud& cloud : clouds_)
    {
        passes_.findTurning(cloud, d);
    }
}

void Foam::mpm::massOffsets::turn(const scalar* u)
{
    const int P = field_.stride(), D = field_.nDim();
    scalar* spin = zero(spin_);
    for (const materialPointCloud& cloud : clouds_)
    {
        passes_.addSpins(cloud, u, spin);
    }
    field_.sumShared(spin, P, D == 2 ? 1 : D);
    scalar* to = zero(part_);
    for (const label l : turning_)
    {
        const scalar* w = spin + P * l;
        const scalar* d = d_.data() + P * l;
        scalar* t = to + P * l;
        if (D == 2)
        {
            t[0] = -w[0] * d[1] / d[D];
            t[1] = w[0] * d[0] / d[D];
            continue;
        }
        crossOver(w, d, d[D], t);
    }
    field_.constrain(to, P, true, false);
}

void Foam::mpm::massOffsets::couple(scalar* f)
{
    const int P = field_.stride(), D = field_.nDim();
    field_.constrain(f, P, true, false);
    scalar* couples = zero(spin_);
    for (const label l : turning_)
    {
        const scalar* fl = f + P * l;
        const scalar* d = d_.data() + P * l;
        scalar* c = couples + P * l;
        if (D == 2)
        {
            c[0] = (d[0] * fl[1] - d[1] * fl[0]) / d[D];
            continue;
        }
        crossOver(d, fl, d[D], c);
    }
    scalar* to = zero(part_);
    for (const materialPointCloud& cloud : clouds_)
    {
        passes_.addCouples(cloud, couples, to);
    }
    field_.sumColumn(to);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::massOffsets::massOffsets(
    velocityField& field, const pointGridTransfer& transfer, const label nNodes) :
    field_(field),
    transfer_(transfer),
    passes_(dynamic_cast<const twoLevelShares&>(transfer)),
    nNodes_(nNodes),
    hold_(false),
    d_(field.stride() * nNodes),
    u_(field.stride() * nNodes),
    spin_(field.stride() * nNodes),
    part_(field.stride() * nNodes)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::scalar* Foam::mpm::massOffsets::velocity(const scalar* u)
{
    update();
    const int P = field_.stride();
    for (label round = 0; round < rounds; ++round)
    {
        turn(round ? u_.data() : u);
        for (const label l : field_.active())
        {
            for (int i = 0; i < P; ++i)
            {
                u_.data()[P * l + i] = u[P * l + i] + part_.data()[P * l + i];
            }
        }
    }
    return u_.data();
}

void Foam::mpm::massOffsets::turnOn(moveCoefficients& take, pointGridTransfer::nodeVelocities& of)
{
    const int P = field_.stride();
    if (!moving_.data())
    {
        moving_ = alignedArray(P * nNodes_);
    }
    scalar* w = moving_.data();
    const auto forAllValues = [&](const auto& f)
    {
        for (const label l : field_.active())
        {
            for (int i = 0; i < P; ++i)
            {
                f(P * l + i);
            }
        }
    };
    forAllValues([&](const label i)
                 { w[i] = take.b1 * of.dU[i] + take.b2 * of.UL[i] + take.b3 * of.U[i]; });
    velocity(w);
    if (take.b3 == 0)
    {
        take.b3 = 1;
        take.b1 = take.b2 = 0;
        of.U = u_.data();
        return;
    }
    forAllValues([&](const label i) { w[i] = of.U[i] + (u_.data()[i] - w[i]) / take.b3; });
    of.U = w;
}

void Foam::mpm::massOffsets::addCouples(scalar* f)
{
    update();
    const int P = field_.stride(), D = field_.nDim();
    for (label round = 0; round < rounds; ++round)
    {
        const scalar* from = round ? part_.data() : f;
        for (const label l : field_.active())
        {
            std::copy_n(from + P * l, P, u_.data() + P * l);
        }
        couple(u_.data());
        for (const label l : field_.active())
        {
            for (int i = 0; i < D; ++i)
            {
                f[P * l + i] += part_.data()[P * l + i];
            }
        }
    }
}
