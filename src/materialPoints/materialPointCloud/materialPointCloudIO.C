/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointCloud.H"
#include "pointBlock.H"
#include "noTraps.H"
#include "fullPrecision.H"
#include "fatalMessages.H"
#include "Cloud.H"
#include "passiveParticle.H"
#include "IFstream.H"
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
    FatalErrorInFunction
        << "Field " << object.objectPath() << " has " << size
        << " values for " << n << " material points." << exit(FatalError);
}


//- Number of values that a field's file announces, -1 if it has none
label announced(const materialPointCloud& c, const word& name)
{
    IOobject object(c.columnObject(name, IOobject::MUST_READ));
    IFstream is(object.objectPath());
    if (!is.good() || !object.readHeader(is))
    {
        return -1;
    }
    const token first(is);
    return first.isLabel() ? first.labelToken() : -1;
}


//- Field of the current time; fatal if it is missing or of another length
template<class Type>
tmp<Field<Type>> readField
(
    const materialPointCloud& c,
    const word& name,
    const label n
)
{
    const IOobject object(c.columnObject(name, IOobject::MUST_READ));

    // Before there is memory for a wrong number of them
    const label nAnnounced = n < 0 ? -1 : announced(c, name);
    if (nAnnounced >= 0 && nAnnounced != n)
    {
        wrongSize(object, nAnnounced, n);
    }

    // OpenFOAM aborts on a broken list without naming the file
    autoPtr<IOField<Type>> fPtr
    (
        readNamed
        (
            object.objectPath(),
            [&] { return autoPtr<IOField<Type>>(new IOField<Type>(object)); }
        )
    );
    IOField<Type>& f = *fPtr;

    if (n >= 0 && f.size() != n)
    {
        wrongSize(object, f.size(), n);
    }
    return tmp<Field<Type>>::New(std::move(static_cast<Field<Type>&>(f)));
}


bool onDisk(const materialPointCloud& c, const word& name)
{
    const fileName path
    (
        c.time().path()/c.time().timeName()/cloud::prefix/c.name()/name
    );
    return isFile(path) || isFile(path + ".gz");
}

}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::mpm::materialPointCloud::columnObject
(
    const word& name,
    const IOobject::readOption r
) const
{
    return IOobject
    (
        name,
        time().timeName(),
        cloud::prefix/this->name(),
        db(),
        r,
        IOobject::NO_WRITE,
        false
    );
}


Foam::label Foam::mpm::materialPointCloud::ownCellBeside(const point& x) const
{
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
                const scalar size =
                    grid_.mesh().bounds().span()[grid_.direction(d)];
                xp[d] = xd + sign*((n >> d) & 1)*1e-10*size;
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


bool Foam::mpm::materialPointCloud::present(const word& name) const
{
    if (onDisk(*this, name))
    {
        return true;
    }

    // A time that a run has written has every column, one of setMaterialPoints
    // at least these: a missing one would silently start from zero
    const bool written = isFile
    (
        time().path()/time().timeName()/"uniform"/"materialPointState"
    );
    const bool ours = onDisk(*this, "x") && (name == "U" || name == "sigma");
    if (written || ours)
    {
        FatalErrorInFunction
            << "Column " << name << " of phase " << this->name()
            << " is missing in time " << time().timeName() << ", which was"
            << " written with it." << nl
            << "Restart from another time, or run setMaterialPoints."
            << exit(FatalError);
    }
    return false;
}


void Foam::mpm::materialPointCloud::readPositions
(
    const labelList& id,
    labelList& cell
)
{
    const int D = grid_.nDim();
    const label n = cell.size();

    vectorField x;
    if (present("x"))
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
        FatalErrorInFunction
            << "Cloud " << name() << " of time " << time().timeName()
            << " has " << x.size() << " positions for " << n
            << " masses." << exit(FatalError);
    }

    label near = -1;
    for (label p = 0; p < n; ++p)
    {
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
        }
        if (cell[p] < 0)
        {
            FatalErrorInFunction
                << "Material point " << id[p] << " of " << name()
                << " at " << x[p] << ", time " << time().timeName()
                << ", lies outside the mesh " << grid_.mesh().bounds()
                << "." << exit(FatalError);
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
    const int D = grid_.nDim();
    grid_.mesh().tetBasePtIs();

    // Overflow and NaN in the files are found below, by name
    const noTraps guard;

    if (!returnReduce(onDisk(*this, "m"), orOp<bool>()))
    {
        return -1;
    }

    // A processor without points has no files. One field at a time is in
    // memory beside the columns
    scalarField mass;
    if (onDisk(*this, "m"))
    {
        // Wrong if it agrees with neither of two other columns
        const bool agrees = announced(*this, "m") == announced(*this, "x");
        mass = readField<scalar>
        (
            *this,
            "m",
            agrees ? -1 : announced(*this, "V")
        );
    }
    const label n = mass.size();
    checkRecord(returnReduce(n, sumOp<label>()));
    labelList cell(n, label(-1));

    n_ = 0;
    reserve(n);
    n_ = n;

    if (n)
    {
        labelList id;
        for (const word name : {"id", "origId"})
        {
            if (id.empty() && onDisk(*this, name))
            {
                id = readField<label>(*this, name, n);
            }
        }
        if (id.empty())
        {
            FatalErrorInFunction
                << "Cloud " << name() << " of time " << time().timeName()
                << " has no file id in "
                << columnObject("id", IOobject::NO_READ).objectPath().path()
                << "." << nl
                << "Points are known by their ids (strengths that scatter,"
                << " probes, restarts): run setMaterialPoints again, or copy"
                << " the file back." << exit(FatalError);
        }
        for (label p = 0; p < n; ++p)
        {
            if (id[p] < 0)
            {
                FatalErrorInFunction
                    << "Cloud " << name() << " of time " << time().timeName()
                    << " has a material point with the id " << id[p]
                    << "; ids must not be negative." << exit(FatalError);
            }
            id_[0][p] = id[p];
        }

        readPositions(id, cell);

        const auto check = [&]
        (
            const label p,
            const bool good,
            const word& name,
            const string& value,
            const char* rule
        )
        {
            if (!good)
            {
                FatalErrorInFunction
                    << "Material point " << id[p] << " of " << this->name()
                    << " at " << position(p, cell[p]) << ", time "
                    << time().timeName() << ": " << name << " is "
                    << value.c_str() << "; it must be " << rule << "."
                    << exit(FatalError);
            }
        };

        const auto positiveField = [&]
        (
            const scalarField& f,
            const word& name,
            const scalar limit,
            const char* rule,
            column& c
        )
        {
            for (label p = 0; p < n; ++p)
            {
                check
                (
                    p,
                    f[p] > 0 && f[p] < limit,
                    name,
                    Foam::name(f[p]),
                    rule
                );
                c[0][p] = f[p];
            }
        };

        positiveField
        (
            mass,
            "m (mass)",
            VGREAT,
            "finite and greater than 0",
            mass_
        );
        mass.clear();
        positiveField
        (
            readField<scalar>(*this, "V", n)(),
            "V (volume)",
            1e3*grid_.mesh().bounds().volume(),
            "greater than 0 and not far above that of the mesh",
            volume_
        );

        if (present("U"))
        {
            const vectorField U(readField<vector>(*this, "U", n));
            for (label p = 0; p < n; ++p)
            {
                check
                (
                    p,
                    std::isfinite(magSqr(U[p])),
                    "U (velocity)",
                    Foam::name(mag(U[p])),
                    "finite"
                );
                for (int d = 0; d < D; ++d)
                {
                    U_[d][p] = U[p][grid_.direction(d)];
                }
            }
        }
        if (present("sigma"))
        {
            const symmTensorField sigma
            (
                readField<symmTensor>(*this, "sigma", n)
            );
            for (label p = 0; p < n; ++p)
            {
                check
                (
                    p,
                    std::isfinite(magSqr(sigma[p])),
                    "sigma (stress)",
                    Foam::name(mag(sigma[p])),
                    "finite"
                );
                setSigma(p, sigma[p]);
            }
        }

        if (halfSize_)
        {
            const vectorField h(readField<vector>(*this, "halfSize", n));
            for (label p = 0; p < n; ++p)
            {
                for (int d = 0; d < D; ++d)
                {
                    const scalar hd = h[p][grid_.direction(d)];
                    if (!(hd > 0))
                    {
                        FatalErrorInFunction
                            << "Material point " << id[p] << " of " << name()
                            << " at " << position(p, cell[p]) << ", time "
                            << time().timeName()
                            << ", has halfSize " << h[p]
                            << "; it must be greater than 0 in the computed"
                            << " directions." << exit(FatalError);
                    }
                    (*halfSize_)[d][p] = hd;
                }
            }
        }
        if (reference_)
        {
            // Absent where another tool has made the points: they start here
            const vectorField X
            (
                readField<vector>(*this, present("X") ? "X" : "x", n)
            );
            for (label p = 0; p < n; ++p)
            {
                check
                (
                    p,
                    std::isfinite(magSqr(X[p])),
                    "X (reference position)",
                    Foam::name(mag(X[p])),
                    "finite"
                );
                for (int d = 0; d < D; ++d)
                {
                    (*reference_)[d][p] = X[p][grid_.direction(d)];
                }
            }
        }
        if (damage_ && present("damage"))
        {
            const scalarField f(readField<scalar>(*this, "damage", n));
            for (label p = 0; p < n; ++p)
            {
                check
                (
                    p,
                    f[p] >= 0 && f[p] <= 1,
                    "damage",
                    Foam::name(f[p]),
                    "in [0, 1]"
                );
            }
            std::copy(f.begin(), f.end(), (*damage_)[0]);
        }

        if (temperature_)
        {
            if (!present("T"))
            {
                FatalErrorInFunction
                    << "Phase " << this->name() << " has heatTransfer, but"
                    << " its points of time " << time().timeName()
                    << " have no column T (temperature)." << nl
                    << "Run setMaterialPoints, with the entry temperature in"
                    << " its regions." << exit(FatalError);
            }
            positiveField
            (
                readField<scalar>(*this, "T", n)(),
                "T (temperature)",
                1e9,
                "greater than 0 and less than 1e9 K",
                *temperature_
            );
        }

        for (const column* own : ownColumns())
        {
            column& h = const_cast<column&>(*own);

            // Absent at the start of a run: the law's initial state. The
            // affine matrix also where another transfer has written the time
            const bool isAffine = affine_ && own == &*affine_;
            if (!(isAffine ? onDisk(*this, h.name()) : present(h.name())))
            {
                continue;
            }
            affineRead_ = affineRead_ || isAffine;
            if (h.kind() == column::scalars)
            {
                const scalarField f(readField<scalar>(*this, h.name(), n));
                std::copy(f.begin(), f.end(), h[0]);
            }
            else if (h.kind() == column::tensors)
            {
                const tensorField f(readField<tensor>(*this, h.name(), n));
                for (label p = 0; p < n; ++p)
                {
                    setTensor(h, p, f[p]);
                }
            }
            else
            {
                const symmTensorField f
                (
                    readField<symmTensor>(*this, h.name(), n)
                );
                for (label p = 0; p < n; ++p)
                {
                    setTensor(h, p, tensor(f[p]));
                }
            }
        }

        for (const column* own : ownColumns())
        {
            const column& h = *own;
            for (int i = 0; i < h.nComponents(); ++i)
            {
                for (label p = 0; p < n; ++p)
                {
                    check
                    (
                        p,
                        std::isfinite(sqr(h[i][p])),
                        h.name(),
                        Foam::name(h[i][p]),
                        "finite, and its square as well"
                    );
                }
            }
        }

        // Ids must be unique: they name points for ever
        labelList sortedIds(id);
        Foam::sort(sortedIds);
        for (label i = 1; i < n; ++i)
        {
            if (sortedIds[i] == sortedIds[i - 1])
            {
                FatalErrorInFunction
                    << "Cloud " << name() << " of time " << time().timeName()
                    << " has two material points with id " << sortedIds[i]
                    << "." << exit(FatalError);
            }
        }
        nextId_ = sortedIds.last() + 1;
    }

    order(cell);
    reduce(nextId_, maxOp<scalar>());

    return returnReduce(n_, sumOp<label>());
}


// ************************************************************************* //
