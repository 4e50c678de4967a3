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

void Foam::mpm::eulerianGas::keepIsentrope
(
    const label celli,
    const scalar p
)
{
    const scalar gamma = thermo_.gamma();
    const scalar iGm1 = 1/(gamma - 1);
    const scalar kinetic = 0.5*magSqr(rhoU_[celli])/rho_[celli];
    const scalar pNew = (gamma - 1)*(rhoE_[celli] - kinetic)/theta_[celli];
    const scalar pIsentropic =
        p*std::pow(rho_[celli]/(theta_[celli]*W_[celli].rho), gamma);
    if (!(pNew >= 0.3*pIsentropic))
    {
        const scalar E = iGm1*theta_[celli]*pIsentropic + kinetic;
        bookFixup(celli, (E - rhoE_[celli])*mesh_.V()[celli]);
        rhoE_[celli] = E;
        ++fixups_.isentropic;
    }
}


template<bool General>
void Foam::mpm::eulerianGas::addWedgeSides(const gasStates<General>& all)
{
    // They have the cell's pressure of the middle of the step
    const labelUList& own = mesh_.faceOwner();
    const vectorField& S = mesh_.faceAreas();
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label n =
            !all.upwind() && isA<wedgePolyPatch>(pp) ? pp.size() : 0;
        for (label f = pp.start(); f < pp.start() + n; ++f)
        {
            const label P = own[f];
            sums_[P].rhoU += (all.own(f).w.p - W_[P].p)*S[f];
        }
    }
}


template<bool Porous, bool Energy, bool General>
void Foam::mpm::eulerianGas::sumFaces
(
    const scalar dt,
    const solidOnFaces* pores
)
{
    typedef typename gasStates<General>::state state;
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    const gasStates<General> all(allStates<General>());
    const bool upwind = all.upwind();
    const scalarField& limited = phiLimited();

    sums_ = sums{0, Zero, 0};
    if (Porous)
    {
        volumes_.setSize(mesh_.nCells());
        volumes_ = volumes{0, 0, 0};
    }

    // Nominal flux in the work next to solid keeps p uniform when the limiter
    // acts
    const auto flux = [&](const label f, const state& donor)
    {
        return carried<Energy>
        (
            limited[f],
            pStar_[f]*(Porous ? phi_[f] : limited[f]),
            donor.w,
            all.rhoE(donor)
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
              ? all.cell(out ? P : N)
              : (out ? all.own(f) : all.nei(f))
            )
        );
        const scalar theta = Porous ? 1 - pores->thetaS0[f] : 1;
        add(P, 1, s, f, theta);
        add(N, -1, s, f, theta);
    }
    for (const labelList* list : {&faces_.coupled, &faces_.boundary})
    {
        const bool books = flows_ && list == &faces_.boundary;
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
                  ? (out ? all.cell(P) : all.behind(f - nInternal))
                  : (out ? all.own(f) : all.nei(f))
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
    if (Porous && pores->area0)
    {
        addVectorAreas(pores->area0);
    }
    addWedgeSides(all);
}


void Foam::mpm::eulerianGas::addVectorAreas(const vector* area)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    for (label f = 0; f < nInternal; ++f)
    {
        if (magSqr(area[f]) > 0)
        {
            const label P = own[f], N = nei[f];
            sums_[P].rhoU -= (pStar_[f] - W_[P].p)*area[f];
            sums_[N].rhoU += (pStar_[f] - W_[N].p)*area[f];
        }
    }
    for (const label f : faces_.coupled)
    {
        const label P = own[f];
        sums_[P].rhoU -= (pStar_[f] - W_[P].p)*area[f];
    }
}


template<bool Porous, bool Energy>
bool Foam::mpm::eulerianGas::newStates
(
    const scalar dt,
    const solidOnFaces* pores
)
{
    const scalarField& V = mesh_.V();
    bookGravity(dt);

    const pressureClosure::conserved now(conserved());
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
                    keepIsentrope(c, p);
                }
            }
        }
        if (Energy)
        {
            positive = positive && pressureClosure::isPositive(now, c);
        }
    }
    return positive;
}


template<bool Porous, bool Energy, bool General>
void Foam::mpm::eulerianGas::cells(const scalar dt, const solidOnFaces* pores)
{
    sumFaces<Porous, Energy, General>(dt, pores);
    bool positive = newStates<Porous, Energy>(dt, pores);
    if (General && Energy)
    {
        boolList bad(rho_.size());
        positive = closure_->markBad(conserved(), bad);
    }
    if (Energy && !returnReduce(positive, andOp<bool>()))
    {
        keepPositive<Porous, General>(dt);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianGas::advance(const scalar dt, const solidOnFaces* pores)
{
    const noTraps guard;

    const bool energy = thermo_.hasEnergy();
    if (pores && energy)
    {
        cells<true, true, false>(dt, pores);
    }
    else if (pores)
    {
        cells<true, false, false>(dt, pores);
    }
    else if (thermo_.isGammaLaw() && energy)
    {
        cells<false, true, false>(dt, pores);
    }
    else if (thermo_.isGammaLaw())
    {
        cells<false, false, false>(dt, pores);
    }
    else if (energy)
    {
        cells<false, true, true>(dt, pores);
    }
    else
    {
        cells<false, false, true>(dt, pores);
    }
    addViscosity(dt, U_);
}

// ************************************************************************* //
