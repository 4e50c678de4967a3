// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "moreDigits.H"
#include "dictionaryTools.H"
#include "stepEntry.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::mpm::eulerianFluids::stateOf(const label celli) const
{
    const gasState& w = W_[celli];
    OStringStream os;
    os << "The fluids have density " << w.rho << " kg/m3, pressure " << w.p << " Pa and rho c^2 "
       << t_[celli].K << " Pa; density and rho c^2 must"
       << " be positive, in cell " << celli << " at " << mesh_.cellCentres()[celli] << ", time "
       << mesh_.time().timeName() << " (velocity " << w.u << "; shares";
    for (label k = 0; k < n_; ++k)
    {
        os << ' ' << mixture_.name(k) << ' ' << part_[n_ * celli + k];
    }
    os << ")." << nl << "At the start: look into 0/p, 0/U, 0/alpha.*, 0/T.*, 0/rho.* and"
       << " constant/phaseProperties. After a restart: into theta,"
       << " thetaRho.*, thetaRhoU, thetaRhoE, alpha.*, F.*, lambda.* of its time. Later:"
       << " a smaller " << stepEntry(mesh_.time()) << " in system/controlDict or upwind for"
       << " reconstruct(...) in system/fvSchemes often helps.";
    if (w.p < 0 && !canTear())
    {
        os << nl << aboutNuclei().c_str();
    }
    return os.str();
}

void Foam::mpm::eulerianFluids::forState(const fieldAction& f)
{
    eulerianFlow::forState(f);
    f(rho0_);
    scalarField m(mesh_.nCells());
    for (label k = 0; k < n_; ++k)
    {
        f(alpha_[k]);
        f(state_[k]);
        forAll(m, c)
        {
            m[c] = mass_[n_ * c + k];
        }
        volScalarField::Internal mass(
            header("thetaRho", IOobject::NO_READ, mixture_.name(k)), mesh_, dimDensity, m);
        f(mass);
    }
    for (carriedShare* s : {&burnt_, &lambda_})
    {
        for (volScalarField& field : s->fields())
        {
            f(field);
        }
    }
}

void Foam::mpm::eulerianFluids::checkSoftened() const
{
    for (label k = 0; k < n_; ++k)
    {
        const scalar c = isGas(k) ? scalar(0) : mixture_.thermo(k).equation().softened();
        if (!(c > 0) || warned_[k])
        {
            continue;
        }
        scalar fastest = 0;
        forAll(W_, i)
        {
            if (part_[n_ * i + k] > 0.5 * theta_[i])
            {
                fastest = max(fastest, mag(W_[i].u));
            }
        }
        reduce(fastest, maxOp<scalar>());
        if (fastest > 0.1 * c)
        {
            warned_[k] = true;
            WarningInFunction << "Fluid " << mixture_.name(k) << " flows with " << fastest
                              << " m/s at time " << mesh_.time().timeName() << ", " << fastest / c
                              << " of its soundSpeed " << c << " m/s: its"
                              << " density changes by " << 100 * sqr(fastest / c) << " %." << nl
                              << "    Give it a soundSpeed of " << 10 * fastest
                              << " m/s or more, or pInf of the real liquid." << nl << endl;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::eulerianFlow::waveState Foam::mpm::eulerianFluids::wave(const label c) const
{
    const gasState& w = W_[c];
    const scalar slow = lowMachSolids_ ? min(scalar(1), mag(w.u) * w.rho / z_[c]) : 1;
    return {t_[c].K, z_[c], chi_ * liquid(z_[c], w), wet_ ? slow : 0};
}

Foam::mpm::eulerianFlow::heatState Foam::mpm::eulerianFluids::heat(const label c) const
{
    const scalar* theta = part_.cdata() + n_ * c;
    const scalar* m = mass_.cdata() + n_ * c;
    const scalar p =
        mixture_.pressure(theta, m, rhoE_[c] - 0.5 * magSqr(rhoU_[c]) / rho_[c], burntOf(c));
    scalar rhoCv = 0, rhoCvT = 0;
    for (label k = 0; k < n_; ++k)
    {
        if (m[k] > 0)
        {
            const gasThermo& thermo = mixture_.thermo(k);
            rhoCv += m[k] * thermo.Cv();
            rhoCvT += m[k] * thermo.Cv() * thermo.T(m[k] / theta[k], p);
        }
    }

    scalar rhoCp = 0;
    for (label k = 0; k < n_; ++k)
    {
        rhoCp += m[k] * (isGas(k) ? mixture_.thermo(k).Cp() : mixture_.thermo(k).Cv());
    }
    return {rhoCvT / rhoCv, rhoCv, rhoCp / rho_[c]};
}

void Foam::mpm::eulerianFluids::needTemperature(const dictionary& dict) const
{
    for (label k = 0; k < n_; ++k)
    {
        if (!mixture_.thermo(k).hasTemperature())
        {
            FatalIOErrorInFunction(dict)
                << "Fluid " << mixture_.name(k) << " (" << mixture_.description(k).c_str()
                << ") has no temperature and"
                << " exchanges no heat. Add its Cv [J/kg/K], or remove this"
                << " dictionary." << exit(FatalIOError);
        }
    }
}

Foam::wordList Foam::mpm::eulerianFluids::fluidNames() const
{
    wordList names(n_);
    forAll(names, k)
    {
        names[k] = mixture_.name(k);
    }
    return names;
}

Foam::List<Foam::mpm::eulerianFlow::fluidSums> Foam::mpm::eulerianFluids::fluidContents() const
{
    // Their energies by the common pressure. The sum is that of the cell, by
    // the largest, which may be torn
    const scalarField& V = mesh_.V();
    List<fluidSums> all(n_);
    forAll(rho_, c)
    {
        label most = 0;
        scalar sum = 0, sizes = 0;
        for (label k = 0; k < n_; ++k)
        {
            const scalar m = mass_[n_ * c + k], theta = part_[n_ * c + k];
            if (!(m > 0))
            {
                continue;
            }
            fluidSums& s = all[k];
            const scalar rho = m / theta;
            s.mass += V[c] * m;
            s.momentum += V[c] * m * W_[c].u;
            s.kinetic += 0.5 * V[c] * m * magSqr(W_[c].u);
            const scalar e = V[c] * theta * mixture_.energy(k, rho, W_[c].p, burntOf(c, k));
            s.internal += e;
            s.volume += V[c] * theta;
            sum += e;
            sizes += mag(e);
            most = m > mass_[n_ * c + most] ? k : most;
        }
        // Less is rounding
        const scalar rest = V[c] * (rhoE_[c] - 0.5 * (rhoU_[c] & W_[c].u)) - sum;
        all[most].internal += mag(rest) > 1e-9 * sizes ? rest : scalar(0);
    }
    return all;
}

void Foam::mpm::eulerianFluids::report() const
{
    const scalarField& V = mesh_.V();
    scalarField mass(n_, 0);
    label shared = 0;
    forAll(W_, c)
    {
        scalar largest = 0;
        for (label k = 0; k < n_; ++k)
        {
            mass[k] += V[c] * mass_[n_ * c + k];
            largest = max(largest, part_[n_ * c + k]);
        }
        shared += largest < (1 - fluidInterfaces::foreign) * theta_[c];
    }
    {
        const moreDigits ofSums;
        Info << "Fluids: mass";
        for (label k = 0; k < n_; ++k)
        {
            Info << ' ' << mixture_.name(k) << ' ' << total(mass[k]);
        }
        Info << ", momentum " << total(momentum()) << ", energy " << total(energy()) << nl;
    }
    Info << "    p " << pressures().c_str() << ", cells at interfaces " << total(shared)
         << " (mixed " << total(interfaces_->cells().size()) << "), outflow limited "
         << total(fixups_.limited) << ", theta kept " << total(fixups_.theta)
         << ", pressure of relaxation kept " << total(relaxed_) << ", isentropic "
         << total(fixups_.isentropic) << ", voids " << total(voids_) << " (energy "
         << total(fixups_.energy) << " added, mass " << total(fixups_.heldBack) << " held back, "
         << total(dropped_) << " dropped)" << endl;
    const label bounded = total(fixups_.positive);
    if (bounded || fixups_.halved)
    {
        Info << "    faces with bounded fluxes " << bounded << ", steps halved " << fixups_.halved
             << endl;
    }
    for (const label k : burnt_.of())
    {
        Info << "    burnt of " << mixture_.name(k) << ": " << burnt_.total(k, mass_, V) << endl;
    }
    for (const label k : lambda_.of())
    {
        const scalar share = lambda_.total(k, mass_, V);
        Info << "    burned on of " << mixture_.name(k) << ": " << share << ", energy "
             << mixture_.burnsOn(k)->Q() * share * total(mass[k]) << endl;
    }
    reportFilled();
    checkSoftened();
    checkTension();
}

Foam::dictionary Foam::mpm::eulerianFluids::state() const
{
    dictionary state(eulerianFlow::state());
    state.add("relaxed", total(relaxed_));
    state.add("voids", total(voids_));
    state.add("dropped", total(dropped_));
    return state;
}

void Foam::mpm::eulerianFluids::setState(const dictionary& state)
{
    eulerianFlow::setState(state);
    const bool keeps = Pstream::master();
    relaxed_ = keeps ? required<label>(state, "relaxed") : 0;
    voids_ = keeps ? required<label>(state, "voids") : 0;
    dropped_ = keeps ? required<scalar>(state, "dropped") : 0;
}
