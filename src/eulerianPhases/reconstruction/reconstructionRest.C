/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "reconstruction.H"
#include "limitedGradients.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::reconstruction::measureRest(const vector& g)
{
    // That of g.x, as p of a fluid of density 1
    const label nInternal = mesh_.nInternalFaces();
    const vectorField& S = mesh_.faceAreas();
    const vectorField& C = mesh_.cellCentres();
    List<gasState> cells(mesh_.nCells()), behind(swap_.size());
    forAll(cells, c)
    {
        cells[c] = gasState{1, Zero, g & C[c]};
    }
    forAll(behind, i)
    {
        const label f = nInternal + i;
        const vector n(S[f]/mag(S[f]));
        behind[i] = cells[mesh_.faceOwner()[f]];
        foot_[i] =
            (g & n)*(n & (mesh_.faceCentres()[f] - C[mesh_.faceOwner()[f]]));
    }
    coupled_.swap(behind);
    for (const label f : boundary_)
    {
        behind[f - nInternal].p += foot_[f - nInternal];
    }
    slopes_->update(cells, behind);
    rest_.setSize(cells.size());
    forAll(rest_, c)
    {
        for (int i = 0; i < 3; ++i)
        {
            rest_[c][i] = slopes_->slope(c, i)[4];
        }
    }
}


void Foam::mpm::reconstruction::slopesAboveRest(const phase& of)
{
    if (rest_.empty())
    {
        foot_.setSize(of.Wb.size(), 0);
        measureRest(of.g);
    }
    const label nInternal = mesh_.nInternalFaces();
    restBehind_ = of.Wb;
    for (const label f : boundary_)
    {
        const label c = mesh_.faceOwner()[f];
        gasState& w = restBehind_[f - nInternal];
        if (w.p == of.W[c].p)
        {
            w.p += of.W[c].rho*foot_[f - nInternal];
        }
    }
    slopes_->update(of.W, restBehind_);
    forAll(of.W, c)
    {
        slopes_->atRest(c, of.W[c].rho*rest_[c]);
    }
}

// ************************************************************************* //
