/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hexGrid.H"
#include "emptyPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "hexMatcher.H"
#include "prismMatcher.H"
#include "wedgePolyPatch.H"
#include "HashSet.H"
#include "EdgeMap.H"
#include "SubField.H"
#include "bitSet.H"
#include "processorPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

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


//- True for faces on empty and wedge patches
bitSet emptyFaces(const polyMesh& mesh)
{
    bitSet isEmpty(mesh.nFaces());
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp))
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
    const bitSet isEmpty(emptyFaces(mesh));

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
        // Front and back are joined by the edges that lie in no empty (wedge)
        // face. On the axis of a wedge they are one point
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

    if (Pstream::parRun())
    {
        labelList root(mesh.nPoints());
        forAll(root, pointi)
        {
            root[pointi] = joined.root(pointi);
        }
        makeSharedNodes(root);
        return;
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


Foam::mpm::hexGrid::coupledSides Foam::mpm::hexGrid::findCoupled()
{
    const polyMesh& mesh = this->mesh();

    // Cells behind cyclic faces
    const label n = mesh.nFaces() - mesh.nInternalFaces();
    coupledSides c{labelList(n, label(-1)), vectorField(n, Zero), false};
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(pp))
        {
            const labelUList& nbr =
                refCast<const cyclicPolyPatch>(pp).neighbPatch().faceCells();
            forAll(pp, i)
            {
                const label facei = pp.start() + i - mesh.nInternalFaces();
                c.cell[facei] = nbr[i];
                c.separation[facei] =
                    refCast<const cyclicPolyPatch>(pp).neighbPatch()
                   .faceCentres()[i]
                  - pp.faceCentres()[i];
                c.cyclic = true;
            }
        }
    }

    // Cells of other processors
    if (Pstream::parRun())
    {
        labelList nbrCell(n, -1);
        vectorField nbrCentre(n, Zero);
        forAll(nbrCell, i)
        {
            nbrCell[i] = mesh.faceOwner()[mesh.nInternalFaces() + i];
            nbrCentre[i] = mesh.faceCentres()[mesh.nInternalFaces() + i];
        }
        syncTools::swapBoundaryFaceList(mesh, nbrCell);
        syncTools::swapBoundaryFaceList(mesh, nbrCentre);

        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            if (isA<processorPolyPatch>(pp))
            {
                const label proci =
                    refCast<const processorPolyPatch>(pp).neighbProcNo();
                const bool shifted = isA<processorCyclicPolyPatch>(pp);
                forAll(pp, i)
                {
                    const label facei = pp.start() + i - mesh.nInternalFaces();
                    c.cell[facei] = ghost(proci, nbrCell[facei]);
                    if (shifted)
                    {
                        c.separation[facei] =
                            nbrCentre[facei] - pp.faceCentres()[i];
                        c.cyclic = true;
                    }
                }
            }
        }
    }
    return c;
}


void Foam::mpm::hexGrid::pairFaces
(
    const label celli,
    const bitSet& isEmpty,
    const bool atAxis,
    cellSides& s
) const
{
    const polyMesh& mesh = this->mesh();
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


Foam::mpm::hexGrid::cellSides Foam::mpm::hexGrid::sidesOf
(
    const label celli,
    const bitSet& isEmpty,
    const bool atAxis
) const
{
    const polyMesh& mesh = this->mesh();
    cellSides s;
    pairFaces(celli, isEmpty, atAxis, s);

    // Each computed direction takes the pair that lies most along it
    FixedList<bool, 3> taken(false);
    for (int d = 0; d < nDim_; ++d)
    {
        if (s.outer >= 0 && d == radial_)
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
            const vector v
            (
                mesh.faceCentres()[s.pair[k][1]]
              - mesh.faceCentres()[s.pair[k][0]]
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
                << " for direction " << d << "; check the empty or wedge"
                << " patches."
                << exit(FatalError);
        }
        taken[best] = true;
        const scalar up =
            mesh.faceCentres()[s.pair[best][1]][dir_[d]]
          - mesh.faceCentres()[s.pair[best][0]][dir_[d]];
        s.side[d][0] = s.pair[best][up > 0 ? 0 : 1];
        s.side[d][1] = s.pair[best][up > 0 ? 1 : 0];
    }
    return s;
}


void Foam::mpm::hexGrid::setCorners
(
    const label celli,
    const cellSides& s,
    labelHashSet& onAxis
)
{
    const polyMesh& mesh = this->mesh();
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
                inAll =
                    inAll
                 && (
                        facei >= 0
                      ? faces[facei].found(p)
                      : !faces[s.outer].found(p)
                    );
            }
            if (inAll)
            {
                corner = pointToNode_[p];
                own = p;
            }
        }
        if (s.outer >= 0 && !((n >> radial_) & 1))
        {
            onAxis.insert(corner);
        }
        cellNodes_[nc*celli + n] = corner;
        cellPoints_[nc*celli + n] = own;
    }
}


void Foam::mpm::hexGrid::setNeighbours
(
    const label celli,
    const cellSides& s,
    const coupledSides& c
)
{
    const polyMesh& mesh = this->mesh();

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
                nbr =
                    mesh.faceOwner()[facei] == celli
                  ? mesh.faceNeighbour()[facei]
                  : mesh.faceOwner()[facei];
            }
            else
            {
                nbr = c.cell[facei - mesh.nInternalFaces()];
                if (nbr >= 0 && shift_.size())
                {
                    shift_[2*(nDim_*celli + d) + i] =
                        c.separation[facei - mesh.nInternalFaces()];
                }
            }
            cellCells_[2*(nDim_*celli + d) + i] = nbr;
            if (nbr < 0)
            {
                walls_[celli] |= 1u << (2*d + i);
            }
        }
    }
}


void Foam::mpm::hexGrid::makeCells()
{
    const polyMesh& mesh = this->mesh();
    const bitSet isEmpty(emptyFaces(mesh));
    hexMatcher hex;
    prismMatcher prism;
    labelHashSet onAxis;
    const label nc = label(1) << nDim_;

    cellNodes_.setSize(nc*mesh.nCells());
    cellPoints_.setSize(nc*mesh.nCells());
    cellCells_.setSize(2*nDim_*mesh.nCells(), -1);
    walls_.setSize(mesh.nCells(), 0);

    const coupledSides coupled(findCoupled());
    if (coupled.cyclic)
    {
        shift_.setSize(2*nDim_*mesh.nCells(), vector(Zero));
    }

    forAll(mesh.cells(), celli)
    {
        const bool atAxis = radial_ >= 0 && prism.isA(mesh, celli);
        if (!atAxis && !hex.isA(mesh, celli))
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << mesh.cellCentres()[celli]
                << " is not a hexahedron: it has "
                << mesh.cells()[celli].size() << " faces. Material points need"
                << " a mesh of hexahedra (shape functions: linear; on meshes of"
                << " boxes also GIMP and B-splines)." << nl
                << "Cells beside locally refined ones have more faces and do"
                << " not work: for finer cells in a place grade the blocks of"
                << " the mesh (simpleGrading), or refine all."
                << exit(FatalError);
        }

        const cellSides sides(sidesOf(celli, isEmpty, atAxis));
        setCorners(celli, sides, onAxis);
        setNeighbours(celli, sides, coupled);
    }
    axisNodes_ = onAxis.sortedToc();
}

// ************************************************************************* //
