// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "detonationFront.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "StringStream.H"
#include "Time.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::mpm::detonationFront::entries(
    {"points", "lines", "planes", "velocity", "time", "times", "width", "radius", "moving"});

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::mpm::detonationFront::source::to(const vector& x) const
{
    const vector d(x - a);
    if (kind == plane)
    {
        return (d & b) * b;
    }
    const vector along(b - a);
    const scalar s = magSqr(along);
    return s > 0 ? d - min(max((d & along) / s, scalar(0)), scalar(1)) * along : d;
}

Foam::vector Foam::mpm::detonationFront::from(const source& s, const vector& x) const
{
    vector d(s.to(x));
    for (direction i = 0; i < 3; ++i)
    {
        d[i] = mesh_->geometricD()[i] < 0 ? 0 : d[i];
    }
    return d;
}

Foam::mpm::detonationFront::arrival
Foam::mpm::detonationFront::arrivalAt(const label celli, const vector& x) const
{
    const scalar V = mesh_->V()[celli];
    arrival at{GREAT, 1};
    scalar first = GREAT;
    for (const source& s : sources_)
    {
        const vector d(from(s, x));
        const scalar t = s.time + mag(d) / velocity_;
        if (t < first)
        {
            first = t;
            scalar area = 0;
            for (const label f : mesh_->cells()[celli])
            {
                area += mag(mesh_->faceAreas()[f] & d);
            }
            at.time = width_ / velocity_ * (area > 0 ? 2 * V * mag(d) / area : std::cbrt(V));
            at.begin = mag(d) > radius_ ? GREAT : max(s.time, t - 0.5 * at.time);
        }
    }
    return at;
}

void Foam::mpm::detonationFront::outside(const source& s, const scalar distance) const
{
    FatalErrorInFunction << "The detonation is lit outside of the charge: "
                         << (s.kind == source::point      ? "point "
                                 : s.kind == source::line ? "line from "
                                                          : "plane through ")
                         << s.a;
    if (s.kind != source::point)
    {
        FatalError << (s.kind == source::line ? " to " : " with the normal ") << s.b;
    }
    if (distance < GREAT)
    {
        FatalError << " is " << distance << " m from the centre of the nearest cell"
                   << " that has some of it.";
    }
    else
    {
        FatalError << ", but no cell has any of it.";
    }
    FatalError << " Move it (entries points, lines, planes of detonation) or the"
               << " charge (setFluids, file alpha)." << exit(FatalError);
}

void Foam::mpm::detonationFront::checkSources(const dictionary& dict) const
{
    const noTraps guard;
    constexpr scalar most = 1e30;
    for (const source& s : sources_)
    {
        if (!(cmptMax(cmptMag(s.a)) < most && cmptMax(cmptMag(s.b)) < most))
        {
            FatalIOErrorInFunction(dict)
                << "An entry of points, lines or planes in " << dict.name() << " has the place "
                << s.a << ' ' << s.b << "; it must be one of the charge [m]." << exit(FatalIOError);
        }
        if (!(mag(s.time) < most))
        {
            FatalIOErrorInFunction(dict)
                << "Entry time or times in " << dict.name() << " has the value " << s.time
                << "; it must be a time [s]." << exit(FatalIOError);
        }
    }
}

void Foam::mpm::detonationFront::readTimes(const dictionary& dict)
{
    if (dict.found("times"))
    {
        const scalarList times(dict.get<scalarList>("times"));
        if (times.size() != sources_.size() || dict.found("time"))
        {
            FatalIOErrorInFunction(dict)
                << "Entry times in " << dict.name() << " has " << times.size() << " values for "
                << sources_.size() << " points, lines and"
                << " planes; it needs one for each, in this order, and"
                << " excludes the entry time." << exit(FatalIOError);
        }
        forAll(times, i)
        {
            sources_[i].time = times[i];
        }
    }
}

void Foam::mpm::detonationFront::warnOfTimes() const
{
    const scalar end = mesh_->time().endTime().value();
    label late = 0;
    scalar first = GREAT;
    for (const source& s : sources_)
    {
        if (s.time > end)
        {
            ++late;
            first = min(first, s.time);
        }
    }
    if (late)
    {
        WarningInFunction << "The detonation is lit at " << first << " s"
                          << (late < sources_.size() ? " in some of its places" : "")
                          << " (entries time, times of detonation in constant/phaseProperties)"
                          << ", after endTime " << end << " s of system/controlDict: "
                          << (late < sources_.size() ? "they do" : "it does")
                          << " not burn in this run." << endl;
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::detonationFront::detonationFront(const dictionary& dict) :
    velocity_(bounded(dict, "velocity", 1, 1e6)),
    width_(boundedOrDefault(dict, "width", 2, 1, 10)),
    radius_(dict.found("radius") ? positive(dict, "radius") : GREAT),
    moving_(dict.getOrDefault<vector>("moving", Zero)),
    mesh_(nullptr)
{
    const scalar time = boundedOrDefault(dict, "time", 0, -GREAT, GREAT);
    typedef List<vector> vectors;
    for (const vector& x : dict.getOrDefault<vectors>("points", vectors()))
    {
        sources_.append({source::point, x, x, time});
    }
    for (const bool plane : {false, true})
    {
        const word key(plane ? "planes" : "lines");
        for (const vectors& two : dict.getOrDefault<List<vectors>>(key, List<vectors>()))
        {
            const noTraps guard;
            if (two.size() != 2 || (plane && !(mag(two[1]) > 0)))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry " << key << " in " << dict.name() << " has " << two
                    << "; each of them must be "
                    << (plane ? "(point normal), the normal not 0, as in (((0 0 0)"
                                " (1 0 0)))."
                              : "(from to), as in (((0 0 0) (0 0 1))).")
                    << exit(FatalIOError);
            }
            sources_.append(
                {plane ? source::plane : source::line, two[0],
                 plane ? two[1] / mag(two[1]) : two[1], time});
        }
    }
    if (sources_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The detonation starts nowhere: one of the entries (points lines"
            << " planes) is missing in " << dict.name() << exit(FatalIOError);
    }
    readTimes(dict);
    checkSources(dict);
    const noTraps guard;
    if (!(mag(moving_) < velocity_))
    {
        FatalIOErrorInFunction(dict)
            << "Entry moving in " << dict.name() << " is " << moving_
            << "; the velocity of the charge [m/s] must be less than that of"
            << " the detonation, " << velocity_ << "." << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::detonationFront::start(const fvMesh& mesh, const boolList& charge, const bool fresh)
{
    mesh_ = &mesh;
    const vectorField& C = mesh.cellCentres();
    begin_.setSize(mesh.nCells());
    time_.setSize(mesh.nCells());
    forAll(begin_, c)
    {
        const arrival at(arrivalAt(c, C[c]));
        begin_[c] = at.begin;
        time_[c] = at.time;
    }
    if (!fresh)
    {
        return;
    }
    warnOfTimes();
    for (const source& s : sources_)
    {
        scalar nearest = GREAT;
        bool touches = false;

        // No further from a cell's centre than its points
        forAll(charge, c)
        {
            if (charge[c])
            {
                const vector d(from(s, C[c] - mesh.time().value() * moving_));
                nearest = min(nearest, mag(d));
                for (const label p : mesh.cellPoints()[c])
                {
                    // Not along the thickness of a mesh in 2D
                    vector reach(mesh.points()[p] - C[c]);
                    for (direction a = 0; a < 3; ++a)
                    {
                        reach[a] *= mesh.geometricD()[a] < 0 ? 0 : 1;
                    }
                    touches = touches || mag(d) <= 1.01 * mag(reach);
                }
            }
        }
        if (!returnReduce(touches, orOp<bool>()))
        {
            outside(s, returnReduce(nearest, minOp<scalar>()));
        }
    }
}

void Foam::mpm::detonationFront::burn(
    const labelUList& cells, const scalar t, UList<scalar>& F) const
{
    if (magSqr(moving_) > 0)
    {
        const vectorField& C = mesh_->cellCentres();
        forAll(cells, i)
        {
            if (F[i] < 1)
            {
                const arrival at(arrivalAt(cells[i], C[cells[i]] - t * moving_));
                F[i] = max(F[i], min(scalar(1), (t - at.begin) / at.time));
            }
        }
        return;
    }
    forAll(cells, i)
    {
        const label c = cells[i];
        F[i] = max(F[i], min(scalar(1), (t - begin_[c]) / time_[c]));
    }
}

Foam::string Foam::mpm::detonationFront::description() const
{
    OStringStream os;
    os << velocity_ << " m/s from " << sources_.size()
       << (sources_.size() > 1 ? " places" : " place");
    if (magSqr(moving_) > 0)
    {
        os << " that move with " << moving_ << " m/s";
    }
    return os.str();
}
