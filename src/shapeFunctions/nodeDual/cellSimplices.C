// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "cellSimplices.H"
#include "pointGrid.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Inverse of the edges of a simplex (columns of E) and its volume
scalar invertEdges(const int nDim, const scalar* E, scalar* I)
{
    tensor J(tensor::I);
    for (int i = 0; i < nDim; ++i)
    {
        for (int k = 0; k < nDim; ++k)
        {
            J[3 * i + k] = E[nDim * k + i];
        }
    }
    const scalar d = det(J);
    if (d > 0)
    {
        const tensor inverse(inv(J));
        for (int k = 0; k < nDim; ++k)
        {
            for (int i = 0; i < nDim; ++i)
            {
                I[nDim * k + i] = inverse[3 * k + i];
            }
        }
    }
    return d / (nDim == 3 ? 6 : nDim);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::cellSimplices::addVertices(
    const pointGrid& grid, const bitSet& isEmpty, const label celli, DynamicList<label>& points)
{
    const polyMesh& mesh = grid.mesh();
    points.clear();
    if (grid.nDim() == 3)
    {
        points.append(mesh.cellPoints()[celli]);
        return;
    }
    label side = -1;
    for (const label facei : mesh.cells()[celli])
    {
        const face& f = mesh.faces()[facei];
        if (grid.nDim() == 1 && !isEmpty.test(facei))
        {
            points.append(f[0]);
        }
        else if (isEmpty.test(facei) && (side < 0 || facei < side))
        {
            side = facei;
        }
    }
    if (grid.nDim() == 2)
    {
        points.append(mesh.faces()[side]);
    }

    // Along the axis, or round the cell in the positive sense
    const auto x = [&](const label i, const int d)
    { return mesh.points()[points[i]][grid.direction(d)]; };
    const label n = points.size();
    scalar area = grid.nDim() == 1 ? x(n - 1, 0) - x(0, 0) : 0;
    for (label i = 0; grid.nDim() == 2 && i < n; ++i)
    {
        const label j = (i + 1) % n;
        area += x(i, 0) * x(j, 1) - x(j, 0) * x(i, 1);
    }
    if (area < 0)
    {
        inplaceReverseList(points);
    }
}

Foam::labelList Foam::mpm::cellSimplices::findBasePoints(const pointGrid& grid)
{
    const polyMesh& mesh = grid.mesh();
    const pointField& x = mesh.points();
    pointField O(mesh.nCells(), Zero);
    forAll(O, celli)
    {
        const labelList& points = mesh.cellPoints()[celli];
        for (const label pointi : points)
        {
            O[celli] += x[pointi] / points.size();
        }
    }

    // Origins behind the faces of the boundary, where a cell is
    pointField behind(mesh.nFaces() - mesh.nInternalFaces());
    bitSet hasBehind(mesh.nFaces());
    forAll(behind, i)
    {
        behind[i] = O[mesh.faceOwner()[mesh.nInternalFaces() + i]];
    }
    syncTools::swapBoundaryFacePositions(mesh, behind);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled())
        {
            hasBehind.set(labelRange(pp.start(), pp.size()));
        }
    }

    // Of points that are alike the one furthest in an oblique direction
    const vector oblique(1e-9, 0.73e-9, 0.41e-9);
    labelList base(mesh.nFaces(), Zero);
    forAll(base, facei)
    {
        const face& f = mesh.faces()[facei];
        if (f.size() == 3)
        {
            continue;
        }

        // Least volume of a tetrahedron of both cells, over that of a cube of
        // the face
        const bool inside = mesh.isInternalFace(facei);
        const point& own = O[mesh.faceOwner()[facei]];
        const point& other =
            inside ? O[mesh.faceNeighbour()[facei]] : behind[facei - mesh.nInternalFaces()];
        const scalar length = sqrt(mag(mesh.faceAreas()[facei]));
        const auto least = [&](const label at)
        {
            const point& b = x[f[at]];
            scalar v = VGREAT;
            for (label k = 1; k < f.size() - 1; ++k)
            {
                const vector n(
                    (x[f[(at + k) % f.size()]] - b) ^ (x[f[(at + k + 1) % f.size()]] - b));
                v = min(v, n & (b - own));
                if (inside || hasBehind.test(facei))
                {
                    v = min(v, n & (other - b));
                }
            }
            return v / pow3(length) + ((b - x[f[0]]) & oblique) / length;
        };
        scalar most = least(0);
        if (most < 1e-3)
        {
            for (label at = 1; at < f.size(); ++at)
            {
                const scalar v = least(at);
                if (v > most)
                {
                    most = v;
                    base[facei] = at;
                }
            }
        }
    }
    return base;
}

void Foam::mpm::cellSimplices::addCorners(
    const pointGrid& grid, const bitSet& isEmpty, const labelUList& basePoints, const label celli,
    const labelUList& vertices, DynamicList<label>& corners, DynamicList<label>& faces)
{
    const polyMesh& mesh = grid.mesh();
    const int nDim = grid.nDim();
    const label n = vertices.size();
    corners.clear();
    if (nDim == 1 || (nDim == 2 && n == 3))
    {
        for (int k = 1; k <= nDim; ++k)
        {
            corners.append(k);
        }
        faces.append(-1);
        return;
    }
    if (nDim == 2)
    {
        for (label i = 0; i < n; ++i)
        {
            const label a = vertices[i], b = vertices[(i + 1) % n];
            corners.append(i);
            corners.append((i + 1) % n);
            label side = -1;
            for (const label facei : mesh.cells()[celli])
            {
                const face& f = mesh.faces()[facei];
                if (!isEmpty.test(facei) && f.found(a) && f.found(b))
                {
                    side = facei;
                }
            }
            faces.append(side);
        }
        return;
    }

    for (const label facei : mesh.cells()[celli])
    {
        const face& f = mesh.faces()[facei];
        const bool outward = mesh.faceOwner()[facei] == celli;
        if (n == 4)
        {
            // The face opposite to the first vertex
            if (f.found(vertices[0]))
            {
                continue;
            }
        }
        const label base = basePoints.size() ? basePoints[facei] : 0;
        for (label k = 1; k < f.size() - 1; ++k)
        {
            const label a = f[(base + k) % f.size()];
            const label b = f[(base + k + 1) % f.size()];
            corners.append(vertices.find(f[base]));
            corners.append(vertices.find(outward ? a : b));
            corners.append(vertices.find(outward ? b : a));
            faces.append(n == 4 ? -1 : facei);
        }
    }
}

bool Foam::mpm::cellSimplices::sortBox(
    const int nDim, DynamicList<label>& points, DynamicList<scalar>& x, DynamicList<label>& corners,
    labelUList faces)
{
    // Rounding of positions in a file may be 1e-8 of the width
    const label n = points.size();
    if (nDim < 2 || n != label(1) << nDim || faces.size() != (nDim - 1) * 2 * nDim)
    {
        return false;
    }
    scalar low[3], high[3];
    for (int d = 0; d < nDim; ++d)
    {
        low[d] = high[d] = x[d];
        for (label i = 1; i < n; ++i)
        {
            low[d] = min(low[d], x[nDim * i + d]);
            high[d] = max(high[d], x[nDim * i + d]);
        }
    }
    labelList to(n, Zero), at(n, -1);
    for (label i = 0; i < n; ++i)
    {
        for (int d = 0; d < nDim; ++d)
        {
            const scalar up = (x[nDim * i + d] - low[d]) / (high[d] - low[d]);
            to[i] |= (up > 0.5) << d;
            if (!(min(up, 1 - up) < 1e-8))
            {
                return false;
            }
        }
        if (at[to[i]] >= 0)
        {
            return false;
        }
        at[to[i]] = i;
    }

    // The corners of a simplex have the bit of its direction alike
    DynamicList<label> order;
    for (int side = 0; side < 2 * nDim; ++side)
    {
        forAll(faces, s)
        {
            bool here = true;
            for (int k = 0; k < nDim; ++k)
            {
                here = here && (to[corners[nDim * s + k]] >> (side / 2)) % 2 == side % 2;
            }
            if (here)
            {
                order.append(s);
            }
        }
    }
    if (order.size() != faces.size())
    {
        return false;
    }
    const labelList oldPoints(points), oldCorners(corners), oldFaces(faces);
    const scalarList oldX(x);
    for (label i = 0; i < n; ++i)
    {
        points[i] = oldPoints[at[i]];
        std::copy_n(oldX.begin() + nDim * at[i], nDim, x.begin() + nDim * i);
    }
    forAll(order, s)
    {
        faces[s] = oldFaces[order[s]];
        for (int k = 0; k < nDim; ++k)
        {
            corners[nDim * s + k] = to[oldCorners[nDim * order[s] + k]];
        }
    }
    return true;
}

void Foam::mpm::cellSimplices::setMaps()
{
    const label n = nDim_ * (nDim_ + 1);
    for (label celli = 0; celli < start_.size() - 1; ++celli)
    {
        if (!isSimplex(celli))
        {
            continue;
        }
        maps_.setSize(n * (start_.size() - 1), 0);
        scalar* to = maps_.begin() + n * celli;
        std::copy_n(origin(celli), nDim_, to);
        for (int k = 0; k < nDim_; ++k)
        {
            std::copy_n(inverses(celli) + nDim_ * k, nDim_, to + nDim_ * corners(celli)[k]);
        }
    }
}

void Foam::mpm::cellSimplices::refuse(const polyMesh& mesh, const labelUList& bad)
{
    const label n = returnReduce(bad.size(), sumOp<label>());
    if (!n)
    {
        return;
    }
    OStringStream own;
    for (label i = 0; i < min(bad.size(), label(5)); ++i)
    {
        own << (i ? "; " : "") << "cell " << bad[i];
        if (Pstream::parRun())
        {
            own << " of processor " << Pstream::myProcNo();
        }
        own << " at " << mesh.cellCentres()[bad[i]] << ", volume " << mesh.cellVolumes()[bad[i]];
    }
    List<string> places(Pstream::nProcs());
    places[Pstream::myProcNo()] = own.str();
    Pstream::gatherList(places);
    Pstream::scatterList(places);
    OStringStream s;
    s << n << (n == 1 ? " cell is" : " cells are") << " flat, folded over or"
      << " far from convex: faces are not seen from the mean of the cell's"
      << " points";
    for (const string& of : places)
    {
        if (!of.empty())
        {
            s << "; " << of.c_str();
        }
    }
    throw string(s.str());
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::cellSimplices::cellSimplices(const pointGrid& grid, const kinds kind) :
    nDim_(grid.nDim()),
    radial_(grid.radial()),
    box_(grid.nCells(), kind == products),
    start_(grid.nCells() + 1, Zero),
    origin_(grid.nDim() * grid.nCells(), Zero),
    subStart_(grid.nCells() + 1, Zero)
{
    const polyMesh& mesh = grid.mesh();
    const bitSet isEmpty(gridNodes::emptyFaces(mesh));

    // Where all faces are triangles their base points do not matter
    bool triangles = true;
    for (const face& f : mesh.faces())
    {
        triangles = triangles && f.size() == 3;
    }
    reduce(triangles, andOp<bool>());
    const labelList basePoints(
        nDim_ < 3 || triangles || kind == products ? labelList() : findBasePoints(grid));

    DynamicList<label> nodes, corners, points, ofCell, faces;
    DynamicList<scalar> x, at, inverses, volumes;
    DynamicList<label> bad;
    for (label celli = 0; celli < grid.nCells(); ++celli)
    {
        addVertices(grid, isEmpty, celli, points);
        const label n = points.size(), firstSub = volumes.size();
        at.clear();
        for (const label pointi : points)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                at.append(mesh.points()[pointi][grid.direction(d)]);
            }
        }
        ofCell.clear();
        if (kind != products)
        {
            addCorners(grid, isEmpty, basePoints, celli, points, ofCell, faces);
        }
        if (kind == boxes && radial_ < 0 && mesh.cells()[celli].size() == 6)
        {
            SubList<label> ofSimplices(faces, faces.size() - firstSub, firstSub);
            box_[celli] = sortBox(nDim_, points, at, ofCell, ofSimplices);
        }
        for (const label pointi : points)
        {
            nodes.append(grid.pointToNode()[pointi]);
        }
        x.append(at);
        scalar* O = origin_.begin() + nDim_ * celli;
        const bool simplex = kind != products && n == nDim_ + 1;
        for (label i = 0; i < (simplex ? 1 : n); ++i)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                O[d] += at[nDim_ * i + d] / (simplex ? 1 : n);
            }
        }

        bool valid = n > nDim_ && mesh.cellVolumes()[celli] > 0;
        scalar sum = 0;
        for (label k = 0; valid && k < ofCell.size(); k += nDim_)
        {
            scalar E[9], I[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
            for (int j = 0; j < nDim_; ++j)
            {
                for (int d = 0; d < nDim_; ++d)
                {
                    E[nDim_ * j + d] = at[nDim_ * ofCell[k + j] + d] - O[d];
                }
            }
            volumes.append(invertEdges(nDim_, E, I));
            sum += mag(volumes.last());
            for (int j = 0; j < nDim_ * nDim_; ++j)
            {
                inverses.append(I[j]);
            }
        }
        for (label s = firstSub; s < volumes.size(); ++s)
        {
            valid = valid && volumes[s] > 1e-9 * sum;
        }
        if (!valid)
        {
            bad.append(celli);
        }
        corners.append(ofCell);
        start_[celli + 1] = nodes.size();
        subStart_[celli + 1] = volumes.size();
    }

    refuse(mesh, bad);
    node_.transfer(nodes);
    x.append(0); // four numbers may be fetched from each
    x_.transfer(x);
    corner_.transfer(corners);
    inverse_.transfer(inverses);
    volume_.transfer(volumes);
    face_.transfer(faces);
    if (kind != products)
    {
        setMaps();
    }
    if (kind == boxes && nDim_ == 3)
    {
        sides_.setSize(mesh.nFaces());
        forAll(box_, celli)
        {
            if (box_[celli])
            {
                sides_.set(mesh.cells()[celli]);
            }
        }
        syncTools::syncFaceList(mesh, sides_, orEqOp<unsigned int>());
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::cellSimplices::maxVertices() const
{
    label most = 0;
    for (label celli = 0; celli < start_.size() - 1; ++celli)
    {
        most = max(most, nVertices(celli));
    }
    return most;
}

Foam::label Foam::mpm::cellSimplices::simplexOf(const label celli, const scalar* x) const
{
    scalar y[3];
    for (int d = 0; d < nDim_; ++d)
    {
        y[d] = x[d] - origin(celli)[d];
    }
    label best = 0, end = nSimplices(celli);
    if (box_[celli])
    {
        // Those of one side
        scalar furthest = -1;
        for (int d = 0; d < nDim_; ++d)
        {
            const scalar up = y[d] / (origin(celli)[d] - position(celli, 0)[d]);
            if (mag(up) > furthest)
            {
                furthest = mag(up);
                best = (nDim_ - 1) * (2 * d + (up > 0));
            }
        }
        end = best + nDim_ - 1;
    }
    const scalar* I = inverses(celli) + nDim_ * nDim_ * best;
    scalar most = -GREAT;
    for (label s = best; s < end; ++s)
    {
        scalar least = GREAT;
        for (int k = 0; k < nDim_; ++k)
        {
            scalar lambda = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                lambda += *I++ * y[d];
            }
            least = min(least, lambda);
        }
        if (least > most)
        {
            most = least;
            best = s;
        }
    }
    return best;
}
