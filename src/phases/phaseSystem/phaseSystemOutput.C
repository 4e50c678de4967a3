/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "phaseSystem.H"
#include "noTraps.H"
#include "selector.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointPhaseSystem::stop
(
    materialPointPhase& phase,
    const label pointi,
    const bool left
)
{
    // The state before the step is untouched: it is what gets written
    Time& time = const_cast<Time&>(mesh_.time());
    const scalar dt = time.deltaTValue();
    const noTraps guard;

    materialPointCloud& cloud = phase.cloud();
    const point x(cloud.position(pointi, cloud.cellOf(pointi)));

    const bool badStress =
        !std::isfinite(magSqr(cloud.sigma(pointi)))
     || !std::isfinite(cloud.volume()[0][pointi]);

    // Never over a state that is on disk already
    const bool onDisk = isDir(time.path()/time.timeName());
    if (!onDisk)
    {
        writePoints();
        time.writeNow();
    }
    const string written
    (
        onDisk
      ? "The state before the step is that of time " + time.timeName()
      + " on disk."
      : "The state before the step is written to " + time.timeName() + "."
    );

    if (left)
    {
        vector xNew(Zero);
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            xNew[grid_.direction(d)] = cloud.xNew()[d][pointi];
        }
        FatalErrorInFunction
            << "Material point " << label(cloud.id()[0][pointi]) << " of "
            << phase.name() << " leaves the mesh " << mesh_.bounds()
            << ": from " << x << " with velocity " << cloud.velocity(pointi)
            << " to " << xNew << " in the step of " << dt << " s after time "
            << time.timeName() << "." << nl
            << written.c_str() << nl
            << "Make the mesh larger, or keep points inside by the boundary"
            << " conditions of U." << phase.velocityField()
            << " (fixedValue or slip)." << exit(FatalError);
    }
    FatalErrorInFunction
        << "Material point " << label(cloud.id()[0][pointi]) << " of "
        << phase.name() << " at " << x << ", time " << time.timeName()
        << ": " << (badStress ? "sigma (stress)" : "U (velocity)")
        << " is no finite number in the step of " << dt << " s." << nl
        << written.c_str() << nl
        << "A smaller maxCo in system/controlDict or maxStrain in"
        << " fvSolution.materialPoints makes the step smaller."
        << exit(FatalError);
}


void Foam::mpm::pointPhaseSystem::checkExtent
(
    materialPointPhase& phase,
    const UList<materialPointCloud::mover>& movers
)
{
    // GIMP's stencil reaches one cell beyond: from two cell widths on weights
    // would become negative
    if (!passes_->hasExtent() || grid_.sameWidth() > 0)
    {
        return;
    }
    materialPointCloud& cloud = phase.cloud();
    for (const materialPointCloud::mover& mv : movers)
    {
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const scalar l = (*cloud.halfSize())[d][mv.point];
            const scalar h = grid_.width(mv.cell, d);
            if (l > 2*h)
            {
                FatalErrorInFunction
                    << "Material point " << label(cloud.id()[0][mv.point])
                    << " of " << phase.name() << " at "
                    << cloud.position(mv.point, cloud.cellOf(mv.point))
                    << ", time " << mesh_.time().timeName()
                    << ", has half-size " << l << " and moves into a cell"
                    << " only " << h << " wide." << nl
                    << "Use more points per cell in setMaterialPointsDict, or"
                    << " a mesh that is graded less." << exit(FatalError);
            }
        }
    }
}


void Foam::mpm::pointPhaseSystem::checkOverlap()
{
    if (warned_ || fields_.size() < 2)
    {
        return;
    }
    labelList owner(grid_.nNodes(), label(-1));
    forAll(fields_, fieldi)
    {
        const gridState& field = fields_[fieldi];
        for (const label n : field.active())
        {
            if (!(field.momentum()[field.stride()*n + grid_.nDim()] > 0))
            {
                continue;
            }
            if (owner[n] >= 0 && !warned_)
            {
                warned_ = true;
                WarningInFunction
                    << "The velocity fields " << fields_[owner[n]].name()
                    << " and " << field.name() << " meet at "
                    << mesh_.points()[grid_.nodePoint()[n]] << ", time "
                    << mesh_.time().timeName()
                    << ". Nothing acts between them: phases with own velocity"
                    << " fields pass through each other. Give them the same"
                    << " velocityField in constant/phaseProperties to let"
                    << " them stick and push." << endl;
            }
            owner[n] = fieldi;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pointPhaseSystem::report() const
{
    scalar mass = 0, kinetic = 0, strain = 0;
    vector momentum(Zero);
    label nFailed = 0;
    for (const materialPointPhase& phase : phases_)
    {
        mass += phase.mass();
        momentum += phase.momentum();
        kinetic += phase.kineticEnergy();
        strain += phase.strainEnergy();
        nFailed += const_cast<materialPointPhase&>(phase).nFailed();
    }
    Info<< "Material points: " << nPoints() << ", mass " << mass
        << ", momentum " << momentum << nl
        << "Energy: kinetic " << kinetic << ", strain " << strain
        << ", total " << kinetic + strain << nl
        << "Failed points: " << nFailed << ", steps redone: " << nRedone_
        << endl;
}


Foam::dictionary Foam::mpm::pointPhaseSystem::state() const
{
    dictionary state;
    state.add("rate", rate_);
    state.add("waveRate", waveRate_);
    state.add("stepsRedone", nRedone_);
    dictionary failed;
    for (const materialPointPhase& phase : phases_)
    {
        failed.add
        (
            phase.name(),
            const_cast<materialPointPhase&>(phase).nFailed()
        );
    }
    state.add("failed", failed);
    return state;
}


void Foam::mpm::pointPhaseSystem::setState(const dictionary& state)
{
    rate_ = required<scalar>(state, "rate");
    waveRate_ = required<scalar>(state, "waveRate");
    nRedone_ = required<label>(state, "stepsRedone");
    const dictionary& failed = requiredDict(state, "failed");
    for (materialPointPhase& phase : phases_)
    {
        phase.nFailed() = failed.getOrDefault<label>(phase.name(), 0);
    }
}


void Foam::mpm::pointPhaseSystem::writePoints()
{
    for (gridState& field : fields_)
    {
        field.writeField();
    }

    if (alpha_.empty())
    {
        alpha_.setSize(phases_.size());
        Umean_.setSize(phases_.size());
        sigmaMean_.setSize(phases_.size());
        forAll(phases_, phasei)
        {
            const auto object = [&](const word& name)
            {
                return IOobject
                (
                    IOobject::groupName(name, phases_[phasei].name()),
                    mesh_.time().timeName(),
                    mesh_,
                    IOobject::NO_READ,
                    IOobject::AUTO_WRITE
                );
            };
            alpha_.set
            (
                phasei,
                new volScalarField
                (object("alpha"), mesh_, dimensionedScalar(dimless, Zero))
            );
            Umean_.set
            (
                phasei,
                new volVectorField
                (object("Umean"), mesh_, dimensionedVector(dimVelocity, Zero))
            );
            sigmaMean_.set
            (
                phasei,
                new volSymmTensorField
                (
                    object("sigma"),
                    mesh_,
                    dimensionedSymmTensor(dimPressure, Zero)
                )
            );
        }
    }

    forAll(phases_, phasei)
    {
        materialPointCloud& cloud = phases_[phasei].cloud();
        cloud.writePoints();

        alpha_[phasei] = dimensionedScalar(dimless, Zero);
        Umean_[phasei] = dimensionedVector(dimVelocity, Zero);
        sigmaMean_[phasei] = dimensionedSymmTensor(dimPressure, Zero);

        forAll(cloud.cells(), k)
        {
            const label celli = cloud.cells()[k];
            scalar v = 0, m = 0;
            vector mU(Zero);
            symmTensor vSigma(Zero);
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                const scalar vp = cloud.volume()[0][p];
                const scalar mp = cloud.mass()[0][p];
                v += vp;
                m += mp;
                mU += mp*cloud.velocity(p);
                vSigma += vp*cloud.sigma(p);
            }
            alpha_[phasei][celli] = v/mesh_.V()[celli];
            Umean_[phasei][celli] = mU/m;
            sigmaMean_[phasei][celli] = vSigma/v;
        }
    }
}

// ************************************************************************* //
