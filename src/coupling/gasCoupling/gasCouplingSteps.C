/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"
#include "cellSums.H"
#include "fieldDictionary.H"
#include "noTraps.H"
#include "startFields.H"
#include "OSspecific.H"
#include "volFields.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gasCoupling::settle(const scalar dt)
{
    const noTraps guard;
    vectorField rest;
    scalarField energy;
    later_.finish(pores_, dt, rest, energy);
    drag_.owe(rest);
    if (gas_.hasEnergy())
    {
        gas_.addHeat(identity(energy.size()), energy);
    }
    promise();
}


void Foam::mpm::gasCoupling::updateWidths() const
{
    const fvMesh& mesh = fraction_->mesh();
    inverse_.setSize(mesh.nCells(), 0);
    const auto add = [&](const label f, const label c)
    {
        inverse_[c] =
            max(inverse_[c], mag(mesh.faceAreas()[f])/mesh.V()[c]);
    };
    for (label f = 0; f < mesh.nInternalFaces(); ++f)
    {
        add(f, mesh.faceOwner()[f]);
        add(f, mesh.faceNeighbour()[f]);
    }
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(pp) && !isA<wedgePolyPatch>(pp))
        {
            forAll(pp, i)
            {
                add(pp.start() + i, pp.faceCells()[i]);
            }
        }
    }
}


void Foam::mpm::gasCoupling::promise()
{
    gas_.promise
    (
        later_.owed() - drag_.owedMomentum(),
        later_.energy() - drag_.owedEnergy()
    );
}


template<class Function>
void Foam::mpm::gasCoupling::forOwed(const Function& f) const
{
    gasCoupling& all = const_cast<gasCoupling&>(*this);
    const word of('.' + gas_.name());
    f("owedPressure" + of, dimPressure*dimTime, all.later_.C());
    f("owedImpulse" + of, dimForce*dimTime, all.later_.B());
    f("owedPressureWork" + of, dimPressure, all.later_.CW());
    f("owedWork" + of, dimPressure, all.drag_.owedWork());
    forAll(points_.phases(), phasei)
    {
        f
        (
            "owedDrag." + points_.phases()[phasei].name(),
            dimDensity*dimVelocity,
            all.drag_.owedOf(phasei)
        );
    }
}


void Foam::mpm::gasCoupling::readOwed(const fieldStates* states)
{
    const fvMesh& mesh = fraction_->mesh();
    const IOobject first
    (
        "owedPressure." + gas_.name(),
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    const bool there =
        states
      ? states->found(first.name())
      : IOobject(first).typeHeaderOk<volScalarField::Internal>(false);
    if (!returnReduce(there, orOp<bool>()))
    {
        return;
    }
    forOwed
    (
        [&](const word& name, const dimensionSet& dimensions, auto& values)
        {
            typedef typename std::decay<decltype(values[0])>::type Type;
            IOobject io(first);
            io.rename(name);
            const DimensionedField<Type, volMesh> field
            (
                fileOrState<DimensionedField<Type, volMesh>>(io, mesh, states)
            );
            checkDimensions(field, dimensions);
            values = field.field();
        }
    );
    later_.resume();
    drag_.resume();
    promise();
}


void Foam::mpm::gasCoupling::addFields(fieldStates& fields) const
{
    if (!later_.acts() && !drag_.owes())
    {
        return;
    }
    const fvMesh& mesh = fraction_->mesh();
    forOwed
    (
        [&](const word& name, const dimensionSet& dimensions, auto& values)
        {
            typedef typename std::decay<decltype(values[0])>::type Type;
            const DimensionedField<Type, volMesh> field
            (
                IOobject
                (
                    name,
                    mesh.time().timeName(),
                    mesh,
                    IOobject::NO_READ,
                    IOobject::NO_WRITE,
                    false
                ),
                mesh,
                dimensions,
                values
            );
            fields.set(name, fieldDictionary(field));
        }
    );
}


void Foam::mpm::gasCoupling::writeOwed() const
{
    const fvMesh& mesh = fraction_->mesh();
    if (!later_.acts() && !drag_.owes())
    {
        // Nor what an earlier run has left
        const fileName path(mesh.time().path()/mesh.time().timeName());
        if (isFile(path/"owedPressure." + gas_.name()))
        {
            rm(path/"owedPressure." + gas_.name());
        }
        return;
    }
    const fullPrecision allDigits;
    forOwed
    (
        [&](const word& name, const dimensionSet& dimensions, auto& values)
        {
            typedef typename std::decay<decltype(values[0])>::type Type;
            const IOobject io
            (
                name,
                mesh.time().timeName(),
                mesh,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            );
            const DimensionedField<Type, volMesh> field
            (
                io, mesh, dimensions, values
            );
            field.write();
        }
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::gasCoupling::severalSteps(const bool several)
{
    several_ = several;
    if (several_ && (later_.acts() || drag_.owes()))
    {
        FatalErrorInFunction
            << "Time " << fraction_->mesh().time().timeName()
            << " was written with maxGasSubSteps: what points and "
            << gas_.name() << " owe each other (files owed*) goes with one"
            << " step of the points." << nl
            << "Go on with maxGasSubSteps, or start maxSubSteps from a time"
            << " without these files." << exit(FatalError);
    }
    if (several_ && !steps_)
    {
        steps_.reset(new solidOverSteps(fraction_->mesh()));
    }
}


void Foam::mpm::gasCoupling::severalOfGas
(
    const bool several,
    const scalar gasDeltaT
)
{
    further_ = several;
    gasDeltaT_ = several ? gasDeltaT : GREAT;
    drag_.severalOfGas(several || later_.acts());
}


Foam::scalar Foam::mpm::gasCoupling::lagRate() const
{
    // See gasCoupling.H
    constexpr scalar added = 0.5, pores = 0.6, drains = 70;
    const noTraps guard;
    if (inverse_.empty())
    {
        updateWidths();
    }
    scalar rate = 0;
    for (const materialPointPhase& phase : points_.phases())
    {
        if (phase.prescribed())
        {
            continue;
        }
        const materialPointCloud& cloud = phase.cloud();
        const scalar* mass = cloud.mass()[0];
        const scalar* volume = cloud.volume()[0];
        forAll(cloud.cells(), k)
        {
            const label c = cloud.cells()[k];
            const scalar rho =
                cellSum(cloud, k, mass)/cellSum(cloud, k, volume);
            const scalar theta = max(gas_.theta()[c], fraction_->eps());
            const eulerianFlow::waveState w(gas_.wave(c));
            const scalar spring =
                std::sqrt(w.K/(theta*rho))/(1 + drains*min(w.drained, 0.1));
            rate = max
            (
                rate,
                inverse_[c]*max(w.z/(added*rho), spring/pores)
            );
        }
    }
    return returnReduce(rate, maxOp<scalar>());
}


void Foam::mpm::gasCoupling::advanceGas
(
    const scalar dt,
    const scalar all,
    const bool last
)
{
    if (passed_ > 0)
    {
        const noTraps guard;
        scalarField p(gas_.states().size());
        scalarField pBehind(gas_.boundaryStates().size());
        forAll(p, c)
        {
            p[c] = gas_.states()[c].p;
        }
        forAll(pBehind, i)
        {
            pBehind[i] = gas_.boundaryStates()[i].p;
        }
        fraction_->pushAnew(p, pBehind);
        drag_.further(dt);
        later_.add(p, dt);
    }
    else
    {
        drag_.addToGas();
        if (further_)
        {
            later_.begin(gas_.states());
        }
    }
    passed_ += dt;

    solidOnFaces pores(several_ ? steps_->mean(pores_) : pores_);
    if (further_)
    {
        dilation_.setSize(fraction_->mesh().nCells());
        forAll(dilation_, c)
        {
            dilation_[c] = dt/all*pores.dilation[c];
        }
        pores.dilation = dilation_.cdata();
    }
    gas_.faceFlux(dt, &pores);
    gas_.advance(dt, &pores);
    if (!last)
    {
        return;
    }
    passed_ = 0;
    if (further_ || later_.acts())
    {
        settle(all);
    }
    const noTraps guard;
    heat_.exchange(all);
    if (books_)
    {
        heat_.addGain(budget_);
    }
    if (removed_)
    {
        fill();
    }
    if (several_)
    {
        steps_->clear();
    }
    watch_.check();
}

// ************************************************************************* //
