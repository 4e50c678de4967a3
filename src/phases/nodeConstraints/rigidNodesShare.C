// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "rigidNodes.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::rigidNodes::startShares(
    const pointGridTransfer& passes, const materialPointCloud& cloud, const scalarList& volume,
    const labelList& active, const int stride)
{
    scalar* q = mass_.data();
    power_ = passes.reach() && !passes.hasExtent() ? 5 : 2;
    for (const label n : active)
    {
        q[stride * n] = 0;
    }
    passes.forStencils(
        cloud,
        [&](const label k, const labelUList& stencil)
        {
            scalar most = VSMALL;
            for (const label n : grid_.nodesOf(cloud.cells()[k]))
            {
                most = max(most, q[stride * n + grid_.nDim()] / volume[n]);
            }
            for (const label n : stencil)
            {
                if (n >= 0)
                {
                    q[stride * n] = max(q[stride * n], 1 / most);
                }
            }
        });
}

void Foam::mpm::rigidNodes::fill(const scalar* mU, const int stride)
{
    forAll(next_.node, i)
    {
        if (!(mU[stride * next_.node[i] + grid_.nDim()] > 0))
        {
            next_.weight[i] = 1;
        }
    }
}

Foam::scalar* Foam::mpm::rigidNodes::clearSums(const labelList& active)
{
    if (!sums_.data())
    {
        sums_ = alignedArray(nSums * grid_.nNodes());
    }
    for (const label n : active)
    {
        for (int c = 0; c < nSums; ++c)
        {
            sums_.data()[nSums * n + c] = 0;
        }
    }

    // Nodes that addSums() needs
    near_.setSize(grid_.nNodes());
    near_ = false;
    forAll(now_.node, i)
    {
        near_[now_.node[i]] = now_.weight[i] < 1;
    }
    return sums_.data();
}

void Foam::mpm::rigidNodes::addSums(
    const pointGridTransfer& passes, const materialPointCloud& cloud, const bool rigid)
{
    const int D = grid_.nDim();
    passes.forNodesOf(
        cloud, near_,
        [&](const label p, const label node, const scalar S, const scalar* A)
        {
            scalar* q = sums_.data() + nSums * node;
            for (int d = 0; d < D; ++d)
            {
                q[(rigid ? 10 : 7) + d] += A[d];
            }
            if (rigid)
            {
                return;
            }
            const scalar vS = cloud.volume()[0][p] * S;
            const tensor sigma(cloud.sigma(p));
            q[0] += vS;
            for (int d = 0, c = 1; d < D; ++d)
            {
                for (int e = d; e < D; ++e)
                {
                    q[c++] += vS * sigma(grid_.direction(d), grid_.direction(e));
                }
            }
        });
}

void Foam::mpm::rigidNodes::addTraction(const int stride, scalar* force)
{
    const int D = grid_.nDim();
    traction_.resize(D * now_.node.size());
    forAll(now_.node, i)
    {
        scalar* t = traction_.begin() + D * i;
        const scalar* q = sums_.data() + nSums * now_.node[i];
        for (int d = 0; d < D; ++d)
        {
            t[d] = 0;
        }
        if (!(now_.weight[i] < 1) || !(q[0] > 0))
        {
            continue;
        }
        for (int d = 0, c = 1; d < D; ++d)
        {
            for (int e = d; e < D; ++e)
            {
                const scalar sigma = q[c++] / q[0];
                const auto surface = [&](const int f)
                {
                    const scalar a = q[10 + f], b = -q[7 + f];
                    return a * b > 0 ? (mag(a) < mag(b) ? a : b) : 0;
                };
                t[d] -= sigma * surface(e);
                if (e > d)
                {
                    t[e] -= sigma * surface(d);
                }
            }
        }
        for (int d = 0; d < D; ++d)
        {
            force[stride * now_.node[i] + d] += t[d];
        }
    }
}

Foam::scalar Foam::mpm::rigidNodes::tractionWork(
    const scalar dt, const scalar* U, const scalar* dU, const int stride) const
{
    const int D = grid_.nDim();
    scalar work = 0;
    forAll(traction_, j)
    {
        const label n = now_.node[j / D];
        const int d = j % D;
        work +=
            now_.part[j / D] * dt * traction_[j] * (U[stride * n + d] + 0.5 * dU[stride * n + d]);
    }
    return work;
}

void Foam::mpm::rigidNodes::addTractionImpulse(const scalar dt)
{
    const int D = grid_.nDim();
    forAll(traction_, j)
    {
        step_[now_.phase[j / D]][grid_.direction(j % D)] -= now_.part[j / D] * dt * traction_[j];
    }
}
