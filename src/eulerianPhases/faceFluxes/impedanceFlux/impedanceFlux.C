/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "impedanceFlux.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(impedanceFlux, 0);
    addToRunTimeSelectionTable(faceFlux, impedanceFlux, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<bool General, bool Vector>
inline void Foam::mpm::impedanceFlux::porousFace
(
    const label f,
    const gasStates<General>& states,
    const porousSide<General>& sideL,
    const porousSide<General>& sideR,
    const besideSolid& solid,
    const result& to
) const
{
    const solidOnFaces& pores = solid.pores;
    const vector& S = faces_.mesh.faceAreas()[f];
    const scalar magS = faces_.magS[f], dt = solid.dt;
    const scalar factor = states.factor();
    const gasState& L = sideL.s.w;
    const gasState& R = sideR.s.w;
    const scalar qL = states.q(sideL.s), qR = states.q(sideR.s);
    const scalar thetaL = sideL.theta, thetaR = sideR.theta;

    const scalar thetaS = pores.thetaS[f];
    const scalar theta = 1 - thetaS;
    const scalar z = std::sqrt(factor*max(L.rho*qL, R.rho*qR));
    const scalar ZL = z*thetaL, ZR = z*thetaR, sumZ = ZL + ZR;
    const scalar uL = (L.u & S)/magS, uR = (R.u & S)/magS;
    const scalar dp = L.p - R.p;

    const scalar bound = Vector ? pores.soundLimit[f] : 0.4;
    const scalar a = min
    (
        theta/sumZ,
        bound*min(thetaL*sideL.V/qL, thetaR*sideR.V/qR)
       /(factor*magS*dt*theta)
    );
    scalar u = (ZL*uL + ZR*uR)/sumZ + a*dp;
    scalar push = Vector ? a*dp : 0, ofSolid = 0;
    scalar mu = ZL*ZR/sumZ/max(theta, max(thetaL, thetaR));

    if (pores.K && pores.fd != solidOnFaces::none)
    {
        const scalar rho0 = 0.5*(L.rho + R.rho);
        const scalar k = pores.K[f]*dt/(theta*rho0);
        const scalar w = min(k/(1 + k), pores.dragLimit[f]);
        u += w*(pores.uS[f] - u);
        if (Vector)
        {
            push *= 1 - w;
            ofSolid = w;
        }
        if (pores.fd == solidOnFaces::impedance)
        {
            const scalar Zm = std::sqrt
            (
                0.5*factor*(qL + qR)
               *(theta*rho0 + thetaS*pores.rhoS[f])/theta
            );
            const scalar wm = w*theta*theta;
            u += 0.5*wm*dp/Zm;
            if (Vector)
            {
                push += 0.5*wm*dp/Zm;
            }
            // Explicit: no more than the gas beside a body can take
            mu += min
            (
                0.5*wm*(Zm - z),
                0.25*pores.inertia[f]/(theta*magS*dt)
            );
        }
    }
    if (Vector)
    {
        // The middle term: both fluxes add up to S.u_s in a dense body
        const vector& A = pores.area[f];
        vector uf((ZL*L.u + ZR*R.u)/sumZ);
        uf += ofSolid*(pores.U[f] - uf);
        to.phi[f] =
            ((S - A) & uf) + ofSolid*((A & pores.U[f]) - pores.phiS[f])
          + theta*magS*push;
    }
    else
    {
        to.phi[f] = theta*u*magS;
    }
    to.pStar[f] = (ZR*L.p + ZL*R.p)/sumZ + mu*(uL - uR);
}


template<bool Porous, bool General, bool Vector>
void Foam::mpm::impedanceFlux::insideFaces
(
    const gasStates<General>& states,
    const besideSolid* solid,
    const result& to
) const
{
    typedef typename gasStates<General>::state state;
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells();
    const label nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vector* const S = mesh.faceAreas().cdata();
    const scalarField& V = mesh.V();
    const scalar* const magS = faces_.magS.cdata();
    const bool upwind = states.upwind();
    const scalar factor = states.factor();
    scalar* const phi = to.phi.data();
    scalar* const pStar = to.pStar.data();
    scalar* const out = to.out.data();

    // Face between two states
    const auto open = [&](const label f, const state& L, const state& R)
    {
        const scalar z = std::sqrt
        (
            factor*max(L.w.rho*states.q(L), R.w.rho*states.q(R))
        );
        const scalar uL = L.w.u & S[f], uR = R.w.u & S[f];
        phi[f] = 0.5*(uL + uR + (L.w.p - R.w.p)*magS[f]/z);
        pStar[f] = 0.5*(L.w.p + R.w.p + z*(uL - uR)/magS[f]);
    };

    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        if (Porous && (solid->near[P] || solid->near[N]))
        {
            porousFace<General, Vector>
            (
                f, states,
                {states.cell(P), solid->theta[P], V[P]},
                {states.cell(N), solid->theta[N], V[N]},
                *solid, to
            );
        }
        else if (upwind)
        {
            open(f, states.cell(P), states.cell(N));
        }
        else
        {
            open(f, states.own(f), states.nei(f));
        }
        out[P] += max(phi[f], scalar(0));
        out[N] -= min(phi[f], scalar(0));
    }

    for (const label f : faces_.coupled)
    {
        const label P = own[f], i = f - nInternal;
        if (Porous && (solid->near[P] || solid->near[nCells + i]))
        {
            porousFace<General, Vector>
            (
                f, states,
                {states.cell(P), solid->theta[P], V[P]},
                {states.behind(i), solid->thetaB[i], faces_.Vb[i]},
                *solid, to
            );
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
void Foam::mpm::impedanceFlux::boundaryFaces
(
    const gasStates<General>& states,
    const besideSolid* solid,
    const result& to
) const
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
                phi[f] += thetaS*pores.uS[f]*magS[f];
            }
        }
        if (faces_.wall[i])
        {
            // As between the state and its mirror image
            scalar z = std::sqrt(states.factor()*L.w.rho*states.q(L));
            if (close)
            {
                z *=
                    solid->theta[P]
                   /max(solid->theta[P], 1 - solid->pores.thetaS[f]);
            }
            pStar[f] +=
                L.w.p - states.cell(P).w.p
              + z*((L.w.u & S[f]) - u)/magS[f];
        }
        to.out[P] += max(phi[f], scalar(0));
    }
}

template<bool General>
void Foam::mpm::impedanceFlux::all
(
    const gasStates<General>& states,
    const result& to
) const
{
    to.out = 0;
    insideFaces<false, General, false>(states, nullptr, to);
    boundaryFaces<false>(states, nullptr, to);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::impedanceFlux::flux
(
    const gasStates<false>& states,
    const result& to
) const
{
    all(states, to);
}


void Foam::mpm::impedanceFlux::flux
(
    const gasStates<true>& states,
    const result& to
) const
{
    all(states, to);
}


void Foam::mpm::impedanceFlux::flux
(
    const gasStates<false>& states,
    const besideSolid& solid,
    const result& to
) const
{
    to.out = 0;
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

// ************************************************************************* //
