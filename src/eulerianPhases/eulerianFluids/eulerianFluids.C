/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianFluids.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "basicSymmetryFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- What stands for all fluids
const dictionary& settings(const dictionary& properties)
{
    const dictionary* found = properties.findDict("fluids");
    return found ? *found : dictionary::null;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
        forAll(alpha_, k)
        {
            alpha_[k].primitiveFieldRef()[c] /= sum[c];
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
    updateBoundaryStates();
}


void Foam::mpm::eulerianFluids::oneFluid
(
    const label k,
    const labelUList& cells
)
{
    constexpr label room = gasThermo::room;
    scalar rho[room], e[room], p[room], c2[room], strength[room], F[room];
    const bool burns = mixture_.detonates(k);
    for (label first = 0; first < cells.size(); first += room)
    {
        const label n = min(room, cells.size() - first);
        for (label i = 0; i < n; ++i)
        {
            const label c = cells[first + i];
            const scalar m = mass_[n_*c + k];
            gasState& w = W_[c];
            w.u = rhoU_[c]/m;
            w.rho = m/theta_[c];
            rho[i] = w.rho;
            e[i] = (rhoE_[c] - 0.5*(rhoU_[c] & w.u))/m;
            F[i] = burns ? burnt_[n_*c + k] : 1;
        }
        mixture_.pressures
        (
            k, n, rho, e, p, c2, strength, burns ? F : nullptr
        );
        for (label i = 0; i < n; ++i)
        {
            const label c = cells[first + i];
            W_[c].p = p[i];
            t_[c].K = rho[i]*c2[i];
            t_[c].rhoE = rho[i]*e[i];
            t_[c].strength = strength[i];
            z_[c] = rho[i]*std::sqrt(max(c2[i], scalar(0)));
        }
    }
}


void Foam::mpm::eulerianFluids::severalFluids(const label c)
{
    const scalar* theta = part_.cdata() + n_*c;
    const scalar* m = mass_.cdata() + n_*c;
    scalar total = 0;
    for (label k = 0; k < n_; ++k)
    {
        total += m[k];
    }
    gasState& w = W_[c];
    w.rho = total/theta_[c];
    w.u = rhoU_[c]/total;
    const scalar energy = rhoE_[c] - 0.5*(rhoU_[c] & w.u);
    const scalar* F = burntOf(c);
    w.p = mixture_.pressure(theta, m, energy, F);
    const fluidMixture::moduli all(mixture_.at(theta, m, w.p, F));
    t_[c].K = all.wood;
    t_[c].rhoE = energy/theta_[c];
    t_[c].strength = all.strength;
    z_[c] = std::sqrt(max(w.rho*all.frozen, scalar(0)));
}


void Foam::mpm::eulerianFluids::primitives()
{
    scalar rate = 0;
    label bad = -1;
    {
        const noTraps guard;
        List<DynamicList<label>> of(n_);
        forAll(theta_, c)
        {
            label only = -1, several = 0;
            for (label k = 0; k < n_; ++k)
            {
                if (mass_[n_*c + k] > 0)
                {
                    only = k;
                    ++several;
                }
            }
            if (several == 1)
            {
                of[only].append(c);
            }
            else
            {
                severalFluids(c);
            }
        }
        for (label k = 0; k < n_; ++k)
        {
            oneFluid(k, of[k]);
        }
        forAll(W_, c)
        {
            const gasState& w = W_[c];
            p_[c] = w.p;
            U_[c] = w.u;
            rho0_[c] = w.rho;
            const scalar r =
                (cmptMag(w.u) & faceRates_.directions[c])
              + z_[c]/w.rho*faceRates_.all[c];
            if (!(w.rho > 0 && t_[c].K > 0 && r < GREAT))
            {
                bad = bad < 0 ? c : bad;
            }
            rate = max(rate, r);
        }
        for (const label k : burning_)
        {
            // The step must see a front that has not come yet
            const scalar D = mixture_.detonates(k)->speed();
            forAll(W_, c)
            {
                if (mass_[n_*c + k] > 0 && burnt_[n_*c + k] < 1)
                {
                    rate = max(rate, D*faceRates_.all[c]);
                }
            }
        }
    }
    bad = badCell_ < 0 ? bad : badCell_;
    rate_ = returnReduce(bad < 0 ? rate : VGREAT, maxOp<scalar>());
    if (rate_ >= VGREAT)
    {
        stop(bad);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::eulerianFluids::eulerianFluids
(
    const fvMesh& mesh,
    const dictionary& properties,
    const wordList& names,
    const vector& g,
    const fieldStates* states
)
:
    eulerianFlow(mesh, "fluids", g),
    mixture_(properties, names),
    n_(names.size()),
    lowMach_(settings(properties).getOrDefault<bool>("lowMach", false)),
    chi_(boundedOrDefault(settings(properties), "drainage", 0.1, 0, 1)),
    reconstruction_(mesh, coupled_, faces_.boundary, faces_.coupled),
    porousFlux_(settings(properties), faces_),
    part_(n_*mesh.nCells(), Zero),
    mass_(n_*mesh.nCells(), Zero),
    t_(W_.size()),
    tb_(Wb_.size(), stateTerms{1, 0, 1}),
    z_(W_.size()),
    zB_(Wb_.size(), 1),
    alphaB_(n_*Wb_.size(), Zero),
    rhoB_(n_*Wb_.size(), Zero),
    p_(startField<volScalarField>("p", states)),
    U_(startField<volVectorField>("U", states)),
    rho0_
    (
        header("rho", IOobject::NO_READ),
        mesh,
        dimensionedScalar(dimDensity, Zero)
    ),
    psi_
    (
        header("psi", IOobject::NO_READ),
        mesh,
        dimensionedScalar(dimDensity/dimPressure, Zero)
    ),
    phiField_
    (
        header("phi", IOobject::NO_READ),
        mesh,
        dimensionedScalar(dimVolume/dimTime, Zero)
    ),
    first_(W_.size() + Wb_.size(), false),
    dropped_(0),
    relaxed_(0),
    beside_(false)
{
    for (const word& name : names)
    {
        const dictionary& dict = requiredDict(properties, name);
        wordList valid(gasThermo::New(dict)->keywords());
        valid.append("type");
        valid.append("detonation");
        checkKeywords(dict, valid);
    }
    checkKeywords
    (
        settings(properties),
        {
            "lowMach", "drainage", "mu", "Pr", "poreFloor", "faceDrag",
            "solidFraction"
        }
    );
    setEnergy(true);
    makeFields(states);
    makeBurnt(states);
    setFaces(U_, p_);
    interfaces_.reset(new fluidInterfaces(faces_, coupled_, n_));
    if (mag(g_) > 0)
    {
        jump_.setSize(mesh.nFaces(), 0);
        weight_.setSize(mesh.nFaces(), 0);
        reconstruction_.checkWeight();
    }
    readState(states);
    startBurning();

    Info<< "Fluids with one velocity and one pressure, "
        << returnReduce(mesh.nCells(), sumOp<label>()) << " cells:" << nl;
    for (label k = 0; k < n_; ++k)
    {
        Info<< "    " << names[k] << ": " << mixture_.description(k).c_str()
            << nl;
    }
    Info<< "    reconstruction: " << reconstruction_.description().c_str()
        << nl << endl;
}


bool Foam::mpm::eulerianFluids::setTheta(const UList<scalar>& theta)
{
    porous_ = true;
    if (restarted_)
    {
        return true;
    }

    // The fields have shares of the cell
    forAll(theta_, c)
    {
        for (label k = 0; k < n_; ++k)
        {
            alpha_[k][c] /= theta_[c];
        }
        theta_[c] = theta[c];
    }
    conserve();
    primitives();
    updateFields();
    updateBoundaryStates();
    return false;
}


void Foam::mpm::eulerianFluids::velocityChanged(const labelUList& cells)
{
    for (const label c : cells)
    {
        U_[c] = W_[c].u;
    }
    if (coupled_.empty())
    {
        return;
    }
    const label nInternal = mesh_.nInternalFaces();
    for (const label f : faces_.coupled)
    {
        Wb_[f - nInternal] = W_[mesh_.faceOwner()[f]];
    }
    coupled_.swap(Wb_);
}


void Foam::mpm::eulerianFluids::correct()
{
    primitives();
    forAll(mesh_.boundary(), patchi)
    {
        fvsPatchScalarField& phi = phiField_.boundaryFieldRef()[patchi];
        const label start = mesh_.boundaryMesh()[patchi].start();
        forAll(phi, i)
        {
            phi[i] = phi_[start + i];
        }
    }
    updateFields();
    updateBoundaryStates();
}

// ************************************************************************* //
