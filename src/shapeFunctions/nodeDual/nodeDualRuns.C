/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "nodeDual.H"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::nodeDual::sortRows()
{
    DynamicList<label> order, node;
    DynamicList<scalar> W, G;
    for (label m = 0; m < start_.size() - 1; ++m)
    {
        const label first = start_[m], n = start_[m + 1] - first;
        order.setSize(n);
        std::iota(order.begin(), order.end(), first);
        std::stable_sort
        (
            order.begin(),
            order.end(),
            [&](const label a, const label b) { return node_[a] < node_[b]; }
        );
        node.clear();
        W.clear();
        G.clear();
        for (const label e : order)
        {
            node.append(node_[e]);
            W.append(W_[e]);
            for (int d = 0; d < nDim_; ++d)
            {
                G.append(G_[nDim_*e + d]);
            }
        }
        std::copy(node.begin(), node.end(), node_.begin() + first);
        std::copy(W.begin(), W.end(), W_.begin() + first);
        std::copy(G.begin(), G.end(), G_.begin() + nDim_*first);
    }
}


bool Foam::mpm::nodeDual::sameRow(const label a, const label b) const
{
    const label n = start_[a + 1] - start_[a], shift = start_[b] - start_[a];
    bool same = start_[b + 1] - start_[b] == n;
    scalar most = 0;
    for (label i = nDim_*start_[a]; same && i < nDim_*start_[a + 1]; ++i)
    {
        most = max(most, mag(G_[i]));
    }
    for (label e = start_[a]; same && e < start_[a + 1]; ++e)
    {
        same =
            node_[e + shift] - b == node_[e] - a
         && mag(W_[e + shift] - W_[e]) <= 1e-12;
        for (int d = 0; d < nDim_; ++d)
        {
            const scalar difference =
                G_[nDim_*(e + shift) + d] - G_[nDim_*e + d];
            same = same && mag(difference) <= 1e-12*most;
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
        // By number of entries and G of the first to six digits: where these
        // differ by rounding a row has one more to look like
        const label begin = nDim_*start_[m], end = nDim_*start_[m + 1];
        scalar most = VSMALL;
        for (label i = begin; i < end; ++i)
        {
            most = max(most, mag(G_[i]));
        }
        std::size_t key = end - begin;
        for (label i = begin; i < min(begin + 2*nDim_, end); ++i)
        {
            key = 1000003*key + std::size_t(std::lround(1e6*G_[i]/most));
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
        std::copy_n
        (
            G_.begin() + nDim_*start_[first],
            nDim_*n,
            G_.begin() + nDim_*start_[m]
        );
    }
}

// ************************************************************************* //
