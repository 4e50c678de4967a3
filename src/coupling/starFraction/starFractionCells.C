// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "starFraction.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::starFraction::thetaOf(const label node) const
{
    return (1 - eps_) * volumeOf(node_, node) / stars_.nodeVolume(node);
}

Foam::scalar Foam::mpm::starFraction::meanTheta(const label node) const
{
    return 0.5 * (1 - eps_) * (old_[node] + volumeOf(node_, node)) / stars_.nodeVolume(node);
}

Foam::vector Foam::mpm::starFraction::velocityOf(const label facei) const
{
    const int D = stars_.grid().nDim();
    scalar sum = 0, u[3] = {0, 0, 0};
    for (const label pointi : mesh_.faces()[facei])
    {
        const label l = stars_.grid().pointToNode()[pointi];
        if (!hasNode_[l])
        {
            continue;
        }
        forAll(velocity_, phasei)
        {
            const scalar weight =
                (oldOfPhase_[phasei][l] + volumeOf(ofPhase_[phasei], l)) / stars_.nodeVolume(l);
            sum += weight;
            for (int d = 0; d < D; ++d)
            {
                u[d] += weight * velocity_[phasei][D * l + d];
            }
        }
    }
    return sum > 0 ? inAxes(u) / sum : vector(Zero);
}

Foam::scalar Foam::mpm::starFraction::density(const label facei) const
{
    scalar m = 0, v = 0;
    for (const label pointi : mesh_.faces()[facei])
    {
        const label l = stars_.grid().pointToNode()[pointi];
        if (hasNode_[l])
        {
            const scalar* q = node_.begin() + starPoints::nodeStride * l;
            m += q[starPoints::mass];
            v += q[starPoints::volume];
        }
    }
    return v > 0 ? m / v : 0;
}

void Foam::mpm::starFraction::updateFace(const label f, const scalar dt)
{
    const int D = stars_.grid().nDim();
    const scalar* q = face_.begin() + faceStride * f;
    const scalar share = 1 - eps_;
    area_[f] = 0.5 * (area0_[f] + share * inAxes(q + starPoints::gradOld(D)));
    areaNew_[f] = share * inAxes(q + starPoints::gradNew(D));
    phiS_[f] = share * q[starPoints::way(D)] / dt;

    const vector& S = mesh_.faceAreas()[f];
    const scalar S2 = magSqr(S);
    thetaS_[f] = max(min((area_[f] & S) / S2, most_), scalar(0));

    // Both faces of a cyclic pair have the same velocity; the first stands
    // first in faces_
    const label other = stars_.mate(f);
    velocityOfFaces_[f] =
        other >= 0 && magSqr(velocityOfFaces_[other]) > 0 ? velocityOfFaces_[other] : velocityOf(f);
    uS_[f] = (velocityOfFaces_[f] & S) / std::sqrt(S2);
    rhoS_[f] = density(f);
}

void Foam::mpm::starFraction::updateSides()
{
    const labelList& toNode = stars_.grid().pointToNode();
    for (const label f : sides_)
    {
        if ((*gasWalls_)[f - mesh_.nInternalFaces()])
        {
            continue;
        }
        scalar old = 0, mean = 0;
        const face& points = mesh_.faces()[f];
        for (const label pointi : points)
        {
            const label l = toNode[pointi];
            if (hasNode_[l])
            {
                old += (1 - eps_) * old_[l] / stars_.nodeVolume(l);
                mean += meanTheta(l);
            }
        }
        thetaS0_[f] = min(old / points.size(), most_);
        thetaS_[f] = min(mean / points.size(), most_);
        uS_[f] =
            thetaS_[f] > 0 ? (velocityOf(f) & mesh_.faceAreas()[f]) / mag(mesh_.faceAreas()[f]) : 0;
    }
}

void Foam::mpm::starFraction::updateGasPush(
    const UList<scalar>& p, const UList<scalar>& pBehind, const vectorField& area)
{
    const vectorField& S = mesh_.faceAreas();
    for (const label c : around_)
    {
        gasPush_[c] = pushOn(c, p, pBehind, [&](const label f) { return S[f] - area[f]; });
    }
}

Foam::scalar Foam::mpm::starFraction::ownOf(const label phasei, const label celli) const
{
    const scalarList& q = ofPhase_[phasei];
    return sumOver(
               celli,
               [&](const scalar V, const label l)
               { return V * volumeOf(q, l) / stars_.nodeVolume(l); })
        / mesh_.V()[celli];
}

void Foam::mpm::starFraction::updatePush(const label phasei, const scalarField& q)
{
    const pointGrid& grid = stars_.grid();
    const int D = grid.nDim();
    const sharedStars* others = stars_.others();
    push_.setSize(D * grid.nNodes());
    const auto clear = [&](const labelUList& nodes)
    {
        for (const label l : nodes)
        {
            std::fill_n(push_.begin() + D * l, D, 0.0);
        }
    };
    clear(nodes_);
    if (others)
    {
        clear(others->nodes().nodes());
    }

    const scalarList behind(coupled_.behind(q));
    const scalarList& of = ofPhase_[phasei];
    for (const label f : faces_)
    {
        // Coupled faces come from both sides
        const label i = f - mesh_.nInternalFaces();
        const scalar qO = q[mesh_.faceOwner()[f]];
        const scalar qN = i < 0 ? q[mesh_.faceNeighbour()[f]] : behind[i];
        if (qO == qN)
        {
            continue;
        }
        scalar v = 0;
        for (const label pointi : mesh_.faces()[f])
        {
            const label l = grid.pointToNode()[pointi];
            v += volumeOf(of, l);
        }
        if (!(v > 0))
        {
            continue;
        }
        const vector H(((i < 0 ? 1 : 0.5) * (qO - qN) / v) * mesh_.faceAreas()[f]);
        for (const label pointi : mesh_.faces()[f])
        {
            const label l = grid.pointToNode()[pointi];
            for (int d = 0; hasNode_[l] && d < D; ++d)
            {
                push_[D * l + d] += H[grid.direction(d)];
            }
        }
    }
    if (others)
    {
        others->nodes().sum(push_.begin(), D, D);
    }
}

void Foam::mpm::starFraction::updateTheta()
{
    for (const label c : around_)
    {
        isAround_[c] = false;
        theta_[c] = dilation_[c] = 0;
        for (scalarField& own : own_)
        {
            if (own.size())
            {
                own[c] = 0;
            }
        }
    }
    around_.clear();
    for (const label l : nodes_)
    {
        for (const label v : stars_.verticesOf(l))
        {
            const label c = stars_.cellOf(v);
            if (!isAround_[c])
            {
                isAround_[c] = true;
                around_.append(c);
            }
        }
    }
    for (const label c : around_)
    {
        theta_[c] = sumOver(c, [&](const scalar V, const label l) { return V * thetaOf(l); })
            / mesh_.V()[c];
        forAll(own_, phasei)
        {
            if (own_[phasei].size())
            {
                own_[phasei][c] = ownOf(phasei, c);
            }
        }
    }
}

void Foam::mpm::starFraction::limitDrag()
{
    // Largest theta_l of each cell, of the cells of a node, of all cells that
    // share a node with a cell
    const cellSimplices& cells = stars_.cells();
    const sharedStars* others = stars_.others();
    if (others)
    {
        for (const label l : others->nodes().nodes())
        {
            largest_[l] = 0;
        }
    }
    for (const label c : around_)
    {
        const label* nodes = cells.nodes(c);
        scalar most = 0;
        for (label i = 0; i < cells.nVertices(c); ++i)
        {
            most = max(most, hasNode_[nodes[i]] ? meanTheta(nodes[i]) : 0);
            largest_[nodes[i]] = 0;
        }
        around1_[c] = most;
    }
    for (const label c : around_)
    {
        const label* nodes = cells.nodes(c);
        for (label i = 0; i < cells.nVertices(c); ++i)
        {
            scalar& most = largest_[nodes[i]];
            most = max(most, around1_[c]);
        }
    }
    if (others)
    {
        others->nodes().largest(largest_.begin(), 1, 1);
    }
    for (const label c : around_)
    {
        const label* nodes = cells.nodes(c);
        for (label i = 0; i < cells.nVertices(c); ++i)
        {
            around1_[c] = max(around1_[c], largest_[nodes[i]]);
        }
    }
    if (others)
    {
        behind_ = coupled_.behind(around1_);
    }
    for (const label f : faces_)
    {
        const label i = f - mesh_.nInternalFaces();
        const scalar other = i < 0 ? around1_[mesh_.faceNeighbour()[f]]
            : others               ? behind_[i]
                                   : around1_[mesh_.faceOwner()[stars_.mate(f)]];
        const scalar most = max(around1_[mesh_.faceOwner()[f]], other);
        dragLimit_[f] = most > 0 ? thetaS_[f] / most : 0;
    }
}

void Foam::mpm::starFraction::updateDilation(const scalar dt)
{
    for (const label c : around_)
    {
        const scalar* q = cell_.begin() + starPoints::cellStride * c;
        if (q[0] > 0)
        {
            dilation_[c] = min(theta_[c], most_) * q[1] / q[0];
            continue;
        }
        const scalar sum = sumOver(
            c,
            [&](const scalar V, const label l) {
                return V / stars_.nodeVolume(l)
                    * node_[starPoints::nodeStride * l + starPoints::dilation];
            });
        dilation_[c] = (1 - eps_) * sum / mesh_.V()[c];
    }
    blendDilation(dt);
}

void Foam::mpm::starFraction::findFailed()
{
    for (const label l : failedNodes_)
    {
        failed_[l] = false;
    }
    failedNodes_.clear();
    const auto add = [&](const label l)
    {
        if (!failed_[l])
        {
            failed_[l] = true;
            failedNodes_.append(l);
        }
    };
    bool fails = false;
    for (const materialPointPhase& phase : points_.phases())
    {
        const materialPointCloud& cloud = phase.cloud();
        const column* damage = cloud.damage();
        if (!damage)
        {
            continue;
        }
        fails = true;
        cloud.forCells(
            [&](const label p, const label celli)
            {
                if ((*damage)[0][p] >= 1)
                {
                    const label* nodes = stars_.cells().nodes(celli);
                    for (label i = 0; i < stars_.cells().nVertices(celli); ++i)
                    {
                        add(nodes[i]);
                    }
                }
            });
    }
    if (stars_.others() && fails)
    {
        const sharedNodes& shared = stars_.others()->nodes();
        for (const label l : shared.nodes())
        {
            largest_[l] = failed_[l];
        }
        shared.largest(largest_.begin(), 1, 1);
        for (const label l : shared.nodes())
        {
            if (largest_[l] > 0)
            {
                add(l);
            }
        }
    }
}

void Foam::mpm::starFraction::blendDilation(const scalar dt)
{
    findFailed();
    const scalar least = 1 - gap_;
    for (const label c : around_)
    {
        const label* nodes = stars_.cells().nodes(c);
        scalar m = 1;
        for (label i = 0; i < stars_.cells().nVertices(c); ++i)
        {
            const label l = nodes[i];
            m = min(m, hasNode_[l] && !failed_[l] ? thetaOf(l) : 0);
        }
        if (!(m > least))
        {
            continue;
        }
        scalar sum = 0;
        for (const label f : mesh_.cells()[c])
        {
            // What the sides of a wedge would take is the hoop's
            if (ofSector_.test(f))
            {
                continue;
            }
            const vector u(hasFace_[f] ? velocityOfFaces_[f] : velocityOf(f));
            const scalar flux = u & mesh_.faceAreas()[f];
            sum += mesh_.faceOwner()[f] == c ? flux : -flux;
        }
        const scalar b = min(scalar(1), (m - least) / (most_ - least));
        const scalar theta = 1 - (*gasTheta_)[c];
        dilation_[c] += b * (theta * dt * sum / mesh_.V()[c] - dilation_[c]);
    }
}

void Foam::mpm::starFraction::findDense()
{
    forAll(dense_, phasei)
    {
        dense_[phasei].clear();
    }
    for (const label c : around_)
    {
        if (!isDense(c) || cell_[starPoints::cellStride * c] > 0)
        {
            continue;
        }
        forAll(dense_, phasei)
        {
            dense d{c, 0, {}, {}};
            scalar M = 0, v = 0;
            for (label i = 0; i < stars_.cells().nVertices(c); ++i)
            {
                const label l = stars_.cells().nodes(c)[i];
                const scalar w = stars_.vertexVolume(stars_.start(c) + i) / stars_.nodeVolume(l);
                const scalar* q = ofPhase_[phasei].begin() + starPoints::nodeStride * l;
                d.nodes.append(l);
                d.share.append(w * q[starPoints::mass]);
                M += d.share.last();
                v += w * q[starPoints::volume];
            }
            if (M > 0)
            {
                d.theta = min((1 - eps_) * v / mesh_.V()[c], most_);
                dense_[phasei].append(d);
            }
        }
    }
}

void Foam::mpm::starFraction::findSurface()
{
    surface_.find(
        [&](const label f) { return areaNew_[f]; }, [&](const label c) { return isDense(c); });
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::starFraction::divergence(const label phasei, const label celli) const
{
    const int D = stars_.grid().nDim();
    const label* nodes = stars_.cells().nodes(celli);
    scalar sum = 0;
    for (label i = 0; i < stars_.cells().nVertices(celli); ++i)
    {
        const vector e(stars_.sideSum(celli, i));
        for (int d = 0; d < D; ++d)
        {
            sum += velocity_[phasei][D * nodes[i] + d] * e[stars_.grid().direction(d)];
        }
    }
    return sum / mesh_.V()[celli];
}

void Foam::mpm::starFraction::forDenseCells(const label phasei, const denseCellAction& f) const
{
    for (const dense& d : dense_[phasei])
    {
        f(d.celli, d.nodes, d.share, d.theta);
    }
}

void Foam::mpm::starFraction::updateNormals()
{
    // Difference of the fraction over a cell below which it is uniform
    constexpr scalar uniform = 5e-4;

    const cellSimplices& cells = stars_.cells();
    scalarField ofCells(theta_);
    scalarList ofNodes;
    for (int pass = 0; pass < 2; ++pass)
    {
        stars_.toNodes(ofCells, ofNodes);
        forAll(ofCells, c)
        {
            scalar sum = 0;
            for (label i = 0; i < cells.nVertices(c); ++i)
            {
                sum += stars_.vertexVolume(stars_.start(c) + i) * ofNodes[cells.nodes(c)[i]];
            }
            ofCells[c] = sum / mesh_.V()[c];
        }
    }
    stars_.toNodes(ofCells, ofNodes);

    normals_.setSize(mesh_.nCells());
    forAll(normals_, c)
    {
        vector n(Zero);
        scalar low = GREAT, high = -GREAT;
        for (label i = 0; i < cells.nVertices(c); ++i)
        {
            const scalar q = ofNodes[cells.nodes(c)[i]];
            low = min(low, q);
            high = max(high, q);
        }
        if (high - low > uniform)
        {
            for (label i = 0; i < cells.nVertices(c); ++i)
            {
                n += ofNodes[cells.nodes(c)[i]] * stars_.sideSum(c, i);
            }
            n /= mag(n);
        }
        normals_[c] = n;
    }
}
