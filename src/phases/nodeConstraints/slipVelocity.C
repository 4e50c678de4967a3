// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "slipVelocity.H"
#include "cornerNormal.H"
#include "basicSymmetryPointPatchField.H"
#include "fixedNormalSlipPointPatchField.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Nodes on the axis of a wedge, of cells that are no hexahedra by radius
labelList onAxis(const mpm::pointGrid& grid)
{
    DynamicList<label> nodes(grid.axisNodes());
    const scalar near = 1e-6 * grid.mesh().bounds().mag();
    const int r = grid.direction(grid.radial());
    forAll(grid.nodePoint(), n)
    {
        const label pointi = grid.nodePoint()[n];
        if (pointi >= 0 && grid.mesh().points()[pointi][r] < near)
        {
            nodes.append(n);
        }
    }
    Foam::inplaceUniqueSort(nodes);
    return labelList(std::move(nodes));
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::List<Foam::mpm::slipVelocity::faceNormal>>
Foam::mpm::slipVelocity::allNormals(const pointVectorField& U) const
{
    const bool parallel = Pstream::parRun();
    List<List<faceNormal>> normals(Pstream::nProcs());
    labelHashSet isShared;
    isShared.insert(shared_.nodes());
    DynamicList<faceNormal> mine, others;
    const auto add = [&](const label n, const label patchi, const vector& nf, const vector& to)
    {
        const label key = parallel ? grid_.nodeKey()[n] : n;
        (isShared.found(n) ? mine : others)
            .append(faceNormal(labelPair(key, patchi), Pair<vector>(nf, to)));
    };

    forAll(U.boundaryField(), patchi)
    {
        const pointPatchField<vector>& pf = U.boundaryField()[patchi];
        if (!is(pf))
        {
            continue;
        }
        const polyPatch& pp = grid_.mesh().boundaryMesh()[pf.patch().index()];
        forAll(pp.meshPoints(), i)
        {
            const label pointi = pp.meshPoints()[i];
            for (const label facei : pp.pointFaces()[i])
            {
                add(grid_.pointToNode()[pointi], patchi, cornerNormal(pp, facei, pointi),
                    pp.faceCentres()[facei] - pp.points()[pointi]);
            }
        }
    }
    if (grid_.radial() >= 0)
    {
        vector radius(Zero);
        radius[grid_.direction(grid_.radial())] = 1;
        for (const label n : onAxis(grid_))
        {
            add(n, -1, radius, vector(Zero));
        }
    }
    normals[Pstream::myProcNo()].transfer(mine);
    if (parallel)
    {
        Pstream::gatherList(normals);
        Pstream::scatterList(normals);
    }
    normals[Pstream::myProcNo()].append(others);
    return normals;
}

Foam::mpm::slipVelocity::normalsOfNodes Foam::mpm::slipVelocity::byNode(
    const List<List<faceNormal>>& normals, const labelHashSet& fixed) const
{
    const bool parallel = Pstream::parRun();
    Map<label> nodeOfKey;
    if (parallel)
    {
        forAll(grid_.nodeKey(), n)
        {
            nodeOfKey.insert(grid_.nodeKey()[n], n);
        }
    }

    normalsOfNodes ofNode;
    for (const List<faceNormal>& list : normals)
    {
        for (const faceNormal& f : list)
        {
            label n = f.first().first();
            if (parallel)
            {
                const auto iter = nodeOfKey.cfind(n);
                n = iter.good() ? iter.val() : -1;
            }
            if (n >= 0 && !fixed.found(n))
            {
                ofNode[labelPair(n, f.first().second())].push_back(f.second());
            }
        }
    }

    // In an order that is the same on all processors
    for (auto& entry : ofNode)
    {
        std::sort(
            entry.second.begin(), entry.second.end(),
            [](const Pair<vector>& a, const Pair<vector>& b) {
                return std::lexicographical_compare(
                    a[0].begin(), a[0].end(), b[0].begin(), b[0].end());
            });
    }
    return ofNode;
}

std::vector<Foam::Pair<Foam::vector>>
Foam::mpm::slipVelocity::surfaces(const std::vector<Pair<vector>>& faces)
{
    // pointNormals() would average over the edges of a patch that has some.
    // Faces at less than 45 degrees are one smooth surface, at edges of the wall
    // at less than 20; others are surfaces of their own (edges, corners)
    std::vector<Pair<vector>> groups;
    for (const Pair<vector>& f : faces)
    {
        bool known = false;
        for (Pair<vector>& g : groups)
        {
            const scalar least = atEdge(g, f) ? 0.94 : 0.7;
            if (!known && (g[0] & f[0]) > least * mag(g[0]) * mag(f[0]))
            {
                g[0] += f[0];
                g[1] += f[1];
                known = true;
            }
        }
        if (!known)
        {
            groups.push_back(f);
        }
    }
    return groups;
}

void Foam::mpm::slipVelocity::join(
    const label patchi, const std::vector<Pair<vector>>& normals, std::vector<surface>& all)
{
    for (const Pair<vector>& f : normals)
    {
        surface* same = nullptr;
        for (surface& s : all)
        {
            const vector& n = s.second()[0];
            if (!same && s.first() >= 0 && patchi >= 0 && s.first() != patchi
                && (n & f[0]) > 0.94 * mag(n) * mag(f[0]))
            {
                same = &s;
            }
        }
        if (same)
        {
            same->second()[0] += f[0];
            same->second()[1] += f[1];
        }
        else
        {
            all.push_back(surface(patchi, f));
        }
    }
}

bool Foam::mpm::slipVelocity::atEdge(const Pair<vector>& a, const Pair<vector>& b)
{
    // Each leads away from the mesh on the other's side
    const auto beyond = [](const Pair<vector>& of, const Pair<vector>& to)
    {
        const vector &n = of[0], &e = to[1];
        return (n & e) > 1e-3 * mag(n) * mag(e);
    };
    return beyond(a, b) && beyond(b, a);
}

void Foam::mpm::slipVelocity::findTurn(
    const label node, const std::vector<Pair<vector>>& faces, const std::vector<surface>& all)
{
    constexpr scalar least = 1e-4;
    for (const Pair<vector>& f : faces)
    {
        scalar apart = GREAT;
        for (const surface& s : all)
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
    const label node, const std::vector<surface>& all, DynamicList<scalar>& projections)
{
    const int D = grid_.nDim();
    std::vector<surface> edges;
    tensor N(Zero);
    for (const surface& s : all)
    {
        const bool edge = std::any_of(
            all.begin(), all.end(),
            [&](const surface& other) { return atEdge(s.second(), other.second()); });
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
    for (const surface& s : edges)
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
    grid_(grid), shared_(shared)
{
    labelHashSet fixed;
    fixed.insert(fixedNodes);
    normalsOfNodes ofNode(byNode(allNormals(U), fixed));

    std::map<label, std::vector<surface>> ofAll;
    for (auto& entry : ofNode)
    {
        join(entry.first.second(), surfaces(entry.second), ofAll[entry.first.first()]);
    }

    for (const auto& entry : ofNode)
    {
        const label n = entry.first.first();
        findTurn(n, entry.second, ofAll[n]);
    }

    DynamicList<label> nodes;
    DynamicList<scalar> projections;
    edgeStart_.append(0);
    for (const auto& of : ofAll)
    {
        nodes.append(of.first);
        add(of.first, of.second, projections);
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
