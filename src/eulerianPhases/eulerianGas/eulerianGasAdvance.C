// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianGas.H"
#include "largestOfAll.H"
#include "noTraps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianGas::keepIsentrope(const label celli, const scalar p)
{
    const scalar gamma = thermo_.gamma();
    const scalar iGm1 = 1 / (gamma - 1);
    const scalar kinetic = 0.5 * magSqr(rhoU_[celli]) / rho_[celli];
    const scalar pNew = (gamma - 1) * (rhoE_[celli] - kinetic) / theta_[celli];
    const scalar ratio = rho_[celli] / (theta_[celli] * W_[celli].rho);
    if (gamma <= 2 && pNew >= 0.3 * p * max(sqr(ratio), scalar(1)))
    {
        return;
    }
    const scalar pIsentropic = p * std::pow(ratio, gamma);
    if (!(pNew >= 0.3 * pIsentropic))
    {
        const scalar E = iGm1 * theta_[celli] * pIsentropic + kinetic;
        bookFixup(celli, (E - rhoE_[celli]) * mesh_.V()[celli]);
        rhoE_[celli] = E;
        ++fixups_.isentropic;
    }
}

template<bool Porous, bool Energy, bool General>
void Foam::mpm::eulerianGas::sumFaces(const scalar dt, const solidOnFaces* pores)
{
    typedef typename gasStates<General>::state state;
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    const gasStates<General> all(allStates<General>());
    const bool upwind = all.upwind();
    const scalarField& limited = phiLimited();

    region_.forCells([&](const label c) { sums_[c] = sums{0, Zero, 0}; });
    if (Porous)
    {
        volumes_.setSize(mesh_.nCells());
        region_.forCells(
            [&](const label c)
            {
                if (thetaChanges(c))
                {
                    volumes_[c] = volumes{0, 0, 0};
                }
            });
    }

    // Nominal flux in the work next to solid keeps p uniform when the limiter
    // acts
    const auto flux = [&](const label f, const state& donor)
    {
        return carried<Energy>(
            limited[f], pStar_[f] * (Porous ? phi_[f] : limited[f]), donor.w, all.rhoE(donor));
    };

    // To one side, whose pressure is p
    const auto add =
        [&](const label c, const scalar sign, const sums& s, const label f, const scalar theta)
    {
        sums& to = sums_[c];
        to.rho += sign * s.rho;
        to.rhoU += sign * (s.rhoU + (theta * (pStar_[f] - W_[c].p)) * S[f]);
        if (Energy)
        {
            to.rhoE += sign * s.rhoE;
        }
        if (Porous && thetaChanges(c))
        {
            volumes& v = volumes_[c];
            v.phi += sign * phi_[f];
            v.limited += sign * limited[f];
            v.solid += sign * pores->phiS[f];
        }
    };
    const auto room = [&](const label f, const bool near)
    { return Porous && near ? 1 - pores->thetaS0[f] : 1; };

    region_.forFaces(
        [&](const label f)
        {
            const label P = own[f], N = nei[f];
            const bool out = limited[f] > 0;
            const sums s(flux(f, upwind ? all.cell(out ? P : N) : (out ? all.own(f) : all.nei(f))));
            const scalar theta = room(f, Porous && (near_[P] || near_[N]));
            add(P, 1, s, f, theta);
            add(N, -1, s, f, theta);
        });
    for (const labelList* list : {&faces_.coupled, &faces_.boundary})
    {
        const bool books = flows_ && list == &faces_.boundary;
        for (const label f : *list)
        {
            const label P = own[f];
            const bool out = limited[f] > 0;
            const sums s(flux(
                f,
                upwind ? (out ? all.cell(P) : all.behind(f - nInternal))
                       : (out ? all.own(f) : all.nei(f))));
            const scalar theta = room(f, true);
            add(P, 1, s, f, theta);
            if (books)
            {
                flows_->mass -= dt * s.rho;
                flows_->impulse -=
                    dt * (s.rhoU + (theta * pStar_[f] + (1 - theta) * W_[P].p) * S[f]);
                flows_->energy -= dt * s.rhoE;
            }
        }
    }
    if (Porous && pores->area0)
    {
        addVectorAreas(pores->area0);
    }
    addWedgeSides(nullptr);
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
            sums_[P].rhoU -= (pStar_[f] - W_[P].p) * area[f];
            sums_[N].rhoU += (pStar_[f] - W_[N].p) * area[f];
        }
    }
    for (const label f : faces_.coupled)
    {
        const label P = own[f];
        sums_[P].rhoU -= (pStar_[f] - W_[P].p) * area[f];
    }
}

template<bool Porous, bool Energy>
bool Foam::mpm::eulerianGas::newStates(const scalar dt, const solidOnFaces* pores)
{
    const scalarField& V = mesh_.V();
    bookGravity(dt);

    const ownPressure::conserved now(conserved());
    bool positive = true;
    region_.forCells(
        [&](const label c)
        {
            const sums& s = sums_[c];
            const scalar h = dt / V[c];
            const scalar rhoOld = rho_[c];
            const vector rhoUOld(rhoU_[c]);
            rho_[c] -= h * s.rho;
            rhoU_[c] += dt * rhoOld * g_ - h * s.rhoU;
            if (Energy)
            {
                rhoE_[c] += dt * (rhoUOld & g_) - h * s.rhoE;
            }
            if (Porous && thetaChanges(c))
            {
                changeTheta<Energy>(c, h, *pores);
                if (Energy && near_[c])
                {
                    keepIsentrope(c, W_[c].p);
                }
            }
            if (Energy)
            {
                positive = positive && ownPressure::isPositive(now, c);
            }
        });
    return positive;
}

template<bool Porous, bool Energy, bool General>
void Foam::mpm::eulerianGas::cells(const scalar dt, const solidOnFaces* pores)
{
    sumFaces<Porous, Energy, General>(dt, pores);
    const flows gained(addLayers(dt));
    if (flows_)
    {
        *flows_ += gained;
    }
    bool positive = newStates<Porous, Energy>(dt, pores);
    if (General && Energy)
    {
        boolList bad(rho_.size());
        positive = closure_.markBad(conserved(), bad);
    }
    if (Energy && onAny(!positive))
    {
        keepPositive<Porous, General>(dt);
    }
}

template<bool General>
Foam::mpm::eulerianGas::sums Foam::mpm::eulerianGas::positiveFlux(
    const gasStates<General>& states, const typename gasStates<General>::state& L,
    const typename gasStates<General>::state& R, const vector& S)
{
    typedef typename gasStates<General>::state state;
    const scalar area = mag(S);
    const scalar uL = (L.w.u & S) / area, uR = (R.w.u & S) / area;
    const scalar cL = states.c(L), cR = states.c(R);
    const scalar low = min(min(uL - cL, uR - cR), scalar(0));
    const scalar high = max(max(uL + cL, uR + cR), scalar(0));

    // a F.n + b W of one side
    sums flux{0, Zero, 0};
    const auto add = [&](const state& s, const scalar u, const scalar a, const scalar b)
    {
        const gasState& w = s.w;
        const scalar E = states.rhoE(s) + 0.5 * w.rho * magSqr(w.u);
        const scalar m = area * (a * u + b) * w.rho;
        flux.rho += m;
        flux.rhoU += m * w.u + (a * w.p) * S;
        flux.rhoE += area * ((a * u + b) * E + a * u * w.p);
    };
    const scalar width = high - low;
    add(L, uL, high / width, -low * high / width);
    add(R, uR, -low / width, low * high / width);
    return flux;
}

template<bool General>
Foam::mpm::eulerianGas::sums
Foam::mpm::eulerianGas::wallFlux(const gasStates<General>& states, const label f) const
{
    typedef typename gasStates<General>::state state;
    const vector& S = mesh_.faceAreas()[f];
    const scalar volume = phiLimited()[f];
    const state c = states.cell(mesh_.faceOwner()[f]);
    const state b = states.behind(f - mesh_.nInternalFaces());
    const scalar z = std::sqrt(states.factor() * c.w.rho * states.q(c));
    const scalar p = b.w.p + z * ((c.w.u - b.w.u) & S) / faces_.magS[f];
    const state& donor = volume > 0 ? c : b;
    sums flux = carried<true>(volume, p * volume, donor.w, states.rhoE(donor));
    flux.rhoU += p * S;
    return flux;
}

template<bool Porous, bool General>
void Foam::mpm::eulerianGas::keepPositive(const scalar dt)
{
    typedef typename gasStates<General>::state state;
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    const scalarField& V = mesh_.V();
    const scalarField& limited = phiLimited();
    const gasStates<General> all(allStates<General>());
    const bool upwind = all.upwind();

    boolList replaced(mesh_.nFaces(), false), bad(rho_.size());
    scalarField behind(Wb_.size());
    bool changed = true;

    // What the step has sent through a face, and what it shall be
    const auto give = [&](const label f, const sums& now, const label N)
    {
        const label P = own[f];
        const state donor = upwind
            ? (limited[f] > 0 ? all.cell(P)
                   : N < 0    ? all.behind(f - nInternal)
                              : all.cell(N))
            : (limited[f] > 0 ? all.own(f) : all.nei(f));
        sums d = carried<true>(
            limited[f], pStar_[f] * (Porous ? phi_[f] : limited[f]), donor.w, all.rhoE(donor));
        d.rho -= now.rho;
        d.rhoU += pStar_[f] * S[f] - now.rhoU;
        d.rhoE -= now.rhoE;

        rho_[P] += dt / V[P] * d.rho;
        rhoU_[P] += dt / V[P] * d.rhoU;
        rhoE_[P] += dt / V[P] * d.rhoE;
        if (N >= 0)
        {
            rho_[N] -= dt / V[N] * d.rho;
            rhoU_[N] -= dt / V[N] * d.rhoU;
            rhoE_[N] -= dt / V[N] * d.rhoE;
        }
        replaced[f] = true;
        changed = true;
        return d;
    };

    while (onAny(changed))
    {
        changed = false;
        closure_.markBad(conserved(), bad);
        forAll(behind, i)
        {
            behind[i] = bad[own[nInternal + i]];
        }
        coupled_.swap(behind);

        for (label f = 0; f < nInternal; ++f)
        {
            const label P = own[f], N = nei[f];
            if ((bad[P] || bad[N]) && !replaced[f] && !(Porous && (near_[P] || near_[N])))
            {
                give(f, positiveFlux(all, all.cell(P), all.cell(N), S[f]), N);
                ++fixups_.positive;
            }
        }
        for (const label f : faces_.coupled)
        {
            const label P = own[f], i = f - nInternal;
            if ((bad[P] || behind[i] > 0.5) && !replaced[f]
                && !(Porous && (near_[P] || near_[bad.size() + i])))
            {
                give(f, positiveFlux(all, all.cell(P), all.behind(i), S[f]), -1);
            }
        }
        for (const label f : faces_.boundary)
        {
            const label P = own[f], i = f - nInternal;
            if (bad[P] && faces_.wall[i] && !replaced[f] && !(Porous && near_[P]))
            {
                const sums d = give(f, wallFlux(all, f), -1);
                if (flows_)
                {
                    flows_->mass += dt * d.rho;
                    flows_->impulse += dt * d.rhoU;
                    flows_->energy += dt * d.rhoE;
                }
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::eulerianGas::advance(const scalar dt, const solidOnFaces* pores, const bool)
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
    addViscosity(dt);
    return true;
}

// * * * * * * * * * * * * * * * Instantiations  * * * * * * * * * * * * * * //

template void Foam::mpm::eulerianGas::keepPositive<true, false>(const scalar);
template void Foam::mpm::eulerianGas::keepPositive<false, false>(const scalar);
template void Foam::mpm::eulerianGas::keepPositive<false, true>(const scalar);
