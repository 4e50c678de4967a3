// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "meshCheck.H"
#include "fatalMessages.H"
#include "polyMesh.H"
#include "cellIOList.H"
#include "Time.H"
#include "PtrList.H"
#include "entry.H"
#include "HashSet.H"
#include "stringList.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- The entries of the file boundary
class patchEntries : public regIOobject, public PtrList<entry>
{
public:
    explicit patchEntries(const IOobject& io) : regIOobject(io)
    {
        Istream& is = readStream(word("polyBoundaryMesh"));
        is >> static_cast<PtrList<entry>&>(*this);
        is.check(FUNCTION_NAME);
        close();
        for (entry& e : *this)
        {
            if (!e.isDict())
            {
                FatalIOErrorInFunction(is)
                    << "Entry " << e.keyword() << " in " << objectPath()
                    << " is not a dictionary; write  " << e.keyword()
                    << " { type ...; nFaces ...; startFace ...; }" << exit(FatalIOError);
            }

            // So that its errors name the file
            e.dict().name() = objectPath() + "/" + e.keyword();
        }
    }

    bool writeData(Ostream&) const { return false; }
};

//- A list of the mesh
template<class List>
autoPtr<List> readList(const IOobject& io)
{
    // Faces have two types: the reading looks at it
    if (!IOobject(io).typeHeaderOk<List>(false))
    {
        cannotRead(io.objectPath(), "it is missing, or has no header (FoamFile).");
    }
    announcedSize(io);
    return readNamed(io.objectPath(), [&] { return autoPtr<List>::New(io); });
}

//- Start of a message about a face
void begin(OSstream& os, const fileName& file, const label facei)
{
    os << "File " << file << ": face " << facei;
}

string problemOfPoints(const pointIOField& points)
{
    OStringStream os;
    forAll(points, i)
    {
        bool good = true;
        for (int d = 0; d < 3; ++d)
        {
            // Comparing NaN traps
            const scalar x = points[i][d];
            good = good && std::isfinite(x) && mag(x) < 1e50;
        }
        if (!good)
        {
            os << "File " << points.objectPath() << ": point " << i << " is at " << points[i];
            break;
        }
    }
    return os.str();
}

string problemOfFaces(const faceCompactIOList& faces, const label nPoints)
{
    OStringStream os;
    forAll(faces, facei)
    {
        const face& f = faces[facei];
        if (f.size() < 3)
        {
            begin(os, faces.objectPath(), facei);
            os << " has " << f.size() << " points; it needs 3";
            break;
        }
        forAll(f, k)
        {
            if (f[k] < 0 || f[k] >= nPoints)
            {
                begin(os, faces.objectPath(), facei);
                os << " has point " << f[k] << "; there are the points 0 to " << nPoints - 1;
                return os.str();
            }
            if (f.find(f[k], k + 1) >= 0)
            {
                begin(os, faces.objectPath(), facei);
                os << " has point " << f[k] << " twice";
                return os.str();
            }
        }
    }
    return os.str();
}

//- Number of faces that have a cell on either side
label nInternalFaces(const labelUList& neighbour, const label nFaces)
{
    // Old meshes have -1 for all others
    const label n = neighbour.size() == nFaces ? neighbour.find(-1) : -1;
    return n < 0 ? neighbour.size() : n;
}

string problemOfCells(const labelIOList& owner, const labelIOList& neighbour, const label nFaces)
{
    OStringStream os;
    if (owner.size() != nFaces)
    {
        os << "File " << owner.objectPath() << " has the owners of " << owner.size()
           << " faces; there are " << nFaces;
        return os.str();
    }
    const label nInternal = nInternalFaces(neighbour, nFaces);
    if (nInternal > nFaces)
    {
        os << "File " << neighbour.objectPath() << " has the neighbours of " << neighbour.size()
           << " faces; there are " << nFaces;
        return os.str();
    }

    // Each cell has more than one face: there are fewer than faces
    labelList count(nFaces, Zero);
    label nCells = 0;
    for (const bool isOwner : {true, false})
    {
        const labelIOList& of = isOwner ? owner : neighbour;
        const label n = isOwner ? nFaces : nInternal;
        for (label facei = 0; facei < n; ++facei)
        {
            const label celli = of[facei];
            if (celli < 0 || celli >= nFaces)
            {
                begin(os, of.objectPath(), facei);
                os << " has cell " << celli << "; there are " << nFaces << " faces and fewer cells";
                return os.str();
            }
            if (!isOwner && celli == owner[facei])
            {
                begin(os, of.objectPath(), facei);
                os << " has cell " << celli << " on both sides";
                return os.str();
            }
            ++count[celli];
            nCells = max(nCells, celli + 1);
        }
    }
    for (label celli = 0; celli < nCells; ++celli)
    {
        if (count[celli] < 4)
        {
            os << "Files " << owner.objectPath() << " and " << neighbour.name() << ": cell "
               << celli << " of " << nCells << " has " << count[celli]
               << " of the 4 or more faces that it"
               << " needs";
            break;
        }
    }
    return os.str();
}

//- As get<label>; an error of that does not name the file
label wholeNumber(const dictionary& dict, const word& key)
{
    const ITstream& is = dict.lookup(key);
    if (is.size() != 1 || !is[0].isLabel())
    {
        FatalIOErrorInFunction(dict) << "Entry " << key << " in " << dict.name()
                                     << " must be a whole number." << exit(FatalIOError);
    }
    return is[0].labelToken();
}

//- A cyclic patch has another of as many faces
string problemOfCyclic(const patchEntries& entries, const entry& own)
{
    OStringStream os;
    const dictionary& dict = own.dict();
    const word partner(dict.getOrDefault<word>("neighbourPatch", word::null));
    if (partner.empty() && dict.found("coupleGroup"))
    {
        return string();
    }
    os << "patch " << own.keyword() << " has the type cyclic and the"
       << " neighbourPatch " << (partner.empty() ? "-" : partner.c_str());
    for (const entry& e : entries)
    {
        if (e.keyword() == partner && &e != &own)
        {
            const word type(e.dict().get<word>("type"));
            const label n = wholeNumber(e.dict(), "nFaces");
            const label nOwn = wholeNumber(dict, "nFaces");
            if (type != "cyclic")
            {
                os << ", which has the type " << type;
                return os.str();
            }
            if (n != nOwn)
            {
                os << ", which has " << n << " faces and not " << nOwn;
                return os.str();
            }
            return string();
        }
    }
    os << ": there is no other patch of this name";
    return os.str();
}

//- The patches cover the faces without neighbour in their order
string problemOfPatches(const patchEntries& entries, const label nInternal, const label nFaces)
{
    OStringStream os;
    os << "File " << entries.objectPath() << ": ";
    wordHashSet names;
    label next = nInternal;
    for (const entry& e : entries)
    {
        const word& name = e.keyword();
        const word type(e.dict().get<word>("type"));
        const label n = wholeNumber(e.dict(), "nFaces");
        const label start = wholeNumber(e.dict(), "startFace");
        if (!names.insert(name))
        {
            os << "two patches have the name " << name;
            return os.str();
        }
        if (!polyPatch::dictionaryConstructorTablePtr_->found(type))
        {
            os << "patch " << name << " has the type " << type << "; types of patches are: "
               << flatOutput(polyPatch::dictionaryConstructorTablePtr_->sortedToc());
            return os.str();
        }
        if (!Pstream::parRun() && type.find("processor") == 0)
        {
            os << "patch " << name << " has the type " << type
               << ": this is a part of a mesh. Run in the folder of the case,"
               << " on all its processors (-parallel)";
            return os.str();
        }
        const string ofCyclic(type == "cyclic" ? problemOfCyclic(entries, e) : string());
        if (!ofCyclic.empty())
        {
            os << ofCyclic.c_str();
            return os.str();
        }
        if (n < 0 || start != next || n > nFaces - next)
        {
            os << "patch " << name << " has " << n << " faces from startFace " << start
               << "; expected startFace " << next << ", and at most " << nFaces - next << " faces";
            return os.str();
        }
        next += n;
    }
    if (next == nFaces)
    {
        return string();
    }
    os << "no patch has the last " << nFaces - next << " of the " << nFaces - nInternal
       << " faces of the boundary";
    return os.str();
}

//- What each processor says
stringList ofProcessors(const string& own)
{
    stringList all(Pstream::nProcs());
    all[Pstream::myProcNo()] = own;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    return all;
}

//- Patches that all processors must have
string namesOfPatches(const patchEntries& entries)
{
    string names;
    for (const entry& e : entries)
    {
        if (e.dict().get<word>("type").find("processor") != 0)
        {
            names += ' ' + e.keyword();
        }
    }
    return names;
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::mpm::firstFound(const string& own)
{
    for (const string& of : ofProcessors(own))
    {
        if (!of.empty())
        {
            return of;
        }
    }
    return string();
}

void Foam::mpm::refuseMesh(const string& found)
{
    OStringStream os;
    for (const string& of : ofProcessors(found))
    {
        if (!of.empty())
        {
            os << of.c_str() << '.' << nl;
        }
    }
    if (!os.str().empty())
    {
        FatalErrorInFunction << os.str().c_str() << "checkMesh -allGeometry -allTopology tells"
                             << " more of a mesh that OpenFOAM can read." << exit(FatalError);
    }
}

void Foam::mpm::checkMeshFiles(const Time& time)
{
    const word& handler = fileHandler().type();
    if (Pstream::parRun() && (handler == "collated" || handler == "hostCollated"))
    {
        FatalErrorInFunction << "fileHandler " << handler << ": points and the state of a run are"
                             << " files of each processor. Take  uncollated,  for decomposePar, too"
                             << " (-fileHandler, FOAM_FILEHANDLER, OptimisationSwitches of"
                             << " controlDict)." << exit(FatalError);
    }
    const word& dir = polyMesh::meshSubDir;
    const auto object = [&](const word& name, const word& instance)
    { return IOobject(name, instance, dir, time, IOobject::MUST_READ, IOobject::NO_WRITE, false); };
    const word ofPoints(time.findInstance(dir, "points"));
    const word ofFaces(time.findInstance(dir, "faces"));
    const word ofPatches(time.findInstance(dir, "boundary", IOobject::MUST_READ, ofFaces));

    // Without owners but with cells: a mesh of an old form
    if (!isFile(object("owner", ofFaces).objectPath())
        && object("cells", ofFaces).typeHeaderOk<cellCompactIOList>(false))
    {
        return;
    }

    const auto points = readList<pointIOField>(object("points", ofPoints));
    string problem = problemOfPoints(*points);
    const auto faces = readList<faceCompactIOList>(object("faces", ofFaces));
    if (problem.empty())
    {
        problem = problemOfFaces(*faces, points->size());
    }
    const auto owner = readList<labelIOList>(object("owner", ofFaces));
    const auto neighbour = readList<labelIOList>(object("neighbour", ofFaces));
    if (problem.empty())
    {
        problem = problemOfCells(*owner, *neighbour, faces->size());
    }
    const patchEntries entries(object("boundary", ofPatches));
    if (problem.empty())
    {
        problem =
            problemOfPatches(entries, nInternalFaces(*neighbour, faces->size()), faces->size());
    }
    refuseMesh(problem);

    string first(namesOfPatches(entries));
    const string own(first);
    Pstream::scatter(first);
    refuseMesh(
        own == first ? string()
                     : "File " + entries.objectPath() + " has the patches" + own
                + ", that of processor 0" + first);
}
