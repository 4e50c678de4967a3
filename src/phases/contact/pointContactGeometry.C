// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointContact.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointContact::meet(const label pairi)
{
    const contactPair& pair = pairs_[pairi];
    const velocityField& A = fields_[pair.a];

    // 1/m where a field has mass (0: prescribed), -1 elsewhere
    const auto inverse = [&](const velocityField& field, const label n)
    {
        const scalar m = field.momentum()[field.stride() * n + nDim_];
        return prescribedStamp_[n] == stamp_ ? 0 : m > 0 ? 1 / m : -1;
    };
    const auto stampHeavy = [&](const velocityField& field)
    {
        ++stamp_;
        const rigidNodes& rigid = field.rigid();
        forAll(rigid.nodes(), i)
        {
            prescribedStamp_[rigid.nodes()[i]] = stamp_;
            owner_[rigid.nodes()[i]] = -1;
            forAll(bodies_, b)
            {
                if (bodies_[b].phase == rigid.nodePhases()[i])
                {
                    owner_[rigid.nodes()[i]] = b;
                }
            }
        }
        for (const label n : field.fixedNodes())
        {
            if (prescribedStamp_[n] == stamp_)
            {
                continue;
            }
            owner_[n] = -1;
            if (field.momentum()[field.stride() * n + nDim_] > 0)
            {
                prescribedStamp_[n] = stamp_;
            }
        }
    };

    if (pair.b >= 0)
    {
        const velocityField& B = fields_[pair.b];
        stampHeavy(B);
        for (const label n : B.active())
        {
            other_[n] = inverse(B, n);
            otherOwner_[n] = prescribedStamp_[n] == stamp_ ? owner_[n] : -1;
        }
    }

    stampHeavy(A);
    for (const label n : A.active())
    {
        const scalar ia = inverse(A, n);
        scalar ib = -1;
        if (pair.b >= 0)
        {
            ib = other_[n];
        }
        else
        {
            for (int d = 0; d < nDim_; ++d)
            {
                ib = pair.wall[nDim_ * n + d] != 0 ? 0 : ib;
            }
            if (ia >= 0 && ib >= 0 && passesEdge(pair.a, n))
            {
                continue;
            }
        }
        const label bodyA = prescribedStamp_[n] == stamp_ ? owner_[n] : -1;
        const label bodyB = pair.b >= 0 ? otherOwner_[n] : -1;
        if (ia < 0 || ib < 0 || (ia + ib <= 0 && bodyA < 0 && bodyB < 0))
        {
            continue;
        }
        if (ia > 0 && ib > 0 && min(ia, ib) < 1e-8 * max(ia, ib))
        {
            continue;
        }
        contactNode m{};
        m.pair = pairi;
        m.node = n;
        m.at = position_[n];
        m.ia = ia;
        m.ib = ib;
        m.bodyA = bodyA;
        m.bodyB = bodyB;
        if (ia + ib <= 0)
        {
            // The lighter of two bodies gives way
            constexpr scalar soft = 1e-4;
            const scalar a = bodyA < 0 ? 0 : soft / bodies_[bodyA].body->mass();
            const scalar b = bodyB < 0 ? 0 : soft / bodies_[bodyB].body->mass();
            (a >= b ? m.ia : m.ib) = max(a, b);
        }
        contactNodes_.append(m);
    }

    if (pair.b >= 0)
    {
        for (const label n : fields_[pair.b].active())
        {
            other_[n] = -1;
        }
    }
}

bool Foam::mpm::pointContact::passesEdge(const label fieldi, const label node) const
{
    const auto at = edges_[fieldi].find(node);
    if (at == edges_[fieldi].end())
    {
        return false;
    }
    // m u has the direction of u
    const scalar* mU = fields_[fieldi].momentum() + fields_[fieldi].stride() * node;
    scalar most = 0;
    for (int d = 0; d < nDim_; ++d)
    {
        most = max(most, mag(mU[d]));
    }
    for (const vector& n : at->second)
    {
        scalar along = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            along += mU[d] * n[grid_.direction(d)];
        }
        if (along <= 1e-9 * most)
        {
            return true;
        }
    }
    return false;
}

void Foam::mpm::pointContact::placeAndHalfSize(
    const materialPointCloud& cloud, const label celli, const label p, scalar* x, scalar* l) const
{
    const column* half = cloud.halfSize();

    // Without half-sizes a box of the cell's shape and the point's volume
    const scalar part = half
        ? 0
        : 0.5 * std::pow(cloud.volume()[0][p] / grid_.mesh().cellVolumes()[celli], 1.0 / nDim_);
    for (int d = 0; d < 3; ++d)
    {
        x[d] = d < nDim_ ? cloud.x()[d][p] : 0;
        l[d] = d >= nDim_ ? 0 : half ? (*half)[d][p] : part * grid_.width(celli, d);
    }
}

void Foam::mpm::pointContact::setNear(const label fieldi)
{
    const int radial = grid_.radial();
    const int stride = fields_[fieldi].stride();
    scalarList& g = gradient_[fieldi];
    DynamicList<label> nodes;
    DynamicList<scalar> S, gradS;
    near_.setSize(phases_.size());
    forAll(phases_, phasei)
    {
        if (fieldOf_[phasei] != fieldi)
        {
            continue;
        }
        const materialPointCloud& cloud = phases_[phasei].cloud();
        nearPoints& near = near_[phasei];
        near.cells.clear();
        near.nodes.clear();
        near.end.clear();
        near.S.clear();
        gridTransfer_.forStencils(
            cloud,
            [&](const label k, const labelUList& stencil)
            {
                bool reaches = false;
                for (const label node : stencil)
                {
                    reaches = reaches || (node >= 0 && placeOf_[node] >= 0);
                }
                if (!reaches)
                {
                    return;
                }
                near.cells.append(k);
                const label celli = cloud.cells()[k];
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    scalar x[3], l[3];
                    placeAndHalfSize(cloud, celli, p, x, l);
                    gridTransfer_.weights(
                        celli, x, cloud.halfSize() ? l : nullptr, nodes, S, gradS);

                    // Section of the ring, whose volume also grows with the
                    // radius
                    const scalar v = cloud.volume()[0][p] / (radial < 0 ? scalar(1) : x[radial]);
                    forAll(nodes, i)
                    {
                        const label n = nodes[i];
                        if (n < 0 || placeOf_[n] < 0)
                        {
                            continue;
                        }
                        near.nodes.append(n);
                        near.S.append(S[i]);
                        if (ball_.size())
                        {
                            addBall(n, x, v, g.data() + stride * n);
                            continue;
                        }
                        for (int d = 0; d < nDim_; ++d)
                        {
                            g[stride * n + d] += v * gradS[nDim_ * i + d];
                        }
                    }
                    near.end.append(near.nodes.size());
                }
            });
    }
}

void Foam::mpm::pointContact::sumGradients()
{
    forAll(fields_, fieldi)
    {
        if (!has_[fieldi])
        {
            continue;
        }
        velocityField& field = fields_[fieldi];
        const int stride = field.stride();
        scalarList& g = gradient_[fieldi];
        g.setSize(stride * grid_.nNodes());
        for (const label n : field.active())
        {
            for (int d = 0; d < nDim_; ++d)
            {
                g[stride * n + d] = 0;
            }
        }
        for (const contactNode& m : contactNodes_)
        {
            const contactPair& pair = pairs_[m.pair];
            if (pair.a == fieldi || pair.b == fieldi)
            {
                placeOf_[m.node] = 0;
            }
        }
        setNear(fieldi);
        for (const contactNode& m : contactNodes_)
        {
            placeOf_[m.node] = -1;
        }
        field.sumColumn(g.data());
    }
}

void Foam::mpm::pointContact::setNormals()
{
    // |g| where the normal comes from the points
    DynamicList<scalar> steep;
    scalarList steepest(pairs_.size(), scalar(0));
    for (contactNode& m : contactNodes_)
    {
        const contactPair& pair = pairs_[m.pair];
        const velocityField& A = fields_[pair.a];
        const bool given = mag(pair.how.normal) > 0;
        scalar wa = 1, wb = 1, size2 = GREAT;
        if (pair.b >= 0 && !given)
        {
            // The body whose surface is flat at the node counts, not the edge
            // of the other, whose gradient is smaller
            scalar square[2] = {0, 0}, both = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                const scalar ga = gradient_[pair.a][A.stride() * m.node + d];
                const scalar gb = gradient_[pair.b][A.stride() * m.node + d];
                square[0] += sqr(ga);
                square[1] += sqr(gb);
                both += ga * gb;
            }
            const scalar larger = max(max(square[0], square[1]), VSMALL);
            size2 = larger;
            steepest[m.pair] = max(steepest[m.pair], std::sqrt(larger));
            wa = std::pow(square[0] / larger, 50);
            wb = std::pow(square[1] / larger, 50);
            if (hard(m) && (m.bodyA < 0 || m.bodyB < 0))
            {
                // One of them, if they are alike the one that is prescribed:
                // a normal that turns from node to node would lift the body
                const bool takeA = square[0] > (m.bodyA < 0 ? 0.64 : 1 / 0.64) * square[1];
                wa = takeA ? 1 : 0;
                wb = 1 - wa;
            }
            // Both along one line, of which setGaps() takes the direction
            wb *= both > 0 ? -1 : 1;
        }
        for (int d = 0; d < nDim_; ++d)
        {
            m.n[d] = pair.b < 0 ? pair.wall[nDim_ * m.node + d]
                : given         ? pair.how.normal[grid_.direction(d)]
                                : wa * gradient_[pair.a][A.stride() * m.node + d]
                    - wb * gradient_[pair.b][A.stride() * m.node + d];
        }
        steep.append(std::sqrt(size2));
    }
    if (ball_.size())
    {
        spreadNormals();
    }

    label kept = 0;
    forAll(contactNodes_, i)
    {
        contactNode m = contactNodes_[i];
        const contactPair& pair = pairs_[m.pair];
        const velocityField& A = fields_[pair.a];
        scalar before = 0, size = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            before += sqr(m.n[d]);
        }
        A.slip(m.node, m.n);
        if (pair.b >= 0)
        {
            fields_[pair.b].slip(m.node, m.n);
        }
        for (int d = 0; d < nDim_; ++d)
        {
            size += sqr(m.n[d]);
        }
        if (size > 1e-12 * before && before > 0)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                m.n[d] /= std::sqrt(size);
            }
            contactNodes_[kept] = m;
            steep[kept++] = steep[i];
        }
    }
    contactNodes_.resize(kept);
    if (bodies_.empty() || ball_.size())
    {
        return;
    }

    // At nodes that surfaces hardly reach the normal is that of a corner: light
    // nodes would not feel it, but a body has no light nodes
    Pstream::listCombineGather(steepest, maxEqOp<scalar>());
    Pstream::listCombineScatter(steepest);
    kept = 0;
    forAll(contactNodes_, i)
    {
        const contactNode m = contactNodes_[i];
        if ((m.bodyA < 0 && m.bodyB < 0) || steep[i] > 0.25 * steepest[m.pair])
        {
            contactNodes_[kept++] = m;
        }
    }
    contactNodes_.resize(kept);
}

Foam::FixedList<Foam::scalar, 2>
Foam::mpm::pointContact::reach(const contactNode& m, const scalar* x, const scalar* l) const
{
    scalar along = 0, R = 0;
    for (int d = 0; d < nDim_; ++d)
    {
        along += distance(m.node, x, d) * m.n[d];
        R += sqr(l[d] * m.n[d]);
    }
    R = std::sqrt(R);
    return {along + R, R - along};
}

void Foam::mpm::pointContact::setGaps()
{
    scalarList reachA(bodies_.size() ? contactNodes_.size() : 0);
    scalarList reachB(reachA.size());
    label first = 0;
    forAll(pairs_, pairi)
    {
        const contactPair& pair = pairs_[pairi];
        label last = first;
        for (; last < contactNodes_.size() && contactNodes_[last].pair == pairi; ++last)
        {
            placeOf_[contactNodes_[last].node] = last;
        }
        for (int side = 0; side < 2; ++side)
        {
            const label fieldi = side == 0 ? pair.a : pair.b;
            if (fieldi < 0)
            {
                continue;
            }
            forMeetings(
                fieldi,
                [&](const label place, const scalar* x, const scalar* l, const scalar)
                {
                    const contactNode& m = contactNodes_[place];
                    const FixedList<scalar, 2> r(reach(m, x, l));
                    scalar* e = reach_.data() + nReach_ * m.node + side;
                    e += inBall(m.node, x) ? 0 : 4;
                    e[0] = max(e[0], r[side]);
                    e[2] = max(e[2], r[1 - side]);
                });
        }
        fields_[pair.a].largestOfShared(reach_.data(), nReach_, nReach_);

        for (label i = first; i < last; ++i)
        {
            contactNode& m = contactNodes_[i];
            placeOf_[m.node] = -1;
            scalar* e = reach_.data() + nReach_ * m.node;
            scalar sunk = GREAT;
            if (nReach_ > 4)
            {
                sunk = allowed * ball_[nDim_ * m.node] - max(e[0], e[4])
                    - (pair.b < 0 ? 0 : max(e[1], e[5]));
            }
            // A wall with edges ends: its planes do not hold what is beside the ball
            const bool beside =
                nReach_ > 4 && pair.b < 0 && !edges_[pair.a].empty() && !(e[0] > -GREAT);
            for (int k = 0; k + 4 < nReach_; ++k)
            {
                e[k] = e[k] > -GREAT ? e[k] : e[4 + k];
                e[4 + k] = -GREAT;
            }
            m.gap = beside ? GREAT : min(-e[0] - (pair.b < 0 ? 0 : e[1]), sunk);
            const bool turn = pair.b >= 0 && !(mag(pair.how.normal) > 0) && -e[2] - e[3] > m.gap;
            if (turn)
            {
                m.gap = -e[2] - e[3];
                for (int d = 0; d < nDim_; ++d)
                {
                    m.n[d] = -m.n[d];
                }
            }
            if (bodies_.size())
            {
                reachA[i] = e[turn ? 2 : 0];
                reachB[i] = e[turn ? 3 : 1];
            }
            e[0] = e[1] = e[2] = e[3] = -GREAT;
        }
        if (ball_.size() && pair.b >= 0 && !(mag(pair.how.normal) > 0))
        {
            widenGaps(pair, first, last);
        }
        first = last;
    }
    if (bodies_.size())
    {
        setPlaces(reachA, reachB);
    }
}

void Foam::mpm::pointContact::setPlaces(const UList<scalar>& reachA, const UList<scalar>& reachB)
{
    label first = 0;
    forAll(pairs_, pairi)
    {
        const contactPair& pair = pairs_[pairi];
        label last = first;
        for (; last < contactNodes_.size() && contactNodes_[last].pair == pairi; ++last)
        {
            if (hard(contactNodes_[last]))
            {
                placeOf_[contactNodes_[last].node] = last;
            }
        }
        for (const label fieldi : {pair.a, pair.b})
        {
            if (fieldi < 0 || fields_[fieldi].rigid().bodies().empty())
            {
                continue;
            }
            velocityField& field = fields_[fieldi];
            const bool isA = fieldi == pair.a;
            const int stride = field.stride();

            // Sum of weights times distance from the node, and of weights
            scalarList& sums = impulse_[fieldi];
            const auto clear = [&]
            {
                for (const label n : field.active())
                {
                    for (int c = 0; c < stride; ++c)
                    {
                        sums[stride * n + c] = 0;
                    }
                }
            };
            clear();
            forMeetings(
                fieldi,
                [&](const label place, const scalar* x, const scalar* l, const scalar S)
                {
                    const contactNode& m = contactNodes_[place];
                    const scalar behind =
                        (isA ? reachA : reachB)[place] - reach(m, x, l)[isA ? 0 : 1];
                    const scalar near = 1 - behind / (0.01 * max(l[0], max(l[1], l[2])));
                    // Not those beside the ball that the gap leaves out
                    if (near <= 0 || near > 1 + 1e-9)
                    {
                        return;
                    }
                    const scalar w = near * S / (S + 0.005);
                    scalar* sum = sums.data() + stride * m.node;
                    for (int d = 0; d < nDim_; ++d)
                    {
                        sum[d] += w * (x[d] - position_[m.node][grid_.direction(d)]);
                    }
                    sum[nDim_] += w;
                });
            field.sumWithMass(sums.data());
            for (label i = first; i < last; ++i)
            {
                contactNode& m = contactNodes_[i];
                const label body = isA ? m.bodyA : m.bodyB;
                const scalar* sum = sums.cdata() + stride * m.node;
                if (!hard(m) || body < 0 || !(sum[nDim_] > 0))
                {
                    continue;
                }
                // Along n where the first point ends. Of two free bodies the
                // first
                scalar along = 0;
                for (int d = 0; d < nDim_; ++d)
                {
                    along += sum[d] * m.n[d];
                }
                for (int d = 0; d < nDim_ && (isA || m.bodyA < 0); ++d)
                {
                    m.at[grid_.direction(d)] = position_[m.node][grid_.direction(d)]
                        + (sum[d] - along * m.n[d]) / sum[nDim_]
                        + (isA ? reachA[i] : -reachB[i]) * m.n[d];
                }
            }
            clear();
        }
        for (label i = first; i < last; ++i)
        {
            placeOf_[contactNodes_[i].node] = -1;
        }
        first = last;
    }
}
