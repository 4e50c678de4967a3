// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fluidInterfaces.H"
#include "syncTools.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::fluidInterfaces::tangent(
    const scalar a, const scalar sign, const scalar b, const scalar lambda)
{
    // y = b x: where the tangent passes 1/2
    const scalar E = std::exp(sign * b * (2 * a - 1)), e = std::exp(b);
    const scalar T = (0.5 * (e + 1 / e) - E) / (0.5 * (e - 1 / e));
    if (lambda < 1e-3)
    {
        // In the middle of the short end
        const scalar t = std::tanh(b * (1 - 0.5 * lambda));
        return 0.5 * (1 + sign * (t - T) / (1 - t * T));
    }
    const scalar o = std::exp(b * (1 - lambda));
    return 0.5
        + 0.5 * sign / (b * lambda) * std::log(E / (0.5 * (o + 1 / o) - 0.5 * (o - 1 / o) * T));
}

void Foam::mpm::fluidInterfaces::swapLabels(std::initializer_list<labelList*> ofBoth) const
{
    if (coupled_.empty())
    {
        return;
    }
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells(), nInternal = mesh.nInternalFaces();
    const label n = ofBoth.size();
    scalarField values(n * (mesh.nFaces() - nInternal), 0);
    for (const label f : faces_.coupled)
    {
        scalar* to = values.begin() + n * (f - nInternal);
        for (const labelList* list : ofBoth)
        {
            *to++ = (*list)[mesh.faceOwner()[f]];
        }
    }
    coupled_.swap(values, n);
    for (const label f : faces_.coupled)
    {
        const scalar* from = values.cdata() + n * (f - nInternal);
        for (labelList* list : ofBoth)
        {
            (*list)[nCells + f - nInternal] = label(*from++);
        }
    }
}

void Foam::mpm::fluidInterfaces::sortCells(const contents& of)
{
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells(), nInternal = mesh.nInternalFaces();
    const auto sort = [&](const label at, const scalar* part, const scalar all)
    {
        label only = -1, most = -1, several = 0;
        for (label k = 0; k < n_; ++k)
        {
            if (part[k] > 0)
            {
                only = k;
                ++several;
            }
            if (part[k] > (1 - foreign) * all)
            {
                most = k;
            }
        }
        single_[at] = several == 1 ? only : -1;
        major_[at] = most;
    };
    for (label c = 0; c < nCells; ++c)
    {
        sort(c, of.part.cdata() + n_ * c, of.theta[c]);
    }
    for (const label f : faces_.boundary)
    {
        const label i = f - nInternal;
        if (of.alphaB[n_ * i] < 0)
        {
            // Nothing of its own comes in
            single_[nCells + i] = single_[mesh.faceOwner()[f]];
            major_[nCells + i] = major_[mesh.faceOwner()[f]];
        }
        else
        {
            sort(nCells + i, of.alphaB.cdata() + n_ * i, 1);
        }
    }
    swapLabels({&single_, &major_});
}

void Foam::mpm::fluidInterfaces::setSlots()
{
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells(), nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    for (const label c : cells_)
    {
        slot_[c] = -1;
    }
    cells_.clear();
    near_ = false;
    const auto add = [&](const label c)
    {
        if (slot_[c] < 0)
        {
            slot_[c] = cells_.size();
            cells_.append(c);
        }
    };
    const auto meet = [](const label a, const label b) { return a >= 0 && b >= 0 && a != b; };
    for (label c = 0; c < nCells; ++c)
    {
        if (single_[c] < 0)
        {
            add(c);
            near_[c] = major_[c] < 0;
        }
    }
    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        if (single_[P] != single_[N])
        {
            add(P);
            add(N);
            if (meet(major_[P], major_[N]))
            {
                near_[P] = near_[N] = true;
            }
        }
    }
    for (const labelList* list : {&faces_.coupled, &faces_.boundary})
    {
        for (const label f : *list)
        {
            const label P = own[f], B = nCells + f - nInternal;
            if (single_[P] != single_[B])
            {
                add(P);
                near_[P] = near_[P] || meet(major_[P], major_[B]);
            }
        }
    }
}

inline void
Foam::mpm::fluidInterfaces::ratios(const scalar* m, const scalar* alpha, scalar* q) const
{
    // The sum of the others: 1 less a share of nearly all is rounding
    for (label k = 0; k < nShares_; ++k)
    {
        scalar others = VSMALL;
        for (label j = 0; j < n_; ++j)
        {
            others += j == k ? 0 : alpha ? m[j] * alpha[j] : m[j];
        }
        q[k] = ((alpha ? m[k] * alpha[k] : m[k]) + VSMALL) / others;
    }
}

void Foam::mpm::fluidInterfaces::setInterfaces(const contents& of)
{
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells(), nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const label n = nShares_ * cells_.size();
    interface_.setSize(n);
    masses_.setSize(n);
    traces_.setSize(n);
    const auto isTrace = [](const scalar q) { return q < trace || q > 1 / trace; };
    forAll(cells_, s)
    {
        ratios(of.mass.cdata() + n_ * cells_[s], nullptr, masses_.begin() + nShares_ * s);
    }
    for (label i = 0; i < n; ++i)
    {
        traces_[i] = isTrace(masses_[i]);
    }
    least_ = masses_;
    most_ = masses_;
    const auto meet = [&](const label s, const label k, const scalar q)
    {
        const label i = nShares_ * s + k;
        least_[i] = min(least_[i], q);
        most_[i] = max(most_[i], q);
        traces_[i] = traces_[i] && isTrace(q);
    };
    for (label f = 0; n && f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f], a = slot_[P], b = slot_[N];
        for (label k = 0; k < nShares_ && (a >= 0 || b >= 0); ++k)
        {
            const auto q = [&](const label s, const label c) {
                return s >= 0 ? masses_[nShares_ * s + k] : single_[c] == k ? VGREAT : VSMALL;
            };
            if (a >= 0)
            {
                meet(a, k, q(b, N));
            }
            if (b >= 0)
            {
                meet(b, k, q(a, P));
            }
        }
    }
    scalarList there(nShares_);
    for (const labelList* list : {&faces_.coupled, &faces_.boundary})
    {
        for (const label f : *list)
        {
            const label s = slot_[own[f]], i = n_ * (f - nInternal);
            if (s >= 0 && of.alphaB[i] >= 0)
            {
                ratios(of.rhoB.cdata() + i, of.alphaB.cdata() + i, there.begin());
                for (label k = 0; k < nShares_; ++k)
                {
                    meet(s, k, there[k]);
                }
            }
        }
    }
    forAll(cells_, s)
    {
        bool jumps = false;
        for (label i = nShares_ * s; i < nShares_ * (s + 1); ++i)
        {
            const scalar q = masses_[i];
            jumps = jumps || most_[i] > different * q || q > different * least_[i];
            interface_[i] = 1;
            if (traces_[i])
            {
                const scalar ratio = max(most_[i] / q, q / least_[i]);
                interface_[i] = ratio > 7 ? min(max(std::log(ratio) - 2, 0.0), 1.0) : scalar(0);
            }
        }
        near_[cells_[s]] = near_[cells_[s]] && jumps;
    }
    labelList near(near_.size(), 0);
    if (!coupled_.empty())
    {
        forAll(near_, i)
        {
            near[i] = near_[i];
        }
        swapLabels({&near});
        for (const label f : faces_.coupled)
        {
            near_[nCells + f - nInternal] = near[nCells + f - nInternal];
        }
    }
}

void Foam::mpm::fluidInterfaces::setMeans(const contents& of)
{
    const fvMesh& mesh = faces_.mesh;
    marked_.setSize(mesh.nPoints());
    pointMeans_.setSize(nShares_ * mesh.nPoints());
    shares_.setSize(nShares_ * mesh.nCells());
    marked_ = false;
    forAll(cells_, s)
    {
        if (isSharp(s))
        {
            for (const label p : mesh.cellPoints()[cells_[s]])
            {
                marked_[p] = true;
            }
        }
    }
    const bool sync = Pstream::parRun() || !coupled_.empty();
    if (sync)
    {
        syncTools::syncPointList(mesh, marked_, orEqOp<bool>(), false);
    }
    forAll(of.theta, c)
    {
        for (label k = 0; k < nShares_; ++k)
        {
            shares_[nShares_ * c + k] = of.part[n_ * c + k] / of.theta[c];
        }
    }
    const labelListList& pointCells = mesh.pointCells();
    forAll(marked_, p)
    {
        if (marked_[p] || sync)
        {
            std::fill_n(pointMeans_.begin() + nShares_ * p, nShares_, 0.0);
        }
        if (marked_[p])
        {
            scalar* mean = pointMeans_.begin() + nShares_ * p;
            const scalar* w = weights_.cdata() + weightStart_[p];
            for (const label c : pointCells[p])
            {
                for (label k = 0; k < nShares_; ++k)
                {
                    mean[k] += *w * shares_[nShares_ * c + k];
                }
                ++w;
            }
        }
    }
    if (sync)
    {
        scalarList one(mesh.nPoints(), Zero);
        for (label k = 0; k < nShares_; ++k)
        {
            forAll(one, p)
            {
                one[p] = pointMeans_[nShares_ * p + k];
            }
            syncTools::syncPointList(mesh, one, plusEqOp<scalar>(), scalar(0));
            forAll(one, p)
            {
                pointMeans_[nShares_ * p + k] = one[p];
            }
        }
    }
}

void Foam::mpm::fluidInterfaces::setGradients(const contents& of)
{
    setMeans(of);
    const fvMesh& mesh = faces_.mesh;
    const label nInternal = mesh.nInternalFaces();
    const labelUList& owner = mesh.faceOwner();
    const vectorField& S = mesh.faceAreas();
    const faceList& faces = mesh.faces();
    const cellList& cells = mesh.cells();
    const Vector<label>& directions = mesh.geometricD();
    gradient_.setSize(nShares_ * cells_.size());
    forAll(cells_, s)
    {
        const label c = cells_[s];
        for (label k = 0; k < nShares_; ++k)
        {
            vector& g = gradient_[nShares_ * s + k];
            g = Zero;
            const scalar own = shares_[nShares_ * c + k];
            if (!(own > wisp && own < 1 - wisp) || !(interface_[nShares_ * s + k] > 0))
            {
                continue;
            }
            for (const label f : cells[c])
            {
                if (f >= nInternal && empty_[f - nInternal])
                {
                    continue;
                }
                const face& points = faces[f];
                scalar mean = 0;
                for (const label p : points)
                {
                    mean += pointMeans_[nShares_ * p + k];
                }
                mean /= points.size();
                g += (mean - own) * (owner[f] == c ? 1 : -1) * S[f];
            }
            for (direction d = 0; d < 3; ++d)
            {
                if (directions[d] < 0)
                {
                    g[d] = 0;
                }
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fluidInterfaces::fluidInterfaces(
    const gasFaces& faces, const coupledFaces& coupled, const label nFluids) :
    faces_(faces),
    V_(faces.mesh.V()),
    S_(faces.mesh.faceAreas()),
    coupled_(coupled),
    n_(nFluids),
    nShares_(nFluids == 2 ? 1 : nFluids)
{
    setWidths();
    setWeights();
    const label nCells = faces.mesh.nCells();
    const label nBoundary = faces.mesh.nFaces() - faces.mesh.nInternalFaces();
    single_.setSize(nCells + nBoundary, 0);
    major_.setSize(nCells + nBoundary, 0);
    near_.setSize(nCells + nBoundary, false);
    slot_.setSize(nCells, -1);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fluidInterfaces::update(const contents& of)
{
    if (n_ == 1)
    {
        return;
    }
    sortCells(of);
    setSlots();
    setInterfaces(of);
    setGradients(of);
}

void Foam::mpm::fluidInterfaces::setTransverse(
    const contents& of, const scalarField& phi, const scalarField& out, const scalar dt)
{
    const fvMesh& mesh = faces_.mesh;
    const label nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    slopes_.setSize(nShares_ * cells_.size());
    ways_.setSize(cells_.size());
    room_.setSize(cells_.size());

    // What comes in less what is there, by faces
    const auto addInflow = [&](const label f, const label c, const vector& S, vector* to)
    {
        const scalar* here = shares_.cdata() + nShares_ * c;
        const scalar* there = f < nInternal
            ? shares_.cdata() + nShares_ * (own[f] == c ? nei[f] : own[f])
            : of.alphaB.cdata() + n_ * (f - nInternal);
        for (label k = 0; k < nShares_ && (f < nInternal || there[0] >= 0); ++k)
        {
            to[k] += (there[k] - here[k]) * S;
        }
    };
    forAll(cells_, s)
    {
        const label c = cells_[s];
        vector* slopes = slopes_.begin() + nShares_ * s;
        std::fill_n(slopes, nShares_, vector(Zero));
        vector& way = ways_[s];
        way = Zero;
        for (const label f : mesh.cells()[c])
        {
            const scalar sign = own[f] == c ? 1 : -1;
            way += (sign * phi[f]) * (mesh.faceCentres()[f] - mesh.cellCentres()[c]);
            if (sign * phi[f] < 0)
            {
                addInflow(f, c, sign * S_[f], slopes);
            }
        }
        way *= 0.5 * dt / (V_[c] * of.theta[c]);
        room_[s] = V_[c] / (dt * out[c]);
        for (label k = 0; k < nShares_; ++k)
        {
            const label i = nShares_ * s + k;
            const scalar own = shares_[nShares_ * c + k];
            const scalar least = min(own, 1 - own) / foreign;
            const scalar w = interface_[i] * min(max((least - 1) / 9, 0.0), 1.0);
            slopes[k] = (w * gradient_[i] + (1 - w) * slopes[k]) / V_[c];
        }
    }
}

inline Foam::scalar Foam::mpm::fluidInterfaces::halfStep(
    const scalar a, const label s, const label k, const vector& n) const
{
    const vector& g = slopes_[nShares_ * s + k];
    const vector& way = ways_[s];
    return min(max(a - ((way & g) - (way & n) * (g & n)), wisp), 1 - wisp);
}

void Foam::mpm::fluidInterfaces::sharesOfCell(
    const contents& of, const label f, const label c, scalar* alpha) const
{
    const vector n(S_[f] / faces_.magS[f]);
    scalar sum = 0;
    for (label k = 0; k < n_; ++k)
    {
        alpha[k] = of.part[n_ * c + k] / of.theta[c];
        if (k < nShares_ && alpha[k] > wisp && alpha[k] < 1 - wisp)
        {
            alpha[k] = halfStep(alpha[k], slot_[c], k, n);
        }
        else if (alpha[k] <= wisp)
        {
            alpha[k] = 0;
        }
        if (k == nShares_)
        {
            alpha[k] = 1 - alpha[0];
        }
        sum += alpha[k];
    }
    for (label k = 0; k < n_; ++k)
    {
        alpha[k] /= sum;
    }
}

void Foam::mpm::fluidInterfaces::shares(
    const contents& of, const label f, const label D, const bool fromOwner, const scalar dt,
    const scalar phi, const scalar* receiver, const scalar thetaOfReceiver, scalar* alpha) const
{
    const scalar* part = of.part.cdata() + n_ * D;
    const scalar theta = of.theta[D];
    if (single_[D] >= 0)
    {
        for (label k = 0; k < n_; ++k)
        {
            alpha[k] = k == single_[D];
        }
        return;
    }

    const label s = slot_[D];
    const scalar V = V_[D];
    const vector n((fromOwner ? faces_.invMagS[f] : -faces_.invMagS[f]) * S_[f]);
    for (label k = 0; k < nShares_; ++k)
    {
        const scalar own = shares_[nShares_ * D + k];
        scalar a = own;
        if (a > wisp && a < 1 - wisp)
        {
            a = halfStep(a, s, k, n);
            const scalar sharpness = interface_[nShares_ * s + k];
            if (sharpness > 0)
            {
                const scalar h = fromOwner ? widthOwn_[f] : widthNei_[f];
                const vector& g = gradient_[nShares_ * s + k];
                const scalar size = mag(g);
                const scalar contrast = size * h / (V * own * (1 - own));
                const scalar along = contrast > mixed ? (g & n) / max(size, VSMALL) : 0;
                const scalar b =
                    beta * mag(along) * sharpness * min((contrast - mixed) / (sharp - mixed), 1.0);
                if (b > 1e-3)
                {
                    const scalar lambda = mag(phi) * dt / (theta * faces_.magS[f] * h);
                    a = tangent(a, along > 0 ? 1 : -1, b, min(scalar(1), lambda));
                }
            }
        }
        alpha[k] = min(max(a, scalar(0)), scalar(1));
    }
    if (nShares_ < n_)
    {
        alpha[1] = 1 - alpha[0];
    }

    // Within what there is
    const scalar all = room_[s];
    scalar sum = 0;
    for (label k = 0; k < n_; ++k)
    {
        if (part[k] < wisp * theta)
        {
            const bool more = receiver[k] * theta > part[k] * thetaOfReceiver;
            alpha[k] = more ? min(part[k] * all, scalar(1)) : 0;
        }
        else
        {
            alpha[k] = min(alpha[k], part[k] * all);
        }
        sum += alpha[k];
    }
    if (sum > 1)
    {
        for (label k = 0; k < n_; ++k)
        {
            alpha[k] /= sum;
        }
    }
    else if (sum < 1)
    {
        scalar room = 0;
        const auto spare = [&](const label k)
        { return part[k] < wisp * theta ? scalar(0) : min(part[k] * all, scalar(1)) - alpha[k]; };
        for (label k = 0; k < n_; ++k)
        {
            room += spare(k);
        }
        for (label k = 0; k < n_; ++k)
        {
            alpha[k] += (1 - sum) * spare(k) / max(room, VSMALL);
        }
    }
}
