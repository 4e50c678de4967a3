/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "OSspecific.H"
#include "materialPointCloud.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "fullPrecision.H"
#include "Cloud.H"
#include "passiveParticle.H"
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
    record.write(os, false);
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
    checkKeywords(record, {"nCells", "min", "max", "points"});
    const dictionary now(meshRecord());
    const auto size = mag(now.get<vector>("max") - now.get<vector>("min"));
    const label nCells = record.get<label>("nCells");
    if
    (
        nCells != now.get<label>("nCells")
     || mag(record.get<vector>("min") - now.get<vector>("min")) > 1e-6*size
     || mag(record.get<vector>("max") - now.get<vector>("max")) > 1e-6*size
    )
    {
        FatalIOErrorInFunction(record)
            << "The mesh is not that of the points of " << name()
            << ", time " << time().timeName() << ": it has "
            << now.get<label>("nCells") << " cells in "
            << now.get<vector>("min") << ' ' << now.get<vector>("max")
            << ", the points were written with " << nCells << " cells in "
            << record.get<vector>("min") << ' ' << record.get<vector>("max")
            << "." << nl
            << "Scale or refine a mesh before setMaterialPoints, and run that"
            << " again." << exit(FatalIOError);
    }
    const dictionary& points = record.subDict("points");
    const label written = points.getOrDefault<label>(name(), max(n, label(0)));
    if (max(n, label(0)) != written)
    {
        FatalIOErrorInFunction(points)
            << "There are " << max(n, label(0)) << " material points of "
            << name() << " at time " << time().timeName() << ", but "
            << written << " were written: a part of "
            << cloud::prefix/name() << " is missing"
            << (Pstream::parRun() ? ", perhaps of one processor." : ".") << nl
            << "Start from a time that is complete; "
            << (Pstream::parRun() ? "run decomposePar again."
                                  : "run setMaterialPoints again.")
            << exit(FatalIOError);
    }
}


Foam::fileName Foam::mpm::materialPointCloud::recordFile() const
{
    return time().path()/time().timeName()/"uniform"/"materialPointMesh";
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::materialPointCloud::writePoints() const
{
    const int D = grid_.nDim();
    const noTraps guard;

    // An earlier run may have had points at this time
    const fileName folder
    (
        time().path()/time().timeName()/cloud::prefix/name()
    );
    if (!n_ && isDir(folder))
    {
        rmDir(folder);
    }

    // Positions for other tools
    Cloud<passiveParticle> parcels
    (
        grid_.mesh(),
        name(),
        IDLList<passiveParticle>()
    );
    labelList cell(n_);
    forAll(cells_, k)
    {
        for (label p = start_[k]; p < start_[k + 1]; ++p)
        {
            cell[p] = cells_[k];
            passiveParticle* parcel = new passiveParticle
            (
                grid_.mesh(),
                position(p, cells_[k]),
                cells_[k]
            );
            parcel->origProc() = 0;
            parcel->origId() = label(id_[0][p]);
            parcels.addParticle(parcel);
        }
    }
    parcels.write();

    const fullPrecision allDigits;

    writeField<vector>
    (*this, "x", n_, [&](label p) { return position(p, cell[p]); });
    writeField<vector>
    (*this, "U", n_, [&](label p) { return velocity(p); });
    writeField<scalar>
    (*this, "m", n_, [&](label p) { return mass_[0][p]; });
    writeField<scalar>
    (*this, "V", n_, [&](label p) { return volume_[0][p]; });
    writeField<symmTensor>
    (*this, "sigma", n_, [&](label p) { return sigma(p); });
    writeField<label>
    (*this, "id", n_, [&](label p) { return label(id_[0][p]); });

    if (halfSize_)
    {
        writeField<vector>
        (
            *this, "halfSize", n_,
            [&](label p)
            {
                vector v(Zero);
                for (int d = 0; d < D; ++d)
                {
                    v[grid_.direction(d)] = (*halfSize_)[d][p];
                }
                return v;
            }
        );
    }
    if (reference_)
    {
        writeField<vector>
        (
            *this, "X", n_,
            [&](label p)
            {
                point X(position(p, cell[p]));
                for (int d = 0; d < D; ++d)
                {
                    X[grid_.direction(d)] = (*reference_)[d][p];
                }
                return X;
            }
        );
    }
    if (damage_)
    {
        writeField<scalar>
        (*this, "damage", n_, [&](label p) { return (*damage_)[0][p]; });
    }
    if (temperature_)
    {
        writeField<scalar>
        (*this, "T", n_, [&](label p) { return (*temperature_)[0][p]; });
    }
    for (const column* own : ownColumns())
    {
        const column& h = *own;
        if (h.kind() == column::scalars)
        {
            writeField<scalar>
            (*this, h.name(), n_, [&](label p) { return h[0][p]; });
        }
        else if (h.kind() == column::tensors)
        {
            writeField<tensor>
            (*this, h.name(), n_, [&](label p) { return tensorOf(h, p); });
        }
        else
        {
            writeField<symmTensor>
            (*this, h.name(), n_, [&](label p) { return symm(tensorOf(h, p)); });
        }
    }

    // For the eye: pressure, not by the name of the gas' field, whose colours
    // ParaView would share, and equivalent stress
    writeField<scalar>
    (*this, "pPoint", n_, [&](label p) { return -tr(sigma(p))/3; });
    writeField<scalar>
    (
        *this, "sigmaEq", n_,
        [&](label p) { return std::sqrt(1.5)*mag(dev(sigma(p))); }
    );
    writeRecord();
}

// ************************************************************************* //
