/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    materialPointFoam

Description
    Explicit dynamics of solids that break, flow and hit each other: material
    points over a fixed mesh; of a gas on the mesh; or of both.

    The time step follows the Courant number of waves and points,
    dt max((|u| + c)/h) <= maxCo, and is redone smaller where a point would
    travel too far or be strained too much; nothing has changed then.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "loadBalance.H"
#include "meshAdaptation.H"
#include "simulation.H"
#include "timeStepControl.H"
#include "fatalMessages.H"
#include "meshCheck.H"
#include "version.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    mpm::exitOnFatal();

    argList::addNote("Material points (solids that break, flow and hit each other) on"
                     " OpenFOAM's mesh.");
    argList::addNote(mpm::version);

#define CREATE_TIME createCheckedTime.H
#include "postProcess.H"

#include "addCheckCaseOptions.H"
#include "setRootCaseLists.H"
    Info << mpm::version << nl << endl;
    mpm::checkControlDict(args.rootPath() / args.globalCaseName() / "system" / "controlDict");
    mpm::timeStepControl::setAsideIncomplete(args);
#include "createTime.H"

    // Not createMesh.H: -dry-run checks the case on its own mesh
    Info << "Create mesh for time = " << runTime.timeName() << nl << endl;
    mpm::checkMeshFiles(runTime);
    fvMesh mesh(IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));
    mpm::checkMesh(mesh);

#include "createFields.H"
    mpm::timeStepControl control(runTime, simulation);
    if (control.dryRun(args))
    {
        return 0;
    }

    Info << "\nStarting time loop\n" << endl;

    mpm::meshAdaptation adaptation(mesh);
    mpm::loadBalance balance(mesh, adaptation);
    adaptation.update(simulation);
    control.setDeltaT();
    while (runTime.run())
    {
        if (control.rebuilds())
        {
            simulation = mpm::simulation(mesh, simulation.takeDown());
        }
        adaptation.update(simulation);
        balance.update(simulation);
        simulation.readModified();

        // Equations (5) to (9) of the paper, then stress (section 3.1)
        scalar factor = 1;
        control.announce();
        simulation.severalSteps(control.nSub() > 1);
        simulation.severalOfGas(control.severalOfGas(), control.gasDeltaT());
        while (control.pointsLeft())
        {
            if (!simulation.advancePoints(control.pointStep(), factor))
            {
                control.redo(factor);
                control.announce();
                continue;
            }
            control.pointsDone();
            if (simulation.hasRemoved() && control.pointsLeft())
            {
                simulation.advanceGas(control.startGas());
                control.gasDone();
                simulation.correct();
            }
        }
        while (control.gasStepsLeft())
        {
            const scalar dt = control.startGas();
            simulation.advanceGas(dt, control.gasShare(), control.lastOfGas());
            control.gasDone();
            if (control.gasStepsLeft())
            {
                simulation.correct();
            }
        }
        control.endStep();

        ++runTime;
        control.showGasStep(true);
        simulation.correct();
        control.showGasStep(false);
        if (control.reports())
        {
            control.printTime();
            simulation.report();
        }
        if (runTime.writeTime())
        {
            simulation.write();
            balance.write();
            adaptation.write();
        }
        runTime.write();
        if (runTime.writeTime())
        {
            control.writeState();
        }
        control.report();
        control.setDeltaT();
    }
    simulation.reportClock();
    adaptation.report();
    control.end();

    return 0;
}
