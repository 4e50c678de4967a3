/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    redistributeCase

Description
    Brings a decomposed case to another number of processors, or to another
    distribution: one written time, with all its fields, clouds and states, as
    it was read, bit by bit. No processor holds the whole case.

    The new number and the method are those of system/decomposeParDict, where
    weightField counts too. The program runs on as many processors as the
    larger of both numbers; the mesh moves by meshDistribution, what stands on
    it by rowsDistribution, as in loadBalance. The folders processor* of
    before go to processorsBefore. With  numberOfSubdomains 1;  the time goes to
    the case itself; a case that is not decomposed yet goes to several processors, where
    the decomposePar of OpenFOAM v1912 takes points times faces.

Usage
    \verbatim
    foamDictionary system/decomposeParDict -entry numberOfSubdomains -set 3
    mpirun -np 3 redistributeCase -parallel      # there were two
    \endverbatim

    Options:
      - -time \<value\>  the time (default: the last complete one)

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "caseRows.H"
#include "decompositionMethod.H"
#include "emptyProcessor.H"
#include "meshDistribution.H"
#include "rowsDistribution.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "Time.H"

using namespace Foam;
using namespace Foam::mpm;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const word before("processorsBefore");

dictionary contentsOf(const fileName& file)
{
    if (!isFile(file))
    {
        FatalErrorInFunction << "There is no file " << file << "." << exit(FatalError);
    }
    requireClosed(file);
    IFstream is(file);
    return dictionary(is);
}

//- Folder of the mesh of a time
word meshInstance(const fileName& path, const scalar time)
{
    const instantList times(Time::findTimes(path));
    for (label i = times.size() - 1; i >= 0; --i)
    {
        const fileName faces(path / times[i].name() / polyMesh::meshSubDir / "faces");
        if (times[i].name() != "constant" && times[i].value() <= time
            && (isFile(faces) || isFile(faces + ".gz")))
        {
            return times[i].name();
        }
    }
    return "constant";
}

//- A case that is not decomposed: one processor that has a copy of its mesh and its time.
//  False: it is, or has no such time
bool makeOneProcessor(const argList& args)
{
    const fileName root(args.rootPath() / args.globalCaseName()), path(root / "processor0");
    if (isDir(path))
    {
        return false;
    }
    const word wanted(args.getOrDefault<word>("time", word::null));
    const instantList times(Time::findTimes(root));
    for (label i = times.size() - 1; i >= 0; --i)
    {
        const word& name = times[i].name();
        const bool meant = wanted.empty() || name == wanted;
        if (name == "constant" || !meant
            || !(i < 2 || isFile(root / name / "uniform" / "materialPointState")))
        {
            continue;
        }
        const word mesh(meshInstance(root, times[i].value()));
        mkDir(path / mesh);
        cp(root / mesh / polyMesh::meshSubDir, path / mesh);
        if (mesh != name)
        {
            cp(root / name, path);
        }
        else
        {
            for (const fileName::Type type : {fileName::FILE, fileName::DIRECTORY})
            {
                for (const fileName& file : readDir(root / name, type, false))
                {
                    if (file != polyMesh::meshSubDir)
                    {
                        cp(root / name / file, path / name);
                    }
                }
            }
        }
        return true;
    }
    return false;
}

//- Number of processors that the case has; checks what there is. Collective
label nProcessors(const argList& args, const label nNew)
{
    const fileName root(args.rootPath() / args.globalCaseName());
    boolList has(Pstream::nProcs(), false);
    has[Pstream::myProcNo()] = isDir(args.path());
    Pstream::gatherList(has);
    Pstream::scatterList(has);
    const label n = has.find(false) < 0 ? has.size() : has.find(false);
    const auto folder = [](const label proci) { return "processor" + Foam::name(proci); };
    if (!Pstream::master())
    {
        return n;
    }
    if (!n)
    {
        FatalErrorInFunction << "There is no folder " << root / "processor0"
                             << ", and the case has no complete time"
                             << " that was asked for; fileHandler collated is not read here."
                             << exit(FatalError);
    }
    if (has.rfind(true) > n)
    {
        FatalErrorInFunction << "Of the processors " << has.rfind(true) + 1 << " there is no "
                             << folder(n) << " in " << root << "." << exit(FatalError);
    }
    label all = n;
    while (isDir(root / folder(all)))
    {
        ++all;
    }
    if (Pstream::nProcs() != max(all, nNew))
    {
        FatalErrorInFunction << "The case has " << all << " processors, system/decomposeParDict"
                             << " asks for " << nNew << ", but this runs on " << Pstream::nProcs()
                             << "." << nl << "Run  mpirun -np " << max(all, nNew)
                             << " redistributeCase -parallel" << exit(FatalError);
    }
    if (isDir(root / before))
    {
        FatalErrorInFunction
            << "There is a folder " << root / before << " already." << nl
            << "Remove it; if an earlier redistributeCase was interrupted, bring its"
            << " folders processor* back first." << exit(FatalError);
    }
    return n;
}

//- The time that was asked for, or the last complete one, on all processors that have files.
//  Collective
instant timeOf(const argList& args, const bool empty)
{
    instantList times(Time::findTimes(args.path()));
    Pstream::scatter(times);
    const word wanted(args.getOrDefault<word>("time", word::null));
    for (label i = times.size() - 1; i >= 0; --i)
    {
        const fileName folder(args.path() / times[i].name());
        const bool state = isFile(folder / "uniform" / "materialPointState");
        const bool here = returnReduce(empty || isDir(folder), andOp<bool>());
        const bool complete = returnReduce(empty || state, andOp<bool>());
        const bool begun = returnReduce(!empty && state, orOp<bool>());
        const bool meant = wanted.empty() || times[i].name() == wanted;
        if (times[i].name() != "constant" && meant && here && (complete || (!begun && i < 2)))
        {
            return times[i];
        }
    }
    wordList names;
    for (const instant& t : times)
    {
        names.append(t.name());
    }
    FatalErrorInFunction
        << (wanted.empty() ? string("No time") : string("Time " + wanted) + " is not")
        << " complete on all processors; processor0 has " << flatOutput(names) << exit(FatalError);
    return instant();
}

labelList newProcs(
    const fvMesh& mesh, const dictionary& dict, const caseRows& rows, const bool empty,
    const label nNew)
{
    if (nNew == 1)
    {
        return labelList(mesh.nCells(), Zero);
    }
    autoPtr<decompositionMethod> method(decompositionMethod::New(dict));
    if (!method->parallelAware())
    {
        FatalIOErrorInFunction(dict)
            << "method " << method->type() << " does not work in parallel; take another one,"
            << " for example  method hierarchical;" << exit(FatalIOError);
    }
    const word field(dict.getOrDefault<word>("weightField", word::null));
    const labelList to(method->decompose(
        mesh, field.empty() ? scalarField(mesh.nCells(), 1) : rows.cellValues(field, empty)));
    labelList cells(nNew, Zero);
    for (const label proci : to)
    {
        ++cells[proci];
    }
    Pstream::listCombineGather(cells, plusEqOp<label>());
    Pstream::listCombineScatter(cells);
    if (min(cells) < 1)
    {
        FatalIOErrorInFunction(dict) << "Processor " << cells.find(0) << " of " << nNew
                                     << " would have no cells." << exit(FatalIOError);
    }
    return to;
}

//- The old folders are put aside, those that were made for this run removed
void putAside(const argList& args, const bool made)
{
    const fileName path(args.path());
    if (made)
    {
        rmDir(path);
    }
    else
    {
        const fileName aside(args.rootPath() / args.globalCaseName() / before);
        mkDir(aside);
        mv(path, aside / path.name());
    }
}

}

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    exitOnFatal();
    argList::addNote("Bring a case, decomposed or not, to the number of processors and the method"
                     " of system/decomposeParDict. Runs on the larger of both numbers.");
    argList::noFunctionObjects();
    argList::noCheckProcessorDirectories();
    argList::addOption("time", "value", "Time to take (default: the last complete one)");
    const argList args(argc, argv);
    if (!Pstream::parRun())
    {
        FatalErrorInFunction << "Run  mpirun -np N redistributeCase -parallel  with N the larger of"
                             << " the numbers of processors before and after." << exit(FatalError);
    }
    const fileName root(args.rootPath() / args.globalCaseName());
    const dictionary dict(contentsOf(root / "system" / "decomposeParDict"));
    const label nNew = required<label>(dict, "numberOfSubdomains");
    if (nNew < 1)
    {
        FatalIOErrorInFunction(dict)
            << "numberOfSubdomains is " << nNew << "; it must be 1 or more." << exit(FatalIOError);
    }
    bool whole = Pstream::master() && nNew > 1 && makeOneProcessor(args);
    Pstream::scatter(whole);
    label nOld = nProcessors(args, nNew);
    Pstream::scatter(nOld);
    const bool empty = Pstream::myProcNo() >= nOld;

    if (isFile(root / "system" / "adaptiveMeshDict"))
    {
        FatalErrorInFunction << "There is " << root / "system" / "adaptiveMeshDict"
                             << ": the trees of an adaptive mesh stay on their processors."
                             << exit(FatalError);
    }

    // The last time may not be the same on all processors
    const instant start(timeOf(args, empty));
    dictionary control(contentsOf(root / "system" / "controlDict"));
    control.set("startFrom", word("startTime"));
    control.set("startTime", start.value());
    Time runTime(control, args.rootPath(), args.caseName());
    runTime.setTime(start, 0);
    if (nNew == 1 && isDir(root / start.name()))
    {
        FatalErrorInFunction << "The case has a folder " << root / start.name() << " already."
                             << exit(FatalError);
    }
    Info << "Time " << start.name() << ": " << nOld << " processors to " << nNew << nl << endl;

    word instance(meshInstance(args.path(), start.value()));
    Pstream::scatter(instance);
    writeEmptyProcessor(runTime, instance, empty);
    fvMesh mesh(IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));
    addEmptyZones(mesh, empty);
    meshDistribution distribution(whole ? meshDistribution(mesh, zero()) : meshDistribution(mesh));
    caseRows rows(mesh, empty);
    const label nPoints = returnReduce(rows.nPoints(), sumOp<label>());
    if (rows.left().size())
    {
        WarningInFunction << "Left behind, of classes that are not known here: "
                          << flatOutput(rows.left()) << endl;
    }

    const labelList to(newProcs(mesh, dict, rows, empty, nNew));
    rowsDistribution with(mesh, to);
    const meshDistribution::maps maps(distribution.move(to));
    with.move(rows.rows(), maps);
    if (returnReduce(rows.nPoints(), sumOp<label>()) != nPoints)
    {
        FatalErrorInFunction << "Points were lost; nothing is changed on disk." << exit(FatalError);
    }

    putAside(args, empty || whole);
    returnReduce(label(0), sumOp<label>());
    distribution.write(runTime.constant());
    rows.write();
    returnReduce(label(0), sumOp<label>());
    if (Pstream::myProcNo() >= nNew)
    {
        rmDir(args.path());
    }
    if (nNew == 1 && Pstream::master())
    {
        mv(args.path() / start.name(), root / start.name());
        rmDir(args.path());
    }
    Info << nPoints << " points on " << nNew << (nNew > 1 ? " processors" : " processor") << nl;
    if (!whole)
    {
        Info << "The folders of before are in " << before << ": remove it if all is well" << nl;
    }
    Info << "End\n" << endl;
    return 0;
}
