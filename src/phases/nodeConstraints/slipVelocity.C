// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "slipVelocity.H"
#include "basicSymmetryPointPatchField.H"
#include "fixedNormalSlipPointPatchField.H"
#include "slipPointPatchField.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::slipVelocity::findTurn(
    const label node, const std::vector<Pair<vector>>& faces,
    const std::vector<wallSurfaces::surface>& all)
{
    constexpr scalar least = 1e-4;
    for (const Pair<vector>& f : faces)
    {
        scalar apart = GREAT;
        for (const wallSurfaces::surface& s : all)
        {
            apart = min(apart, mag(normalised(f[0]) - normalised(s.second()[0])));
        }
        if (apart > least)
        {
            turns_.setSize(grid_.nNodes(), false);
            turns_[node] = true;
            return;
        }
    }
}

void Foam::mpm::slipVelocity::hold(
    const label node, const label patchi, const vector& normal, tensor& N)
{
    const int D = grid_.nDim();
    vector v(Zero);
    for (int d = 0; d < D; ++d)
    {
        v[d] = normal[grid_.direction(d)];
    }
    if (mag(v) > 0)
    {
        v /= mag(v);
    }
    const vector rest(v - (N & v));
    if (!(mag(rest) > 1e-3))
    {
        return;
    }
    N += rest * rest / magSqr(rest);

    if (patchi >= 0)
    {
        nodeReactions::part part{node, patchi, false, {}, point(Zero)};
        for (int d = 0; d < D; ++d)
        {
            part.normal[d] = rest[d] / mag(rest);
        }
        parts_.append(part);
    }
}

void Foam::mpm::slipVelocity::add(
    const label node, const std::vector<wallSurfaces::surface>& all, const boolList& isWall,
    const bool nearEdge, DynamicList<scalar>& projections)
{
    const int D = grid_.nDim();
    std::vector<label> edge(wallSurfaces::edgesOf(all));
    tensor N(Zero);
    for (size_t k = 0; k < all.size(); ++k)
    {
        const label patchi = all[k].first();
        const bool wall = patchi >= 0 && isWall[patchi];
        // Beside an edge by itself
        edge[k] = !wall ? -1 : edge[k] >= 0 ? edge[k] : nearEdge ? label(all.size() + k) : -1;
        if (edge[k] < 0)
        {
            hold(node, patchi, all[k].second()[0], N);
        }
    }
    for (int i = 0; i < D; ++i)
    {
        for (int j = 0; j < D; ++j)
        {
            projections.append((i == j ? 1 : 0) - N(i, j));
        }
    }
    const tensor held(N);
    for (size_t first = 0; first < all.size(); ++first)
    {
        const label of = edge[first];
        for (size_t k = first; of >= 0 && k < all.size(); ++k)
        {
            if (edge[k] != of)
            {
                continue;
            }
            edge[k] = -1;
            vector n(Zero);
            for (int d = 0; d < D; ++d)
            {
                n[d] = all[k].second()[0][grid_.direction(d)];
            }
            n = normalised(n - (held & n));
            for (int d = 0; d < D; ++d)
            {
                edgeNormals_.append(n[d]);
            }
            hold(node, all[k].first(), all[k].second()[0], N);
        }
        if (of >= 0)
        {
            edgeStart_.append(edgeNormals_.size());
        }
    }
    firstEdge_.append(edgeStart_.size() - 1);
}

void Foam::mpm::slipVelocity::applyEdges(const label i, scalar* u) const
{
    const int D = grid_.nDim();
    for (label e = firstEdge_[i]; e < firstEdge_[i + 1]; ++e)
    {
        scalar least = GREAT;
        const scalar* n = nullptr;
        for (label at = edgeStart_[e]; at < edgeStart_[e + 1]; at += D)
        {
            scalar along = 0;
            for (int d = 0; d < D; ++d)
            {
                along += u[d] * edgeNormals_[at + d];
            }
            if (along < least)
            {
                least = along;
                n = edgeNormals_.cdata() + at;
            }
        }
        for (int d = 0; least > 0 && d < D; ++d)
        {
            u[d] -= least * n[d];
        }
    }
}

void Foam::mpm::slipVelocity::apply(const label i, scalar* u) const
{
    const int D = grid_.nDim();
    const scalar* R = projection_.cdata() + D * D * i;
    scalar v[3];
    for (int a = 0; a < D; ++a)
    {
        v[a] = 0;
        for (int b = 0; b < D; ++b)
        {
            v[a] += R[D * a + b] * u[b];
        }
    }
    for (int a = 0; a < D; ++a)
    {
        u[a] = v[a];
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::slipVelocity::slipVelocity(
    const pointGrid& grid, const sharedNodes& shared, const pointVectorField& U,
    const labelUList& fixedNodes) :
    grid_(grid)
{
    labelHashSet fixed;
    fixed.insert(fixedNodes);
    DynamicList<label> patches;
    boolList isWall(U.boundaryField().size(), false);
    forAll(U.boundaryField(), patchi)
    {
        const pointPatchField<vector>& pf = U.boundaryField()[patchi];
        isWall[patchi] = isA<slipPointPatchField<vector>>(pf);
        if (is(pf))
        {
            patches.append(patchi);
        }
    }
    const wallSurfaces walls(grid, shared, patches, true, fixed);
    for (const auto& entry : walls.faces())
    {
        const label n = entry.first.first();
        findTurn(n, entry.second, walls.surfaces().at(n));
    }

    // Nodes of the cells around edges of the walls
    scalarList nearEdge(grid.nNodes(), scalar(0));
    for (const auto& of : walls.surfaces())
    {
        const std::vector<label> edges(wallSurfaces::edgesOf(of.second));
        const label pointi = grid.nodePoint()[of.first];
        if (pointi < 0 || *std::max_element(edges.begin(), edges.end()) < 0)
        {
            continue;
        }
        for (const label celli : grid.mesh().pointCells()[pointi])
        {
            for (const label n : grid.nodesOf(celli))
            {
                nearEdge[n] = 1;
            }
        }
    }
    shared.largest(nearEdge.data(), 1, 1);

    DynamicList<label> nodes;
    DynamicList<scalar> projections;
    edgeStart_.append(0);
    firstEdge_.append(0);
    for (const auto& of : walls.surfaces())
    {
        nodes.append(of.first);
        add(of.first, of.second, isWall, nearEdge[of.first] > 0, projections);
    }
    node_.transfer(nodes);
    projection_.transfer(projections);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::slipVelocity::is(const pointPatchField<vector>& pf)
{
    return isA<basicSymmetryPointPatchField<vector>>(pf)
        && !isA<fixedNormalSlipPointPatchField<vector>>(pf);
}

void Foam::mpm::slipVelocity::project(const label node, scalar* v) const
{
    const auto at = std::lower_bound(node_.begin(), node_.end(), node);
    if (at != node_.end() && *at == node)
    {
        apply(at - node_.begin(), v);
    }
}

void Foam::mpm::slipVelocity::impose(scalar* u, const int stride, const bool, const bool) const
{
    // Most nodes of a boundary are without points and stand still
    forAll(node_, i)
    {
        scalar* v = u + stride * node_[i];
        bool moves = false;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            moves = moves || v[d] != 0;
        }
        if (moves)
        {
            apply(i, v);
            applyEdges(i, v);
        }
    }
}
