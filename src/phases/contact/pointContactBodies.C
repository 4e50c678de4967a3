// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointContact.H"
#include "scalarMatrices.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointContact::setBodyU(const List<vector6>& V)
{
    for (contactNode& m : contactNodes_)
    {
        for (int side = 0; side < 2; ++side)
        {
            const label b = side == 0 ? m.bodyA : m.bodyB;
            if (b < 0)
            {
                continue;
            }
            const vector ub(bodies_[b].body->at(m.at, false) * V[b]);
            for (int d = 0; d < nDim_; ++d)
            {
                m.bodyU[side][d] = ub[grid_.direction(d)];
            }
        }
    }
}

Foam::tensor Foam::mpm::pointContact::stiffness(const contactNode& m, const slope kind) const
{
    tensor P(Zero);
    vector n(Zero), t(Zero);
    for (int d = 0; d < nDim_; ++d)
    {
        n[grid_.direction(d)] = m.n[d];
        t[grid_.direction(d)] = m.Jt[d];
    }
    const scalar M = 1 / (m.ia + m.ib);
    const scalar Jt = mag(t);
    if (m.stuck)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            P(grid_.direction(d), grid_.direction(d)) = 1;
        }
    }
    else
    {
        P = n * n;
        if (Jt > 0 && kind != ofFilter)
        {
            // |J_t| is proportional to J_n and points along the slip
            tensor across(-n * n);
            if (kind == tangent)
            {
                t /= Jt;
                P += m.slope * t * n;
                across -= t * t;
            }
            for (int d = 0; d < nDim_; ++d)
            {
                across(grid_.direction(d), grid_.direction(d)) += 1;
            }
            P += Jt / m.stickImpulse * across;
        }
    }
    return M * P;
}

template<class Impulse>
Foam::List<Foam::mpm::vector6> Foam::mpm::pointContact::sumOverBodies(const Impulse& impulse) const
{
    List<vector> sums(2 * bodies_.size(), vector(Zero));
    for (const contactNode& m : contactNodes_)
    {
        scalar J[3] = {0, 0, 0};
        impulse(m, fields_[pairs_[m.pair].a].part(m.node), J);
        for (int side = 0; side < 2; ++side)
        {
            const label b = side == 0 ? m.bodyA : m.bodyB;
            vector Jb(Zero);
            for (int d = 0; b >= 0 && d < nDim_; ++d)
            {
                Jb[grid_.direction(d)] = side == 0 ? -J[d] : J[d];
            }
            if (b >= 0)
            {
                sums[2 * b] += Jb;
                sums[2 * b + 1] += (m.at - bodies_[b].body->centre(false)) ^ Jb;
            }
        }
    }
    Pstream::listCombineGather(sums, plusEqOp<vector>());
    Pstream::listCombineScatter(sums);

    List<vector6> all(bodies_.size());
    forAll(all, b)
    {
        all[b] = vector6(sums[2 * b], sums[2 * b + 1]);
    }
    return all;
}

Foam::List<Foam::mpm::vector6> Foam::mpm::pointContact::pushes() const
{
    return sumOverBodies(
        [&](const contactNode& m, const scalar part, scalar* J)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                J[d] = part * (m.Jn * m.n[d] + m.Jt[d]);
            }
        });
}

Foam::List<Foam::mpm::vector6>
Foam::mpm::pointContact::newton(const List<vector6>& r, const slope kind) const
{
    // C + sum G^T (-dJ/du) G over bodies
    const label n = 6 * bodies_.size();
    scalarList sums(n * n, scalar(0));
    for (const contactNode& m : contactNodes_)
    {
        if ((m.bodyA < 0 && m.bodyB < 0) || !m.closed || (kind == ofFilter && hard(m)))
        {
            continue;
        }
        const tensor K(fields_[pairs_[m.pair].a].part(m.node) * stiffness(m, kind));
        const label body[2] = {m.bodyA, m.bodyB};
        for (int i = 0; i < 2; ++i)
        {
            for (int j = 0; j < 2; ++j)
            {
                if (body[i] < 0 || body[j] < 0)
                {
                    continue;
                }
                const point& x = m.at;
                const matrix36 Gi(bodies_[body[i]].body->at(x, false));
                const matrix36 Gj(bodies_[body[j]].body->at(x, false));
                for (int c = 0; c < 6; ++c)
                {
                    const vector6 column((i == j ? 1 : -1) * Gi.transposed(K & Gj[c]));
                    for (int a = 0; a < 6; ++a)
                    {
                        sums[n * (6 * body[i] + a) + 6 * body[j] + c] += column[a];
                    }
                }
            }
        }
    }
    Pstream::listCombineGather(sums, plusEqOp<scalar>());
    Pstream::listCombineScatter(sums);

    scalarSquareMatrix A(n);
    scalarField x(n);
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            A(i, j) = sums[n * i + j];
        }
    }
    forAll(bodies_, b)
    {
        const matrix6& C = bodies_[b].body->combined();
        for (int i = 0; i < 6; ++i)
        {
            for (int j = 0; j < 6; ++j)
            {
                A(6 * b + i, 6 * b + j) += C(i, j);
            }
            x[6 * b + i] = -r[b][i];
        }
    }
    LUsolve(A, x);

    List<vector6> dV(bodies_.size());
    forAll(dV, b)
    {
        for (int i = 0; i < 6; ++i)
        {
            dV[b][i] = x[6 * b + i];
        }
    }
    return dV;
}

void Foam::mpm::pointContact::clearImpulses()
{
    for (const contactNode& m : contactNodes_)
    {
        const contactPair& pair = pairs_[m.pair];
        const int stride = fields_[pair.a].stride();
        for (int d = 0; d < nDim_; ++d)
        {
            impulse_[pair.a][stride * m.node + d] = 0;
            if (pair.b >= 0)
            {
                impulse_[pair.b][stride * m.node + d] = 0;
            }
        }
    }
}

void Foam::mpm::pointContact::solveBodies(const List<scalar*>& u, const int step, const scalar dt)
{
    constexpr label maxSteps = 100;
    slope kind = tangent;
    const label n = bodies_.size();
    List<vector6> V(n), r(n), J, dV;
    forAll(bodies_, b)
    {
        V[b] = bodies_[b].body->step();
    }
    scalar before = GREAT, length = 1;
    bool settled = false;
    for (label i = 0; i < maxSteps; ++i)
    {
        clearImpulses();
        setBodyU(V);
        computeImpulses(u, step, dt, true);
        J = pushes();
        scalar all = 0, size = 0;
        forAll(bodies_, b)
        {
            const freeBody& body = *bodies_[b].body;
            r[b] = body.combined() * (V[b] - body.step()) - body.masked(J[b]);
            all += (V[b] && (body.combined() * V[b])) + (body.response(J[b]) && J[b]);
        }
        kind = i < 10 ? tangent : secant;
        dV = newton(r, kind);
        forAll(bodies_, b)
        {
            size += dV[b] && (bodies_[b].body->combined() * dV[b]);
        }
        if (!(size > 1e-24 * all))
        {
            settled = true;
            break;
        }
        // Half the step length where nodes keep opening and closing
        length = size < before || i == 10 ? 1 : max(0.5 * length, scalar(0.1));
        before = size;
        forAll(bodies_, b)
        {
            V[b] += (i + 1 < maxSteps ? length : 0) * dV[b];
        }
    }

    nUnsettled_ += settled ? 0 : 1;

    // The last step in J, not in V: rounding does not grow by the stiffness, and
    // what did not converge stays that of a linear contact
    for (contactNode& m : contactNodes_)
    {
        if ((m.bodyA < 0 && m.bodyB < 0) || !m.closed)
        {
            continue;
        }
        vector du(Zero);
        if (m.bodyA >= 0)
        {
            du -= bodies_[m.bodyA].body->at(m.at, false) * dV[m.bodyA];
        }
        if (m.bodyB >= 0)
        {
            du += bodies_[m.bodyB].body->at(m.at, false) * dV[m.bodyB];
        }
        const vector dJ(-stiffness(m, kind) & du);
        const contactPair& pair = pairs_[m.pair];
        const label at = fields_[pair.a].stride() * m.node;
        for (int d = 0; d < nDim_; ++d)
        {
            const scalar more = dJ[grid_.direction(d)];
            m.Jt[d] += more;
            impulse_[pair.a][at + d] -= more;
            if (pair.b >= 0)
            {
                impulse_[pair.b][at + d] += more;
            }
        }
    }
    J = pushes();

    // The nodes get their change in velocityField::addImpulse
    forAll(fields_, fieldi)
    {
        fields_[fieldi].rigid().impose(u[fieldi], step, false, false);
    }
    forAll(bodies_, b)
    {
        bodies_[b].body->change(bodies_[b].body->response(J[b]));
    }
    for (velocityField& field : fields_)
    {
        field.rigid().renew();
    }
}

void Foam::mpm::pointContact::shareIncrement()
{
    // r for W = 0: impulses from the increments of the other side
    List<vector6> r(sumOverBodies(
        [&](const contactNode& m, const scalar part, scalar* J)
        {
            if (!m.closed || hard(m))
            {
                return;
            }
            const contactPair& pair = pairs_[m.pair];
            const int step = fields_[pair.a].stride();
            scalar dv[3] = {0, 0, 0}, dvn = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                dv[d] = (pair.b < 0 ? 0 : fields_[pair.b].increment()[step * m.node + d])
                    - fields_[pair.a].increment()[step * m.node + d];
                dvn += dv[d] * m.n[d];
            }
            for (int d = 0; d < nDim_; ++d)
            {
                J[d] = part * (m.stuck ? dv[d] : dvn * m.n[d]) / (m.ia + m.ib);
            }
        }));
    forAll(r, b)
    {
        r[b] = bodies_[b].body->masked(r[b]);
    }
    const List<vector6> W(newton(r, ofFilter));
    forAll(bodies_, b)
    {
        velocityField& field = fields_[bodies_[b].field];
        rigidNodes& rigid = field.rigid();
        rigid.addIncrement(rigidNodes::bodyOf{bodies_[b].phase, bodies_[b].body}, W[b]);
        const int stride = field.stride();
        rigid.addImpulse(field.increment(), true, field.momentum(), stride);
        rigid.impose(field.increment(), stride, true, false);
    }
}
