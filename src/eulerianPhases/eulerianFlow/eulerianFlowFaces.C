/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianFlow.H"

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::mpm::eulerianFlow::markNearSolid(const solidOnFaces& pores)
{
    // So much less than 1 is left behind by rounding and by a body that has
    // passed
    constexpr scalar full = 1 - 1e-3;

    const label nCells = mesh_.nCells();
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();

    near_.setSize(nCells + Wb_.size());
    for (label c = 0; c < nCells; ++c)
    {
        near_[c] = theta_[c] < full;
    }
    for (label f = 0; f < mesh_.nFaces(); ++f)
    {
        if (pores.at(f))
        {
            near_[own[f]] = true;
            if (f < nInternal)
            {
                near_[nei[f]] = true;
            }
        }
    }

    scalarField behind(Wb_.size());
    forAll(behind, i)
    {
        behind[i] = near_[own[nInternal + i]];
    }
    coupled_.swap(behind);
    forAll(behind, i)
    {
        near_[nCells + i] = behind[i] > 0.5;
    }
}


void Foam::mpm::eulerianFlow::setFarFace
(
    const label f,
    const farField::state& s,
    const solidOnFaces* pores
)
{
    const label c = mesh_.faceOwner()[f];
    scalar& out = out_[c];
    out -= max(phi_[f], scalar(0));
    phi_[f] = s.u*faces_.magS[f];
    pStar_[f] = s.p;
    if (pores && near_[c])
    {
        // As at other boundary faces
        phi_[f] *= 1 - pores->thetaS[f];
        if (pores->area)
        {
            phi_[f] += pores->thetaS[f]*pores->uS[f]*faces_.magS[f];
        }
    }
    out = max(out, scalar(0)) + max(phi_[f], scalar(0));
}


template<bool Porous>
void Foam::mpm::eulerianFlow::limitOutflow
(
    const scalar dt,
    const solidOnFaces* pores
)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const scalarField& V = mesh_.V();

    const auto most = [&](const label c)
    {
        const scalar theta = theta_[c];
        return
            Porous
          ? max(min(0.9*theta, theta - 0.5*pores->eps), pores->leak*theta)
          : 0.9;
    };

    limits_ = false;
    forAll(out_, c)
    {
        if (dt*out_[c] > most(c)*V[c])
        {
            limits_ = true;
            break;
        }
    }
    reduce(limits_, orOp<bool>());
    if (!limits_)
    {
        return;
    }

    forAll(out_, c)
    {
        const scalar allowed = most(c)*V[c]/dt;
        if (out_[c] > allowed)
        {
            out_[c] = allowed/out_[c];
            ++fixups_.limited;
        }
        else
        {
            out_[c] = 1;
        }
    }
    scalarField behind(Wb_.size(), 1);
    for (const label f : faces_.coupled)
    {
        behind[f - nInternal] = out_[own[f]];
    }
    coupled_.swap(behind);

    phiLimited_.setSize(phi_.size());
    for (label f = 0; f < nInternal; ++f)
    {
        const label donor = phi_[f] > 0 ? own[f] : nei[f];
        phiLimited_[f] = phi_[f]*out_[donor];
        fixups_.heldBack +=
            dt*mag(phi_[f] - phiLimited_[f])*W_[donor].rho;
    }
    for (const labelList* list : {&faces_.coupled, &faces_.boundary})
    {
        for (const label f : *list)
        {
            phiLimited_[f] =
                phi_[f]*(phi_[f] > 0 ? out_[own[f]] : behind[f - nInternal]);

            // What comes in is counted where it leaves
            if (phi_[f] > 0)
            {
                fixups_.heldBack +=
                    dt*(phi_[f] - phiLimited_[f])*W_[own[f]].rho;
            }
        }
    }
}

// * * * * * * * * * * * * * * * Instantiations  * * * * * * * * * * * * * * //

template void Foam::mpm::eulerianFlow::limitOutflow<true>
(
    const scalar,
    const solidOnFaces*
);

template void Foam::mpm::eulerianFlow::limitOutflow<false>
(
    const scalar,
    const solidOnFaces*
);

// ************************************************************************* //
