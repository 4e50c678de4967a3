// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "refinedMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::refinedMesh::markFace(const label facei)
{
    const label n = 1 << depth(facei);
    if (n == 1 || !(halved_[facei][0] && halved_[facei][1]))
    {
        return;
    }
    labelList& points = inFace_[facei];
    points = labelList((n + 1) * (n + 1), -1);
    for (const faceSide* side : {&owner_[facei], &neighbour_[facei]})
    {
        if (side->squares.empty())
        {
            continue;
        }
        for (label v = 0; v < n; ++v)
        {
            for (label u = 0; u < n; ++u)
            {
                const label w = n >> at(*side, facei, u, v).level;
                for (const label y : {v - v % w, v - v % w + w})
                {
                    for (const label x : {u - u % w, u - u % w + w})
                    {
                        const bool in = x > 0 && x < n && y > 0 && y < n;
                        points[x + (n + 1) * y] = in ? 0 : -1;
                    }
                }
            }
        }
    }
}

void Foam::mpm::refinedMesh::makePoints()
{
    const pointField& X = mesh_.points();
    DynamicList<point> x(leaves_.size() + X.size());
    x.append(X);

    edgeStart_.setSize(onEdge_.size());
    forAll(onEdge_, e)
    {
        edgeStart_[e] = x.size();
        const edge& of = edges_[e];
        for (label i = 1; i < full; ++i)
        {
            if ((onEdge_[e] >> i) & 1u)
            {
                x.append(((full - i) * X[lower(of)] + i * X[of.otherVertex(lower(of))]) / full);
            }
        }
    }
    inFace_.setSize(mesh_.nFaces());
    forAll(inFace_, f)
    {
        markFace(f);
        const label n = 1 << depth(f);
        const face& of = faces_[f];
        forAll(inFace_[f], i)
        {
            if (inFace_[f][i] < 0)
            {
                continue;
            }
            // The same sum from both sides of a coupled face
            const label u = i % (n + 1), v = i / (n + 1);
            const bool turned = base_.turned(f);
            const point& ofU = X[turned ? of.last() : of[1]];
            const point& ofV = X[turned ? of[1] : of.last()];
            inFace_[f][i] = x.size();
            x.append(
                ((scalar((n - u) * (n - v)) * X[of[0]] + scalar(u * v) * X[of[2]])
                 + (scalar(u * (n - v)) * ofU + scalar((n - u) * v) * ofV))
                / (n * n));
        }
    }
    inCell_.setSize(base_.size());
    cellDepth_ = labelList(base_.size(), 0);
    for (label leaf = 0; leaf < leaves_.size(); ++leaf)
    {
        label& d = cellDepth_[leaves_.cell()[leaf]];
        d = max(d, leaves_.level()[leaf]);
    }
    for (label leaf = 0; leaf < leaves_.size(); ++leaf)
    {
        const label celli = leaves_.cell()[leaf], n = 1 << cellDepth_[celli];
        const baseHexes::hex& h = base_[celli];
        if (leaves_.level()[leaf] == 0 || h.nChildren() < 8)
        {
            continue;
        }
        labelList& points = inCell_[celli];
        if (points.empty())
        {
            points = labelList((n + 1) * (n + 1) * (n + 1), -1);
        }
        const label unit = full / n, w = leaves_.width(leaf, 0) / unit;
        for (label corner = 0; corner < 8; ++corner)
        {
            place p;
            bool in = true;
            label i = 0;
            for (label a = 2; a >= 0; --a)
            {
                p[a] = leaves_.at(leaf)[a] / unit + ((corner >> a) & 1) * w;
                in = in && p[a] > 0 && p[a] < n;
                i = i * (n + 1) + p[a];
            }
            if (in && points[i] < 0)
            {
                points[i] = x.size();
                point at(Zero);
                for (label c = 0; c < 8; ++c)
                {
                    const auto weight = [&](const label a)
                    { return (c >> a) & 1 ? p[a] : n - p[a]; };
                    at += scalar(weight(0) * weight(1) * weight(2)) * X[h.corners[c]];
                }
                x.append(at / (n * n * n));
            }
        }
    }
    to_.points.transfer(x);
}

Foam::label Foam::mpm::refinedMesh::onEdge(const label edge, const label A, const label at) const
{
    if (edge < 0)
    {
        return -1;
    }
    const unsigned mask = onEdge_[edge];
    const label i = A == lower(edges_[edge]) ? at : full - at;
    if (!((mask >> i) & 1u))
    {
        return -1;
    }
    label before = 0;
    for (unsigned left = mask & ((1u << i) - 1); left; left &= left - 1)
    {
        ++before;
    }
    return edgeStart_[edge] + before;
}

void Foam::mpm::refinedMesh::markEdge(const label celli, const place& at)
{
    const baseHexes::hex& h = base_[celli];
    for (label a = 0; a < 3; ++a)
    {
        const label b = (a + 1) % 3, c = (a + 2) % 3;
        const bool p = at[b] == full, q = at[c] == full;
        const label e = h.edges[4 * a + p + 2 * q];
        if (e >= 0 && at[a] > 0 && at[a] < full && (p || at[b] == 0) && (q || at[c] == 0))
        {
            const bool up = h.corners[(p << b) | (q << c)] == lower(edges_[e]);
            onEdge_[e] |= label(1u << (up ? at[a] : full - at[a]));
        }
    }
}

Foam::mpm::refinedMesh::place
Foam::mpm::refinedMesh::placeOf(const label facei, const label u, const label v) const
{
    // By the cell of the owner: its own coordinates
    const baseHexes::frame& f = frameP_[facei];
    place at;
    at[f.side / 2] = f.side % 2 ? full : 0;
    at[f.axisU] = f.flipU ? full - u : u;
    at[f.axisV] = f.flipV ? full - v : v;
    return at;
}

Foam::label Foam::mpm::refinedMesh::ofCell(const label celli, const place& at) const
{
    const baseHexes::hex& h = base_[celli];
    label nInside = 0, axis = -1, other = -1;
    for (label a = 0; a < 3; ++a)
    {
        if (at[a] > 0 && at[a] < full)
        {
            ++nInside;
            axis = a;
        }
        else
        {
            other = a;
        }
    }
    const auto corner = [&](const label a) { return at[a] ? 1 << a : 0; };
    if (nInside == 0)
    {
        return h.corners[corner(0) | corner(1) | corner(2)];
    }
    if (nInside == 1)
    {
        const label b = (axis + 1) % 3, c = (axis + 2) % 3;
        const label pq = (at[b] ? 1 : 0) + (at[c] ? 2 : 0);
        return onEdge(h.edges[4 * axis + pq], h.corners[corner(b) | corner(c)], at[axis]);
    }
    if (nInside == 2)
    {
        const label f = h.sides[2 * other + (at[other] ? 1 : 0)];
        const labelList& points = inFace_[f];
        if (points.empty())
        {
            return -1;
        }
        const baseHexes::frame& r = owners_[f] == celli ? frameP_[f] : frameN_[f];
        const label n = 1 << depth(f), unit = full / n;
        const label u = r.flipU ? full - at[r.axisU] : at[r.axisU];
        const label v = r.flipV ? full - at[r.axisV] : at[r.axisV];
        return u % unit || v % unit ? -1 : points[u / unit + (n + 1) * (v / unit)];
    }
    const labelList& points = inCell_[celli];
    const label n = 1 << cellDepth_[celli], unit = full / n;
    if (points.empty() || at[0] % unit || at[1] % unit || at[2] % unit)
    {
        return -1;
    }
    return points[at[0] / unit + (n + 1) * (at[1] / unit + (n + 1) * (at[2] / unit))];
}
