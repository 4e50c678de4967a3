// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointSystem.H"
#include "deltaTAdvice.H"
#include "noTraps.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A line on a fixed deltaT above Courant number 1, else empty
string deltaTHint(const Time& time, const scalar courantRate)
{
    const scalar Co = courantRate * time.deltaTValue();
    if (!(Co > 1) || time.controlDict().getOrDefault("adjustTimeStep", false))
    {
        return "";
    }
    return "Courant number above 1 in this step (take the deltaT of the first"
           " warning in the log if that is larger): "
        + mpm::deltaTAdvice(time.deltaTValue(), Co) + "\n";
}

//- The time from which a restart would go on: the last complete one, or the
//  start
word restartTime(const Time& time)
{
    const instantList times(Time::findTimes(time.path()));
    for (label i = times.size() - 1; i >= 0; --i)
    {
        const fileName state(time.path() / times[i].name() / "uniform" / "materialPointState");
        if (isFile(state))
        {
            return times[i].name();
        }
    }
    return Time::timeName(time.startTime().value());
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::mpm::materialPointSystem::writeBeforeStop()
{
    // The state before the step is untouched: it is what gets written, but
    // never over a state that is on disk already
    Time& time = const_cast<Time&>(mesh_.time());
    if (returnReduce(isDir(time.path() / time.timeName()), orOp<bool>()))
    {
        return "The state before the step is that of time " + time.timeName() + " on disk.";
    }
    writePoints();
    if (coupling_)
    {
        coupling_->writeFields();
    }
    const word from(restartTime(time));
    time.writeNow();
    return "The state before the step is written to " + time.timeName()
        + " for inspection; a restart begins at " + from + ".";
}

void Foam::mpm::materialPointSystem::stop(const badPoint& bad)
{
    const noTraps guard;
    const string written(writeBeforeStop());

    // Of the state before the step; rate_ is that of the failed one
    scalar speed = 0;
    for (const materialPointPhase& p : phases_)
    {
        speed = max(speed, speedRate(p));
    }
    reduce(speed, maxOp<scalar>());

    // One processor reports and ends the others, which wait
    const label teller =
        returnReduce(bad.phase < 0 ? labelMax : Pstream::myProcNo(), minOp<label>());
    if (teller != Pstream::myProcNo())
    {
        returnReduce(label(0), sumOp<label>());
        return;
    }

    const Time& time = mesh_.time();
    const scalar dt = time.deltaTValue();
    const label pointi = bad.point;
    materialPointPhase& phase = phases_[bad.phase];
    materialPointCloud& cloud = phase.cloud();
    const point x(cloud.position(pointi, cloud.cellOf(pointi)));

    const string hint(deltaTHint(time, speed + waveRate_ + parts_.courantRate()));

    const bool badStress =
        !std::isfinite(magSqr(cloud.sigma(pointi))) || !std::isfinite(cloud.volume()[0][pointi]);

    if (bad.left)
    {
        vector xNew(x);
        scalar to[3] = {0, 0, 0};
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            xNew[grid_.direction(d)] = cloud.xNew()[d][pointi];
            to[d] = cloud.xNew()[d][pointi];
        }
        const string beyond(walls_ ? walls_->words(cloud.cellOf(pointi), to) : string());
        FatalErrorInFunction << "Material point " << label(cloud.id()[0][pointi]) << " of "
                             << phase.name() << " leaves the mesh " << mesh_.bounds() << ": from "
                             << x << " with velocity " << cloud.velocity(pointi) << " to " << xNew
                             << " in the step of " << dt << " s after time " << time.timeName()
                             << "." << nl << beyond.c_str() << written.c_str() << nl << hint.c_str()
                             << (hint.empty() ? "M" : "Otherwise m")
                             << "ake the mesh larger, or keep points inside by the boundary"
                             << " conditions of U." << phase.velocityField()
                             << " (fixedValue or slip), or by a wall:  contact { floor { fields ("
                             << phase.velocityField() << "); patch ...; type ...; } }  in"
                             << " constant/phaseProperties"
                             << (coupling_ ? "."
                                           : ", or let them go:  outflow { patches (...); }"
                                             "  there.")
                             << exit(FatalError);
    }
    FatalErrorInFunction << "Material point " << label(cloud.id()[0][pointi]) << " of "
                         << phase.name() << " at " << x << ", time " << time.timeName() << ": "
                         << (badStress ? "sigma (stress)" : "U (velocity)")
                         << " is not finite in the step of " << dt << " s." << nl << written.c_str()
                         << nl << hint.c_str()
                         << "A smaller maxCo in system/controlDict or maxStrain in"
                         << " fvSolution.materialPoints reduces the time step." << exit(FatalError);
}

void Foam::mpm::materialPointSystem::checkExtent(
    materialPointPhase& phase, const UList<materialPointCloud::cellChange>& cellChanges)
{
    // GIMP's stencil reaches one cell beyond: from two cell widths on weights
    // would become negative
    if (!gridTransfer_->hasExtent() || grid_.sameWidth() > 0)
    {
        return;
    }
    materialPointCloud& cloud = phase.cloud();
    for (const materialPointCloud::cellChange& mv : cellChanges)
    {
        if (mv.cell >= grid_.nCells())
        {
            continue;
        }
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const scalar l = (*cloud.halfSize())[d][mv.point];
            const scalar h = grid_.width(mv.cell, d);
            if (l > 2 * h)
            {
                FatalErrorInFunction << "Material point " << label(cloud.id()[0][mv.point])
                                     << " of " << phase.name() << " at "
                                     << mesh_.cellCentres()[mv.cell] << ", time "
                                     << mesh_.time().timeName() << ", has half-size " << l
                                     << " and moves into a cell"
                                     << " only " << h << " wide." << nl
                                     << "Use more points per cell in setMaterialPointsDict, or"
                                     << " a mesh that is graded less." << exit(FatalError);
            }
        }
    }
}

void Foam::mpm::materialPointSystem::stopForStress(
    const materialPointPhase& phase, const label p, const scalar dt) const
{
    const materialPointCloud& cloud = phase.cloud();
    const point x(cloud.position(p, cloud.cellOf(p)));
    FatalErrorInFunction << "Material point " << label(cloud.id()[0][p]) << " of " << phase.name()
                         << " at " << x << ", step of " << dt << " s after time "
                         << mesh_.time().timeName() << ": "
                         << (std::isfinite(magSqr(cloud.sigma(p)))
                                 ? "the volume is not positive, law "
                                 : "sigma (stress) is not finite, law ")
                         << phase.law().type() << "; velocity " << cloud.velocity(p) << ", volume "
                         << cloud.volume()[0][p] << "." << nl
                         << "Nothing is written: the last written time is the last"
                         << " good state." << nl
                         << "A smaller maxCo in system/controlDict or maxStrain in"
                         << " fvSolution.materialPoints reduces the time step." << exit(FatalError);
}
