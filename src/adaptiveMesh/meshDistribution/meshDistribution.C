// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "meshDistribution.H"
#include "cyclicPolyPatch.H"
#include "ListOps.H"
#include "processorCyclicPolyPatch.H"
#include "PstreamBuffers.H"
#include "syncTools.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sorted, each once
labelList sortedOnce(const labelUList& numbers)
{
    labelList all(numbers);
    Foam::sort(all);
    all.setSize(std::unique(all.begin(), all.end()) - all.begin());
    return all;
}

//- Places of numbers in a sorted list that has them
labelList placesIn(const labelUList& sorted, const labelUList& numbers)
{
    labelList at(numbers.size());
    forAll(at, i)
    {
        at[i] = std::lower_bound(sorted.begin(), sorted.end(), numbers[i]) - sorted.begin();
    }
    return at;
}

//- Lists of all processors by their destinations
labelListList exchanged(const labelListList& to)
{
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(to, proci)
    {
        UOPstream os(proci, buffers);
        os << to[proci];
    }
    buffers.finishedSends();
    labelListList from(to.size());
    forAll(from, proci)
    {
        UIPstream is(proci, buffers);
        is >> from[proci];
    }
    return from;
}

IOobject header(const polyMesh& mesh, const word& name)
{
    return IOobject(
        name, mesh.facesInstance(), polyMesh::meshSubDir, mesh, IOobject::NO_READ,
        IOobject::NO_WRITE, false);
}

labelListList numbersOf(const labelUList& numbers, const labelListList& places)
{
    labelListList of(places.size());
    forAll(of, proci)
    {
        of[proci] = UIndirectList<label>(numbers, places[proci])();
    }
    return of;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelIOList
Foam::mpm::meshDistribution::read(const polyMesh& files, const word& name, const label size)
{
    IOobject io(
        name, files.facesInstance(), polyMesh::meshSubDir, files, IOobject::MUST_READ,
        IOobject::NO_WRITE, false);
    if (!returnReduce(io.typeHeaderOk<labelIOList>(true), andOp<bool>()))
    {
        FatalErrorInFunction << "loadBalance in system/decomposeParDict and an adaptive mesh"
                             << " on several processors need the file " << io.objectPath()
                             << ", which decomposePar writes." << exit(FatalError);
    }
    labelIOList list(io);
    if (returnReduce(list.size() != size, orOp<bool>()))
    {
        FatalErrorInFunction << "File " << io.objectPath() << " has " << list.size()
                             << " numbers, the mesh has " << size << ": run decomposePar -force."
                             << exit(FatalError);
    }
    return list;
}

Foam::DynamicList<Foam::mpm::meshDistribution::sentFace>
Foam::mpm::meshDistribution::facesOf(const labelList& toProc) const
{
    labelList cellBehind, procBehind;
    syncTools::swapBoundaryCellList(mesh_, cells_, cellBehind);
    syncTools::swapBoundaryCellList(mesh_, toProc, procBehind);
    DynamicList<sentFace> all(mesh_.nFaces());
    const label nInternal = mesh_.nInternalFaces();
    forAll(mesh_.faces(), f)
    {
        const label P = mesh_.faceOwner()[f], i = f - nInternal;
        sentFace s{mag(faces_[f]) - 1, cells_[P], -1, toProc[P], -1, -1, labelList()};
        face points(mesh_.faces()[f]);
        if (i < 0)
        {
            s.b = cells_[mesh_.faceNeighbour()[f]];
            s.q = toProc[mesh_.faceNeighbour()[f]];
        }
        else
        {
            const polyPatch& pp = mesh_.boundaryMesh()[mesh_.boundaryMesh().whichPatch(f)];
            s.q = pp.coupled() ? procBehind[i] : -1;
            if (isA<processorCyclicPolyPatch>(pp))
            {
                s.patch = refCast<const processorCyclicPolyPatch>(pp).referPatchID();
            }
            else if (isA<processorPolyPatch>(pp))
            {
                s.b = cellBehind[i];
            }
            else
            {
                s.patch = pp.index();
            }
        }
        if (faces_[f] < 0)
        {
            std::swap(s.a, s.b);
            std::swap(s.p, s.q);
            points.flip();
        }
        s.points = UIndirectList<label>(points_, points)();
        all.append(std::move(s));
    }
    return all;
}

void Foam::mpm::meshDistribution::setMesh(
    meshChange& change, const newMesh& to, const PtrList<dictionary>& patches,
    const labelUList& partners)
{
    const label me = Pstream::myProcNo(), nPatches = patches.size();

    // Inside; patches; to other processors, through patches: the pair of these has the same
    // place on both sides
    typedef FixedList<label, 4> place;
    const auto placeOf = [&](const sentFace& s)
    {
        const label q = s.p == me ? s.q : s.p;
        if (s.patch < 0)
        {
            return q == me ? place{-1, 0, 0, 0} : place{nPatches, q, -1, 0};
        }
        if (s.q < 0 || q == me)
        {
            return place{s.patch, 0, 0, 0};
        }
        const label other = partners[s.patch];
        return place{nPatches, q, min(s.patch, other), (me < q) == (s.patch < other) ? 0 : 1};
    };
    const auto before = [](const place& a, const place& b)
    { return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end()); };
    labelList order(identity(to.faces.size()));
    List<place> places(order.size());
    forAll(places, i)
    {
        places[i] = placeOf(to.faces[i]);
    }
    std::stable_sort(
        order.begin(), order.end(),
        [&](const label i, const label j) { return before(places[i], places[j]); });

    faceList faces(order.size());
    labelList owner(order.size());
    DynamicList<label> inside(order.size());
    labelList size(nPatches, 0);
    faces_.setSize(order.size());
    struct between
    {
        label proc, patch, size;
    };
    DynamicList<between> others;
    forAll(order, f)
    {
        const sentFace& s = to.faces[order[f]];
        const place& at = places[order[f]];
        const bool turned = s.patch < 0 && s.p != me;
        face& of = faces[f];
        of = face(placesIn(to.points, s.points));
        if (turned)
        {
            of.flip();
        }
        owner[f] = turned ? s.b : s.a;
        faces_[f] = (turned ? -1 : 1) * (s.number + 1);
        if (at[0] < 0)
        {
            inside.append(s.b);
        }
        else if (at[0] < nPatches)
        {
            ++size[at[0]];
        }
        else
        {
            if (f == 0 || places[order[f - 1]] != at)
            {
                others.append(between{at[1], s.patch, 0});
            }
            ++others.last().size;
        }
    }
    owner = placesIn(to.cells, owner);
    labelList neighbour(placesIn(to.cells, inside));
    change.set(pointField(to.x), std::move(faces), std::move(owner), std::move(neighbour));
    const label n = nPatches + others.size();
    wordList names(n);
    PtrList<dictionary> dicts(n);
    size.setSize(n);
    const word at("At" + Foam::name(mesh_.time().timeIndex()));
    forAll(names, i)
    {
        if (i < nPatches)
        {
            names[i] = patches[i].dictName();
            dicts.set(i, new dictionary(patches[i]));
            continue;
        }
        const between& other = others[i - nPatches];
        const bool through = other.patch >= 0;
        names[i] = processorPolyPatch::newName(me, other.proc)
            + (through ? "through" + names[other.patch] : word()) + at;
        dicts.set(i, new dictionary());
        dicts[i].set("type", word(through ? "processorCyclic" : "processor"));
        dicts[i].set("myProcNo", me);
        dicts[i].set("neighbProcNo", other.proc);
        if (through)
        {
            dicts[i].set("referPatch", names[other.patch]);
        }
        size[i] = other.size;
    }
    change.setPatches(names, dicts, size);
    cells_ = to.cells;
    points_ = to.points;
    patches_.setSize(nPatches);
    patches_.setSize(n, -1);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::meshDistribution::meshDistribution(polyMesh& mesh, const polyMesh* files) :
    mesh_(mesh),
    cells_(read(files ? *files : mesh, "cellProcAddressing", mesh.nCells())),
    points_(read(files ? *files : mesh, "pointProcAddressing", mesh.nPoints())),
    faces_(read(files ? *files : mesh, "faceProcAddressing", mesh.nFaces())),
    patches_(read(files ? *files : mesh, "boundaryProcAddressing", mesh.boundaryMesh().size()))
{
}

Foam::mpm::meshDistribution::meshDistribution(polyMesh& mesh, const zero) :
    mesh_(mesh),
    cells_(header(mesh, "cellProcAddressing"), identity(mesh.nCells())),
    points_(header(mesh, "pointProcAddressing"), identity(mesh.nPoints())),
    faces_(header(mesh, "faceProcAddressing"), identity(mesh.nFaces(), 1)),
    patches_(header(mesh, "boundaryProcAddressing"), identity(mesh.boundaryMesh().size()))
{
}

Foam::mpm::meshDistribution::meshDistribution(
    polyMesh& mesh, const labelUList& cells, const labelUList& points, const labelUList& faces) :
    mesh_(mesh),
    cells_(header(mesh, "cellProcAddressing"), cells),
    points_(header(mesh, "pointProcAddressing"), points),
    faces_(header(mesh, "faceProcAddressing"), faces),
    patches_(header(mesh, "boundaryProcAddressing"), labelList())
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::meshDistribution::maps Foam::mpm::meshDistribution::move(const labelList& toProc)
{
    const label n = Pstream::nProcs(), nPatches = mesh_.boundaryMesh().nNonProcessor();
    PtrList<dictionary> patches(meshChange::patches(mesh_, nPatches));
    labelList partners(nPatches, -1);
    forAll(partners, i)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[i];
        if (isA<cyclicPolyPatch>(pp))
        {
            partners[i] = refCast<const cyclicPolyPatch>(pp).neighbPatchID();
        }
    }

    // What goes where
    labelListList toCells(n), toFaces(n), toPoints(n), faceNumbers(n), faceTexts(n);
    toCells = invertOneToMany(n, toProc);
    const DynamicList<sentFace> faces(facesOf(toProc));
    boolList here(n, false);
    List<DynamicList<label>> sentFaces(n), texts(n);
    List<bitSet> sentPoints(n, bitSet(mesh_.nPoints()));
    forAll(faces, f)
    {
        const sentFace& s = faces[f];
        const label P = toProc[mesh_.faceOwner()[f]];
        const label N = mesh_.isInternalFace(f) ? toProc[mesh_.faceNeighbour()[f]] : P;
        for (const label proci : P == N ? labelList(1, P) : labelList({P, N}))
        {
            sentFaces[proci].append(f);
            texts[proci].append(
                labelList({s.number, s.a, s.b, s.p, s.q, s.patch, s.points.size()}));
            texts[proci].append(s.points);
            sentPoints[proci].set(mesh_.faces()[f]);
        }
    }
    forAll(texts, proci)
    {
        toFaces[proci].transfer(sentFaces[proci]);
        faceTexts[proci].transfer(texts[proci]);
        toPoints[proci] = sentPoints[proci].sortedToc();
    }

    // What has come
    newMesh to;
    const labelListList cellsFrom(exchanged(numbersOf(cells_, toCells)));
    const labelListList pointsFrom(exchanged(numbersOf(points_, toPoints)));
    to.cells = sortedOnce(ListListOps::combine<labelList>(cellsFrom, accessOp<labelList>()));
    to.points = sortedOnce(ListListOps::combine<labelList>(pointsFrom, accessOp<labelList>()));
    labelListList cellPlaces(n), pointPlaces(n), facePlaces(n);
    forAll(cellPlaces, proci)
    {
        cellPlaces[proci] = placesIn(to.cells, cellsFrom[proci]);
        pointPlaces[proci] = placesIn(to.points, pointsFrom[proci]);
    }
    const labelListList textsFrom(exchanged(faceTexts));
    labelListList numbersFrom(n);
    forAll(textsFrom, proci)
    {
        const labelList& t = textsFrom[proci];
        DynamicList<label> numbers;
        for (label at = 0; at < t.size(); at += 7 + t[at + 6])
        {
            numbers.append(t[at]);
            to.faces.append(sentFace{
                t[at], t[at + 1], t[at + 2], t[at + 3], t[at + 4], t[at + 5],
                SubList<label>(t, t[at + 6], at + 7)});
        }
        numbersFrom[proci].transfer(numbers);
    }
    std::sort(
        to.faces.begin(), to.faces.end(),
        [](const sentFace& a, const sentFace& b) { return a.number < b.number; });
    to.faces.setSize(
        std::unique(
            to.faces.begin(), to.faces.end(),
            [](const sentFace& a, const sentFace& b) { return a.number == b.number; })
        - to.faces.begin());

    const wordList zones(mesh_.cellZones().names());
    List<boolList> inZones(zones.size(), boolList(mesh_.nCells(), false));
    forAll(zones, i)
    {
        UIndirectList<bool>(inZones[i], mesh_.cellZones()[i]) = true;
    }
    maps m{{}, {}, {}, meshChange(mesh_)};
    m.cells = mapDistribute(to.cells.size(), std::move(toCells), std::move(cellPlaces));
    m.points = mapDistribute(to.points.size(), std::move(toPoints), std::move(pointPlaces));
    to.x = mesh_.points();
    m.points.distribute(to.x);
    setMesh(m.change, to, patches, partners);
    for (boolList& in : inZones)
    {
        m.cells.distribute(in);
    }
    m.change.setZones(zones, inZones);

    // Faces by the order of the new mesh
    Map<label> faceAt(2 * faces_.size());
    forAll(faces_, f)
    {
        faceAt.set(mag(faces_[f]) - 1, f);
    }
    forAll(facePlaces, proci)
    {
        facePlaces[proci].setSize(numbersFrom[proci].size());
        forAll(facePlaces[proci], i)
        {
            facePlaces[proci][i] = faceAt[numbersFrom[proci][i]];
        }
    }
    m.faces = mapDistribute(faces_.size(), std::move(toFaces), std::move(facePlaces));
    return m;
}

void Foam::mpm::meshDistribution::write(const word& instance)
{
    mesh_.setInstance(instance);
    mesh_.write();
    mesh_.setInstance(instance, IOobject::NO_WRITE);
    for (labelIOList* list : {&cells_, &points_, &faces_, &patches_})
    {
        labelIOList(
            IOobject(
                list->name(), instance, polyMesh::meshSubDir, mesh_, IOobject::NO_READ,
                IOobject::NO_WRITE, false),
            *list)
            .write();
    }
}
