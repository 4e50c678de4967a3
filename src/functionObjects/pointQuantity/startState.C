// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "startState.H"
#include "IOField.H"
#include "OSspecific.H"
#include "Time.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

bool hasFile(const cloud& c, const word& time, const word& field)
{
    const fileName path(c.time().path() / time / c.db().dbDir() / cloud::prefix / c.name() / field);
    return isFile(path) || isFile(path + ".gz");
}

template<class Type>
void readFile(
    const dictionary& dict, const cloud& c, const word& time, const word& field,
    Field<Type>& values, const label n)
{
    IOField<Type> f(IOobject(
        field, time, cloud::prefix / c.name(), c.db(), IOobject::MUST_READ, IOobject::NO_WRITE,
        false));
    if (n >= 0 && f.size() != n)
    {
        FatalIOErrorInFunction(dict)
            << "Field " << f.objectPath() << " has " << f.size() << " values for " << n
            << " material points." << exit(FatalIOError);
    }
    values.transfer(f);
}

//- The values to keep, those of all processors one after the other
template<class Container>
void shareValues(const boolList& keep, Container& values)
{
    List<Container> parts(Pstream::nProcs());
    Container& mine = parts[Pstream::myProcNo()];
    mine.setSize(values.size());
    label n = 0;
    forAll(values, i)
    {
        if (keep[i])
        {
            mine[n++] = values[i];
        }
    }
    mine.setSize(n);
    Pstream::gatherList(parts);
    Pstream::scatterList(parts);

    n = 0;
    for (const Container& part : parts)
    {
        n += part.size();
    }
    values.setSize(n);
    n = 0;
    for (const Container& part : parts)
    {
        for (const auto& value : part)
        {
            values[n++] = value;
        }
    }
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::point Foam::mpm::positionOf(const materialPointCloud& cloud, const label pointi)
{
    const labelList& start = cloud.start();
    const label k = label(std::upper_bound(start.begin(), start.end(), pointi) - start.begin()) - 1;

    return cloud.position(pointi, cloud.cells()[k]);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::mpm::startState::firstTime(const cloud& c)
{
    // The same list for all: a folder may be missing where no points were
    DynamicList<word> found;
    for (const instant& t : c.time().times())
    {
        if (t.name() != c.time().constant())
        {
            found.append(t.name());
        }
    }
    wordList names(std::move(found));
    Pstream::scatter(names);

    for (const word& name : names)
    {
        if (returnReduce(hasFile(c, name, "m"), orOp<bool>()))
        {
            return name;
        }
    }
    return word::null;
}

void Foam::mpm::startState::read(
    const dictionary& dict, const materialPointCloud& cloud, const word& time,
    const bool withHalfSize)
{
    const bool hasPoints = hasFile(cloud, time, "m");
    wordList fields({"x", "V"});
    if (withHalfSize)
    {
        fields.append("halfSize");
    }
    for (const word& field : fields)
    {
        const bool missing = hasPoints && !hasFile(cloud, time, field);
        if (returnReduce(missing, orOp<bool>()))
        {
            FatalIOErrorInFunction(dict)
                << "The start positions of phase " << cloud.name()
                << " are needed. The run started at time " << time << ", but its folder "
                << cloud::prefix / cloud.name() << " has no file " << field
                << ", which setMaterialPoints and"
                << " materialPointFoam write." << exit(FatalIOError);
        }
    }
    if (!hasPoints)
    {
        return;
    }
    readFile(dict, cloud, time, "x", x_, -1);
    readFile(dict, cloud, time, "V", V_, x_.size());
    if (withHalfSize)
    {
        readFile(dict, cloud, time, "halfSize", halfSize_, x_.size());
    }

    // Without the files points are numbered as they stand
    id_ = identity(x_.size());
    for (const word field : {"id", "origId"})
    {
        if (hasFile(cloud, time, field))
        {
            labelField id;
            readFile(dict, cloud, time, field, id, x_.size());
            id_.transfer(id);
            break;
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::startState::startState(
    const dictionary& dict, const materialPointPhase& phase, const bool withHalfSize)
{
    const materialPointCloud& cloud = phase.cloud();
    const Time& runTime = cloud.time();

    time_ = firstTime(cloud);
    scalar first = GREAT;
    if (!time_.empty())
    {
        readScalar(time_, first);
    }

    // Names have fewer digits than times
    const bool now = time_ == runTime.timeName();
    if (!now && first > runTime.value())
    {
        FatalIOErrorInFunction(dict)
            << "The start positions of phase " << phase.name()
            << " are needed, but no time folder up to " << runTime.timeName() << " in "
            << runTime.path() << " has " << cloud::prefix / phase.name() << "." << nl
            << "Keep the folder of the time at which the run started." << exit(FatalIOError);
    }

    if (!now || withHalfSize)
    {
        read(dict, cloud, time_, withHalfSize);
    }
    else
    {
        const label n = cloud.size();
        id_.setSize(n);
        x_.setSize(n);
        V_.setSize(n);
        for (label p = 0; p < n; ++p)
        {
            id_[p] = label(cloud.id()[0][p]);
            x_[p] = positionOf(cloud, p);
            V_[p] = cloud.volume()[0][p];
        }
    }
    table_ = idTable(id_, id_.size());
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::startState::share(const boolList& keep)
{
    shareValues(keep, id_);
    shareValues(keep, x_);
    shareValues(keep, V_);
    table_ = idTable(id_, id_.size());
}
