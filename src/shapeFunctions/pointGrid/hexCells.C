// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "hexCells.H"
#include "hexMatcher.H"
#include "prismMatcher.H"
#include "meshCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A hexahedron that the axis of a wedge has made a prism: its triangles are
//  no sides of the wedge, as those of a ring of triangular section are
bool isAtAxis(
    const polyMesh& mesh, const int radial, const bitSet& isEmpty, prismMatcher& prism,
    const label celli)
{
    if (radial < 0 || !prism.isA(mesh, celli))
    {
        return false;
    }
    for (const label f : mesh.cells()[celli])
    {
        if (isEmpty.test(f) && mesh.faces()[f].size() == 3)
        {
            return false;
        }
    }
    return true;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::hexCells::pairFaces(
    const label celli, const bitSet& isEmpty, const bool atAxis, cellSides& s) const
{
    const polyMesh& mesh = mesh_;
    const faceList& faces = mesh.faces();
    s.nPairs = 0;

    // The six faces as three pairs without a common point. Of the prism at
    // an axis only the triangles are a pair
    const cell& cFaces = mesh.cells()[celli];
    FixedList<bool, 6> used(false);
    for (int i = 0; i < cFaces.size(); ++i)
    {
        if (used[i])
        {
            continue;
        }
        for (int j = i + 1; j < cFaces.size(); ++j)
        {
            bool touches = false;
            for (const label p : faces[cFaces[i]])
            {
                touches = touches || faces[cFaces[j]].found(p);
            }
            if (!used[j] && !touches)
            {
                s.pair[s.nPairs][0] = cFaces[i];
                s.pair[s.nPairs][1] = cFaces[j];
                ++s.nPairs;
                used[i] = used[j] = true;
                break;
            }
        }
    }

    // The side that faces the axis
    s.outer = -1;
    for (int i = 0; atAxis && i < cFaces.size(); ++i)
    {
        if (!used[i] && !isEmpty.test(cFaces[i]))
        {
            s.outer = cFaces[i];
        }
    }
}

Foam::mpm::hexCells::cellSides
Foam::mpm::hexCells::sidesOf(const label celli, const bitSet& isEmpty, const bool atAxis) const
{
    const polyMesh& mesh = mesh_;
    cellSides s;
    pairFaces(celli, isEmpty, atAxis, s);

    // Each computed direction takes the pair that lies most along it
    FixedList<bool, 3> taken(false);
    for (int d = 0; d < nDim_; ++d)
    {
        if (s.outer >= 0 && d == axes_.radial())
        {
            s.side[d][0] = -1;
            s.side[d][1] = s.outer;
            continue;
        }
        int best = -1;
        scalar along = -1;
        for (int k = 0; k < s.nPairs; ++k)
        {
            if (taken[k] || isEmpty.test(s.pair[k][0]))
            {
                continue;
            }
            const vector v(mesh.faceCentres()[s.pair[k][1]] - mesh.faceCentres()[s.pair[k][0]]);
            const scalar a = mag(v[axes_.direction(d)]) / max(mag(v), VSMALL);
            if (a > along)
            {
                along = a;
                best = k;
            }
        }
        if (best < 0)
        {
            FatalErrorInFunction << "Cell " << celli << " at " << mesh.cellCentres()[celli]
                                 << " has no pair of sides"
                                 << " for direction " << d << "; check the empty or wedge"
                                 << " patches." << exit(FatalError);
        }
        taken[best] = true;
        const scalar up = mesh.faceCentres()[s.pair[best][1]][axes_.direction(d)]
            - mesh.faceCentres()[s.pair[best][0]][axes_.direction(d)];
        s.side[d][0] = s.pair[best][up > 0 ? 0 : 1];
        s.side[d][1] = s.pair[best][up > 0 ? 1 : 0];
    }
    return s;
}

void Foam::mpm::hexCells::setCorners(
    const label celli, const cellSides& s, const labelList& pointToNode, label* corners,
    labelHashSet& onAxis)
{
    const polyMesh& mesh = mesh_;
    const faceList& faces = mesh.faces();
    const label nc = label(1) << nDim_;

    // A corner is the node of the points that its sides share
    for (label n = 0; n < nc; ++n)
    {
        label corner = -1, own = -1;
        for (const label p : mesh.cellPoints()[celli])
        {
            bool inAll = true;
            for (int d = 0; d < nDim_; ++d)
            {
                const label facei = s.side[d][(n >> d) & 1];
                inAll = inAll && (facei >= 0 ? faces[facei].found(p) : !faces[s.outer].found(p));
            }
            if (inAll)
            {
                corner = pointToNode[p];
                own = p;
            }
        }
        if (s.outer >= 0 && !((n >> axes_.radial()) & 1))
        {
            onAxis.insert(corner);
        }
        corners[nc * celli + n] = corner;
        cellPoints_[nc * celli + n] = own;
    }
}

void Foam::mpm::hexCells::setNeighbours(
    const label celli, const cellSides& s, const coupledCells& c)
{
    const polyMesh& mesh = mesh_;

    for (int d = 0; d < nDim_; ++d)
    {
        for (int i = 0; i < 2; ++i)
        {
            const label facei = s.side[d][i];
            label nbr = -1;
            if (facei < 0)
            {
                // Nothing beyond the axis
            }
            else if (mesh.isInternalFace(facei))
            {
                nbr = mesh.faceOwner()[facei] == celli ? mesh.faceNeighbour()[facei]
                                                       : mesh.faceOwner()[facei];
            }
            else
            {
                nbr = c.cell[facei - mesh.nInternalFaces()];
                if (nbr >= 0 && shift_.size())
                {
                    shift_[2 * (nDim_ * celli + d) + i] =
                        c.separation[facei - mesh.nInternalFaces()];
                }
            }
            cellCells_[2 * (nDim_ * celli + d) + i] = nbr;
            if (nbr < 0)
            {
                walls_[celli] |= 1u << (2 * d + i);
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::hexCells::hexCells(
    const polyMesh& mesh, const gridAxes& axes, gridNodes& nodes, ghostCells& ghosts) :
    mesh_(mesh),
    axes_(axes),
    nDim_(axes.nDim()),
    cellCells_(2 * nDim_ * mesh.nCells(), label(-1)),
    walls_(mesh.nCells(), static_cast<unsigned char>(0))
{
    const bitSet isEmpty(gridNodes::emptyFaces(mesh));
    prismMatcher prism;
    labelHashSet onAxis;
    const label nc = label(1) << nDim_;

    labelList corners(nc * mesh.nCells());
    cellPoints_.setSize(nc * mesh.nCells());

    const coupledCells coupled(mesh, ghosts);
    if (coupled.cyclic)
    {
        shift_.setSize(2 * nDim_ * mesh.nCells(), vector(Zero));
    }

    forAll(mesh.cells(), celli)
    {
        const bool atAxis = isAtAxis(mesh, axes.radial(), isEmpty, prism, celli);
        const cellSides sides(sidesOf(celli, isEmpty, atAxis));
        setCorners(celli, sides, nodes.ofPoints(), corners.data(), onAxis);
        setNeighbours(celli, sides, coupled);
    }
    axisNodes_ = onAxis.sortedToc();
    nodes.setOfCells(nc, std::move(corners));
    corners_ = nodes.ofCells().cdata();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::mpm::hexCells::refusal(const polyMesh& mesh, const gridAxes& axes)
{
    const bitSet isEmpty(gridNodes::emptyFaces(mesh));
    hexMatcher hex;
    prismMatcher prism;
    string reason;
    forAll(mesh.cells(), celli)
    {
        const bool atAxis = isAtAxis(mesh, axes.radial(), isEmpty, prism, celli);
        if (!atAxis && !hex.isA(mesh, celli))
        {
            OStringStream s;
            s << "Cell " << celli << " at " << mesh.cellCentres()[celli]
              << " is not a hexahedron: it has " << mesh.cells()[celli].size() << " faces";
            reason = s.str();
            break;
        }
    }
    return firstFound(reason);
}

void Foam::mpm::hexCells::cornerPositions(const label celli, scalar* x) const
{
    const label nc = label(1) << nDim_;
    for (label n = 0; n < nc; ++n)
    {
        const point& p = mesh_.points()[cellPoints_[nc * celli + n]];
        for (int d = 0; d < nDim_; ++d)
        {
            x[nDim_ * n + d] = p[axes_.direction(d)];
        }
    }
}
