/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "viscousFlux.H"
#include "leastSquaresGrad.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- theta of cells whose inertia limits the flux in place of the step
constexpr scalar thin = 0.1;

//- Of two layers in a row
scalar inRow(const scalar a, const scalar da, const scalar b, const scalar db)
{
    return a > 0 && b > 0 ? (da + db)/(da/a + db/b) : 0;
}

//- Gradients of the cells by Gauss' theorem, with those behind faces
template<class Type>
auto gradient(const GeometricField<Type, fvPatchField, volMesh>& field)
{
    return fv::leastSquaresGrad<Type>(field.mesh()).grad(field, "grad");
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::viscousFlux::viscousFlux
(
    const fvMesh& mesh,
    const gasFaces& faces,
    const coupledFaces& coupled
)
:
    faces_(faces),
    coupled_(coupled),
    along_(mesh.nInternalFaces()),
    alongB_(mesh.nFaces() - mesh.nInternalFaces(), 0),
    ownWidth_(along_.size()),
    neiWidth_(along_.size()),
    ownWidthB_(alongB_.size(), 0),
    neiWidthB_(alongB_.size(), 0),
    deltaB_(alongB_.size(), Zero),
    sum_(mesh.nCells(), 0),
    sumT_(mesh.nCells(), 0),
    mu(mesh.nCells(), 0),
    kappa(mesh.nCells(), 0)
{
    const vectorField& S = mesh.faceAreas();
    const vectorField& C = mesh.cellCentres();
    const vectorField& Cf = mesh.faceCentres();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const label nInternal = mesh.nInternalFaces();
    const auto normal = [&](const label f) { return S[f]/faces.magS[f]; };
    forAll(along_, f)
    {
        const vector n(normal(f));
        along_[f] = faces.magS[f]/(n & (C[nei[f]] - C[own[f]]));
        ownWidth_[f] = mag(n & (Cf[f] - C[own[f]]));
        neiWidth_[f] = mag(n & (C[nei[f]] - Cf[f]));
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        const polyPatch& pp = patch.patch();
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }
        const vectorField delta(patch.delta());
        forAll(delta, i)
        {
            const label f = pp.start() + i, b = f - nInternal;
            const vector n(normal(f));
            deltaB_[b] = delta[i];
            alongB_[b] = faces.magS[f]/(n & delta[i]);
            ownWidthB_[b] = mag(n & (Cf[f] - C[own[f]]));
            neiWidthB_[b] = max((n & delta[i]) - ownWidthB_[b], scalar(0));
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::mpm::viscousFlux::behindFaces
(
    const volScalarField* T,
    const scalarField& theta,
    const scalarField& rho
) const
{
    const fvMesh& mesh = faces_.mesh;
    const label nInternal = mesh.nInternalFaces();
    scalarField other(width*alongB_.size(), 0);
    for (const label f : faces_.coupled)
    {
        const label b = f - nInternal, P = mesh.faceOwner()[f];
        scalar* to = other.begin() + width*b;
        to[0] = mu[P];
        to[1] = kappa[P];
        to[2] = T ? (*T)[P] : 0;
        to[3] = ownWidthB_[b];
        to[4] = theta[P];
        to[5] = rho[P]*mesh.V()[P];
    }
    if (!coupled_.empty())
    {
        coupled_.swap(other, width);
    }
    return other;
}


Foam::scalar Foam::mpm::viscousFlux::rate
(
    const scalarField& theta,
    const scalarField& rho,
    const scalarField& rhoCv
) const
{
    const fvMesh& mesh = faces_.mesh;
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const label nInternal = mesh.nInternalFaces();
    sum_ = 0;
    sumT_ = 0;
    const auto give = [&](const label c, const scalar a, const scalar m, const scalar k)
    {
        sum_[c] += a*m;
        sumT_[c] += a*k;
    };
    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        const scalar a = max(theta[P], theta[N])*along_[f];
        const scalar dP = ownWidth_[f], dN = neiWidth_[f];
        const scalar m = inRow(mu[P], dP, mu[N], dN);
        const scalar k = inRow(kappa[P], dP, kappa[N], dN);
        give(P, a, m, k);
        give(N, a, m, k);
    }
    const scalarField other(behindFaces(nullptr, theta, rho));
    for (const label f : faces_.coupled)
    {
        const label P = own[f], b = f - nInternal;
        const scalar* o = other.cdata() + width*b;
        const scalar dP = ownWidthB_[b];
        give
        (
            P, max(theta[P], o[4])*alongB_[b], inRow(mu[P], dP, o[0], o[3]),
            inRow(kappa[P], dP, o[1], o[3])
        );
    }
    for (const label f : faces_.boundary)
    {
        const label P = own[f];
        give(P, alongB_[f - nInternal], mu[P], kappa[P]);
    }
    scalar most = 0;
    forAll(rho, c)
    {
        if (theta[c] > thin)
        {
            most = max(most, 4*sum_[c]/(3*rho[c]*mesh.V()[c]));
            if (sumT_[c] > 0)
            {
                most = max(most, sumT_[c]/(rhoCv[c]*mesh.V()[c]));
            }
        }
    }
    return returnReduce(most, maxOp<scalar>());
}


void Foam::mpm::viscousFlux::add
(
    const scalar dt,
    const volVectorField& U,
    const UList<gasState>& behind,
    const volScalarField* T,
    const scalarField& theta,
    const scalarField& rho,
    result& to
) const
{
    const fvMesh& mesh = U.mesh();
    const vectorField& S = mesh.faceAreas();
    const vectorField& C = mesh.cellCentres();
    const scalarField& V = mesh.V();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const label nInternal = mesh.nInternalFaces();
    const bool heat = T && to.rhoE.size() && max(kappa) > 0;

    const tmp<volTensorField> tG(gradient(U));
    const volTensorField& G = tG();
    tmp<volVectorField> tGT;
    if (returnReduce(heat, orOp<bool>()))
    {
        tGT = gradient(*T);
    }

    // What a face takes into its owner
    vector force;
    scalar power;
    const auto between = [&]
    (
        const label f,
        const scalar along,
        const vector& delta,
        const scalar dP,
        const scalar dN,
        const scalar muN,
        const vector& uN,
        const tensor& GN,
        const scalar kappaN,
        const scalar TN,
        const vector& GTN,
        const scalar thetaN,
        const scalar massN
    )
    {
        const label P = own[f];
        const scalar muP = mu[P], w = dN/(dP + dN);
        const scalar m = inRow(muP, dP, muN, dN);
        scalar share = max(theta[P], thetaN);
        if (min(theta[P], thetaN) < thin && m > 0)
        {
            share = min
            (
                share, 0.25*min(rho[P]*V[P], massN)/(m*along*dt)
            );
        }
        const tensor g(w*G[P] + (1 - w)*GN);
        const vector skew(S[f] - along*delta);
        const vector uP(U[P]);
        force =
            share*m
           *(
                along*(uN - uP) + (skew & g) + (g & S[f])
              - 2.0/3.0*tr(g)*S[f]
            );
        const scalar a = muP/dP, b = muN/dN;
        power = a + b > 0 ? force & ((a*uP + b*uN)/(a + b)) : 0;
        if (heat)
        {
            power +=
                share*inRow(kappa[P], dP, kappaN, dN)
               *(
                    along*(TN - (*T)[P])
                  + (skew & (w*tGT()[P] + (1 - w)*GTN))
                );
        }
    };
    const auto give = [&](const label c, const scalar sign)
    {
        to.rhoU[c] += sign*dt/V[c]*force;
        if (to.rhoE.size())
        {
            to.rhoE[c] += sign*dt/V[c]*power;
        }
    };
    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        between
        (
            f, along_[f], C[N] - C[P], ownWidth_[f], neiWidth_[f],
            mu[N], U[N], G[N], kappa[N], heat ? (*T)[N] : 0,
            heat ? tGT()[N] : vector(Zero), theta[N], rho[N]*V[N]
        );
        give(P, 1);
        give(N, -1);
    }

    // Across processors and cyclic sides, then the other boundary
    const scalarField other(behindFaces(T, theta, rho));
    forAll(mesh.boundary(), patchi)
    {
        const polyPatch& pp = mesh.boundaryMesh()[patchi];
        const fvPatchVectorField& Ub = U.boundaryField()[patchi];
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }
        if (pp.coupled())
        {
            const tensorField GN(G.boundaryField()[patchi].patchNeighbourField());
            vectorField GTN(pp.size(), Zero);
            if (heat)
            {
                GTN = tGT().boundaryField()[patchi].patchNeighbourField();
            }
            forAll(pp, i)
            {
                const label f = pp.start() + i, b = f - nInternal;
                const scalar* o = other.cdata() + width*b;
                between
                (
                    f, alongB_[b], deltaB_[b], ownWidthB_[b], o[3], o[0],
                    behind[b].u, GN[i], o[1], o[2], GTN[i], o[4], o[5]
                );
                give(own[f], 1);
            }
            continue;
        }
        const vectorField slope(Ub.snGrad());
        scalarField slopeT(pp.size(), 0);
        if (heat)
        {
            slopeT = T->boundaryField()[patchi].snGrad();
        }
        const bool wedge = isA<wedgePolyPatch>(pp);
        forAll(pp, i)
        {
            const label f = pp.start() + i, P = own[f];
            force =
                theta[P]*mu[P]
               *(
                    faces_.magS[f]*slope[i] + (G[P] & S[f])
                  - 2.0/3.0*tr(G[P])*S[f]
                );
            power = wedge ? 0 : force & Ub[i];
            if (heat)
            {
                power += theta[P]*kappa[P]*faces_.magS[f]*slopeT[i];
            }
            give(P, 1);
            if (!wedge)
            {
                to.impulse += dt*force;
                to.energy += dt*power;
            }
        }
    }
}

// ************************************************************************* //
