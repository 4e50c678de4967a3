// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "caseRows.H"
#include "rowsDistribution.H"
#include "Cloud.H"
#include "IFstream.H"
#include "IOField.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "parcelAt.H"
#include "StringStream.H"
#include "Time.H"
#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Last column of a cloud's rows: where OpenFOAM's parcels are
const word parcelPosition("parcel position");

bool isOf(const word& type, const std::string& place)
{
    return type.ends_with("Field") ? type.starts_with(place)
                                   : place == "vol" && type.ends_with("Field::Internal");
}

bool sphericalOrFaces(const word& type)
{
    return type.starts_with("surface") || type.find("Spherical") != word::npos;
}

dictionary contents(IOobject io)
{
    IFstream is(io.objectPath());
    io.readHeader(is);
    return dictionary(is);
}

//- Entries with one value in place of lists, where they stood: what a processor has that has no
//  cells
void dropLists(dictionary& dict)
{
    for (const word& key : dict.toc())
    {
        if (dict.isDict(key))
        {
            dropLists(dict.subDict(key));
            continue;
        }
        ITstream& is = dict.lookup(key);
        if (is.empty() || !is[0].isWord() || is[0].wordToken() != "nonuniform")
        {
            continue;
        }
        const label n = mpm::rowsDistribution::componentsOf(is);
        if (n == 0)
        {
            dict.remove(key);
            continue;
        }
        string zeros;
        for (label i = 0; i < n; ++i)
        {
            zeros += " 0";
        }
        IStringStream text(key + " uniform " + (n > 1 ? "(" + zeros + ")" : zeros) + ";");
        dict.merge(dictionary(text));
    }
}

template<class Type, class Function>
bool ifClass(const word& type, const Function& f)
{
    const bool is = type == IOField<Type>::typeName;
    if (is)
    {
        f(pTraits<Type>::zero);
    }
    return is;
}

//- Call f(a value of the type of a column); false: there is none
template<class Function>
bool ofClass(const word& type, const Function& f)
{
    return ifClass<label>(type, f) || ifClass<scalar>(type, f) || ifClass<vector>(type, f)
        || ifClass<symmTensor>(type, f) || ifClass<tensor>(type, f);
}

//- Files below a folder, with their paths in it
void addFiles(const fileName& folder, const fileName& below, DynamicList<fileName>& names)
{
    for (const fileName& name : readDir(folder / below, fileName::FILE, false))
    {
        names.append(below / name);
    }
    for (const fileName& name : readDir(folder / below, fileName::DIRECTORY))
    {
        // Parcels write their own
        if (name != cloud::prefix)
        {
            addFiles(folder, below / name, names);
        }
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::mpm::caseRows::object(const word& name, const fileName& local) const
{
    return IOobject(
        name, mesh_.time().timeName(), local, mesh_.time(), IOobject::MUST_READ, IOobject::NO_WRITE,
        false);
}

Foam::HashTable<Foam::word> Foam::mpm::caseRows::classes(const fileName& local) const
{
    List<HashTable<word>> found(Pstream::nProcs());
    HashTable<word>& here = found[Pstream::myProcNo()];
    for (const fileName& name : readDir(mesh_.time().timePath() / local, fileName::FILE))
    {
        IOobject io(object(name, local));
        IFstream is(io.objectPath());
        if (is.good() && io.readHeader(is))
        {
            here.set(name, io.headerClassName());
        }
    }
    Pstream::gatherList(found);
    Pstream::scatterList(found);
    HashTable<word> all;
    for (const HashTable<word>& of : found)
    {
        all += of;
    }
    return all;
}

void Foam::mpm::caseRows::readFields(const bool empty)
{
    fields_ = classes(fileName::null);
    for (const word& name : fields_.sortedToc())
    {
        const word& type = fields_[name];
        const bool onPoints = isOf(type, "point");
        if (sphericalOrFaces(type) || !(onPoints || isOf(type, "vol")))
        {
            left_.append(name);
            fields_.erase(name);
            continue;
        }
        dictionary of;
        string text;
        if (!empty)
        {
            of = contents(object(name));
        }
        if (Pstream::master())
        {
            dictionary common(of);
            dropLists(common);
            OStringStream os;
            os.precision(17);
            common.write(os, false);
            text = os.str();
        }
        Pstream::scatter(text);
        if (empty)
        {
            IStringStream is(text);
            of = dictionary(is);
        }
        (onPoints ? rows_.points.pointFields : rows_.gas).set(name, of);
    }
}

Foam::mpm::pointRows Foam::mpm::caseRows::readCloud(const word& name) const
{
    const fileName local(cloud::prefix / name);
    Cloud<passiveParticle> parcels(mesh_, name, false);
    const label n = parcels.size();
    pointRows rows;
    List<scalarList> values;
    rows.cells.setSize(n);
    for (const word& column : clouds_[name].sortedToc())
    {
        ofClass(
            clouds_[name][column],
            [&](const auto& zero)
            {
                typedef std::decay_t<decltype(zero)> Type;
                constexpr direction m = pTraits<Type>::nComponents;
                const IOobject io(object(column, local));
                const bool found = isFile(io.objectPath()) || isFile(io.objectPath() + ".gz");
                const Field<Type> f(found || n ? Field<Type>(IOField<Type>(io)) : Field<Type>());
                if (f.size() != n)
                {
                    FatalErrorInFunction << "File " << io.objectPath() << " has " << f.size()
                                         << " values for " << n << " points." << exit(FatalError);
                }
                rows.columns.append(column);
                rows.nComponents.append(m);
                values.append(scalarList(m * n));
                forAll(f, p)
                {
                    for (direction d = 0; d < m; ++d)
                    {
                        values.last()[m * p + d] = component(f[p], d);
                    }
                }
            });
    }
    rows.columns.append(parcelPosition);
    rows.nComponents.append(3);
    values.append(scalarList(3 * n));
    label p = 0;
    for (const passiveParticle& parcel : parcels)
    {
        const point x(parcel.position());
        for (direction d = 0; d < 3; ++d)
        {
            values.last()[3 * p + d] = x[d];
        }
        rows.cells[p++] = parcel.cell();
    }
    for (p = 0; p < n; ++p)
    {
        forAll(values, i)
        {
            const label m = rows.nComponents[i];
            rows.values.append(SubList<scalar>(values[i], m, m * p));
        }
    }
    return rows;
}

void Foam::mpm::caseRows::readUniform()
{
    if (Pstream::master())
    {
        const fileName folder(mesh_.time().timePath() / "uniform");
        DynamicList<fileName> names;
        addFiles(folder, fileName::null, names);

        // The state says that a time is complete: last
        std::sort(
            names.begin(), names.end(),
            [](const fileName& a, const fileName& b)
            {
                return (a == "materialPointState" ? 1 : 0) < (b == "materialPointState" ? 1 : 0)
                    || (a != "materialPointState" && b != "materialPointState" && a < b);
            });
        for (const fileName& name : names)
        {
            std::ifstream is(folder / name, std::ios::binary);
            std::ostringstream os;
            os << is.rdbuf();
            uniform_.append(Tuple2<fileName, string>(name, os.str()));
        }
    }
    Pstream::scatter(uniform_);
}

void Foam::mpm::caseRows::writeCloud(const word& name) const
{
    const pointRows& rows = rows_.points.points[name];
    const fileName local(cloud::prefix / name);
    const label n = rows.size(), size = rows.rowSize();
    Cloud<passiveParticle> parcels(mesh_, name, IDLList<passiveParticle>());

    // In the order of the solver: by cells, in them by ids
    const label ids = rows.place("id"), origIds = rows.place("origId");
    labelList order(identity(n));
    std::sort(
        order.begin(), order.end(),
        [&](const label p, const label q)
        {
            const label a = rows.cells[p], b = rows.cells[q];
            const bool less =
                ids < 0 ? p < q : rows.values[size * p + ids] < rows.values[size * q + ids];
            return a < b || (a == b && less);
        });
    for (const label p : order)
    {
        const scalar* row = &rows.values[size * p];
        const scalar* x = row + size - 3;
        auto parcel = mpm::parcelAt(mesh_, point(x[0], x[1], x[2]), rows.cells[p]);
        parcel->origProc() = 0;
        parcel->origId() = origIds < 0 ? p : label(row[origIds]);
        parcels.addParticle(parcel.ptr());
    }
    parcels.write();

    label at = 0;
    for (label i = 0; i < rows.columns.size() - 1; ++i)
    {
        ofClass(
            clouds_[name][rows.columns[i]],
            [&](const auto& zero)
            {
                typedef std::decay_t<decltype(zero)> Type;
                IOobject io(object(rows.columns[i], local));
                io.readOpt() = IOobject::NO_READ;
                IOField<Type> f(io, n);
                forAll(f, p)
                {
                    for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
                    {
                        setComponent(f[p], d) = rows.values[size * order[p] + at + d];
                    }
                }
                f.write(n > 0);
            });
        at += rows.nComponents[i];
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::caseRows::caseRows(const fvMesh& mesh, const bool empty) : mesh_(mesh)
{
    // Collective, so before processors without points go their own way
    mesh.tetBasePtIs();

    readFields(empty);
    HashTable<word> names;
    for (const fileName& name :
         readDir(mesh.time().timePath() / cloud::prefix, fileName::DIRECTORY))
    {
        names.set(name, name);
    }
    List<wordList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = names.sortedToc();
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    for (const wordList& of : all)
    {
        for (const word& name : of)
        {
            names.set(name, name);
        }
    }
    for (const word& name : names.sortedToc())
    {
        HashTable<word> columns(classes(cloud::prefix / name));
        for (const word& column : columns.sortedToc())
        {
            if (column == "positions" || column == "coordinates" || column == "origProcId")
            {
                columns.erase(column);
            }
            else if (!ofClass(columns[column], [](const auto&) {}))
            {
                left_.append(cloud::prefix / name / column);
                columns.erase(column);
            }
        }
        clouds_.set(name, columns);
        rows_.points.points.set(name, readCloud(name));
    }
    readUniform();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::mpm::caseRows::cellValues(const word& field, const bool empty) const
{
    if (!fields_.found(field) || fields_[field] != volScalarField::typeName)
    {
        FatalErrorInFunction << "There is no field " << field << ", the weightField of"
                             << " system/decomposeParDict, in " << mesh_.time().timePath() << "."
                             << exit(FatalError);
    }
    return empty ? scalarField()
                 : scalarField("internalField", contents(object(field)), mesh_.nCells());
}

Foam::label Foam::mpm::caseRows::nPoints() const
{
    label n = 0;
    forAllConstIters(rows_.points.points, iter) { n += iter.val().size(); }
    return n;
}

void Foam::mpm::caseRows::write() const
{
    const fullPrecision allDigits;
    const Time& time = mesh_.time();
    mesh_.tetBasePtIs();
    mkDir(time.timePath());
    for (const word& name : fields_.sortedToc())
    {
        const bool onPoints = rows_.points.pointFields.found(name);
        const IOobject io(object(name));
        OFstream os(
            io.objectPath(), time.writeFormat(), IOstream::currentVersion, time.writeCompression());
        io.writeHeader(os, fields_[name]);
        (onPoints ? rows_.points.pointFields : rows_.gas)[name].write(os, false);
        IOobject::writeEndDivider(os);
    }
    for (const word& name : clouds_.sortedToc())
    {
        writeCloud(name);
    }
    for (const Tuple2<fileName, string>& file : uniform_)
    {
        const fileName path(time.timePath() / "uniform" / file.first());
        mkDir(path.path());
        std::ofstream(path, std::ios::binary) << file.second();
    }
}
