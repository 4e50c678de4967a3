// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "solidFraction.H"
#include "fractionLattice.H"
#include "dictionaryTools.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(solidFraction, 0);
defineRunTimeSelectionTable(solidFraction, dictionary);
}

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::mpm::solidFraction::updateVolumes()
{
    // Volume over that of the unstressed material beyond which no solid holds together
    constexpr scalar apart = 1.25;

    for (materialPointPhase& phase : points_.phases())
    {
        materialPointCloud& cloud = phase.cloud();
        const scalar rho = phase.rho();
        const scalar* v = cloud.volume()[0];
        const scalar* m = cloud.mass()[0];
        scalar* to = (*cloud.gasVolume())[0];
        if (phase.grains() || phase.motion())
        {
            for (label p = 0; p < cloud.size(); ++p)
            {
                to[p] = phase.grains() ? m[p] / rho : v[p];
            }
            continue;
        }

        // It pushes where -tr sigma/3 > p_0
        const bool pushes = phase.law().pushesGrown();
        const scalar least = -3 * phase.referencePressure();
        const column& sigma = cloud.stress();
        for (label p = 0; p < cloud.size(); ++p)
        {
            const bool grown = rho * v[p] > apart * m[p];
            to[p] = grown && !(pushes && sigma[0][p] + sigma[1][p] + sigma[2][p] < least)
                ? apart * m[p] / rho
                : v[p];
        }
        if (const column* damage = cloud.damage())
        {
            for (label p = 0; p < cloud.size(); ++p)
            {
                if ((*damage)[0][p] >= 1)
                {
                    to[p] = min(to[p], m[p] / rho);
                }
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::solidFraction::solidFraction(
    materialPointSystem& points, const dictionary& gasDict, const scalar clipped) :
    points_(points),
    mesh_(refCast<const fvMesh>(points.grid().mesh())),
    eps_(boundedOrDefault(gasDict, "poreFloor", 1e-2, 1e-6, 0.5)),
    most_(1 - clipped * eps_),
    thetaS0_(mesh_.nFaces(), 0),
    thetaS_(mesh_.nFaces(), 0),
    phiS_(mesh_.nFaces(), 0),
    uS_(mesh_.nFaces(), 0),
    rhoS_(mesh_.nFaces(), 0),
    dragLimit_(mesh_.nFaces(), 0),
    theta_(mesh_.nCells(), 0),
    dilation_(mesh_.nCells(), 0),
    gasPush_(mesh_.nCells(), Zero),
    coupled_(mesh_),
    surface_(points, mesh_, coupled_),
    own_(points.phases().size()),
    oldVolume_(points.phases().size()),
    isBetween_(mesh_.nFaces(), false),
    gasTheta_(nullptr),
    gasThetaBehind_(nullptr),
    gasWalls_(nullptr)
{
    std::fill_n(isBetween_.begin(), mesh_.nInternalFaces(), true);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        for (label i = 0; pp.coupled() && i < pp.size(); ++i)
        {
            isBetween_[pp.start() + i] = true;
        }
    }
    for (materialPointPhase& phase : points.phases())
    {
        phase.cloud().needGas();
    }
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::solidFraction>
Foam::mpm::solidFraction::New(materialPointSystem& points, const dictionary& gasDict)
{
    const word name(oneOfOrDefault(
        gasDict, "solidFraction", points.grid().noLattice().empty() ? "lattice" : "star",
        dictionaryConstructorTablePtr_->sortedToc()));
    Info << "Points in gas: solidFraction " << name << nl << endl;
    return dictionaryConstructorTablePtr_->cfind(name).val()(points, gasDict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::solidFraction::show(solidOnFaces& pores) const
{
    pores.thetaS0 = thetaS0_.cdata();
    pores.thetaS = thetaS_.cdata();
    pores.phiS = phiS_.cdata();
    pores.uS = uS_.cdata();
    pores.rhoS = rhoS_.cdata();
    pores.dragLimit = dragLimit_.cdata();
    pores.dilation = dilation_.cdata();
    pores.eps = eps_;
}

Foam::scalar Foam::mpm::solidFraction::divergence(const label phasei, const label celli) const
{
    const velocityField& field = points_.fields()[points_.fieldOf(phasei)];
    return points_.grid().divergence(celli, field.U(), field.stride());
}

void Foam::mpm::solidFraction::keepOwn(const label phasei)
{
    own_[phasei].setSize(mesh_.nCells(), 0);
}

void Foam::mpm::solidFraction::keepVolumes()
{
    forAll(points_.phases(), phasei)
    {
        materialPointCloud& cloud = points_.phases()[phasei].cloud();
        const scalar* v = (*cloud.gasVolume())[0];
        oldVolume_[phasei].setSize(cloud.size() + column::padding);
        std::copy(v, v + cloud.size(), oldVolume_[phasei].begin());
    }
}
