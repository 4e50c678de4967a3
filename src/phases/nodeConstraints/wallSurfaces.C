// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "wallSurfaces.H"
#include "cornerNormal.H"
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

Foam::List<Foam::List<Foam::mpm::wallSurfaces::faceNormal>> Foam::mpm::wallSurfaces::allNormals(
    const sharedNodes& shared, const labelUList& patches, const bool axis) const
{
    const bool parallel = Pstream::parRun();
    List<List<faceNormal>> normals(Pstream::nProcs());
    labelHashSet isShared;
    isShared.insert(shared.nodes());
    DynamicList<faceNormal> mine, others;
    const auto add = [&](const label n, const label patchi, const vector& nf, const vector& to)
    {
        const label key = parallel ? grid_.nodeKey()[n] : n;
        (isShared.found(n) ? mine : others)
            .append(faceNormal(labelPair(key, patchi), Pair<vector>(nf, to)));
    };

    for (const label patchi : patches)
    {
        const polyPatch& pp = grid_.mesh().boundaryMesh()[patchi];
        forAll(pp.meshPoints(), i)
        {
            const label pointi = pp.meshPoints()[i];
            for (const label facei : pp.pointFaces()[i])
            {
                add(grid_.pointToNode()[pointi], patchi, cornerNormal(pp, facei, pointi),
                    normalised(pp.faceCentres()[facei] - pp.points()[pointi]));
            }
        }
    }
    if (axis && grid_.radial() >= 0)
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

Foam::mpm::wallSurfaces::facesOfNodes Foam::mpm::wallSurfaces::byNode(
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

    facesOfNodes ofNode;
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
Foam::mpm::wallSurfaces::group(const std::vector<Pair<vector>>& faces)
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

void Foam::mpm::wallSurfaces::join(
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

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::wallSurfaces::wallSurfaces(
    const pointGrid& grid, const sharedNodes& shared, const labelUList& patches, const bool axis,
    const labelHashSet& without) :
    grid_(grid)
{
    faces_ = byNode(allNormals(shared, patches, axis), without);
    for (const auto& entry : faces_)
    {
        join(entry.first.second(), group(entry.second), surfaces_[entry.first.first()]);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::wallSurfaces::atEdge(const Pair<vector>& a, const Pair<vector>& b)
{
    // Each ends there, and leads away from the mesh on the other's side
    const auto beyond = [](const Pair<vector>& of, const Pair<vector>& to)
    {
        const vector &n = of[0], &e = to[1];
        return mag(e) > 0.1 && (n & e) > 1e-3 * mag(n) * mag(e);
    };
    return beyond(a, b) && beyond(b, a);
}

std::vector<Foam::label> Foam::mpm::wallSurfaces::edgesOf(const std::vector<surface>& all)
{
    const label n = all.size();
    std::vector<label> edge(n, -1);
    label nEdges = 0;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (!atEdge(all[i].second(), all[j].second()))
            {
                continue;
            }
            const label from = edge[i];
            edge[j] = edge[j] >= 0 ? edge[j] : from >= 0 ? from : nEdges++;
            edge[i] = edge[j];
            // Two edges that the surface i joins are one
            for (label& e : edge)
            {
                e = from >= 0 && e == from ? edge[j] : e;
            }
        }
    }
    return edge;
}
