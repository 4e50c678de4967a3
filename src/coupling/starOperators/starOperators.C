/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "starOperators.H"
#include "gridNodes.H"
#include "pointGrid.H"
#include "cyclicPolyPatch.H"
#include "scalarMatrices.H"

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
        sum += cells_.volumes(celli)[s];
    }
    return mesh_.cellVolumes()[celli]/sum;
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
            vertexVolume_[v] = t*cells_.integral(c, i);
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


Foam::vector Foam::mpm::starOperators::sideSum
(
    const label celli,
    const label i
) const
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
                (scalar(corner[k] == i) - b)*cells_.volumes(celli)[s];
            for (int d = 0; d < D; ++d)
            {
                sum[grid_.direction(d)] += share*I[D*k + d];
            }
        }
        corner += D;
        I += D*D;
    }
    return thickness(celli)*sum;
}


Foam::vector Foam::mpm::starOperators::faceShare
(
    const label facei,
    const label node
) const
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
            share += scalar(toNode[p] == node)/f.size();
        }
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            sum[grid_.direction(d)] = share*S[grid_.direction(d)];
        }
        return sum;
    }
    const label base = basePoints_.size() ? basePoints_[facei] : 0;
    const pointField& x = mesh_.points();
    for (label k = 1; k < f.size() - 1; ++k)
    {
        const label p[3] =
        {
            f[base],
            f[(base + k) % f.size()],
            f[(base + k + 1) % f.size()]
        };
        const vector area(0.5*((x[p[1]] - x[p[0]]) ^ (x[p[2]] - x[p[0]])));
        for (const label pointi : p)
        {
            if (toNode[pointi] == node)
            {
                sum += area/3;
            }
        }
    }
    return sum;
}


Foam::scalar Foam::mpm::starOperators::weight(const label facei) const
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const label other =
        facei < mesh_.nInternalFaces() ? facei : mate_[facei];
    const vector way
    (
        (Cf[facei] - C[owner(facei)]) + (C[neighbour(facei)] - Cf[other])
    );
    const vector& S = mesh_.faceAreas()[facei];
    const scalar area = mag(S);

    // Any positive weight will do; a very skewed face gets no huge one
    return area/max(mag(way & S)/area, 0.05*mag(way));
}


Foam::scalarList Foam::mpm::starOperators::potentials
(
    const label node,
    const labelUList& cells,
    const labelUList& faces,
    const UList<scalar>& w
) const
{
    const label n = cells.size();
    scalarSquareMatrix L(n, Zero);
    scalar scale = 0;
    for (const label f : faces)
    {
        const label O = cells.find(owner(f)), N = cells.find(neighbour(f));
        if (O != N)
        {
            const scalar c = weight(f);
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

    scalarList pi(n*n), residual(n);
    for (label h = 0; h < n; ++h)
    {
        scalar* x = pi.begin() + n*h;
        std::fill_n(x, n, 0.0);

        // The second time the residual of the first
        for (int pass = 0; pass < 2; ++pass)
        {
            for (label i = 0; i < n; ++i)
            {
                residual[i] = scalar(i == h) - w[i];
                for (label j = 0; j < n; ++j)
                {
                    residual[i] -= L(i, j)*x[j];
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
            FatalErrorInFunction
                << "The cells around the mesh point at "
                << grid_.nodePositions()[node] << " touch at this point or"
                << " edge only: material points in a gas need cells that are"
                << " joined by faces." << exit(FatalError);
        }
    }
    return pi;
}


Foam::mpm::starOperators::star* Foam::mpm::starOperators::makeStar
(
    const label node
) const
{
    const int D = grid_.nDim();
    const SubList<label> vertices(verticesOf(node));
    const SubList<label> faces(facesOf(node));
    const scalar V = nodeVolume_[node];

    // The cells, each once; of each w and e
    DynamicList<label> cells;
    labelList column(vertices.size());
    DynamicList<scalar> w;
    DynamicList<vector> e;
    forAll(vertices, i)
    {
        const label v = vertices[i], c = cellOf_[v];
        column[i] = cells.find(c);
        if (column[i] < 0)
        {
            column[i] = cells.size();
            cells.append(c);
            w.append(0);
            e.append(vector(Zero));
        }
        w[column[i]] += vertexVolume_[v]/V;
        e[column[i]] += sideSum(c, v - start_[c]);
    }
    const label n = cells.size(), nFaces = faces.size();
    const scalarList pi(potentials(node, cells, faces, w));

    star* made = new star;
    made->g.setSize(vertices.size()*nFaces);
    made->B.setSize(D*nFaces, Zero);
    forAll(faces, k)
    {
        const label f = faces[k];
        const label O = cells.find(owner(f)), N = cells.find(neighbour(f));
        const scalar c = O == N ? 0 : weight(f);
        forAll(vertices, i)
        {
            const scalar* x = pi.begin() + n*column[i];
            made->g[nFaces*i + k] = c*(x[O] - x[N]);
        }
        if (!wall_[node])
        {
            vector a(-faceShare(f, node));
            for (label h = 0; h < n; ++h)
            {
                a += (c*(pi[n*h + O] - pi[n*h + N]))*e[h];
            }
            for (int d = 0; d < D; ++d)
            {
                made->B[D*k + d] = a[grid_.direction(d)]/V;
            }
        }
    }
    return made;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::starOperators::starOperators(const pointGrid& grid)
:
    grid_(grid),
    mesh_(grid.mesh()),
    cells_(grid),
    stars_(grid.nNodes())
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
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::starOperators::toNodes
(
    const UList<scalar>& ofCells,
    scalarList& ofNodes
) const
{
    ofNodes.setSize(grid_.nNodes());
    forAll(ofNodes, l)
    {
        // Equal values stay equal
        const label first = vertexStart_[l], end = vertexStart_[l + 1];
        const scalar base =
            first < end ? ofCells[cellOf_[vertices_[first]]] : 0;
        scalar sum = 0;
        for (label i = first; i < end; ++i)
        {
            const label v = vertices_[i];
            sum += vertexVolume_[v]*(ofCells[cellOf_[v]] - base);
        }
        ofNodes[l] = first < end ? base + sum/nodeVolume_[l] : 0;
    }
}

// ************************************************************************* //
