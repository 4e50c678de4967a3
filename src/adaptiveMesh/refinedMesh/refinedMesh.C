// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "refinedMesh.H"
#include "coupledPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "PstreamBuffers.H"
#include "syncTools.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::refinedMesh::markEdges()
{
    onEdge_ = labelList(mesh_.nEdges(), 0);
    for (label leaf = 0; leaf < leaves_.size(); ++leaf)
    {
        for (label corner = 0; leaves_.level()[leaf] > 0 && corner < 8; ++corner)
        {
            place at(leaves_.at(leaf));
            for (label a = 0; a < 3; ++a)
            {
                at[a] += (corner >> a) & 1 ? leaves_.width(leaf, a) : 0;
            }
            markEdge(leaves_.cell()[leaf], at);
        }
    }

    // What is finer behind a coupled face
    for (label f = nInternal_; f < faces_.size(); ++f)
    {
        const faceSide& side = neighbour_[f];
        const label nu = halved_[f][0] ? 1 << side.depth : 1;
        forAll(side.squares, i)
        {
            for (label corner = 0; corner < 4; ++corner)
            {
                const label w = full >> side.squares[i].level;
                FixedList<label, 2> at({i % nu, i / nu});
                for (label d = 0; d < 2; ++d)
                {
                    const label size = halved_[f][d] ? w : full;
                    at[d] = at[d] * (full >> side.depth) / size * size + ((corner >> d) & 1) * size;
                }
                markEdge(owners_[f], placeOf(f, at[0], at[1]));
            }
        }
    }
    if (Pstream::parRun())
    {
        syncTools::syncEdgeList(
            mesh_, onEdge_, [](label& x, const label y) { x |= y; }, label(0));
    }
}

Foam::mpm::refinedMesh::faceSide Foam::mpm::refinedMesh::sideOf(
    const label celli, const label facei, const baseHexes::frame& f) const
{
    const label a = f.side / 2, end = f.side % 2 ? full : 0;
    faceSide side{0, {}};
    const auto touches = [&](const label leaf)
    { return leaves_.at(leaf)[a] + (end ? leaves_.width(leaf, a) : 0) == end; };
    for (label leaf = leaves_.start()[celli]; leaf < leaves_.start()[celli + 1]; ++leaf)
    {
        side.depth = max(side.depth, touches(leaf) ? leaves_.level()[leaf] : 0);
    }
    const label nu = halved_[facei][0] ? 1 << side.depth : 1;
    const label nv = halved_[facei][1] ? 1 << side.depth : 1;
    side.squares.setSize(nu * nv);
    for (label leaf = leaves_.start()[celli]; leaf < leaves_.start()[celli + 1]; ++leaf)
    {
        if (!touches(leaf))
        {
            continue;
        }
        const auto range = [&](const label axis, const bool flip, const label n)
        {
            const label w = leaves_.width(leaf, axis);
            const label from = flip ? full - leaves_.at(leaf)[axis] - w : leaves_.at(leaf)[axis];
            return Pair<label>(from * n / full, (from + w) * n / full);
        };
        const Pair<label> u(range(f.axisU, f.flipU, nu)), v(range(f.axisV, f.flipV, nv));
        for (label j = v[0]; j < v[1]; ++j)
        {
            for (label i = u[0]; i < u[1]; ++i)
            {
                side.squares[i + nu * j] = square{leaf, leaves_.level()[leaf]};
            }
        }
    }
    return side;
}

void Foam::mpm::refinedMesh::makeSides()
{
    const label n = mesh_.nFaces();
    owner_.setSize(n);
    neighbour_ = List<faceSide>(n, faceSide{0, {}});
    frameP_.setSize(n);
    frameN_.setSize(n);
    halved_.setSize(n);
    for (label f = 0; f < n; ++f)
    {
        const label P = owners_[f];
        const baseHexes::frame& r = frameP_[f] = base_.frameOf(P, f, base_.turned(f));
        halved_[f] = Pair<bool>(base_[P].halved[r.axisU], base_[P].halved[r.axisV]);
        owner_[f] = sideOf(P, f, r);
        if (f < nInternal_)
        {
            const label N = neighbours_[f];
            frameN_[f] = base_.frameOf(N, f, false);
            neighbour_[f] = sideOf(N, f, frameN_[f]);
        }
    }
}

void Foam::mpm::refinedMesh::swapSides()
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const auto text = [&](const polyPatch& pp)
    {
        DynamicList<label> t;
        for (label f = pp.start(); f < pp.start() + pp.size(); ++f)
        {
            t.append(owner_[f].depth);
            t.append(owner_[f].squares.size());
            for (const square& s : owner_[f].squares)
            {
                t.append(s.level);
            }
        }
        return labelList(std::move(t));
    };
    const auto take = [&](const polyPatch& pp, const labelUList& t)
    {
        label at = 0;
        for (label f = pp.start(); f < pp.start() + pp.size(); ++f)
        {
            faceSide& side = neighbour_[f];
            side.depth = t[at++];
            side.squares.setSize(t[at++]);
            for (square& s : side.squares)
            {
                s = square{-1, t[at++]};
            }
        }
    };
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    for (const polyPatch& pp : patches)
    {
        if (isA<cyclicPolyPatch>(pp))
        {
            take(pp, text(refCast<const cyclicPolyPatch>(pp).neighbPatch()));
        }
        else if (isA<processorPolyPatch>(pp))
        {
            UOPstream os(refCast<const processorPolyPatch>(pp).neighbProcNo(), buffers);
            os << text(pp);
        }
    }
    if (!Pstream::parRun())
    {
        return;
    }
    buffers.finishedSends();
    for (const polyPatch& pp : patches)
    {
        if (isA<processorPolyPatch>(pp))
        {
            UIPstream is(refCast<const processorPolyPatch>(pp).neighbProcNo(), buffers);
            take(pp, labelList(is));
        }
    }
}

const Foam::mpm::refinedMesh::square& Foam::mpm::refinedMesh::at(
    const faceSide& side, const label facei, const label u, const label v) const
{
    const label shift = depth(facei) - side.depth;
    const label nu = halved_[facei][0] ? 1 << side.depth : 1;
    return side
        .squares[(halved_[facei][0] ? u >> shift : 0) + nu * (halved_[facei][1] ? v >> shift : 0)];
}

template<class PointAt, class Place>
void Foam::mpm::refinedMesh::edgePoints(
    const PointAt& pointAt, const Place& from, const Place& to, const label first,
    DynamicList<label>& points)
{
    Place middle(from);
    label length = 0;
    forAll(middle, a)
    {
        length += mag(to[a] - from[a]);
        middle[a] = (from[a] + to[a]) / 2;
    }
    const label half = length > 1 ? pointAt(middle) : -1;
    if (half >= 0)
    {
        edgePoints(pointAt, from, middle, first, points);
        edgePoints(pointAt, middle, to, half, points);
        return;
    }
    points.append(first);
}

template<class PointAt, class Place>
Foam::face
Foam::mpm::refinedMesh::polygon(const PointAt& pointAt, const FixedList<Place, 4>& corners)
{
    DynamicList<label> points(8);
    FixedList<label, 4> at;
    forAll(at, i)
    {
        at[i] = pointAt(corners[i]);
    }
    forAll(at, i)
    {
        // Corners that are one have no edge between them
        if (at[i] != at[(i + 1) % 4])
        {
            edgePoints(pointAt, corners[i], corners[(i + 1) % 4], at[i], points);
        }
    }
    return points.size() < 3 ? face() : face(points);
}

void Foam::mpm::refinedMesh::facesInCell(const label celli)
{
    if (cellDepth_[celli] == 0)
    {
        return;
    }
    const baseHexes::hex& h = base_[celli];
    const label depth = cellDepth_[celli];
    FixedList<label, 3> n;
    for (label a = 0; a < 3; ++a)
    {
        n[a] = h.halved[a] ? 1 << depth : 1;
    }
    const auto index = [&](const place& p)
    { return p[0] * n[0] / full + n[0] * (p[1] * n[1] / full + n[1] * (p[2] * n[2] / full)); };
    labelList leafAt(n[0] * n[1] * n[2]);
    const label begin = leaves_.start()[celli], end = leaves_.start()[celli + 1];
    for (label leaf = begin; leaf < end; ++leaf)
    {
        place p;
        const place& at = leaves_.at(leaf);
        for (p[2] = at[2]; p[2] < at[2] + leaves_.width(leaf, 2); p[2] += full / n[2])
        {
            for (p[1] = at[1]; p[1] < at[1] + leaves_.width(leaf, 1); p[1] += full / n[1])
            {
                for (p[0] = at[0]; p[0] < at[0] + leaves_.width(leaf, 0); p[0] += full / n[0])
                {
                    leafAt[index(p)] = leaf;
                }
            }
        }
    }
    const auto pointAt = [&](const place& p) { return ofCell(celli, p); };
    for (label leaf = begin; leaf < end; ++leaf)
    {
        const place& at = leaves_.at(leaf);
        for (label side = 0; side < 6; ++side)
        {
            const label a = side / 2, b = (a + 1) % 3, c = (a + 2) % 3;
            const label w = leaves_.width(leaf, a);
            place behind(at);
            behind[a] += side % 2 ? w : -1;
            if (behind[a] < 0 || behind[a] >= full)
            {
                continue;
            }
            const label other = leafAt[index(behind)];
            const label l = leaves_.level()[leaf], lOther = leaves_.level()[other];

            // The smaller one makes it, of two that are equal the first
            if (l < lOther || (l == lOther && other < leaf))
            {
                continue;
            }
            place p(at);
            p[a] += side % 2 ? w : 0;
            FixedList<place, 4> corners(p);
            corners[1][b] += leaves_.width(leaf, b);
            corners[2] = corners[1];
            corners[2][c] += leaves_.width(leaf, c);
            corners[3][c] = corners[2][c];
            face f(polygon(pointAt, corners));
            if (f.empty())
            {
                continue;
            }
            // Right-handed along the axis: out of the leaf at its end
            if ((side % 2 == 1) != (leaf < other))
            {
                f.flip();
            }
            inside_.append(found{min(leaf, other), max(leaf, other), std::move(f)});
        }
    }
}

void Foam::mpm::refinedMesh::facesOf(const label facei, DynamicList<found>& faces)
{
    const label d = depth(facei), nu = extent(facei, 0), nv = extent(facei, 1);
    typedef FixedList<label, 2> uv;
    const auto pointAt = [&](const uv& p) { return ofFace(facei, p[0], p[1]); };

    // Corners follow each other as those of the base face
    const label first = pointAt(uv({full, 0})) == faces_[facei][1] ? 0 : 1;
    const faceSide &P = owner_[facei], &N = neighbour_[facei];
    for (label v = 0; v < nv; ++v)
    {
        for (label u = 0; u < nu; ++u)
        {
            const square& p = at(P, facei, u, v);
            const square q = N.squares.size() ? at(N, facei, u, v) : square{-1, 0};
            const label w = 1 << (d - max(p.level, q.level));
            if ((nu > 1 && u % w) || (nv > 1 && v % w))
            {
                continue;
            }
            const uv size({nu > 1 ? w * (full / nu) : full, nv > 1 ? w * (full / nv) : full});
            FixedList<uv, 4> corners(uv({u * (full / nu), v * (full / nv)}));
            corners[1][first] += size[first];
            corners[2] = corners[1];
            corners[2][1 - first] += size[1 - first];
            corners[3][1 - first] = corners[2][1 - first];
            face f(polygon(pointAt, corners));
            if (f.size())
            {
                faces.append(found{p.leaf, q.leaf, std::move(f)});
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::refinedMesh::refinedMesh(const treeLeaves& leaves) :

    leaves_(leaves),
    base_(leaves.base()),
    mesh_(leaves.base().mesh()),
    faces_(mesh_.faces()),
    owners_(mesh_.faceOwner()),
    neighbours_(mesh_.faceNeighbour()),
    edges_(mesh_.edges()),
    nInternal_(mesh_.nInternalFaces())
{
    makeSides();
    swapSides();
    markEdges();
    makePoints();

    inside_.reserve(3 * leaves.size());
    for (label celli = 0; celli < base_.size(); ++celli)
    {
        facesInCell(celli);
    }
    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        facesOf(f, inside_);
    }
    std::sort(
        inside_.begin(), inside_.end(),
        [](const found& a, const found& b)
        { return a.owner < b.owner || (a.owner == b.owner && a.neighbour < b.neighbour); });
    DynamicList<found> outside;
    to_.patchSizes.setSize(mesh_.boundaryMesh().size());
    DynamicList<label> baseFace;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label before = outside.size();
        for (label f = pp.start(); f < pp.start() + pp.size(); ++f)
        {
            facesOf(f, outside);
            baseFace.setSize(outside.size(), f);
        }
        to_.patchSizes[pp.index()] = outside.size() - before;
    }
    const label nInside = inside_.size();
    to_.faces.setSize(nInside + outside.size());
    to_.owner.setSize(to_.faces.size());
    to_.neighbour.setSize(nInside);
    forAll(to_.faces, f)
    {
        found& from = f < nInside ? inside_[f] : outside[f - nInside];
        to_.faces[f].transfer(from.points);
        to_.owner[f] = from.owner;
        if (f < nInside)
        {
            to_.neighbour[f] = from.neighbour;
        }
    }
    to_.baseFace.transfer(baseFace);
}
