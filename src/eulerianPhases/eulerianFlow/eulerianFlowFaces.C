// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFlow.H"
#include "largestOfAll.H"
#include "noTraps.H"
#include "basicSymmetryFvPatchFields.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Call cell(n) for a cell and those beside it, boundary(b) for coupled faces,
//  which have p > 0 in behind
template<class Cell, class Behind>
void around(
    const polyMesh& mesh, const label c, const bool neighbours, const UList<mpm::gasState>& behind,
    const Cell& cell, const Behind& boundary)
{
    cell(c);
    if (!neighbours)
    {
        return;
    }
    const labelUList& own = mesh.faceOwner();
    for (const label f : mesh.cells()[c])
    {
        const label b = f - mesh.nInternalFaces();
        if (b < 0)
        {
            cell(own[f] == c ? mesh.faceNeighbour()[f] : own[f]);
        }
        else if (behind[b].p > 0)
        {
            boundary(b);
        }
    }
}

}

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::mpm::eulerianFlow::setFaces()
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label nInternal = mesh_.nInternalFaces();

    DynamicList<label> boundary, coupled;
    faces_.wall.setSize(mesh_.nFaces() - nInternal, false);
    forAll(patches, patchi)
    {
        const polyPatch& pp = patches[patchi];
        if (isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        const fvPatchVectorField& Ub = U_.boundaryField()[patchi];
        const bool wall = (Ub.fixesValue() || isA<basicSymmetryFvPatchVectorField>(Ub))
            && !p_.boundaryField()[patchi].fixesValue();
        for (label f = pp.start(); f < pp.start() + pp.size(); ++f)
        {
            (pp.coupled() ? coupled : boundary).append(f);
            faces_.wall[f - nInternal] = wall;
        }
    }
    far_.reset(new farField(U_, p_));
    faces_.boundary.transfer(boundary);
    faces_.coupled.transfer(coupled);

    // Courant number per second of a cell: half the sum of |u.S| + c|S| over
    // its faces over its volume
    faceRates_.directions.setSize(mesh_.nCells(), Zero);
    faceRates_.all.setSize(mesh_.nCells(), 0);
    const auto add = [&](const label f, const label c)
    {
        const vector& S = S_[f];
        const scalar h = 0.5 / V_[c];
        faceRates_.directions[c] += h * cmptMag(S);
        faceRates_.all[c] += h * mag(S);
    };
    for (label f = 0; f < nInternal; ++f)
    {
        add(f, mesh_.faceOwner()[f]);
        add(f, mesh_.faceNeighbour()[f]);
    }
    for (const labelList* list : {&faces_.boundary, &faces_.coupled})
    {
        for (const label f : *list)
        {
            add(f, mesh_.faceOwner()[f]);
        }
    }

    faces_.Vb.setSize(mesh_.nFaces() - nInternal);
    faces_.magS.setSize(mesh_.nFaces());
    faces_.invMagS.setSize(mesh_.nFaces());
    forAll(faces_.magS, f)
    {
        faces_.magS[f] = mag(S_[f]);
        faces_.invMagS[f] = 1 / max(faces_.magS[f], VSMALL);
    }
    forAll(faces_.Vb, i)
    {
        faces_.Vb[i] = V_[mesh_.faceOwner()[nInternal + i]];
    }
    coupled_.swap(faces_.Vb);
}

void Foam::mpm::eulerianFlow::markNearSolid(const solidOnFaces& pores)
{
    // So much less than 1 is left behind by rounding and by a body that has
    // passed
    constexpr scalar full = 1 - 1e-3;

    const label nCells = mesh_.nCells();
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();

    near_.setSize(nCells + Wb_.size(), false);
    region_.forCells([&](const label c) { near_[c] = theta_[c] < full; });
    const auto mark = [&](const label c)
    {
        near_[c] = true;
        region_.touch(c);
    };
    pores.forSolid(
        mesh_.nFaces(),
        [&](const label f)
        {
            mark(own[f]);
            if (f < nInternal)
            {
                mark(nei[f]);
            }
        });
    region_.join();

    changes_.setSize(nCells);
    region_.forCells([&](const label c) { changes_[c] = near_[c] || pores.dilation[c] != 0; });

    for (const label f : faces_.boundary)
    {
        near_[nCells + f - nInternal] = near_[own[f]];
    }
    if (coupled_.empty())
    {
        return;
    }
    scalarField behind(Wb_.size(), 0);
    for (const label f : faces_.coupled)
    {
        behind[f - nInternal] = near_[own[f]];
    }
    coupled_.swap(behind);
    for (const label f : faces_.coupled)
    {
        near_[nCells + f - nInternal] = behind[f - nInternal] > 0.5;
    }
}

void Foam::mpm::eulerianFlow::updateFarStates()
{
    forAll(far_->faces(), i)
    {
        const farField::face& a = far_->faces()[i];
        const label c = mesh_.faceOwner()[a.f], b = a.f - mesh_.nInternalFaces();
        gasState L(W_[c]);
        L.p += faceWeight(c, a.f);
        const farField::state s(farState(i, L, wave(c).z));
        Wb_[b] = s.behind;
        thetaB_[b] = theta_[c];
        p_.boundaryFieldRef()[a.patch][a.i] = s.p;
        U_.boundaryFieldRef()[a.patch][a.i] = s.behind.u;
    }
}

void Foam::mpm::eulerianFlow::farFaces(const solidOnFaces* pores, const boolList* first)
{
    forAll(far_->faces(), i)
    {
        const label f = far_->faces()[i].f, c = mesh_.faceOwner()[f];
        const label b = f - mesh_.nInternalFaces();
        const bool ofCell = reconstruction_.upwind() || (first && (*first)[c]);
        gasState L(ofCell ? W_[c] : reconstruction_.faces()[f].own);
        const scalar z = ofCell ? wave(c).z : sideImpedance(f, L);
        L.p += faceWeight(c, f);
        const farField::state s(farState(i, L, z));
        Wb_[b] = s.behind;
        const stateTerms* t = farTerms(b);
        if (!reconstruction_.upwind())
        {
            reconstruction_.setBehind(f, s.behind, t);
        }
        scalar& out = out_[c];
        out -= max(phi_[f], scalar(0));
        phi_[f] = s.u * faces_.magS[f];
        pStar_[f] = s.p;
        if (pores && near_[c])
        {
            // As at other boundary faces
            phi_[f] *= 1 - pores->thetaS[f];
            if (pores->area)
            {
                phi_[f] += pores->thetaS[f] * pores->uS[f] * faces_.magS[f];
            }
        }
        out = max(out, scalar(0)) + max(phi_[f], scalar(0));
    }
}

void Foam::mpm::eulerianFlow::startLayers(const scalar dt, const solidOnFaces* pores)
{
    farLayer& layer = far_->layer();
    layer.clear();
    if (layer.cells().empty())
    {
        return;
    }

    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const labelList& patchOf = mesh_.boundaryMesh().patchID();
    boolList empty(mesh_.boundaryMesh().size()), wedge(empty.size());
    forAll(empty, i)
    {
        empty[i] = isA<emptyPolyPatch>(mesh_.boundaryMesh()[i]);
        wedge[i] = isA<wedgePolyPatch>(mesh_.boundaryMesh()[i]);
    }
    forAll(layer.cells(), i)
    {
        const farLayer::cell& a = layer.cells()[i];
        const label c = a.c;
        if (magSqr(layer.strain()[c]) > 0)
        {
            region_.touch(c);
        }
        if (!region_.has(c))
        {
            continue;
        }
        const gasState& w = W_[c];
        const bool beside = pores && near_[c];
        vector gradients(Zero), middle(Zero), slope(Zero);
        for (const label f : mesh_.cells()[c])
        {
            const label b = f - nInternal;
            if (b >= 0 && empty[patchOf[b]])
            {
                continue;
            }
            // The cell's own velocity and pressure on the sides of a wedge; on others the mean,
            // and along the normal what flows
            const scalar sign = own[f] == c ? 1 : -1;
            const vector& S = S_[f];
            vector u(w.u);
            scalar p = w.p;
            if (b < 0 || !wedge[patchOf[b]])
            {
                u = 0.5 * (u + (b >= 0 ? Wb_[b].u : W_[sign > 0 ? nei[f] : own[f]].u));
                u += beside ? Zero : (phi_[f] - (u & S)) * sqr(faces_.invMagS[f]) * S;
                p = pStar_[f];
                middle += sign * phi_[f] * (mesh_.faceCentres()[f] - mesh_.cellCentres()[c]);
            }
            slope += sign * (p - w.p) * S;
            for (direction k = 0; k < 3; ++k)
            {
                if (a.rate[k] > 0)
                {
                    gradients[k] += sign * (u & a.n[k]) * (S & a.n[k]);
                }
            }
        }
        const scalar V = V_[c], K = max(wave(c).K, SMALL);
        slope = slope / V - w.rho * g_;
        for (direction k = 0; k < 3; ++k)
        {
            const scalar flown = beside ? 0 : (middle & a.n[k]) * (slope & a.n[k]) / K;
            gradients[k] = (gradients[k] + flown) / V;
        }
        layer.add(i, dt, std::sqrt(K / w.rho), w.u, gradients);
    }
    region_.join();
}

Foam::mpm::flowGains Foam::mpm::eulerianFlow::addLayers(const scalar dt)
{
    flows gained;
    for (const farLayer::source& s : far_->layer().sources())
    {
        const label c = s.c;
        const scalar h = 1 / dt, mass = V_[c] * s.strain * rho_[c];
        const vector impulse(V_[c] * (s.strain * rhoU_[c] + rho_[c] * s.du));
        sums_[c].rho -= h * mass;
        sums_[c].rhoU -= h * impulse;
        gained.mass += mass;
        gained.impulse += impulse;
        if (energy_)
        {
            const scalar work = s.du & (rhoU_[c] + 0.5 * rho_[c] * s.du);
            const scalar energy = V_[c] * (s.strain * (rhoE_[c] + theta_[c] * W_[c].p) + work);
            sums_[c].rhoE -= h * energy;
            gained.energy += energy;
        }
    }
    return gained;
}

void Foam::mpm::eulerianFlow::addWedgeSides(const boolList* first)
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label n = !reconstruction_.upwind() && isA<wedgePolyPatch>(pp) ? pp.size() : 0;
        for (label f = pp.start(); f < pp.start() + n; ++f)
        {
            const label P = mesh_.faceOwner()[f];
            if (!(first && (*first)[P]))
            {
                sums_[P].rhoU += (reconstruction_.faces()[f].own.p - W_[P].p) * S_[f];
            }
        }
    }
}

void Foam::mpm::eulerianFlow::limitOutflow(const scalar dt, const solidOnFaces* pores)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const scalarField& V = mesh_.V();

    const auto most = [&](const label c)
    {
        const scalar theta = theta_[c];
        return pores ? max(min(0.9 * theta, theta - 0.5 * pores->eps), pores->leak * theta) : 0.9;
    };

    limits_ = false;
    region_.forCells([&](const label c) { limits_ = limits_ || dt * out_[c] > most(c) * V[c]; });
    limits_ = onAny(limits_);
    if (!limits_)
    {
        return;
    }

    region_.forCells(
        [&](const label c)
        {
            const scalar allowed = most(c) * V[c] / dt;
            if (out_[c] > allowed)
            {
                out_[c] = allowed / out_[c];
                ++fixups_.limited;
            }
            else
            {
                out_[c] = 1;
            }
        });
    scalarField behind(Wb_.size(), 1);
    for (const label f : faces_.coupled)
    {
        behind[f - nInternal] = out_[own[f]];
    }
    coupled_.swap(behind);

    // 0 on faces of empty patches and wedges, which the loops below leave out
    phiLimited_.setSize(phi_.size(), 0);
    region_.forFaces(
        [&](const label f)
        {
            const label donor = phi_[f] > 0 ? own[f] : nei[f];
            phiLimited_[f] = phi_[f] * out_[donor];
            fixups_.heldBack += dt * mag(phi_[f] - phiLimited_[f]) * W_[donor].rho;
        });
    for (const labelList* list : {&faces_.coupled, &faces_.boundary})
    {
        for (const label f : *list)
        {
            phiLimited_[f] = phi_[f] * (phi_[f] > 0 ? out_[own[f]] : behind[f - nInternal]);

            // What comes in is counted where it leaves
            if (phi_[f] > 0)
            {
                fixups_.heldBack += dt * (phi_[f] - phiLimited_[f]) * W_[own[f]].rho;
            }
        }
    }
}

Foam::DynamicList<Foam::mpm::eulerianFlow::column> Foam::mpm::eulerianFlow::columns()
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
        other[f - nInternal] = gasState{V[P] * theta_[P], V[P] * rhoU_[P], 1};
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
        around(
            mesh_, c, change[c] > 0, other,
            [&](const label n)
            {
                volume += V[n] * theta_[n];
                momentum += V[n] * rhoU_[n];
            },
            [&](const label b)
            {
                volume += other[b].rho;
                momentum += other[b].u;
            });
        cells.append(c);
        factor.append(change[c] / volume);
        rhoU.append(change[c] / volume * momentum);
        fixups_.filled += V[c] * change[c];
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
        scalarField behind(of.n * nBehind, 0), add(of.n * cells.size(), 0);
        for (const label f : faces_.coupled)
        {
            const label P = mesh_.faceOwner()[f];
            for (label k = 0; k < of.n; ++k)
            {
                behind[of.n * (f - nInternal) + k] = V[P] * of.values[of.n * P + k];
            }
        }
        coupled_.swap(behind, of.n);
        forAll(cells, i)
        {
            const label c = cells[i];
            for (label k = 0; k < of.n; ++k)
            {
                scalar sum = 0;
                around(
                    mesh_, c, change[c] > 0, other,
                    [&](const label n) { sum += V[n] * of.values[of.n * n + k]; },
                    [&](const label b) { sum += behind[of.n * b + k]; });
                add[of.n * i + k] = factor[i] * sum;
            }
        }
        forAll(cells, i)
        {
            for (label k = 0; k < of.n; ++k)
            {
                of.values[of.n * cells[i] + k] += add[of.n * i + k];
            }
        }
    }
    columnsFilled(cells);
    vector impulse(Zero);
    forAll(cells, i)
    {
        rhoU_[cells[i]] += rhoU[i];
        impulse += V[cells[i]] * rhoU[i];
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
