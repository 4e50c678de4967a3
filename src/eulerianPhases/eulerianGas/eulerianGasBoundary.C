/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianGas.H"
#include "emptyPolyPatch.H"
#include "noTraps.H"

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
    thermo_.terms
    (
        Wb_.size(),
        [&](const label i) -> const gasState& { return Wb_[i]; },
        [&](const label i) -> stateTerms& { return tb_[i]; }
    );
    forAll(psi_.boundaryField(), patchi)
    {
        fvPatchScalarField& psi = psi_.boundaryFieldRef()[patchi];
        const label start =
            mesh_.boundaryMesh()[patchi].start() - mesh_.nInternalFaces();
        forAll(psi, i)
        {
            psi[i] = Wb_[start + i].rho/tb_[start + i].K;
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
            psi[i] = w.rho/w.p;
            thetaB_[start + i] = theta_[own[pp.start() + i]];
        }
    }
    updateFarStates();
    if (!coupled_.empty())
    {
        coupled_.swap(Wb_);
        if (porous_)
        {
            coupled_.swap(thetaB_);
        }
        forAll(patches, patchi)
        {
            const polyPatch& pp = patches[patchi];
            for (label i = 0; pp.coupled() && i < pp.size(); ++i)
            {
                const gasState& w = Wb_[pp.start() - nInternal + i];
                rho0_.boundaryFieldRef()[patchi][i] = w.rho;
                U_.boundaryFieldRef()[patchi][i] = w.u;
                p_.boundaryFieldRef()[patchi][i] = w.p;
            }
        }
    }
    if (!thermo_.isGammaLaw())
    {
        generalTerms();
    }
}


void Foam::mpm::eulerianGas::correctBoundaryFields()
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

// ************************************************************************* //
