/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianGas.H"
#include "wedgePolyPatch.H"
#include "noTraps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::eulerianGas::newTheta
(
    const scalar A,
    const scalar D,
    const scalar eps
)
{
    scalar theta = A + D;
    if (theta < 0.5*A)
    {
        theta = A/(1 - D/A);
        ++fixups_.theta;
    }
    if (theta < min(A, 0.5*eps))
    {
        theta = min(A, 0.5*eps);
        ++fixups_.theta;
    }
    return theta;
}


void Foam::mpm::eulerianGas::bookFixup
(
    const label celli,
    const scalar energy
)
{
    fixups_.energy += energy;
    if (mag(energy) > fixedMost_)
    {
        fixedMost_ = mag(energy);
        fixedCell_ = celli;
    }
    if (flows_)
    {
        flows_->fixups += energy;
    }
}


template<bool Energy>
Foam::mpm::eulerianGas::sums Foam::mpm::eulerianGas::carried
(
    const scalar volume,
    const scalar work,
    const gasState& donor,
    const scalar iGm1
)
{
    sums s;
    s.rho = volume*donor.rho;
    s.rhoU = s.rho*donor.u;
    if (Energy)
    {
        s.rhoE =
            volume*(iGm1*donor.p + 0.5*donor.rho*magSqr(donor.u)) + work;
    }
    return s;
}


template<bool Porous, bool Energy>
void Foam::mpm::eulerianGas::cells(const scalar dt, const solidOnFaces* pores)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    const scalarField& V = mesh_.V();
    const scalar gamma = thermo_.gamma();
    const scalar iGm1 = 1/(gamma - 1);
    const bool upwind = reconstruction_.upwind();
    const List<reconstruction::sides>& sides = reconstruction_.faces();
    const scalarField& limited = phiLimited();

    sums_ = sums{0, Zero, 0};
    if (Porous)
    {
        volumes_.setSize(mesh_.nCells());
        volumes_ = volumes{0, 0, 0};
    }

    // Nominal flux in the work next to solid keeps p uniform when the limiter
    // acts
    const auto flux = [&](const label f, const gasState& donor)
    {
        return carried<Energy>
        (
            limited[f], pStar_[f]*(Porous ? phi_[f] : limited[f]), donor, iGm1
        );
    };

    // To one side, whose pressure is p
    const auto add = [&]
    (
        const label c,
        const scalar sign,
        const sums& s,
        const label f,
        const scalar theta
    )
    {
        sums& to = sums_[c];
        to.rho += sign*s.rho;
        to.rhoU += sign*(s.rhoU + (theta*(pStar_[f] - W_[c].p))*S[f]);
        if (Energy)
        {
            to.rhoE += sign*s.rhoE;
        }
        if (Porous)
        {
            volumes& v = volumes_[c];
            v.phi += sign*phi_[f];
            v.limited += sign*limited[f];
            v.solid += sign*pores->phiS[f];
        }
    };

    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        const bool out = limited[f] > 0;
        const sums s
        (
            flux
            (
                f,
                upwind
              ? W_[out ? P : N]
              : (out ? sides[f].own : sides[f].nei)
            )
        );
        const scalar theta = Porous ? 1 - pores->thetaS0[f] : 1;
        add(P, 1, s, f, theta);
        add(N, -1, s, f, theta);
    }
    for (const labelList* list : {&coupledList_, &boundary_})
    {
        const bool books = flows_ && list == &boundary_;
        for (const label f : *list)
        {
            const label P = own[f];
            const bool out = limited[f] > 0;
            const sums s
            (
                flux
                (
                    f,
                    upwind
                  ? (out ? W_[P] : Wb_[f - nInternal])
                  : (out ? sides[f].own : sides[f].nei)
                )
            );
            const scalar theta = Porous ? 1 - pores->thetaS0[f] : 1;
            add(P, 1, s, f, theta);
            if (books)
            {
                flows_->mass -= dt*s.rho;
                flows_->impulse -=
                    dt
                   *(s.rhoU + (theta*pStar_[f] + (1 - theta)*W_[P].p)*S[f]);
                flows_->energy -= dt*s.rhoE;
            }
        }
    }
    if (flows_ && mag(g_) > 0)
    {
        forAll(rho_, c)
        {
            flows_->gravityImpulse += dt*V[c]*rho_[c]*g_;
            flows_->gravityWork += dt*V[c]*(rhoU_[c] & g_);
        }
    }

    // The sides of a wedge have the cell's pressure of the middle of the step
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label n = !upwind && isA<wedgePolyPatch>(pp) ? pp.size() : 0;
        for (label f = pp.start(); f < pp.start() + n; ++f)
        {
            const label P = own[f];
            sums_[P].rhoU += (sides[f].own.p - W_[P].p)*S[f];
        }
    }

    bool positive = true;
    forAll(sums_, c)
    {
        const sums& s = sums_[c];
        const scalar h = dt/V[c];
        const scalar rhoOld = rho_[c];
        const vector rhoUOld(rhoU_[c]);
        rho_[c] -= h*s.rho;
        rhoU_[c] += dt*rhoOld*g_ - h*s.rhoU;
        if (Energy)
        {
            rhoE_[c] += dt*(rhoUOld & g_) - h*s.rhoE;
        }
        if (Porous)
        {
            const volumes& v = volumes_[c];
            const scalar A = theta_[c] - h*v.limited;
            const scalar D = h*(v.solid + v.phi) - pores->dilation[c];
            theta_[c] = newTheta(A, D, pores->eps);
            if (Energy)
            {
                const scalar p = W_[c].p;
                rhoE_[c] -= p*(theta_[c] - A - h*v.phi);
                bookFixup(c, -p*(theta_[c] - (A + D))*V[c]);

                if (near_[c])
                {
                    const scalar kinetic = 0.5*magSqr(rhoU_[c])/rho_[c];
                    const scalar pNew =
                        (gamma - 1)*(rhoE_[c] - kinetic)/theta_[c];
                    const scalar pIsentropic =
                        p*std::pow(rho_[c]/(theta_[c]*W_[c].rho), gamma);
                    if (!(pNew >= 0.3*pIsentropic))
                    {
                        const scalar E = iGm1*theta_[c]*pIsentropic + kinetic;
                        bookFixup(c, (E - rhoE_[c])*V[c]);
                        rhoE_[c] = E;
                        ++fixups_.isentropic;
                    }
                }
            }
        }
        if (Energy)
        {
            positive = positive && isPositive(c);
        }
    }
    if (Energy && !returnReduce(positive, andOp<bool>()))
    {
        keepPositive<Porous>(dt);
    }
}


Foam::mpm::eulerianGas::sums Foam::mpm::eulerianGas::positiveFlux
(
    const gasState& L,
    const gasState& R,
    const vector& S
) const
{
    const scalar gamma = thermo_.gamma(), area = mag(S);
    const scalar uL = (L.u & S)/area, uR = (R.u & S)/area;
    const scalar cL = std::sqrt(gamma*L.p/L.rho);
    const scalar cR = std::sqrt(gamma*R.p/R.rho);
    const scalar low = min(min(uL - cL, uR - cR), scalar(0));
    const scalar high = max(max(uL + cL, uR + cR), scalar(0));

    // a F.n + b W of one side
    sums flux{0, Zero, 0};
    const auto add =
        [&](const gasState& w, const scalar u, const scalar a, const scalar b)
    {
        const scalar E = w.p/(gamma - 1) + 0.5*w.rho*magSqr(w.u);
        const scalar m = area*(a*u + b)*w.rho;
        flux.rho += m;
        flux.rhoU += m*w.u + (a*w.p)*S;
        flux.rhoE += area*((a*u + b)*E + a*u*w.p);
    };
    const scalar width = high - low;
    add(L, uL, high/width, -low*high/width);
    add(R, uR, -low/width, low*high/width);
    return flux;
}


template<bool Porous>
void Foam::mpm::eulerianGas::keepPositive(const scalar dt)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    const scalarField& V = mesh_.V();
    const scalar iGm1 = 1/(thermo_.gamma() - 1);
    const scalarField& limited = phiLimited();
    const bool upwind = reconstruction_.upwind();

    boolList replaced(mesh_.nFaces(), false), bad(rho_.size());
    scalarField behind(Wb_.size());
    bool changed = true;

    // What the step has sent through a face, and what it shall be
    const auto give = [&](const label f, const sums& now, const label N)
    {
        const label P = own[f];
        const gasState& donor =
            upwind
          ? (limited[f] > 0 ? W_[P] : N < 0 ? Wb_[f - nInternal] : W_[N])
          : limited[f] > 0
          ? reconstruction_.faces()[f].own
          : reconstruction_.faces()[f].nei;
        sums d = carried<true>
        (
            limited[f], pStar_[f]*(Porous ? phi_[f] : limited[f]), donor, iGm1
        );
        d.rho -= now.rho;
        d.rhoU += pStar_[f]*S[f] - now.rhoU;
        d.rhoE -= now.rhoE;

        rho_[P] += dt/V[P]*d.rho;
        rhoU_[P] += dt/V[P]*d.rhoU;
        rhoE_[P] += dt/V[P]*d.rhoE;
        if (N >= 0)
        {
            rho_[N] -= dt/V[N]*d.rho;
            rhoU_[N] -= dt/V[N]*d.rhoU;
            rhoE_[N] -= dt/V[N]*d.rhoE;
        }
        replaced[f] = true;
        changed = true;
        return d;
    };

    while (returnReduce(changed, orOp<bool>()))
    {
        changed = false;
        forAll(bad, c)
        {
            bad[c] = !isPositive(c);
        }
        forAll(behind, i)
        {
            behind[i] = bad[own[nInternal + i]];
        }
        coupled_.swap(behind);

        for (label f = 0; f < nInternal; ++f)
        {
            const label P = own[f], N = nei[f];
            if
            (
                (bad[P] || bad[N]) && !replaced[f]
             && !(Porous && (near_[P] || near_[N]))
            )
            {
                give(f, positiveFlux(W_[P], W_[N], S[f]), N);
                ++fixups_.positive;
            }
        }
        for (const label f : coupledList_)
        {
            const label P = own[f], i = f - nInternal;
            if
            (
                (bad[P] || behind[i] > 0.5) && !replaced[f]
             && !(Porous && (near_[P] || near_[bad.size() + i]))
            )
            {
                give(f, positiveFlux(W_[P], Wb_[i], S[f]), -1);
            }
        }
        for (const label f : boundary_)
        {
            // Walls: the pressure of the cell itself instead of that at the
            // face
            const label P = own[f], i = f - nInternal;
            if (bad[P] && wall_[i] && !replaced[f] && !(Porous && near_[P]))
            {
                const gasState& w = W_[P];
                const scalar z = std::sqrt(thermo_.gamma()*w.rho*w.p);
                const scalar p =
                    Wb_[i].p + z*((w.u - Wb_[i].u) & S[f])/magS_[f];
                sums now = carried<true>
                (
                    limited[f], p*limited[f],
                    limited[f] > 0 ? w : Wb_[i], iGm1
                );
                now.rhoU += p*S[f];
                const sums d = give(f, now, -1);
                if (flows_)
                {
                    flows_->mass += dt*d.rho;
                    flows_->impulse += dt*d.rhoU;
                    flows_->energy += dt*d.rhoE;
                }
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianGas::advance(const scalar dt, const solidOnFaces* pores)
{
    const noTraps guard;

    if (pores)
    {
        if (thermo_.isentropic())
        {
            cells<true, false>(dt, pores);
        }
        else
        {
            cells<true, true>(dt, pores);
        }
    }
    else if (thermo_.isentropic())
    {
        cells<false, false>(dt, pores);
    }
    else
    {
        cells<false, true>(dt, pores);
    }
}

// ************************************************************************* //
