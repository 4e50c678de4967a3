/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointCloud.H"
#include "HashTable.H"
#include "pointBlock.H"
#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(materialPointCloud, 0);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
void Foam::mpm::materialPointCloud::forStress(const Function& f)
{
    f(stress_);
    f(volume_);
    if (damage_) f(*damage_);
    for (column& h : history_) f(h);
}


std::vector<const Foam::mpm::column*>
Foam::mpm::materialPointCloud::ownColumns() const
{
    std::vector<const column*> own;
    for (const column& h : history_)
    {
        own.push_back(&h);
    }
    if (affine_)
    {
        own.push_back(&*affine_);
    }
    return own;
}


void Foam::mpm::materialPointCloud::reserve(label n)
{
    if (n > x_.capacity() || x_.capacity() == 0)
    {
        // Once full, it will happen again
        n = max(n, label(1.1*x_.capacity()));
        const label nOld = n_ + nArrived_;
        const auto grow = [&](column& c) { c.reserve(n, nOld); };
        forColumns(grow);
        grow(xNew_);
        grow(UNew_);
        if (affineNew_) grow(*affineNew_);
        if (gasPressure_)
        {
            grow(*gasPressure_);
            grow(*gasForce_);
        }
        scratch_ = alignedArray(n + column::padding);
    }
}


template<class Column, class Function>
void Foam::mpm::materialPointCloud::forComponents
(
    Column& c,
    const label pointi,
    const Function& f
) const
{
    // Computed directions first, the others after them
    const int D = grid_.nDim();
    int dir[3];
    bool used[3] = {false, false, false};
    for (int d = 0; d < D; ++d)
    {
        dir[d] = grid_.direction(d);
        used[dir[d]] = true;
    }
    for (int d = D, e = 0; d < 3; ++d)
    {
        while (used[e]) ++e;
        dir[d] = e;
        used[e] = true;
    }

    const column::kinds kind = c.kind();
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            const bool inside = i < D && j < D;
            if (inside || (kind == column::stresses && i == j))
            {
                const int slot =
                    kind == column::stresses ? symmSlot(i, j)
                  : kind == column::strains ? strainSlot(D, i, j)
                  : i*D + j;
                f(c[slot][pointi], 3*dir[i] + dir[j]);
            }
        }
    }
}


Foam::tensor Foam::mpm::materialPointCloud::tensorOf
(
    const column& c,
    const label pointi
) const
{
    tensor t(Zero);
    forComponents
    (c, pointi, [&](const scalar& a, const int i) { t[i] = a; });
    return t;
}


void Foam::mpm::materialPointCloud::setTensor
(
    column& c,
    const label pointi,
    const tensor& t
) const
{
    forComponents(c, pointi, [&](scalar& a, const int i) { a = t[i]; });
}


void Foam::mpm::materialPointCloud::setSigma
(
    const label pointi,
    const symmTensor& sigma
)
{
    setTensor(stress_, pointi, tensor(sigma));
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::materialPointCloud::materialPointCloud
(
    const hexGrid& grid,
    const word& name
)
:
    cloud(grid.mesh(), name),
    grid_(grid),
    n_(0),
    nextId_(0),
    start_(1, label(0)),
    firstMoved_(0),
    oldN_(0),
    nArrived_(0),
    sorted_(false),
    count_(grid.nCells(), label(0)),
    first_(grid.nCells(), label(0)),
    x_("x", column::vectors, grid.nDim()),
    U_("U", column::vectors, grid.nDim()),
    xNew_("xNew", column::vectors, grid.nDim()),
    UNew_("UNew", column::vectors, grid.nDim()),
    mass_("m", column::scalars, grid.nDim()),
    volume_("V", column::scalars, grid.nDim()),
    stress_("sigma", column::stresses, grid.nDim()),
    id_("id", column::scalars, grid.nDim()),
    affineRead_(false)
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::materialPointCloud::needHalfSize()
{
    halfSize_.reset(new column("halfSize", column::vectors, grid_.nDim()));
}


void Foam::mpm::materialPointCloud::needDamage()
{
    damage_.reset(new column("damage", column::scalars, grid_.nDim()));
}


void Foam::mpm::materialPointCloud::needStrength()
{
    strength_.reset(new column("strength", column::scalars, grid_.nDim()));
}


void Foam::mpm::materialPointCloud::needReference()
{
    reference_.reset(new column("X", column::vectors, grid_.nDim()));
}


void Foam::mpm::materialPointCloud::needTemperature()
{
    temperature_.reset(new column("T", column::scalars, grid_.nDim()));
}


void Foam::mpm::materialPointCloud::needAffine()
{
    affine_.reset(new column("C", column::tensors, grid_.nDim()));
    affineNew_.reset(new column("CNew", column::tensors, grid_.nDim()));
}


void Foam::mpm::materialPointCloud::needHistory
(
    const word& name,
    const column::kinds kind
)
{
    history_.emplace_back(name, kind, grid_.nDim());
}


void Foam::mpm::materialPointCloud::needGas()
{
    const int D = grid_.nDim();
    gasVolume_.reset(new column("gasVolume", column::scalars, D));
    displacement_.reset(new column("displacement", column::vectors, D));
    gasPressure_.reset(new column("gasPressure", column::scalars, D));
    gasForce_.reset(new column("gasForce", column::vectors, D));
}


void Foam::mpm::materialPointCloud::allocateGas()
{
    const label n = max(x_.capacity(), label(1));
    for (column* c : {&*gasVolume_, &*displacement_, &*gasPressure_, &*gasForce_})
    {
        c->reserve(n, 0);
    }
}


Foam::scalar Foam::mpm::materialPointCloud::bytesPerPoint() const
{
    materialPointCloud& me = const_cast<materialPointCloud&>(*this);

    // Tentative position, velocity and affine matrix, kept stress, scratch
    label nMore =
        2*grid_.nDim() + 1 + (affineNew_ ? affineNew_->nComponents() : 0);
    for (const column& c : kept_)
    {
        nMore += c.nComponents();
    }
    scalar perPoint = sizeof(scalar)*nMore;
    me.forColumns
    (
        [&](column& c) { perPoint += sizeof(scalar)*c.nComponents(); }
    );
    return
        (
            perPoint*(x_.capacity() + column::padding)
          + sizeof(label)*scalar
            (
                from_.size() + cells_.size() + start_.size()
              + oldCells_.size() + oldStart_.size() + count_.size()
              + first_.size()
            )
        )/max(n_, label(1));
}


Foam::label Foam::mpm::materialPointCloud::cellOf(const label pointi) const
{
    const auto next = std::upper_bound(start_.begin(), start_.end(), pointi);
    return cells_[label(next - start_.begin()) - 1];
}


Foam::point Foam::mpm::materialPointCloud::position
(
    const label pointi,
    const label celli
) const
{
    point p(grid_.mesh().cellCentres()[celli]);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        p[grid_.direction(d)] = x_[d][pointi];
    }
    return p;
}


Foam::vector Foam::mpm::materialPointCloud::velocity(const label pointi) const
{
    vector v(Zero);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        v[grid_.direction(d)] = U_[d][pointi];
    }
    return v;
}


Foam::symmTensor Foam::mpm::materialPointCloud::sigma(const label pointi) const
{
    return symm(tensorOf(stress_, pointi));
}


void Foam::mpm::materialPointCloud::add(const UList<newPoint>& points)
{
    const label n = n_ + points.size();
    const int D = grid_.nDim();

    reserve(n);

    labelList cell(n, label(-1));
    forAll(cells_, k)
    {
        for (label p = start_[k]; p < start_[k + 1]; ++p)
        {
            cell[p] = cells_[k];
        }
    }

    label near = -1;
    forAll(points, i)
    {
        const newPoint& from = points[i];
        const label p = n_ + i;

        scalar x[3];
        for (int d = 0; d < D; ++d)
        {
            x[d] = from.x[grid_.direction(d)];
        }
        label celli = near >= 0 ? grid_.locate(near, x) : -1;
        if (celli < 0)
        {
            celli = grid_.find(x);
        }
        if (celli < 0)
        {
            FatalErrorInFunction
                << "Material point " << nextId_ << " of " << name()
                << " at " << from.x << " lies outside the mesh "
                << grid_.mesh().bounds() << "." << exit(FatalError);
        }
        cell[p] = near = celli;

        for (int d = 0; d < D; ++d)
        {
            x_[d][p] = x[d];
            U_[d][p] = from.U[grid_.direction(d)];
            if (halfSize_)
            {
                (*halfSize_)[d][p] = from.halfSize[grid_.direction(d)];
            }
            if (reference_)
            {
                (*reference_)[d][p] = x[d];
            }
        }
        mass_[0][p] = from.mass;
        volume_[0][p] = from.volume;
        if (temperature_)
        {
            (*temperature_)[0][p] = from.T;
        }
        id_[0][p] = nextId_++;

        setSigma(p, from.sigma);
    }

    n_ = n;
    order(cell);
}


void Foam::mpm::materialPointCloud::take
(
    materialPointCloud& from,
    const UList<label>& cells
)
{
    const label n = n_ + cells.size();
    reserve(n);

    // A column that only one of both has: zero, or left behind
    HashTable<const column*> given;
    from.forColumns([&](const column& c) { given.insert(c.name(), &c); });
    forColumns
    (
        [&](column& c)
        {
            const column* source = given.lookup(c.name(), nullptr);
            for (int i = 0; i < c.nComponents(); ++i)
            {
                if (source)
                {
                    const scalar* values = (*source)[i] + from.n_;
                    std::copy(values, values + cells.size(), c[i] + n_);
                }
                else
                {
                    std::fill_n(c[i] + n_, cells.size(), 0.0);
                }
            }
        }
    );

    labelList cell(n);
    forAll(cells_, c)
    {
        for (label p = start_[c]; p < start_[c + 1]; ++p)
        {
            cell[p] = cells_[c];
        }
    }
    forAll(cells, i)
    {
        cell[n_ + i] = cells[i];
    }
    nextId_ = max(nextId_, from.nextId_);
    n_ = n;
    order(cell);
    sorted_ = false;
}


void Foam::mpm::materialPointCloud::keepStress()
{
    size_t k = 0;
    forStress
    (
        [&](column& c)
        {
            if (k == kept_.size())
            {
                kept_.emplace_back(c.name(), c.kind(), grid_.nDim());
            }
            column& to = kept_[k++];
            to.reserve(c.capacity(), 0);
            for (int i = 0; i < c.nComponents(); ++i)
            {
                std::copy(c[i], c[i] + n_, to[i]);
            }
        }
    );
}


void Foam::mpm::materialPointCloud::restoreStress()
{
    size_t k = 0;
    forStress
    (
        [&](column& c)
        {
            const column& from = kept_[k++];
            for (int i = 0; i < c.nComponents(); ++i)
            {
                std::copy(from[i], from[i] + n_, c[i]);
            }
        }
    );
}


// ************************************************************************* //
