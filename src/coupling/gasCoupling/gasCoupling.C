/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"
#include "pointEnergy.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "emptyPolyPatch.H"
#include "coupledPolyPatch.H"
#include "syncTools.H"
#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::gasCoupling::unclippedFraction
(
    const scalarList& face,
    const label facei
) const
{
    const int d = sums_.direction(facei);
    const label at = sums_.nPlaces()*d + sums_.facePlace(facei);
    return
        (1 - eps_)*face[pointKernels::faceStride*at + pointKernels::volume]
       /faceVolume(facei);
}


Foam::scalar Foam::mpm::gasCoupling::faceVolume(const label facei) const
{
    const label celli = mesh_.faceOwner()[facei];
    return
        sums_.grid().radial() < 0
      ? mesh_.V()[celli]
      : mag(mesh_.faceAreas()[facei])
       *sums_.grid().width(celli, sums_.direction(facei));
}


Foam::scalar Foam::mpm::gasCoupling::solidFraction(const label celli) const
{
    const label at = pointKernels::cellStride*sums_.place(celli);
    return (1 - eps_)*cell_[at + pointKernels::fraction]/mesh_.V()[celli];
}


void Foam::mpm::gasCoupling::updateVolume
(
    materialPointCloud& cloud,
    const label phasei
)
{
    const scalar* v = cloud.volume()[0];
    scalar* to = (*cloud.gasVolume())[0];
    if (points_.phases()[phasei].grains())
    {
        const scalar rho = points_.phases()[phasei].rho();
        const scalar* m = cloud.mass()[0];
        for (label p = 0; p < cloud.size(); ++p)
        {
            to[p] = m[p]/rho;
        }
        return;
    }
    std::copy(v, v + cloud.size(), to);
    if (const column* damage = cloud.damage())
    {
        const scalar rho = points_.phases()[phasei].law().rho();
        for (label p = 0; p < cloud.size(); ++p)
        {
            if ((*damage)[0][p] >= 1)
            {
                to[p] = min(to[p], cloud.mass()[0][p]/rho);
            }
        }
    }
}


void Foam::mpm::gasCoupling::sumPoints(const bool withDilation)
{
    cell_ = 0;
    forAll(points_.phases(), phasei)
    {
        materialPointCloud& cloud = points_.phases()[phasei].cloud();
        updateVolume(cloud, phasei);
        const bool pushes = granular_.set(phasei);
        if (pushes)
        {
            grainFace_[phasei] = 0;
            grainCell_[phasei] = 0;
        }
        scalarList& face = pushes ? grainFace_[phasei] : faceNew_;
        scalarList& cell = pushes ? grainCell_[phasei] : cell_;
        kernels_->arrive
        (
            cloud,
            withDilation ? oldVolume_[phasei].cdata() : nullptr,
            face.data(),
            cell.data()
        );
        if (pushes)
        {
            forAll(face, i)
            {
                faceNew_[i] += face[i];
            }
            forAll(cell, i)
            {
                cell_[i] += cell[i];
            }
            sumFaces(face);
            sums_.sum(cell.data(), pointKernels::cellStride);
        }
    }
    sumFaces(faceNew_);
    sums_.sum(cell_.data(), pointKernels::cellStride);
}


void Foam::mpm::gasCoupling::sumFaces(scalarList& face) const
{
    const int D = sums_.grid().nDim();
    for (int d = 0; d < D; ++d)
    {
        sums_.sum
        (
            face.data() + pointKernels::faceStride*sums_.nPlaces()*d,
            pointKernels::faceStride
        );
    }

    // The solid is mirrored at walls
    for (const label facei : sums_.walls())
    {
        const label at =
            sums_.nPlaces()*sums_.direction(facei) + sums_.facePlace(facei);
        scalar* q = face.data() + pointKernels::faceStride*at;
        q[pointKernels::volume] *= 2;
        q[pointKernels::mass] *= 2;
        q[pointKernels::flux] = 0;
    }
}


void Foam::mpm::gasCoupling::limitFaceDrag()
{
    scalarField largest(mesh_.nCells(), 0);
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    forAll(thetaS_, f)
    {
        largest[own[f]] = max(largest[own[f]], dragLimit_[f]);
        if (f < nei.size())
        {
            largest[nei[f]] = max(largest[nei[f]], dragLimit_[f]);
        }
    }
    scalarField behind(mesh_.nFaces() - mesh_.nInternalFaces());
    scalarField Kbehind(behind.size()), massBehind(behind.size());
    const auto mass = [&](const label c)
    {
        // With more solid one step throws the gas too far
        const scalar rho = gas_.rho()[c];
        return (rho + min(held_[c], 15*rho))*mesh_.V()[c];
    };
    forAll(behind, i)
    {
        behind[i] = largest[own[mesh_.nInternalFaces() + i]];
        Kbehind[i] = Kc_[own[mesh_.nInternalFaces() + i]];
        massBehind[i] = mass(own[mesh_.nInternalFaces() + i]);
    }
    syncTools::swapBoundaryFaceList(mesh_, behind);
    syncTools::swapBoundaryFaceList(mesh_, Kbehind);
    syncTools::swapBoundaryFaceList(mesh_, massBehind);
    forAll(thetaS_, f)
    {
        const label i = f - mesh_.nInternalFaces();
        const scalar most =
            max(largest[own[f]], i < 0 ? largest[nei[f]] : behind[i]);
        dragLimit_[f] = most > 0 ? thetaS_[f]/most : 0;
        K_[f] = max(Kc_[own[f]], i < 0 ? Kc_[nei[f]] : Kbehind[i]);
        inertia_[f] =
            min(mass(own[f]), i < 0 ? mass(nei[f]) : massBehind[i]);
    }
}


void Foam::mpm::gasCoupling::prepareFaces(const scalar dt)
{
    for (label f = 0; f < mesh_.nFaces(); ++f)
    {
        const int d = sums_.direction(f);
        if (d < 0)
        {
            continue;
        }
        const label at = sums_.nPlaces()*d + sums_.facePlace(f);
        const scalar* old = face_.cdata() + pointKernels::faceStride*at;
        const scalar* now = faceNew_.cdata() + pointKernels::faceStride*at;
        const scalar sumOld = old[pointKernels::volume];
        const scalar sumNow = now[pointKernels::volume];
        if (sumOld <= 0 && sumNow <= 0)
        {
            thetaS0_[f] = thetaS_[f] = phiS_[f] = uS_[f] = 0;
            dragLimit_[f] = 0;
            continue;
        }

        const scalar V = faceVolume(f);
        const scalar S = mag(mesh_.faceAreas()[f]);
        const scalar mean = 0.5*(1 - eps_)*(sumOld + sumNow)/V;
        thetaS0_[f] = min((1 - eps_)*sumOld/V, most_);
        thetaS_[f] = min(mean, most_);
        dragLimit_[f] = mean;

        // S/V is 1/h; the lattice's own 1/h differs from it by rounding, which
        // adds up in the gas fraction
        phiS_[f] =
            sums_.sign(f)*(thetaS_[f]/mean)*(1 - eps_)
           *now[pointKernels::flux]*S/(V*dt);
        uS_[f] = phiS_[f]/(thetaS_[f]*S);

        const scalar m = old[pointKernels::mass] + now[pointKernels::mass];
        rhoS_[f] = m/(sumOld + sumNow);
    }
    forAll(dilation_, c)
    {
        dilation_[c] =
            (1 - eps_)
           *cell_[pointKernels::cellStride*sums_.place(c) + pointKernels::dilation]
           /mesh_.V()[c];
    }
    limitFaceDrag();
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gasCoupling::gasCoupling
(
    materialPointSystem& points,
    eulerianGas& gas,
    const dictionary& properties
)
:
    mesh_(refCast<const fvMesh>(points.grid().mesh())),
    points_(points),
    gas_(gas),
    sums_(points.grid()),
    kernels_(pointKernels::New(sums_)),
    eps_
    (
        boundedOrDefault
        (
            requiredDict(properties, gas.name()), "poreFloor", 1e-2, 1e-6, 0.5
        )
    ),
    mu_
    (
        boundedOrDefault
        (
            requiredDict(properties, gas.name()), "mu", 0, 0, GREAT
        )
    ),
    Pr_
    (
        boundedOrDefault
        (
            requiredDict(properties, gas.name()), "Pr", 0, 0, GREAT
        )
    ),
    most_(1 - (points.grid().radial() < 0 ? 0.5 : 1)*eps_),
    drag_(points.phases().size()),
    heat_(points.phases().size()),
    granular_(points.phases().size()),
    grainFace_(points.phases().size()),
    grainCell_(points.phases().size()),
    waveRate_(0),
    face_(pointKernels::faceStride*sums_.nPlaces()*points.grid().nDim(), scalar(0)),
    faceNew_(face_.size(), scalar(0)),
    cell_(pointKernels::cellStride*sums_.nPlaces(), scalar(0)),
    P_(sums_.nPlaces(), scalar(0)),
    G_(sums_.nPlaces()*points.grid().nDim(), scalar(0)),
    oldVolume_(points.phases().size()),
    thetaS0_(mesh_.nFaces(), 0),
    thetaS_(mesh_.nFaces(), 0),
    phiS_(mesh_.nFaces(), 0),
    uS_(mesh_.nFaces(), 0),
    K_(mesh_.nFaces(), 0),
    dragLimit_(mesh_.nFaces(), 0),
    inertia_(mesh_.nFaces(), 0),
    rhoS_(mesh_.nFaces(), 0),
    dilation_(mesh_.nCells(), 0),
    J_(mesh_.nCells(), Zero),
    Q_(mesh_.nCells(), 0),
    Kc_(mesh_.nCells(), 0),
    held_(mesh_.nCells(), 0),
    push_(points.phases().size(), Zero),
    books_(false),
    rigidWork_(0),
    normalOnly_(false),
    energyOfAll_(0)
{
    if (!gas_.thermo().isGammaLaw())
    {
        FatalIOErrorInFunction(requiredDict(properties, gas_.name()))
            << "Gas " << gas_.name() << " has an equationOfState; beside"
            << " material points it needs thermo perfectGas or isentropic."
            << exit(FatalIOError);
    }
    forAll(points_.phases(), phasei)
    {
        materialPointPhase& phase = points_.phases()[phasei];
        const dictionary& dict = requiredDict(properties, phase.name());
        dictionary stick;
        stick.add("type", "stick");
        drag_.set
        (
            phasei,
            dragModel::New
            (
                dict.found("drag") ? requiredDict(dict, "drag") : stick
            )
        );
        normalOnly_ = normalOnly_ || drag_[phasei].normalOnly();
        if (drag_[phasei].needsViscosity() && !(mu_ > 0))
        {
            FatalIOErrorInFunction(dict)
                << "The drag of " << phase.name() << " needs the viscosity"
                << " of the gas: add mu [Pa s] to phase " << gas_.name() << "."
                << exit(FatalIOError);
        }
        readHeat(phasei, dict);
        readGranular(phasei, dict);
        phase.cloud().needGas();
    }

    pores_.thetaS0 = thetaS0_.cdata();
    pores_.thetaS = thetaS_.cdata();
    pores_.phiS = phiS_.cdata();
    pores_.uS = uS_.cdata();
    pores_.K = K_.cdata();
    pores_.dragLimit = dragLimit_.cdata();
    pores_.inertia = inertia_.cdata();
    pores_.rhoS = rhoS_.cdata();
    pores_.dilation = dilation_.cdata();
    pores_.eps = eps_;
    pores_.fd = readFaceDrag(requiredDict(properties, gas.name()));

    const noTraps guard;
    points_.couple(*this);
    sumPoints(false);
    face_.swap(faceNew_);
    faceNew_ = 0;

    scalarField theta(mesh_.nCells());
    forAll(theta, c)
    {
        theta[c] = max(1 - solidFraction(c), 1 - most_);
    }
    gas_.setTheta(theta);
    measureEnergy();
    if (points_.energy().active())
    {
        // The points began before the gas was there
        needEnergy();
        startBudget();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::gasCoupling::start(const scalar)
{
    const noTraps guard;
    const int D = sums_.grid().nDim();
    const List<gasState>& W = gas_.states();

    P_ = 0;
    forAll(sums_.places(), c)
    {
        P_[sums_.place(c)] = W[c].p;
    }
    sums_.sum(P_.data(), 1);

    G_ = 0;
    const auto jump = [&](const label f, const scalar pO, const scalar pN)
    {
        const scalar theta = unclippedFraction(face_, f);
        if (theta > 0)
        {
            const int d = sums_.direction(f);
            const scalar clip = min(scalar(1), most_/theta);
            G_[sums_.nPlaces()*d + sums_.facePlace(f)] =
                (1 - eps_)*clip*sums_.sign(f)*(pN - pO)
               *mag(mesh_.faceAreas()[f])/faceVolume(f);
        }
    };
    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        jump(f, W[mesh_.faceOwner()[f]].p, W[mesh_.faceNeighbour()[f]].p);
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!isA<coupledPolyPatch>(pp))
        {
            continue;
        }
        forAll(pp, i)
        {
            // The processor of the upper cell gives it to both
            const label f = pp.start() + i;
            const label c = mesh_.faceOwner()[f];
            if (sums_.sign(f) < 0)
            {
                jump
                (
                    f,
                    W[c].p,
                    gas_.boundaryStates()[f - mesh_.nInternalFaces()].p
                );
            }
        }
    }
    for (int d = 0; d < D; ++d)
    {
        sums_.sum(G_.data() + sums_.nPlaces()*d, 1);
    }

    forAll(points_.phases(), phasei)
    {
        materialPointPhase& phase = points_.phases()[phasei];
        materialPointCloud& cloud = phase.cloud();
        kernels_->gather
        (
            cloud,
            P_.cdata(),
            granular_.set(phasei) ? grainJumps(phasei).cdata() : G_.cdata()
        );
        if (phase.motion())
        {
            push_[phasei] = Zero;
            for (int d = 0; d < D; ++d)
            {
                const scalar* F = (*cloud.gasForce())[d];
                push_[phasei][sums_.grid().direction(d)] =
                    std::accumulate(F, F + cloud.size(), scalar(0));
            }
            if (freeBody* body = phase.motion()->free())
            {
                pushBody(*body, cloud, push_[phasei]);
            }
            continue;
        }

        // Grains have all of the gas' pressure in gasForce
        if (phase.grains())
        {
            scalar* pressure = (*cloud.gasPressure())[0];
            std::fill(pressure, pressure + cloud.size(), scalar(0));
            continue;
        }

        // Dry points hold sigma + P
        if (const column* damage = cloud.damage())
        {
            scalar* pressure = (*cloud.gasPressure())[0];
            for (label p = 0; p < cloud.size(); ++p)
            {
                if ((*damage)[0][p] >= 1)
                {
                    pressure[p] = 0;
                }
            }
        }
    }
}


void Foam::mpm::gasCoupling::moved(const scalar)
{
    const noTraps guard;
    faceNew_ = 0;
    for (materialPointPhase& phase : points_.phases())
    {
        kernels_->depart(phase.cloud(), faceNew_.data());
    }
    if (books_)
    {
        bookRigid();
    }
}


void Foam::mpm::gasCoupling::accepted(const scalar)
{
    forAll(points_.phases(), phasei)
    {
        materialPointCloud& cloud = points_.phases()[phasei].cloud();
        const scalar* v = (*cloud.gasVolume())[0];
        oldVolume_[phasei].setSize(cloud.size() + column::padding);
        std::copy(v, v + cloud.size(), oldVolume_[phasei].begin());
    }
}


void Foam::mpm::gasCoupling::end(const scalar dt)
{
    const noTraps guard;
    sumPoints(true);
    prepareFaces(dt);
    face_.swap(faceNew_);
    if (books_)
    {
        bookDry();
        budget_.rigid += rigidWork_;
    }
}


void Foam::mpm::gasCoupling::advanceGas(const scalar dt)
{
    gas_.addSources(dragged_, J_, Q_);
    gas_.faceFlux(dt, &pores_);
    gas_.advance(dt, &pores_);
    exchangeHeat(dt);
    watch();
}


void Foam::mpm::gasCoupling::report() const
{
    scalar least = GREAT, most = -GREAT;
    forAll(gas_.theta(), c)
    {
        const scalar Theta = gas_.theta()[c] + solidFraction(c);
        least = min(least, Theta);
        most = max(most, Theta);
    }
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());
    measureEnergy();
    Info<< "Theta: min " << least << ", max " << most << endl;
    reportHeat();
}


void Foam::mpm::gasCoupling::write()
{
    volScalarField Theta
    (
        IOobject
        (
            "Theta",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar("Theta", dimless, 0)
    );
    forAll(Theta, c)
    {
        Theta[c] = gas_.theta()[c] + solidFraction(c);
    }
    Theta.write();
}

// ************************************************************************* //
