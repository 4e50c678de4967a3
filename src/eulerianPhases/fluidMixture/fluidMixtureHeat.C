// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fluidMixture.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::fluidMixture::relaxAgain(
    const share* s, const scalar P, const scalar* Q, scalar* theta) const
{
    FixedList<share, most> heated;
    FixedList<scalar, most> volumes;
    scalar volume = 0;
    forAll(fluids_, k)
    {
        share& h = heated[k];
        h = s[k];
        if (h.m > 0)
        {
            h.A = theta[k];
            h.e0 = h.A * energy(k, h.m / theta[k], P, h.F) + Q[k];
            volume += h.A;
        }
    }
    bool found = true;
    const scalar next = relax(heated.cdata(), volume, volumes.begin(), nullptr, &found, false);
    forAll(fluids_, k)
    {
        // What cools has a volume left
        found = found && (!(s[k].m > 0) || volumes[k] > 0);
    }
    if (!found || !(next > 0))
    {
        return P;
    }
    std::copy_n(volumes.begin(), size(), theta);
    return next;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::fluidMixture::heat(
    const share* s, const scalar P, const scalar Q, const scalar part, scalar* theta) const
{
    FixedList<scalar, most> to;
    scalar mass = 0, rest = Q;
    forAll(fluids_, k)
    {
        to[k] = 0;
        if (thermo(k).isGammaLaw() && s[k].m > 0)
        {
            // Of work by the last pressure to that of the mean one, but no
            // colder than the isentrope
            const scalar A = s[k].A, more = theta[k] - A;
            const scalar gamma = stiff_[k].gamma, p = (gamma - 1) * s[k].e0 / A;
            to[k] = 0.5 * (P - p) * more;
            if (mag(more) > 1e-3 * A)
            {
                const scalar ps = p * std::pow(A / theta[k], gamma);
                to[k] = max(to[k], theta[k] * (ps - P) / (gamma - 1));
            }
            to[k] *= part;
            rest -= to[k];
        }
    }
    const auto takes = [&](const label k)
    { return rest > 0 || !thermo(k).isGammaLaw() ? s[k].m : scalar(0); };
    forAll(fluids_, k)
    {
        mass += takes(k);
    }
    forAll(fluids_, k)
    {
        to[k] += rest * takes(k) / max(mass, VSMALL);
    }
    return relaxAgain(s, P, to.cdata(), theta);
}

Foam::scalar
Foam::mpm::fluidMixture::raise(const share* s, scalar& P, const scalar least, scalar* theta) const
{
    FixedList<scalar, most> to;
    scalar added = 0;
    forAll(fluids_, k)
    {
        to[k] = 0;
        if (thermo(k).isGammaLaw() && s[k].m > 0)
        {
            const scalar rho = s[k].m / theta[k];
            to[k] = theta[k] * (least - P) * rho / at(k, rho, s[k].F).B;
            added += to[k];
        }
    }
    P = relaxAgain(s, P, to.cdata(), theta);
    return added;
}
