/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianFluids.H"
#include "dictionaryTools.H"
#include "fullPrecision.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::mpm::eulerianFluids::stateOf(const label celli) const
{
    const gasState& w = W_[celli];
    OStringStream os;
    os  << "The fluids have density " << w.rho << " kg/m3, pressure " << w.p
        << " Pa and rho c^2 " << t_[celli].K << " Pa; density and rho c^2 must"
        << " be positive, in cell " << celli << " at "
        << mesh_.cellCentres()[celli] << ", time " << mesh_.time().timeName()
        << " (velocity " << w.u << "; shares";
    for (label k = 0; k < n_; ++k)
    {
        os  << ' ' << mixture_.name(k) << ' ' << part_[n_*celli + k];
    }
    os  << ")." << nl
        << "At the start: look into 0/p, 0/U, 0/alpha.*, 0/T.*, 0/rho.* and"
        << " constant/phaseProperties. After a restart: into theta,"
        << " thetaRho.*, thetaRhoU, thetaRhoE, alpha.*, F.* of its time. Later:"
        << " a smaller maxCoGas in system/controlDict or upwind for"
        << " reconstruct(...) in system/fvSchemes often helps.";
    if (w.p < 0 && !canTear())
    {
        os  << nl << aboutNuclei().c_str();
    }
    return os.str();
}


template<class Function>
void Foam::mpm::eulerianFluids::forState(const Function& f)
{
    const auto object = [&](const word& name, const label k)
    {
        IOobject io(header(name, IOobject::NO_READ, k));
        io.instance() = mesh_.time().timeName();
        return io;
    };
    f(p_);
    f(U_);
    f(rho0_);
    volScalarField theta
    (
        object("theta", -1), mesh_, dimensionedScalar(dimless, Zero),
        "zeroGradient"
    );
    theta.primitiveFieldRef() = theta_;
    theta.correctBoundaryConditions();
    f(theta);
    scalarField m(mesh_.nCells());
    for (label k = 0; k < n_; ++k)
    {
        f(alpha_[k]);
        f(state_[k]);
        forAll(m, c)
        {
            m[c] = mass_[n_*c + k];
        }
        volScalarField::Internal mass
        (
            object("thetaRho", k), mesh_, dimDensity, m
        );
        f(mass);
    }
    for (volScalarField& F : F_)
    {
        f(F);
    }
    volVectorField::Internal rhoU
    (
        object("thetaRhoU", -1), mesh_, dimDensity*dimVelocity, rhoU_
    );
    f(rhoU);
    volScalarField::Internal rhoE
    (
        object("thetaRhoE", -1), mesh_, dimPressure, rhoE_
    );
    f(rhoE);
}

void Foam::mpm::eulerianFluids::checkSoftened() const
{
    for (label k = 0; k < n_; ++k)
    {
        const scalar c =
            isGas(k) ? scalar(0) : mixture_.thermo(k).equation().softened();
        if (!(c > 0) || warned_[k])
        {
            continue;
        }
        scalar fastest = 0;
        forAll(W_, i)
        {
            if (part_[n_*i + k] > 0.5*theta_[i])
            {
                fastest = max(fastest, mag(W_[i].u));
            }
        }
        reduce(fastest, maxOp<scalar>());
        if (fastest > 0.1*c)
        {
            warned_[k] = true;
            WarningInFunction
                << "Fluid " << mixture_.name(k) << " flows with " << fastest
                << " m/s at time " << mesh_.time().timeName() << ", "
                << fastest/c << " of its soundSpeed " << c << " m/s: its"
                << " density changes by " << 100*sqr(fastest/c) << " %." << nl
                << "    Give it a soundSpeed of " << 10*fastest
                << " m/s or more, or pInf of the real liquid." << nl << endl;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::eulerianFlow::waveState
Foam::mpm::eulerianFluids::wave(const label c) const
{
    return {t_[c].K, z_[c], chi_*liquid(z_[c], W_[c])};
}


Foam::mpm::eulerianFlow::heatState
Foam::mpm::eulerianFluids::heat(const label c) const
{
    const scalar* theta = part_.cdata() + n_*c;
    const scalar* m = mass_.cdata() + n_*c;
    const scalar p = mixture_.pressure
    (
        theta, m, rhoE_[c] - 0.5*magSqr(rhoU_[c])/rho_[c], burntOf(c)
    );
    scalar rhoCv = 0, rhoCvT = 0;
    for (label k = 0; k < n_; ++k)
    {
        if (m[k] > 0)
        {
            const gasThermo& thermo = mixture_.thermo(k);
            rhoCv += m[k]*thermo.Cv();
            rhoCvT += m[k]*thermo.Cv()*thermo.T(m[k]/theta[k], p);
        }
    }

    scalar rhoCp = 0;
    for (label k = 0; k < n_; ++k)
    {
        rhoCp += m[k]*(isGas(k) ? mixture_.thermo(k).Cp() : mixture_.thermo(k).Cv());
    }
    return {rhoCvT/rhoCv, rhoCv, rhoCp/rho_[c]};
}


void Foam::mpm::eulerianFluids::needTemperature(const dictionary& dict) const
{
    for (label k = 0; k < n_; ++k)
    {
        if (!mixture_.thermo(k).hasTemperature())
        {
            FatalIOErrorInFunction(dict)
                << "Fluid " << mixture_.name(k) << " ("
                << mixture_.description(k).c_str() << ") has no temperature and"
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


Foam::List<Foam::mpm::eulerianFlow::fluidSums>
Foam::mpm::eulerianFluids::fluidContents() const
{
    // Their energies by the common pressure, the sum is that of the cell
    const scalarField& V = mesh_.V();
    List<fluidSums> all(n_);
    forAll(rho_, c)
    {
        for (label k = 0; k < n_; ++k)
        {
            const scalar m = mass_[n_*c + k], theta = part_[n_*c + k];
            if (!(m > 0))
            {
                continue;
            }
            fluidSums& s = all[k];
            const scalar rho = m/theta;
            s.mass += V[c]*m;
            s.momentum += V[c]*m*W_[c].u;
            s.kinetic += 0.5*V[c]*m*magSqr(W_[c].u);
            s.internal +=
                V[c]*theta
               *fluidMixture::energy
                (
                    mixture_.at(k, rho, burntOf(c, k)), rho, W_[c].p
                );
            s.volume += V[c]*theta;
        }
    }
    return all;
}


void Foam::mpm::eulerianFluids::report() const
{
    const scalarField& V = mesh_.V();
    scalar pMin = GREAT, pMax = -GREAT;
    scalarField mass(n_, 0);
    label shared = 0;
    forAll(W_, c)
    {
        scalar largest = 0;
        pMin = min(pMin, W_[c].p);
        pMax = max(pMax, W_[c].p);
        for (label k = 0; k < n_; ++k)
        {
            mass[k] += V[c]*mass_[n_*c + k];
            largest = max(largest, part_[n_*c + k]);
        }
        shared += largest < (1 - fluidInterfaces::foreign)*theta_[c];
    }
    Info<< "Fluids: mass";
    for (label k = 0; k < n_; ++k)
    {
        Info<< ' ' << mixture_.name(k) << ' '
            << returnReduce(mass[k], sumOp<scalar>());
    }
    Info<< ", momentum " << returnReduce(momentum(), sumOp<vector>())
        << ", energy " << returnReduce(energy(), sumOp<scalar>()) << nl
        << "    p " << returnReduce(pMin, minOp<scalar>()) << " to "
        << returnReduce(pMax, maxOp<scalar>()) << ", cells at interfaces "
        << returnReduce(shared, sumOp<label>()) << " (mixed "
        << returnReduce(interfaces_->cells().size(), sumOp<label>())
        << "), outflow limited "
        << returnReduce(fixups_.limited, sumOp<label>()) << ", theta kept "
        << returnReduce(fixups_.theta, sumOp<label>())
        << ", pressure of relaxation kept "
        << returnReduce(relaxed_, sumOp<label>()) << ", isentropic "
        << returnReduce(fixups_.isentropic, sumOp<label>()) << ", voids "
        << returnReduce(voids_, sumOp<label>()) << " (energy "
        << returnReduce(fixups_.energy, sumOp<scalar>()) << " added, mass "
        << returnReduce(fixups_.heldBack, sumOp<scalar>()) << " held back, "
        << returnReduce(dropped_, sumOp<scalar>()) << " dropped)" << endl;
    for (const label k : burning_)
    {
        Info<< "    burnt of " << mixture_.name(k) << ": "
            << burntShare(k) << endl;
    }
    reportFilled();
    checkSoftened();
    checkTension();
}


void Foam::mpm::eulerianFluids::writeFields()
{
    const fullPrecision allDigits;
    forState
    (
        [&](auto& field)
        {
            field.instance() = mesh_.time().timeName();
            field.write();
        }
    );
}


Foam::mpm::fieldStates Foam::mpm::eulerianFluids::takeDown()
{
    fieldStates states;
    forState
    (
        [&](const auto& field)
        {
            states.set(field.name(), fieldDictionary(field));
        }
    );
    return states;
}


Foam::dictionary Foam::mpm::eulerianFluids::state() const
{
    dictionary state(fixupState());
    state.add("relaxed", returnReduce(relaxed_, sumOp<label>()));
    state.add("voids", returnReduce(voids_, sumOp<label>()));
    state.add("dropped", returnReduce(dropped_, sumOp<scalar>()));
    return state;
}


void Foam::mpm::eulerianFluids::setState(const dictionary& state)
{
    setFixups(state);
    const bool keeps = Pstream::master();
    relaxed_ = keeps ? required<label>(state, "relaxed") : 0;
    voids_ = keeps ? required<label>(state, "voids") : 0;
    dropped_ = keeps ? required<scalar>(state, "dropped") : 0;
}

// ************************************************************************* //
