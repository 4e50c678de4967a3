/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianFluids.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::mpm::eulerianFluids::settings
(
    const dictionary& properties
)
{
    const dictionary* found = properties.findDict("fluids");
    return found ? *found : dictionary::null;
}


Foam::IOobject Foam::mpm::eulerianFluids::header
(
    const word& name,
    const IOobject::readOption read,
    const label fluid
) const
{
    return IOobject
    (
        fluid < 0 ? name : IOobject::groupName(name, mixture_.name(fluid)),
        mesh_.time().timeName(),
        mesh_,
        read,
        IOobject::NO_WRITE
    );
}


template<class FieldType>
FieldType Foam::mpm::eulerianFluids::startField
(
    const word& name,
    const fieldStates* states,
    const label fluid
) const
{
    const IOobject io(header(name, IOobject::MUST_READ, fluid));
    IOobject file(io);
    if
    (
        !states
     && !returnReduce(file.typeHeaderOk<regIOobject>(false), andOp<bool>())
    )
    {
        FatalErrorInFunction
            << "Field " << io.name() << " of the fluids is missing: there is no"
            << " file " << io.objectPath() << "." << exit(FatalError);
    }
    return fileOrState<FieldType>(io, mesh_, states);
}


void Foam::mpm::eulerianFluids::makeFields(const fieldStates* states)
{
    // Shares: one file may be missing, that of what is left
    label missing = -1;
    alpha_.setSize(n_);
    state_.setSize(n_);
    for (label k = 0; k < n_; ++k)
    {
        IOobject io(header("alpha", IOobject::MUST_READ, k));
        const bool there =
            states
         || returnReduce(io.typeHeaderOk<regIOobject>(false), andOp<bool>());
        if (!there && (missing < 0))
        {
            missing = k;
            continue;
        }
        alpha_.set
        (
            k, new volScalarField(startField<volScalarField>("alpha", states, k))
        );
    }
    if (missing >= 0)
    {
        const IOobject io(header("alpha", IOobject::NO_READ, missing));
        if (n_ == 1)
        {
            alpha_.set
            (
                0,
                new volScalarField
                (
                    io, mesh_, dimensionedScalar("one", dimless, 1),
                    "zeroGradient"
                )
            );
        }
        else
        {
            // With the conditions of another, whose values it complements
            const volScalarField& other = alpha_[missing ? 0 : 1];
            alpha_.set(missing, new volScalarField(io, other));
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
                        static_cast<scalarField&>(b) -=
                            alpha_[k].boundaryField()[patchi];
                    }
                }
            }
        }
    }
    for (label k = 0; k < n_; ++k)
    {
        const word name(isGas(k) ? "T" : "rho");
        IOobject io(header(name, IOobject::MUST_READ, k));
        const bool there =
            states
         || returnReduce(io.typeHeaderOk<regIOobject>(false), andOp<bool>());
        state_.set
        (
            k,
            there || isGas(k)
          ? new volScalarField(startField<volScalarField>(name, states, k))
          : new volScalarField
            (
                header(name, IOobject::NO_READ, k),
                mesh_,
                dimensionedScalar("rho", dimDensity, mixture_.rho0(k)),
                "zeroGradient"
            )
        );
    }
}


void Foam::mpm::eulerianFluids::checkShares()
{
    scalarField sum(mesh_.nCells(), Zero);
    forAll(alpha_, k)
    {
        scalarField& a = alpha_[k].primitiveFieldRef();
        forAll(a, c)
        {
            if (!(a[c] > -1e-9 && a[c] < 1 + 1e-9))
            {
                FatalErrorInFunction
                    << "Field " << alpha_[k].name() << " in "
                    << alpha_[k].objectPath() << " has the value " << a[c]
                    << " in cell " << c << " at " << mesh_.cellCentres()[c]
                    << "; a share of the volume is in [0, 1]."
                    << exit(FatalError);
            }
            a[c] = min(max(a[c], scalar(0)), scalar(1));
            sum[c] += a[c];
        }
    }
    forAll(sum, c)
    {
        if (mag(sum[c] - 1) > 1e-6)
        {
            FatalErrorInFunction
                << "The shares alpha of the fluids add up to " << sum[c]
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
            a = a < nuclei_[k] ? nuclei_[k] : a*(1 - missing/others);
        }
    }
}


Foam::scalar Foam::mpm::eulerianFluids::density
(
    const label k,
    const scalar state,
    const scalar p
) const
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
            const scalar theta = theta_[c]*alpha_[k][c];
            part_[n_*c + k] = theta;
            mass_[n_*c + k] = 0;
            if (theta > 0)
            {
                const scalar rhoK = density(k, state_[k][c], p_[c]);
                mass_[n_*c + k] = theta*rhoK;
                rho += theta*rhoK;
                energy +=
                    theta
                   *fluidMixture::energy
                    (
                        mixture_.at(k, rhoK, burntOf(c, k)), rhoK, p_[c]
                    );
            }
        }
        rho_[c] = rho;
        rhoU_[c] = rho*U_[c];
        rhoE_[c] = energy + 0.5*rho*magSqr(U_[c]);
    }
}


void Foam::mpm::eulerianFluids::readState(const fieldStates* states)
{
    IOobject io(header("thetaRhoU", IOobject::MUST_READ));
    restarted_ =
        states
     || returnReduce
        (
            io.typeHeaderOk<volVectorField::Internal>(false), andOp<bool>()
        );
    if (!restarted_)
    {
        checkShares();
        conserve();
        primitives();
        far_->setValues(W_, g_, U_, p_);
        updateBoundaryStates();
        updateFields();
        updateBoundaryStates();
        return;
    }
    const auto read = [&](const word& name, const label k)
    {
        return fileOrState<volScalarField::Internal>
        (
            header(name, IOobject::MUST_READ, k), mesh_, states
        ).field();
    };
    theta_ = fileOrState<volScalarField>
    (
        header("theta", IOobject::MUST_READ), mesh_, states
    ).primitiveField();
    rho_ = 0;
    for (label k = 0; k < n_; ++k)
    {
        const scalarField m(read("thetaRho", k));
        forAll(theta_, c)
        {
            part_[n_*c + k] = alpha_[k][c];
            mass_[n_*c + k] = m[c];
            rho_[c] += m[c];
        }
    }
    porous_ = returnReduce(min(theta_) < 1 || max(theta_) > 1, orOp<bool>());
    rhoU_ = fileOrState<volVectorField::Internal>
    (
        header("thetaRhoU", IOobject::MUST_READ), mesh_, states
    ).field();
    rhoE_ = read("thetaRhoE", -1);
    primitives();
    far_->setValues(W_, g_, U_, p_);
    updateBoundaryStates();
}


void Foam::mpm::eulerianFluids::readViscosity(const dictionary& properties)
{
    const bool viscous =
        settings(properties).getOrDefault<bool>("viscous", false);
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
        T_.reset
        (
            new volScalarField
            (
                header("T", IOobject::NO_READ),
                mesh_,
                dimensionedScalar(dimTemperature, Zero),
                "zeroGradient"
            )
        );
    }
}


const Foam::volScalarField* Foam::mpm::eulerianFluids::transport
(
    scalarField& rhoCv
)
{
    const noTraps guard;
    forAll(theta_, c)
    {
        scalar mu = 0, kappa = 0, sumT = 0;
        for (label k = 0; k < n_; ++k)
        {
            const scalar theta = part_[n_*c + k], m = mass_[n_*c + k];
            mu += theta*mu_[k];
            kappa += theta*kappa_[k];
            if (T_ && m > 0)
            {
                const gasThermo& thermo = mixture_.thermo(k);
                rhoCv[c] += m*thermo.Cv();
                sumT += m*thermo.Cv()*thermo.T(m/theta, W_[c].p);
            }
        }
        viscous_->mu[c] = mu/theta_[c];
        viscous_->kappa[c] = kappa/theta_[c];
        if (T_)
        {
            (*T_)[c] = sumT/rhoCv[c];
        }
    }
    if (T_)
    {
        T_->correctBoundaryConditions();
    }
    return T_.get();
}

// * * * * * * * * * * * * * * * Instantiations  * * * * * * * * * * * * * * //

template Foam::volScalarField Foam::mpm::eulerianFluids::startField
(
    const word&,
    const fieldStates*,
    const label
) const;

template Foam::volVectorField Foam::mpm::eulerianFluids::startField
(
    const word&,
    const fieldStates*,
    const label
) const;

// ************************************************************************* //
