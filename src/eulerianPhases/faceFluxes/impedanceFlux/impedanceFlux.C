// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "impedanceFlux.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(impedanceFlux, 0);
addToRunTimeSelectionTable(faceFlux, impedanceFlux, dictionary);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<bool Porous, bool General, bool Vector>
void Foam::mpm::impedanceFlux::insideFaces(
    const gasStates<General>& states, const besideSolid* solid, const result& to) const
{
    typedef typename gasStates<General>::state state;
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells();
    const label nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vector* const S = mesh.faceAreas().cdata();
    const scalarField& V = mesh.V();
    const bool upwind = states.upwind();
    const scalar factor = states.factor();
    scalar* const phi = to.phi.data();
    scalar* const pStar = to.pStar.data();
    scalar* const out = to.out.data();

    // Faces next to solid: by lanes where areas are numbers
    typedef lanes<registerLanes> T;
    constexpr int W = registerLanes;
    union block
    {
        porousState<T> t;
        scalar at[7][W];
    };
    union areas
    {
        porousArea<T> t;
        scalar at[8][W];
    };
    block left, right;
    areas area;
    label group[W];
    int nGroup = 0;
    const auto flush = [&](const int n)
    {
        // Empty lanes repeat the last face
        for (int l = n; l < W; ++l)
        {
            for (int i = 0; i < 7; ++i)
            {
                left.at[i][l] = left.at[i][n - 1];
                right.at[i][l] = right.at[i][n - 1];
            }
            for (int i = 0; i < 8; ++i)
            {
                area.at[i][l] = area.at[i][n - 1];
            }
        }
        const solidOnFaces& pores = solid->pores;
        const porousResult<T> r(beside(
            left.t, right.t, area.t, solid->dt, 0, 1, pores.K ? pores.fd : solidOnFaces::none));
        const T flow = r.theta * r.u * area.t.magS;
        for (int l = 0; l < n; ++l)
        {
            const label f = group[l];
            phi[f] = flow[l];
            pStar[f] = r.pStar[l];
            out[own[f]] += max(phi[f], scalar(0));
            out[nei[f]] -= min(phi[f], scalar(0));
        }
        nGroup = 0;
    };
    const auto gather = [&](const label f)
    {
        const label P = own[f], N = nei[f];
        const state L(states.cell(P)), R(states.cell(N));
        const scalar KL = factor * states.q(L), KR = factor * states.q(R);
        const scalar z = std::sqrt(max(L.w.rho * KL, R.w.rho * KR));
        const int l = nGroup++;
        const auto put = [&](block& b, const state& s, const scalar K, const label c)
        {
            b.at[0][l] = s.w.rho;
            b.at[1][l] = (s.w.u & S[f]) * faces_.invMagS[f];
            b.at[2][l] = K;
            b.at[3][l] = z;
            b.at[4][l] = s.w.p;
            b.at[5][l] = solid->theta[c];
            b.at[6][l] = V[c];
        };
        put(left, L, KL, P);
        put(right, R, KR, N);
        const porousArea<scalar> a(areaOf<false>(f, solid->pores));
        const scalar* from = &a.magS;
        for (int i = 0; i < 8; ++i)
        {
            area.at[i][l] = from[i];
        }
        group[l] = f;
        if (nGroup == W)
        {
            flush(W);
        }
    };
    const auto porous =
        [&](const label f, const state& L, const state& R, const scalar thetaR, const scalar VR)
    {
        const scalar qL = states.q(L), qR = states.q(R);
        const scalar z = std::sqrt(factor * max(L.w.rho * qL, R.w.rho * qR));
        const label P = own[f];
        porousFace<Vector>(
            f, {L.w, factor * qL, z, L.w.p, solid->theta[P], V[P]},
            {R.w, factor * qR, z, R.w.p, thetaR, VR}, solid->dt, solid->pores, 0, 1, to);
    };

    // Face between two states: Z = z/|S|
    const auto between = [&](const label f, const state& L, const state& R, const scalar Z)
    {
        const scalar uL = L.w.u & S[f], uR = R.w.u & S[f];
        phi[f] = 0.5 * (uL + uR + (L.w.p - R.w.p) / Z);
        pStar[f] = 0.5 * (L.w.p + R.w.p + Z * (uL - uR));
    };
    const auto open = [&](const label f, const state& L, const state& R)
    {
        const scalar z2 = max(L.w.rho * states.q(L), R.w.rho * states.q(R));
        between(f, L, R, std::sqrt(factor * z2) * faces_.invMagS[f]);
    };

    // A root per cell, not per face
    scalar* const z = z_.data();
    if (upwind)
    {
        const auto set = [&](const label c)
        {
            const state L(states.cell(c));
            z[c] = std::sqrt(factor * L.w.rho * states.q(L));
        };
        if (zOfAll_ && !faces_.region.all())
        {
            faces_.region.forCells(set);
        }
        else
        {
            for (label c = 0; c < nCells; ++c)
            {
                set(c);
            }
        }
        zOfAll_ = !faces_.region.all();
    }

    faces_.region.forFaces(
        [&](const label f)
        {
            const label P = own[f], N = nei[f];
            if (Porous && (solid->near[P] || solid->near[N]))
            {
                if (!Vector)
                {
                    gather(f);
                    return;
                }
                porous(f, states.cell(P), states.cell(N), solid->theta[N], V[N]);
            }
            else if (upwind)
            {
                between(f, states.cell(P), states.cell(N), max(z[P], z[N]) * faces_.invMagS[f]);
            }
            else
            {
                open(f, states.own(f), states.nei(f));
            }
            out[P] += max(phi[f], scalar(0));
            out[N] -= min(phi[f], scalar(0));
        });

    if (nGroup)
    {
        flush(nGroup);
    }

    for (const label f : faces_.coupled)
    {
        const label P = own[f], i = f - nInternal;
        if (Porous && (solid->near[P] || solid->near[nCells + i]))
        {
            porous(f, states.cell(P), states.behind(i), solid->thetaB[i], faces_.Vb[i]);
        }
        else if (upwind)
        {
            open(f, states.cell(P), states.behind(i));
        }
        else
        {
            open(f, states.own(f), states.nei(f));
        }
        out[P] += max(phi[f], scalar(0));
    }
}

template<bool Porous, bool General>
void Foam::mpm::impedanceFlux::boundaryFaces(
    const gasStates<General>& states, const besideSolid* solid, const result& to) const
{
    const fvMesh& mesh = faces_.mesh;
    const label nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const vectorField& S = mesh.faceAreas();
    const scalarField& magS = faces_.magS;
    const bool upwind = states.upwind();
    scalarField& phi = to.phi;
    scalarField& pStar = to.pStar;

    for (const label f : faces_.boundary)
    {
        const label P = own[f], i = f - nInternal;
        const bool close = Porous && solid->near[P];
        const auto L = upwind || close ? states.cell(P) : states.own(f);
        const gasState& B = states.behind(i).w;
        const scalar u = B.u & S[f];
        phi[f] = u;
        pStar[f] = B.p;
        if (close)
        {
            // Without an area of the solid the gas of its share goes with it
            const solidOnFaces& pores = solid->pores;
            const scalar thetaS = pores.thetaS[f];
            phi[f] *= 1 - thetaS;
            if (pores.area)
            {
                phi[f] += thetaS * pores.uS[f] * magS[f];
            }
        }
        if (faces_.wall[i])
        {
            // As between the state and its mirror image
            scalar z = std::sqrt(states.factor() * L.w.rho * states.q(L));
            if (close)
            {
                z *= solid->theta[P] / max(solid->theta[P], 1 - solid->pores.thetaS[f]);
            }
            pStar[f] += L.w.p - states.cell(P).w.p + z * ((L.w.u & S[f]) - u) / magS[f];
        }
        to.out[P] += max(phi[f], scalar(0));
    }
}

void Foam::mpm::impedanceFlux::clear(const result& to) const
{
    faces_.region.forCells([&](const label c) { to.out[c] = 0; });
    for (const label f : faces_.boundary)
    {
        to.out[faces_.mesh.faceOwner()[f]] = 0;
    }
}

template<bool General>
void Foam::mpm::impedanceFlux::all(const gasStates<General>& states, const result& to) const
{
    clear(to);
    insideFaces<false, General, false>(states, nullptr, to);
    boundaryFaces<false>(states, nullptr, to);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::impedanceFlux::flux(const gasStates<false>& states, const result& to) const
{
    all(states, to);
}

void Foam::mpm::impedanceFlux::flux(const gasStates<true>& states, const result& to) const
{
    all(states, to);
}

void Foam::mpm::impedanceFlux::flux(
    const gasStates<false>& states, const besideSolid& solid, const result& to) const
{
    clear(to);
    if (solid.pores.area)
    {
        insideFaces<true, false, true>(states, &solid, to);
    }
    else
    {
        insideFaces<true, false, false>(states, &solid, to);
    }
    boundaryFaces<true>(states, &solid, to);
}
