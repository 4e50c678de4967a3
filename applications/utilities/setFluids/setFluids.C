/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    setFluids

Description
    Fills the cells with fluids (phases of type fluid): shapes give each cell
    its exact share of them.

    Writes p, U, alpha.<fluid>, T.<gas> or rho.<fluid> of all fluids to the
    start time. Files that are there keep their boundary conditions; others get
    slip (U on walls) and zeroGradient, p and U farField where the other's file
    has it. A table compares volume and mass of each
    region with those of its shape (fluidStart.H).

Usage
    \b setFluids [OPTION]

    Options:
      - \par -dict \<file\>
        Read this file instead of system/setFluidsDict

      - \par -count
        Only print the table; write nothing

    Example of system/setFluidsDict:
    \verbatim
    default { fluid air; T 300; }

    // p of the default, or
    hydrostatic { point (0 0.5 0); p 1e5; }

    regions
    {
        column { type box; min (0 0 0); max (0.1 0.2 1); fluid water; }
        charge
        {
            type sphere; centre (0.3 0.1 0); radius 0.02;
            fluid products; mass 1; p 8.4e9;
        }
    }
    \endverbatim

    Entries of default and of a region:
    \table
        Property | Description                           | Required | Default
        fluid    | one of the phases of type fluid       | yes      |
        type     | shape, with its entries; of a region  | yes      |
        p        | [Pa]                          | no | hydrostatic, default
        T        | of a perfectGas [K]           | this, rho or mass |
        rho      | [kg/m3]                       | no | rho of the phase
        mass     | of what the mesh has of the region [kg] | no |
        U        | [m/s]                         | no       | (0 0 0)
    \endtable

    Shapes are those of setMaterialPoints: box, sphere, cylinder, cellZone,
    cells, mesh, surface, union, intersection, difference. Later regions lie on
    top of those before. mass is that of the mesh: of the sector on a wedge, of
    the thickness in 2D.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "cloud.H"
#include "fvMesh.H"
#include "Time.H"
#include "IOdictionary.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "fluidStart.H"
#include "meshCheck.H"
#include "noTraps.H"
#include "phaseNames.H"
#include "uniformDimensionedFields.H"
#include "version.H"

using namespace Foam;
using namespace Foam::mpm;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Fatal if a run would not take the new fields
void checkTime(const Time& time)
{
    const fileName state(time.timePath() / "thetaRhoU");
    if (isFile(state) || isFile(state + ".gz"))
    {
        FatalErrorInFunction << "Time " << time.timeName() << " has been written by a run ("
                             << state << "), which takes its state from there." << nl
                             << "For a new start set  startFrom startTime;  in"
                             << " system/controlDict, or remove the times of the last run."
                             << exit(FatalError);
    }
    if (isDir(time.rootPath() / time.globalCaseName() / "processor0"))
    {
        WarningInFunction << "The case is decomposed: the fields of processor0 and others"
                          << " stay as they are. decomposePar -force takes the new ones." << endl;
    }
}

//- Warn of points that have been made before
void checkPoints(const Time& time, const dictionary& phaseProperties)
{
    DynamicList<word> there;
    for (const word& name : phaseNames(phaseProperties, {"materialPoints"}))
    {
        if (isDir(time.timePath() / cloud::prefix / name))
        {
            there.append(name);
        }
    }
    if (there.size())
    {
        WarningInFunction << "The points of " << flatOutput(there) << " at time " << time.timeName()
                          << " were made before these fluids: they have not"
                          << " been compared with their pressure. Run setMaterialPoints"
                          << " after setFluids." << endl;
    }
}

vector gravity(const fvMesh& mesh)
{
    const IOobject header(
        "g", mesh.time().constant(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    IOobject file(header);
    if (!file.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        return Zero;
    }
    const vector g(uniformDimensionedVectorField(header).value());
    checkGravity(header.objectPath(), g, mesh.geometricD());
    return g;
}

IOdictionary read(const IOobject& io)
{
    IOdictionary dict(io);
    requireClosed(dict.objectPath());
    return dict;
}

}

// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    exitOnFatal();

    argList::addNote("Fill the cells with fluids, as system/setFluidsDict says, and write"
                     " p, U, alpha, T and rho to the start time; the fluids are the phases"
                     " of type fluid of constant/phaseProperties. Serial only; decomposePar"
                     " distributes the fields.");
    argList::addNote(version);
    argList::noParallel();
    argList::addOption("dict", "file", "Read this file instead of system/setFluidsDict");
    argList::addBoolOption("count", "Only print the table of volume and mass; write nothing");

#include "setRootCase.H"
    checkControlDict(args.rootPath() / args.globalCaseName() / "system" / "controlDict");
#include "createTime.H"

    if (!args.found("count"))
    {
        checkTime(runTime);
    }
    requireCaseFile(runTime, "constant/phaseProperties");
    if (!args.found("dict"))
    {
        requireCaseFile(runTime, "system/setFluidsDict");
    }
    Info << "Create mesh for time = " << runTime.timeName() << nl << endl;
    checkMeshFiles(runTime);
    const fvMesh mesh(
        IOobject(polyMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));
    checkMesh(mesh);

    // Shapes may be as large as they like
    const noTraps guard;

    const word dictName("setFluidsDict");
#include "setSystemMeshDictionaryIO.H"

    const IOdictionary phaseProperties(
        read(IOobject("phaseProperties", runTime.constant(), mesh, IOobject::MUST_READ)));
    const wordList names(phaseNames(phaseProperties, {"fluid"}));
    if (names.empty())
    {
        FatalIOErrorInFunction(phaseProperties)
            << "No phase has the type fluid: there is nothing to fill cells"
            << " with. The files of a phase of type gas are written by hand, or"
            << " by OpenFOAM's setFields." << exit(FatalIOError);
    }
    Info << "Reading " << dictIO.objectPath() << nl << endl;
    const IOdictionary dict(read(dictIO));

    if (!args.found("count"))
    {
        checkPoints(runTime, phaseProperties);
    }
    const fluidStart start(mesh, phaseProperties, names, dict, gravity(mesh));
    start.printTable();
    if (!args.found("count"))
    {
        start.write();
    }

    Info << nl << "End" << nl << endl;

    return 0;
}
