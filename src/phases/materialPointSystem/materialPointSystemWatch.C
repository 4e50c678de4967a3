/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A speed over a width: in words, and of which processor
struct fastest
{
    scalar rate = 0;
    string words;

    //- The words of the processor with the largest rate; 0 everywhere: none.
    //  Collective
    void combine()
    {
        const scalar most = returnReduce(rate, maxOp<scalar>());
        label teller =
            most > 0 && rate == most ? Pstream::myProcNo() : labelMax;
        reduce(teller, minOp<label>());
        List<string> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = words;
        Pstream::gatherList(all);
        Pstream::scatterList(all);
        rate = most;
        words = teller < all.size() ? all[teller] : string();
    }
};


string inWords
(
    const string& who,
    const char* what,
    const scalar speed,
    const scalar width
)
{
    OStringStream os;
    os.precision(4);
    os  << who.c_str() << ": " << what << ' ' << speed << " m/s in "
        << 1e3*width << " mm";
    return os.str();
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::materialPointSystem::hasSources() const
{
    bool sources = mag(g_) > 0 || coupling_;
    for (const materialPointPhase& phase : phases_)
    {
        sources =
            sources || phase.hasBodyForce()
         || (phase.prescribed() && phase.motion()->type() != "fixed");
    }
    for (const velocityField& field : fields_)
    {
        sources = sources || field.drives();
    }
    return returnReduce(sources, orOp<bool>());
}


void Foam::mpm::materialPointSystem::noteEnergy
(
    const scalar energy,
    const energyBudget* b
) const
{
    if (!(largestEnergy_ > 0))
    {
        // Less than this is rounding
        scalar least = 0;
        for (const materialPointPhase& phase : phases_)
        {
            if (!phase.motion())
            {
                least += 1e-12*phase.mass()*sqr(phase.law().waveSpeed());
            }
        }
        largestEnergy_ = max(least, energy);
        startEnergy_ = energy;
        sourceless_ = !hasSources();
    }
    if (b)
    {
        largestEnergy_ = max
        (
            largestEnergy_,
            max(energy, mag(b->hasGas ? b->gas.energy - b->gas.energy0 : 0))
        );
        // remap too: what forces and stresses do not agree on can grow
        energyGrowth_ =
            (b->residual() + b->remap())/max(largestEnergy_, VSMALL);
    }
    else if (sourceless_)
    {
        energyGrowth_ = (energy - startEnergy_)/max(largestEnergy_, VSMALL);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::mpm::materialPointSystem::limiter() const
{
    const noTraps guard;
    fastest sound, speed;
    forAll(phases_, phasei)
    {
        materialPointPhase& phase =
            const_cast<materialPointPhase&>(phases_[phasei]);
        const materialPointCloud& cloud = phase.cloud();
        const auto name = [&](const label p)
        {
            return
                "point " + Foam::name(label(cloud.id()[0][p])) + " of "
              + phase.name();
        };

        // Speeds
        forAll(cloud.cells(), k)
        {
            const scalar h = grid_.shortestSide(cloud.cells()[k]);
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                const scalar u = phase.largestSpeed(p);
                if (u > speed.rate*h)
                {
                    speed.rate = u/h;
                    speed.words = inWords(name(p), "speed", u, h);
                }
            }
        }

        if (phase.motion() || !cloud.size())
        {
            continue;
        }
        const scalar h = phase.shortestSide();
        const scalar c = phase.waveSpeed();
        if (c > sound.rate*h)
        {
            sound.rate = c/h;
            const label p = phase.fastestPoint();
            sound.words = inWords
            (
                p < 0 ? string(phase.name()) : string(name(p)),
                "sound",
                c,
                h
            );
        }
    }
    sound.combine();
    speed.combine();

    const fastest& most = sound.rate >= speed.rate ? sound : speed;
    const fastest& other = sound.rate >= speed.rate ? speed : sound;
    return
        most.rate > 0 && other.rate > 0.1*most.rate
      ? string(most.words + "; " + other.words)
      : most.words;
}


Foam::scalar Foam::mpm::materialPointSystem::energyGrowth() const
{
    return energyGrowth_;
}


void Foam::mpm::materialPointSystem::readModified()
{
    if (!mesh_.time().runTimeModifiable())
    {
        return;
    }
    const dictionary& dict =
        requiredDict(mesh_.solutionDict(), "materialPoints");
    if (numerics_ == dict)
    {
        return;
    }

    // What the run is built on stays
    const wordList fixed
    ({
        "shapeFunction", "dilatation", "transfer", "stressUpdate"
    });
    wordList keys(dict.toc());
    for (const word& key : numerics_.toc())
    {
        if (!keys.found(key))
        {
            keys.append(key);
        }
    }
    dictionary now(dict);
    wordList acts, later;
    for (const word& key : keys)
    {
        const entry* a = numerics_.findEntry(key);
        const entry* b = dict.findEntry(key);
        if (a && b && *a == *b)
        {
            continue;
        }
        (fixed.found(key) ? later : acts).append(key);
        if (fixed.found(key) && a)
        {
            now.set(a->clone(now).ptr());
        }
        else if (fixed.found(key))
        {
            now.remove(key);
        }
    }
    checkNumerics(dict);
    transfer_ = transferScheme::New(now);
    readLimits(now);
    if (now.getOrDefault<bool>("energyBudget", false))
    {
        bookEnergy();
    }
    if (acts.size())
    {
        Info<< "fvSolution.materialPoints has changed: " << flatOutput(acts)
            << " act from time " << mesh_.time().timeName() << " on" << nl
            << endl;
    }
    if (later.size())
    {
        WarningInFunction
            << "fvSolution.materialPoints has changed: " << flatOutput(later)
            << " act only in a new run; this one keeps the old ones." << endl;
    }
    numerics_ = dict;
}


void Foam::mpm::materialPointSystem::readWeights()
{
    IOobject header
    (
        "cellWeights",
        mesh_.time().timeName(),
        mesh_,
        IOobject::MUST_READ,
        IOobject::AUTO_WRITE
    );
    const bool found = header.typeHeaderOk<volScalarField>(true);
    if (returnReduce(found, andOp<bool>()))
    {
        weights_.reset(new volScalarField(header, mesh_));
    }
}


void Foam::mpm::materialPointSystem::updateWeights()
{
    if (!weights_)
    {
        return;
    }

    // As setMaterialPoints -cellWeights
    weights_->primitiveFieldRef() = 0.02;
    for (const materialPointPhase& phase : phases_)
    {
        const materialPointCloud& cloud = phase.cloud();
        forAll(cloud.cells(), k)
        {
            (*weights_)[cloud.cells()[k]] +=
                cloud.start()[k + 1] - cloud.start()[k];
        }
    }
}


void Foam::mpm::materialPointSystem::lookForSeparation()
{
    forAll(watches_, phasei)
    {
        if (watches_.set(phasei))
        {
            watches_[phasei].look(phases_[phasei]);
        }
    }
}

// ************************************************************************* //
