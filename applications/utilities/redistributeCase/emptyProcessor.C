// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "emptyProcessor.H"
#include "entry.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

IOobject meshFile(const Time& time, const word& instance, const word& name)
{
    return IOobject(
        name, instance, polyMesh::meshSubDir, time, IOobject::NO_READ, IOobject::NO_WRITE, false);
}

void writeText(
    const Time& time, const word& instance, const word& name, const word& type, const string& text)
{
    const IOobject io(meshFile(time, instance, name));
    mkDir(io.path());
    OFstream os(io.objectPath());
    io.writeHeader(os, type);
    os << text.c_str() << nl;
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::writeEmptyProcessor(const Time& time, const word& instance, const bool empty)
{
    string patches, identity;
    bool tets = false;
    if (Pstream::master())
    {
        IOobject io(meshFile(time, instance, "boundary"));
        IFstream is(io.objectPath());
        io.readHeader(is);
        const PtrList<entry> all(is);
        OStringStream os, places;
        label n = 0;
        for (const entry& e : all)
        {
            dictionary dict(e.dict());
            if (!e.keyword().starts_with("procBoundary"))
            {
                dict.set("nFaces", 0);
                dict.set("startFace", 0);
                dict.writeEntry(e.keyword(), os);
                places << ' ' << n++;
            }
        }
        patches = Foam::name(n) + "\n(\n" + os.str() + ")";
        tets = isFile(meshFile(time, instance, "tetBasePtIs").objectPath());
        identity = Foam::name(n) + "(" + places.str() + ")";
    }
    Pstream::scatter(patches);
    Pstream::scatter(identity);
    Pstream::scatter(tets);
    if (!empty)
    {
        return;
    }
    writeText(time, instance, "points", "vectorField", "0()");
    writeText(time, instance, "faces", "faceList", "0()");
    writeText(time, instance, "boundary", "polyBoundaryMesh", patches);
    for (const word name :
         {"owner", "neighbour", "cellProcAddressing", "faceProcAddressing", "pointProcAddressing"})
    {
        writeText(time, instance, name, "labelList", "0()");
    }
    if (tets)
    {
        // All read them or all find them
        writeText(time, instance, "tetBasePtIs", "labelList", "0()");
    }
    writeText(time, instance, "boundaryProcAddressing", "labelList", identity);
}

void Foam::mpm::addEmptyZones(fvMesh& mesh, const bool empty)
{
    wordList names(mesh.cellZones().names());
    Pstream::scatter(names);
    if (!empty)
    {
        return;
    }
    List<cellZone*> zones(names.size());
    forAll(zones, i)
    {
        zones[i] = new cellZone(names[i], labelList(), i, mesh.cellZones());
    }
    mesh.addZones(List<pointZone*>(), List<faceZone*>(), zones);
}
