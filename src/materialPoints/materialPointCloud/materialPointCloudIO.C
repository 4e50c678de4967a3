// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointCloud.H"
#include "pointBlock.H"
#include "noTraps.H"
#include "fullPrecision.H"
#include "fatalMessages.H"
#include "Cloud.H"
#include "passiveParticle.H"
#include "IOField.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

void wrongSize(const IOobject& object, const label size, const label n)
{
    FatalErrorInFunction << "Field " << object.objectPath() << " has " << size << " values for "
                         << n << " material points." << exit(FatalError);
}

//- Number of values that a field's file announces, -1 if it has none
label announced(const materialPointCloud& c, const word& name)
{
    return announcedSize(c.columnObject(name, IOobject::MUST_READ));
}

//- Field of the current time; fatal if it is missing or of another length
template<class Type>
tmp<Field<Type>> readField(const materialPointCloud& c, const word& name, const label n)
{
    const IOobject object(c.columnObject(name, IOobject::MUST_READ));

    // Check the size before memory is allocated for it
    const label nAnnounced = announced(c, name);
    if (n >= 0 && nAnnounced >= 0 && nAnnounced != n)
    {
        wrongSize(object, nAnnounced, n);
    }

    // OpenFOAM aborts on a broken list without naming the file
    autoPtr<IOField<Type>> fPtr(readNamed(
        object.objectPath(), [&] { return autoPtr<IOField<Type>>(new IOField<Type>(object)); }));
    IOField<Type>& f = *fPtr;

    if (n >= 0 && f.size() != n)
    {
        wrongSize(object, f.size(), n);
    }
    return tmp<Field<Type>>::New(std::move(static_cast<Field<Type>&>(f)));
}

bool onDisk(const materialPointCloud& c, const word& name)
{
    const fileName path(c.time().path() / c.time().timeName() / cloud::prefix / c.name() / name);
    return isFile(path) || isFile(path + ".gz");
}

//- Name of a column for messages
string titleOf(const cloudColumn& c)
{
    const string& title = c.rules().title;
    return title.empty() ? string(c.name()) : c.name() + " (" + title + ")";
}

}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::IOobject
Foam::mpm::materialPointCloud::columnObject(const word& name, const IOobject::readOption r) const
{
    return IOobject(
        name, time().timeName(), cloud::prefix / this->name(), db(), r, IOobject::NO_WRITE, false);
}

Foam::label Foam::mpm::materialPointCloud::ownCellNear(const point& x) const
{
    const auto owns = [&](const label celli)
    {
        scalar xp[3] = {0, 0, 0};
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            xp[d] = x[grid_.direction(d)];
        }
        return grid_.locate(celli, xp) == celli;
    };

    // Rings around the cell with the nearest centre, at last all cells
    labelHashSet tried;
    DynamicList<label> cells;
    if (grid_.nCells())
    {
        cells.append(grid_.mesh().findNearestCell(x));
        tried.insert(cells[0]);
    }
    label first = 0;
    for (int ring = 0; ring < 3 && first < cells.size(); ++ring)
    {
        const label end = cells.size();
        for (; first < end; ++first)
        {
            if (owns(cells[first]))
            {
                return cells[first];
            }
            for (const label node : grid_.nodesOf(cells[first]))
            {
                for (const label celli : grid_.nodes().cellsOf(node))
                {
                    if (tried.insert(celli))
                    {
                        cells.append(celli);
                    }
                }
            }
        }
    }
    for (label celli = 0; celli < grid_.nCells(); ++celli)
    {
        if (!tried.found(celli) && owns(celli))
        {
            return celli;
        }
    }
    return -1;
}

Foam::label Foam::mpm::materialPointCloud::ownCellBeside(const point& x) const
{
    // The way from another cell may lead through another processor
    if (Pstream::parRun() && !grid_.locatesAtOnce())
    {
        const label celli = ownCellNear(x);
        if (celli >= 0)
        {
            return celli;
        }
    }

    // decomposePar goes by the cell that the point was written with: on a side
    // it may be the other one
    for (const scalar sign : {-1, 1})
    {
        for (int n = 1; Pstream::parRun() && n < (1 << grid_.nDim()); ++n)
        {
            scalar xp[3] = {0, 0, 0};
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                const scalar xd = x[grid_.direction(d)];
                const scalar size = grid_.mesh().bounds().span()[grid_.direction(d)];
                xp[d] = xd + sign * ((n >> d) & 1) * 1e-10 * size;
            }
            const label celli = grid_.find(xp);
            if (celli >= 0 && celli < grid_.nCells())
            {
                return celli;
            }
        }
    }
    return -1;
}

bool Foam::mpm::materialPointCloud::present(const cloudColumn& c) const
{
    const columnRules& rules = c.rules();
    if (onDisk(*this, c.name())
        // OpenFOAM's own message names the missing file
        || (rules.inFiles == columnRules::required && rules.remedySentence.empty()))
    {
        return true;
    }
    if (rules.inFiles == columnRules::optional)
    {
        return false;
    }

    // A time that a run has written has every column, one of setMaterialPoints
    // some of them: a missing one would silently start from its initial value
    const bool written =
        isFile(time().path() / time().timeName() / "uniform" / "materialPointState");
    const bool ours = rules.inFiles == columnRules::sinceStart && onDisk(*this, "x");
    if (written || ours)
    {
        FatalErrorInFunction << "Column " << c.name() << " of phase " << this->name()
                             << " is missing in time " << time().timeName() << ": its file was"
                             << " removed, or the time was written with another law, failure"
                             << " model or scheme." << nl
                             << "Restart from another time, or run setMaterialPoints."
                             << exit(FatalError);
    }
    if (rules.inFiles == columnRules::required)
    {
        FatalErrorInFunction << "Phase " << this->name() << " has " << rules.neededFor.c_str()
                             << ", but its points of time " << time().timeName()
                             << " have no column " << titleOf(c).c_str() << "." << nl
                             << rules.remedySentence.c_str() << exit(FatalError);
    }
    return false;
}

template<class Type>
void Foam::mpm::materialPointCloud::checkValue(
    const cloudColumn& c, const Type& value, const label pointi, const label celli) const
{
    const columnRules& rules = c.rules();
    bool good = true;
    if (rules.sign == columnRules::finite)
    {
        good = std::isfinite(magSqr(value));
    }
    else
    {
        const int D = grid_.nDim();
        const bool isVector = c.kind() == column::vectors;
        const int n = isVector ? D : int(pTraits<Type>::nComponents);
        for (int i = 0; i < n; ++i)
        {
            const scalar a = component(value, direction(isVector ? grid_.direction(i) : i));
            good = good
                && (rules.sign == columnRules::positives ? a > 0 && a < rules.limit
                                                         : a >= 0 && a <= 1);
        }
    }
    if (!good)
    {
        OStringStream text;
        text << value;
        FatalErrorInFunction << "Material point " << label(id_[0][pointi]) << " of " << this->name()
                             << " at " << position(pointi, celli) << ", time " << time().timeName()
                             << ": " << titleOf(c).c_str() << " is " << text.str().c_str()
                             << "; it must be " << rules.rule.c_str() << "." << exit(FatalError);
    }
}

template<class Type>
void Foam::mpm::materialPointCloud::fillColumn(
    cloudColumn& c, const Field<Type>& values, const labelList& cell)
{
    forAll(values, p)
    {
        checkValue(c, values[p], p, cell[p]);
        if constexpr (std::is_same<Type, scalar>::value)
        {
            c[0][p] = values[p];
        }
        else if constexpr (std::is_same<Type, vector>::value)
        {
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                c[d][p] = values[p][grid_.direction(d)];
            }
        }
        else
        {
            setTensor(c, p, tensor(values[p]));
        }
    }
}

void Foam::mpm::materialPointCloud::readColumn(cloudColumn& c, const labelList& cell)
{
    const label n = cell.size();
    c.fromFile() = present(c);
    const word file(c.fromFile() ? c.name() : c.rules().orElseFile);
    if (file.empty())
    {
        return;
    }
    switch (c.kind())
    {
    case column::scalars:
        fillColumn(c, readField<scalar>(*this, file, n)(), cell);
        break;
    case column::vectors:
        fillColumn(c, readField<vector>(*this, file, n)(), cell);
        break;
    case column::tensors:
        fillColumn(c, readField<tensor>(*this, file, n)(), cell);
        break;
    default:
        fillColumn(c, readField<symmTensor>(*this, file, n)(), cell);
    }
}

Foam::scalarField Foam::mpm::materialPointCloud::readMasses()
{
    // A processor without points has no files
    if (!onDisk(*this, "m"))
    {
        return scalarField();
    }
    // The number is wrong if it agrees with neither of two other columns
    const bool agrees = announced(*this, "m") == announced(*this, "x");
    return readField<scalar>(*this, "m", agrees ? -1 : announced(*this, "V"));
}

void Foam::mpm::materialPointCloud::readIds()
{
    labelList id;
    for (const word name : {"id", "origId"})
    {
        if (id.empty() && onDisk(*this, name))
        {
            id = readField<label>(*this, name, n_);
        }
    }
    if (id.empty())
    {
        FatalErrorInFunction << "Cloud " << name() << " of time " << time().timeName()
                             << " has no file id in "
                             << columnObject("id", IOobject::NO_READ).objectPath().path() << "."
                             << nl << "Points are known by their ids (strengths that scatter,"
                             << " probes, restarts): run setMaterialPoints again, or copy"
                             << " the file back." << exit(FatalError);
    }
    forAll(id, p)
    {
        if (id[p] < 0)
        {
            FatalErrorInFunction << "Cloud " << name() << " of time " << time().timeName()
                                 << " has a material point with the id " << id[p]
                                 << "; ids must not be negative." << exit(FatalError);
        }
        id_[0][p] = id[p];
    }

    // Ids must be unique: a point keeps its id for the whole run
    Foam::sort(id);
    for (label i = 1; i < id.size(); ++i)
    {
        if (id[i] == id[i - 1])
        {
            FatalErrorInFunction << "Cloud " << name() << " of time " << time().timeName()
                                 << " has two material points with id " << id[i] << "."
                                 << exit(FatalError);
        }
    }
    nextId_ = id.last() + 1;
}

void Foam::mpm::materialPointCloud::readPositions(labelList& cell)
{
    const label n = cell.size();

    vectorField x;
    if (present(x_))
    {
        x = readField<vector>(*this, "x", n);
    }
    else
    {
        // Another tool's cloud: positions to the precision of its
        // barycentric coordinates
        Cloud<passiveParticle> parcels(grid_.mesh(), name(), false);
        x.setSize(parcels.size());
        label p = 0;
        for (const passiveParticle& parcel : parcels)
        {
            x[p++] = parcel.position();
        }
    }
    if (x.size() != n)
    {
        FatalErrorInFunction << "Cloud " << name() << " of time " << time().timeName() << " has "
                             << x.size() << " positions for " << n << " masses."
                             << exit(FatalError);
    }

    cell = -1;
    findCells(x, cell);
}

void Foam::mpm::materialPointCloud::findCells(const UList<point>& x, labelList& cell)
{
    const int D = grid_.nDim();
    label near = -1;
    forAll(cell, p)
    {
        if (cell[p] >= 0)
        {
            continue;
        }
        near = cell[p] < -1 ? -2 - cell[p] : near;
        scalar xp[3];
        for (int d = 0; d < D; ++d)
        {
            xp[d] = x[p][grid_.direction(d)];
        }
        if (std::isfinite(magSqr(x[p])))
        {
            cell[p] = near >= 0 ? grid_.locate(near, xp) : -1;
            if (cell[p] < 0)
            {
                for (int d = 0; d < D; ++d)
                {
                    xp[d] = x[p][grid_.direction(d)];
                }
                cell[p] = grid_.find(xp);
            }
        }
        if (cell[p] < 0 || cell[p] >= grid_.nCells())
        {
            cell[p] = ownCellBeside(x[p]);
            for (int d = 0; !grid_.locatesAtOnce() && d < D; ++d)
            {
                xp[d] = x[p][grid_.direction(d)];
            }
        }
        if (cell[p] < 0)
        {
            FatalErrorInFunction << "Material point " << label(id_[0][p]) << " of " << name()
                                 << " at " << x[p] << ", time " << time().timeName()
                                 << ", lies outside the mesh " << grid_.mesh().bounds() << "."
                                 << exit(FatalError);
        }
        near = cell[p];
        for (int d = 0; d < D; ++d)
        {
            x_[d][p] = xp[d];
        }
    }
}

Foam::label Foam::mpm::materialPointCloud::readPoints()
{
    grid_.mesh().tetBasePtIs();

    // Overflow and NaN in the files are found below, by name
    const noTraps guard;

    if (!returnReduce(onDisk(*this, "m"), orOp<bool>()))
    {
        return -1;
    }

    // Only one field at a time is held in memory beside the columns
    scalarField mass(readMasses());
    const label n = mass.size();
    checkRecord(returnReduce(n, sumOp<label>()));
    labelList cell(n, label(-1));

    n_ = 0;
    reserve(n);
    n_ = n;

    for (cloudColumn& c : columns_)
    {
        c.fill(0, n);
    }
    if (n)
    {
        readIds();
        readPositions(cell);
        fillColumn(mass_, mass, cell);
        mass.clear();
        for (cloudColumn& c : columns_)
        {
            const columnRules::files files = c.rules().inFiles;
            if (files != columnRules::none && files != columnRules::key)
            {
                readColumn(c, cell);
            }
        }
    }

    order(cell);
    reduce(nextId_, maxOp<scalar>());

    return returnReduce(n_, sumOp<label>());
}
