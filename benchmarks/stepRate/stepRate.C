/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    stepRate

Description
    Time steps of a case without output, and what they cost: material-point
    steps per second, the share of each part of the step, bytes per point.
    The case has its points already (setMaterialPoints); deltaT is constant.

    With -parallel the rate is that of all processors together.

    Rates are best of -repeat runs of -steps steps, after -warmup steps. They are
    those of the clock on the wall; with -cpuTime those of the processor's
    time, for comparisons on a machine that has other work.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "materialPointSystem.H"
#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

//- Largest resident memory of this process so far [kB]; 0 if the system does
//  not tell
label peakMemory()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
    {
        if (line.compare(0, 6, "VmHWM:") == 0)
        {
            return label(std::stol(line.substr(6)));
        }
    }
    return 0;
}

//- Seconds, of this process' own or since some time
scalar seconds(const bool ofProcessor)
{
    if (ofProcessor)
    {
        return scalar(std::clock()) / CLOCKS_PER_SEC;
    }
    return std::chrono::duration<scalar>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}

int main(int argc, char* argv[])
{
    argList::addNote("Speed of the time step on the case's points");
    argList::addOption("steps", "N", "steps of one measurement (20)");
    argList::addOption("warmup", "N", "steps before the first one (5)");
    argList::addOption("repeat", "N", "measurements, the best counts (3)");

    argList::addBoolOption("cpuTime", "measure processor time");

#include "setRootCase.H"
#include "createTime.H"
#include "createMesh.H"

    const label nSteps = args.getOrDefault<label>("steps", 20);
    const label nWarmup = args.getOrDefault<label>("warmup", 5);
    const label nRepeat = args.getOrDefault<label>("repeat", 3);

    const bool cpuTime = args.found("cpuTime");

    mpm::materialPointSystem points(mesh);

    const auto run = [&](const label n)
    {
        for (label i = 0; i < n; ++i)
        {
            ++runTime;
            scalar factor = 1;
            if (!points.advance(runTime.deltaTValue(), factor))
            {
                FatalErrorInFunction << "A step had to be redone: deltaT is too large for a"
                                     << " measurement." << exit(FatalError);
            }
        }
    };

    run(nWarmup);

    scalar best = GREAT;
    mpm::materialPointSystem::clocks part;
    for (label i = 0; i < nRepeat; ++i)
    {
        const mpm::materialPointSystem::clocks before(points.clock());
        returnReduce(label(0), sumOp<label>());
        const scalar start = seconds(cpuTime);
        run(nSteps);
        const scalar s = returnReduce(seconds(cpuTime) - start, maxOp<scalar>());
        if (s < best)
        {
            best = s;
            const mpm::materialPointSystem::clocks after(points.clock());
            part.nodes = after.nodes - before.nodes;
            part.move = after.move - before.move;
            part.sort = after.sort - before.sort;
            part.project = after.project - before.project;
            part.stress = after.stress - before.stress;
        }
    }

    const scalar n = points.nPoints();
    Info << "points " << label(n) << nl << "rate [M point-steps/s] " << n * nSteps / best * 1e-6
         << nl << "ns per point and step " << best / (n * nSteps) * 1e9 << nl
         << "share of the step [%]: nodes " << 100 * part.nodes / best << " move "
         << 100 * part.move / best << " sort " << 100 * part.sort / best << " project "
         << 100 * part.project / best << " stress and force " << 100 * part.stress / best << nl
         << "columns and buffers [bytes per point] " << points.bytesPerPoint() << nl
         << "node columns [bytes per point] " << points.gridBytes() / n << nl << "peak memory [kB] "
         << peakMemory() << nl;

    points.report();

    return 0;
}
