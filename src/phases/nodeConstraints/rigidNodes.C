// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "rigidNodes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::rigidNodes::setVelocity(const label phasei, const rigidMotion& motion, nodeSet& set)
{
    const int D = grid_.nDim();
    set.value.resize(D * set.node.size());
    forAll(set.node, i)
    {
        if (set.phase[i] == phasei)
        {
            const vector u(motion.now().velocityAt(position_[set.node[i]]));
            for (int d = 0; d < D; ++d)
            {
                set.value[D * i + d] = u[grid_.direction(d)];
            }
        }
    }
}

void Foam::mpm::rigidNodes::setVelocity(
    const bodyOf& b, const vector6& V, const bool tentative, const nodeSet& set,
    DynamicList<scalar>& to) const
{
    const int D = grid_.nDim();
    to.resize(D * set.node.size());
    forAll(set.node, i)
    {
        if (set.phase[i] == b.phase)
        {
            const vector u(b.body->at(position_[set.node[i]], tentative) * V);
            for (int d = 0; d < D; ++d)
            {
                to[D * i + d] = u[grid_.direction(d)];
            }
        }
    }
}

Foam::mpm::vector6 Foam::mpm::rigidNodes::sumOver(
    const bodyOf& b, const bool tentative, const scalar* u, const vector6& V, const scalar* mU,
    const int stride, matrix6* A) const
{
    const nodeSet& set = tentative ? next_ : now_;
    const int D = grid_.nDim();

    // The vector followed by the upper half of A
    scalarList sums(A ? 27 : 6, scalar(0));
    vector6 rhs(Zero);
    matrix6 mass(Zero);
    forAll(set.node, i)
    {
        const label n = set.node[i];
        const scalar m = set.part[i] * mU[stride * n + D];
        if (set.phase[i] != b.phase || !(m > 0))
        {
            continue;
        }
        const matrix36 G(b.body->at(position_[n], tentative));
        vector un(Zero);
        for (int d = 0; d < D; ++d)
        {
            un[grid_.direction(d)] = u[stride * n + d];
        }
        rhs += m * G.transposed(un - G * V);
        for (int j = 0; A && j < 6; ++j)
        {
            const vector6 column(G.transposed(G[j]));
            for (int i = 0; i <= j; ++i)
            {
                mass(i, j) += m * column[i];
            }
        }
    }
    label k = 0;
    for (int i = 0; i < 6; ++i)
    {
        sums[k++] = rhs[i];
    }
    for (int i = 0; A && i < 6; ++i)
    {
        for (int j = i; j < 6; ++j)
        {
            sums[k++] = mass(i, j);
        }
    }
    Pstream::listCombineGather(sums, plusEqOp<scalar>());
    Pstream::listCombineScatter(sums);
    k = 0;
    for (int i = 0; i < 6; ++i)
    {
        rhs[i] = sums[k++];
    }
    for (int i = 0; A && i < 6; ++i)
    {
        for (int j = i; j < 6; ++j)
        {
            (*A)(i, j) = (*A)(j, i) = sums[k++];
        }
    }
    return rhs;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::rigidNodes::rigidNodes(const pointGrid& grid) : grid_(grid), shares_(false), power_(2) {}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::rigidNodes::setPhases(const label n)
{
    step_.setSize(n, vector(Zero));
    sum_.setSize(n, vector(Zero));
}

Foam::scalar* Foam::mpm::rigidNodes::clearMass(const labelList& active, const int stride)
{
    if (!mass_.data())
    {
        mass_ = alignedArray(stride * grid_.nNodes());
        position_ = grid_.nodePositions();
    }
    for (const label n : active)
    {
        for (int c = 0; c < stride; ++c)
        {
            mass_.data()[stride * n + c] = 0;
        }
    }
    return mass_.data();
}

void Foam::mpm::rigidNodes::clear()
{
    next_.node.clear();
    next_.phase.clear();
    next_.value.clear();
    next_.increment.clear();
    next_.part.clear();
    next_.weight.clear();
}

void Foam::mpm::rigidNodes::add(
    const label phasei, const rigidMotion& motion, const scalar largest, const scalarList* volume,
    const labelList& active, const int stride)
{
    const scalar* mass = mass_.data() + grid_.nDim();
    const auto weight = [&](const label n)
    {
        return volume ? std::pow(
                   min(scalar(1), mass[stride * n] / (*volume)[n] * mass_.data()[stride * n] / 0.8),
                   power_)
                      : 1;
    };

    // Nodes that an earlier phase of the list has as well are marked by a
    // negative mass
    forAll(next_.node, i)
    {
        const label n = next_.node[i];
        if (mass[stride * n] > 1e-9 * largest && weight(n) > next_.weight[i])
        {
            next_.phase[i] = phasei;
            next_.weight[i] = weight(n);
        }
        mass_.data()[stride * n + grid_.nDim()] = -1;
    }
    for (const label n : active)
    {
        if (mass[stride * n] > 1e-9 * largest)
        {
            next_.node.append(n);
            next_.phase.append(phasei);
            next_.weight.append(weight(n));
        }
    }
    setVelocity(phasei, motion, next_);
}

Foam::scalar* Foam::mpm::rigidNodes::marks(const labelList& active, const int stride)
{
    scalar* marks = clearMass(active, stride);
    for (const label n : next_.node)
    {
        marks[stride * n] = 1;
    }
    return marks;
}

void Foam::mpm::rigidNodes::setParts(const scalar* marks, const int stride)
{
    next_.part.resize(next_.node.size());
    forAll(next_.node, i)
    {
        next_.part[i] = 1 / marks[stride * next_.node[i]];
    }
}

void Foam::mpm::rigidNodes::combine(const scalar* u, const scalar* mU, const int stride)
{
    for (const bodyOf& b : bodies_)
    {
        matrix6 A;
        const vector6 rhs(sumOver(b, true, u, b.body->velocityNew(), mU, stride, &A));
        b.body->combine(A, rhs);
        setVelocity(b, b.body->start(true), true, next_, next_.value);
    }
    if (bodies_.size())
    {
        next_.increment.resize(next_.value.size());
        next_.increment = 0;
    }
}

void Foam::mpm::rigidNodes::begin(const scalar dt, const vector& g)
{
    for (const bodyOf& b : bodies_)
    {
        b.body->begin(dt, g);
    }
    renew();
}

void Foam::mpm::rigidNodes::take(const scalar* u, const scalar* mU, const int stride)
{
    for (const bodyOf& b : bodies_)
    {
        if (b.body->shares())
        {
            b.body->change(
                b.body->response(sumOver(b, false, u, b.body->step(), mU, stride, nullptr)));
        }
    }
    renew();
}

void Foam::mpm::rigidNodes::takeIncrement(
    const scalar* u, const scalar* mU, const int stride, const bool changes)
{
    for (const bodyOf& b : bodies_)
    {
        vector6 W(Zero);
        if (b.body->shares())
        {
            W = b.body->response(sumOver(b, false, u, W, mU, stride, nullptr));
        }
        setVelocity(b, W, false, now_, now_.increment);
        if (changes)
        {
            b.body->change(W);
        }
    }
    if (changes)
    {
        renew();
    }
}

void Foam::mpm::rigidNodes::renew()
{
    for (const bodyOf& b : bodies_)
    {
        setVelocity(b, b.body->step(), false, now_, now_.value);
    }
}

void Foam::mpm::rigidNodes::addIncrement(const bodyOf& b, const vector6& W)
{
    DynamicList<scalar> more;
    setVelocity(b, W, false, now_, more);
    const int D = grid_.nDim();
    forAll(now_.node, i)
    {
        for (int d = 0; now_.phase[i] == b.phase && d < D; ++d)
        {
            now_.increment[D * i + d] += more[D * i + d];
        }
    }
    b.body->change(W);
    renew();
}

void Foam::mpm::rigidNodes::newVelocity(const label phasei, const rigidMotion& motion)
{
    setVelocity(phasei, motion, now_);
}

void Foam::mpm::rigidNodes::impose(
    scalar* u, const int stride, const bool homogeneous, const bool tentative) const
{
    const nodeSet& set = tentative ? next_ : now_;
    const int D = grid_.nDim();
    forAll(set.node, i)
    {
        const scalar w = set.weight[i];
        for (int d = 0; d < D; ++d)
        {
            scalar& un = u[stride * set.node[i] + d];
            const scalar to = imposed(set, homogeneous, D * i + d);
            un = w < 1 ? un + w * (to - un) : to;
        }
    }
}

void Foam::mpm::rigidNodes::addImpulse(
    const scalar* u, const bool homogeneous, const scalar* mU, const int stride)
{
    const int D = grid_.nDim();
    forAll(now_.node, i)
    {
        const label n = now_.node[i];
        const scalar m = now_.weight[i] * now_.part[i] * mU[stride * n + D];
        for (int d = 0; d < D; ++d)
        {
            step_[now_.phase[i]][grid_.direction(d)] +=
                m * (u[stride * n + d] - imposed(now_, homogeneous, D * i + d));
        }
    }
}

void Foam::mpm::rigidNodes::mark(labelHashSet& constrained) const
{
    forAll(now_.node, i)
    {
        if (isFree(now_.phase[i]))
        {
            constrained.erase(now_.node[i]);
        }
        else
        {
            constrained.insert(now_.node[i]);
        }
    }
}

void Foam::mpm::rigidNodes::addProjectionImpulse(
    const scalar a, const scalar* U, const scalar* mU, const int stride)
{
    const int D = grid_.nDim();
    forAll(now_.node, i)
    {
        const label n = now_.node[i];
        for (int d = 0; d < D; ++d)
        {
            step_[now_.phase[i]][grid_.direction(d)] +=
                a * now_.part[i] * (mU[stride * n + d] - mU[stride * n + D] * U[stride * n + d]);
        }
    }
}

void Foam::mpm::rigidNodes::addImpulse(const scalar* J, const scalar* mU, const int stride)
{
    const int D = grid_.nDim();
    forAll(now_.node, i)
    {
        for (int d = 0; d < D && !(mU[stride * now_.node[i] + D] > 0); ++d)
        {
            step_[now_.phase[i]][grid_.direction(d)] += now_.part[i] * J[stride * now_.node[i] + d];
        }
    }
}

void Foam::mpm::rigidNodes::newTime() { step_ = Zero; }

void Foam::mpm::rigidNodes::takeNew()
{
    now_.node.swap(next_.node);
    now_.phase.swap(next_.phase);
    now_.value.swap(next_.value);
    now_.increment.swap(next_.increment);
    for (const bodyOf& b : bodies_)
    {
        b.body->acceptNodes();
    }
    now_.part.swap(next_.part);
    now_.weight.swap(next_.weight);
    traction_.resize(shares_ ? grid_.nDim() * now_.node.size() : 0);
    traction_ = 0;
}

void Foam::mpm::rigidNodes::accept()
{
    takeNew();
    forAll(step_, phasei)
    {
        sum_[phasei] += step_[phasei];
    }
}

Foam::vector Foam::mpm::rigidNodes::stepImpulse(const label phasei) const
{
    return returnReduce(step_[phasei], sumOp<vector>());
}

Foam::vector Foam::mpm::rigidNodes::impulse(const label phasei) const
{
    return returnReduce(sum_[phasei], sumOp<vector>());
}

void Foam::mpm::rigidNodes::setImpulse(const label phasei, const vector& impulse)
{
    sum_[phasei] = Pstream::master() ? impulse : vector(Zero);
}
