// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "sharedStars.H"
#include "PstreamBuffers.H"
#include "UIPstream.H"
#include "UOPstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using Foam::mpm::starPart;

//- A part as a list of numbers
void pack(const starPart& part, DynamicList<scalar>& to)
{
    const auto put = [&](const vector& v)
    {
        to.append(v.x());
        to.append(v.y());
        to.append(v.z());
    };
    to.append(part.vertices.size());
    to.append(part.edges.size());
    to.append(part.wall);
    for (const starPart::vertex& v : part.vertices)
    {
        to.append(v.cell);
        to.append(v.volume);
        put(v.side);
    }
    for (const starPart::edge& e : part.edges)
    {
        to.append(e.face);
        to.append(e.owner);
        to.append(e.neighbour);
        to.append(e.weight);
        put(e.share);
    }
}

//- Its opposite, appended; from is moved to the next part
void unpack(const scalar*& from, starPart& part)
{
    const auto get = [&]()
    {
        const vector v(from[0], from[1], from[2]);
        from += 3;
        return v;
    };
    const label nVertices = label(*from++), nEdges = label(*from++);
    part.wall = *from++ > 0 || part.wall;
    for (label i = 0; i < nVertices; ++i)
    {
        starPart::vertex v;
        v.cell = label(*from++);
        v.volume = *from++;
        v.side = get();
        part.vertices.append(v);
    }
    for (label i = 0; i < nEdges; ++i)
    {
        starPart::edge e;
        e.face = label(*from++);
        e.owner = label(*from++);
        e.neighbour = label(*from++);
        e.weight = *from++;
        e.share = get();
        part.edges.append(e);
    }
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::sharedStars::sharedStars(
    const pointGrid& grid, const std::function<void(const label, starPart&)>& ownPart) :
    shared_(grid.shared(0)),
    place_(grid.nNodes(), -1),
    others_(shared_.nodes().size()),
    start_(shared_.nodes().size() + 1, Zero),
    first_(shared_.procs().size()),
    count_(shared_.procs().size()),
    volume_(shared_.procs().size()),
    ownVolume_(shared_.nodes().size(), Zero),
    send_(shared_.procs().size()),
    receive_(shared_.procs().size()),
    base_(shared_.nodes().size()),
    sum_(shared_.nodes().size()),
    weight_(shared_.nodes().size())
{
    forAll(shared_.nodes(), i)
    {
        place_[shared_.nodes()[i]] = i;
    }

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(shared_.procs(), i)
    {
        DynamicList<scalar> all;
        for (const label l : shared_.with(i))
        {
            starPart part;
            ownPart(l, part);
            pack(part, all);
            scalar& V = ownVolume_[place_[l]];
            V = 0;
            for (const starPart::vertex& v : part.vertices)
            {
                V += v.volume;
            }
        }
        UOPstream to(shared_.procs()[i], buffers);
        to << all;
    }
    buffers.finishedSends();

    // Numbers of rows of a shared node, relative to its first at first
    forAll(shared_.procs(), i)
    {
        const labelList& nodes = shared_.with(i);
        first_[i].setSize(nodes.size());
        count_[i].setSize(nodes.size());
        volume_[i].setSize(nodes.size());
        UIPstream from(shared_.procs()[i], buffers);
        const scalarList all(from);
        const scalar* at = all.begin();
        forAll(nodes, k)
        {
            starPart& part = others_[place_[nodes[k]]];
            first_[i][k] = part.vertices.size();
            unpack(at, part);
            count_[i][k] = part.vertices.size() - first_[i][k];
            volume_[i][k] = 0;
            for (label v = 0; v < count_[i][k]; ++v)
            {
                volume_[i][k] += part.vertices[first_[i][k] + v].volume;
            }
        }
    }
    forAll(others_, i)
    {
        start_[i + 1] = start_[i] + others_[i].vertices.size();
    }
    forAll(first_, i)
    {
        forAll(first_[i], k)
        {
            first_[i][k] += start_[place_[shared_.with(i)[k]]];
        }
    }
    rows_.setSize(stride * start_.last(), Zero);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::sharedStars::exchange() const
{
    const label request = UPstream::nRequests();
    const int tag = UPstream::msgType();
    forAll(receive_, i)
    {
        if (receive_[i].size())
        {
            UIPstream::read(
                UPstream::commsTypes::nonBlocking, shared_.procs()[i],
                reinterpret_cast<char*>(receive_[i].data()), receive_[i].size() * sizeof(scalar),
                tag);
        }
    }
    forAll(send_, i)
    {
        if (send_[i].size())
        {
            UOPstream::write(
                UPstream::commsTypes::nonBlocking, shared_.procs()[i],
                reinterpret_cast<const char*>(send_[i].cdata()), send_[i].size() * sizeof(scalar),
                tag);
        }
    }
    UPstream::waitRequests(request);
}

void Foam::mpm::sharedStars::addMean(
    const label i, const scalar base, const scalar sum, const scalar volume) const
{
    if (!(weight_[i] > 0))
    {
        base_[i] = base;
    }
    weight_[i] += volume;
    sum_[i] += sum + volume * (base - base_[i]);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::sharedStars::means(scalarList& base, const scalarList& sum) const
{
    forAll(send_, i)
    {
        const labelList& nodes = shared_.with(i);
        send_[i].setSize(2 * nodes.size());
        receive_[i].setSize(2 * nodes.size());
        forAll(nodes, k)
        {
            send_[i][2 * k] = base[nodes[k]];
            send_[i][2 * k + 1] = sum[nodes[k]];
        }
    }
    exchange();

    // In the order of the processors, this one among them
    sum_ = 0;
    weight_ = 0;
    bool added = false;
    const auto addOwn = [&]
    {
        forAll(shared_.nodes(), i)
        {
            const label l = shared_.nodes()[i];
            addMean(i, base[l], sum[l], ownVolume_[i]);
        }
        added = true;
    };
    forAll(receive_, i)
    {
        if (!added && shared_.procs()[i] > UPstream::myProcNo())
        {
            addOwn();
        }
        forAll(shared_.with(i), k)
        {
            const scalar* q = receive_[i].cdata() + 2 * k;
            addMean(place_[shared_.with(i)[k]], q[0], q[1], volume_[i][k]);
        }
    }
    if (!added)
    {
        addOwn();
    }
    forAll(shared_.nodes(), i)
    {
        base[shared_.nodes()[i]] = base_[i] + sum_[i] / weight_[i];
    }
}
