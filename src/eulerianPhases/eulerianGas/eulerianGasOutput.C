// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianGas.H"
#include "moreDigits.H"
#include "stepEntry.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::mpm::eulerianGas::stateOf(const label celli) const
{
    OStringStream os;
    const gasState& w = W_[celli];
    os << "Gas " << name_ << " has density " << w.rho << " kg/m3 and"
       << " pressure " << w.p << " Pa";
    if (T_)
    {
        os << ", temperature " << thermo_.T(w.rho, w.p) << " K";
    }
    if (!thermo_.isGammaLaw())
    {
        os << " and rho c^2 " << t_[celli].K << " Pa; density and rho c^2"
           << " must be positive,";
    }
    else
    {
        os << ", which must be positive,";
    }
    os << " in cell " << celli << " at " << mesh_.cellCentres()[celli] << ", time "
       << mesh_.time().timeName() << " (velocity " << w.u << ", theta " << theta_[celli] << ")."
       << nl << "At the start: look into 0/p, "
       << (readsRho() ? "0/rho." + name_ + ", "
               : T_   ? "0/T." + name_ + ", "
                      : string())
              .c_str()
       << "0/U." << name_ << " and constant/phaseProperties. Later: a smaller "
       << stepEntry(mesh_.time()) << " in"
       << " system/controlDict or upwind for reconstruct(...) in"
       << " system/fvSchemes often keeps the gas positive.";
    return os.str();
}

void Foam::mpm::eulerianGas::updateTemperature()
{
    forAll(W_, c)
    {
        (*T_)[c] = thermo_.T(W_[c].rho, W_[c].p);
    }
    for (fvPatchScalarField& T : T_->boundaryFieldRef())
    {
        const label start = T.patch().start() - mesh_.nInternalFaces();
        forAll(T, i)
        {
            const gasState& w = Wb_[start + i];
            T[i] = thermo_.T(w.rho, w.p);
        }
    }
}

void Foam::mpm::eulerianGas::forState(const fieldAction& f)
{
    scalarField& psi = psi_.primitiveFieldRef();
    forAll(psi, c)
    {
        psi[c] = W_[c].rho / (t_.empty() ? W_[c].p : t_[c].K);
    }
    eulerianFlow::forState(f);
    f(rho0_);
    if (T_)
    {
        if (!thermo_.isGammaLaw())
        {
            updateTemperature();
        }
        f(*T_);
    }
    volScalarField::Internal rho(
        header("thetaRho", IOobject::NO_READ, name_), mesh_, dimDensity, rho_);
    f(rho);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::eulerianFlow::heatState Foam::mpm::eulerianGas::heat(const label c) const
{
    const vector u(rhoU_[c] / rho_[c]);
    const scalar Cv = thermo_.Cv();
    return {(rhoE_[c] / rho_[c] - 0.5 * magSqr(u)) / Cv, rho_[c] * Cv, thermo_.Cp()};
}

Foam::mpm::eulerianFlow::waveState Foam::mpm::eulerianGas::wave(const label c) const
{
    const scalar K = t_.empty() ? thermo_.gamma() * W_[c].p : t_[c].K;
    return {K, std::sqrt(K * W_[c].rho), 0, 0};
}

void Foam::mpm::eulerianGas::needTemperature(const dictionary& dict) const
{
    if (!thermo_.hasTemperature())
    {
        FatalIOErrorInFunction(dict) << "The gas " << name_ << " (" << thermo_.description().c_str()
                                     << ") has no temperature and exchanges no heat. Use thermo"
                                     << " perfectGas." << exit(FatalIOError);
    }
}

void Foam::mpm::eulerianGas::report() const
{
    // Of cells that are more gas than solid
    scalar freeMin = GREAT, freeMax = -GREAT;
    label nPores = 0;
    forAll(W_, celli)
    {
        const scalar p = W_[celli].p;
        if (theta_[celli] > 0.5)
        {
            freeMin = min(freeMin, p);
            freeMax = max(freeMax, p);
        }
        else
        {
            ++nPores;
        }
    }
    {
        const moreDigits ofSums;
        Info << "Gas " << name_ << ": mass " << total(mass()) << ", momentum " << total(momentum());
        if (thermo_.hasEnergy())
        {
            Info << ", energy " << total(energy());
        }
    }
    Info << nl << "    p " << pressures().c_str() << ", outflow limited " << total(fixups_.limited)
         << ", theta kept " << total(fixups_.theta) << ", isentropic " << total(fixups_.isentropic)
         << " (energy " << total(fixups_.energy) << " added, mass " << total(fixups_.heldBack)
         << " held back)";
    if (const label n = total(fixups_.positive))
    {
        Info << ", kept positive at faces " << n;
    }
    reduce(freeMin, minOp<scalar>());
    reduce(freeMax, maxOp<scalar>());
    if (total(nPores) && freeMin <= freeMax)
    {
        Info << nl << "    where theta > 0.5: p " << freeMin << " to " << freeMax;
    }
    if (region_.used())
    {
        Info << ", " << total(region_.size()) << " of " << total(mesh_.nCells()) << " cells active";
    }
    Info << endl;
    reportFilled();
}

Foam::List<Foam::mpm::eulerianFlow::fluidSums> Foam::mpm::eulerianGas::fluidContents() const
{
    // Without an energy equation there is no internal energy
    const scalarField& V = mesh_.V();
    fluidSums s;
    forAll(rho_, c)
    {
        const scalar kinetic = 0.5 * magSqr(rhoU_[c]) / rho_[c];
        s.mass += V[c] * rho_[c];
        s.momentum += V[c] * rhoU_[c];
        s.kinetic += V[c] * kinetic;
        s.internal += energy_ ? V[c] * (rhoE_[c] - kinetic) : 0;
        s.volume += V[c] * theta_[c];
    }
    return List<fluidSums>(1, s);
}
