/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointContact.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointContact::setNodes
(
    const List<scalar*>& u,
    const int step,
    const List<freeBody::vector6>& V
)
{
    for (const meeting& m : meetings_)
    {
        const pairOf& pair = pairs_[m.pair];
        for (int side = 0; side < 2; ++side)
        {
            const label b = side == 0 ? m.bodyA : m.bodyB;
            if (b < 0)
            {
                continue;
            }
            const Eigen::Vector3d ub
            (
                bodies_[b].body->at(position_[m.node], false)*V[b]
            );
            scalar* to = u[side == 0 ? pair.a : pair.b] + step*m.node;
            for (int d = 0; d < nDim_; ++d)
            {
                to[d] = ub(grid_.direction(d));
            }
        }
    }
}


Eigen::Matrix3d Foam::mpm::pointContact::stiffness
(
    const meeting& m,
    const bool increment
) const
{
    Eigen::Matrix3d P(Eigen::Matrix3d::Zero());
    Eigen::Vector3d n(Eigen::Vector3d::Zero()), t(n);
    for (int d = 0; d < nDim_; ++d)
    {
        n(grid_.direction(d)) = m.n[d];
        t(grid_.direction(d)) = m.Jt[d];
    }
    const scalar M = 1/(m.ia + m.ib);
    const scalar Jt = t.norm();
    if (m.stuck)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            P(grid_.direction(d), grid_.direction(d)) = 1;
        }
    }
    else
    {
        P = n*n.transpose();
        if (Jt > 0 && !increment)
        {
            // J_t = mu J_n along t; only its direction follows the slip
            t /= Jt;
            P += pairs_[m.pair].how.mu*t*n.transpose();
            Eigen::Matrix3d across(-n*n.transpose() - t*t.transpose());
            for (int d = 0; d < nDim_; ++d)
            {
                across(grid_.direction(d), grid_.direction(d)) += 1;
            }
            P += Jt/m.want*across;
        }
    }
    return M*P;
}


Foam::List<Foam::mpm::freeBody::vector6>
Foam::mpm::pointContact::pushes() const
{
    List<vector> sums(2*bodies_.size(), vector(Zero));
    for (const meeting& m : meetings_)
    {
        const scalar part = fields_[pairs_[m.pair].a].part(m.node);
        for (int side = 0; side < 2; ++side)
        {
            const label b = side == 0 ? m.bodyA : m.bodyB;
            vector J(Zero);
            for (int d = 0; b >= 0 && d < nDim_; ++d)
            {
                J[grid_.direction(d)] =
                    (side == 0 ? -part : part)*(m.Jn*m.n[d] + m.Jt[d]);
            }
            if (b >= 0)
            {
                sums[2*b] += J;
                sums[2*b + 1] +=
                    (position_[m.node] - bodies_[b].body->centre(false)) ^ J;
            }
        }
    }
    Pstream::listCombineGather(sums, plusEqOp<vector>());
    Pstream::listCombineScatter(sums);

    List<freeBody::vector6> J(bodies_.size());
    forAll(J, b)
    {
        for (int d = 0; d < 3; ++d)
        {
            J[b](d) = sums[2*b][d];
            J[b](3 + d) = sums[2*b + 1][d];
        }
    }
    return J;
}


Foam::List<Foam::mpm::freeBody::vector6> Foam::mpm::pointContact::newton
(
    const List<freeBody::vector6>& r,
    const bool increment
) const
{
    // C + sum G^T (-dJ/du) G over bodies
    const label n = 6*bodies_.size();
    scalarList sums(n*n, scalar(0));
    for (const meeting& m : meetings_)
    {
        if
        (
            (m.bodyA < 0 && m.bodyB < 0)
         || !m.closed
         || (increment && hard(m))
        )
        {
            continue;
        }
        const Eigen::Matrix3d K
        (
            fields_[pairs_[m.pair].a].part(m.node)*stiffness(m, increment)
        );
        const label body[2] = {m.bodyA, m.bodyB};
        for (int i = 0; i < 2; ++i)
        {
            for (int j = 0; j < 2; ++j)
            {
                if (body[i] < 0 || body[j] < 0)
                {
                    continue;
                }
                const point& x = position_[m.node];
                const freeBody::matrix6 A
                (
                    (i == j ? 1 : -1)
                   *bodies_[body[i]].body->at(x, false).transpose()
                   *K*bodies_[body[j]].body->at(x, false)
                );
                for (int a = 0; a < 6; ++a)
                {
                    for (int c = 0; c < 6; ++c)
                    {
                        sums[n*(6*body[i] + a) + 6*body[j] + c] += A(a, c);
                    }
                }
            }
        }
    }
    Pstream::listCombineGather(sums, plusEqOp<scalar>());
    Pstream::listCombineScatter(sums);

    Eigen::MatrixXd A(n, n);
    Eigen::VectorXd rhs(n);
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            A(i, j) = sums[n*i + j];
        }
    }
    forAll(bodies_, b)
    {
        A.block<6, 6>(6*b, 6*b) += bodies_[b].body->combined();
        rhs.segment<6>(6*b) = -r[b];
    }
    const Eigen::VectorXd x(A.fullPivLu().solve(rhs));

    List<freeBody::vector6> dV(bodies_.size());
    forAll(dV, b)
    {
        dV[b] = x.segment<6>(6*b);
    }
    return dV;
}


void Foam::mpm::pointContact::clearImpulses()
{
    for (const meeting& m : meetings_)
    {
        const pairOf& pair = pairs_[m.pair];
        const int stride = fields_[pair.a].stride();
        for (int d = 0; d < nDim_; ++d)
        {
            impulse_[pair.a][stride*m.node + d] = 0;
            if (pair.b >= 0)
            {
                impulse_[pair.b][stride*m.node + d] = 0;
            }
        }
    }
}


void Foam::mpm::pointContact::settle
(
    const List<scalar*>& u,
    const int step,
    const scalar dt
)
{
    constexpr label maxSteps = 100;
    const label n = bodies_.size();
    List<freeBody::vector6> V(n), r(n), J;
    forAll(bodies_, b)
    {
        V[b] = bodies_[b].body->step();
    }
    const List<freeBody::vector6> free(V);
    scalar before = GREAT, length = 1;
    for (label i = 0; i < maxSteps; ++i)
    {
        clearImpulses();
        setNodes(u, step, V);
        collide(u, step, dt, true);
        J = pushes();
        scalar all = 0;
        forAll(bodies_, b)
        {
            const freeBody& body = *bodies_[b].body;
            r[b] = body.combined()*(V[b] - body.step()) - body.masked(J[b]);
            all += V[b].dot(body.combined()*V[b])
              + body.response(J[b]).dot(J[b]);
        }
        const List<freeBody::vector6> dV(newton(r, false));
        scalar size = 0;
        forAll(bodies_, b)
        {
            size += dV[b].dot(bodies_[b].body->combined()*dV[b]);
        }
        if (!(size > 1e-28*all))
        {
            break;
        }
        // Where nodes open and close by turns, half of the way
        length = size < before ? 1 : max(0.5*length, scalar(0.1));
        before = size;
        forAll(bodies_, b)
        {
            V[b] += length*dV[b];
        }
    }

    // gridState::addImpulse gives the nodes their change
    setNodes(u, step, free);
    forAll(bodies_, b)
    {
        bodies_[b].body->change(bodies_[b].body->response(J[b]));
    }
    for (gridState& field : fields_)
    {
        field.rigid().renew();
    }
}


void Foam::mpm::pointContact::shareIncrement()
{
    // r of W = 0: what the others' increments push
    List<vector> sums(2*bodies_.size(), vector(Zero));
    for (const meeting& m : meetings_)
    {
        if (!m.closed || hard(m) || (m.bodyA < 0 && m.bodyB < 0))
        {
            continue;
        }
        const pairOf& pair = pairs_[m.pair];
        const int step = 2*fields_[pair.a].stride();
        const scalar part = fields_[pair.a].part(m.node);
        scalar dv[3] = {0, 0, 0}, dvn = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            dv[d] =
                (
                    pair.b < 0
                  ? 0 : fields_[pair.b].increment()[step*m.node + d]
                )
              - fields_[pair.a].increment()[step*m.node + d];
            dvn += dv[d]*m.n[d];
        }
        vector take(Zero);
        for (int d = 0; d < nDim_; ++d)
        {
            take[grid_.direction(d)] =
                part*(m.stuck ? dv[d] : dvn*m.n[d])/(m.ia + m.ib);
        }
        for (int side = 0; side < 2; ++side)
        {
            const label b = side == 0 ? m.bodyA : m.bodyB;
            if (b >= 0)
            {
                const vector J(side == 0 ? take : -take);
                sums[2*b] += J;
                sums[2*b + 1] +=
                    (position_[m.node] - bodies_[b].body->centre(false)) ^ J;
            }
        }
    }
    Pstream::listCombineGather(sums, plusEqOp<vector>());
    Pstream::listCombineScatter(sums);
    List<freeBody::vector6> r(bodies_.size());
    forAll(r, b)
    {
        for (int d = 0; d < 3; ++d)
        {
            r[b](d) = -sums[2*b][d];
            r[b](3 + d) = -sums[2*b + 1][d];
        }
        r[b] = bodies_[b].body->masked(r[b]);
    }
    const List<freeBody::vector6> W(newton(r, true));
    forAll(bodies_, b)
    {
        gridState& field = fields_[bodies_[b].field];
        rigidNodes& rigid = field.rigid();
        rigid.addIncrement
        (
            rigidNodes::bodyOf{bodies_[b].phase, bodies_[b].body},
            W[b]
        );
        rigid.impose(field.increment(), 2*field.stride(), true, false);
    }
}

// ************************************************************************* //
