// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "refinementCriterion.H"
#include "dictionaryTools.H"
#include "IOdictionary.H"
#include "pointRegionShape.H"
#include "Time.H"
#include "treeLeaves.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(refinementCriterion, 0);
defineRunTimeSelectionTable(refinementCriterion, dictionary);
}

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::mpm::refinementCriterion::markShape(
    const polyMesh& mesh, const dictionary& dict, const bool cut, scalarField& need)
{
    const autoPtr<pointRegionShape> shape(pointRegionShape::New(pointGrid::New(mesh), dict));
    const boundBox box(shape->bounds());
    const Vector<label> computed(mesh.geometricD());
    const label nDim = mesh.nGeometricD();
    for (label c = 0; c < mesh.nCells(); ++c)
    {
        // Centre, middles of the faces and all points, a little inside: no shape thinner than
        // half a cell is missed; smaller ones by their own centre
        const point& C = mesh.cellCentres()[c];
        const labelList& points = mesh.cellPoints()[c];
        DynamicList<point> at(points.size() + mesh.cells()[c].size() + 1);
        at.append(C);
        for (const label p : points)
        {
            at.append(mesh.points()[p] + 1e-3 * (C - mesh.points()[p]));
            at.append(0.5 * (mesh.points()[p] + C));
        }
        for (const label f : mesh.cells()[c])
        {
            const point& x = mesh.faceCentres()[f];
            at.append(x + 1e-3 * (C - x));
        }
        label n = 0;
        for (const bool in : shape->contains(c, pointField(at)))
        {
            n += in;
        }
        bool in = cut ? n > 0 && n < at.size() : n > 0;
        if (n == 0 && box.volume() < GREAT)
        {
            const boundBox cell(mesh.cells()[c].points(mesh.faces(), mesh.points()), false);
            label nIn = 0;
            for (label d = 0; d < 3; ++d)
            {
                const scalar x = shape->computed(box.midpoint())[d];
                nIn += computed[d] > 0 && x >= cell.min()[d] && x <= cell.max()[d];
            }
            in = nIn == nDim;
        }
        need[c] = max(need[c], scalar(in));
    }
}

Foam::dictionary Foam::mpm::refinementCriterion::regionsOf(const polyMesh& mesh, const word& file)
{
    const word regions("regions");
    const IOdictionary dict(IOobject(
        file, mesh.time().system(), mesh.time(), IOobject::READ_IF_PRESENT, IOobject::NO_WRITE,
        false));
    return dict.subOrEmptyDict(regions);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::refinementCriterion::refinementCriterion(
    const dictionary& dict, const label maxLevel, const wordList& keywords) :
    dict_(dict), level_(boundedLabelOrDefault(dict, "level", maxLevel, 1, maxLevel))
{
    wordList valid({"type", "level"});
    valid.append(keywords);
    checkKeywords(dict, valid);
}

Foam::autoPtr<Foam::mpm::refinementCriterion>
Foam::mpm::refinementCriterion::New(const dictionary& dict, const label maxLevel)
{
    return selectFromTable<refinementCriterion>(
        dict, dictionaryConstructorTablePtr_, dict, maxLevel);
}
