/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianGas.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::farField::medium::part Foam::mpm::eulerianGas::partOf
(
    const scalar rho,
    const scalar p
) const
{
    if (thermo_.isGammaLaw())
    {
        return {1, rho, thermo_.gamma()*p, thermo_.gamma()};
    }

    // n by a step of 1e-4 along the isentrope
    stateTerms t;
    const auto K = [&](const gasState& w)
    {
        thermo_.terms
        (
            1,
            [&](const label) -> const gasState& { return w; },
            [&](const label) -> stateTerms& { return t; }
        );
        return t.K;
    };
    const scalar K0 = K({rho, Zero, p});
    const scalar K1 = K({rho*(1 + 1e-4), Zero, p + 1e-4*K0});
    return {1, rho, K0, min(max((K1 - K0)/(1e-4*K0), scalar(0.5)), scalar(50))};
}


Foam::mpm::farField::state Foam::mpm::eulerianGas::farState
(
    const label i,
    const gasState& L,
    const scalar K
) const
{
    const farField::face& a = far_->faces()[i];
    const gasState& w = W_[mesh_.faceOwner()[a.f]];
    const scalar pFar = far_->p(i);
    farField::medium of;
    of.p = w.p;
    of.outside = false;
    const volScalarField* field =
        readsRho() ? &rho0_ : thermo_.isGammaLaw() ? T_.get() : nullptr;
    const fvPatchScalarField* b =
        field ? &field->boundaryField()[a.patch] : nullptr;
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
    farField::state s(far_->at(i, L, std::sqrt(L.rho*K), of));

    // What comes in by conditions that say so
    if
    (
        b && s.u < 0 && !of.outside
     && !isA<zeroGradientFvPatchScalarField>(*b)
    )
    {
        const scalar v = (*b)[a.i];
        of.size = 0;
        of.p = pFar;
        of.add(partOf(readsRho() ? v : thermo_.rho(pFar, v), pFar));
        s.behind.rho = of.rho(s.p);
    }
    return s;
}


void Foam::mpm::eulerianGas::updateFarStates()
{
    forAll(far_->faces(), i)
    {
        const farField::face& a = far_->faces()[i];
        const label c = mesh_.faceOwner()[a.f];
        gasState L(W_[c]);
        const scalar K = t_.empty() ? thermo_.gamma()*L.p : t_[c].K;
        L.p += faceWeight(c, a.f);
        const farField::state s(farState(i, L, K));
        Wb_[a.f - mesh_.nInternalFaces()] = s.behind;
        thetaB_[a.f - mesh_.nInternalFaces()] = theta_[c];
        p_.boundaryFieldRef()[a.patch][a.i] = s.p;
        U_.boundaryFieldRef()[a.patch][a.i] = s.behind.u;
        rho0_.boundaryFieldRef()[a.patch][a.i] = s.behind.rho;
        psi_.boundaryFieldRef()[a.patch][a.i] = s.behind.rho/s.p;
    }
}


void Foam::mpm::eulerianGas::farFaces(const solidOnFaces* pores)
{
    forAll(far_->faces(), i)
    {
        const label f = far_->faces()[i].f, c = mesh_.faceOwner()[f];
        const bool first = reconstruction_.upwind() || (pores && near_[c]);
        gasState L(first ? W_[c] : reconstruction_.faces()[f].own);
        const scalar K =
            t_.empty() ? thermo_.gamma()*L.p
          : first ? t_[c].K : reconstruction_.terms()[f].own.K;
        L.p += faceWeight(c, f);
        const farField::state s(farState(i, L, K));
        gasState& behind = Wb_[f - mesh_.nInternalFaces()];
        behind = s.behind;
        stateTerms* t = nullptr;
        if (t_.size())
        {
            t = &tb_[f - mesh_.nInternalFaces()];
            thermo_.terms
            (
                1,
                [&](const label) -> const gasState& { return behind; },
                [&](const label) -> stateTerms& { return *t; }
            );
        }
        if (!reconstruction_.upwind())
        {
            reconstruction_.setBehind(f, behind, t);
        }
        setFarFace(f, s, pores);
    }
}

// ************************************************************************* //
