// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "nodeDual.H"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::nodeDual::nodeDual(const pointGrid& grid, const cellSimplices& cells) :
    grid_(grid),
    cells_(cells),
    nDim_(grid.nDim()),
    volume_(grid.nNodes(), Zero),
    width_(grid.nDim() * grid.nNodes(), Zero),
    start_(grid.nNodes() + 1, Zero),
    reduced_(grid.nNodes(), false),
    hasOffsets_(false)
{
    const nodeRows rows(grid, cells);
    DynamicList<label> nodes(16 * grid.nNodes());
    DynamicList<scalar> G(nDim_ * 16 * grid.nNodes()), W(16 * grid.nNodes());
    nodeRows::row row;
    for (label m = 0; m < grid.nNodes(); ++m)
    {
        rows.get(m, row);
        for (const nodeRows::entry& e : row.entries)
        {
            nodes.append(e.node);
            for (int d = 0; d < nDim_; ++d)
            {
                G.append(e.G[d] / row.volume);
                width_[nDim_ * m + d] += 2 * e.N * sqr(e.d[d]) / row.volume;
            }
        }
        for (int d = 0; d < nDim_; ++d)
        {
            width_[nDim_ * m + d] = std::sqrt(width_[nDim_ * m + d]);
        }
        start_[m + 1] = nodes.size();
        volume_[m] = row.volume;
        reduced_[m] = row.faces.size();
        if (row.entries.size())
        {
            const tensor P(makeRing(nDim_, row));
            W.setSize(nodes.size());
            solve(nDim_, m, P, row.entries, W.begin() + start_[m]);
        }
    }
    node_.transfer(nodes);
    W_.transfer(W);
    G_.transfer(G);
    sortRows();
    findRuns();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::scalarList& Foam::mpm::nodeDual::offsets() const
{
    if (!hasOffsets_)
    {
        const nodeRows rows(grid_, cells_);
        nodeRows::row row;
        offset_.setSize(nDim_ * node_.size());
        label at = 0;
        for (label m = 0; m < grid_.nNodes(); ++m)
        {
            rows.get(m, row);
            const tensor P(makeRing(nDim_, row));

            // As sortRows()
            std::stable_sort(
                row.entries.begin(), row.entries.end(),
                [](const nodeRows::entry& a, const nodeRows::entry& b) { return a.node < b.node; });
            for (const nodeRows::entry& e : row.entries)
            {
                const vector d(P & e.d);
                for (int c = 0; c < nDim_; ++c)
                {
                    offset_[at++] = d[c];
                }
            }
        }
        hasOffsets_ = true;
    }
    return offset_;
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tensor Foam::mpm::nodeDual::directions(const int nDim)
{
    tensor P(Zero);
    for (int d = 0; d < nDim; ++d)
    {
        P[4 * d] = 1;
    }
    return P;
}

Foam::tensor Foam::mpm::nodeDual::makeRing(const int nDim, nodeRows::row& r)
{
    tensor P(directions(nDim));
    if (r.faces.empty())
    {
        return P;
    }

    // Groups of faces: patch, sum of the areas
    DynamicList<label> patch, group;
    DynamicList<vector> area;
    for (const nodeRows::ringFace& f : r.faces)
    {
        label g = 0;
        while (
            g < patch.size()
            && (patch[g] != f.patch || (area[g] & f.area) < 0.8660254 * mag(area[g]) * mag(f.area)))
        {
            ++g;
        }
        if (g == patch.size())
        {
            patch.append(f.patch);
            area.append(vector(Zero));
        }
        area[g] += f.area;
        group.append(g);
    }

    boolList inGroup(patch.size());
    for (nodeRows::entry& e : r.entries)
    {
        scalar sum = 0;
        inGroup = false;
        forAll(r.faces, i)
        {
            const nodeRows::ringFace& f = r.faces[i];
            if (f.has(e))
            {
                inGroup[group[i]] = true;
                sum += mag(f.area) / f.nodes.size();
            }
        }
        e.N = inGroup.found(false) ? 0 : sum;
    }

    // What the planes of the groups have in common
    for (const vector& a : area)
    {
        const vector n(P & a);
        if (mag(n) > 0.1 * mag(a))
        {
            P -= (n * n) / magSqr(n);
        }
    }
    return P;
}

void Foam::mpm::nodeDual::solve(
    const int nDim, const label m, const tensor& P, const UList<nodeRows::entry>& row, scalar* W)
{
    // Newton's method for the least of log sum N exp(-q.d), which is convex
    scalar most = 0, furthest = 0;
    for (const nodeRows::entry& e : row)
    {
        most = e.N > 0 ? max(most, mag(P & e.d)) : most;
        furthest = max(furthest, mag(e.d));
    }
    if (most <= 1e-9 * furthest)
    {
        // What P leaves of the directions at a corner is rounding
        forAll(row, i)
        {
            W[i] = row[i].node == m && magSqr(row[i].d) == 0;
        }
        return;
    }
    const scalar h = most;
    vector q(Zero);
    const auto values = [&](const vector& at, vector& mean, symmTensor& square)
    {
        scalar Z = 0;
        mean = Zero;
        square = Zero;
        for (const nodeRows::entry& e : row)
        {
            if (!(e.N > 0))
            {
                continue;
            }
            const vector d((P & e.d) / h);
            const scalar w = e.N * std::exp(-(at & d));
            Z += w;
            mean += w * d;
            square += w * sqr(d);
        }
        mean /= Z;
        square /= Z;
        return std::log(Z);
    };

    vector mean;
    symmTensor square;
    scalar F = values(q, mean, square);
    bool found = false;
    for (int step = 0; step < 100 && !found && mag(q) < 50; ++step)
    {
        if (mag(mean) < 1e-15)
        {
            found = true;
            break;
        }
        // Directions that the ring does not have stay out of it
        const symmTensor H(square - sqr(mean));
        const tensor full(tensor(H) + max(tr(H), scalar(1e-300)) * (tensor(tensor::I) - P));
        if (det(full) <= 1e-12 * pow3(tr(H)))
        {
            break;
        }
        vector dq(inv(full) & mean);
        dq *= min(scalar(1), 10 / max(mag(dq), VSMALL));
        scalar share = 1;
        vector newMean;
        symmTensor newSquare;
        scalar newF = values(q + dq, newMean, newSquare);
        while (newF > F + 1e-14 && share > 1e-4)
        {
            share *= 0.5;
            newF = values(q + share * dq, newMean, newSquare);
        }
        if (mag(newMean) >= mag(mean) && mag(mean) < 1e-13)
        {
            found = true;
            break;
        }
        q += share * dq;
        F = newF;
        mean = newMean;
        square = newSquare;
    }

    scalar Z = 0;
    forAll(row, i)
    {
        W[i] = row[i].N > 0 ? row[i].N * std::exp(-(q & (P & row[i].d)) / h) : 0;
        Z += W[i];
    }
    forAll(row, i)
    {
        const bool own = row[i].node == m && magSqr(row[i].d) == 0;
        W[i] = !found ? scalar(own) : (own ? 1 - beta : 0) + beta * W[i] / Z;
    }
}

void Foam::mpm::nodeDual::sortRows()
{
    DynamicList<label> order, node;
    DynamicList<scalar> W, G;
    for (label m = 0; m < start_.size() - 1; ++m)
    {
        const label first = start_[m], n = start_[m + 1] - first;
        order.setSize(n);
        std::iota(order.begin(), order.end(), first);
        std::stable_sort(
            order.begin(), order.end(),
            [&](const label a, const label b) { return node_[a] < node_[b]; });
        node.clear();
        W.clear();
        G.clear();
        for (const label e : order)
        {
            node.append(node_[e]);
            W.append(W_[e]);
            for (int d = 0; d < nDim_; ++d)
            {
                G.append(G_[nDim_ * e + d]);
            }
        }
        std::copy(node.begin(), node.end(), node_.begin() + first);
        std::copy(W.begin(), W.end(), W_.begin() + first);
        std::copy(G.begin(), G.end(), G_.begin() + nDim_ * first);
    }
}

bool Foam::mpm::nodeDual::sameRow(const label a, const label b) const
{
    const label n = start_[a + 1] - start_[a], shift = start_[b] - start_[a];
    bool same = start_[b + 1] - start_[b] == n;
    scalar most = 0;
    for (label i = nDim_ * start_[a]; same && i < nDim_ * start_[a + 1]; ++i)
    {
        most = max(most, mag(G_[i]));
    }
    for (label e = start_[a]; same && e < start_[a + 1]; ++e)
    {
        same = node_[e + shift] - b == node_[e] - a && mag(W_[e + shift] - W_[e]) <= 1e-12;
        for (int d = 0; d < nDim_; ++d)
        {
            const scalar difference = G_[nDim_ * (e + shift) + d] - G_[nDim_ * e + d];
            same = same && mag(difference) <= 1e-12 * most;
        }
    }
    return same;
}

void Foam::mpm::nodeDual::findRuns()
{
    alike_.setSize(start_.size() - 1);
    std::unordered_multimap<std::size_t, label> firsts;
    forAll(alike_, m)
    {
        // By the places of the nodes and G of the first to six digits: where these
        // differ by rounding a row has one more to look like
        const label begin = nDim_ * start_[m], end = nDim_ * start_[m + 1];
        scalar most = VSMALL;
        for (label i = begin; i < end; ++i)
        {
            most = max(most, mag(G_[i]));
        }
        std::size_t key = end - begin;
        for (label i = begin; i < min(begin + 2 * nDim_, end); ++i)
        {
            key = 1000003 * key + std::size_t(std::lround(1e6 * G_[i] / most));
        }

        for (label e = start_[m]; e < start_[m + 1]; ++e)
        {
            key = 1000003 * key + std::size_t(node_[e] - m);
        }

        label first = m && sameRow(alike_[m - 1], m) ? alike_[m - 1] : -1;
        const auto known = firsts.equal_range(key);
        for (auto iter = known.first; first < 0 && iter != known.second; ++iter)
        {
            first = sameRow(iter->second, m) ? iter->second : -1;
        }
        if (first < 0)
        {
            alike_[m] = m;
            firsts.emplace(key, m);
            continue;
        }
        alike_[m] = first;
        const label n = start_[m + 1] - start_[m];
        std::copy_n(W_.begin() + start_[first], n, W_.begin() + start_[m]);
        std::copy_n(G_.begin() + nDim_ * start_[first], nDim_ * n, G_.begin() + nDim_ * start_[m]);
    }
}
