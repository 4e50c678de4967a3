// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "reconstruction.H"
#include "boxSides.H"
#include "limitedGradients.H"
#include "leastSquaresVectors.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::reconstruction::fromSlopes()
{
    const limitedGradients& slopes = *slopes_;
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const auto side = [&](const label f, const label c)
    { return limitedGradients::fromLanes(slopes.at(c, Cf[f] - C[c])); };
    region_.forFaces(
        [&](const label f)
        {
            faces_[f].own = side(f, own[f]);
            faces_[f].nei = side(f, nei[f]);
        });
    for (const label f : coupledList_)
    {
        faces_[f].own = side(f, own[f]);
    }
}

void Foam::mpm::reconstruction::sidesOfBoundary(const phase& of, const boolUList* nearSolid)
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& S = mesh_.faceAreas();
    const labelUList& own = mesh_.faceOwner();
    for (const label f : boundary_)
    {
        const label c = own[f];
        const gasState& w = of.W[c];
        gasState& s = faces_[f].own;
        s = w;
        if (byCells_ && !(nearSolid && (*nearSolid)[c]))
        {
            const vector d(Cf[f] - C[c]);
            s = limitedGradients::fromLanes(slopes_->at(c, d));
            if (mag(of.Wb[f - mesh_.nInternalFaces()].p - w.p) > 1e-10 * mag(w.p))
            {
                // The pressure of the boundary is that at the foot of the
                // normal; where it is the cell's but for rounding it is not
                // another one
                const vector along(d - (d & S[f]) / magSqr(S[f]) * S[f]);
                s.p = slopes_->at(c, along)[4];
            }
        }
    }
}

template<class IsNear>
void Foam::mpm::reconstruction::setNearSolid(const UList<gasState>& W, const IsNear& isNear)
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    region_.forFaces(
        [&](const label f)
        {
            if (isNear(f))
            {
                faces_[f].own = W[own[f]];
                faces_[f].nei = W[nei[f]];
            }
        });
    for (const label f : coupledList_)
    {
        if (isNear(f))
        {
            faces_[f].own = W[own[f]];
        }
    }
}

template<bool General>
void Foam::mpm::reconstruction::changes(
    const scalar dt, const phase& of, const boolUList* nearSolid)
{
    const vectorField& S = mesh_.faceAreas();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();
    const UList<gasState>& W = of.W;
    const scalar gamma = General ? 0 : of.thermo->gamma();

    region_.forCells([&](const label c) { rates_[c] = rates{0, 0, 0, Zero, Zero}; });
    const auto add = [&](const label c, const gasState& w, const vector& s)
    {
        const gasState& W0 = W[c];
        rates& r = rates_[c];
        const scalar us = W0.u & s;
        const vector du(w.u - W0.u);
        const scalar dp = w.p - W0.p;
        r.div += du & s;
        r.rho += us * (w.rho - W0.rho);
        r.p += us * dp;
        r.u += us * du;
        r.gradP += dp * s;
    };
    region_.forFaces(
        [&](const label f)
        {
            add(own[f], faces_[f].own, S[f]);
            add(nei[f], faces_[f].nei, -S[f]);
        });
    for (const label f : coupledList_)
    {
        add(own[f], faces_[f].own, S[f]);
    }
    for (const label f : boundary_)
    {
        add(own[f], of.Wb[f - nInternal], S[f]);
    }
    for (const label f : wedge_)
    {
        // No flux through it: u_r/r, which the differences do not see
        rates_[own[f]].div -= W[own[f]].u & S[f];
    }

    const scalarField& V = mesh_.V();
    region_.forCells(
        [&](const label c)
        {
            rates& r = rates_[c];
            const gasState& w = W[c];
            const scalar h = nearSolid && (*nearSolid)[c] ? 0 : -0.5 * dt / V[c];
            r.rho = h * (r.rho + w.rho * r.div);
            r.u = h * (r.u + r.gradP / w.rho);
            r.p = h * (r.p + (General ? of.t[c].K : gamma * w.p) * r.div);
        });
}

template<bool General>
void Foam::mpm::reconstruction::slopeChanges(
    const scalar dt, const phase& of, const boolUList* nearSolid)
{
    const UList<gasState>& W = of.W;
    const scalarField& V = mesh_.V();
    const vectorField& S = mesh_.faceAreas();
    const labelUList& own = mesh_.faceOwner();
    const scalar gamma = General ? 0 : of.thermo->gamma();

    region_.forCells([&](const label c) { rates_[c] = rates{0, 0, 0, Zero, Zero}; });
    for (const label f : wedge_)
    {
        // u_r/r
        rates_[own[f]].div -= (W[own[f]].u & S[f]) / V[own[f]];
    }
    region_.forCells(
        [&](const label c)
        {
            const gasState& w = W[c];
            const limitedGradients::state x = slopes_->slope(c, 0), y = slopes_->slope(c, 1),
                                          z = slopes_->slope(c, 2),
                                          along = x * w.u.x() + y * w.u.y() + z * w.u.z();

            rates& r = rates_[c];
            const scalar h = nearSolid && (*nearSolid)[c] ? 0 : -0.5 * dt;
            const scalar div = r.div + x[1] + y[2] + z[3];
            const gasState change = limitedGradients::fromLanes(along);
            r.rho = h * (change.rho + w.rho * div);
            r.u = h * (change.u + vector(x[4], y[4], z[4]) / w.rho);
            r.p = h * (change.p + (General ? of.t[c].K : gamma * w.p) * div);
        });
}

template<bool General>
void Foam::mpm::reconstruction::predict(
    const scalar dt, const phase& of, const boolUList* nearSolid)
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();
    const UList<gasState>& W = of.W;

    const label nCells = W.size();
    const auto isNear = [&](const label f)
    {
        return nearSolid
            && ((*nearSolid)[own[f]]
                || (*nearSolid)[f < nInternal ? nei[f] : nCells + f - nInternal]);
    };
    if (nearSolid)
    {
        setNearSolid(W, isNear);
    }
    if (byCells_)
    {
        slopeChanges<General>(dt, of, nearSolid);
    }
    else
    {
        changes<General>(dt, of, nearSolid);
    }

    const auto ahead = [&](const label c, gasState& s)
    {
        const rates& r = rates_[c];
        const gasState& w = W[c];
        s.rho += r.rho;
        s.u += r.u;
        s.p += r.p;
        if (s.rho < 0.1 * w.rho || (General ? s.p < w.p - 0.9 * of.t[c].strength : s.p < 0.1 * w.p))
        {
            s = w;
        }
    };
    region_.forFaces(
        [&](const label f)
        {
            if (!isNear(f))
            {
                ahead(own[f], faces_[f].own);
                ahead(nei[f], faces_[f].nei);
            }
        });
    sidesOfBoundary(of, nearSolid);
    for (const label f : boundary_)
    {
        ahead(own[f], faces_[f].own);
    }
    for (const label f : wedge_)
    {
        faces_[f].own = W[own[f]];
        ahead(own[f], faces_[f].own);
    }
    for (const label f : coupledList_)
    {
        if (!isNear(f))
        {
            ahead(own[f], faces_[f].own);
        }
    }
    sidesBehind(of);
}

void Foam::mpm::reconstruction::sidesBehind(const phase& of)
{
    const label nInternal = mesh_.nInternalFaces();
    for (const label f : boundary_)
    {
        faces_[f].nei = of.Wb[f - nInternal];
    }
    if (coupled_.empty())
    {
        return;
    }
    for (const label f : coupledList_)
    {
        swap_[f - nInternal] = faces_[f].own;
    }
    coupled_.swap(swap_);
    for (const label f : coupledList_)
    {
        faces_[f].nei = swap_[f - nInternal];
    }
}

void Foam::mpm::reconstruction::predictOnBoxes(
    const scalar dt, const phase& of, const boolUList* nearSolid)
{
    boxes_->update(own_, dt, of, nearSolid, faces_);
    for (const labelList* list : {&boundary_, &coupledList_})
    {
        for (const label f : *list)
        {
            const label c = mesh_.faceOwner()[f];
            if (!region_.has(c))
            {
                faces_[f].own = of.W[c];
            }
        }
    }
    sidesBehind(of);
}

void Foam::mpm::reconstruction::setTerms(const phase& of)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();

    const auto repair = [](gasState& s, stateTerms& t, const gasState& w, const stateTerms& tw)
    {
        if (!(t.K > 0.01 * tw.K))
        {
            s = w;
            t = tw;
        }
    };
    const auto set = [&](const label n, const auto& face)
    {
        of.thermo->terms(
            n, [&](const label i) -> const gasState& { return faces_[face(i)].own; },
            [&](const label i) -> stateTerms& { return terms_[face(i)].own; });
        of.thermo->terms(
            n, [&](const label i) -> const gasState& { return faces_[face(i)].nei; },
            [&](const label i) -> stateTerms& { return terms_[face(i)].nei; });
        for (label i = 0; i < n; ++i)
        {
            const label f = face(i), b = f - nInternal;
            sides& s = faces_[f];
            sideTerms& t = terms_[f];
            repair(s.own, t.own, of.W[own[f]], of.t[own[f]]);
            if (b < 0)
            {
                repair(s.nei, t.nei, of.W[nei[f]], of.t[nei[f]]);
            }
            else
            {
                repair(s.nei, t.nei, of.Wb[b], of.tb[b]);
            }
        }
    };
    set(nInternal, [](const label i) { return i; });
    for (const labelList* list : {&coupledList_, &boundary_})
    {
        set(list->size(), [&](const label i) { return (*list)[i]; });
    }
}

void Foam::mpm::reconstruction::halfStep(
    const scalar dt, const phase& of, const boolUList* nearSolid)
{
    const bool gamma = of.thermo && of.thermo->isGammaLaw();
    if (boxes_)
    {
        predictOnBoxes(dt, of, nearSolid);
    }
    else if (gamma)
    {
        predict<false>(dt, of, nearSolid);
    }
    else
    {
        predict<true>(dt, of, nearSolid);
    }
    if (!gamma)
    {
        terms_.setSize(faces_.size());
    }
    if (!gamma && of.thermo)
    {
        setTerms(of);
    }
}

void Foam::mpm::reconstruction::measureRest(const vector& g)
{
    // That of g.x, as p of a fluid of density 1
    const label nInternal = mesh_.nInternalFaces();
    const vectorField& S = mesh_.faceAreas();
    const vectorField& C = mesh_.cellCentres();
    List<gasState> cells(mesh_.nCells()), behind(swap_.size());
    forAll(cells, c)
    {
        cells[c] = gasState{1, Zero, g & C[c]};
    }
    forAll(behind, i)
    {
        const label f = nInternal + i;
        const vector n(S[f] / mag(S[f]));
        behind[i] = cells[mesh_.faceOwner()[f]];
        foot_[i] = (g & n) * (n & (mesh_.faceCentres()[f] - C[mesh_.faceOwner()[f]]));
    }
    coupled_.swap(behind);
    for (const label f : boundary_)
    {
        behind[f - nInternal].p += foot_[f - nInternal];
    }
    slopes_->update(cells, behind);
    rest_.setSize(cells.size());
    forAll(rest_, c)
    {
        for (int i = 0; i < 3; ++i)
        {
            rest_[c][i] = slopes_->slope(c, i)[4];
        }
    }
}

void Foam::mpm::reconstruction::slopesAboveRest(const phase& of)
{
    if (rest_.empty())
    {
        foot_.setSize(of.Wb.size(), 0);
        measureRest(of.g);
    }
    const label nInternal = mesh_.nInternalFaces();
    restBehind_ = of.Wb;
    for (const label f : boundary_)
    {
        const label c = mesh_.faceOwner()[f];
        gasState& w = restBehind_[f - nInternal];
        if (w.p == of.W[c].p)
        {
            w.p += of.W[c].rho * foot_[f - nInternal];
        }
    }
    slopes_->update(of.W, restBehind_);
    forAll(of.W, c)
    {
        slopes_->atRest(c, of.W[c].rho * rest_[c]);
    }
}

void Foam::mpm::reconstruction::measureSkew()
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const labelUList& own = mesh_.faceOwner();

    skew_.setSize(mesh_.nFaces(), Zero);
    scalar most = 0;
    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        const vector& P = C[own[f]];
        const vector d(C[mesh_.faceNeighbour()[f]] - P);
        skew_[f] = Cf[f] - P - (1 - mesh_.weights()[f]) * d;
        most = max(most, mag(skew_[f]) / mag(d));
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (patch.coupled())
        {
            const vectorField delta(patch.delta());
            forAll(delta, i)
            {
                const label f = patch.start() + i;
                const vector& d = delta[i];
                skew_[f] = Cf[f] - C[own[f]] - (1 - patch.weights()[i]) * d;
                most = max(most, mag(skew_[f]) / mag(d));
            }
        }
    }
    if (returnReduce(most, maxOp<scalar>()) < 1e-6)
    {
        skew_.clear();
    }
}

void Foam::mpm::reconstruction::leastSquares(const UList<gasState>& W, const UList<gasState>& Wb)
{
    const leastSquaresVectors& vectors = leastSquaresVectors::New(mesh_);
    const surfaceVectorField& v = vectors.pVectors();
    const surfaceVectorField& vN = vectors.nVectors();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    grad_ = gradients{Zero, Zero, Zero};
    const auto add = [&](const label c, const gasState& N, const vector& v)
    {
        const gasState& P = W[c];
        gradients& g = grad_[c];
        g.rho += (N.rho - P.rho) * v;
        g.p += (N.p - P.p) * v;
        g.u += v * (N.u - P.u);
    };
    for (label f = 0; f < nInternal; ++f)
    {
        add(own[f], W[nei[f]], v[f]);
        add(nei[f], W[own[f]], vN[f]);
    }
    for (const labelList* list : {&boundary_, &coupledList_})
    {
        for (const label f : *list)
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(f);
            add(own[f], Wb[f - nInternal],
                v.boundaryField()[patchi][f - mesh_.boundaryMesh()[patchi].start()]);
        }
    }
}

void Foam::mpm::reconstruction::addSkew(const UList<gasState>& W, const UList<gasState>& Wb)
{
    const scalarField& w = mesh_.weights();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    // The limiter is the way from P on the line over that without it
    const auto part = [](const scalar to, const scalar whole)
    { return mag(whole) > VSMALL ? max(scalar(0), min(to / whole, scalar(1))) : 0; };
    const auto shift = [&](gasState& s, const gasState& P, const gasState& N, const gradients& g,
                           const scalar v, const vector& d)
    {
        s.rho += part(s.rho - P.rho, v * (N.rho - P.rho)) * (d & g.rho);
        s.p += part(s.p - P.p, v * (N.p - P.p)) * (d & g.p);
        const vector du(N.u - P.u);
        s.u += part((s.u - P.u) & du, v * magSqr(du)) * (d & g.u);
    };

    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        shift(faces_[f].own, W[P], W[N], grad_[P], 1 - w[f], skew_[f]);
        shift(faces_[f].nei, W[N], W[P], grad_[N], w[f], skew_[f]);
    }
    for (const label f : coupledList_)
    {
        const label patchi = mesh_.boundaryMesh().whichPatch(f);
        const label i = f - mesh_.boundaryMesh()[patchi].start();
        shift(
            faces_[f].own, W[own[f]], Wb[f - nInternal], grad_[own[f]],
            1 - mesh_.boundary()[patchi].weights()[i], skew_[f]);
    }
}
