/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointSystem.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "largestOfAll.H"
#include "noTraps.H"
#include "uniformDimensionedFields.H"
#include "Time.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::materialPointSystem::readNumerics()
{
    const dictionary& dict =
        requiredDict(mesh_.solutionDict(), "materialPoints");

    checkNumerics(dict);
    numerics_ = dict;
    transfer_ = transferScheme::New(dict);
    stressUpdate_ = stressUpdate::New(dict);
    readLimits(dict);
}


void Foam::mpm::materialPointSystem::readLimits(const dictionary& dict)
{
    maxTravel_ = boundedOrDefault(dict, "maxTravel", 0.5, 1e-3, 0.9);
    maxStrain_ = boundedOrDefault(dict, "maxStrain", 0.2, 1e-4, 1);
}


void Foam::mpm::materialPointSystem::checkNumerics(const dictionary& dict)
{
    wordList valid(transferScheme::keywordsOfAll(dict));
    valid.append
    (
        wordList
        ({
            "shapeFunction", "dilatation", "stressUpdate", "energyBudget",
            "maxTravel", "maxStrain"
        })
    );
    checkKeywords(dict, valid);
}


void Foam::mpm::materialPointSystem::startAffine()
{
    // Fixed point of C = grad u(v, C): rigid rotation to rounding
    const noTraps guard;
    for (label i = 0; i < 200; ++i)
    {
        scalar size = 0, change = 0;
        forAll(phases_, phasei)
        {
            materialPointCloud& cloud = phases_[phasei].cloud();
            const velocityField& field = fields_[fieldOf_[phasei]];
            if (phases_[phasei].motion())
            {
                continue;
            }
            gridTransfer_->affine(cloud, false, field.U(), 0);
            column& C = *cloud.affine();
            column& CNew = *cloud.affineNew();
            for (int c = 0; c < C.nComponents(); ++c)
            {
                for (label p = 0; p < cloud.size(); ++p)
                {
                    size = max(size, mag(CNew[c][p]));
                    change = max(change, mag(CNew[c][p] - C[c][p]));
                }
            }
            C.swap(CNew);
        }
        activate(false);
        projectAll(pointGridTransfer::current);
        for (velocityField& field : fields_)
        {
            field.accept();
        }
        reduce(size, maxOp<scalar>());
        reduce(change, maxOp<scalar>());
        if (debug)
        {
            Info<< "startAffine " << i << ": " << change << " of " << size << nl;
        }
        if (change <= 1e-14*size)
        {
            break;
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::materialPointSystem::materialPointSystem(const fvMesh& mesh)
:
    regIOobject
    (
        IOobject
        (
            "materialPointSystem",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(mesh),
    grid_(hexGrid::New(mesh)),
    properties_
    (
        IOobject
        (
            "phaseProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    g_(Zero),
    erodes_(false),
    started_(0),
    empty_(false),
    rate_(0),
    waveRate_(0),
    nRedone_(0),
    dt_(0),
    tentative_(false),
    damped_(false),
    warned_(false),
    coupling_(nullptr),
    startEnergy_(0),
    largestEnergy_(0),
    energyGrowth_(0),
    sourceless_(false)
{
    IOobject gHeader
    (
        "g",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if
    (
        gHeader.typeHeaderOk<uniformDimensionedVectorField>(true)
     || exists(mesh.time().globalPath()/mesh.time().constant()/"g")
    )
    {
        const auto g = readNamed
        (
            gHeader.objectPath(),
            [&]
            {
                const uniformDimensionedVectorField field(gHeader);
                return dimensionedVector(field.name(), field.dimensions(),
                    field.value());
            }
        );
        const noTraps guard;
        if (g.dimensions() != dimAcceleration || !std::isfinite(mag(g.value())))
        {
            FatalErrorInFunction
                << "Gravity in " << gHeader.objectPath() << " is " << g.value()
                << ' ' << g.dimensions() << "; it must be finite and in "
                << dimAcceleration << " (m/s2)." << exit(FatalError);
        }
        g_ = g.value();
        checkGravity(gHeader.objectPath(), g_, mesh.geometricD());
    }

    requireClosed(properties_.objectPath());
    requireClosed(mesh.solutionDict().name());
    readNumerics();
    gridTransfer_ = pointGridTransfer::New
    (
        mesh.solutionDict().subDict("materialPoints"),
        grid_
    );

    const wordList names(materialPointPhase::names(properties_));
    phases_.setSize(names.size());
    fieldOf_.setSize(names.size());
    cellChanges_.setSize(names.size());
    eroded_.setSize(names.size());
    left_.setSize(names.size());
    if (properties_.found("outflow"))
    {
        outflow_.reset
        (
            new outflowPatches(requiredDict(properties_, "outflow"), grid_)
        );
    }
    debris_.setSize(names.size(), -1);

    wordList fieldNames;
    forAll(names, phasei)
    {
        phases_.set
        (
            phasei,
            new materialPointPhase
            (
                grid_,
                names[phasei],
                requiredDict(properties_, names[phasei]),
                // Contact sees the points' boxes with every shape function
                gridTransfer_->hasExtent() || properties_.found("contact"),
                transfer_->affine() != transferScheme::none
            )
        );
        erodes_ = erodes_ || phases_[phasei].erosion();
        const word& field = phases_[phasei].velocityField();
        fieldOf_[phasei] = fieldNames.find(field);
        if (fieldOf_[phasei] < 0)
        {
            fieldOf_[phasei] = fieldNames.size();
            fieldNames.append(field);
        }
    }

    fields_.setSize(fieldNames.size());
    forAll(fieldNames, fieldi)
    {
        const fileName file
        (
            mesh.time().timePath()
           /IOobject::groupName("U", fieldNames[fieldi])
        );
        fields_.set
        (
            fieldi,
            readNamed
            (
                file,
                [&]
                {
                    return new velocityField
                    (
                        grid_,
                        fieldNames[fieldi],
                        gridTransfer_->reach()
                    );
                }
            )
        );
        fields_[fieldi].rigid().setPhases(phases_.size());
        forAll(phases_, phasei)
        {
            rigidMotion* motion = phases_[phasei].motion();
            if (motion && motion->free() && fieldOf_[phasei] == fieldi)
            {
                fields_[fieldi].rigid().addBody(phasei, *motion->free());
            }
        }
    }

    connectDebris();
    forAll(phases_, phasei)
    {
        materialPointPhase& phase = phases_[phasei];
        phase.read
        (
            debris_.found(phasei),
            phase.erosion() || (outflow_ && !phase.motion())
        );
        Info<< "Phase " << phase.name() << ": "
            << returnReduce(phase.cloud().size(), sumOp<label>())
            << " points of ";
        if (phase.motion())
        {
            Info<< "a rigid body, motion " << phase.motion()->type();
            phase.motion()->start(mesh_.time().value(), phase.cloud());
            phase.motion()->setVelocity(phase.cloud());
        }
        else
        {
            Info<< phase.law().type() << ", wave speed "
                << phase.law().waveSpeed() << " m/s";
        }
        if (const freeBody* b = phase.motion() ? phase.motion()->free() : nullptr)
        {
            Info<< ", mass " << b->mass() << " kg";
        }
        Info<< ", velocity field " << phase.velocityField() << nl;

        // The domain of a point must not reach past the next cell
        if (gridTransfer_->hasExtent())
        {
            materialPointCloud& cloud = phase.cloud();
            forAll(cloud.cells(), k)
            {
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    for (int d = 0; d < grid_.nDim(); ++d)
                    {
                        const scalar l = (*cloud.halfSize())[d][p];
                        if (l > 1.0001*grid_.width(cloud.cells()[k], d))
                        {
                            FatalErrorInFunction
                                << "Material point " << cloud.id()[0][p]
                                << " of " << phase.name() << " at "
                                << cloud.position(p, cloud.cells()[k])
                                << ", time " << mesh_.time().timeName()
                                << ", has half-size " << l
                                << ", larger than its cell." << nl
                                << "Use more points per cell in"
                                << " setMaterialPointsDict or the shape"
                                << " function linear." << exit(FatalError);
                        }
                    }
                }
            }
        }
        const materialPointCloud& cloud = phase.cloud();
        forAll(cloud.cells(), k)
        {
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                const scalar ih = 1/grid_.width(cloud.cells()[k], d);
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    rate_ = max(rate_, mag(cloud.U()[d][p])*ih);
                }
            }
        }
    }
    rate_ = largestOfAll(rate_);
    updateWaveRate();
    countStarted();

    contact_ = pointContact::New
    (
        properties_,
        grid_,
        phases_,
        fields_,
        fieldOf_,
        *gridTransfer_
    );
    startNodes();
    if (contact_)
    {
        contact_->update();

        // Nothing to warn of
        warned_ = true;
        for (label a = 0; a < fields_.size(); ++a)
        {
            for (label b = a + 1; b < fields_.size(); ++b)
            {
                warned_ = warned_ && contact_->between(a, b);
            }
        }
    }
    bool haveAffine = true;
    for (const materialPointPhase& phase : phases_)
    {
        haveAffine = haveAffine && (phase.motion() || phase.cloud().affineRead());
    }
    if
    (
        transfer_->affine() != transferScheme::none
     && !returnReduce(haveAffine, orOp<bool>())
    )
    {
        startAffine();
    }
    for (velocityField& field : fields_)
    {
        field.writeField();
    }
    if
    (
        mesh.solutionDict().subDict("materialPoints")
       .getOrDefault<bool>("energyBudget", false)
    )
    {
        bookEnergy();
    }
    checkOverlap();

    readWeights();
    watches_.setSize(phases_.size());
    forAll(phases_, phasei)
    {
        const materialPointPhase& phase = phases_[phasei];
        if (!phase.motion() && phase.law().holdsTogether())
        {
            watches_.set(phasei, new separationWatch(phase));
        }
    }

    Info<< "Material points: " << nPoints() << " in "
        << phases_.size() << " phases, "
        << (grid_.radial() >= 0 ? "axisymmetric " : "") << grid_.nDim() << "D, "
        << grid_.nNodes() << " nodes, "
        << (grid_.hasLattice() ? "lattice" : "general hexahedra") << nl
        << "    shape function "
        << mesh.solutionDict().subDict("materialPoints").get<word>("shapeFunction")
        << (gridTransfer_->cellMeans ? ", dilatation cellMean" : "")
        << ", stress update " << stressUpdate_->type() << nl << "    ";
    transfer_->write(Info);
    reportBalance();
    Info<< "    " << bytesPerPoint() << " bytes per point in columns and"
        << " buffers, " << gridBytes()/max(nPoints(), label(1))
        << " on the nodes" << nl << endl;
}

// ************************************************************************* //
