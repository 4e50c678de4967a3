/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"
#include "dictionaryTools.H"
#include "coupledPolyPatch.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- h max(-div u, 0) of a cell from its corners [m/s], h its shortest side; on
//  a wedge div u of the plane
scalar velocityLoss
(
    const pointGrid& grid,
    const label celli,
    const scalar* U,
    const int stride
)
{
    return
        grid.shortestSide(celli)
       *max(-grid.divergence(celli, U, stride), scalar(0));
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gasCoupling::readGranular
(
    const label phasei,
    const dictionary& dict
)
{
    if (!dict.found("granularPressure"))
    {
        return;
    }
    granular_.set
    (
        phasei,
        granularPressure::New(requiredDict(dict, "granularPressure")).ptr()
    );
    grainFace_[phasei].setSize(face_.size(), scalar(0));
    grainCell_[phasei].setSize(cell_.size(), scalar(0));
    pGrains_.setSize(mesh_.nCells());

    // The stiffest packing sets the time step from the start: a step may
    // close a bed
    const scalar c = std::sqrt
    (
        granular_[phasei].slope(1)/points_.phases()[phasei].rho()
    );
    scalar rate = 0;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        for (int d = 0; d < sums_.grid().nDim(); ++d)
        {
            rate = max(rate, c/sums_.grid().width(celli, d));
        }
    }
    waveRate_ = max(waveRate_, returnReduce(rate, maxOp<scalar>()));
}


const Foam::scalarList& Foam::mpm::gasCoupling::grainJumps(const label phasei)
{
    const granularPressure& law = granular_[phasei];
    const scalarList& face = grainFace_[phasei];
    const scalarList& cell = grainCell_[phasei];
    const int D = sums_.grid().nDim();

    forAll(pGrains_, c)
    {
        const label at = pointKernels::cellStride*sums_.place(c);
        pGrains_[c] = law.p(cell[at + pointKernels::fraction]/mesh_.V()[c]);
    }

    // Nodes of cells with points have a velocity
    const pointGrid& grid = sums_.grid();
    const velocityField& field = points_.fields()[points_.fieldOf(phasei)];
    const scalar rho = points_.phases()[phasei].rho();
    for (const label c : points_.phases()[phasei].cloud().cells())
    {
        if (pGrains_[c] > 0)
        {
            const label at = pointKernels::cellStride*sums_.place(c);
            pGrains_[c] += law.q
            (
                cell[at + pointKernels::fraction]/mesh_.V()[c],
                rho,
                velocityLoss(grid, c, field.U(), field.stride())
            );
        }
    }
    scalarField behind(mesh_.nFaces() - mesh_.nInternalFaces());
    forAll(behind, i)
    {
        behind[i] = pGrains_[mesh_.faceOwner()[mesh_.nInternalFaces() + i]];
    }
    syncTools::swapBoundaryFaceList(mesh_, behind);

    GGrains_.setSize(G_.size());
    GGrains_ = 0;
    const auto jump = [&](const label f, const scalar pO, const scalar pN)
    {
        const label at = sums_.nPlaces()*sums_.direction(f) + sums_.facePlace(f);
        const scalar v = face[pointKernels::faceStride*at + pointKernels::volume];
        if (v > 0 && pO != pN)
        {
            // V/h is the area; v holds V K_f
            GGrains_[at] =
                sums_.sign(f)*(pN - pO)*mag(mesh_.faceAreas()[f])/v;
        }
    };
    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        jump(f, pGrains_[mesh_.faceOwner()[f]], pGrains_[mesh_.faceNeighbour()[f]]);
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        forAll(pp, i)
        {
            const label f = pp.start() + i;
            if (isA<coupledPolyPatch>(pp) && sums_.sign(f) < 0)
            {
                jump
                (
                    f,
                    pGrains_[mesh_.faceOwner()[f]],
                    behind[f - mesh_.nInternalFaces()]
                );
            }
        }
    }
    for (int d = 0; d < D; ++d)
    {
        sums_.sum(GGrains_.data() + sums_.nPlaces()*d, 1);
    }
    forAll(GGrains_, i)
    {
        GGrains_[i] += G_[i];
    }
    return GGrains_;
}

// ************************************************************************* //
