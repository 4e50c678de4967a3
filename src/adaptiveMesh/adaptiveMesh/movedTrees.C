// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "adaptiveMesh.H"
#include "globalIndex.H"
#include "globalMeshData.H"
#include "ListOps.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Place of each item when those of all processors are sorted by a key; those of one key
//  follow each other on one processor. Collective
labelList placesByKey(const labelUList& keys)
{
    const label most = keys.size() ? max(keys) : label(-1);
    labelList start(returnReduce(most, maxOp<label>()) + 1, 0);
    for (const label key : keys)
    {
        ++start[key];
    }
    Pstream::listCombineGather(start, plusEqOp<label>());
    Pstream::listCombineScatter(start);
    label sum = 0;
    for (label& s : start)
    {
        sum += s;
        s = sum - s;
    }
    labelList places(keys.size());
    forAll(keys, i)
    {
        places[i] = start[keys[i]]++;
    }
    return places;
}

}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::meshDistribution> Foam::mpm::adaptiveMesh::numbers()
{
    const label nInternal = mesh_.nInternalFaces();
    const labelList cells(placesByKey(ofCells(distribution_->cells())));
    labelList points, once;
    mesh_.globalData().mergePoints(points, once);

    // Faces of patches by those of the base mesh, as their order is; the others before them.
    // A face between two processors has the lower number of both, whose cell owns it
    const globalIndex all(mesh_.nFaces());
    labelList faces(mesh_.nFaces()), behind(mesh_.nFaces() - nInternal);
    forAll(faces, f)
    {
        faces[f] = all.toGlobal(f) + 1;
    }
    behind = SubList<label>(faces, behind.size(), nInternal);
    syncTools::swapBoundaryFaceList(mesh_, behind);
    DynamicList<label> ofPatches, keys;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const bool between = isA<processorPolyPatch>(pp) && !isA<processorCyclicPolyPatch>(pp);
        for (label f = pp.start(); f < pp.start() + pp.size(); ++f)
        {
            const label other = behind[f - nInternal];
            if (between)
            {
                faces[f] = faces[f] < other ? faces[f] : -other;
            }
            else
            {
                ofPatches.append(f);
                keys.append(mag(distribution_->faces()[baseFace_[f - nInternal]]) - 1);
            }
        }
    }
    const labelList places(placesByKey(keys));
    forAll(places, i)
    {
        faces[ofPatches[i]] = all.size() + places[i] + 1;
    }
    return autoPtr<meshDistribution>(new meshDistribution(mesh_, cells, points, faces));
}

void Foam::mpm::adaptiveMesh::move(const labelList& toProc, labelList& values)
{
    // Levels of a tree follow each other: by base cells
    labelListList levels(base_->nCells());
    forAll(levels, b)
    {
        const label first = leaves_->start()[b];
        levels[b] = SubList<label>(leaves_->level(), leaves_->start()[b + 1] - first, first);
    }
    leaves_.clear();
    hexes_.clear();
    const meshDistribution::maps maps(distribution_->move(toProc));
    maps.cells.distribute(levels);
    maps.cells.distribute(values);
    hexes_.reset(new baseHexes(base_()));
    make(autoPtr<treeLeaves>(
        new treeLeaves(hexes_(), ListListOps::combine<labelList>(levels, accessOp<labelList>()))));
    baseWritten_ = false;
}
