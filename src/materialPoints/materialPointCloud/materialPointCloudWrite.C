// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "OSspecific.H"
#include "materialPointCloud.H"
#include "parcelAt.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "fullPrecision.H"
#include "version.H"
#include "Cloud.H"
#include "IOField.H"
#include "IFstream.H"
#include "OFstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

template<class Type, class Get>
void writeField(const materialPointCloud& c, const word& name, const label n, const Get& get)
{
    IOField<Type> f(c.columnObject(name, IOobject::NO_READ), n);
    for (label p = 0; p < n; ++p)
    {
        f[p] = get(p);
    }
    f.note() = version;
    f.write(n > 0);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::mpm::materialPointCloud::meshRecord() const
{
    dictionary record;
    record.add("nCells", returnReduce(grid_.nCells(), sumOp<label>()));
    record.add("min", grid_.mesh().bounds().min());
    record.add("max", grid_.mesh().bounds().max());
    return record;
}

void Foam::mpm::materialPointCloud::writeRecord() const
{
    const fullPrecision allDigits;
    const fileName file(recordFile());
    dictionary record(meshRecord());
    dictionary points;
    if (isFile(file))
    {
        IFstream is(file);
        points = dictionary(is).subOrEmptyDict("points");
    }
    points.set(name(), returnReduce(n_, sumOp<label>()));
    record.add("points", points);
    mkDir(file.path());
    OFstream os(file);
    os.precision(17);
    os << "// " << version << nl;
    record.write(os, false);
}

void Foam::mpm::materialPointCloud::checkMesh() const
{
    // Overflow and NaN in the file are another mesh
    const noTraps guard;
    const fileName file(recordFile());
    if (!returnReduce(isFile(file), andOp<bool>()))
    {
        return;
    }
    IFstream is(file);
    const dictionary record(is);
    checkKeywords(record, {"nCells", "min", "max", "points"});
    const dictionary now(meshRecord());
    const auto size = mag(now.get<vector>("max") - now.get<vector>("min"));
    const label nCells = record.get<label>("nCells");
    if (nCells != now.get<label>("nCells")
        || mag(record.get<vector>("min") - now.get<vector>("min")) > 1e-6 * size
        || mag(record.get<vector>("max") - now.get<vector>("max")) > 1e-6 * size)
    {
        FatalIOErrorInFunction(record)
            << "The mesh is not that of the points of " << name() << ", time " << time().timeName()
            << ": it has " << now.get<label>("nCells") << " cells in " << now.get<vector>("min")
            << ' ' << now.get<vector>("max") << ", the points were written with " << nCells
            << " cells in " << record.get<vector>("min") << ' ' << record.get<vector>("max") << "."
            << nl << "Scale or refine a mesh before setMaterialPoints, and run that"
            << " again." << exit(FatalIOError);
    }
}

void Foam::mpm::materialPointCloud::checkRecord(const label n) const
{
    const fileName file(recordFile());
    if (!returnReduce(isFile(file), andOp<bool>()))
    {
        return;
    }
    IFstream is(file);
    const dictionary record(is);
    const dictionary& points = record.subDict("points");
    const label written = points.getOrDefault<label>(name(), max(n, label(0)));
    if (max(n, label(0)) != written)
    {
        FatalIOErrorInFunction(points)
            << "There are " << max(n, label(0)) << " material points of " << name() << " at time "
            << time().timeName() << ", but " << written << " were written: a part of "
            << cloud::prefix / name() << " is missing"
            << (Pstream::parRun() ? ", perhaps of one processor." : ".") << nl
            << "Start from a time that is complete; "
            << (Pstream::parRun() ? "run decomposePar again." : "run setMaterialPoints again.")
            << exit(FatalIOError);
    }
}

Foam::fileName Foam::mpm::materialPointCloud::recordFile() const
{
    return time().path() / time().timeName() / "uniform" / "materialPointMesh";
}

void Foam::mpm::materialPointCloud::writeParcels(const labelList& cell) const
{
    Cloud<passiveParticle> parcels(grid_.mesh(), name(), IDLList<passiveParticle>());
    forAll(cell, p)
    {
        auto parcel = parcelAt(grid_.mesh(), position(p, cell[p]), cell[p]);
        parcel->origProc() = 0;
        parcel->origId() = label(id_[0][p]);
        parcels.addParticle(parcel.ptr());
    }
    parcels.write();
}

void Foam::mpm::materialPointCloud::writeColumn(const cloudColumn& c, const labelList& cell) const
{
    switch (c.kind())
    {
    case column::scalars:
        writeField<scalar>(*this, c.name(), n_, [&](label p) { return c[0][p]; });
        break;
    case column::vectors:
        writeField<vector>(
            *this, c.name(), n_,
            [&](label p)
            {
                vector v(Zero);
                if (c.rules().isPosition)
                {
                    v = position(p, cell[p]);
                }
                for (int d = 0; d < grid_.nDim(); ++d)
                {
                    v[grid_.direction(d)] = c[d][p];
                }
                return v;
            });
        break;
    case column::tensors:
        writeField<tensor>(*this, c.name(), n_, [&](label p) { return tensorOf(c, p); });
        break;
    default:
        writeField<symmTensor>(*this, c.name(), n_, [&](label p) { return symm(tensorOf(c, p)); });
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::materialPointCloud::writePoints() const
{
    const noTraps guard;

    // An earlier run may have had points at this time
    const fileName folder(time().path() / time().timeName() / cloud::prefix / name());
    if (!n_ && isDir(folder))
    {
        rmDir(folder);
    }

    const labelList cell(cellsOfPoints(n_));
    writeParcels(cell);

    const fullPrecision allDigits;

    for (const cloudColumn& c : columns_)
    {
        if (c.rules().inFiles != columnRules::none)
        {
            writeColumn(c, cell);
        }
    }
    writeField<label>(*this, "id", n_, [&](label p) { return label(id_[0][p]); });

    // For the eye: pressure, not by the name of the gas' field, whose colours
    // ParaView would share, and equivalent stress
    writeField<scalar>(*this, "pPoint", n_, [&](label p) { return -tr(sigma(p)) / 3; });
    writeField<scalar>(
        *this, "sigmaEq", n_, [&](label p) { return std::sqrt(1.5) * mag(dev(sigma(p))); });
    writeRecord();
}
