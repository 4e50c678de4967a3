// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pressureOverSteps.H"
#include "largestOfAll.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pressureOverSteps::update()
{
    bool any = false;
    for (const scalar C : later_)
    {
        any = any || C != 0;
    }
    acts_ = onAny(any);
    const label nInternal = mesh_.nInternalFaces();
    forAll(behind_, i)
    {
        behind_[i] = later_[mesh_.faceOwner()[nInternal + i]];
    }
    if (acts_)
    {
        coupled_.swap(behind_);
    }
}

void Foam::mpm::pressureOverSteps::rate(
    const solidOnFaces& pores, const scalar dt, scalarField& W) const
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    W = 0;
    for (label f = 0; f < mesh_.nFaces(); ++f)
    {
        W[own[f]] += pores.phiS[f];
        if (f < nei.size())
        {
            W[nei[f]] -= pores.phiS[f];
        }
    }
    forAll(W, c)
    {
        W[c] = W[c] / mesh_.V()[c] - pores.dilation[c] / dt;
    }
}

void Foam::mpm::pressureOverSteps::share(const solidOnFaces& pores, vectorField& B) const
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    B = Zero;
    for (label f = 0; f < mesh_.nFaces(); ++f)
    {
        if (!pores.at(f))
        {
            continue;
        }
        const label P = own[f], i = f - nei.size();
        const scalar jump = (i < 0 ? later_[nei[f]] : behind_[i]) - later_[P];
        vector A(pores.thetaS0[f] * S[f]);
        if (pores.area0)
        {
            A += pores.area0[f];
        }
        const vector half((-0.5 * jump) * A);
        B[P] += half;
        if (i < 0)
        {
            B[nei[f]] += half;
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pressureOverSteps::pressureOverSteps(const fvMesh& mesh) :
    mesh_(mesh),
    coupled_(mesh),
    later_(mesh.nCells(), 0),
    behind_(mesh.nFaces() - mesh.nInternalFaces(), 0),
    sum_(mesh.nCells(), 0),
    owed_(mesh.nCells(), Zero),
    way_(mesh.nCells(), 0),
    acts_(false)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pressureOverSteps::addTo(
    const scalar dt, scalarField& p, scalarField& pBehind) const
{
    forAll(p, c)
    {
        p[c] += later_[c] / dt;
    }
    forAll(pBehind, i)
    {
        pBehind[i] += behind_[i] / dt;
    }
}

void Foam::mpm::pressureOverSteps::begin(const UList<gasState>& states)
{
    first_.setSize(states.size());
    forAll(first_, c)
    {
        first_[c] = states[c].p;
    }
}

void Foam::mpm::pressureOverSteps::add(const UList<scalar>& p, const scalar dt)
{
    forAll(sum_, c)
    {
        sum_[c] += dt * (p[c] - first_[c]);
    }
}

void Foam::mpm::pressureOverSteps::add(const UList<scalar>& sum)
{
    forAll(sum_, c)
    {
        sum_[c] += sum[c];
    }
}

void Foam::mpm::pressureOverSteps::finish(
    const solidOnFaces& pores, const scalar dt, vectorField& rest, scalarField& energy)
{
    // Of what was owed, what the step gave
    vectorField given(owed_.size(), Zero);
    share(pores, given);
    rest = owed_ - given;

    scalarField W(mesh_.nCells());
    rate(pores, dt, W);
    energy = way_ - later_ * W;
    way_ = sum_ * W;

    later_ = sum_;
    sum_ = 0;
    update();
    share(pores, owed_);
}
