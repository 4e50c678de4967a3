// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "noTraps.H"
#include "stepEntry.H"
#include "StringStream.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Least pressure of a void in a liquid over the liquid's modulus (260 Pa of
//  water, a tenth of its vapour's at 20 degrees C): traces of gas would reach
//  1e-45 Pa, and what closes such voids follows from rounding
constexpr Foam::scalar leastOfVoid = 1e-7;

//- Largest energy of a cell's fix-up over that of the cell, where a smaller step
//  may need none
constexpr Foam::scalar mostKept = 0.05;

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianFluids::startShares(const scalar dt)
{
    const DynamicList<label>& cells = interfaces_->cells();
    shares_.setSize(n_ * cells.size());
    densities_.setSize(shares_.size());
    perVolume_.setSize(cells.size());
    forAll(cells, s)
    {
        const label c = cells[s];
        perVolume_[s] = dt / V_[c];
        for (label k = 0; k < n_; ++k)
        {
            const scalar theta = part_[n_ * c + k], m = mass_[n_ * c + k];
            const scalar rho = m > 0 ? m / theta : 0, F = burntOf(c, k);
            densities_[n_ * s + k] = rho;
            shares_[n_ * s + k] = {
                theta, m, m > 0 ? theta * mixture_.energy(k, rho, W_[c].p, F) : 0, F};
            if (m > 0 && isTorn(c, k))
            {
                shares_[n_ * s + k].e0 = theta * t_[c].rhoE;
            }
        }
    }
}

bool Foam::mpm::eulerianFluids::relaxCell(const label s)
{
    const label c = interfaces_->cells()[s];
    fluidMixture::share* share = shares_.begin() + n_ * s;
    scalar* part = part_.begin() + n_ * c;
    scalar* mass = mass_.begin() + n_ * c;
    label only = -1, several = 0;
    bool gas = false, other = false;
    FixedList<scalar, fluidMixture::most> theta;
    for (label k = 0; k < n_; ++k)
    {
        fluidMixture::share& of = share[k];
        const scalar before = mass[k] > 0 ? mass[k] / part[k] : 0;
        const bool rounding = of.A < 1e-20 || of.m <= 0
            || (of.A < 1e-12 && before > 0
                && (of.m > 10 * before * of.A || of.m < 0.1 * before * of.A));
        if (rounding)
        {
            if (of.A < -1e-10 * theta_[c] && !lastTry_)
            {
                return false;
            }
            if (of.A < -1e-10 * theta_[c] && badCell_ < 0)
            {
                badCell_ = c;
                OStringStream os;
                os << "Fluid " << mixture_.name(k) << " has flown out of cell " << c << " at "
                   << mesh_.cellCentres()[c] << ", which has"
                   << " none left, time " << mesh_.time().value() << "." << nl << "A smaller "
                   << stepEntry(mesh_.time()) << " in system/controlDict helps.";
                whyBad_ = os.str();
            }
            dropped_ += of.m * V_[c];
            of = {0, 0, 0};
        }
        else
        {
            // What has left a void: less than any rounding, but more than what
            // can't be squared
            const scalar trace = max(1e-30 * rho_[c] * of.A - of.m, scalar(0));
            of.m += trace;
            dropped_ -= trace * V_[c];
            only = k;
            ++several;
            (isGas(k) ? gas : other) = true;
        }
    }
    relaxedP_[c] = -1;
    if (several <= 1)
    {
        for (label k = 0; k < n_; ++k)
        {
            part[k] = k == only ? theta_[c] : 0;
            mass[k] = share[k].m;
        }
        rho_[c] = only < 0 ? 0 : mass[only];
        if (beside_ && near_[c] && only >= 0 && isGas(only))
        {
            keepIsentrope(c, only, W_[c].rho, W_[c].p);
        }
        return only >= 0 && isState(only, c);
    }
    bool common = true;
    // Beside solid, which may close a cell in a step, halves come before a stand-in
    const bool any = lastTry_ || !(beside_ && near_[c]);
    const scalar P = mixture_.relax(share, theta_[c], theta.begin(), nullptr, &common, any);
    if (!common && !lastTry_)
    {
        return false;
    }
    if (!common && badCell_ < 0)
    {
        badCell_ = c;
        OStringStream os;
        os << "The fluids of cell " << c << " at " << mesh_.cellCentres()[c]
           << " have no pressure in common at which all have a speed of"
           << " sound (a fluid in tension, or a share that has expanded far),"
           << " time " << mesh_.time().value() << ":";
        for (label k = 0; k < n_; ++k)
        {
            os << ' ' << mixture_.name(k) << " volume " << share[k].A << ", mass " << share[k].m
               << ", energy " << share[k].e0 << (k + 1 < n_ ? ";" : ".");
        }
        os << nl << "At the start: look into 0/p, 0/U, 0/alpha.*, 0/T.* and 0/rho.*. Later: a"
           << " smaller " << stepEntry(mesh_.time())
           << " in system/controlDict or upwind for reconstruct(...) in"
           << " system/fvSchemes often helps.";
        whyBad_ = os.str();
    }
    scalar total = 0;
    for (label k = 0; k < n_; ++k)
    {
        part[k] = theta[k];
        mass[k] = share[k].m;
        total += mass[k];
    }
    rho_[c] = total;
    return heatCell(c, share, P, gas, other);
}

Foam::scalar Foam::mpm::eulerianFluids::ofGas(const label c) const
{
    scalar sum = 0;
    for (label k = 0; k < n_; ++k)
    {
        sum += isGas(k) ? mass_[n_ * c + k] : scalar(0);
    }
    return sum;
}

Foam::scalar Foam::mpm::eulerianFluids::mostOfEmpty(const label c) const
{
    // What a void had of energy stays when all mass has gone: without this
    // bound c^2 = p/rho has none (8e5 m/s in a cavity of 4e-10 kg/m3). No gas
    // has p/rho of 1000 times the liquid's c^2
    const scalar* mass = mass_.cdata() + n_ * c;
    scalar rho0 = 0, c2 = 0;
    for (label k = 0; k < n_; ++k)
    {
        if (!isGas(k) && mass[k] > 0)
        {
            rho0 = max(rho0, mixture_.rho0(k));
            c2 = max(c2, sqr(mixture_.least(k).c));
        }
    }
    const bool empty = c2 > 0 && rho_[c] < 1e-4 * rho0 * theta_[c];
    const scalar bound = ofGas(c) < 1e-6 * rho_[c] ? 1 : 1000;
    return empty ? bound * rho_[c] / theta_[c] * c2 : GREAT;
}

bool Foam::mpm::eulerianFluids::heatCell(
    const label c, const fluidMixture::share* share, scalar P, const bool gas, const bool other)
{
    scalar* part = part_.begin() + n_ * c;
    const scalar* mass = mass_.cdata() + n_ * c;
    const scalar kinetic = 0.5 * magSqr(rhoU_[c]) / rho_[c];
    const scalar* F = burntOf(c);
    const scalar energy = rhoE_[c] - kinetic;
    scalar wet = 0, least = 0, p = -1;
    if (other)
    {
        const fluidMixture::moduli at = mixture_.at(part, mass, P, F);
        const scalar Q = energy - at.energy;
        wet = min(at.liquid / 0.8, scalar(1));
        if (gas)
        {
            // Nor do traces of gas take the heat of products (1e14 J/kg in
            // what was left between two slugs that met)
            wet = max(wet, min((1e-6 - ofGas(c) / rho_[c]) / 9e-7, scalar(1)));
        }
        least = min(leastOfVoid * at.stiffest, mostOfEmpty(c));
        if (wet > 0 && Q > -1e-3 * at.store)
        {
            P = mixture_.heat(share, P, wet * Q, wet, part);
            p = wet == 1 ? P : -1;
        }
    }
    if (p < 0)
    {
        p = mixture_.pressure(part, mass, energy, F);
    }
    if (!gas && p < 0 && mixture_.at(part, mass, p, F).torn)
    {
        // Torn, as one fluid is
        scalar fast = 0;
        for (label k = 0; k < n_; ++k)
        {
            fast = mass[k] > 0 ? max(fast, mixture_.least(k).c) : fast;
        }
        relaxedP_[c] = 1e-7 * sqr(fast) * rho_[c] / theta_[c];
        return !firstTry_ && (lastTry_ || energy / rho_[c] > leastAround(c) - 0.05 * sqr(fast));
    }
    if (gas && !(p >= 0.3 * P))
    {
        const scalar E = mixture_.at(part, mass, P, F).energy + kinetic;
        if (!lastTry_ && E - rhoE_[c] > mostKept * (mag(rhoE_[c]) + kinetic))
        {
            return false;
        }
        bookFixup(c, (E - rhoE_[c]) * V_[c]);
        rhoE_[c] = E;
        p = P;
        ++relaxed_;
    }
    const scalar most = gas && other ? mostOfEmpty(c) : GREAT;
    if (p > most)
    {
        const scalar E = mixture_.at(part, mass, most, F).energy + kinetic;
        bookFixup(c, (E - rhoE_[c]) * V_[c]);
        rhoE_[c] = E;
        p = most;
        ++voids_;
    }
    if (gas && wet == 1 && p < least)
    {
        const scalar E = mixture_.raise(share, p, least, part);
        bookFixup(c, E * V_[c]);
        rhoE_[c] += E;
        ++voids_;
    }
    relaxedP_[c] = wet > 0 ? p : -1;
    return mag(p) < GREAT && mag(rhoE_[c]) < GREAT;
}
