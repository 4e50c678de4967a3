/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "caseTime.H"
#include "cloud.H"
#include "Field.H"
#include "FlatOutput.H"
#include "HashSet.H"
#include "IOField.H"
#include "labelIOList.H"
#include "localIOdictionary.H"
#include "OSspecific.H"
#include "symmTensor.H"
#include "tensor.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- Append the components of a field
template<class Type>
void append(caseTime::values& all, const UList<Type>& f)
{
    const int n = pTraits<Type>::nComponents;
    const label old = all.numbers.size();

    all.nComponents = n;
    all.numbers.setSize(old + n*f.size());
    forAll(f, i)
    {
        for (direction c = 0; c < n; ++c)
        {
            all.numbers[old + n*i + c] = component(f[i], c);
        }
    }
}


//- Append a field of a file; false for another type
template<class Type>
bool appendColumn(caseTime::values& all, const IOobject& io)
{
    if (io.headerClassName() != IOField<Type>::typeName)
    {
        return false;
    }
    append(all, IOField<Type>(io));
    return true;
}


//- Append the inner values of a field of a file, n of them; false for another
//  type
template<class Type>
bool appendField
(
    caseTime::values& all,
    const IOobject& io,
    const word& prefix,
    const label n
)
{
    const word name
    (
        prefix + char(std::toupper(pTraits<Type>::typeName[0]))
      + (pTraits<Type>::typeName + 1) + "Field"
    );
    // Without boundary values (thetaRho of a gas) they have another keyword
    const word inner(name + "::Internal");
    const bool isInner = io.headerClassName() == inner;
    if (io.headerClassName() != name && !isInner)
    {
        return false;
    }
    const localIOdictionary dict(io, isInner ? inner : name);
    append(all, Field<Type>(isInner ? "value" : "internalField", dict, n));
    return true;
}


//- Sorted, each once
wordList sortedOf(const wordHashSet& names)
{
    return names.sortedToc();
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::mpm::caseTime::folder(const label piecei) const
{
    return pieces_[piecei].path()/pieces_[piecei].timeName();
}


const Foam::polyMesh& Foam::mpm::caseTime::mesh(const label piecei) const
{
    if (!meshes_.set(piecei))
    {
        meshes_.set
        (
            piecei,
            new polyMesh
            (
                IOobject
                (
                    polyMesh::defaultRegion,
                    name(),
                    pieces_[piecei],
                    IOobject::MUST_READ
                )
            )
        );
    }
    return meshes_[piecei];
}


Foam::labelList Foam::mpm::caseTime::addressing
(
    const label piecei,
    const bool cells
) const
{
    const polyMesh& m = mesh(piecei);
    if (!decomposed_)
    {
        return identity(cells ? m.nCells() : m.nPoints());
    }
    return labelIOList
    (
        IOobject
        (
            cells ? "cellProcAddressing" : "pointProcAddressing",
            m.facesInstance(),
            polyMesh::meshSubDir,
            m,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::caseTime::caseTime
(
    const fileName& path,
    const bool latest,
    const scalar value,
    const bool processors
)
:
    path_(path)
{
    if (!isDir(path))
    {
        FatalErrorInFunction
            << "There is no case " << path << exit(FatalError);
    }

    label nProcessors = 0;
    while (isDir(path/("processor" + Foam::name(nProcessors))))
    {
        ++nProcessors;
    }
    if (processors && !nProcessors)
    {
        FatalErrorInFunction
            << "Case " << path << " has no folder processor0."
            << exit(FatalError);
    }

    // The last time with points if there is one; that of the whole case first
    const auto find = [&](const fileName& folder, instant& found)
    {
        const instantList times(Time::findTimes(folder));
        bool there = false;
        for (const instant& t : times)
        {
            if (t.name() == "constant")
            {
                continue;
            }
            if
            (
                latest
             || mag(t.value() - value) <= 1e-6*max(mag(value), SMALL)
            )
            {
                found = t;
                there = true;
            }
        }
        return there;
    };
    const auto withPoints = [&](const fileName& folder, const instant& t)
    {
        return isDir(folder/t.name()/cloud::prefix);
    };

    instant mine, theirs;
    const bool whole = !processors && find(path, mine);
    const bool parts = nProcessors && find(path/"processor0", theirs);

    // decomposePar leaves the start in the whole case: the last one has it
    bool partsHavePoints = false;
    for (label i = 0; parts && i < nProcessors; ++i)
    {
        partsHavePoints =
            partsHavePoints
         || withPoints(path/("processor" + Foam::name(i)), theirs);
    }
    decomposed_ =
        parts
     && (
            !whole
         || (partsHavePoints && !withPoints(path, mine))
         || theirs.value() > mine.value()
        );
    if (!whole && !parts)
    {
        wordList names;
        for
        (
            const instant& t :
            Time::findTimes(nProcessors ? path/"processor0" : path)
        )
        {
            if (t.name() != "constant")
            {
                names.append(t.name());
            }
        }
        FatalErrorInFunction
            << "Case " << path << " has no time "
            << (latest ? word("folder") : word(Foam::name(value))) << "."
            << nl << "Its times are: " << flatOutput(names)
            << exit(FatalError);
    }

    pieces_.setSize(decomposed_ ? nProcessors : 1);
    meshes_.setSize(pieces_.size());
    forAll(pieces_, i)
    {
        pieces_.set
        (
            i,
            new Time
            (
                path.path(),
                decomposed_
              ? path.name()/("processor" + Foam::name(i))
              : fileName(path.name()),
                "system",
                "constant",
                false,
                false
            )
        );
        pieces_[i].setTime(decomposed_ ? theirs : mine, 0);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::caseTime::clouds() const
{
    wordHashSet names;
    forAll(pieces_, i)
    {
        for
        (
            const fileName& f :
            readDir(folder(i)/cloud::prefix, fileName::DIRECTORY)
        )
        {
            names.insert(f);
        }
    }
    return sortedOf(names);
}


Foam::wordList Foam::mpm::caseTime::columns(const word& cloudName) const
{
    // Other tools' names of what x and id say
    const wordHashSet others
        {"positions", "coordinates", "origProcId", "origId", "id"};

    wordHashSet names;
    forAll(pieces_, i)
    {
        for
        (
            const fileName& f :
            readDir(folder(i)/cloud::prefix/cloudName, fileName::FILE)
        )
        {
            if (!others.found(f.lessExt()) && !others.found(f))
            {
                names.insert(f.hasExt("gz") ? word(f.lessExt()) : word(f));
            }
        }
    }
    return sortedOf(names);
}


Foam::wordList Foam::mpm::caseTime::fields() const
{
    wordHashSet names;
    forAll(pieces_, i)
    {
        for (const fileName& f : readDir(folder(i), fileName::FILE))
        {
            names.insert(f.hasExt("gz") ? word(f.lessExt()) : word(f));
        }
    }
    return sortedOf(names);
}


Foam::mpm::caseTime::values Foam::mpm::caseTime::column
(
    const word& cloudName,
    const word& name,
    const labelList& ids
) const
{
    values all;
    forAll(pieces_, i)
    {
        IOobject io
        (
            name,
            pieces_[i].timeName(),
            cloud::prefix/cloudName,
            pieces_[i],
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );

        // A processor without points has no files
        if (!io.typeHeaderOk<IOField<scalar>>(false))
        {
            continue;
        }
        if
        (
            !appendColumn<scalar>(all, io)
         && !appendColumn<vector>(all, io)
         && !appendColumn<symmTensor>(all, io)
         && !appendColumn<tensor>(all, io)
         && !appendColumn<label>(all, io)
        )
        {
            Info<< "Not compared: " << io.objectPath() << " is a "
                << io.headerClassName() << nl;
            return values();
        }
    }
    if (all.nComponents)
    {
        const label n = all.numbers.size()/all.nComponents;
        all.names = ids.size() ? ids : identity(n);
        if (all.names.size() != n)
        {
            FatalErrorInFunction
                << "Column " << name << " of cloud " << cloudName << " in "
                << path_ << ", time " << this->name() << ", has " << n
                << " values for " << ids.size() << " points."
                << exit(FatalError);
        }
    }
    return all;
}


Foam::mpm::caseTime::values Foam::mpm::caseTime::field
(
    const word& name,
    bool& onCells
) const
{
    values all;
    forAll(pieces_, i)
    {
        IOobject io
        (
            name,
            pieces_[i].timeName(),
            pieces_[i],
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );
        if (!io.typeHeaderOk<IOField<scalar>>(false))
        {
            continue;
        }
        const word kind(io.headerClassName());
        onCells = kind.substr(0, 3) == "vol";
        const word prefix(onCells ? "vol" : "point");
        if (kind.substr(0, prefix.size()) != prefix)
        {
            Info<< "Not compared: " << io.objectPath() << " is a " << kind
                << nl;
            return values();
        }

        const labelList names(addressing(i, onCells));
        const label n = names.size();
        if
        (
            !appendField<scalar>(all, io, prefix, n)
         && !appendField<vector>(all, io, prefix, n)
         && !appendField<symmTensor>(all, io, prefix, n)
         && !appendField<tensor>(all, io, prefix, n)
        )
        {
            Info<< "Not compared: " << io.objectPath() << " is a " << kind
                << nl;
            return values();
        }
        all.names.append(names);
    }
    return all;
}


Foam::point Foam::mpm::caseTime::position
(
    const label name,
    const bool cell
) const
{
    forAll(pieces_, i)
    {
        const label at = addressing(i, cell).find(name);
        if (at >= 0)
        {
            return cell ? mesh(i).cellCentres()[at] : mesh(i).points()[at];
        }
    }
    return point::uniform(GREAT);
}

// ************************************************************************* //
