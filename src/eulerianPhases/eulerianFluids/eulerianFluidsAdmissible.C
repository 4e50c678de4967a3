// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "largestOfAll.H"
#include "noTraps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianFluids::contentOf(const label c, const label i, content& of) const
{
    const bool behind = i >= 0;
    of.w = behind ? &Wb_[i] : &W_[c];
    of.c = (behind ? zB_[i] : z_[c]) / of.w->rho;
    label several = 0;
    scalar sum = 0;
    for (label k = 0; k < n_; ++k)
    {
        const label j = n_ * (behind ? i : c) + k;
        const scalar alpha = behind ? alphaB_[j] : part_[j] / theta_[c];
        const scalar rho = behind ? rhoB_[j] : (mass_[j] > 0 ? mass_[j] / part_[j] : 0);
        const bool has = alpha > 0 && rho > 0;
        of.alpha[k] = has ? alpha : 0;
        of.m[k] = of.alpha[k] * rho;
        of.F[k] = behind ? burntBehind(i, k) : burntOf(c, k);
        of.e[k] = has ? of.alpha[k] * mixture_.energy(k, rho, of.w->p, of.F[k]) : 0;
        several += has;
        sum += of.e[k];
    }

    // By its energy, which the pressure of what is torn does not tell
    of.rhoE = behind ? tb_[i].rhoE : t_[c].rhoE;
    if (several != 1)
    {
        of.rhoE = sum;
        return;
    }
    for (label k = 0; k < n_; ++k)
    {
        of.e[k] = of.alpha[k] > 0 ? of.rhoE : scalar(0);
    }
}

bool Foam::mpm::eulerianFluids::canGet(const label c, const scalar heat) const
{
    // Above the energy beyond which no fluid is torn; without such a one anything goes
    scalar energy = rhoE_[c] - 0.5 * magSqr(rhoU_[c]) / rho_[c];
    for (label k = 0; k < n_; ++k)
    {
        const scalar part = part_[n_ * c + k];
        energy -= part > 0 ? part * min(mixture_.surely(k), ROOTVGREAT) : 0;
    }
    return keepsEnergy(energy, heat);
}

bool Foam::mpm::eulerianFluids::isState(const label k, const label c) const
{
    const scalar rho = rho_[c];
    if (!(rho > 0))
    {
        return false;
    }
    const scalar energy = rhoE_[c] - 0.5 * magSqr(rhoU_[c]) / rho;
    if (isGas(k))
    {
        return energy > 0 && energy < GREAT;
    }
    if (!(mag(energy) < GREAT))
    {
        return false;
    }
    const fluidMixture::torn& torn = mixture_.least(k);
    const bool wasTorn = torn.is(W_[c].rho, t_[c].strength);
    const scalar rhoOld = W_[c].rho * theta_[c], was = t_[c].rhoE * theta_[c];
    if (!wasTorn
        && (!firstTry_
            || (!mixture_.isStiff(k) && mag(rho - rhoOld) < 0.02 * rhoOld
                && mag(energy - was) < 0.02 * t_[c].strength)))
    {
        // Exponentials only where much has changed
        return true;
    }
    const scalar density = rho / theta_[c], e = energy / rho, F = burntOf(c, k);
    scalar p, c2, strength;
    mixture_.pressures(k, 1, &density, &e, &p, &c2, &strength, burnt_.empty() ? nullptr : &F);
    return !torn.is(density, strength) || (wasTorn && e > leastAround(c) - 0.05 * sqr(torn.c));
}

void Foam::mpm::eulerianFluids::spreadTears()
{
    // Nothing holds a surface under tension
    const label nCells = mesh_.nCells(), nInternal = mesh_.nInternalFaces();
    anyTorn_ = mixture_.tears() && onAny(torn_.size() > 0);
    if (!anyTorn_)
    {
        return;
    }
    boolList torn(nCells, false);
    for (const label c : torn_)
    {
        torn[c] = true;
    }
    scalarField behind(Wb_.size(), 0);
    for (const label f : faces_.coupled)
    {
        behind[f - nInternal] = torn[mesh_.faceOwner()[f]];
    }
    coupled_.swap(behind);
    const auto tear = [&](const label c)
    {
        const label k = torn[c] || !(W_[c].p < 0) ? -1 : only(c);
        if (k >= 0)
        {
            torn[c] = true;
            torn_.append(c);
            const fluidMixture::torn& least = mixture_.least(k);
            gasState& w = W_[c];
            w.p = least.p(w.rho);
            t_[c].K = t_[c].strength = least.c2 * w.rho;
            z_[c] = w.rho * std::sqrt(least.c2);
        }
    };
    const label nTorn = torn_.size();
    for (label i = 0; i < nTorn; ++i)
    {
        for (const label f : mesh_.cells()[torn_[i]])
        {
            if (f < nInternal)
            {
                tear(mesh_.faceOwner()[f]);
                tear(mesh_.faceNeighbour()[f]);
            }
        }
    }
    for (const label f : faces_.coupled)
    {
        if (behind[f - nInternal] > 0.5)
        {
            tear(mesh_.faceOwner()[f]);
        }
    }
}

Foam::scalar Foam::mpm::eulerianFluids::leastAround(const label c) const
{
    scalar least = t_[c].rhoE / W_[c].rho;
    const label nInternal = mesh_.nInternalFaces();
    for (const label f : mesh_.cells()[c])
    {
        const label i = f - nInternal, P = mesh_.faceOwner()[f];
        const label N = i >= 0 || P != c ? P : mesh_.faceNeighbour()[f];
        least = min(least, i >= 0 ? tb_[i].rhoE / Wb_[i].rho : t_[N].rhoE / W_[N].rho);
    }
    return least;
}

void Foam::mpm::eulerianFluids::keepOld(const solidOnFaces* pores)
{
    const DynamicList<label>& cells = interfaces_->cells();
    slotOld_.setSize((2 * n_ + 6) * cells.size());
    scalar* to = slotOld_.begin();
    for (const label c : cells)
    {
        to = std::copy_n(part_.cdata() + n_ * c, n_, to);
        to = std::copy_n(mass_.cdata() + n_ * c, n_, to);
        *to++ = rho_[c];
        for (direction d = 0; d < 3; ++d)
        {
            *to++ = rhoU_[c][d];
        }
        *to++ = rhoE_[c];
        *to++ = relaxedP_[c];
    }
    thetaOld_.setSize(0);
    if (pores)
    {
        thetaOld_ = theta_;
    }
    burnt_.keep();
    lambda_.keep();
    old_.done = fixups_;
    if (flows_)
    {
        old_.gained = *flows_;
    }
    old_.dropped = dropped_;
    old_.relaxed = relaxed_;
    old_.voids = voids_;
}

void Foam::mpm::eulerianFluids::restore(const scalar dt)
{
    const labelList& slot = interfaces_->slot();
    const labelList& single = interfaces_->single();
    if (thetaOld_.size())
    {
        theta_ = thetaOld_;
    }
    forAll(sums_, c)
    {
        const scalar h = dt / V_[c];
        rho_[c] += h * sums_[c].rho;
        rhoU_[c] += h * sums_[c].rhoU;
        rhoE_[c] += h * sums_[c].rhoE;
    }
    for (const oldState& old : bad_)
    {
        rho_[old.c] = old.rho;
        rhoU_[old.c] = old.rhoU;
        rhoE_[old.c] = old.rhoE;
    }
    forAll(slot, c)
    {
        if (slot[c] < 0)
        {
            mass_[n_ * c + single[c]] = rho_[c];
            part_[n_ * c + single[c]] = theta_[c];
        }
    }
    const scalar* from = slotOld_.cdata();
    for (const label c : interfaces_->cells())
    {
        std::copy_n(from, n_, part_.begin() + n_ * c);
        std::copy_n(from + n_, n_, mass_.begin() + n_ * c);
        from += 2 * n_;
        rho_[c] = *from++;
        for (direction d = 0; d < 3; ++d)
        {
            rhoU_[c][d] = *from++;
        }
        rhoE_[c] = *from++;
        relaxedP_[c] = *from++;
    }
    burnt_.restore();
    lambda_.restore();
    fixups_ = old_.done;
    if (flows_)
    {
        *flows_ = old_.gained;
    }
    dropped_ = old_.dropped;
    relaxed_ = old_.relaxed;
    voids_ = old_.voids;
}

bool Foam::mpm::eulerianFluids::boundFaces(const solidOnFaces* pores)
{
    const label nInternal = mesh_.nInternalFaces(), nCells = mesh_.nCells();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    if (!bounds_)
    {
        bounded_.setSize(mesh_.nFaces());
        bounded_ = false;
        bounds_ = true;
    }
    label more = 0;
    const auto bound = [&](const label f, const label P, const label N)
    {
        if (!bounded_[f] && !(pores && (near_[P] || near_[N])))
        {
            bounded_[f] = true;
            ++more;
        }
    };
    scalarField behind(Wb_.size(), 0);
    for (const oldState& old : bad_)
    {
        const label c = old.c;
        for (const label f : mesh_.cells()[c])
        {
            if (f < nInternal)
            {
                bound(f, own[f], nei[f]);
            }
            else
            {
                behind[f - nInternal] = 1;
            }
        }
    }
    for (const label f : faces_.boundary)
    {
        const label P = own[f], i = f - nInternal;
        if (behind[i] < 0.5 || first_[P] || (pores && near_[P]))
        {
            continue;
        }
        if (faces_.wall[i])
        {
            const vector& S = S_[f];
            pStar_[f] = W_[P].p + (jump_.size() ? weight_[f] : scalar(0))
                + z_[P] * ((W_[P].u - Wb_[i].u) & S) / faces_.magS[f];
        }
        bounded_[f] = true;
        ++more;
    }
    for (const oldState& old : bad_)
    {
        first_[old.c] = true;
    }
    if (!coupled_.empty())
    {
        scalarField other(behind);
        coupled_.swap(other);
        for (const label f : faces_.coupled)
        {
            const label i = f - nInternal;
            if (behind[i] > 0.5 || other[i] > 0.5)
            {
                bound(f, own[f], nCells + i);
            }
        }
    }
    fixups_.positive += more;
    old_.done.positive += more;
    return onAny(more > 0);
}

void Foam::mpm::eulerianFluids::addBounded(
    const label f, const label P, const label N, const label i, const scalar dt)
{
    content L, R;
    contentOf(P, -1, L);
    contentOf(N, i, R);
    const scalar magS = faces_.magS[f];
    const vector n(S_[f] / magS);
    const scalar uL = L.w->u & n, uR = R.w->u & n;
    const scalar wP = jump_.size() ? weight_[f] : scalar(0);
    const scalar pL = L.w->p + wP, pR = R.w->p + (jump_.size() ? wP - jump_[f] : scalar(0));

    // Speeds that a strong shock into either side does not outrun
    constexpr scalar shock = 1.5;
    scalar cL = L.c, cR = R.c;
    if (pR > pL)
    {
        cL += shock * max((pR - pL) / (R.w->rho * cR) + uL - uR, 0.0);
        cR += shock * max((pL - pR) / (L.w->rho * cL) + uL - uR, 0.0);
    }
    else
    {
        cR += shock * max((pL - pR) / (L.w->rho * cL) + uL - uR, 0.0);
        cL += shock * max((pR - pL) / (R.w->rho * cR) + uL - uR, 0.0);
    }
    const scalar low = min(min(uL - cL, uR - cR), 0.0);
    const scalar high = max(max(uL + cL, uR + cR), 0.0);
    const scalar width = high - low;

    // Two streams
    const scalar out = magS * high * (uL - low) / width;
    const scalar in = magS * low * (high - uR) / width;
    phi_[f] = out + in;
    if (limits_)
    {
        phiLimited_[f] = phi_[f];
    }
    pStar_[f] = (high * pL - low * pR) / width;

    const label a = interfaces_->slot()[P], b = i < 0 ? interfaces_->slot()[N] : -1;
    sums& s = face_;
    s = sums{0, Zero, 0};
    for (label k = 0; k < n_; ++k)
    {
        const scalar volume = out * L.alpha[k] + in * R.alpha[k];
        const scalar m = out * L.m[k] + in * R.m[k];
        const scalar e = out * L.e[k] + in * R.e[k];
        faceMass_[k] = m;
        if (carries_)
        {
            carry(k, f, out * L.m[k], P, -1);
            carry(k, f, in * R.m[k], N, i);
        }
        s.rho += m;
        const auto add = [&](const label slot, const label c, const scalar sign)
        {
            if (slot >= 0)
            {
                fluidMixture::share& to = shares_[n_ * slot + k];
                const scalar h = sign * dt / V_[c];
                to.A -= h * volume;
                to.m -= h * m;
                to.e0 -= h * e;
            }
        };
        add(a, P, 1);
        add(b, N, -1);
    }
    const scalar rhoL = L.w->rho, rhoR = R.w->rho;
    s.rhoU = out * rhoL * L.w->u + in * rhoR * R.w->u;
    s.rhoE = out * (L.rhoE + 0.5 * rhoL * magSqr(L.w->u))
        + in * (R.rhoE + 0.5 * rhoR * magSqr(R.w->u))
        + magS * (high * pL * uL - low * pR * uR) / width;
}
