// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "sharedNodes.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "HashSet.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::sharedNodes::sharedNodes(const labelUList& places, const labelUList& placeKeys)
{
    if (!Pstream::parRun())
    {
        return;
    }

    // Keys that each processor offers
    Map<label> nodeOfKey(2 * places.size());
    labelListList keys(Pstream::nProcs());
    labelList& mine = keys[Pstream::myProcNo()];
    mine = placeKeys;
    forAll(places, i)
    {
        nodeOfKey.insert(placeKeys[i], places[i]);
    }
    Foam::sort(mine);
    Pstream::gatherList(keys);
    Pstream::scatterList(keys);

    DynamicList<label> procs;
    DynamicList<labelList> nodes;
    labelHashSet isShared;
    forAll(keys, proci)
    {
        if (proci == Pstream::myProcNo())
        {
            continue;
        }
        DynamicList<label> common;
        for (const label key : keys[proci])
        {
            const auto iter = nodeOfKey.cfind(key);
            if (iter.good())
            {
                common.append(iter.val());
                isShared.insert(iter.val());
            }
        }
        if (common.size())
        {
            procs.append(proci);
            nodes.append(labelList(common));
        }
    }
    procs_.transfer(procs);
    nodes_.setSize(nodes.size());
    forAll(nodes_, i)
    {
        nodes_[i].transfer(nodes[i]);
    }
    all_ = isShared.sortedToc();

    send_.setSize(procs_.size());
    receive_.setSize(procs_.size());
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Operation>
void Foam::mpm::sharedNodes::combine(
    scalar* q, const int stride, const int nComp, const scalar none, const Operation& op) const
{
    if (procs_.empty())
    {
        return;
    }
    const label request = UPstream::nRequests();
    const int tag = UPstream::msgType();

    forAll(procs_, i)
    {
        const label n = nComp * nodes_[i].size();
        if (receive_[i].size() < n)
        {
            receive_[i].setSize(n);
            send_[i].setSize(n);
        }
        UIPstream::read(
            UPstream::commsTypes::nonBlocking, procs_[i],
            reinterpret_cast<char*>(receive_[i].data()), n * sizeof(scalar), tag);
    }
    forAll(procs_, i)
    {
        scalar* to = send_[i].data();
        for (const label node : nodes_[i])
        {
            for (int c = 0; c < nComp; ++c)
            {
                *to++ = q[stride * node + c];
            }
        }
        UOPstream::write(
            UPstream::commsTypes::nonBlocking, procs_[i],
            reinterpret_cast<const char*>(send_[i].cdata()),
            nComp * nodes_[i].size() * sizeof(scalar), tag);
    }

    // In the order of the processors, this one among them
    if (own_.size() < nComp * all_.size())
    {
        own_.setSize(nComp * all_.size());
    }
    scalar* own = own_.data();
    for (const label node : all_)
    {
        for (int c = 0; c < nComp; ++c)
        {
            *own++ = q[stride * node + c];
            q[stride * node + c] = none;
        }
    }
    const auto addOwn = [&]
    {
        const scalar* from = own_.cdata();
        for (const label node : all_)
        {
            for (int c = 0; c < nComp; ++c)
            {
                op(q[stride * node + c], *from++);
            }
        }
    };

    UPstream::waitRequests(request);

    bool added = false;
    forAll(procs_, i)
    {
        if (!added && procs_[i] > UPstream::myProcNo())
        {
            addOwn();
            added = true;
        }
        const scalar* from = receive_[i].cdata();
        for (const label node : nodes_[i])
        {
            for (int c = 0; c < nComp; ++c)
            {
                op(q[stride * node + c], *from++);
            }
        }
    }
    if (!added)
    {
        addOwn();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::sharedNodes::sum(scalar* q, const int stride, const int nComp) const
{
    combine(q, stride, nComp, 0, [](scalar& to, const scalar from) { to += from; });
}

void Foam::mpm::sharedNodes::largest(scalar* q, const int stride, const int nComp) const
{
    combine(q, stride, nComp, -GREAT, [](scalar& to, const scalar from) { to = max(to, from); });
}
