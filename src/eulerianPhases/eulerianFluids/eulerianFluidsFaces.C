// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "noTraps.H"
#include "syncTools.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianFluids::updateFields()
{
    forAll(theta_, c)
    {
        psi_[c] = W_[c].rho / t_[c].K;
        for (label k = 0; k < n_; ++k)
        {
            const scalar theta = part_[n_ * c + k], m = mass_[n_ * c + k];
            alpha_[k][c] = theta;
            if (m > 0)
            {
                const scalar rho = m / theta;
                state_[k][c] = isGas(k) ? mixture_.thermo(k).T(rho, W_[c].p) : rho;
            }
        }
    }
    for (fvPatchScalarField& psi : psi_.boundaryFieldRef())
    {
        forAll(psi, i)
        {
            psi[i] = psi_[psi.patch().faceCells()[i]];
        }
    }
    U_.correctBoundaryConditions();
    p_.correctBoundaryConditions();
    for (label k = 0; k < n_; ++k)
    {
        alpha_[k].correctBoundaryConditions();
        state_[k].correctBoundaryConditions();
    }
    burnt_.updateFields();
    lambda_.updateFields();
}

void Foam::mpm::eulerianFluids::updateBoundaryStates()
{
    const noTraps guard;
    burnt_.updateBehind(coupled_);
    lambda_.updateBehind(coupled_);
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    forAll(patches, patchi)
    {
        const polyPatch& pp = patches[patchi];
        const label start = pp.start() - nInternal;
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }
        const fvPatchScalarField& p = p_.boundaryField()[patchi];
        const fvPatchVectorField& U = U_.boundaryField()[patchi];
        const bool ofCell = isA<zeroGradientFvPatchScalarField>(alpha_[0].boundaryField()[patchi]);
        for (label i = 0; i < pp.size(); ++i)
        {
            const label b = start + i, P = own[pp.start() + i];
            gasState& w = Wb_[b];
            w = W_[P];
            tb_[b] = t_[P];
            zB_[b] = z_[P];
            thetaB_[b] = theta_[P];
            scalar* alpha = alphaB_.begin() + n_ * b;
            scalar* rho = rhoB_.begin() + n_ * b;
            for (label k = 0; k < n_; ++k)
            {
                const scalar theta = part_[n_ * P + k];
                alpha[k] = theta / theta_[P];
                rho[k] = theta > 0 ? mass_[n_ * P + k] / theta : 0;
            }
            if (pp.coupled() || isA<wedgePolyPatch>(pp))
            {
                continue;
            }
            w.p = p[i];
            w.u = U[i];
            const bool closed = faces_.wall[b] && (w.u & S_[pp.start() + i]) >= 0;
            if (ofCell || closed)
            {
                alpha[0] = -1;
                continue;
            }
            scalar sum = 0;
            w.rho = 0;
            for (label k = 0; k < n_; ++k)
            {
                alpha[k] = max(alpha_[k].boundaryField()[patchi][i], scalar(0));
                sum += alpha[k];
            }
            for (label k = 0; k < n_; ++k)
            {
                alpha[k] /= max(sum, VSMALL);
                rho[k] = density(k, state_[k].boundaryField()[patchi][i], p[i]);
                w.rho += alpha[k] * rho[k];
            }
        }
    }
    updateFarStates();
    if (coupled_.empty())
    {
        return;
    }
    static_assert(sizeof(stateTerms) == 3 * sizeof(scalar), "plain numbers");
    coupled_.swap(
        Wb_,
        {{zB_.data(), 1},
         {thetaB_.data(), porous_ ? 1 : 0},
         {alphaB_.data(), n_},
         {rhoB_.data(), n_},
         {reinterpret_cast<scalar*>(tb_.data()), 3}});
}

void Foam::mpm::eulerianFluids::setJumps()
{
    if (jump_.empty())
    {
        return;
    }
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    scalarField behind(strata_ ? Wb_.size() : 0, 0);
    if (strata_)
    {
        strata_->update(interfaces_->cells(), interfaces_->near(), n_, part_, mass_);
        for (const label f : faces_.coupled)
        {
            behind[f - nInternal] = (*strata_)(own[f], f);
        }
        coupled_.swap(behind);
    }
    forAll(weight_, f)
    {
        weight_[f] = faceWeight(own[f], f);
    }
    for (label f = 0; f < nInternal; ++f)
    {
        jump_[f] = weight_[f] - faceWeight(mesh_.faceNeighbour()[f], f);
    }
    for (const label f : faces_.boundary)
    {
        jump_[f] = faces_.wall[f - nInternal] ? 0 : weight_[f];
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const vectorField delta(patch.delta());
        forAll(delta, i)
        {
            const label f = patch.start() + i, P = own[f];
            const vector d(mesh_.faceCentres()[f] - mesh_.cellCentres()[P] - delta[i]);
            const scalar inLayers = strata_ ? behind[f - nInternal] : 0;
            jump_[f] = weight_[f] - Wb_[f - nInternal].rho * (g_ & d) - inLayers;
        }
    }
}

void Foam::mpm::eulerianFluids::sideTerms()
{
    // Sides away from interfaces are of one fluid but for traces, which come and go by rounding
    bool stiff = true;
    for (label k = 0; k < n_; ++k)
    {
        stiff = stiff && mixture_.isStiff(k);
    }
    if (stiff)
    {
        return;
    }
    List<reconstruction::sideTerms>& terms = reconstruction_.ownTerms();
    const List<reconstruction::sides>& sides = reconstruction_.faces();
    terms.setSize(sides.size());
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();
    const labelList& major = interfaces_->major();

    constexpr label room = gasThermo::room;
    struct run
    {
        label n = 0;
        gasState* w[room];
        stateTerms* to[room];
        label cell[room];
    };
    List<run> runs(n_);
    scalar rho[room], p[room], K[room], rhoE[room], strength[room], F[room];
    const auto flush = [&](const label k)
    {
        run& r = runs[k];
        const bool burns = mixture_.detonates(k);
        for (label i = 0; i < r.n; ++i)
        {
            rho[i] = r.w[i]->rho;
            p[i] = r.w[i]->p;
            F[i] = burntOf(r.cell[i], k);
        }
        mixture_.states(k, r.n, rho, p, K, rhoE, strength, burns ? F : nullptr);
        for (label i = 0; i < r.n; ++i)
        {
            if (K[i] > 0.01 * t_[r.cell[i]].K)
            {
                *r.to[i] = stateTerms{K[i], rhoE[i], strength[i]};
            }
            else
            {
                *r.w[i] = W_[r.cell[i]];
                *r.to[i] = t_[r.cell[i]];
            }
        }
        r.n = 0;
    };
    const auto add = [&](const label c, const gasState& w, stateTerms& to)
    {
        const label k = major[c];
        if (k < 0 || mixture_.isStiff(k))
        {
            return;
        }
        run& r = runs[k];
        r.w[r.n] = const_cast<gasState*>(&w);
        r.to[r.n] = &to;
        r.cell[r.n++] = c;
        if (r.n == room)
        {
            flush(k);
        }
    };
    for (label f = 0; f < nInternal; ++f)
    {
        add(own[f], sides[f].own, terms[f].own);
        add(nei[f], sides[f].nei, terms[f].nei);
    }
    for (const labelList* list : {&faces_.boundary, &faces_.coupled})
    {
        for (const label f : *list)
        {
            add(own[f], sides[f].own, terms[f].own);
        }
    }
    for (label k = 0; k < n_; ++k)
    {
        flush(k);
    }

    // Of the other sides of processors: as they are there
    const label nCells = mesh_.nCells();
    for (const label f : faces_.coupled)
    {
        const label i = f - nInternal, k = major[nCells + i];
        gasState& w = const_cast<gasState&>(sides[f].nei);
        stateTerms& to = terms[f].nei;
        if (k < 0 || mixture_.isStiff(k))
        {
            continue;
        }
        const scalar F = burntBehind(i, k);
        mixture_.states(k, 1, &w.rho, &w.p, &to.K, &to.rhoE, &to.strength, &F);
        if (!(to.K > 0.01 * tb_[i].K))
        {
            w = Wb_[i];
            to = tb_[i];
        }
    }
}

void Foam::mpm::eulerianFluids::setSoftness()
{
    const label nCells = mesh_.nCells(), nInternal = mesh_.nInternalFaces();
    const boolList& near = interfaces_->near();
    const auto soften = [&](const label at, const gasState& w, const scalar K, const scalar z)
    {
        if (interfaces_->single()[at] < 0 && !near[at] && K * w.rho < sqr(z))
        {
            soft_[at] = std::sqrt(K * w.rho) / z;
            softened_.append(at);
        }
    };
    for (const label at : softened_)
    {
        soft_[at] = 1;
    }
    softened_.clear();
    for (const label c : interfaces_->cells())
    {
        soften(c, W_[c], t_[c].K, z_[c]);
    }
    for (const label f : faces_.coupled)
    {
        const label i = f - nInternal;
        soften(nCells + i, Wb_[i], tb_[i].K, zB_[i]);
    }
}

//- Share of mu over Co^2 that slow flow keeps between reconstructed sides, where a limited slope
//  is no prediction of p*. With 0 noise of 1e-4 m/s in air of 34 m/s, 40 x 40 boxes, vanLeer,
//  was 0.003, 1.4 and 2.3 m/s after 1 s with Co = 0.4, 0.6 and 0.8, in water of 25 m/s a little
//  less; with 0.06 0.0003, 0.03, 1.9; 0.1 0.0002, 0.001, 0.005; 0.15 0.0001, 0.0003, 0.0005.
//  The tip of a dam break on 10 cells is later by 0.3, 1.1, 2.3 % with 0.1, 0.7, 2.0, 3.1 % with
//  0.15; a stiff disc in water has 0.9 of its acceleration, 0.95 before (lightInWater)
static constexpr Foam::scalar leastPerCo2 = 0.1;

//- Share of mu that slow flow keeps, of two sides of impedance z
static inline Foam::scalar lowMachShare(
    const Foam::mpm::gasState& L, const Foam::scalar zL, const Foam::mpm::gasState& R,
    const Foam::scalar zR)
{
    using namespace Foam;
    return min(scalar(1), max(mag(L.u) * L.rho / zL, mag(R.u) * R.rho / zR));
}

inline void Foam::mpm::eulerianFluids::face(
    const label f, const gasState& L, const gasState& R, const scalar pL, const scalar pR,
    const scalar zL, const scalar zR, const scalar least)
{
    const vector& S = S_[f];
    const scalar uL = (L.u & S) * faces_.invMagS[f], uR = (R.u & S) * faces_.invMagS[f];
    const scalar iSum = 1 / (zL + zR);
    scalar mu = zL * zR * iSum;
    if (lowMach_)
    {
        mu *= max(least, lowMachShare(L, zL, R, zR));
    }
    phi_[f] = faces_.magS[f] * (zL * uL + zR * uR + (pL - pR)) * iSum;
    pStar_[f] = (zR * pL + zL * pR) * iSum + mu * (uL - uR);
}

void Foam::mpm::eulerianFluids::porousFace(
    const label f, const label N, const label i, const scalar dt, const solidOnFaces& pores)
{
    const label P = mesh_.faceOwner()[f];
    const labelList& major = interfaces_->major();
    const gasState& WN = i < 0 ? W_[N] : Wb_[i];
    const scalar zN = i < 0 ? z_[N] : zB_[i], KN = i < 0 ? t_[N].K : tb_[i].K;
    const bool heavy = jump_.size(), same = major[P] >= 0 && major[P] == major[N];
    const scalar wP = heavy ? weight_[f] : 0, wN = heavy ? wP - jump_[f] : 0;
    const scalar z = max(z_[P], zN);
    const impedanceFlux::porousSide L{W_[P],        t_[P].K,   same ? z : z_[P],
                                      W_[P].p + wP, theta_[P], V_[P]};
    const impedanceFlux::porousSide R{WN,
                                      KN,
                                      same ? z : zN,
                                      WN.p + wN,
                                      i < 0 ? theta_[N] : thetaB_[i],
                                      i < 0 ? V_[N] : faces_.Vb[i]};
    const scalar chi = share_ * chi_ * max(liquid(z_[P], W_[P]), liquid(zN, WN));
    const scalar low = lowMachSolids_ ? lowMachShare(W_[P], z_[P], WN, zN) : 1;
    const mpm::faceFlux::result to{phi_, pStar_, out_};
    if (pores.area)
    {
        porousFlux_.porousFace<true>(f, L, R, dt, pores, chi, low, to);
    }
    else
    {
        porousFlux_.porousFace<false>(f, L, R, dt, pores, chi, low, to);
    }
}

template<bool Porous, bool Heavy>
void Foam::mpm::eulerianFluids::insideFaces(const scalar dt, const solidOnFaces* pores)
{
    const label nInternal = mesh_.nInternalFaces(), nCells = mesh_.nCells();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const labelList& major = interfaces_->major();
    const bool upwind = reconstruction_.upwind(), soft = softened_.size();
    const scalar least = leastPerCo2 * sqr(dt * courantRate());
    reconstruction::sides* const sides = reconstruction_.ownSides().data();
    const reconstruction::sideTerms* const terms = reconstruction_.terms().cdata();

    // N, and the state behind it: from the first boundary face on, of the other side
    const auto one =
        [&](const label f, const label N, gasState& WN, const scalar zN, const scalar KN)
    {
        const label P = own[f], k = major[P], kN = major[N];
        const bool first = upwind || first_[P] || first_[N];
        const gasState& L = first ? W_[P] : sides[f].own;
        const gasState& R = first ? WN : sides[f].nei;
        scalar zL = z_[P], zR = zN;
        if (!first)
        {
            const reconstruction::sideTerms* t = terms + f;
            const scalar KL = k < 0 ? 0 : sideK(k, sides[f].own, t, true, W_[P], t_[P].K);
            const scalar KR = kN < 0 ? 0 : sideK(kN, sides[f].nei, t, false, WN, KN);
            zL = k < 0 ? zL : L.rho * KL;
            zR = kN < 0 ? zR : R.rho * KR;
            if (k >= 0 && k == kN)
            {
                zL = zR = std::sqrt(max(zL, zR));
            }
            else
            {
                zL = k < 0 ? zL : std::sqrt(zL);
                zR = kN < 0 ? zR : std::sqrt(zR);
            }
        }
        else if (k >= 0 && k == kN)
        {
            zL = zR = max(zL, zR);
        }
        if (soft)
        {
            zL *= soft_[P];
            zR *= soft_[N];
        }
        const scalar wP = Heavy ? weight_[f] : 0;
        const scalar pR = R.p + (Heavy ? wP - jump_[f] : 0);
        face(f, L, R, L.p + wP, pR, zL, zR, first ? 0 : least);
    };
    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        if (Porous && (near_[P] || near_[N]))
        {
            porousFace(f, N, -1, dt, *pores);
        }
        else
        {
            one(f, N, W_[N], z_[N], t_[N].K);
        }
        out_[P] += max(phi_[f], scalar(0));
        out_[N] -= min(phi_[f], scalar(0));
    }
    for (const label f : faces_.coupled)
    {
        const label P = own[f], i = f - nInternal, N = nCells + i;
        if (Porous && (near_[P] || near_[N]))
        {
            porousFace(f, N, i, dt, *pores);
        }
        else
        {
            one(f, N, Wb_[i], zB_[i], tb_[i].K);
        }
        out_[P] += max(phi_[f], scalar(0));
    }
}

void Foam::mpm::eulerianFluids::boundaryFaces(const solidOnFaces* pores)
{
    const label nInternal = mesh_.nInternalFaces();
    const bool upwind = reconstruction_.upwind();
    for (const label f : faces_.boundary)
    {
        const label P = mesh_.faceOwner()[f], i = f - nInternal;
        const vector& S = S_[f];
        const bool first = upwind || first_[P];
        const bool close = pores && near_[P];
        const label k = first ? -1 : interfaces_->major()[P];
        gasState& side = reconstruction_.ownSides()[f].own;
        const scalar K =
            k < 0 ? 0 : sideK(k, side, reconstruction_.terms().cdata() + f, true, W_[P], t_[P].K);
        const gasState& L = first ? W_[P] : side;
        const gasState& B = Wb_[i];
        const scalar u = B.u & S;
        phi_[f] = u;
        pStar_[f] = B.p;
        if (close)
        {
            // Without an area of the solid the fluid of its share goes with it
            phi_[f] *= 1 - pores->thetaS[f];
            if (pores->area)
            {
                phi_[f] += pores->thetaS[f] * pores->uS[f] * faces_.magS[f];
            }
        }
        if (faces_.wall[i])
        {
            scalar z = k < 0 ? z_[P] : std::sqrt(L.rho * K);
            if (close)
            {
                z *= theta_[P] / max(theta_[P], 1 - pores->thetaS[f]);
            }
            else
            {
                z *= soft_[P];
            }
            pStar_[f] = L.p + (jump_.size() ? weight_[f] : scalar(0))
                + z * ((L.u & S) - u) / faces_.magS[f];
        }
        out_[P] += max(phi_[f], scalar(0));
    }
}

void Foam::mpm::eulerianFluids::widenFirst()
{
    boolList near(mesh_.nPoints(), false);
    const label nCells = mesh_.nCells();
    for (label c = 0; c < nCells; ++c)
    {
        if (first_[c])
        {
            for (const label p : mesh_.cellPoints()[c])
            {
                near[p] = true;
            }
        }
    }
    syncTools::syncPointList(mesh_, near, orEqOp<bool>(), false);
    forAll(near, p)
    {
        if (near[p])
        {
            for (const label c : mesh_.pointCells()[p])
            {
                first_[c] = true;
            }
        }
    }
    swapFirst();
}

void Foam::mpm::eulerianFluids::swapFirst()
{
    const label nCells = mesh_.nCells(), nInternal = mesh_.nInternalFaces();
    scalarField behind(Wb_.size(), 0);
    for (const label f : faces_.coupled)
    {
        behind[f - nInternal] = first_[mesh_.faceOwner()[f]];
    }
    coupled_.swap(behind);
    for (const label f : faces_.coupled)
    {
        first_[nCells + f - nInternal] = behind[f - nInternal] > 0.5;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianFluids::faceFlux(const scalar dt, const solidOnFaces* pores)
{
    const noTraps guard;
    interfaces_->update(contents());
    setSoftness();
    setJumps();
    first_ = interfaces_->near();
    for (const label c : torn_)
    {
        first_[c] = true;
    }
    if (jump_.size() && n_ > 1 && reconstruction_.byCells())
    {
        widenFirst();
    }
    else if (anyTorn_)
    {
        swapFirst();
    }
    if (pores)
    {
        porous_ = true;
        markNearSolid(*pores);
        forAll(first_, i)
        {
            first_[i] = first_[i] || near_[i];
        }
    }
    if (!reconstruction_.upwind())
    {
        reconstruction_.update(
            dt, {nullptr, W_, Wb_, t_, tb_, jump_.size() ? &jump_ : nullptr, g_}, rho0_, U_, p_,
            n_ > 1 || pores ? &first_ : nullptr);
        sideTerms();
    }
    out_ = 0;
    const bool heavy = jump_.size();
    if (given_)
    {
        givenFaces();
    }
    else if (pores)
    {
        heavy ? insideFaces<true, true>(dt, pores) : insideFaces<true, false>(dt, pores);
    }
    else
    {
        heavy ? insideFaces<false, true>(dt, pores) : insideFaces<false, false>(dt, pores);
    }
    boundaryFaces(pores);
    farFaces(pores, &first_);
    outflow_ = out_;
    limitOutflow(dt, pores);
    if (limits_)
    {
        outflow_ *= out_;
    }
}
