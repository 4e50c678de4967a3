/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "reconstruction.H"
#include "leastSquaresVectors.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::reconstruction::measureSkew()
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const labelUList& own = mesh_.faceOwner();

    skew_.setSize(mesh_.nFaces(), Zero);
    scalar most = 0;
    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        const vector& P = C[own[f]];
        const vector d(C[mesh_.faceNeighbour()[f]] - P);
        skew_[f] = Cf[f] - P - (1 - mesh_.weights()[f])*d;
        most = max(most, mag(skew_[f])/mag(d));
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (patch.coupled())
        {
            const vectorField delta(patch.delta());
            forAll(delta, i)
            {
                const label f = patch.start() + i;
                const vector& d = delta[i];
                skew_[f] =
                    Cf[f] - C[own[f]] - (1 - patch.weights()[i])*d;
                most = max(most, mag(skew_[f])/mag(d));
            }
        }
    }
    if (returnReduce(most, maxOp<scalar>()) < 1e-6)
    {
        skew_.clear();
    }
}


void Foam::mpm::reconstruction::leastSquares
(
    const UList<gasState>& W,
    const UList<gasState>& Wb
)
{
    const leastSquaresVectors& vectors = leastSquaresVectors::New(mesh_);
    const surfaceVectorField& v = vectors.pVectors();
    const surfaceVectorField& vN = vectors.nVectors();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    grad_ = gradients{Zero, Zero, Zero};
    const auto add = [&]
    (
        const label c,
        const gasState& N,
        const vector& v
    )
    {
        const gasState& P = W[c];
        gradients& g = grad_[c];
        g.rho += (N.rho - P.rho)*v;
        g.p += (N.p - P.p)*v;
        g.u += v*(N.u - P.u);
    };
    for (label f = 0; f < nInternal; ++f)
    {
        add(own[f], W[nei[f]], v[f]);
        add(nei[f], W[own[f]], vN[f]);
    }
    for (const labelList* list : {&boundary_, &coupledList_})
    {
        for (const label f : *list)
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(f);
            add
            (
                own[f],
                Wb[f - nInternal],
                v.boundaryField()[patchi]
                [f - mesh_.boundaryMesh()[patchi].start()]
            );
        }
    }
}


void Foam::mpm::reconstruction::addSkew
(
    const UList<gasState>& W,
    const UList<gasState>& Wb
)
{
    const scalarField& w = mesh_.weights();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    // The limiter is the way from P on the line over that without it
    const auto part = [](const scalar to, const scalar whole)
    {
        return
            mag(whole) > VSMALL
          ? max(scalar(0), min(to/whole, scalar(1)))
          : 0;
    };
    const auto shift = [&]
    (
        gasState& s,
        const gasState& P,
        const gasState& N,
        const gradients& g,
        const scalar v,
        const vector& d
    )
    {
        s.rho += part(s.rho - P.rho, v*(N.rho - P.rho))*(d & g.rho);
        s.p += part(s.p - P.p, v*(N.p - P.p))*(d & g.p);
        const vector du(N.u - P.u);
        s.u += part((s.u - P.u) & du, v*magSqr(du))*(d & g.u);
    };

    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        shift(faces_[f].own, W[P], W[N], grad_[P], 1 - w[f], skew_[f]);
        shift(faces_[f].nei, W[N], W[P], grad_[N], w[f], skew_[f]);
    }
    for (const label f : coupledList_)
    {
        const label patchi = mesh_.boundaryMesh().whichPatch(f);
        const label i = f - mesh_.boundaryMesh()[patchi].start();
        shift
        (
            faces_[f].own, W[own[f]], Wb[f - nInternal], grad_[own[f]],
            1 - mesh_.boundary()[patchi].weights()[i], skew_[f]
        );
    }
}

// ************************************************************************* //
