/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianFlow.H"
#include "noTraps.H"

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::DynamicList<Foam::mpm::eulerianFlow::column>
Foam::mpm::eulerianFlow::columns()
{
    DynamicList<column> all;
    all.append({theta_.data(), 1});
    all.append({rho_.data(), 1});
    if (energy_)
    {
        all.append({rhoE_.data(), 1});
    }
    return all;
}


template<class Cell, class Behind>
void Foam::mpm::eulerianFlow::around
(
    const label c,
    const bool neighbours,
    const UList<gasState>& behind,
    const Cell& cell,
    const Behind& boundary
) const
{
    cell(c);
    if (!neighbours)
    {
        return;
    }
    const labelUList& own = mesh_.faceOwner();
    for (const label f : mesh_.cells()[c])
    {
        const label b = f - mesh_.nInternalFaces();
        if (b < 0)
        {
            cell(own[f] == c ? mesh_.faceNeighbour()[f] : own[f]);
        }
        else if (behind[b].p > 0)
        {
            boundary(b);
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianFlow::fill(const UList<scalar>& change)
{
    const noTraps guard;
    const scalarField& V = mesh_.V();
    const label nInternal = mesh_.nInternalFaces(), nBehind = Wb_.size();

    // Behind coupled faces: volume and momentum of what flows in the cell
    List<gasState> other(nBehind, gasState{0, Zero, 0});
    for (const label f : faces_.coupled)
    {
        const label P = mesh_.faceOwner()[f];
        other[f - nInternal] = gasState{V[P]*theta_[P], V[P]*rhoU_[P], 1};
    }
    coupled_.swap(other);

    DynamicList<label> cells;
    DynamicList<scalar> factor;
    DynamicList<vector> rhoU;
    forAll(change, c)
    {
        if (change[c] == 0)
        {
            continue;
        }
        scalar volume = 0;
        vector momentum(Zero);
        around
        (
            c, change[c] > 0, other,
            [&](const label n)
            {
                volume += V[n]*theta_[n];
                momentum += V[n]*rhoU_[n];
            },
            [&](const label b)
            {
                volume += other[b].rho;
                momentum += other[b].u;
            }
        );
        cells.append(c);
        factor.append(change[c]/volume);
        rhoU.append(change[c]/volume*momentum);
        fixups_.filled += V[c]*change[c];
    }

    const scalar mass0 = mass(), energy0 = energy();
    List<fluidSums> before;
    if (flows_ && cells.size())
    {
        before = fluidContents();
    }
    for (const column& of : columns())
    {
        // All changes before any
        scalarField behind(of.n*nBehind, 0), add(of.n*cells.size(), 0);
        for (const label f : faces_.coupled)
        {
            const label P = mesh_.faceOwner()[f];
            for (label k = 0; k < of.n; ++k)
            {
                behind[of.n*(f - nInternal) + k] = V[P]*of.values[of.n*P + k];
            }
        }
        coupled_.swap(behind, of.n);
        forAll(cells, i)
        {
            const label c = cells[i];
            for (label k = 0; k < of.n; ++k)
            {
                scalar sum = 0;
                around
                (
                    c, change[c] > 0, other,
                    [&](const label n) { sum += V[n]*of.values[of.n*n + k]; },
                    [&](const label b) { sum += behind[of.n*b + k]; }
                );
                add[of.n*i + k] = factor[i]*sum;
            }
        }
        forAll(cells, i)
        {
            for (label k = 0; k < of.n; ++k)
            {
                of.values[of.n*cells[i] + k] += add[of.n*i + k];
            }
        }
    }
    columnsFilled(cells);
    vector impulse(Zero);
    forAll(cells, i)
    {
        rhoU_[cells[i]] += rhoU[i];
        impulse += V[cells[i]]*rhoU[i];
    }
    fixups_.filledMass += mass() - mass0;
    if (flows_)
    {
        flows_->mass += mass() - mass0;
        flows_->impulse += impulse;
        flows_->energy += energy() - energy0;
        if (before.size() > 1)
        {
            const List<fluidSums> now(fluidContents());
            flows_->fluids.setSize(now.size(), 0);
            forAll(now, k)
            {
                flows_->fluids[k] += now[k].mass - before[k].mass;
            }
        }
    }
}

// ************************************************************************* //
