// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "nodeReactions.H"
#include "Time.H"
#include "scalarField.H"
#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::nodeReactions::nodeReactions(
    const pointGrid& grid, const UList<part>& parts, const sharedNodes& shared) :
    grid_(grid),
    parts_(parts),
    place_(grid.nNodes(), label(-1)),
    now_(0),
    dt_(0),
    index_(grid.mesh().time().timeIndex())
{
    for (const part& p : parts_)
    {
        if (place_[p.node] < 0)
        {
            place_[p.node] = nodes_.size();
            nodes_.append(p.node);
        }
    }
    impulse_.setSize(grid_.nDim() * nodes_.size(), Zero);
    taken_ = impulse_;

    // Ghost nodes have no mesh point: the mean of what other processors have,
    // which is one place unless sides are cyclic
    scalarField x;
    if (Pstream::parRun())
    {
        nActive_.setSize(grid_.nNodes(), 1);
        x.setSize(4 * grid_.nNodes(), Zero);
        forAll(grid_.nodePoint(), node)
        {
            if (grid_.nodePoint()[node] >= 0)
            {
                const point& at = grid_.mesh().points()[grid_.nodePoint()[node]];
                std::copy(at.begin(), at.end(), &x[4 * node]);
                x[4 * node + 3] = 1;
            }
        }
        shared.sum(x.data(), 4, 4);
    }
    for (part& p : parts_)
    {
        if (grid_.nodePoint()[p.node] >= 0)
        {
            p.x = grid_.mesh().points()[grid_.nodePoint()[p.node]];
        }
        else
        {
            const scalar* at = &x[4 * p.node];
            p.x = point(at[0], at[1], at[2]) / at[3];
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::mpm::nodeReactions::impulse(const part& p) const
{
    const int D = grid_.nDim();
    const scalar* J = taken_.cdata() + D * place_[p.node];

    scalar along = 0;
    for (int d = 0; d < D; ++d)
    {
        along += J[d] * p.normal[d];
    }
    vector result(Zero);
    for (int d = 0; d < D; ++d)
    {
        result[grid_.direction(d)] = p.fixed ? J[d] : along * p.normal[d];
    }
    return result;
}

void Foam::mpm::nodeReactions::start(
    const scalar dt, const labelUList& active, const sharedNodes& shared)
{
    now_ = dt;
    impulse_ = Zero;
    const label index = grid_.mesh().time().timeIndex();
    if (index != index_)
    {
        index_ = index;
        taken_ = Zero;
        dt_ = 0;
    }

    if (nActive_.size())
    {
        for (const label n : shared.nodes())
        {
            nActive_[n] = 0;
        }
        for (const label n : active)
        {
            nActive_[n] = 1;
        }
        shared.sum(nActive_.data(), 1, 1);
    }
}

void Foam::mpm::nodeReactions::accept()
{
    const int D = grid_.nDim();
    forAll(nodes_, k)
    {
        const scalar share = nActive_.size() ? 1 / max(nActive_[nodes_[k]], scalar(1)) : 1;
        for (label i = D * k; i < D * (k + 1); ++i)
        {
            taken_[i] += share * impulse_[i];
        }
    }
    impulse_ = Zero;
    dt_ += now_;
}

template<class Impulse>
void Foam::mpm::nodeReactions::addAt(const labelUList& nodes, const Impulse& impulse)
{
    const int D = grid_.nDim();
    for (const label n : nodes)
    {
        if (place_[n] >= 0)
        {
            scalar* J = impulse_.data() + D * place_[n];
            for (int d = 0; d < D; ++d)
            {
                J[d] += impulse(n, d);
            }
        }
    }
}

void Foam::mpm::nodeReactions::add(
    const labelUList& nodes, const scalar sign, const scalar* u, const scalar* mU, const int stride)
{
    const int D = grid_.nDim();
    addAt(
        nodes,
        [=](const label n, const int d) { return sign * mU[stride * n + D] * u[stride * n + d]; });
}

void Foam::mpm::nodeReactions::addProjected(
    const labelUList& nodes, const scalar share, const scalar* u, const scalar* mU,
    const int stride)
{
    const int D = grid_.nDim();
    addAt(
        nodes,
        [=](const label n, const int d)
        { return share * (mU[stride * n + D] * u[stride * n + d] - mU[stride * n + d]); });
}
