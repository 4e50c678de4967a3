// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "meshChange.H"
#include "labelIOList.H"
#include "ListOps.H"
#include "mapPolyMesh.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::meshChange::meshChange(polyMesh& mesh) :
    meshChange(mesh, mesh.nCells(), mesh.nFaces(), mesh.nPoints())
{
}

Foam::mpm::meshChange::meshChange(
    polyMesh& mesh, const label nCells, const label nFaces, const label nPoints) :
    mesh_(mesh), nCells_(nCells), nFaces_(nFaces), nPoints_(nPoints)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::PtrList<Foam::dictionary> Foam::mpm::meshChange::patches(const polyMesh& mesh, const label n)
{
    PtrList<dictionary> all(n < 0 ? mesh.boundaryMesh().size() : n);
    forAll(all, i)
    {
        const polyPatch& pp = mesh.boundaryMesh()[i];
        OStringStream os;
        os << pp;
        IStringStream is(os.str());
        all.set(i, new dictionary(pp.name(), dictionary(), is));
    }
    return all;
}

void Foam::mpm::meshChange::set(
    pointField&& points, faceList&& faces, labelList&& owner, labelList&& neighbour)
{
    // Fields that the mesh owns
    for (const word& name : mesh_.sortedNames())
    {
        regIOobject* io = mesh_.getObjectPtr<regIOobject>(name);
        if (io && io->ownedByRegistry() && io->type().ends_with("Field"))
        {
            io->checkOut();
        }
    }
    if (fvMesh* fv = isA<fvMesh>(mesh_) ? &refCast<fvMesh>(mesh_) : nullptr)
    {
        fv->clearOut();
        fv->removeFvBoundary();
    }
    else
    {
        mesh_.clearOut();
        mesh_.removeBoundary();
    }
    mesh_.resetPrimitives(
        autoPtr<pointField>(new pointField(std::move(points))),
        autoPtr<faceList>(new faceList(std::move(faces))),
        autoPtr<labelList>(new labelList(std::move(owner))),
        autoPtr<labelList>(new labelList(std::move(neighbour))), labelList(), labelList(), true);
}

void Foam::mpm::meshChange::setPatches(
    const wordList& names, PtrList<dictionary>& patches, const labelUList& nFaces)
{
    label start = mesh_.nInternalFaces();
    PtrList<polyPatch> list(patches.size());
    forAll(list, i)
    {
        patches[i].set("nFaces", nFaces[i]);
        patches[i].set("startFace", start);
        list.set(i, polyPatch::New(names[i], patches[i], i, mesh_.boundaryMesh()));
        start += nFaces[i];
    }
    if (isA<fvMesh>(mesh_))
    {
        refCast<fvMesh>(mesh_).addFvPatches(list);
    }
    else
    {
        mesh_.addPatches(list);
    }

    // Made when they are asked for, by all processors together. OpenFOAM would read base points
    // of the faces from where the mesh was written, that of then. One processor makes them when
    // points want them
    mesh_.geometricD();
    fileName& instance = mesh_.polyMesh::instance();
    const fileName before(instance);
    if (Pstream::parRun()
        || IOobject("tetBasePtIs", before, polyMesh::meshSubDir, mesh_, IOobject::MUST_READ)
               .typeHeaderOk<labelIOList>(true))
    {
        instance = mesh_.time().path() / "none";
        mesh_.tetBasePtIs();
        instance = before;
    }
}

void Foam::mpm::meshChange::setZones(const wordList& names, const List<boolList>& cells)
{
    mesh_.pointZones().clear();
    mesh_.faceZones().clear();
    mesh_.cellZones().clear();
    List<cellZone*> zones(names.size());
    forAll(zones, i)
    {
        labelList in(findIndices(cells[i], true));
        zones[i] = new cellZone(names[i], in, i, mesh_.cellZones());
    }
    mesh_.addZones(List<pointZone*>(), List<faceZone*>(), zones);
}

void Foam::mpm::meshChange::tellFunctionObjects() const
{
    // Nothing is where it was
    const List<objectMap> none;
    const labelListList noZones;
    const auto lost = [](const label n) { return labelList(n, label(-1)); };
    const mapPolyMesh map(
        mesh_, nPoints_, nFaces_, nCells_, lost(mesh_.nPoints()), none, lost(mesh_.nFaces()), none,
        none, none, lost(mesh_.nCells()), none, none, none, none, lost(nPoints_), lost(nFaces_),
        lost(nCells_), labelHashSet(), labelListList(), noZones, noZones, noZones, noZones,
        pointField(), labelList(), labelList(), autoPtr<scalarField>());
    const_cast<Time&>(mesh_.time()).functionObjects().updateMesh(map);
}
