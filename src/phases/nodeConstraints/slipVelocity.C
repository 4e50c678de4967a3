// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "slipVelocity.H"
#include "basicSymmetryPointPatchField.H"
#include "fixedNormalSlipPointPatchField.H"
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
    const label node, const std::vector<wallSurfaces::surface>& all, const scalarList& besideEdge,
    DynamicList<scalar>& projections)
{
    const int D = grid_.nDim();
    std::vector<wallSurfaces::surface> edges;
    tensor N(Zero);
    for (const wallSurfaces::surface& s : all)
    {
        // A wall beside an edge of it holds only what presses on it
        const bool edge = (besideEdge[node] > 0 && all.size() == 1)
            || std::any_of(all.begin(), all.end(),
                           [&](const wallSurfaces::surface& other) {
                               return &other != &s
                                   && wallSurfaces::atEdge(s.second(), other.second());
                           });
        if (edge)
        {
            edges.push_back(s);
        }
        else
        {
            hold(node, s.first(), s.second()[0], N);
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
    for (const wallSurfaces::surface& s : edges)
    {
        vector n(Zero);
        for (int d = 0; d < D; ++d)
        {
            n[d] = s.second()[0][grid_.direction(d)];
        }
        n = normalised(n - (held & n));
        for (int d = 0; d < D; ++d)
        {
            edge_.append(n[d]);
        }
        hold(node, s.first(), s.second()[0], N);
    }
    edgeStart_.append(edge_.size());
}

void Foam::mpm::slipVelocity::applyEdge(const label i, scalar* u) const
{
    const int D = grid_.nDim();
    scalar least = GREAT;
    const scalar* n = nullptr;
    for (label at = edgeStart_[i]; at < edgeStart_[i + 1]; at += D)
    {
        scalar along = 0;
        for (int d = 0; d < D; ++d)
        {
            along += u[d] * edge_[at + d];
        }
        if (along < least)
        {
            least = along;
            n = edge_.cdata() + at;
        }
    }
    for (int d = 0; least > 0 && n && d < D; ++d)
    {
        u[d] -= least * n[d];
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
    forAll(U.boundaryField(), patchi)
    {
        if (is(U.boundaryField()[patchi]))
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
    scalarList besideEdge(grid.nNodes(), scalar(0));
    for (const auto& of : walls.surfaces())
    {
        const std::vector<wallSurfaces::surface>& all = of.second;
        const label pointi = grid.nodePoint()[of.first];
        const bool edge = std::any_of(
            all.begin(), all.end(),
            [&](const wallSurfaces::surface& s)
            {
                return std::any_of(
                    all.begin(), all.end(),
                    [&](const wallSurfaces::surface& other)
                    { return &other != &s && wallSurfaces::atEdge(s.second(), other.second()); });
            });
        for (label i = 0; edge && pointi >= 0 && i < grid.mesh().pointCells()[pointi].size(); ++i)
        {
            for (const label n : grid.nodesOf(grid.mesh().pointCells()[pointi][i]))
            {
                besideEdge[n] = 1;
            }
        }
    }
    shared.largest(besideEdge.data(), 1, 1);

    DynamicList<label> nodes;
    DynamicList<scalar> projections;
    edgeStart_.append(0);
    for (const auto& of : walls.surfaces())
    {
        nodes.append(of.first);
        add(of.first, of.second, besideEdge, projections);
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
            applyEdge(i, v);
        }
    }
}
