/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    adaptMesh

Description
    Halves the cells of a new mesh where system/adaptiveMeshDict wants them fine at
    the start: in its shapes, where setMaterialPointsDict will put points
    and around the shapes of setFluidsDict. To be run after the
    mesh has been made and before setFluids and setMaterialPoints; the run goes
    on from there.

Usage
    \b adaptMesh

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "adaptiveMesh.H"
#include "fatalMessages.H"
#include "meshCheck.H"
#include "pointGrid.H"
#include "Time.H"
#include "version.H"

using namespace Foam;
using namespace Foam::mpm;

int main(int argc, char* argv[])
{
    exitOnFatal();

    argList::addNote("Halve the cells of a new mesh where system/adaptiveMeshDict wants them fine"
                     " at the start. To be run before setFluids and setMaterialPoints. Serial"
                     " only.");
    argList::addNote(version);
    argList::noParallel();

#include "setRootCase.H"
    checkControlDict(args.rootPath() / args.globalCaseName() / "system" / "controlDict");
#include "createTime.H"

    requireCaseFile(runTime, "system/adaptiveMeshDict");
    Info << "Create mesh for time = " << runTime.timeName() << nl << endl;
    checkMeshFiles(runTime);
    polyMesh mesh(
        IOobject(polyMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));
    checkMesh(mesh);
    adaptiveMesh adaptive(mesh);

    Info << "Cells of the base mesh: " << adaptive.leaves().base().size() << nl;
    const fileName instance(mesh.facesInstance());
    for (label i = 0; i < adaptive.maxLevel(); ++i)
    {
        adaptive.look(true, true);
        autoPtr<treeLeaves> to(adaptive.next());
        if (!to)
        {
            break;
        }
        adaptive.make(std::move(to));
        pointGrid::Delete(mesh);
        Info << "Cells after " << i + 1 << (i ? " times: " : " time:  ") << mesh.nCells() << nl;
    }
    adaptive.write(instance);

    Info << nl << "End" << nl << endl;

    return 0;
}
