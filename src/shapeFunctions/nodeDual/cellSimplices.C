/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

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
            J[3*i + k] = E[nDim*k + i];
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
                I[nDim*k + i] = inverse[3*k + i];
            }
        }
    }
    return d/(nDim == 3 ? 6 : nDim);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::cellSimplices::addVertices
(
    const pointGrid& grid,
    const bitSet& isEmpty,
    const label celli,
    DynamicList<label>& points
)
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
    {
        return mesh.points()[points[i]][grid.direction(d)];
    };
    const label n = points.size();
    scalar area = grid.nDim() == 1 ? x(n - 1, 0) - x(0, 0) : 0;
    for (label i = 0; grid.nDim() == 2 && i < n; ++i)
    {
        const label j = (i + 1) % n;
        area += x(i, 0)*x(j, 1) - x(j, 0)*x(i, 1);
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
            O[celli] += x[pointi]/points.size();
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
            inside ? O[mesh.faceNeighbour()[facei]]
          : behind[facei - mesh.nInternalFaces()];
        const scalar length = sqrt(mag(mesh.faceAreas()[facei]));
        const auto least = [&](const label at)
        {
            const point& b = x[f[at]];
            scalar v = GREAT;
            for (label k = 1; k < f.size() - 1; ++k)
            {
                const vector n
                (
                    (x[f[(at + k) % f.size()]] - b)
                  ^ (x[f[(at + k + 1) % f.size()]] - b)
                );
                v = min(v, n & (b - own));
                if (inside || hasBehind.test(facei))
                {
                    v = min(v, n & (other - b));
                }
            }
            return v/pow3(length) + ((b - x[f[0]]) & oblique)/length;
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


void Foam::mpm::cellSimplices::addCorners
(
    const pointGrid& grid,
    const bitSet& isEmpty,
    const labelUList& basePoints,
    const label celli,
    const labelUList& vertices,
    DynamicList<label>& corners,
    DynamicList<label>& faces
)
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


void Foam::mpm::cellSimplices::sides
(
    const label celli,
    const label i,
    scalar* h
) const
{
    for (int d = 0; d < nDim_; ++d)
    {
        h[d] = 2*(origin(celli)[d] - position(celli, i)[d]);
    }
}


Foam::mpm::cellSimplices::regions
Foam::mpm::cellSimplices::regionsOf(const label celli) const
{
    const label n = nVertices(celli);
    const auto vertex = [&](const label i)
    {
        const scalar* x = position(celli, i % n);
        return vector2D(x[0], x[1]);
    };
    vector2D mean(Zero);
    for (label i = 0; i < n; ++i)
    {
        mean += vertex(i)/n;
    }

    // Gradients of the two vertices of a side in its triangle with the mean;
    // of S_i there they have their share and 1/n of the mean's
    struct side
    {
        vector2D a, b;
    };
    List<side> sides(n);
    const auto first = [&](const label i, const label k)
    {
        return scalar(i == k) - 1.0/n;
    };
    const auto second = [&](const label i, const label k)
    {
        return scalar(i == (k + 1) % n) - 1.0/n;
    };

    regions r;
    r.size.setSize(n);
    r.S.setSize(n*n);
    r.dS.setSize(n*n, vector2D(Zero));
    scalarList A(n, Zero);
    List<vector2D> moment(n, vector2D(Zero));
    for (label k = 0; k < n; ++k)
    {
        const vector2D a(vertex(k) - mean), b(vertex(k + 1) - mean);
        const scalar twice = a.x()*b.y() - a.y()*b.x();
        sides[k].a = vector2D(b.y(), -b.x())/twice;
        sides[k].b = vector2D(-a.y(), a.x())/twice;
        for (const bool end : {false, true})
        {
            const label at = (k + end) % n;
            const vector2D centre(((end ? b : a) + 0.5*(a + b))/3);
            A[at] += 0.25*twice;
            moment[at] += 0.25*twice*(mean + centre);
            for (label i = 0; i < n; ++i)
            {
                r.dS[n*at + i] += 0.25*twice
                   *(first(i, k)*sides[k].a + second(i, k)*sides[k].b);
            }
        }
    }
    for (label k = 0; k < n; ++k)
    {
        // The centroid is in one of the two triangles at the vertex
        const vector2D x(moment[k]/A[k]);
        const label before = (k + n - 1) % n;
        const auto least = [&](const label s)
        {
            return min(sides[s].a & (x - mean), sides[s].b & (x - mean));
        };
        const label s = least(k) >= least(before) ? k : before;
        r.size[k] = A[k]*x[radial_];
        for (label i = 0; i < n; ++i)
        {
            r.S[n*k + i] =
                1.0/n
              + first(i, s)*(sides[s].a & (x - mean))
              + second(i, s)*(sides[s].b & (x - mean));
            r.dS[n*k + i] /= A[k];
        }
    }
    return r;
}


void Foam::mpm::cellSimplices::refuse
(
    const polyMesh& mesh,
    const labelUList& bad
)
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
        own << " at " << mesh.cellCentres()[bad[i]] << ", volume "
            << mesh.cellVolumes()[bad[i]];
    }
    List<string> places(Pstream::nProcs());
    places[Pstream::myProcNo()] = own.str();
    Pstream::gatherList(places);
    Pstream::scatterList(places);
    OStringStream s;
    s   << n << (n == 1 ? " cell is" : " cells are") << " flat, folded over or"
        << " far from convex: faces are not seen from the mean of the cell's"
        << " points";
    for (const string& of : places)
    {
        if (!of.empty())
        {
            s   << "; " << of.c_str();
        }
    }
    throw string(s.str());
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::cellSimplices::cellSimplices
(
    const pointGrid& grid,
    const bool products
)
:
    nDim_(grid.nDim()),
    radial_(grid.radial()),
    products_(products),
    start_(grid.nCells() + 1, Zero),
    origin_(grid.nDim()*grid.nCells(), Zero),
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
    const labelList basePoints
    (
        nDim_ < 3 || triangles || products
      ? labelList()
      : findBasePoints(grid)
    );

    DynamicList<label> nodes, corners, points, ofCell, faces;
    DynamicList<scalar> x, inverses, volumes;
    DynamicList<label> bad;
    for (label celli = 0; celli < grid.nCells(); ++celli)
    {
        addVertices(grid, isEmpty, celli, points);
        const label n = points.size();
        for (const label pointi : points)
        {
            nodes.append(grid.pointToNode()[pointi]);
            for (int d = 0; d < nDim_; ++d)
            {
                x.append(mesh.points()[pointi][grid.direction(d)]);
            }
        }
        const scalar* at = x.begin() + nDim_*start_[celli];
        scalar* O = origin_.begin() + nDim_*celli;
        const bool simplex = !products && n == nDim_ + 1;
        for (label i = 0; i < (simplex ? 1 : n); ++i)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                O[d] += at[nDim_*i + d]/(simplex ? 1 : n);
            }
        }

        ofCell.clear();
        if (!products)
        {
            addCorners
            (
                grid, isEmpty, basePoints, celli, points, ofCell, faces
            );
        }
        bool valid = n > nDim_ && mesh.cellVolumes()[celli] > 0;
        scalar sum = 0;
        const label firstSub = volumes.size();
        for (label k = 0; valid && k < ofCell.size(); k += nDim_)
        {
            scalar E[9], I[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
            for (int j = 0; j < nDim_; ++j)
            {
                for (int d = 0; d < nDim_; ++d)
                {
                    E[nDim_*j + d] = at[nDim_*ofCell[k + j] + d] - O[d];
                }
            }
            volumes.append(invertEdges(nDim_, E, I));
            sum += mag(volumes.last());
            for (int j = 0; j < nDim_*nDim_; ++j)
            {
                inverses.append(I[j]);
            }
        }
        for (label s = firstSub; s < volumes.size(); ++s)
        {
            valid = valid && volumes[s] > 1e-9*sum;
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
    x_.transfer(x);
    corner_.transfer(corners);
    inverse_.transfer(inverses);
    volume_.transfer(volumes);
    face_.transfer(faces);
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


Foam::label Foam::mpm::cellSimplices::simplexOf
(
    const label celli,
    const scalar* x
) const
{
    scalar y[3];
    for (int d = 0; d < nDim_; ++d)
    {
        y[d] = x[d] - origin(celli)[d];
    }
    const scalar* I = inverses(celli);
    label best = 0;
    scalar most = -GREAT;
    for (label s = 0; s < nSimplices(celli); ++s)
    {
        scalar least = GREAT;
        for (int k = 0; k < nDim_; ++k)
        {
            scalar lambda = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                lambda += *I++*y[d];
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


Foam::scalar Foam::mpm::cellSimplices::integral
(
    const label celli,
    const label i
) const
{
    if (products_)
    {
        scalar h[3], volume = 1;
        sides(celli, i, h);
        for (int d = 0; d < nDim_; ++d)
        {
            volume *= mag(h[d])/2;
        }
        return volume;
    }
    if (radial_ >= 0)
    {
        const regions r(regionsOf(celli));
        scalar sum = 0;
        forAll(r.size, k)
        {
            sum += r.size[k]*r.S[r.size.size()*k + i];
        }
        return sum;
    }
    const scalar b = originShare(celli, i);
    const label* corner = corners(celli);
    scalar sum = 0;
    for (label s = 0; s < nSimplices(celli); ++s, corner += nDim_)
    {
        scalar share = b;
        for (int k = 0; k < nDim_; ++k)
        {
            share += corner[k] == i;
        }
        sum += share*volumes(celli)[s]/(nDim_ + 1);
    }
    return sum;
}


void Foam::mpm::cellSimplices::integrals
(
    const label celli,
    const label i,
    scalar* SdS
) const
{
    const label n = nVertices(celli);
    if (products_)
    {
        // int S_i S_j = h/3 or h/6, int S_i dS_j/dx = 1/2 towards j
        scalar hi[3], hj[3];
        sides(celli, i, hi);
        for (label j = 0; j < n; ++j)
        {
            sides(celli, j, hj);
            for (int d = 0; d < nDim_; ++d)
            {
                scalar& sum = SdS[nDim_*j + d];
                sum = hj[d] > 0 ? -0.5 : 0.5;
                for (int e = 0; e < nDim_; ++e)
                {
                    if (e != d)
                    {
                        sum *= mag(hi[e])/(hi[e]*hj[e] > 0 ? 3 : 6);
                    }
                }
            }
        }
        return;
    }
    if (radial_ >= 0)
    {
        const regions r(regionsOf(celli));
        std::fill_n(SdS, n*nDim_, 0.0);
        for (label k = 0; k < n; ++k)
        {
            for (label j = 0; j < n; ++j)
            {
                for (int d = 0; d < nDim_; ++d)
                {
                    SdS[nDim_*j + d] +=
                        r.size[k]*r.S[n*k + i]*r.dS[n*k + j][d];
                }
            }
        }
        return;
    }
    const scalar b = originShare(celli, i);
    const label* corner = corners(celli);
    const scalar* I = inverses(celli);
    scalar ofOrigin[3] = {0, 0, 0};
    std::fill_n(SdS, n*nDim_, 0.0);
    for (label s = 0; s < nSimplices(celli); ++s)
    {
        scalar share = b;
        for (int k = 0; k < nDim_; ++k)
        {
            share += corner[k] == i;
        }
        share *= volumes(celli)[s]/(nDim_ + 1);
        for (int k = 0; k < nDim_; ++k)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                SdS[nDim_*corner[k] + d] += share*I[nDim_*k + d];
                ofOrigin[d] -= share*I[nDim_*k + d];
            }
        }
        corner += nDim_;
        I += nDim_*nDim_;
    }
    for (label j = 0; j < n; ++j)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            SdS[nDim_*j + d] += originShare(celli, j)*ofOrigin[d];
        }
    }
}

// ************************************************************************* //
