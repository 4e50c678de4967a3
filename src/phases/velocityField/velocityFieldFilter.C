// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "velocityField.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::velocityField::strainFromU(const bool copy)
{
    strainIsU_ = !copy;
    if (copy)
    {
        scalar* to = strainMomentum();
        forComponents([&](const label i) { to[i] = U_.data()[i]; });
    }
}

void Foam::mpm::velocityField::strainFromUL(const scalar weight)
{
    scalar* to = strainMomentum();
    forComponents(
        [&](const label i)
        {
            const scalar u = U_.data()[i] + dU_.data()[i];
            to[i] = u + weight * (UL_.data()[i] - u);
        });
}

void Foam::mpm::velocityField::addChangeToStrain()
{
    forComponents([&](const label i) { Ustrain_.data()[i] += dU_.data()[i]; });
}

Foam::scalar* Foam::mpm::velocityField::strainMomentum()
{
    strainIsU_ = false;
    need(Ustrain_);
    return zero(Ustrain_);
}

void Foam::mpm::velocityField::strainFromMomentum()
{
    scalar* u = Ustrain_.data();
    shared_.sum(u, stride_, nDim_ + 1);
    forMasses(u, [&](const label i, const scalar rm) { u[i] *= rm; });
    constrain(u, stride_, false, false);
}

void Foam::mpm::velocityField::startFilter(const series s, const scalar scale)
{
    filtered_ = s;
    need(increment_);
    const scalar* from = s == ofUL ? UL_.data()
        : s == ofU                 ? U_.data()
        : s == ofDU                ? dU_.data()
                                   : Ustrain_.data();
    scalar* v = increment_.data();
    forComponents([&](const label i) { v[i] = scale * from[i]; });
}

void Foam::mpm::velocityField::nextIncrement(const series s)
{
    const scalar* mU = mU_.data();
    scalar* v = increment_.data();
    const scalar* Mv = product_.data();

    forMasses(mU, [&](const label i, const scalar rm) { v[i] -= rm * Mv[i]; });

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
    scalar* v = increment_.data();
    forMasses(mU_.data(), [&](const label i, const scalar rm) { v[i] += rm * impulse[i]; });
    constrainStep(v, true);
}

void Foam::mpm::velocityField::addIncrement(const series s, const scalar weight)
{
    const scalar* v = increment_.data();
    scalar* to = s == ofStrain ? Ustrain_.data() : UL_.data();
    forComponents(
        [&](const label i)
        {
            to[i] += weight * v[i];
            if (s == ofDU)
            {
                dU_.data()[i] += weight * v[i];
            }
        });
}
