// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "nodeRows.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "PstreamBuffers.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Two vectors from one node to one other: through a cyclic side they differ
//  by its length
bool same(const vector& a, const vector& b) { return magSqr(a - b) <= 1e-6 * magSqr(b); }

//- Are two faces in the order in which they are taken, on all processors?
bool before(const Foam::mpm::nodeRows::ringFace& a, const Foam::mpm::nodeRows::ringFace& b)
{
    if (a.patch != b.patch)
    {
        return a.patch < b.patch;
    }
    for (int d = 0; d < 2; ++d)
    {
        if (a.centre[d] != b.centre[d])
        {
            return a.centre[d] < b.centre[d];
        }
    }
    return a.centre[2] < b.centre[2];
}

//- A row as a list of numbers, its nodes by their keys
void pack(
    const Foam::mpm::pointGrid& grid, const Foam::mpm::nodeRows::row& r, DynamicList<scalar>& to)
{
    const auto put = [&](const vector& v)
    {
        to.append(v.x());
        to.append(v.y());
        to.append(v.z());
    };
    to.append(r.volume);
    to.append(r.entries.size());
    for (const auto& e : r.entries)
    {
        to.append(grid.nodeKey()[e.node]);
        put(e.d);
        put(e.G);
        to.append(e.N);
    }
    to.append(r.faces.size());
    for (const auto& f : r.faces)
    {
        to.append(f.patch);
        put(f.area);
        put(f.centre);
        to.append(f.nodes.size());
        forAll(f.nodes, i)
        {
            to.append(grid.nodeKey()[f.nodes[i]]);
            put(f.d[i]);
        }
    }
}

//- Its opposite; from is moved to the next row
void unpack(const Map<label>& nodeOfKey, const scalar*& from, Foam::mpm::nodeRows::row& r)
{
    const auto get = [&]()
    {
        const vector v(from[0], from[1], from[2]);
        from += 3;
        return v;
    };
    r.volume = *from++;
    r.entries.setSize(label(*from++));
    for (auto& e : r.entries)
    {
        e.node = nodeOfKey[label(*from++)];
        e.d = get();
        e.G = get();
        e.N = *from++;
    }
    r.faces.setSize(label(*from++));
    for (auto& f : r.faces)
    {
        f.patch = label(*from++);
        f.area = get();
        f.centre = get();
        f.nodes.setSize(label(*from++));
        f.d.setSize(f.nodes.size());
        forAll(f.nodes, i)
        {
            f.nodes[i] = nodeOfKey[label(*from++)];
            f.d[i] = get();
        }
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::mpm::nodeRows::computed(const vector& v) const
{
    vector c(Zero);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        c[d] = v[grid_.direction(d)];
    }
    return c;
}

void Foam::mpm::nodeRows::addFace(
    const label patchi, const vector& area, const vector& centre, const labelUList& nodes,
    const UList<vector>& x)
{
    scalar size = 0;
    for (const vector& v : x)
    {
        size = max(size, magSqr(v - x[0]));
    }
    forAll(nodes, i)
    {
        // Front and back of 2D are one place
        bool known = false;
        for (label j = 0; j < i; ++j)
        {
            known = known || (nodes[j] == nodes[i] && magSqr(x[j] - x[i]) <= 1e-6 * size);
        }
        if (!known)
        {
            faces_[nodes[i]].append(ringFace{patchi, area, centre - x[i], nodes, x - x[i]});
        }
    }
}

void Foam::mpm::nodeRows::addFaces()
{
    const polyMesh& mesh = grid_.mesh();
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled() || isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        forAll(pp, i)
        {
            const face& f = pp[i];
            labelList nodes(f.size());
            vectorField x(f.size());
            forAll(f, k)
            {
                nodes[k] = grid_.pointToNode()[f[k]];
                x[k] = computed(mesh.points()[f[k]]);
            }
            const label facei = pp.start() + i;
            addFace(
                pp.index(), computed(mesh.faceAreas()[facei]), computed(mesh.faceCentres()[facei]),
                nodes, x);
        }
    }
}

void Foam::mpm::nodeRows::addAxis()
{
    const int r = grid_.radial();
    const scalar onAxis = 1e-6 * grid_.mesh().bounds().mag();
    for (label celli = 0; r >= 0 && celli < grid_.nCells(); ++celli)
    {
        const label n = cells_.nVertices(celli);
        for (label i = 0; i < n; ++i)
        {
            const label j = (i + 1) % n;
            const scalar* a = cells_.position(celli, i);
            const scalar* b = cells_.position(celli, j);
            if (a[r] > onAxis || b[r] > onAxis)
            {
                continue;
            }
            vector area(Zero);
            area[r] = -mag(b[1 - r] - a[1 - r]);
            vectorField x(2);
            x[0] = vector(a[0], a[1], 0);
            x[1] = vector(b[0], b[1], 0);
            labelList nodes(2);
            nodes[0] = cells_.nodes(celli)[i];
            nodes[1] = cells_.nodes(celli)[j];
            addFace(-1, area, 0.5 * (x[0] + x[1]), nodes, x);
        }
    }
}

void Foam::mpm::nodeRows::ownPart(const label m, row& r) const
{
    const int nDim = grid_.nDim();
    DynamicList<scalar> SdS;
    r.volume = 0;
    r.entries.clear();
    for (const label celli : grid_.nodes().cellsOf(m))
    {
        const label n = cells_.nVertices(celli);
        SdS.setSize(nDim * n);
        for (label i = 0; i < n; ++i)
        {
            if (cells_.nodes(celli)[i] != m)
            {
                continue;
            }
            const scalar volume = cells_.integral(celli, i);
            const scalar share = volume / n;
            r.volume += volume;
            cells_.integrals(celli, i, SdS.begin());
            for (label j = 0; j < n; ++j)
            {
                vector d(Zero), G(Zero);
                for (int c = 0; c < nDim; ++c)
                {
                    d[c] = cells_.position(celli, j)[c] - cells_.position(celli, i)[c];
                    G[c] = SdS[nDim * j + c];
                }
                entry& e = r.at(cells_.nodes(celli)[j], d);
                e.G += G;
                e.N += share;
            }
        }
    }
    r.faces = faces_[m];
}

void Foam::mpm::nodeRows::exchange()
{
    const sharedNodes& common = grid_.shared(0);
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    row part;
    forAll(common.procs(), i)
    {
        DynamicList<scalar> all;
        for (const label m : common.with(i))
        {
            ownPart(m, part);
            pack(grid_, part, all);
        }
        UOPstream to(common.procs()[i], buffers);
        to << all;
    }
    buffers.finishedSends();

    Map<label> nodeOfKey(2 * grid_.nNodes());
    forAll(grid_.nodeKey(), n)
    {
        nodeOfKey.insert(grid_.nodeKey()[n], n);
    }
    const auto add = [&](const label m)
    {
        row& r = shared_(m);
        r.volume += part.volume;
        for (const entry& e : part.entries)
        {
            entry& to = r.at(e.node, e.d);
            to.G += e.G;
            to.N += e.N;
        }
        r.faces.append(part.faces);
    };

    // In the order of the processors, this one among them
    labelList procs(common.procs());
    procs.append(Pstream::myProcNo());
    Foam::sort(procs);
    for (const label proci : procs)
    {
        if (proci == Pstream::myProcNo())
        {
            for (const label m : common.nodes())
            {
                ownPart(m, part);
                add(m);
            }
            continue;
        }
        UIPstream from(proci, buffers);
        const scalarList all(from);
        const scalar* at = all.begin();
        for (const label m : common.with(common.procs().find(proci)))
        {
            unpack(nodeOfKey, at, part);
            add(m);
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::nodeRows::nodeRows(const pointGrid& grid, const cellSimplices& cells) :
    grid_(grid), cells_(cells), faces_(grid.nNodes())
{
    addFaces();
    addAxis();
    if (Pstream::parRun())
    {
        exchange();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::nodeRows::ringFace::has(const entry& e) const
{
    forAll(nodes, i)
    {
        if (nodes[i] == e.node && same(d[i], e.d))
        {
            return true;
        }
    }
    return false;
}

Foam::mpm::nodeRows::entry& Foam::mpm::nodeRows::row::at(const label node, const vector& d)
{
    for (entry& e : entries)
    {
        if (e.node == node && same(e.d, d))
        {
            return e;
        }
    }
    entries.append(entry{node, d, vector(Zero), 0});
    return entries.last();
}

void Foam::mpm::nodeRows::get(const label m, row& r) const
{
    const auto iter = shared_.cfind(m);
    if (iter.good())
    {
        r = iter.val();
    }
    else
    {
        ownPart(m, r);
    }
    std::sort(r.faces.begin(), r.faces.end(), before);
}
