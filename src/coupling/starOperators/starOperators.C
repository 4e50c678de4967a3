// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "starOperators.H"
#include "gridNodes.H"
#include "pointGrid.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "syncTools.H"
#include "scalarMatrices.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::starOperators::thickness(const label celli) const
{
    // In 3D warped faces let the volumes differ
    if (grid_.nDim() == 3)
    {
        return 1;
    }
    scalar sum = 0;
    for (label s = 0; s < cells_.nSimplices(celli); ++s)
    {
        sum += radius(celli, s) * cells_.volumes(celli)[s];
    }
    return mesh_.cellVolumes()[celli] / sum;
}

void Foam::mpm::starOperators::makeVertices()
{
    const label nCells = mesh_.nCells();
    start_.setSize(nCells + 1);
    start_[0] = 0;
    for (label c = 0; c < nCells; ++c)
    {
        start_[c + 1] = start_[c] + cells_.nVertices(c);
    }
    cellOf_.setSize(start_[nCells]);
    vertexVolume_.setSize(start_[nCells]);
    nodeVolume_.setSize(grid_.nNodes(), Zero);
    vertexStart_.setSize(grid_.nNodes() + 1, Zero);
    for (label c = 0; c < nCells; ++c)
    {
        const scalar t = thickness(c);
        for (label i = 0; i < cells_.nVertices(c); ++i)
        {
            const label v = start_[c] + i, l = cells_.nodes(c)[i];
            cellOf_[v] = c;
            vertexVolume_[v] = t * cells_.integral(c, i);
            nodeVolume_[l] += vertexVolume_[v];
            ++vertexStart_[l + 1];
        }
    }
    for (label l = 0; l < grid_.nNodes(); ++l)
    {
        vertexStart_[l + 1] += vertexStart_[l];
    }
    vertices_.setSize(cellOf_.size());
    labelList next(vertexStart_);
    for (label c = 0; c < nCells; ++c)
    {
        for (label i = 0; i < cells_.nVertices(c); ++i)
        {
            vertices_[next[cells_.nodes(c)[i]]++] = start_[c] + i;
        }
    }
}

void Foam::mpm::starOperators::makeFaces()
{
    mate_.setSize(mesh_.nFaces(), -1);
    const bitSet isEmpty(gridNodes::emptyFaces(mesh_));
    boolList walls(mesh_.nFaces(), false), own(mesh_.nFaces(), false);
    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        own[f] = true;
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const auto* cyclic = isA<cyclicPolyPatch>(pp);
        for (label i = 0; i < pp.size(); ++i)
        {
            const label f = pp.start() + i;
            if (cyclic)
            {
                mate_[f] = cyclic->neighbPatch().start() + i;
                own[f] = cyclic->owner();
            }
            else if (isA<processorPolyPatch>(pp))
            {
                own[f] = true;
            }
            else
            {
                walls[f] = !isEmpty.test(f);
            }
        }
    }

    // The nodes of a face, each once
    DynamicList<label> nodes;
    const auto nodesOf = [&](const label f)
    {
        nodes.clear();
        for (const label p : mesh_.faces()[f])
        {
            const label l = grid_.pointToNode()[p];
            if (!nodes.found(l))
            {
                nodes.append(l);
            }
        }
    };
    wall_.setSize(grid_.nNodes(), false);
    faceStart_.setSize(grid_.nNodes() + 1, Zero);
    for (label f = 0; f < mesh_.nFaces(); ++f)
    {
        if (!own[f] && !walls[f])
        {
            continue;
        }
        nodesOf(f);
        for (const label l : nodes)
        {
            if (walls[f])
            {
                wall_[l] = true;
            }
            else
            {
                ++faceStart_[l + 1];
            }
        }
    }
    for (label l = 0; l < grid_.nNodes(); ++l)
    {
        faceStart_[l + 1] += faceStart_[l];
    }
    faces_.setSize(faceStart_[grid_.nNodes()]);
    labelList next(faceStart_);
    for (label f = 0; f < mesh_.nFaces(); ++f)
    {
        if (own[f])
        {
            nodesOf(f);
            for (const label l : nodes)
            {
                faces_[next[l]++] = f;
            }
        }
    }
}

void Foam::mpm::starOperators::share()
{
    if (!Pstream::parRun())
    {
        return;
    }
    cellNumbers_.reset(new globalIndex(mesh_.nCells()));
    faceNumbers_.reset(new globalIndex(mesh_.nFaces()));
    labelList cells(mesh_.nCells());
    forAll(cells, c)
    {
        cells[c] = cellNumbers_->toGlobal(c);
    }
    syncTools::swapBoundaryCellList(mesh_, cells, cellBehind_);

    const label nInternal = mesh_.nInternalFaces();
    const label n = mesh_.nFaces() - nInternal;
    faceNumber_.setSize(n);
    wayBehind_.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        const label f = nInternal + i;
        faceNumber_[i] = faceNumbers_->toGlobal(f);
        wayBehind_[i] = mesh_.cellCentres()[owner(f)] - mesh_.faceCentres()[f];
    }
    syncTools::swapBoundaryFaceList(mesh_, faceNumber_);
    syncTools::swapBoundaryFaceList(mesh_, wayBehind_);

    others_.reset(new sharedStars(grid_, [&](const label l, starPart& part) { ownPart(l, part); }));
    others_->nodes().sum(nodeVolume_.begin(), 1, 1);
}

Foam::vector Foam::mpm::starOperators::sideSum(const label celli, const label i) const
{
    const int D = grid_.nDim();
    const scalar b = cells_.originShare(celli, i);
    const label* corner = cells_.corners(celli);
    const scalar* I = cells_.inverses(celli);
    vector sum(Zero);
    for (label s = 0; s < cells_.nSimplices(celli); ++s)
    {
        for (int k = 0; k < D; ++k)
        {
            const scalar share =
                (scalar(corner[k] == i) - b) * radius(celli, s) * cells_.volumes(celli)[s];
            for (int d = 0; d < D; ++d)
            {
                sum[grid_.direction(d)] += share * I[D * k + d];
            }
        }
        corner += D;
        I += D * D;
    }
    return thickness(celli) * sum;
}

Foam::vector Foam::mpm::starOperators::faceShare(const label facei, const label node) const
{
    const face& f = mesh_.faces()[facei];
    const labelList& toNode = grid_.pointToNode();
    vector sum(Zero);
    if (grid_.nDim() < 3)
    {
        const vector& S = mesh_.faceAreas()[facei];
        scalar share = 0;
        for (const label p : f)
        {
            if (toNode[p] == node)
            {
                share += grid_.radial() < 0 ? 1.0 / f.size() : wedgeShare(f, p);
            }
        }
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            sum[grid_.direction(d)] = share * S[grid_.direction(d)];
        }
        return sum;
    }
    const label base = basePoints_.size() ? basePoints_[facei] : 0;
    const pointField& x = mesh_.points();
    for (label k = 1; k < f.size() - 1; ++k)
    {
        const label p[3] = {f[base], f[(base + k) % f.size()], f[(base + k + 1) % f.size()]};
        const vector area(0.5 * ((x[p[1]] - x[p[0]]) ^ (x[p[2]] - x[p[0]])));
        for (const label pointi : p)
        {
            if (toNode[pointi] == node)
            {
                sum += area / 3;
            }
        }
    }
    return sum;
}

Foam::scalar Foam::mpm::starOperators::weight(const label facei) const
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const label other = facei < mesh_.nInternalFaces() ? facei : mate_[facei];
    const vector way(
        (Cf[facei] - C[owner(facei)])
        + (other < 0 ? wayBehind_[facei - mesh_.nInternalFaces()]
                     : C[neighbour(facei)] - Cf[other]));
    const vector& S = mesh_.faceAreas()[facei];
    const scalar area = mag(S);

    // Any positive weight will do; a very skewed face gets no huge one
    return area / max(mag(way & S) / area, 0.05 * mag(way));
}

bool Foam::mpm::starOperators::ofLower(const label facei) const
{
    const label i = facei - mesh_.nInternalFaces();
    return i >= 0 && mate_[facei] < 0 && faceNumber_[i] < faceNumbers_->toGlobal(facei);
}

Foam::mpm::starPart::edge
Foam::mpm::starOperators::edgeOf(const label facei, const label node) const
{
    const label i = facei - mesh_.nInternalFaces();
    starPart::edge e;
    e.face = faceNumbers_ ? faceNumbers_->toGlobal(facei) : facei;
    e.owner = number(owner(facei));
    e.neighbour = i >= 0 && mate_[facei] < 0 ? cellBehind_[i] : number(neighbour(facei));
    e.weight = e.owner == e.neighbour ? 0 : weight(facei);
    e.share = faceShare(facei, node);
    return e;
}

void Foam::mpm::starOperators::ownPart(const label node, starPart& part) const
{
    for (const label v : verticesOf(node))
    {
        const label c = cellOf_[v];
        part.vertices.append(
            starPart::vertex{number(c), vertexVolume_[v], surfaceSum(c, v - start_[c])});
    }
    for (const label f : facesOf(node))
    {
        if (!ofLower(f))
        {
            part.edges.append(edgeOf(f, node));
        }
    }
    part.wall = wall_[node];
}

Foam::scalarList Foam::mpm::starOperators::potentials(
    const label node, const labelUList& cells, const UList<starPart::edge>& edges,
    const UList<scalar>& w) const
{
    const label n = cells.size();
    scalarSquareMatrix L(n, Zero);
    scalar scale = 0;
    for (const starPart::edge& e : edges)
    {
        const label O = cells.find(e.owner), N = cells.find(e.neighbour);
        if (O != N)
        {
            const scalar c = e.weight;
            L(O, O) += c;
            L(N, N) += c;
            L(O, N) -= c;
            L(N, O) -= c;
            scale += c;
        }
    }
    scale /= max(n, 1);
    scalarSquareMatrix inverse(L);
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            inverse(i, j) += max(scale, SMALL);
        }
    }
    labelList pivots(n);
    LUDecompose(inverse, pivots);

    scalarList pi(n * n), residual(n);
    for (label h = 0; h < n; ++h)
    {
        scalar* x = pi.begin() + n * h;
        std::fill_n(x, n, 0.0);

        // The second time the residual of the first
        for (int pass = 0; pass < 2; ++pass)
        {
            for (label i = 0; i < n; ++i)
            {
                residual[i] = scalar(i == h) - w[i];
                for (label j = 0; j < n; ++j)
                {
                    residual[i] -= L(i, j) * x[j];
                }
            }
            LUBacksubstitute(inverse, pivots, residual);
            for (label i = 0; i < n; ++i)
            {
                x[i] += residual[i];
            }
        }
    }
    for (const scalar p : pi)
    {
        if (!std::isfinite(p))
        {
            FatalErrorInFunction << "The cells around the mesh point at "
                                 << grid_.nodePositions()[node] << " touch at this point or"
                                 << " edge only: material points in a gas need cells that are"
                                 << " joined by faces." << exit(FatalError);
        }
    }
    return pi;
}

Foam::mpm::starOperators::star* Foam::mpm::starOperators::makeStar(const label node) const
{
    const int D = grid_.nDim();
    const SubList<label> faces(facesOf(node));
    const scalar V = nodeVolume_[node];

    // Other processors' parts behind the own one
    starPart all;
    ownPart(node, all);
    if (const starPart* others = others_ ? others_->othersOf(node) : nullptr)
    {
        all.vertices.append(others->vertices);
        all.edges.append(others->edges);
        all.wall = all.wall || others->wall;
    }

    // The cells, each once; of each w and e
    DynamicList<label> cells;
    labelList column(all.vertices.size());
    DynamicList<scalar> w;
    DynamicList<vector> e;
    forAll(column, i)
    {
        const starPart::vertex& v = all.vertices[i];
        column[i] = cells.find(v.cell);
        if (column[i] < 0)
        {
            column[i] = cells.size();
            cells.append(v.cell);
            w.append(0);
            e.append(vector(Zero));
        }
        w[column[i]] += v.volume / V;
        e[column[i]] += v.side;
    }
    const label n = cells.size(), nFaces = faces.size();
    const scalarList pi(potentials(node, cells, all.edges, w));

    star* made = new star;
    made->g.setSize(column.size() * nFaces);
    made->B.setSize(D * nFaces, Zero);
    label next = 0;
    forAll(faces, k)
    {
        // A face of a lower processor is its edge, the other way round
        const bool turned = ofLower(faces[k]);
        const starPart::edge* edge = nullptr;
        if (turned)
        {
            const label at = faceNumber_[faces[k] - mesh_.nInternalFaces()];
            for (const starPart::edge& e : all.edges)
            {
                edge = e.face == at ? &e : edge;
            }
        }
        else
        {
            edge = &all.edges[next++];
        }
        const label O = cells.find(edge->owner), N = cells.find(edge->neighbour);
        const scalar c = turned ? -edge->weight : edge->weight;
        forAll(column, i)
        {
            const scalar* x = pi.begin() + n * column[i];
            made->g[nFaces * i + k] = c * (x[O] - x[N]);
        }
        if (!all.wall)
        {
            vector a(turned ? edge->share : -edge->share);
            for (label h = 0; h < n; ++h)
            {
                a += (c * (pi[n * h + O] - pi[n * h + N])) * e[h];
            }
            for (int d = 0; d < D; ++d)
            {
                made->B[D * k + d] = a[grid_.direction(d)] / V;
            }
        }
    }
    return made;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::starOperators::starOperators(const pointGrid& grid) :
    grid_(grid), mesh_(grid.mesh()), cells_(grid), stars_(grid.nNodes())
{
    // Where all faces are triangles their base points do not matter
    bool triangles = true;
    for (const face& f : mesh_.faces())
    {
        triangles = triangles && f.size() == 3;
    }
    reduce(triangles, andOp<bool>());
    if (grid.nDim() == 3 && !triangles)
    {
        basePoints_ = cellSimplices::findBasePoints(grid);
    }
    makeVertices();
    makeFaces();
    share();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::starOperators::toNodes(
    const UList<scalar>& ofCells, scalarList& ofNodes, const labelUList* some) const
{
    // Nodes of cells that points come into later have none yet
    ofNodes.setSize(grid_.nNodes(), Zero);
    sums_.setSize(others_ ? grid_.nNodes() : 0);
    const auto mean = [&](const label l)
    {
        // Equal values stay equal
        const label first = vertexStart_[l], end = vertexStart_[l + 1];
        const scalar base = first < end ? ofCells[cellOf_[vertices_[first]]] : 0;
        scalar sum = 0;
        for (label i = first; i < end; ++i)
        {
            const label v = vertices_[i];
            sum += vertexVolume_[v] * (ofCells[cellOf_[v]] - base);
        }
        if (others_ && others_->othersOf(l))
        {
            ofNodes[l] = base;
            sums_[l] = sum;
        }
        else
        {
            ofNodes[l] = first < end ? base + sum / nodeVolume_[l] : 0;
        }
    };
    if (some)
    {
        std::for_each(some->cbegin(), some->cend(), mean);
    }
    else
    {
        forAll(ofNodes, l)
        {
            mean(l);
        }
    }
    if (others_)
    {
        if (some)
        {
            const labelList& shared = others_->nodes().nodes();
            std::for_each(shared.cbegin(), shared.cend(), mean);
        }
        others_->means(ofNodes, sums_);
    }
}
