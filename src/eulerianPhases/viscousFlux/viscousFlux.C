// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "viscousFlux.H"
#include "largestOfAll.H"
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
    return a > 0 && b > 0 ? (da + db) / (da / a + db / b) : 0;
}

//- Gradients of the cells by Gauss' theorem, with those behind faces
template<class Type>
auto gradient(const GeometricField<Type, fvPatchField, volMesh>& field)
{
    return fv::leastSquaresGrad<Type>(field.mesh()).grad(field, "grad");
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::viscousFlux::viscousFlux(
    const fvMesh& mesh, const gasFaces& faces, const coupledFaces& coupled) :
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
    const auto normal = [&](const label f) { return S[f] / faces.magS[f]; };
    forAll(along_, f)
    {
        const vector n(normal(f));
        along_[f] = faces.magS[f] / (n & (C[nei[f]] - C[own[f]]));
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
            alongB_[b] = faces.magS[f] / (n & delta[i]);
            ownWidthB_[b] = mag(n & (Cf[f] - C[own[f]]));
            neiWidthB_[b] = max((n & delta[i]) - ownWidthB_[b], scalar(0));
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::mpm::viscousFlux::behindFaces(
    const volScalarField* T, const scalarField& theta, const scalarField& rho) const
{
    const fvMesh& mesh = faces_.mesh;
    const label nInternal = mesh.nInternalFaces();
    scalarField other(width * alongB_.size(), 0);
    for (const label f : faces_.coupled)
    {
        const label b = f - nInternal, P = mesh.faceOwner()[f];
        scalar* to = other.begin() + width * b;
        to[0] = mu[P];
        to[1] = kappa[P];
        to[2] = T ? (*T)[P] : 0;
        to[3] = ownWidthB_[b];
        to[4] = theta[P];
        to[5] = rho[P] * mesh.V()[P];
    }
    if (!coupled_.empty())
    {
        coupled_.swap(other, width);
    }
    return other;
}

Foam::scalar Foam::mpm::viscousFlux::rate(
    const scalarField& theta, const scalarField& rho, const scalarField& rhoCv) const
{
    const fvMesh& mesh = faces_.mesh;
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const label nInternal = mesh.nInternalFaces();
    sum_ = 0;
    sumT_ = 0;
    const auto give = [&](const label c, const scalar a, const scalar m, const scalar k)
    {
        sum_[c] += a * m;
        sumT_[c] += a * k;
    };
    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        const scalar a = max(theta[P], theta[N]) * along_[f];
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
        const scalar* o = other.cdata() + width * b;
        const scalar dP = ownWidthB_[b];
        give(
            P, max(theta[P], o[4]) * alongB_[b], inRow(mu[P], dP, o[0], o[3]),
            inRow(kappa[P], dP, o[1], o[3]));
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
            most = max(most, 4 * sum_[c] / (3 * rho[c] * mesh.V()[c]));
            if (sumT_[c] > 0)
            {
                most = max(most, sumT_[c] / (rhoCv[c] * mesh.V()[c]));
            }
        }
    }
    return largestOfAll(most);
}

Foam::mpm::viscousFlux::exchange Foam::mpm::viscousFlux::between(
    const scalar dt, const vector& S, const scalar along, const vector& delta, const side& P,
    const side& N)
{
    const scalar m = inRow(P.mu, P.width, N.mu, N.width);
    scalar share = max(P.theta, N.theta);
    if (min(P.theta, N.theta) < thin && m > 0)
    {
        share = min(share, 0.25 * min(P.mass, N.mass) / (m * along * dt));
    }
    const scalar w = N.width / (P.width + N.width);
    const tensor g(w * P.G + (1 - w) * N.G);
    const vector skew(S - along * delta);
    exchange x;
    x.force = share * m * (along * (N.u - P.u) + (skew & g) + (g & S) - 2.0 / 3.0 * tr(g) * S);
    const scalar a = P.mu / P.width, b = N.mu / N.width;
    x.power = share * inRow(P.kappa, P.width, N.kappa, N.width)
        * (along * (N.T - P.T) + (skew & (w * P.GT + (1 - w) * N.GT)));
    if (a + b > 0)
    {
        x.power += x.force & ((a * P.u + b * N.u) / (a + b));
    }
    return x;
}

Foam::mpm::viscousFlux::side
Foam::mpm::viscousFlux::of(const flow& now, const label c, const scalar width) const
{
    return {mu[c],    kappa[c],     now.T ? (*now.T)[c] : 0,
            width,    now.theta[c], now.rho[c] * faces_.mesh.V()[c],
            now.U[c], now.G[c],     now.GT ? (*now.GT)[c] : vector(Zero)};
}

void Foam::mpm::viscousFlux::give(const scalar h, const label c, const exchange& x, result& to)
{
    to.rhoU[c] += h * x.force;
    if (to.rhoE.size())
    {
        to.rhoE[c] += h * x.power;
    }
}

void Foam::mpm::viscousFlux::addBoundary(
    const scalar dt, const label patchi, const flow& now, result& to) const
{
    const fvMesh& mesh = faces_.mesh;
    const vectorField& S = mesh.faceAreas();
    const polyPatch& pp = mesh.boundaryMesh()[patchi];
    const fvPatchVectorField& Ub = now.U.boundaryField()[patchi];
    const vectorField slope(Ub.snGrad());
    scalarField slopeT(pp.size(), 0);
    if (now.T)
    {
        slopeT = now.T->boundaryField()[patchi].snGrad();
    }
    const bool wedge = isA<wedgePolyPatch>(pp);
    forAll(pp, i)
    {
        const label f = pp.start() + i, P = mesh.faceOwner()[f];
        const tensor& G = now.G[P];
        exchange x;
        x.force = now.theta[P] * mu[P]
            * (faces_.magS[f] * slope[i] + (G & S[f]) - 2.0 / 3.0 * tr(G) * S[f]);
        x.power =
            (wedge ? 0 : x.force & Ub[i]) + now.theta[P] * kappa[P] * faces_.magS[f] * slopeT[i];
        give(dt / mesh.V()[P], P, x, to);
        if (!wedge)
        {
            to.impulse += dt * x.force;
            to.energy += dt * x.power;
        }
    }
}

void Foam::mpm::viscousFlux::add(
    const scalar dt, const volVectorField& U, const UList<gasState>& behind,
    const volScalarField* T, const scalarField& theta, const scalarField& rho, result& to) const
{
    const fvMesh& mesh = faces_.mesh;
    const vectorField& S = mesh.faceAreas();
    const vectorField& C = mesh.cellCentres();
    const scalarField& V = mesh.V();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const label nInternal = mesh.nInternalFaces();
    const bool heat = onAny(T && to.rhoE.size() && max(kappa) > 0);
    const tmp<volTensorField> tG(gradient(U));
    tmp<volVectorField> tGT;
    if (heat)
    {
        tGT = gradient(*T);
    }
    const flow now{U, tG(), heat ? T : nullptr, heat ? &tGT() : nullptr, theta, rho};
    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        const exchange x = between(
            dt, S[f], along_[f], C[N] - C[P], of(now, P, ownWidth_[f]), of(now, N, neiWidth_[f]));
        give(dt / V[P], P, x, to);
        give(-dt / V[N], N, x, to);
    }

    // Across processors and cyclic sides, then the other boundary
    const scalarField other(behindFaces(now.T, theta, rho));
    forAll(mesh.boundary(), patchi)
    {
        const polyPatch& pp = mesh.boundaryMesh()[patchi];
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }
        if (!pp.coupled())
        {
            addBoundary(dt, patchi, now, to);
            continue;
        }
        const tensorField GN(now.G.boundaryField()[patchi].patchNeighbourField());
        vectorField GTN(pp.size(), Zero);
        if (heat)
        {
            GTN = now.GT->boundaryField()[patchi].patchNeighbourField();
        }
        forAll(pp, i)
        {
            const label f = pp.start() + i, b = f - nInternal, P = own[f];
            const scalar* o = other.cdata() + width * b;
            const exchange x = between(
                dt, S[f], alongB_[b], deltaB_[b], of(now, P, ownWidthB_[b]),
                {o[0], o[1], o[2], o[3], o[4], o[5], behind[b].u, GN[i], GTN[i]});
            give(dt / V[P], P, x, to);
        }
    }
}
