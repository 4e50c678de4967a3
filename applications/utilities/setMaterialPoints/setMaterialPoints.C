/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Application
    setMaterialPoints

Group
    grpPreProcessingUtilities

Description
    Fills regions of the mesh with material points: the setFields of points.

    Each cell is divided into pointsPerCell sub-cells; a point stands at the
    centre of each sub-cell that lies in the region's shape. Points go to
    lagrangian/<phase> of the start time, in the order of regions, cells and
    sub-cells, in place of what was there. A table compares their volume with
    that of the shape.

Usage
    \b setMaterialPoints [OPTION]

    Options:
      - \par -dict \<file\>
        Read this file instead of system/setMaterialPointsDict

      - \par -count
        Only print the table; write nothing

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
        Property       | Description                            | Required | Default
        phase          | one of phases in phaseProperties       | yes      |
        type           | shape, see below                       | yes      |
        pointsPerCell  | points per direction, 1 to 16: a number or a vector; entries of empty directions are ignored | yes |
        samples        | positions per direction of a sub-cell, 1 to 8: their part inside the shape multiplies the volume | no | 1
        velocity       | velocity [m/s]                         | no       | (0 0 0)
        stress         | (xx xy xz yy yz zz) [Pa], or ambient: minus pressure | no | zero
        pressure       | with stress ambient [Pa]               | no       |
        volumeFraction | factor of volume and mass, (0, 1]      | no       | 1
        density        | for the mass, instead of the law's rho [kg/m3] | no | rho
        overlap        | allow: share places with other regions | no       | forbid
    \endtable

    Shapes and their entries:
    \table
        Type     | Entries
        box      | min, max
        sphere   | centre, radius (a disc in 2D)
        cylinder | point1, point2, radius
        cellZone | zone
        cells    | none: all cells
        surface  | surface { type triSurfaceMesh; file "body.stl"; }
    \endtable

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "polyMesh.H"
#include "IOdictionary.H"
#include "IOmanip.H"
#include "StringStream.H"
#include "OSspecific.H"
#include "PtrList.H"
#include "materialPointPhase.H"
#include "pointRegion.H"

using namespace Foam;
using namespace Foam::mpm;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

IOobject dictionaryObject
(
    const polyMesh& mesh,
    const fileName& name,
    const fileName& instance
)
{
    return IOobject
    (
        name,
        instance,
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


//- The phases, without points
void readPhases
(
    const hexGrid& grid,
    const dictionary& dict,
    PtrList<materialPointPhase>& phases
)
{
    const wordList names(dict.get<wordList>("phases"));

    phases.setSize(names.size());
    forAll(names, i)
    {
        phases.set
        (
            i,
            new materialPointPhase(grid, names[i], dict.subDict(names[i]), true)
        );
    }
}


//- The regions with their points
void readRegions
(
    const hexGrid& grid,
    const dictionary& dict,
    const PtrList<materialPointPhase>& phases,
    PtrList<pointRegion>& regions
)
{
    wordList names(phases.size());
    forAll(phases, i)
    {
        names[i] = phases[i].name();
    }

    const auto phaseOf = [&](const pointRegion& r) -> const materialPointPhase&
    {
        return phases[names.find(r.phase())];
    };

    const dictionary& regionsDict = dict.subDict("regions");
    const wordList keys(regionsDict.toc());
    if (keys.empty())
    {
        FatalIOErrorInFunction(regionsDict)
            << "There are no regions." << exit(FatalIOError);
    }

    regions.setSize(keys.size());
    forAll(keys, i)
    {
        if (!regionsDict.isDict(keys[i]))
        {
            FatalIOErrorInFunction(regionsDict)
                << "Region " << keys[i] << " is no dictionary; write  "
                << keys[i] << " { phase ...; type ...; }"
                << exit(FatalIOError);
        }
        regions.set
        (
            i,
            new pointRegion(grid, regionsDict.subDict(keys[i]), names)
        );
        pointRegion& region = regions[i];
        const materialPointPhase& phase = phaseOf(region);

        region.create(phase.law().rho());

        for (label j = 0; j < i; ++j)
        {
            if (phaseOf(regions[j]).velocityField() == phase.velocityField())
            {
                region.checkOverlap(regions[j]);
            }
        }
    }
}


//- Points of all regions of a phase, in the order of the regions
DynamicList<materialPointCloud::newPoint> pointsOf
(
    const materialPointPhase& phase,
    const PtrList<pointRegion>& regions
)
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


//- A line of the table; a negative volume is not known
void printLine
(
    const std::string& region,
    const word& phase,
    const label nPoints,
    const scalar mass,
    const scalar volume,
    const scalar exactVolume
)
{
    const auto padded = [](std::string s)
    {
        s.resize(max(s.size(), std::size_t(15)), ' ');
        return s + ' ';
    };

    OStringStream line;
    line.precision(6);
    line<< "    " << padded(region).c_str() << padded(phase).c_str()
        << setw(10) << nPoints << setw(14) << mass << setw(14) << volume;
    if (exactVolume > 0)
    {
        line<< setw(14) << exactVolume
            << setw(14) << (volume - exactVolume)/exactVolume;
    }
    else
    {
        line<< setw(14) << "n/a" << setw(14) << "n/a";
    }
    Info<< line.str().c_str() << nl;
}


void printTable
(
    const PtrList<materialPointPhase>& phases,
    const PtrList<pointRegion>& regions
)
{
    Info<< "    region          phase               points     mass [kg]"
        << "   volume [m3]    exact [m3]    difference" << nl;

    forAll(regions, i)
    {
        const pointRegion& r = regions[i];
        printLine
        (
            r.name(), r.phase(), r.points().size(), r.mass(), r.volume(),
            r.exactVolume()
        );
    }
    Info<< nl;

    forAll(phases, i)
    {
        label n = 0;
        scalar mass = 0, volume = 0, exact = 0;
        forAll(regions, j)
        {
            const pointRegion& r = regions[j];
            if (r.phase() == phases[i].name())
            {
                n += r.points().size();
                mass += r.mass();
                volume += r.volume();
                const scalar v = r.exactVolume();
                exact = v < 0 || exact < 0 ? -1 : exact + v;
            }
        }
        printLine("total", phases[i].name(), n, mass, volume, exact);
    }
    Info<< endl;
}


//- Write the points in place of those that were there
void write(materialPointPhase& phase, const PtrList<pointRegion>& regions)
{
    const Time& time = phase.cloud().time();
    const fileName folder
    (
        time.timePath()/cloud::prefix/phase.name()
    );
    if (isDir(folder))
    {
        rmDir(folder);
    }

    phase.cloud().add(pointsOf(phase, regions));

    if (phase.cloud().size())
    {
        Info<< "Writing " << folder << endl;
        phase.cloud().writePoints();
    }
    else
    {
        WarningInFunction
            << "Phase " << phase.name() << " has no points: no region of"
            << " setMaterialPointsDict names it." << endl;
    }
}

}

// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Fill regions of the mesh with material points, as"
        " system/setMaterialPointsDict says, and write them to"
        " lagrangian/<phase> of the start time; the phases are those of"
        " constant/phaseProperties. Serial only; decomposePar distributes"
        " the points."
    );
    argList::noParallel();
    argList::addOption
    (
        "dict",
        "file",
        "Read this file instead of system/setMaterialPointsDict"
    );
    argList::addBoolOption
    (
        "count",
        "Only print the table of points, mass and volume; write nothing"
    );

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    const word dictName("setMaterialPointsDict");
    #include "setSystemMeshDictionaryIO.H"

    const hexGrid& grid = hexGrid::New(mesh);

    const IOdictionary phaseProperties
    (
        dictionaryObject(mesh, "phaseProperties", runTime.constant())
    );
    PtrList<materialPointPhase> phases;
    readPhases(grid, phaseProperties, phases);

    Info<< "Reading " << dictIO.objectPath() << nl << endl;
    const IOdictionary dict(dictIO);
    PtrList<pointRegion> regions;
    readRegions(grid, dict, phases, regions);

    printTable(phases, regions);

    if (!args.found("count"))
    {
        forAll(phases, i)
        {
            write(phases[i], regions);
        }
    }

    Info<< nl << "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
