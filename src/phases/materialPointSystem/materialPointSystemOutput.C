/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "noTraps.H"
#include "dictionaryTools.H"
#include "OSspecific.H"
#include "Time.H"
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::mpm::materialPointSystem::writeBeforeStop()
{
    // The state before the step is untouched: it is what gets written, but
    // never over a state that is on disk already
    Time& time = const_cast<Time&>(mesh_.time());
    if (returnReduce(isDir(time.path()/time.timeName()), orOp<bool>()))
    {
        return
            "The state before the step is that of time " + time.timeName()
          + " on disk.";
    }
    writePoints();
    time.writeNow();
    return
        "The state before the step is written to " + time.timeName() + ".";
}


void Foam::mpm::materialPointSystem::stop(const badPoint& bad)
{
    const noTraps guard;
    const string written(writeBeforeStop());

    // One processor tells; it ends the others, which wait
    const label teller = returnReduce
    (
        bad.phase < 0 ? labelMax : Pstream::myProcNo(),
        minOp<label>()
    );
    if (teller != Pstream::myProcNo())
    {
        returnReduce(label(0), sumOp<label>());
        return;
    }

    const Time& time = mesh_.time();
    const scalar dt = time.deltaTValue();
    const label pointi = bad.point;
    materialPointPhase& phase = phases_[bad.phase];
    materialPointCloud& cloud = phase.cloud();
    const point x(cloud.position(pointi, cloud.cellOf(pointi)));

    const bool badStress =
        !std::isfinite(magSqr(cloud.sigma(pointi)))
     || !std::isfinite(cloud.volume()[0][pointi]);

    if (bad.left)
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
            << "Make the mesh larger, keep points inside by the boundary"
            << " conditions of U." << phase.velocityField()
            << " (fixedValue or slip), or let them go:"
            << "  outflow { patches (...); }  in constant/phaseProperties."
            << exit(FatalError);
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


void Foam::mpm::materialPointSystem::checkExtent
(
    materialPointPhase& phase,
    const UList<materialPointCloud::cellChange>& cellChanges
)
{
    // GIMP's stencil reaches one cell beyond: from two cell widths on weights
    // would become negative
    if (!gridTransfer_->hasExtent() || grid_.sameWidth() > 0)
    {
        return;
    }
    materialPointCloud& cloud = phase.cloud();
    for (const materialPointCloud::cellChange& mv : cellChanges)
    {
        if (mv.cell >= grid_.nCells())
        {
            continue;
        }
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const scalar l = (*cloud.halfSize())[d][mv.point];
            const scalar h = grid_.width(mv.cell, d);
            if (l > 2*h)
            {
                FatalErrorInFunction
                    << "Material point " << label(cloud.id()[0][mv.point])
                    << " of " << phase.name() << " at "
                    << mesh_.cellCentres()[mv.cell]
                    << ", time " << mesh_.time().timeName()
                    << ", has half-size " << l << " and moves into a cell"
                    << " only " << h << " wide." << nl
                    << "Use more points per cell in setMaterialPointsDict, or"
                    << " a mesh that is graded less." << exit(FatalError);
            }
        }
    }
}


void Foam::mpm::materialPointSystem::checkOverlap()
{
    if (warned_ || fields_.size() < 2)
    {
        return;
    }
    labelList owner(grid_.nNodes(), label(-1));
    labelList rigidOf(grid_.nNodes(), label(-1));
    forAll(fields_, fieldi)
    {
        const velocityField& field = fields_[fieldi];
        for (const label n : field.rigid().nodes())
        {
            rigidOf[n] = fieldi;
        }
        for (const label n : field.active())
        {
            if
            (
                grid_.nodePoint()[n] < 0
             || (
                    rigidOf[n] != fieldi
                 && !(field.momentum()[field.stride()*n + grid_.nDim()] > 0)
                )
            )
            {
                continue;
            }
            if
            (
                owner[n] >= 0
             && !warned_
             && !(contact_ && contact_->between(owner[n], fieldi))
            )
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
                    << " them stick and push, or add contact { ... }; there."
                    << endl;
            }
            owner[n] = fieldi;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::report() const
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
        nFailed += returnReduce
        (
            const_cast<materialPointPhase&>(phase).nFailed(),
            sumOp<label>()
        );
    }
    const label nPresent = nPoints();
    Info<< "Material points: " << nPresent << ", mass " << mass
        << ", momentum " << momentum << nl
        << "Energy: kinetic " << kinetic << ", strain " << strain
        << ", total " << kinetic + strain << nl;
    const energyBudget* b = budget();
    noteEnergy(kinetic + strain, b);
    if (b)
    {
        Info<< "Energy budget: transfer " << b->transfer() << ", boundary "
            << b->work.boundary << ", external " << b->work.external
            << ", failure " << b->losses.failure << ", dissipation "
            << b->losses.dissipation;
        if (contact_)
        {
            Info<< ", contact " << b->work.contact;
        }
        if (erodes())
        {
            Info<< ", erosion " << b->erosion();
        }
        if (damps())
        {
            Info<< ", damping " << b->damping;
        }
        if (b->hasGas)
        {
            const gasBudget& g = b->gas;
            Info<< nl << "    gas " << g.energy << ", gained "
                << g.energy - g.energy0 << ", boundary " << g.boundary
                << ", external " << g.external << ", rigid " << g.rigid
                << ", dry " << g.dry << ", fix-ups " << g.fixups << nl
                << "    all";
        }
        else
        {
            Info<< ", remap " << b->remap() << ',';
        }
        Info<< " residual " << b->residual() << nl;
    }
    Info<< "Failed points: " << nFailed << ", steps redone: " << nRedone_
        << endl;
    reportErosion(nPresent);
    forAll(phases_, phasei)
    {
        if (phases_[phasei].motion())
        {
            Info<< "Load on " << phases_[phasei].name() << ": force "
                << rigidStepImpulse(phasei)/max(dt_, VSMALL) << " N, impulse "
                << rigidImpulse(phasei) << " N s" << endl;
        }
    }
    if (contact_)
    {
        contact_->report(dt_);
    }
}


void Foam::mpm::materialPointSystem::reportClock() const
{
    const struct
    {
        const char* name;
        scalar seconds;
    } parts[] =
    {
        {"nodes", clock_.nodes},
        {"move", clock_.move},
        {"sort", clock_.sort},
        {"project", clock_.project},
        {"stress and force", clock_.stress},
        {"contact", clock_.contact},
        {"coupling", clock_.coupling},
        {"gas", clock_.gas}
    };
    scalar sum = 0;
    for (const auto& part : parts)
    {
        sum += part.seconds;
    }
    std::ostringstream line;
    line << std::fixed << std::setprecision(2) << "Parts of the steps' " << sum
        << " s:" << std::setprecision(1);
    const char* separator = " ";
    for (const auto& part : parts)
    {
        if (part.seconds > 0)
        {
            line << separator << part.name << ' ' << 100*part.seconds/sum
                << " %";
            separator = ", ";
        }
    }
    Info<< line.str().c_str() << nl << endl;
}


void Foam::mpm::materialPointSystem::reportBalance() const
{
    if (!Pstream::parRun())
    {
        return;
    }
    label n = 0;
    for (const materialPointPhase& phase : phases_)
    {
        n += phase.cloud().size();
    }
    labelList points(Pstream::nProcs());
    points[Pstream::myProcNo()] = n;
    Pstream::gatherList(points);
    if (!Pstream::master())
    {
        return;
    }
    label least = 0, most = 0;
    scalar sum = 0;
    forAll(points, proci)
    {
        least = points[proci] < points[least] ? proci : least;
        most = points[proci] > points[most] ? proci : most;
        sum += points[proci];
    }
    const scalar mean = sum/points.size();
    Info<< "    points per processor: mean " << mean << ", least "
        << points[least] << " (" << least << "), most " << points[most]
        << " (" << most << "), imbalance "
        << 100*(points[most]/mean - 1) << " %" << nl;
    if (points[most] > 1.3*mean)
    {
        Info<< "    the fullest processor sets the pace: cellWeights of"
            << " setMaterialPoints -cellWeights, named weightField in"
            << " system/decomposeParDict, share the points evenly" << nl;
    }
}


Foam::scalar Foam::mpm::materialPointSystem::storedEnergy() const
{
    scalar stored = -returnReduce
    (
        losses_.failure + losses_.dissipation,
        sumOp<scalar>()
    );
    for (const materialPointPhase& phase : phases_)
    {
        stored += phase.motion() ? 0 : phase.strainEnergy();
    }
    return stored;
}


void Foam::mpm::materialPointSystem::updateBudget() const
{
    budget_.kinetic = budget_.strain = 0;
    for (const materialPointPhase& phase : phases_)
    {
        // What moves as prescribed does work on the others: boundary
        if (!phase.prescribed())
        {
            budget_.kinetic += phase.kineticEnergy();
            budget_.strain += phase.strainEnergy();
        }
    }
    budget_.losses = losses_;
    budget_.losses.reduceAll();
    budget_.hasGas = coupling_;
    if (coupling_)
    {
        budget_.gas = coupling_->balance();
    }
}


void Foam::mpm::materialPointSystem::bookEnergy() const
{
    if (budget_.active)
    {
        return;
    }
    budget_.active = true;
    if (coupling_)
    {
        coupling_->needEnergy();
        coupling_->startBudget();
    }
    updateBudget();
    budget_.kinetic0 = budget_.kinetic;
    budget_.strain0 = budget_.strain;
}


const Foam::mpm::energyBudget* Foam::mpm::materialPointSystem::budget() const
{
    if (!budget_.active)
    {
        return nullptr;
    }
    updateBudget();
    return &budget_;
}


void Foam::mpm::materialPointSystem::writePoints()
{
    lookForSeparation();
    updateWeights();
    for (velocityField& field : fields_)
    {
        field.writeField();
    }

    if (alpha_.empty())
    {
        alpha_.setSize(phases_.size());
        Umean_.setSize(phases_.size());
        sigmaMean_.setSize(phases_.size());
        Tmean_.setSize(phases_.size());
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
            if (phases_[phasei].cloud().temperature())
            {
                Tmean_.set
                (
                    phasei,
                    new volScalarField
                    (
                        object("Tmean"),
                        mesh_,
                        dimensionedScalar(dimTemperature, Zero)
                    )
                );
            }
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
        if (const column* T = cloud.temperature())
        {
            Tmean_[phasei] = dimensionedScalar(dimTemperature, Zero);
            forAll(cloud.cells(), k)
            {
                scalar m = 0, mT = 0;
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    m += cloud.mass()[0][p];
                    mT += cloud.mass()[0][p]*(*T)[0][p];
                }
                Tmean_[phasei][cloud.cells()[k]] = mT/m;
            }
        }
    }
}

// ************************************************************************* //
