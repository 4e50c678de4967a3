// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "baseHexes.H"
#include "cellModel.H"
#include "coupledPolyPatch.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Nothing is halved between two of these
bool isFlat(const polyMesh& mesh, const label face)
{
    if (mesh.isInternalFace(face))
    {
        return false;
    }
    const polyPatch& pp = mesh.boundaryMesh()[mesh.boundaryMesh().whichPatch(face)];
    return isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp);
}

//- The same corners from where their labels come in the least order, right-handed: the axes of
//  a cell do not depend on the numbers of faces, which differ from processor to processor
FixedList<label, 8> leastOrder(const labelUList& corners)
{
    static const FixedList<FixedList<label, 3>, 6> orders{{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                                          {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    FixedList<label, 8> least(corners);
    for (label turn = 0; turn < 48; ++turn)
    {
        const label flips = turn & 7, n = (flips & 1) + ((flips >> 1) & 1) + (flips >> 2);
        const FixedList<label, 3>& axes = orders[turn >> 3];
        if ((n + (turn >> 3) / 3) % 2)
        {
            continue;
        }
        FixedList<label, 8> turned;
        for (label i = 0; i < 8; ++i)
        {
            label from = 0;
            for (label a = 0; a < 3; ++a)
            {
                from |= (((i ^ flips) >> a) & 1) << axes[a];
            }
            turned[i] = corners[from];
        }
        if (turned < least)
        {
            least = turned;
        }
    }
    return least;
}

//- Corners of OpenFOAM's hexahedron or of a prism at the axis of a wedge in
//  tensor order; empty: another cell
labelList tensorCorners(const polyMesh& mesh, const label celli)
{
    const cellShape& shape = mesh.cellShapes()[celli];
    if (shape.model() == cellModel::ref(cellModel::HEX))
    {
        return UIndirectList<label>(shape, labelList({0, 1, 3, 2, 4, 5, 7, 6}))();
    }
    if (shape.model() != cellModel::ref(cellModel::PRISM))
    {
        return labelList();
    }
    for (label a = 0; a < 3; ++a)
    {
        const label b = (a + 1) % 3, c = (a + 2) % 3;
        label nFlat = 0;
        for (const label f : mesh.cells()[celli])
        {
            const face& points = mesh.faces()[f];
            nFlat += points.size() == 4 && points.found(shape[a]) && isFlat(mesh, f);
        }
        if (nFlat == 2)
        {
            const label A = shape[a], D = shape[a + 3];
            return {A, shape[b], A, shape[c], D, shape[b + 3], D, shape[c + 3]};
        }
    }
    return labelList();
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::baseHexes::hex Foam::mpm::baseHexes::make(const label celli) const
{
    const labelList corners(tensorCorners(mesh_, celli));
    if (corners.empty())
    {
        FatalErrorInFunction
            << "An adaptive mesh halves hexahedra (at the axis of a wedge prisms): cell " << celli
            << " at " << mesh_.cellCentres()[celli] << " is a "
            << mesh_.cellShapes()[celli].model().name() << "." << nl
            << "Make a mesh of hexahedra, or remove system/adaptiveMeshDict." << exit(FatalError);
    }
    hex h;
    h.corners = leastOrder(corners);
    for (label side = 0; side < 6; ++side)
    {
        const label a = side / 2, e = side % 2;
        DynamicList<label> points(4);
        for (label i = 0; i < 8; ++i)
        {
            if (((i >> a) & 1) == e && !points.found(h.corners[i]))
            {
                points.append(h.corners[i]);
            }
        }
        h.sides[side] = -1;
        for (const label f : mesh_.cells()[celli])
        {
            const face& of = mesh_.faces()[f];
            const bool all = std::all_of(
                points.begin(), points.end(), [&](const label p) { return of.found(p); });
            if (all && of.size() == points.size())
            {
                h.sides[side] = f;
            }
        }
    }
    for (label a = 0; a < 3; ++a)
    {
        const auto flat = [&](const label f) { return f >= 0 && isFlat(mesh_, f); };
        h.halved[a] = !(flat(h.sides[2 * a]) && flat(h.sides[2 * a + 1]));
        for (label pq = 0; pq < 4; ++pq)
        {
            const label from = ((pq & 1) << ((a + 1) % 3)) | ((pq >> 1) << ((a + 2) % 3));
            const label A = h.corners[from], B = h.corners[from | (1 << a)];
            label& at = h.edges[4 * a + pq];
            at = -1;
            if (h.halved[a] && A != B)
            {
                for (const label e : mesh_.pointEdges()[A])
                {
                    at = mesh_.edges()[e].otherVertex(A) == B ? e : at;
                }
            }
        }
    }
    return h;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::baseHexes::baseHexes(const polyMesh& mesh) : mesh_(mesh), cells_(mesh.nCells())
{
    forAll(cells_, celli)
    {
        cells_[celli] = make(celli);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::baseHexes::turned(const label face) const
{
    if (mesh_.isInternalFace(face))
    {
        return false;
    }
    const polyPatch& pp = mesh_.boundaryMesh()[mesh_.boundaryMesh().whichPatch(face)];
    return pp.coupled() && !refCast<const coupledPolyPatch>(pp).owner();
}

Foam::mpm::baseHexes::frame
Foam::mpm::baseHexes::frameOf(const label celli, const label facei, const bool turned) const
{
    const hex& h = cells_[celli];
    const face& f = mesh_.faces()[facei];
    frame r;
    r.side = h.sideOf(facei);
    const label a = r.side / 2, b = (a + 1) % 3, c = (a + 2) % 3;

    // Corner of a point of the face: of two in one the first
    const auto at = [&](const label point)
    {
        for (label i = 0; i < 8; ++i)
        {
            if (((i >> a) & 1) == r.side % 2 && h.corners[i] == point)
            {
                return i;
            }
        }
        return label(-1);
    };
    const label origin = at(f[0]);
    bool uIsB = h.halved[b];
    if (h.halved[b] && h.halved[c])
    {
        uIsB = ((origin ^ at(turned ? f.last() : f[1])) >> b) & 1;
    }
    r.axisU = uIsB ? b : c;
    r.axisV = uIsB ? c : b;
    r.flipU = (origin >> r.axisU) & 1;
    r.flipV = (origin >> r.axisV) & 1;
    return r;
}
