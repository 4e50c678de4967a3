// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "adaptiveMesh.H"
#include "refinedMesh.H"
#include "IFstream.H"
#include "labelIOList.H"
#include "pointIOField.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Objects of the base mesh lie under the region base
IOobject baseHeader(const polyMesh& mesh, const IOobject::readOption read)
{
    const Time& time = mesh.time();
    return IOobject(
        "base", read == IOobject::NO_READ ? mesh.facesInstance() : fileName(time.timeName()), time,
        read, IOobject::NO_WRITE);
}

//- Class of a file's content, which comes next
word readHeader(IFstream& is)
{
    const word format("format"), type("class");
    const token start(is);
    const dictionary header(is);
    is.format(header.get<word>(format));
    return header.get<word>(type);
}

faceList readFaces(IFstream& is)
{
    if (readHeader(is) != "faceCompactList")
    {
        return faceList(is);
    }
    const labelList start(is), points(is);
    faceList faces(start.size() - 1);
    forAll(faces, f)
    {
        faces[f] = face(labelList(SubList<label>(points, start[f + 1] - start[f], start[f])));
    }
    return faces;
}

template<class Type>
Type readFile(const fileName& file)
{
    IFstream is(file);
    readHeader(is);
    return Type(is);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::adaptiveMesh::copyBase(const polyMesh& from)
{
    base_.reset(new polyMesh(
        baseHeader(mesh_, IOobject::NO_READ), pointField(from.points()), faceList(from.faces()),
        labelList(from.faceOwner()), labelList(from.faceNeighbour())));
    PtrList<polyPatch> patches(from.boundaryMesh().size());
    forAll(patches, i)
    {
        patches.set(i, from.boundaryMesh()[i].clone(base_->boundaryMesh()));
    }
    base_->addPatches(patches);
    List<boolList> in(from.cellZones().size(), boolList(from.nCells(), false));
    forAll(in, i)
    {
        UIndirectList<bool>(in[i], from.cellZones()[i]) = true;
    }
    meshChange(base_()).setZones(from.cellZones().names(), in);
}

bool Foam::mpm::adaptiveMesh::readWhole(labelList& levels)
{
    const Time& time = mesh_.time();
    const fileName constant(time.rootPath() / time.globalCaseName() / time.constant());
    const fileName ofLevels(constant / "polyMesh" / "cellLevel");
    if (!Pstream::parRun() || !returnReduce(isFile(ofLevels), andOp<bool>()))
    {
        return false;
    }
    levels = readFile<labelList>(ofLevels);
    const labelIOList cells(IOobject(
        "cellProcAddressing", mesh_.facesInstance(), polyMesh::meshSubDir, mesh_,
        IOobject::MUST_READ, IOobject::NO_WRITE, false));
    const fileName folder(constant / "base" / "polyMesh");

    // All on the master, and from there
    pointField points;
    faceList faces;
    labelList owner, neighbour;
    PtrList<entry> patches;
    if (Pstream::master())
    {
        points = readFile<pointField>(folder / "points");
        IFstream ofFaces(folder / "faces");
        faces = readFaces(ofFaces);
        owner = readFile<labelList>(folder / "owner");
        neighbour = readFile<labelList>(folder / "neighbour");
        neighbour.setSize(min(neighbour.size(), faces.size()));
    }
    IFstream ofPatches(folder / "boundary");
    readHeader(ofPatches);
    PtrList<entry>(ofPatches).swap(patches);
    base_.reset(new polyMesh(
        baseHeader(mesh_, IOobject::NO_READ), std::move(points), std::move(faces), std::move(owner),
        std::move(neighbour)));
    PtrList<polyPatch> list(patches.size());
    label start = base_->nInternalFaces();
    forAll(list, i)
    {
        dictionary dict(patches[i].dict());
        const word nFaces("nFaces");
        const label n = Pstream::master() ? dict.get<label>(nFaces) : 0;
        dict.set(nFaces, n);
        dict.set("startFace", start);
        list.set(i, polyPatch::New(patches[i].keyword(), dict, i, base_->boundaryMesh()));
        start += n;
    }
    base_->addPatches(list);

    // A tree goes where its first leaf is
    const label nBase = returnReduce(base_->nCells(), sumOp<label>());
    const label nDim = mesh_.nGeometricD();
    labelList baseOf(levels.size()), firstOf(nBase, label(-1));
    {
        scalar filled = 0;
        label b = -1;
        forAll(levels, c)
        {
            if (filled < SMALL)
            {
                firstOf[++b] = c;
            }
            baseOf[c] = b;
            filled += std::pow(2.0, -scalar(levels[c]) * nDim);
            filled = filled > 1 - SMALL ? 0 : filled;
        }
    }
    labelList toProc(nBase, label(-1));
    forAll(cells, c)
    {
        if (firstOf[baseOf[cells[c]]] == cells[c])
        {
            toProc[baseOf[cells[c]]] = Pstream::myProcNo();
        }
    }
    Pstream::listCombineGather(toProc, maxEqOp<label>());
    Pstream::listCombineScatter(toProc);
    whole_.setSize(cells.size());
    forAll(cells, c)
    {
        whole_[c] = toProc[baseOf[cells[c]]];
    }
    distribution_.reset(new meshDistribution(base_(), zero()));
    distribution_->move(Pstream::master() ? toProc : labelList());

    DynamicList<label> here;
    forAll(levels, c)
    {
        if (toProc[baseOf[c]] == Pstream::myProcNo())
        {
            here.append(levels[c]);
        }
    }
    levels.transfer(here);
    return true;
}

void Foam::mpm::adaptiveMesh::readBase()
{
    IOobject header(
        "cellLevel", mesh_.facesInstance(), polyMesh::meshSubDir, mesh_, IOobject::MUST_READ,
        IOobject::NO_WRITE, false);
    IOobject ofBase(
        "points", mesh_.time().findInstance("base/polyMesh", "points", IOobject::READ_IF_PRESENT),
        "base/polyMesh", mesh_.time(), IOobject::MUST_READ, IOobject::NO_WRITE, false);

    // decomposePar shares the levels, and does not know the base mesh
    const bool levelsHere = returnReduce(header.typeHeaderOk<labelIOList>(true), orOp<bool>());
    const bool refined =
        levelsHere && returnReduce(ofBase.typeHeaderOk<pointIOField>(false), orOp<bool>());
    labelList levels(mesh_.nCells(), 0);
    baseWritten_ = refined;
    if (refined)
    {
        levels = labelIOList(header);
        if (returnReduce(levels.size() != mesh_.nCells(), orOp<bool>()))
        {
            FatalErrorInFunction << "File " << header.objectPath() << " has " << levels.size()
                                 << " levels, the mesh has " << mesh_.nCells()
                                 << " cells: it is of another mesh."
                                 << " Remove it, or make the mesh anew." << exit(FatalError);
        }
        base_.reset(new polyMesh(baseHeader(mesh_, IOobject::MUST_READ)));
        if (Pstream::parRun())
        {
            distribution_.reset(new meshDistribution(base_()));
        }
    }
    else if (!readWhole(levels))
    {
        if (levelsHere)
        {
            FatalErrorInFunction << "There is " << header.objectPath()
                                 << ", but no base mesh: no file " << ofBase.objectPath()
                                 << exit(FatalError);
        }
        copyBase(mesh_);
        if (Pstream::parRun())
        {
            distribution_.reset(new meshDistribution(base_(), &mesh_));
        }
    }
    hexes_.reset(new baseHexes(base_()));
    leaves_.reset(new treeLeaves(hexes_(), levels));
    refinedMesh made(leaves_());
    baseFace_.transfer(made.made().baseFace);
}
