/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "OSspecific.H"
#include "materialPointCloud.H"
#include "noTraps.H"
#include "fullPrecision.H"
#include "Cloud.H"
#include "passiveParticle.H"
#include "IOField.H"

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
}

// ************************************************************************* //
