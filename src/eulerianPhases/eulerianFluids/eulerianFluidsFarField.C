/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianFluids.H"
#include "noTraps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::farField::medium::part Foam::mpm::eulerianFluids::partOf
(
    const label k,
    const scalar Y,
    const scalar rho,
    const scalar p,
    const scalar F
) const
{
    // n by a step of 1e-4 along the isentrope
    const auto K = [&](const scalar rho, const scalar p)
    {
        return rho*fluidMixture::c2(mixture_.at(k, rho, F), rho, p);
    };
    const scalar K0 = K(rho, p);
    const scalar K1 = K(rho*(1 + 1e-4), p + 1e-4*K0);
    const scalar n = min(max((K1 - K0)/(1e-4*K0), scalar(0.5)), scalar(50));
    return {Y, rho, K0, n};
}


Foam::mpm::farField::state Foam::mpm::eulerianFluids::farState
(
    const label i,
    const gasState& L,
    const scalar z
)
{
    const farField::face& a = far_->faces()[i];
    const label c = mesh_.faceOwner()[a.f], b = a.f - mesh_.nInternalFaces();
    const scalar pFar = far_->p(i);
    const bool ofCell = alphaB_[n_*b] < 0;
    farField::medium of;
    of.outside =
        !ofCell && farField::fixes(alpha_[0].boundaryField()[a.patch]);

    // The shares of the conditions at the pressure far away
    const auto given = [&]
    {
        of.size = 0;
        of.p = pFar;
        FixedList<scalar, fluidMixture::most> rho;
        scalar all = 0;
        for (label k = 0; k < n_; ++k)
        {
            rho[k] =
                density(k, state_[k].boundaryField()[a.patch][a.i], pFar);
            all += alphaB_[n_*b + k]*rho[k];
        }
        for (label k = 0; k < n_; ++k)
        {
            const scalar m = alphaB_[n_*b + k]*rho[k];
            if (m > 0)
            {
                of.add(partOf(k, m/all, rho[k], pFar, burntBehind(b, k)));
            }
        }
    };
    if (of.outside)
    {
        given();
    }
    else
    {
        of.p = W_[c].p;
        for (label k = 0; k < n_; ++k)
        {
            const scalar m = mass_[n_*c + k];
            if (m > 0)
            {
                const scalar rho = m/part_[n_*c + k];
                of.add(partOf(k, m/rho_[c], rho, of.p, burntOf(c, k)));
            }
        }
    }
    farField::state s(far_->at(i, L, z, of));
    if (ofCell)
    {
        return s;
    }
    if (s.u < 0 && !of.outside)
    {
        given();
    }
    if (s.u < 0)
    {
        // Densities at p*, shares as given
        s.behind.rho = 0;
        for (label k = 0, j = 0; k < n_; ++k)
        {
            if (alphaB_[n_*b + k] > 0)
            {
                rhoB_[n_*b + k] = of.rho(j++, s.p);
                s.behind.rho += alphaB_[n_*b + k]*rhoB_[n_*b + k];
            }
        }
    }
    return s;
}


void Foam::mpm::eulerianFluids::updateFarStates()
{
    forAll(far_->faces(), i)
    {
        const farField::face& a = far_->faces()[i];
        const label c = mesh_.faceOwner()[a.f];
        gasState L(W_[c]);
        L.p += faceWeight(c, a.f);
        const farField::state s(farState(i, L, z_[c]));
        Wb_[a.f - mesh_.nInternalFaces()] = s.behind;
        p_.boundaryFieldRef()[a.patch][a.i] = s.p;
        U_.boundaryFieldRef()[a.patch][a.i] = s.behind.u;
    }
}


void Foam::mpm::eulerianFluids::farFaces(const solidOnFaces* pores)
{
    forAll(far_->faces(), i)
    {
        const label f = far_->faces()[i].f, c = mesh_.faceOwner()[f];
        const bool first = reconstruction_.upwind() || first_[c];
        gasState L(first ? W_[c] : reconstruction_.faces()[f].own);
        const scalar z =
            first || interfaces_->major()[c] < 0
          ? z_[c]
          : std::sqrt(L.rho*reconstruction_.terms()[f].own.K);
        L.p += faceWeight(c, f);
        const farField::state s(farState(i, L, z));
        Wb_[f - mesh_.nInternalFaces()] = s.behind;
        if (!reconstruction_.upwind())
        {
            reconstruction_.setBehind(f, s.behind, nullptr);
        }
        setFarFace(f, s, pores);
    }
}

// ************************************************************************* //
