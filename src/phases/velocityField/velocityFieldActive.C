// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "velocityField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::velocityField::findRings()
{
    labelList seen(grid_.nNodes(), label(-1));
    DynamicList<label> rings;
    ringStart_.setSize(grid_.nNodes() + 1, 0);
    for (label node = 0; node < grid_.nNodes(); ++node)
    {
        seen[node] = node;
        for (const label celli : grid_.nodes().cellsOf(node))
        {
            for (const label n : grid_.nodesOf(celli))
            {
                if (seen[n] != node)
                {
                    seen[n] = node;
                    rings.append(n);
                }
            }
        }
        ringStart_[node + 1] = rings.size();
    }
    ring_.transfer(rings);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::velocityField::activate(const UList<const labelList*>& cells, const int reach)
{
    ++stampNow_;
    DynamicList<label> nodes(active_.size() + active_.size() / 8 + 16);

    // Always active: other processors send sums for them
    for (const label n : shared_.nodes())
    {
        stamp_[n] = stampNow_;
        nodes.append(n);
    }

    const auto take = [&](const label n)
    {
        if (stamp_[n] != stampNow_)
        {
            stamp_[n] = stampNow_;
            nodes.append(n);
        }
    };

    // Elsewhere the ring of the nodes is that of their cells, each once
    const bool ring = reach && !grid_.hasLattice();
    for (const labelList* list : cells)
    {
        for (const label celli : *list)
        {
            grid_.forNodesAround(celli, ring ? 0 : reach, take);
        }
    }
    if (ring && ringStart_.empty())
    {
        findRings();
    }
    for (label i = 0, n = nodes.size(); ring && i < n; ++i)
    {
        for (label e = ringStart_[nodes[i]]; e < ringStart_[nodes[i] + 1]; ++e)
        {
            take(ring_[e]);
        }
    }
    activeNew_.transfer(nodes);
}

void Foam::mpm::velocityField::sumLoad()
{
    if (load_.data())
    {
        sumColumn(load_.data());
    }
}

void Foam::mpm::velocityField::addLoad()
{
    if (load_.data())
    {
        forComponents([&](const label i) { f_.data()[i] += load_.data()[i]; });
    }
}

Foam::scalar Foam::mpm::velocityField::loadWork(const scalar dt) const
{
    scalar work = 0;
    for (label i = 0; load_.data() && i < active_.size(); ++i)
    {
        const label n = active_[i];
        for (int d = 0; d < nDim_; ++d)
        {
            work += part(n) * dt * load_.data()[stride_ * n + d]
                * (U_.data()[stride_ * n + d] + 0.5 * dU_.data()[stride_ * n + d]);
        }
    }
    return work;
}

const Foam::scalarList& Foam::mpm::velocityField::nodeVolume(const pointGridTransfer& transfer)
{
    if (nodeVolume_.empty())
    {
        nodeVolume_ = transfer.nodeVolumes(grid_, false);
    }
    return nodeVolume_;
}
