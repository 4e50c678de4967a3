// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::mpm::eulerianFluids::settings(const dictionary& properties)
{
    return properties.found("fluids") ? requiredDict(properties, "fluids") : dictionary::null;
}

Foam::volScalarField* Foam::mpm::eulerianFluids::newField(
    const word& name, const label k, const fieldStates* states, const bool there,
    const scalar value) const
{
    const word& of = mixture_.name(k);
    if (there)
    {
        return new volScalarField(startField<volScalarField>(name, states, of));
    }
    return new volScalarField(
        header(name, IOobject::NO_READ, of), mesh_,
        dimensionedScalar(name, dimensionsOf(name), value), "zeroGradient");
}

bool Foam::mpm::eulerianFluids::hasState(const fieldStates* states) const
{
    if (states)
    {
        return true;
    }
    DynamicList<word> found, missing;
    const auto look = [&](const word& name, const word& of)
    {
        const IOobject io(header(name, IOobject::MUST_READ, of));
        bool here;
        isThere(io, &here);
        (here ? found : missing).append(io.name());
    };
    look("thetaRhoU", group_);
    look("thetaRhoE", group_);
    for (label k = 0; k < n_; ++k)
    {
        look("thetaRho", mixture_.name(k));
    }
    if (returnReduce(found.empty(), andOp<bool>()))
    {
        return false;
    }
    for (label k = 0; k < n_; ++k)
    {
        look("alpha", mixture_.name(k));
        if (mixture_.detonates(k))
        {
            look("F", mixture_.name(k));
        }
        if (mixture_.burnsOn(k))
        {
            look("lambda", mixture_.name(k));
        }
    }
    if (tells(missing.size()))
    {
        FatalErrorInFunction << "Time " << mesh_.time().timeName() << " has not all of the state"
                             << " of the fluids: there are " << flatOutput(found) << ", but no "
                             << flatOutput(missing) << " in " << mesh_.time().timePath() << "."
                             << nl
                             << "Start from another time. Without any of the files thetaRho.*,"
                             << " thetaRhoU, thetaRhoE the run starts from p, U, alpha.*, T.*"
                             << " and rho.*." << exit(FatalError);
    }
    return true;
}

void Foam::mpm::eulerianFluids::makeFields(const fieldStates* states)
{
    restarted_ = hasState(states);

    // Shares: one file may be missing, that of what is left
    label missing = -1;
    alpha_.setSize(n_);
    state_.setSize(n_);
    for (label k = 0; k < n_; ++k)
    {
        if (!(states || inFile("alpha", k)) && missing < 0)
        {
            missing = k;
            continue;
        }
        alpha_.set(k, newField("alpha", k, states, true, 0));
    }
    if (missing >= 0)
    {
        if (n_ == 1)
        {
            alpha_.set(0, newField("alpha", 0, states, false, 1));
        }
        else
        {
            // With the conditions of another, whose values it complements
            const volScalarField& other = alpha_[missing ? 0 : 1];
            alpha_.set(
                missing,
                new volScalarField(
                    header("alpha", IOobject::NO_READ, mixture_.name(missing)), other));
            volScalarField& left = alpha_[missing];
            left.primitiveFieldRef() = 1;
            for (fvPatchScalarField& b : left.boundaryFieldRef())
            {
                if (b.fixesValue() && !b.coupled())
                {
                    static_cast<scalarField&>(b) = 1;
                }
            }
            for (label k = 0; k < n_; ++k)
            {
                if (k == missing)
                {
                    continue;
                }
                left.primitiveFieldRef() -= alpha_[k].primitiveField();
                forAll(left.boundaryField(), patchi)
                {
                    fvPatchScalarField& b = left.boundaryFieldRef()[patchi];
                    if (b.fixesValue() && !b.coupled())
                    {
                        static_cast<scalarField&>(b) -= alpha_[k].boundaryField()[patchi];
                    }
                }
            }
        }
    }
    for (label k = 0; k < n_; ++k)
    {
        const word name(isGas(k) ? "T" : "rho");
        const bool there = states || isGas(k) || inFile(name, k);
        state_.set(k, newField(name, k, states, there, mixture_.rho0(k)));
    }
}

void Foam::mpm::eulerianFluids::checkShares()
{
    const noTraps guard;
    scalarField sum(mesh_.nCells(), Zero);
    forAll(alpha_, k)
    {
        scalarField& a = alpha_[k].primitiveFieldRef();
        forAll(a, c)
        {
            if (!(a[c] > -1e-9 && a[c] < 1 + 1e-9))
            {
                FatalErrorInFunction << "Field " << alpha_[k].name() << " in "
                                     << alpha_[k].objectPath() << " has the value " << a[c]
                                     << " in cell " << c << " at " << mesh_.cellCentres()[c]
                                     << "; a share of the volume is in [0, 1]." << exit(FatalError);
            }
            a[c] = min(max(a[c], scalar(0)), scalar(1));
            sum[c] += a[c];
        }
    }
    forAll(sum, c)
    {
        if (mag(sum[c] - 1) > 1e-6)
        {
            FatalErrorInFunction << "The shares alpha of the fluids add up to " << sum[c]
                                 << " in cell " << c << " at " << mesh_.cellCentres()[c]
                                 << "; that must be 1. The file of one fluid may be left out: it"
                                 << " has the rest." << exit(FatalError);
        }
        scalar missing = 0, others = 0;
        forAll(alpha_, k)
        {
            scalar& a = alpha_[k].primitiveFieldRef()[c];
            a /= sum[c];
            const bool few = a < nuclei_[k];
            missing += few ? nuclei_[k] - a : 0;
            others += few ? 0 : a;
        }
        forAll(alpha_, k)
        {
            scalar& a = alpha_[k].primitiveFieldRef()[c];
            a = a < nuclei_[k] ? nuclei_[k] : a * (1 - missing / others);
        }
    }
}

void Foam::mpm::eulerianFluids::checkDensities() const
{
    const noTraps guard;
    forAll(state_, k)
    {
        forAll(state_[k], c)
        {
            const scalar rho = density(k, state_[k][c], p_[c]);
            if (alpha_[k][c] > 0 && !(rho > 0 && rho < GREAT))
            {
                FatalErrorInFunction
                    << "Field " << state_[k].name() << " in " << state_[k].objectPath()
                    << " has the value " << state_[k][c] << " in cell " << c << " at "
                    << mesh_.cellCentres()[c] << ", where " << mixture_.name(k) << " has the share "
                    << alpha_[k][c] << " and p is " << p_[c] << " Pa: the density " << rho
                    << " kg/m3 must be"
                    << " greater than 0." << exit(FatalError);
            }
        }
    }
}

void Foam::mpm::eulerianFluids::checkState(const scalarField& p) const
{
    const noTraps guard;
    forAll(p, c)
    {
        scalar sum = 0, least = 0;
        for (label k = 0; k < n_; ++k)
        {
            sum += part_[n_ * c + k];
            least = min(least, min(part_[n_ * c + k], mass_[n_ * c + k]));
        }
        const bool shares = mag(sum - theta_[c]) <= 1e-6 * theta_[c] && least >= 0;
        scalar ofState = p_[c], allowed = 1e-5 * t_[c].K;
        if (relaxedP_[c] > 0 && ofGas(c) > 0)
        {
            // Not by the file itself
            ofState = mixture_.pressure(
                part_.cdata() + n_ * c, mass_.cdata() + n_ * c,
                rhoE_[c] - 0.5 * magSqr(rhoU_[c]) / rho_[c], burntOf(c));
            allowed = 1e-5 * sqr(z_[c]) / W_[c].rho;
        }
        if (shares && mag(p[c] - ofState) <= allowed)
        {
            continue;
        }
        OStringStream why;
        if (shares)
        {
            why << "p is " << p[c] << " Pa, that of the state " << ofState
                << " Pa, which is more than 1e-5 of rho c^2 away.";
        }
        else
        {
            why << "alpha.* add up to " << sum << ", theta is " << theta_[c]
                << (least < 0 ? ", and a share or mass is negative." : ".");
        }
        FatalErrorInFunction
            << "The fields p, theta, alpha.* and F.* of time " << mesh_.time().timeName()
            << " do not belong to the state"
            << " thetaRho.*, thetaRhoU, thetaRhoE of the fluids in that time: " << why.str().c_str()
            << " That is in cell " << c << " at " << mesh_.cellCentres()[c] << "." << nl
            << "If some were changed on purpose, or an equationOfState of the fluids"
            << " (soundSpeed, pInf) in constant/phaseProperties, remove the"
            << " files thetaRho.*, thetaRhoU, thetaRhoE there and the run starts"
            << " from p, U, alpha.*, T.*, rho.*, F.*." << exit(FatalError);
    }
}

Foam::scalar
Foam::mpm::eulerianFluids::density(const label k, const scalar state, const scalar p) const
{
    return isGas(k) ? mixture_.thermo(k).rho(p, state) : state;
}

void Foam::mpm::eulerianFluids::conserve()
{
    const noTraps guard;
    forAll(theta_, c)
    {
        scalar rho = 0, energy = 0;
        for (label k = 0; k < n_; ++k)
        {
            const scalar theta = theta_[c] * alpha_[k][c];
            part_[n_ * c + k] = theta;
            mass_[n_ * c + k] = 0;
            if (theta > 0)
            {
                const scalar rhoK = density(k, state_[k][c], p_[c]);
                mass_[n_ * c + k] = theta * rhoK;
                rho += theta * rhoK;
                energy += theta * mixture_.energy(k, rhoK, p_[c], burntOf(c, k));
            }
        }
        rho_[c] = rho;
        rhoU_[c] = rho * U_[c];
        rhoE_[c] = energy + 0.5 * rho * magSqr(U_[c]);
    }
}

void Foam::mpm::eulerianFluids::start(const fieldStates* states)
{
    if (!restarted_)
    {
        checkShares();
        checkDensities();
        begin();
        return;
    }
    readState(states);
    rho_ = 0;
    for (label k = 0; k < n_; ++k)
    {
        const scalarField m(
            startField<volScalarField::Internal>("thetaRho", states, mixture_.name(k)).field());
        forAll(theta_, c)
        {
            part_[n_ * c + k] = alpha_[k][c];
            mass_[n_ * c + k] = m[c];
            rho_[c] += m[c];
        }
    }
    const scalarField p(p_.primitiveField());
    relaxedP_ = p;
    primitives();
    if (!states)
    {
        checkState(p);
    }
    far_->setValues(W_, g_, U_, p_);
    updateBoundaryStates();
}

void Foam::mpm::eulerianFluids::readViscosity(const dictionary& properties)
{
    const bool viscous = settings(properties).getOrDefault<bool>("viscous", false);
    mu_.setSize(n_, 0);
    kappa_.setSize(n_, 0);
    bool conducts = false;
    for (label k = 0; k < n_; ++k)
    {
        const dictionary& dict = requiredDict(properties, mixture_.name(k));
        if (viscous)
        {
            mu_[k] = bounded(dict, "mu", 0, GREAT);
            kappa_[k] = boundedOrDefault(dict, "kappa", 0, 0, GREAT);
            conducts = conducts || kappa_[k] > 0;
        }
        else if (dict.found("mu") || dict.found("kappa"))
        {
            FatalIOErrorInFunction(dict)
                << "Entries mu and kappa of " << mixture_.name(k) << " act only"
                << " with  fluids { viscous yes; }  (mu of drag stands in"
                << " fluids)." << exit(FatalIOError);
        }
    }
    if (!viscous)
    {
        return;
    }
    viscous_.reset(new viscousFlux(mesh_, faces_, coupled_));
    if (conducts)
    {
        needTemperature(settings(properties));
        T_.reset(new volScalarField(
            header("T", IOobject::NO_READ, group_), mesh_, dimensionedScalar(dimTemperature, Zero),
            "zeroGradient"));
    }
}

const Foam::volScalarField* Foam::mpm::eulerianFluids::transport(scalarField& rhoCv)
{
    const noTraps guard;
    forAll(theta_, c)
    {
        scalar mu = 0, kappa = 0, sumT = 0;
        for (label k = 0; k < n_; ++k)
        {
            const scalar theta = part_[n_ * c + k], m = mass_[n_ * c + k];
            mu += theta * mu_[k];
            kappa += theta * kappa_[k];
            if (T_ && m > 0)
            {
                const gasThermo& thermo = mixture_.thermo(k);
                rhoCv[c] += m * thermo.Cv();
                sumT += m * thermo.Cv() * thermo.T(m / theta, W_[c].p);
            }
        }
        viscous_->mu[c] = mu / theta_[c];
        viscous_->kappa[c] = kappa / theta_[c];
        if (T_)
        {
            (*T_)[c] = sumT / rhoCv[c];
        }
    }
    if (T_)
    {
        T_->correctBoundaryConditions();
    }
    return T_.get();
}
