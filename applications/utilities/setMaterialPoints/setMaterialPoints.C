/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    setMaterialPoints

Description
    Fills regions of the mesh with material points: the setFields of points.

    Each cell is divided into pointsPerCell sub-cells; of each that lies in the
    region's shape a point gets the part in the shape, exactly, and is put so
    that it does not stick out of it (pointRegion.H). Points go to
    lagrangian/<phase> of the start time, in the order of regions, cells and
    sub-cells, in place of what was there. A table compares their volume with
    that of the shape.

Usage
    \b setMaterialPoints [OPTION]

    Options:
      - \par -dict \<file\>
        Read this file instead of system/setMaterialPointsDict

      - \par -cellWeights
        Also write the field cellWeights, for decomposeParDict

      - \par -count
        Only print the table; write nothing

      - \par -force
        Also in a time that a run has written: its points are lost, and what it
        has summed up of them

    Example of system/setMaterialPointsDict:
    \verbatim
    regions
    {
        flyer
        {
            phase           flyer;
            type            box;
            min             (0 0.0038 0);
            max             (0.02 0.0057 1);
            pointsPerCell   (2 2 1);
            velocity        (0 -100 0);
        }
    }
    \endverbatim

    Entries of a region:
    \table
        Property       | Description                    | Required | Default
        phase          | one of phases (phaseProperties) | yes     |
        type           | shape, see below               | yes      |
        pointsPerCell  | per direction, 1 to 16         | yes      |
        parts          | exact or sampled               | no       | exact
        samples        | of parts sampled, 1 to 8       | no       | 1
        velocity       | [m/s], or a dictionary         | no       | (0 0 0)
        stress         | (xx xy xz yy yz zz) [Pa] or ambient | no  | 0
        pressure       | only with stress ambient [Pa]  | no       |
        temperature    | [K]; of phases with heatTransfer | yes    |
        volumeFraction | factor of the volume, (0, 1]   | no       | 1
        density        | for the mass [kg/m3]           | no       | rho of law
        overlap        | allow or forbid                | no       | forbid
    \endtable

    pointsPerCell is a number or a vector; its entries of empty directions are
    ignored. With stress ambient the stress is that of the pressure. Regions of
    rigid phases have neither velocity nor stress. Regions whose phases share a
    velocity field must not overlap, unless one of them allows it.

    On meshes with cells that are no hexahedra, and of the elements of a mesh,
    pointsPerCell is 1 (centroid), 2 (a point for each corner) or n from 3 on:
    a triangle (n - 1)^2 and a tetrahedron (n - 1)^3 equal parts, other cells
    simplices of (n/2)^nDim each (simplexParts.H).

    Mass and outline of all shapes are exact on all meshes, in a gas too
    (pointRegion.H). With parts sampled sub-cells are whole: those whose centre,
    or any of samples^nDim positions, lies in the shape.

    Entries of the dictionary velocity, which are added up:
    \verbatim
        velocity
        {
            uniform     (1 0 0);
            omega       20;             // [rad/s]
            axis        (0 0 1);
            origin      (0.5 0.5 0);
            x           table ((0 (0 0 0)) (1 (0 3 0)));
        }
    \endverbatim
    with x, y and z any Function1 of that coordinate.

    Shapes and their entries:
    \table
        Type     | Entries
        box      | min, max
        sphere   | centre, radius, innerRadius 0 (a disc or ring in 2D)
        cylinder | point1, point2, radius, innerRadius 0
        cellZone | zone
        cells    | none: all cells
        mesh     | file, group all, scale 1 (points of its elements)
        surface  | surface { type triSurfaceMesh; file "body.stl"; scale 1; }
        union, intersection, difference | shapes { a { type ...; } b { ... } }
    \endtable

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fvMesh.H"
#include "volFields.H"
#include "Time.H"
#include "polyMesh.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "PtrList.H"
#include "materialPointPhase.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "meshCheck.H"
#include "version.H"
#include "noTraps.H"
#include "regionTable.H"
#include "phaseNames.H"
#include "fullPrecision.H"
#include "IFstream.H"
#include "OFstream.H"

using namespace Foam;
using namespace Foam::mpm;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void checkFiles(const Time& time, const argList& args)
{
    requireCaseFile(time, "constant/phaseProperties");
    if (!args.found("dict"))
    {
        requireCaseFile(time, "system/setMaterialPointsDict");
    }
}

//- The phases, without points
void readPhases(const pointGrid& grid, const dictionary& dict, PtrList<materialPointPhase>& phases)
{
    const wordList names(materialPointPhase::names(dict));
    if (names.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No phase has the type materialPoints." << exit(FatalIOError);
    }

    phases.setSize(names.size());
    forAll(names, i)
    {
        phases.set(i, new materialPointPhase(grid, names[i], requiredDict(dict, names[i]), true));
    }
}

wordList namesOf(const PtrList<materialPointPhase>& phases)
{
    wordList names(phases.size());
    forAll(phases, i)
    {
        names[i] = phases[i].name();
    }
    return names;
}

//- The regions with their points
void readRegions(
    const pointGrid& grid, const dictionary& dict, const PtrList<materialPointPhase>& phases,
    const bool inGas, PtrList<pointRegion>& regions)
{
    const wordList names(namesOf(phases));

    const auto phaseOf = [&](const pointRegion& r) -> const materialPointPhase&
    { return phases[names.find(r.phase())]; };

    const auto sameField = [&](const pointRegion& a, const pointRegion& b)
    { return phaseOf(a).velocityField() == phaseOf(b).velocityField(); };

    const dictionary& regionsDict = requiredDict(dict, "regions");
    const wordList keys(regionsDict.toc());
    if (keys.empty())
    {
        FatalIOErrorInFunction(regionsDict) << "There are no regions." << exit(FatalIOError);
    }

    regions.setSize(keys.size());
    forAll(keys, i)
    {
        if (!regionsDict.isDict(keys[i]))
        {
            FatalIOErrorInFunction(regionsDict)
                << "Region " << keys[i] << " is not a dictionary; write  " << keys[i]
                << " { phase ...; type ...; }" << exit(FatalIOError);
        }
        regions.set(i, new pointRegion(grid, requiredDict(regionsDict, keys[i]), names, inGas));
        pointRegion& region = regions[i];
        const materialPointPhase& phase = phaseOf(region);

        if (phase.motion())
        {
            // The motion says what the velocity is, and there is no stress
            const dictionary& regionDict = regionsDict.subDict(keys[i]);
            for (const word key : {"velocity", "stress", "pressure"})
            {
                if (regionDict.found(key))
                {
                    FatalIOErrorInFunction(regionDict)
                        << "Entry " << key << " in region " << keys[i] << ": phase " << phase.name()
                        << " is rigid; its"
                        << " motion in constant/phaseProperties gives the"
                        << " velocity, and it has no stress." << exit(FatalIOError);
                }
            }
        }
        region.setReferencePressure(phase.referencePressure());
        region.checkTemperature(phase.cloud().temperature());
        for (label j = 0; j < i; ++j)
        {
            if (sameField(regions[j], region))
            {
                region.join(regions[j]);
            }
        }
    }

    forAll(regions, i)
    {
        regions[i].create(phaseOf(regions[i]).rho());
        for (label j = 0; j < i; ++j)
        {
            if (sameField(regions[j], regions[i]))
            {
                regions[i].checkOverlap(regions[j]);
            }
        }
    }
}

//- Points of all regions of a phase, in the order of the regions
DynamicList<materialPointCloud::newPoint>
pointsOf(const materialPointPhase& phase, const PtrList<pointRegion>& regions)
{
    DynamicList<materialPointCloud::newPoint> points;
    forAll(regions, i)
    {
        if (regions[i].phase() == phase.name())
        {
            points.append(regions[i].points());
        }
    }
    return points;
}

//- Write the number of points of each cell for decomposePar: processors get
//  equal sums. An empty cell counts a little, so that meshes without points
//  are shared as well
void writeCellWeights(const fvMesh& mesh, const PtrList<materialPointPhase>& phases)
{
    constexpr scalar emptyCell = 0.02;

    volScalarField weights(
        IOobject(
            "cellWeights", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE,
            false),
        mesh, dimensionedScalar("emptyCell", dimless, emptyCell));
    for (const materialPointPhase& phase : phases)
    {
        const materialPointCloud& cloud = phase.cloud();
        forAll(cloud.cells(), k)
        {
            weights[cloud.cells()[k]] += cloud.start()[k + 1] - cloud.start()[k];
        }
    }
    Info << "Writing " << weights.objectPath() << endl;
    weights.write();
}

//- Fatal if points of a run would be lost
void checkTime(const Time& time, const bool force)
{
    const fileName state(time.timePath() / "uniform" / "materialPointState");
    if (isFile(state) && !force)
    {
        FatalErrorInFunction << "Time " << time.timeName() << " has been written by a run ("
                             << state << "): its points would be lost." << nl
                             << "For a new start set  startFrom startTime;  in"
                             << " system/controlDict, or remove the times of the last run."
                             << " setMaterialPoints -force replaces them." << exit(FatalError);
    }
    if (isDir(time.rootPath() / time.globalCaseName() / "processor0"))
    {
        WarningInFunction << "The case is decomposed: the points of processor0 and others"
                          << " stay as they are. decomposePar -force takes the new ones." << endl;
    }
}

//- Sums, bodies and budgets that a run has written are those of its points
void forgetPoints(const Time& time)
{
    const fileName file(time.timePath() / "uniform" / "materialPointState");
    if (!isFile(file))
    {
        return;
    }
    IFstream is(file);
    dictionary state(is);
    state.remove("points");
    state.set("newPoints", true);

    const fullPrecision allDigits;
    OFstream os(file);
    os.precision(17);
    state.write(os, false);
}

//- Write the points in place of those that were there
void write(materialPointPhase& phase, const PtrList<pointRegion>& regions)
{
    const Time& time = phase.cloud().time();
    const fileName folder(time.timePath() / cloud::prefix / phase.name());
    if (isDir(folder))
    {
        rmDir(folder);
    }

    phase.cloud().add(pointsOf(phase, regions));
    phase.startHistory();

    if (phase.cloud().size())
    {
        Info << "Writing " << folder << endl;
        phase.cloud().writePoints();
    }
    else
    {
        WarningInFunction << "Phase " << phase.name() << " has no points: no region of"
                          << " setMaterialPointsDict names it." << endl;
    }
}

}

// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    exitOnFatal();

    argList::addNote("Fill regions of the mesh with material points, as"
                     " system/setMaterialPointsDict says, and write them to"
                     " lagrangian/<phase> of the start time; the phases are those of"
                     " constant/phaseProperties. Serial only; decomposePar distributes"
                     " the points.");
    argList::addNote(version);
    argList::noParallel();
    argList::addOption("dict", "file", "Read this file instead of system/setMaterialPointsDict");
    argList::addBoolOption(
        "cellWeights",
        "Also write the field cellWeights (points per cell) for weightField in"
        " decomposeParDict");
    argList::addBoolOption(
        "count", "Only print the table of points, mass and volume; write nothing");
    argList::addBoolOption("force", "Put points in place of those that a run has written");

#include "setRootCase.H"
    checkControlDict(args.rootPath() / args.globalCaseName() / "system" / "controlDict");
#include "createTime.H"

    if (!args.found("count"))
    {
        checkTime(runTime, args.found("force"));
    }

    // fvSchemes and fvSolution are wanted only for a field
    const bool withWeights = args.found("cellWeights");
    const IOobject meshObject(
        polyMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ);
    Info << "Create mesh for time = " << runTime.timeName() << nl << endl;
    checkMeshFiles(runTime);
    const autoPtr<polyMesh> meshPtr(
        withWeights ? new fvMesh(meshObject) : new polyMesh(meshObject));
    const polyMesh& mesh = *meshPtr;
    checkMesh(mesh);

    // Shapes may be as large as they like: what overflows is found by name
    const noTraps guard;

    const word dictName("setMaterialPointsDict");
#include "setSystemMeshDictionaryIO.H"

    const pointGrid& grid = pointGrid::New(mesh);

    checkFiles(runTime, args);
    const IOdictionary phaseProperties(
        IOobject("phaseProperties", runTime.constant(), mesh, IOobject::MUST_READ));
    requireClosed(phaseProperties.objectPath());
    PtrList<materialPointPhase> phases;
    readPhases(grid, phaseProperties, phases);

    Info << "Reading " << dictIO.objectPath() << nl << endl;
    const IOdictionary dict(dictIO);
    requireClosed(dict.objectPath());
    PtrList<pointRegion> regions;
    const bool inGas = phaseNames(phaseProperties, {"gas", "fluid"}).size();
    readRegions(grid, dict, phases, inGas, regions);

    printTable(namesOf(phases), regions);
    printStart(phaseProperties, phases, regions);

    if (!args.found("count"))
    {
        forAll(phases, i)
        {
            write(phases[i], regions);
        }
        forgetPoints(runTime);
        if (withWeights)
        {
            writeCellWeights(refCast<const fvMesh>(mesh), phases);
        }
    }

    Info << nl << "End" << nl << endl;

    return 0;
}
