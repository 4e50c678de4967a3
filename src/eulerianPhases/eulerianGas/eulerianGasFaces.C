// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianGas.H"
#include "noTraps.H"
#include "emptyPolyPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianGas::generalBoundary(const label patchi)
{
    const polyPatch& pp = mesh_.boundaryMesh()[patchi];
    const label start = pp.start() - mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const fvPatchScalarField& p = p_.boundaryField()[patchi];
    fvPatchScalarField& rho0 = rho0_.boundaryFieldRef()[patchi];

    if (!thermo_.hasEnergy())
    {
        scalarField rho(pp.size());
        forAll(rho, i)
        {
            rho[i] = W_[own[pp.start() + i]].rho;
        }
        thermo_.equation().densities(rho.size(), p.cdata(), rho.data());
        forAll(rho, i)
        {
            rho0[i] = rho[i];
        }
    }
    forAll(pp, i)
    {
        Wb_[start + i] = gasState{rho0[i], U_.boundaryField()[patchi][i], p[i]};
    }
}

void Foam::mpm::eulerianGas::generalTerms()
{
    const noTraps guard;
    thermo_.terms(
        Wb_.size(), [&](const label i) -> const gasState& { return Wb_[i]; },
        [&](const label i) -> stateTerms& { return tb_[i]; });
    forAll(psi_.boundaryField(), patchi)
    {
        fvPatchScalarField& psi = psi_.boundaryFieldRef()[patchi];
        const label start = mesh_.boundaryMesh()[patchi].start() - mesh_.nInternalFaces();
        forAll(psi, i)
        {
            psi[i] = Wb_[start + i].rho / tb_[start + i].K;
        }
    }
}

void Foam::mpm::eulerianGas::updateBoundaryStates()
{
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
        if (pp.coupled())
        {
            for (label i = 0; i < pp.size(); ++i)
            {
                Wb_[start + i] = W_[own[pp.start() + i]];
                thetaB_[start + i] = theta_[own[pp.start() + i]];
            }
            continue;
        }
        if (!thermo_.isGammaLaw())
        {
            generalBoundary(patchi);
            continue;
        }
        const fvPatchScalarField& p = p_.boundaryField()[patchi];
        const fvPatchVectorField& U = U_.boundaryField()[patchi];
        fvPatchScalarField& rho0 = rho0_.boundaryFieldRef()[patchi];
        fvPatchScalarField& psi = psi_.boundaryFieldRef()[patchi];
        for (label i = 0; i < pp.size(); ++i)
        {
            const scalar T = T_ ? T_->boundaryField()[patchi][i] : 1;
            gasState& w = Wb_[start + i];
            w.p = p[i];
            w.u = U[i];
            w.rho = thermo_.rho(p[i], T);
            rho0[i] = w.rho;
            psi[i] = w.rho / w.p;
            thetaB_[start + i] = theta_[own[pp.start() + i]];
        }
    }
    updateFarStates();
    for (const farField::face& a : far_->faces())
    {
        const gasState& w = Wb_[a.f - nInternal];
        rho0_.boundaryFieldRef()[a.patch][a.i] = w.rho;
        psi_.boundaryFieldRef()[a.patch][a.i] = w.rho / w.p;
    }
    if (!coupled_.empty())
    {
        coupled_.swap(Wb_, {{thetaB_.data(), porous_ ? 1 : 0}});
        forAll(patches, patchi)
        {
            const polyPatch& pp = patches[patchi];
            if (!pp.coupled())
            {
                continue;
            }
            fvPatchScalarField& rho0 = rho0_.boundaryFieldRef()[patchi];
            fvPatchVectorField& U = U_.boundaryFieldRef()[patchi];
            fvPatchScalarField& p = p_.boundaryFieldRef()[patchi];
            forAll(pp, i)
            {
                const gasState& w = Wb_[pp.start() - nInternal + i];
                rho0[i] = w.rho;
                U[i] = w.u;
                p[i] = w.p;
            }
        }
    }
    if (!thermo_.isGammaLaw())
    {
        generalTerms();
    }
}

void Foam::mpm::eulerianGas::updateFields()
{
    U_.correctBoundaryConditions();
    p_.correctBoundaryConditions();
    if (T_)
    {
        T_->correctBoundaryConditions();
    }
    if (readsRho())
    {
        rho0_.correctBoundaryConditions();
    }
}

Foam::mpm::farField::medium::part
Foam::mpm::eulerianGas::partOf(const scalar rho, const scalar p) const
{
    if (thermo_.isGammaLaw())
    {
        return {1, rho, thermo_.gamma() * p, thermo_.gamma()};
    }

    stateTerms t;
    const auto K = [&](const scalar rho, const scalar p)
    {
        const gasState w{rho, Zero, p};
        thermo_.terms(
            1, [&](const label) -> const gasState& { return w; },
            [&](const label) -> stateTerms& { return t; });
        return t.K;
    };
    return farField::medium::isentrope(1, rho, p, K);
}

Foam::mpm::farField::state
Foam::mpm::eulerianGas::farState(const label i, const gasState& L, const scalar z)
{
    const farField::face& a = far_->faces()[i];
    const gasState& w = W_[mesh_.faceOwner()[a.f]];
    const scalar pFar = far_->p(i);
    farField::medium of;
    of.p = w.p;
    of.outside = false;
    const volScalarField* field = readsRho() ? &rho0_ : thermo_.isGammaLaw() ? T_.get() : nullptr;
    const fvPatchScalarField* b = field ? &field->boundaryField()[a.patch] : nullptr;
    if (b && farField::fixes(*b))
    {
        of.p = pFar;
        of.outside = true;
        const scalar v = (*b)[a.i];
        of.add(partOf(readsRho() ? v : thermo_.rho(pFar, v), pFar));
    }
    else
    {
        of.add(partOf(w.rho, w.p));
    }
    farField::state s(far_->at(i, L, z, of));

    // What comes in by conditions that say so
    if (b && s.u < 0 && !of.outside && !isA<zeroGradientFvPatchScalarField>(*b))
    {
        const scalar v = (*b)[a.i];
        of.size = 0;
        of.p = pFar;
        of.add(partOf(readsRho() ? v : thermo_.rho(pFar, v), pFar));
        s.behind.rho = of.rho(s.p);
    }
    return s;
}

Foam::scalar Foam::mpm::eulerianGas::sideImpedance(const label f, const gasState& L) const
{
    const scalar K = t_.empty() ? thermo_.gamma() * L.p : reconstruction_.terms()[f].own.K;
    return std::sqrt(L.rho * K);
}

const Foam::mpm::stateTerms* Foam::mpm::eulerianGas::farTerms(const label i)
{
    if (t_.empty())
    {
        return nullptr;
    }
    thermo_.terms(
        1, [&](const label) -> const gasState& { return Wb_[i]; },
        [&](const label) -> stateTerms& { return tb_[i]; });
    return &tb_[i];
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianGas::faceFlux(const scalar dt, const solidOnFaces* pores)
{
    const noTraps guard;

    if (pores)
    {
        if (!thermo_.isGammaLaw())
        {
            FatalErrorInFunction << "Gas " << name_ << " has an equationOfState: it runs without"
                                 << " solid only." << exit(FatalError);
        }
        porous_ = true;
        markNearSolid(*pores);
    }
    if (!reconstruction_.upwind())
    {
        reconstruction_.update(
            dt, {&thermo_, W_, Wb_, t_, tb_}, rho0_, U_, p_, pores ? &near_ : nullptr);
    }

    const mpm::faceFlux::result to{phi_, pStar_, out_};
    if (pores)
    {
        faceFlux_->flux(allStates<false>(), {dt, theta_, thetaB_, near_, *pores}, to);
        farFaces(pores, &near_);
        limitOutflow(dt, pores);
        return;
    }
    if (thermo_.isGammaLaw())
    {
        faceFlux_->flux(allStates<false>(), to);
    }
    else
    {
        faceFlux_->flux(allStates<true>(), to);
    }
    farFaces(nullptr, nullptr);
    limitOutflow(dt, nullptr);
}
