/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"
#include "selector.H"
#include "coupledPolyPatch.H"
#include "syncTools.H"

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
        new granularPressure(requiredDict(dict, "granularPressure"))
    );
    grainFace_[phasei].setSize(face_.size(), scalar(0));
    grainCell_[phasei].setSize(cell_.size(), scalar(0));
    pGrains_.setSize(mesh_.nCells());
}


void Foam::mpm::gasCoupling::updateWaveRate()
{
    // c^2 = (dp_s/da)/rho of the fastest cell
    scalar rate = 0;
    bool some = false;
    forAll(granular_, phasei)
    {
        if (!granular_.set(phasei))
        {
            continue;
        }
        some = true;
        const scalarList& cell = grainCell_[phasei];
        const scalar rho = points_.phases()[phasei].rho();
        forAll(pGrains_, c)
        {
            const label at = pointKernels::cellStride*sums_.place(c);
            const scalar slope = granular_[phasei].slope
            (
                cell[at + pointKernels::fraction]/mesh_.V()[c]
            );
            if (slope > 0)
            {
                scalar h = GREAT;
                for (int d = 0; d < sums_.grid().nDim(); ++d)
                {
                    h = min(h, sums_.grid().width(c, d));
                }
                rate = max(rate, std::sqrt(slope/rho)/h);
            }
        }
    }
    waveRate_ = some ? returnReduce(rate, maxOp<scalar>()) : 0;
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
