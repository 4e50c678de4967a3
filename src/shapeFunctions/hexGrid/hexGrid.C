/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexGrid.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "cyclicPolyPatch.H"
#include "hexMatcher.H"
#include "EdgeMap.H"
#include "SubField.H"
#include "PackedBoolList.H"

#include <Eigen/LU>
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(hexGrid, 0);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sets of joined labels; the smallest label stands for the set
class joinedLabels
{
    labelList parent_;

public:

    explicit joinedLabels(const label n)
    :
        parent_(identity(n))
    {}

    label root(label i)
    {
        while (parent_[i] != i)
        {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    void join(const label i, const label j)
    {
        const label a = root(i), b = root(j);
        parent_[max(a, b)] = min(a, b);
    }
};


//- True for faces on empty patches
PackedBoolList emptyFaces(const polyMesh& mesh)
{
    PackedBoolList isEmpty(mesh.nFaces());
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            forAll(pp, i)
            {
                isEmpty.set(pp.start() + i);
            }
        }
    }
    return isEmpty;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::hexGrid::makeNodes()
{
    const polyMesh& mesh = this->mesh();
    const PackedBoolList isEmpty(emptyFaces(mesh));

    joinedLabels joined(mesh.nPoints());

    if (nDim_ == 1)
    {
        // A cross-section is a face that is not empty
        forAll(mesh.faces(), facei)
        {
            if (!isEmpty.test(facei))
            {
                const face& f = mesh.faces()[facei];
                for (label i = 1; i < f.size(); ++i)
                {
                    joined.join(f[0], f[i]);
                }
            }
        }
    }
    else if (nDim_ == 2)
    {
        // Front and back are joined by the edges that lie in no empty face
        EdgeMap<bool> inEmpty(4*mesh.nCells());
        forAll(mesh.faces(), facei)
        {
            if (isEmpty.test(facei))
            {
                const face& f = mesh.faces()[facei];
                forAll(f, i)
                {
                    inEmpty.insert(f.faceEdge(i), true);
                }
            }
        }
        forAll(mesh.faces(), facei)
        {
            if (!isEmpty.test(facei))
            {
                const face& f = mesh.faces()[facei];
                forAll(f, i)
                {
                    const edge e(f.faceEdge(i));
                    if (!inEmpty.found(e))
                    {
                        joined.join(e.first(), e.second());
                    }
                }
            }
        }
    }

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(pp))
        {
            const cyclicPolyPatch& cpp = refCast<const cyclicPolyPatch>(pp);
            if (!cpp.owner())
            {
                continue;
            }
            if (!cpp.parallel())
            {
                FatalErrorInFunction
                    << "Cyclic patch " << pp.name() << " is rotational;"
                    << " material points need a translational one."
                    << exit(FatalError);
            }
            const labelList& own = cpp.meshPoints();
            const labelList& nbr = cpp.neighbPatch().meshPoints();
            for (const edge& e : cpp.coupledPoints())
            {
                joined.join(own[e[0]], nbr[e[1]]);
            }
        }
    }

    // Compact numbering in the order of the first point
    pointToNode_.setSize(mesh.nPoints());
    DynamicList<label> first(mesh.nPoints());
    forAll(pointToNode_, pointi)
    {
        const label root = joined.root(pointi);
        if (root == pointi)
        {
            pointToNode_[pointi] = first.size();
            first.append(pointi);
        }
        else
        {
            pointToNode_[pointi] = pointToNode_[root];
        }
    }
    nodePoint_.transfer(first);
}


void Foam::mpm::hexGrid::makeCells()
{
    const polyMesh& mesh = this->mesh();
    const PackedBoolList isEmpty(emptyFaces(mesh));
    hexMatcher hex;
    const label nc = label(1) << nDim_;

    cellNodes_.setSize(nc*mesh.nCells());
    cellPoints_.setSize(nc*mesh.nCells());
    cellCells_.setSize(2*nDim_*mesh.nCells(), -1);
    walls_.setSize(mesh.nCells(), 0);

    // Cells behind cyclic faces
    labelList coupled(mesh.nFaces() - mesh.nInternalFaces(), -1);
    vectorField separation(coupled.size(), Zero);
    bool cyclic = false;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(pp))
        {
            const labelUList& nbr =
                refCast<const cyclicPolyPatch>(pp).neighbPatch().faceCells();
            forAll(pp, i)
            {
                const label facei = pp.start() + i - mesh.nInternalFaces();
                coupled[facei] = nbr[i];
                separation[facei] =
                    refCast<const cyclicPolyPatch>(pp).neighbPatch()
                   .faceCentres()[i]
                  - pp.faceCentres()[i];
                cyclic = true;
            }
        }
    }

    if (cyclic)
    {
        shift_.setSize(2*nDim_*mesh.nCells(), vector(Zero));
    }

    const faceList& faces = mesh.faces();

    forAll(mesh.cells(), celli)
    {
        if (!hex.isA(mesh, celli))
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << mesh.cellCentres()[celli]
                << " is no hexahedron. Material points need a mesh of"
                << " hexahedra (shape functions: linear; on meshes of boxes"
                << " also GIMP)." << exit(FatalError);
        }

        // The six faces as three pairs without a common point
        const cell& cFaces = mesh.cells()[celli];
        label pair[3][2];
        int nPairs = 0;
        FixedList<bool, 6> used(false);
        for (int i = 0; i < 6; ++i)
        {
            if (used[i])
            {
                continue;
            }
            for (int j = i + 1; j < 6; ++j)
            {
                bool touches = false;
                for (const label p : faces[cFaces[i]])
                {
                    touches = touches || faces[cFaces[j]].found(p);
                }
                if (!used[j] && !touches)
                {
                    pair[nPairs][0] = cFaces[i];
                    pair[nPairs][1] = cFaces[j];
                    ++nPairs;
                    used[i] = used[j] = true;
                    break;
                }
            }
        }

        // Each computed direction takes the pair that lies most along it
        label side[3][2];
        FixedList<bool, 3> taken(false);
        for (int d = 0; d < nDim_; ++d)
        {
            int best = -1;
            scalar along = -1;
            for (int k = 0; k < nPairs; ++k)
            {
                if (taken[k] || isEmpty.test(pair[k][0]))
                {
                    continue;
                }
                const vector v
                (
                    mesh.faceCentres()[pair[k][1]]
                  - mesh.faceCentres()[pair[k][0]]
                );
                const scalar a = mag(v[dir_[d]])/max(mag(v), VSMALL);
                if (a > along)
                {
                    along = a;
                    best = k;
                }
            }
            if (best < 0)
            {
                FatalErrorInFunction
                    << "Cell " << celli << " at "
                    << mesh.cellCentres()[celli] << " has no pair of sides"
                    << " for direction " << d << "; check the empty patches."
                    << exit(FatalError);
            }
            taken[best] = true;
            const scalar up =
                mesh.faceCentres()[pair[best][1]][dir_[d]]
              - mesh.faceCentres()[pair[best][0]][dir_[d]];
            side[d][0] = pair[best][up > 0 ? 0 : 1];
            side[d][1] = pair[best][up > 0 ? 1 : 0];
        }

        // A corner is the node of the points that its sides share
        for (label n = 0; n < nc; ++n)
        {
            label corner = -1, own = -1;
            for (const label p : faces[side[0][n & 1]])
            {
                bool inAll = true;
                for (int d = 1; d < nDim_; ++d)
                {
                    inAll = inAll && faces[side[d][(n >> d) & 1]].found(p);
                }
                if (inAll)
                {
                    corner = pointToNode_[p];
                    own = p;
                }
            }
            cellNodes_[nc*celli + n] = corner;
            cellPoints_[nc*celli + n] = own;
        }

        for (int d = 0; d < nDim_; ++d)
        {
            for (int s = 0; s < 2; ++s)
            {
                const label facei = side[d][s];
                label nbr = -1;
                if (mesh.isInternalFace(facei))
                {
                    nbr =
                        mesh.faceOwner()[facei] == celli
                      ? mesh.faceNeighbour()[facei]
                      : mesh.faceOwner()[facei];
                }
                else
                {
                    nbr = coupled[facei - mesh.nInternalFaces()];
                    if (nbr >= 0)
                    {
                        shift_[2*(nDim_*celli + d) + s] =
                            separation[facei - mesh.nInternalFaces()];
                    }
                }
                cellCells_[2*(nDim_*celli + d) + s] = nbr;
                if (nbr < 0)
                {
                    walls_[celli] |= 1u << (2*d + s);
                }
            }
        }
    }
}


void Foam::mpm::hexGrid::makeLattice()
{
    const polyMesh& mesh = this->mesh();
    const pointField& points = mesh.points();
    const label nc = label(1) << nDim_;

    // Shortest side and misalignment of the cells. Corners of a cell are
    // taken from its own points: on a cyclic side a node has two positions
    cellIjk_.setSize(nDim_*mesh.nCells());

    scalarField lower(nDim_*mesh.nCells()), upper(nDim_*mesh.nCells());
    scalar shortest[3] = {GREAT, GREAT, GREAT};

    forAll(mesh.cells(), celli)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            scalar lo = GREAT, hi = -GREAT;
            for (const label p : mesh.cellPoints()[celli])
            {
                lo = min(lo, points[p][dir_[d]]);
                hi = max(hi, points[p][dir_[d]]);
            }
            lower[nDim_*celli + d] = lo;
            upper[nDim_*celli + d] = hi;
            shortest[d] = min(shortest[d], hi - lo);
        }
    }

    // Each point must lie on the lower or upper plane of each cell
    forAll(mesh.cells(), celli)
    {
        for (const label p : mesh.cellPoints()[celli])
        {
            for (int d = 0; d < nDim_; ++d)
            {
                const scalar x = points[p][dir_[d]];
                const scalar tol = 1e-4*shortest[d];
                if
                (
                    mag(x - lower[nDim_*celli + d]) > tol
                 && mag(x - upper[nDim_*celli + d]) > tol
                )
                {
                    OStringStream s;
                    s   << "cell " << celli << " at "
                        << mesh.cellCentres()[celli]
                        << " is no box along the axes";
                    noLattice_ = s.str();
                    return;
                }
            }
        }
    }

    // Planes: clusters of coordinates. The smallest value stands for the
    // plane, so that both cells at a plane compare with the same number
    for (int d = 0; d < nDim_; ++d)
    {
        scalarList x(2*mesh.nCells());
        forAll(mesh.cells(), celli)
        {
            x[2*celli] = lower[nDim_*celli + d];
            x[2*celli + 1] = upper[nDim_*celli + d];
        }
        std::sort(x.begin(), x.end());

        DynamicList<scalar> planes;
        for (const scalar xi : x)
        {
            if (planes.empty() || xi > planes.last() + 1e-3*shortest[d])
            {
                planes.append(xi);
            }
        }

        nCells_[d] = planes.size() - 1;
        planes_[d].setSize(planes.size() + 2);
        forAll(planes, i)
        {
            planes_[d][i + 1] = planes[i];
        }

        const auto indexOf = [&](const scalar xi)
        {
            const auto iter = std::upper_bound
            (
                planes.begin(),
                planes.end(),
                xi + 1e-2*shortest[d]
            );
            return label(iter - planes.begin());
        };

        forAll(mesh.cells(), celli)
        {
            const label i = indexOf(lower[nDim_*celli + d]);
            const label j = indexOf(upper[nDim_*celli + d]);
            if (j != i + 1)
            {
                OStringStream s;
                s   << "cell " << celli << " at "
                    << mesh.cellCentres()[celli]
                    << " spans planes of other cells";
                noLattice_ = s.str();
                return;
            }
            cellIjk_[nDim_*celli + d] = i;
        }
    }

    // Cells on the lattice with one ghost ring
    label nLattice = 1, nLatticeNodes = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        if (scalar(nLatticeNodes)*(nCells_[d] + 3) > 50.0*mesh.nCells() + 1e6)
        {
            noLattice_ = "the cells fill too little of their common lattice";
            return;
        }
        nLattice *= nCells_[d] + 2;
        nLatticeNodes *= nCells_[d] + 3;
    }
    latticeCell_.setSize(nLattice, -1);
    latticeNode_.setSize(nLatticeNodes, -1);

    const auto index = [&](const label* ijk, const label extra)
    {
        label n = ijk[0], stride = 1;
        for (int d = 1; d < nDim_; ++d)
        {
            stride *= nCells_[d - 1] + extra;
            n += stride*ijk[d];
        }
        return n;
    };

    forAll(mesh.cells(), celli)
    {
        const label* ijk = cellIjk_.cdata() + nDim_*celli;
        label& at = latticeCell_[index(ijk, 2)];
        if (at >= 0)
        {
            noLattice_ = "cells overlap";
            return;
        }
        at = celli;

        for (label n = 0; n < nc; ++n)
        {
            label corner[3] = {0, 0, 0};
            for (int d = 0; d < nDim_; ++d)
            {
                corner[d] = ijk[d] + ((n >> d) & 1);
            }
            latticeNode_[index(corner, 3)] = cellNodes_[nc*celli + n];
        }
    }

    // Cyclic directions: the lowest and highest plane are one
    for (int d = 0; d < nDim_; ++d)
    {
        period_[d] = 0;
        label nCyclic = 0, nSide = 0;
        forAll(mesh.cells(), celli)
        {
            if (ijk(celli, d) == 1)
            {
                ++nSide;
                if (neighbour(celli, d, 0) >= 0)
                {
                    ++nCyclic;
                }
            }
        }
        if (nCyclic)
        {
            if (nCyclic != nSide)
            {
                noLattice_ = "a cyclic patch covers only a part of its side";
                return;
            }
            period_[d] = planes_[d][nCells_[d] + 1] - planes_[d][1];
        }
    }

    // Ghost planes and ghost ring
    for (int d = 0; d < nDim_; ++d)
    {
        scalarList& x = planes_[d];
        const label n = nCells_[d];
        if (period_[d] > 0)
        {
            x[0] = x[n] - period_[d];
            x[n + 2] = x[2] + period_[d];
        }
        else
        {
            x[0] = 2*x[1] - x[2];
            x[n + 2] = 2*x[n + 1] - x[n];
        }
        invWidth_[d].setSize(n + 2);
        for (label i = 0; i < n + 2; ++i)
        {
            invWidth_[d][i] = 1/(x[i + 1] - x[i]);
        }
    }

    for (int d = 0; d < nDim_; ++d)
    {
        if (period_[d] <= 0)
        {
            continue;
        }
        // All entries of the ring of direction d from the other end
        const label n = nCells_[d];
        forAll(latticeCell_, i)
        {
            label rest = i, stride = 1, at = 0;
            for (int e = 0; e <= d; ++e)
            {
                at = rest % (nCells_[e] + 2);
                rest /= nCells_[e] + 2;
                if (e < d) stride *= nCells_[e] + 2;
            }
            if (at == 0) latticeCell_[i] = latticeCell_[i + n*stride];
            if (at == n + 1) latticeCell_[i] = latticeCell_[i - n*stride];
        }
        forAll(latticeNode_, i)
        {
            label rest = i, stride = 1, at = 0;
            for (int e = 0; e <= d; ++e)
            {
                at = rest % (nCells_[e] + 3);
                rest /= nCells_[e] + 3;
                if (e < d) stride *= nCells_[e] + 3;
            }
            if (at == 0) latticeNode_[i] = latticeNode_[i + n*stride];
            if (at == n + 2) latticeNode_[i] = latticeNode_[i - n*stride];
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::hexGrid::hexGrid(const polyMesh& mesh)
:
    MeshObject<polyMesh, GeometricMeshObject, hexGrid>(mesh),
    nDim_(0),
    dir_{0, 0, 0},
    nCells_{0, 0, 0},
    period_{0, 0, 0}
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp))
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " is a wedge: axisymmetric"
                << " material points do not exist yet. Use empty patches"
                << " (2D) or a 3D mesh." << exit(FatalError);
        }
    }

    const Vector<label>& computed = mesh.solutionD();
    for (int d = 0; d < 3; ++d)
    {
        if (computed[d] > 0)
        {
            dir_[nDim_++] = d;
        }
    }

    makeNodes();
    makeCells();
    makeLattice();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::hexGrid::width(const label celli, const int d) const
{
    if (hasLattice())
    {
        const label i = ijk(celli, d);
        return planes_[d][i + 1] - planes_[d][i];
    }

    // Shortest of the edges along the cell's direction
    const label nc = label(1) << nDim_;
    scalar corner[24];
    cornerPositions(celli, corner);
    scalar shortest = GREAT;
    for (label n = 0; n < nc; ++n)
    {
        if (!((n >> d) & 1))
        {
            scalar s = 0;
            for (int e = 0; e < nDim_; ++e)
            {
                s += sqr
                (
                    corner[nDim_*(n | (1 << d)) + e] - corner[nDim_*n + e]
                );
            }
            shortest = min(shortest, std::sqrt(s));
        }
    }
    return shortest;
}


void Foam::mpm::hexGrid::cornerPositions(const label celli, scalar* x) const
{
    const label nc = label(1) << nDim_;
    for (label n = 0; n < nc; ++n)
    {
        const point& p = mesh().points()[cellPoints_[nc*celli + n]];
        for (int d = 0; d < nDim_; ++d)
        {
            x[nDim_*n + d] = p[dir_[d]];
        }
    }
}


void Foam::mpm::hexGrid::localCoordinates
(
    const label celli,
    const scalar* x,
    scalar* xi
) const
{
    if (hasLattice())
    {
        for (int d = 0; d < nDim_; ++d)
        {
            const label i = ijk(celli, d);
            xi[d] = (x[d] - planes_[d][i])*invWidth_[d][i];
        }
        return;
    }

    const label nc = label(1) << nDim_;
    scalar corner[24];
    cornerPositions(celli, corner);

    for (int d = 0; d < nDim_; ++d)
    {
        xi[d] = 0.5;
    }
    Eigen::Matrix3d J;
    Eigen::Vector3d r;
    for (int iter = 0; iter < 20; ++iter)
    {
        J.setIdentity();
        r.setZero();
        for (int d = 0; d < nDim_; ++d)
        {
            r(d) = x[d];
            J(d, d) = 0;
        }
        for (label n = 0; n < nc; ++n)
        {
            scalar w = 1;
            for (int d = 0; d < nDim_; ++d)
            {
                w *= (n >> d) & 1 ? xi[d] : 1 - xi[d];
            }
            for (int e = 0; e < nDim_; ++e)
            {
                r(e) -= w*corner[nDim_*n + e];
            }
            for (int d = 0; d < nDim_; ++d)
            {
                scalar dw = (n >> d) & 1 ? 1 : -1;
                for (int e = 0; e < nDim_; ++e)
                {
                    if (e != d)
                    {
                        dw *= (n >> e) & 1 ? xi[e] : 1 - xi[e];
                    }
                }
                for (int e = 0; e < nDim_; ++e)
                {
                    J(e, d) += dw*corner[nDim_*n + e];
                }
            }
        }
        const Eigen::Vector3d dxi(J.partialPivLu().solve(r));
        scalar largest = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            // Far outside the map need not be one to one: stay near
            xi[d] = min(max(xi[d] + dxi(d), scalar(-2)), scalar(3));
            largest = max(largest, mag(dxi(d)));
        }
        if (largest < 1e-14)
        {
            break;
        }
    }
}


Foam::label Foam::mpm::hexGrid::locate(const label from, scalar* x) const
{
    if (hasLattice())
    {
        label at[3] = {0, 0, 0};
        for (int d = 0; d < nDim_; ++d)
        {
            const scalarList& X = planes_[d];
            const label n = nCells_[d];

            if (period_[d] > 0)
            {
                // Once is enough for a point that moves less than the domain
                if (x[d] < X[1])
                {
                    x[d] += period_[d];
                    // Rounding may land on the closed end: that is the start
                    if (x[d] >= X[n + 1]) x[d] = X[1];
                }
                else if (x[d] >= X[n + 1])
                {
                    x[d] = max(x[d] - period_[d], X[1]);
                }
            }
            if (!(x[d] >= X[1] && x[d] <= X[n + 1]))
            {
                return -1;
            }
            label i =
                from >= 0
              ? ijk(from, d)
              : label
                (
                    std::upper_bound(X.begin() + 1, X.begin() + n + 2, x[d])
                  - X.begin()
                ) - 1;
            i = min(max(i, label(1)), n);
            while (i > 1 && x[d] < X[i]) --i;
            while (i < n && x[d] >= X[i + 1]) ++i;
            at[d] = i;
        }

        const label celli = cellAt(at);
        if (celli >= 0)
        {
            return celli;
        }

        // On the upper plane of the mesh inside the lattice (a hole above):
        // that plane is outermost and closed
        for (int n = 1; n < (1 << nDim_); ++n)
        {
            label lower[3] = {at[0], at[1], at[2]};
            bool possible = true;
            for (int d = 0; d < nDim_; ++d)
            {
                if ((n >> d) & 1)
                {
                    possible = possible && x[d] == planes_[d][at[d]];
                    --lower[d];
                }
            }
            if (possible && cellAt(lower) >= 0)
            {
                return cellAt(lower);
            }
        }
        return -1;
    }

    // General hexahedra: through the side that is violated most
    label celli = from;
    for (int step = 0; step < 50 && celli >= 0; ++step)
    {
        scalar xi[3];
        localCoordinates(celli, x, xi);

        label next = -1, through = -1;
        scalar worst = 0;
        bool outside = false;
        for (int d = 0; d < nDim_; ++d)
        {
            for (int s = 0; s < 2; ++s)
            {
                const scalar beyond = s ? xi[d] - 1 : -xi[d];
                const label nbr = neighbour(celli, d, s);
                // A little beyond a boundary side is rounding of the inverse
                const bool out = nbr < 0 ? beyond > 1e-10 : beyond > 0;
                if (out && beyond > worst)
                {
                    worst = beyond;
                    next = nbr;
                    through = 2*(nDim_*celli + d) + s;
                    outside = true;
                }
            }
        }
        if (!outside)
        {
            return celli;
        }
        if (next >= 0 && worst < 1e-12)
        {
            // On the common side to rounding: the higher cell owns it
            return max(celli, next);
        }
        if (next >= 0 && shift_.size())
        {
            for (int d = 0; d < nDim_; ++d)
            {
                x[d] += shift_[through][dir_[d]];
            }
        }
        celli = next;
    }
    return -1;
}


Foam::label Foam::mpm::hexGrid::find(scalar* x) const
{
    if (hasLattice())
    {
        return locate(-1, x);
    }

    point p(Zero);
    // The missing coordinates: those of any mesh point's cell centre
    p = mesh().cellCentres()[0];
    for (int d = 0; d < nDim_; ++d)
    {
        p[dir_[d]] = x[d];
    }
    const label near = mesh().findNearestCell(p);
    return near < 0 ? -1 : locate(near, x);
}

// ************************************************************************* //
