/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianGas.H"
#include "noTraps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianGas::markNearSolid(const solidOnFaces& pores)
{
    // So much less than 1 is left behind by rounding and by a body that has
    // passed
    constexpr scalar full = 1 - 1e-3;

    const label nCells = mesh_.nCells();
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();

    near_.setSize(nCells + Wb_.size());
    for (label c = 0; c < nCells; ++c)
    {
        near_[c] = theta_[c] < full;
    }
    for (label f = 0; f < mesh_.nFaces(); ++f)
    {
        if (pores.thetaS[f] > 0 || pores.thetaS0[f] > 0)
        {
            near_[own[f]] = true;
            if (f < nInternal)
            {
                near_[nei[f]] = true;
            }
        }
    }

    scalarField behind(Wb_.size());
    forAll(behind, i)
    {
        behind[i] = near_[own[nInternal + i]];
    }
    coupled_.swap(behind);
    forAll(behind, i)
    {
        near_[nCells + i] = behind[i] > 0.5;
    }
}


template<bool Porous>
void Foam::mpm::eulerianGas::faces(const scalar dt, const solidOnFaces* pores)
{
    const label nCells = mesh_.nCells();
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    const scalarField& V = mesh_.V();
    const scalar gamma = thermo_.gamma();
    const bool upwind = reconstruction_.upwind();
    const List<reconstruction::sides>& sides = reconstruction_.faces();

    out_ = 0;

    // Face between two states: sets flux and pressure
    const auto open = [&](const label f, const gasState& L, const gasState& R)
    {
        const scalar z = std::sqrt(gamma*max(L.rho*L.p, R.rho*R.p));
        const scalar uL = L.u & S[f], uR = R.u & S[f];
        phi_[f] = 0.5*(uL + uR + (L.p - R.p)*magS_[f]/z);
        pStar_[f] = 0.5*(L.p + R.p + z*(uL - uR)/magS_[f]);
    };

    // The same next to solid
    const auto porousFace = [&]
    (
        const label f,
        const gasState& L,
        const gasState& R,
        const scalar thetaL,
        const scalar thetaR,
        const scalar VL,
        const scalar VR
    )
    {
        const scalar thetaS = pores->thetaS[f];
        const scalar theta = 1 - thetaS;
        const scalar z = std::sqrt(gamma*max(L.rho*L.p, R.rho*R.p));
        const scalar ZL = z*thetaL, ZR = z*thetaR, sumZ = ZL + ZR;
        const scalar uL = (L.u & S[f])/magS_[f], uR = (R.u & S[f])/magS_[f];
        const scalar dp = L.p - R.p;

        const scalar a = min
        (
            theta/sumZ,
            0.4*min(thetaL*VL/L.p, thetaR*VR/R.p)
           /(gamma*magS_[f]*dt*theta)
        );
        scalar u = (ZL*uL + ZR*uR)/sumZ + a*dp;
        scalar mu = ZL*ZR/sumZ/max(theta, max(thetaL, thetaR));

        if (pores->K && pores->fd > 0)
        {
            const scalar rho0 = 0.5*(L.rho + R.rho);
            const scalar k = pores->K[f]*dt/(theta*rho0);
            const scalar w = min(k/(1 + k), pores->dragLimit[f]);
            u += w*(pores->uS[f] - u);
            if (pores->fd == 3)
            {
                const scalar Zm = std::sqrt
                (
                    0.5*gamma*(L.p + R.p)
                   *(theta*rho0 + thetaS*pores->rhoS[f])/theta
                );
                const scalar wm = w*theta*theta;
                u += 0.5*wm*dp/Zm;
                // Explicit: no more than the gas beside a body can take
                mu += min
                (
                    0.5*wm*(Zm - z),
                    0.25*pores->inertia[f]/(theta*magS_[f]*dt)
                );
            }
        }
        phi_[f] = theta*u*magS_[f];
        pStar_[f] = (ZR*L.p + ZL*R.p)/sumZ + mu*(uL - uR);
    };

    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        if (Porous && (near_[P] || near_[N]))
        {
            porousFace(f, W_[P], W_[N], theta_[P], theta_[N], V[P], V[N]);
        }
        else if (upwind)
        {
            open(f, W_[P], W_[N]);
        }
        else
        {
            open(f, sides[f].own, sides[f].nei);
        }
        out_[P] += max(phi_[f], scalar(0));
        out_[N] -= min(phi_[f], scalar(0));
    }

    for (const label f : coupledList_)
    {
        const label P = own[f], i = f - nInternal;
        if (Porous && (near_[P] || near_[nCells + i]))
        {
            porousFace
            (
                f, W_[P], Wb_[i], theta_[P], thetaB_[i], V[P], Vb_[i]
            );
        }
        else if (upwind)
        {
            open(f, W_[P], Wb_[i]);
        }
        else
        {
            open(f, sides[f].own, sides[f].nei);
        }
        out_[P] += max(phi_[f], scalar(0));
    }

    for (const label f : boundary_)
    {
        const label P = own[f], i = f - nInternal;
        const bool close = Porous && near_[P];
        const gasState& L = upwind || close ? W_[P] : sides[f].own;
        const gasState& B = Wb_[i];
        const scalar u = B.u & S[f];
        phi_[f] = u;
        pStar_[f] = B.p;
        if (close)
        {
            phi_[f] *= 1 - pores->thetaS[f];
        }
        if (wall_[i])
        {
            // As between the state and its mirror image
            scalar z = std::sqrt(gamma*L.rho*L.p);
            if (close)
            {
                z *= theta_[P]/max(theta_[P], 1 - pores->thetaS[f]);
            }
            pStar_[f] +=
                L.p - W_[P].p + z*((L.u & S[f]) - u)/magS_[f];
        }
        out_[P] += max(phi_[f], scalar(0));
    }
}


template<bool Porous>
void Foam::mpm::eulerianGas::limitOutflow
(
    const scalar dt,
    const solidOnFaces* pores
)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const scalarField& V = mesh_.V();

    const auto most = [&](const label c)
    {
        const scalar theta = theta_[c];
        return
            Porous
          ? max(min(0.9*theta, theta - 0.5*pores->eps), 0.01*theta)
          : 0.9;
    };

    limits_ = false;
    forAll(out_, c)
    {
        if (dt*out_[c] > most(c)*V[c])
        {
            limits_ = true;
            break;
        }
    }
    reduce(limits_, orOp<bool>());
    if (!limits_)
    {
        return;
    }

    forAll(out_, c)
    {
        const scalar allowed = most(c)*V[c]/dt;
        if (out_[c] > allowed)
        {
            out_[c] = allowed/out_[c];
            ++fixups_.limited;
        }
        else
        {
            out_[c] = 1;
        }
    }
    scalarField behind(Wb_.size(), 1);
    for (const label f : coupledList_)
    {
        behind[f - nInternal] = out_[own[f]];
    }
    coupled_.swap(behind);

    phiLimited_.setSize(phi_.size());
    for (label f = 0; f < nInternal; ++f)
    {
        const label donor = phi_[f] > 0 ? own[f] : nei[f];
        phiLimited_[f] = phi_[f]*out_[donor];
        fixups_.heldBack +=
            dt*mag(phi_[f] - phiLimited_[f])*W_[donor].rho;
    }
    for (const labelList* list : {&coupledList_, &boundary_})
    {
        for (const label f : *list)
        {
            phiLimited_[f] =
                phi_[f]*(phi_[f] > 0 ? out_[own[f]] : behind[f - nInternal]);

            // What comes in is counted where it leaves
            if (phi_[f] > 0)
            {
                fixups_.heldBack +=
                    dt*(phi_[f] - phiLimited_[f])*W_[own[f]].rho;
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianGas::faceFlux(const scalar dt, const solidOnFaces* pores)
{
    const noTraps guard;

    if (pores)
    {
        porous_ = true;
        markNearSolid(*pores);
    }
    if (!reconstruction_.upwind())
    {
        reconstruction_.update
        (
            dt, thermo_.gamma(), W_, Wb_, rho0_, U_, p_,
            pores ? &near_ : nullptr
        );
    }

    if (pores)
    {
        faces<true>(dt, pores);
        limitOutflow<true>(dt, pores);
    }
    else
    {
        faces<false>(dt, pores);
        limitOutflow<false>(dt, pores);
    }
}

// ************************************************************************* //
