// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "largestOfAll.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianFluids::setComposition(const scalar dt)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const labelList& slot = interfaces_->slot();
    const scalarField& phi = phiLimited();

    // Shares in the flux of faces between slots, and through coupled ones
    interfaces_->setTransverse(contents(), phi, outflow_, dt);
    DynamicList<scalar> shares(8 * n_ * interfaces_->cells().size());
    faceStart_.setSize(mesh_.nFaces());
    const fluidInterfaces::contents all(contents());
    const auto add = [&](const label f, const label D, const scalar* to, const scalar theta)
    {
        const label at = shares.size();
        faceStart_[f] = at;
        shares.setSize(at + n_);
        interfaces_->shares(all, f, D, own[f] == D, dt, phi[f], to, theta, shares.begin() + at);
    };
    const auto of = [&](const label c) { return part_.cdata() + n_ * c; };
    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        if (slot[P] >= 0 || slot[N] >= 0)
        {
            const label D = phi[f] > 0 ? P : N, to = phi[f] > 0 ? N : P;
            add(f, D, of(to), theta_[to]);
        }
    }
    for (const label f : faces_.boundary)
    {
        const label P = own[f];
        if (slot[P] >= 0)
        {
            const scalar* alpha = alphaB_.cdata() + n_ * (f - nInternal);
            if (phi[f] > 0)
            {
                add(f, P, alpha[0] < 0 ? of(P) : alpha, alpha[0] < 0 ? theta_[P] : 1);
            }
            else
            {
                const label at = shares.size();
                faceStart_[f] = at;
                shares.setSize(at + n_);
                if (alpha[0] < 0)
                {
                    interfaces_->sharesOfCell(all, f, P, shares.begin() + at);
                }
                else
                {
                    std::copy_n(alpha, n_, shares.begin() + at);
                }
            }
        }
    }
    if (!coupled_.empty())
    {
        // The donor's side says what leaves
        scalarField sent(n_ * Wb_.size(), 0);
        for (const label f : faces_.coupled)
        {
            const label P = own[f], i = f - nInternal;
            faceStart_[f] = -1;
            if (slot[P] < 0)
            {
                for (label k = 0; k < n_; ++k)
                {
                    sent[n_ * i + k] = k == interfaces_->single()[P];
                }
                continue;
            }
            if (phi[f] > 0)
            {
                add(f, P, alphaB_.cdata() + n_ * i, 1);
                std::copy_n(shares.cdata() + faceStart_[f], n_, sent.begin() + n_ * i);
            }
        }
        coupled_.swap(sent, n_);
        for (const label f : faces_.coupled)
        {
            if (slot[own[f]] >= 0 && faceStart_[f] < 0)
            {
                faceStart_[f] = shares.size();
                for (label k = 0; k < n_; ++k)
                {
                    shares.append(sent[n_ * (f - nInternal) + k]);
                }
            }
        }
    }
    faceShares_.transfer(shares);
}

void Foam::mpm::eulerianFluids::addFluids(const label f, const label P, const label N)
{
    const label nInternal = mesh_.nInternalFaces();
    const scalar phi = phiLimited()[f];
    const bool out = phi > 0;
    const bool behind = f >= nInternal && !out;
    const label D = out ? P : N, i = f - nInternal;
    const bool first =
        reconstruction_.upwind() || first_[P] || first_[f < nInternal ? N : mesh_.nCells() + i];
    const gasState& w0 = behind ? Wb_[i] : W_[D];
    const gasState& w = first ? w0
        : out                 ? reconstruction_.faces()[f].own
                              : reconstruction_.faces()[f].nei;
    const scalar* alpha = faceShares_.cdata() + faceStart_[f];

    // The largest fluid has the reconstructed state, of others there is no
    // more than in the cell
    const bool one = !first && interfaces_->major()[behind ? mesh_.nCells() + i : D] >= 0;
    const scalar denser = one ? w.rho / w0.rho : 1;

    // Shares and densities of where it comes from: behind the face, or a cell
    const bool given = behind && alphaB_[n_ * i] >= 0;
    const label c = behind ? P : D, slot = interfaces_->slot()[c];
    const scalar* part = (given ? alphaB_.cdata() + n_ * i : part_.cdata() + n_ * c);
    const scalar* density = given ? rhoB_.cdata() + n_ * i
        : slot >= 0               ? densities_.cdata() + n_ * slot
                                  : nullptr;
    const scalar half = given ? 0.5 : 0.5 * theta_[c];
    const label alone = behind ? -1 : interfaces_->single()[D];
    const bool torn = alone >= 0 && isTorn(D, alone);
    sums& s = face_;
    s = sums{0, Zero, 0};
    const label a = interfaces_->slot()[P];
    const label b = f < nInternal ? interfaces_->slot()[N] : -1;
    for (label k = 0; k < n_; ++k)
    {
        faceMass_[k] = 0;
        if (!(alpha[k] > 0))
        {
            continue;
        }
        const bool large = one && part[k] > half;
        const scalar rho = (large ? denser : 1) * (density ? density[k] : W_[c].rho);
        const scalar volume = phi * alpha[k];
        const scalar m = volume * rho;
        const scalar F = given ? burntBehind(i, k) : burntOf(c, k);
        const scalar e = torn && k == alone
            ? volume * t_[D].rhoE
            : volume * mixture_.energy(k, rho, large ? w.p : w0.p, F);
        faceMass_[k] = m;
        if (carries_)
        {
            carry(k, f, m, c, given ? i : -1);
        }
        s.rho += m;
        s.rhoE += e;
        const auto add = [&](const label slot, const scalar sign)
        {
            fluidMixture::share& to = shares_[n_ * slot + k];
            const scalar h = sign * perVolume_[slot];
            to.A -= h * volume;
            to.m -= h * m;
            to.e0 -= h * e;
        };
        if (a >= 0)
        {
            add(a, 1);
        }
        if (b >= 0)
        {
            add(b, -1);
        }
    }
    s.rhoU = s.rho * w.u;
    s.rhoE += 0.5 * s.rho * magSqr(w.u) + pStar_[f] * working()[f];
}

inline void Foam::mpm::eulerianFluids::addAlone(const label f, const gasState& w, const scalar rhoE)
{
    const scalar phi = phiLimited()[f];
    face_.rho = phi * w.rho;
    face_.rhoU = face_.rho * w.u;
    face_.rhoE = phi * rhoE + 0.5 * face_.rho * magSqr(w.u) + pStar_[f] * working()[f];
}

template<bool Plain>
inline void Foam::mpm::eulerianFluids::addFace(
    const label c, const scalar sign, const label f, const scalar dt, const solidOnFaces* pores)
{
    sums& to = sums_[c];
    to.rho += sign * face_.rho;
    if (Plain)
    {
        to.rhoU += sign * (face_.rhoU + (pStar_[f] - W_[c].p) * S_[f]);
        to.rhoE += sign * face_.rhoE;
        return;
    }

    // The pressure acts on what the solid leaves of the face
    vector open(S_[f]);
    if (pores)
    {
        open *= 1 - pores->thetaS0[f];
        if (pores->area0)
        {
            open -= pores->area0[f];
        }
        volumes& v = volumes_[c];
        v.phi += sign * phi_[f];
        v.limited += sign * phiLimited()[f];
        v.solid += sign * pores->phiS[f];
    }
    // As setJumps() has it, from the side of the cell
    const scalar weight = jump_.empty() ? 0 : weight_[f] - (sign < 0 ? jump_[f] : 0);
    to.rhoU += sign * (face_.rhoU + (pStar_[f] - W_[c].p - weight) * open);
    to.rhoE += sign * face_.rhoE;
    if (jump_.size())
    {
        const vector d(mesh_.faceCentres()[f] - mesh_.cellCentres()[c]);
        const scalar work = face_.rho * (g_ & d);
        to.rhoE -= sign * work;
        if (flows_)
        {
            flows_->gravityWork += sign * dt * work;
            flows_->gravityImpulse += sign * dt * weight * open;
        }
    }
}

template<bool Plain>
void Foam::mpm::eulerianFluids::sumInside(const scalar dt, const solidOnFaces* pores)
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const labelList& slot = interfaces_->slot();
    const labelList& single = interfaces_->single();
    const bool upwind = reconstruction_.upwind();
    const reconstruction::sides* const sides = reconstruction_.faces().cdata();
    const reconstruction::sideTerms* const terms = reconstruction_.terms().cdata();
    const scalarField& limited = phiLimited();
    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        const label P = own[f], N = nei[f];
        const bool out = limited[f] > 0;
        if (bounds_ && bounded_[f])
        {
            addBounded(f, P, N, -1, dt);
        }
        else if (slot[P] >= 0 || slot[N] >= 0)
        {
            addFluids(f, P, N);
        }
        else
        {
            const label D = out ? P : N, k = single[P];
            if (upwind || first_[P] || first_[N])
            {
                addAlone(f, W_[D], t_[D].rhoE);
            }
            else
            {
                const gasState& w = out ? sides[f].own : sides[f].nei;
                addAlone(
                    f, w,
                    mixture_.isStiff(k) ? mixture_.stiff(k).energy(w.p)
                        : out           ? terms[f].own.rhoE
                                        : terms[f].nei.rhoE);
            }
            if (carries_)
            {
                carry(k, f, face_.rho, D, -1);
            }
        }
        addFace<Plain>(P, 1, f, dt, pores);
        addFace<Plain>(N, -1, f, dt, pores);
    }
}

void Foam::mpm::eulerianFluids::sumBoundary(const scalar dt, const solidOnFaces* pores)
{
    const vectorField& S = mesh_.faceAreas();
    const labelUList& own = mesh_.faceOwner();
    const labelList& slot = interfaces_->slot();
    const bool upwind = reconstruction_.upwind();
    const List<reconstruction::sides>& sides = reconstruction_.faces();
    for (const labelList* list : {&faces_.coupled, &faces_.boundary})
    {
        const bool coupled = list == &faces_.coupled;
        for (const label f : *list)
        {
            const label P = own[f], i = f - mesh_.nInternalFaces();
            const bool first = upwind || first_[P] || (coupled && first_[mesh_.nCells() + i]);
            if (coupled && bounds_ && bounded_[f])
            {
                addBounded(f, P, -1, i, dt);
            }
            else if (slot[P] >= 0)
            {
                addFluids(f, P, P);
            }
            else
            {
                const gasState& w = phiLimited()[f] > 0 ? (first ? W_[P] : sides[f].own)
                    : first || !coupled                 ? Wb_[i]
                                                        : sides[f].nei;
                const label k = interfaces_->single()[P];
                const bool out = phiLimited()[f] > 0;
                const scalar F = out ? burntOf(P, k) : burntBehind(i, k);
                addAlone(f, w, rhoEOf(k, w, F));
                if (carries_)
                {
                    carry(k, f, face_.rho, P, out ? -1 : i);
                }
            }
            addFace<false>(P, 1, f, dt, pores);
            if (flows_ && !coupled)
            {
                const scalar theta = pores ? 1 - pores->thetaS0[f] : 1;
                const scalar p = theta * pStar_[f] + (1 - theta) * W_[P].p;
                flows_->mass -= dt * face_.rho;
                flows_->fluids.setSize(n_, 0);
                for (label k = 0; k < n_; ++k)
                {
                    flows_->fluids[k] -= slot[P] >= 0   ? dt * faceMass_[k]
                        : interfaces_->single()[P] == k ? dt * face_.rho
                                                        : 0;
                }
                flows_->impulse -= dt * (face_.rhoU + p * S[f]);
                flows_->energy -= dt * face_.rhoE;
            }
        }
    }
    addWedgeSides(&first_);
}

Foam::mpm::flowGains Foam::mpm::eulerianFluids::layersOfFluids(const scalar dt)
{
    flows gained(addLayers(dt));
    gained.fluids.setSize(n_, 0);
    for (const farLayer::source& s : far_->layer().sources())
    {
        const label c = s.c, slot = interfaces_->slot()[c];
        for (label k = 0; k < n_; ++k)
        {
            const scalar m = mass_[n_ * c + k], theta = part_[n_ * c + k];
            if (!(m > 0))
            {
                continue;
            }
            gained.fluids[k] += V_[c] * s.strain * m;
            if (carries_)
            {
                burnt_.gain(k, c, V_[c] / dt * s.strain * m);
                lambda_.gain(k, c, V_[c] / dt * s.strain * m);
            }
            if (slot >= 0)
            {
                fluidMixture::share& to = shares_[n_ * slot + k];
                const scalar e = isTorn(c, k)
                    ? t_[c].rhoE
                    : mixture_.energy(k, m / theta, W_[c].p, burntOf(c, k));
                to.A += s.strain * theta;
                to.m += s.strain * m;
                to.e0 += s.strain * theta * e;
            }
        }
    }
    return gained;
}

void Foam::mpm::eulerianFluids::keepIsentrope(
    const label c, const label k, const scalar rho, const scalar p)
{
    const scalar gamma = mixture_.thermo(k).gamma();
    const scalar kinetic = 0.5 * magSqr(rhoU_[c]) / rho_[c];
    const scalar pNew = (gamma - 1) * (rhoE_[c] - kinetic) / theta_[c];
    const scalar pIsentropic = p * std::pow(rho_[c] / (theta_[c] * rho), gamma);
    if (!(pNew >= 0.3 * pIsentropic))
    {
        const scalar E = theta_[c] * pIsentropic / (gamma - 1) + kinetic;
        bookFixup(c, (E - rhoE_[c]) * V_[c]);
        rhoE_[c] = E;
        ++fixups_.isentropic;
    }
}

bool Foam::mpm::eulerianFluids::newStates(const scalar dt, const solidOnFaces* pores)
{
    const scalarField& V = mesh_.V();
    const labelList& slot = interfaces_->slot();
    const labelList& single = interfaces_->single();
    bad_.clear();
    FixedList<scalar, fluidMixture::most> surely;
    for (label k = 0; k < n_; ++k)
    {
        surely[k] = mixture_.surely(k);
    }
    forAll(sums_, c)
    {
        const scalar h = dt / V[c];
        const sums& s = sums_[c];
        const scalar rho = W_[c].rho;
        const scalar rhoOld = rho_[c], rhoEOld = rhoE_[c];
        const vector rhoUOld(rhoU_[c]);
        rho_[c] -= h * s.rho;
        rhoU_[c] -= h * s.rhoU;
        rhoE_[c] -= h * s.rhoE;
        if (pores)
        {
            changeTheta<true>(c, h, *pores);
        }
        if (slot[c] < 0)
        {
            const label k = single[c];
            mass_[n_ * c + k] = rho_[c];
            part_[n_ * c + k] = theta_[c];
            if (pores && near_[c] && isGas(k))
            {
                keepIsentrope(c, k, rho, W_[c].p);
            }

            // Sure without a division
            const scalar sure = 2 * rho_[c] * (rhoE_[c] - theta_[c] * surely[k]);
            if (!(rho_[c] > 0 && sure > magSqr(rhoU_[c]) && sure < GREAT) && !isState(k, c))
            {
                bad_.append(oldState{c, rhoOld, rhoEOld, rhoUOld});
            }
        }
    }
    forAll(interfaces_->cells(), s)
    {
        if (!relaxCell(s))
        {
            const label c = interfaces_->cells()[s];
            bad_.append(oldState{c, rho_[c], rhoE_[c], rhoU_[c]});
        }
    }
    return !onAny(bad_.size() > 0);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::eulerianFluids::advance(const scalar dt, const solidOnFaces* pores, const bool last)
{
    const noTraps guard;
    beside_ = pores;
    bounds_ = false;
    firstTry_ = true;
    lastTry_ = false;
    keepOld(pores);
    setComposition(dt);
    flows gained;
    for (;;)
    {
        startShares(dt);
        sums_ = sums{0, Zero, 0};
        if (pores)
        {
            volumes_.setSize(mesh_.nCells());
            volumes_ = volumes{0, 0, 0};
        }
        if (pores || jump_.size())
        {
            sumInside<false>(dt, pores);
        }
        else
        {
            sumInside<true>(dt, pores);
        }
        sumBoundary(dt, pores);
        gained = layersOfFluids(dt);
        burn(dt);
        burnOn(dt);
        if (newStates(dt, pores) || lastTry_)
        {
            break;
        }
        restore(dt);
        firstTry_ = false;
        if (!boundFaces(pores))
        {
            if (!last)
            {
                return false;
            }
            lastTry_ = true;
        }
    }
    if (flows_)
    {
        *flows_ += gained;
    }
    addViscosity(dt);
    if (given_)
    {
        keepMotion();
    }
    return true;
}
