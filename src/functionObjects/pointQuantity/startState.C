/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

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
    const fileName path
    (
        c.time().path()/time/c.db().dbDir()/cloud::prefix/c.name()/field
    );
    return isFile(path) || isFile(path + ".gz");
}


template<class Type>
void readFile
(
    const dictionary& dict,
    const cloud& c,
    const word& time,
    const word& field,
    Field<Type>& values,
    const label n
)
{
    IOField<Type> f
    (
        IOobject
        (
            field,
            time,
            cloud::prefix/c.name(),
            c.db(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    if (n >= 0 && f.size() != n)
    {
        FatalIOErrorInFunction(dict)
            << "Field " << f.objectPath() << " has " << f.size()
            << " values for " << n << " material points."
            << exit(FatalIOError);
    }
    values.transfer(f);
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::point Foam::mpm::positionOf
(
    const materialPointCloud& cloud,
    const label pointi
)
{
    const labelList& start = cloud.start();
    const label k = label
    (
        std::upper_bound(start.begin(), start.end(), pointi)
      - start.begin()
    ) - 1;

    return cloud.position(pointi, cloud.cells()[k]);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::startState::read
(
    const dictionary& dict,
    const materialPointCloud& cloud,
    const word& time
)
{
    for (const word field : {"x", "V"})
    {
        if (!hasFile(cloud, time, field))
        {
            FatalIOErrorInFunction(dict)
                << "The start positions of phase " << cloud.name()
                << " are needed. The run started at time " << time
                << ", but its folder " << cloud::prefix/cloud.name()
                << " has no file " << field << ", which setMaterialPoints and"
                << " materialPointFoam write."
                << exit(FatalIOError);
        }
    }
    readFile(dict, cloud, time, "x", x_, -1);
    readFile(dict, cloud, time, "V", V_, x_.size());

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

Foam::mpm::startState::startState
(
    const dictionary& dict,
    const materialPointPhase& phase
)
{
    const materialPointCloud& cloud = phase.cloud();
    const Time& runTime = cloud.time();

    const instant* first = nullptr;
    const instantList times(runTime.times());
    for (const instant& t : times)
    {
        if (t.name() != runTime.constant() && hasFile(cloud, t.name(), "m"))
        {
            first = &t;
            break;
        }
    }
    if (!first || first->value() > runTime.value())
    {
        FatalIOErrorInFunction(dict)
            << "The start positions of phase " << phase.name()
            << " are needed, but no time folder up to "
            << runTime.timeName() << " in " << runTime.path() << " has "
            << cloud::prefix/phase.name() << "." << nl
            << "Keep the folder of the time at which the run started."
            << exit(FatalIOError);
    }

    time_ = first->name();
    if (first->value() < runTime.value())
    {
        read(dict, cloud, time_);
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

// ************************************************************************* //
