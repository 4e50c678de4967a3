// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointCloud.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(materialPointCloud, 0);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::mpm::materialPointCloud::cellsOfPoints(const label n) const
{
    labelList cell(n, label(-1));
    forCells([&](const label p, const label celli) { cell[p] = celli; });
    return cell;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::materialPointCloud::materialPointCloud(const pointGrid& grid, const word& name) :
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
    x_(declare("x", column::vectors, columnRules(columnRules::key).position().withTentative())),
    U_(declare(
        "U", column::vectors, columnRules(columnRules::sinceStart, "velocity").withTentative())),
    mass_(declare(
        "m", column::scalars,
        columnRules(columnRules::key, "mass").positive(VGREAT, "finite and greater than 0"))),
    volume_(declare(
        "V", column::scalars,
        columnRules(columnRules::required, "volume")
            .changesWithStress()
            .positive(
                1e3 * grid.mesh().bounds().volume(),
                "greater than 0 and not far above that of the mesh"))),
    stress_(declare(
        "sigma", column::stresses,
        columnRules(columnRules::sinceStart, "stress").changesWithStress())),
    // Written and read as labels: writePoints(), readIds()
    id_(declare("id", column::scalars, columnRules(columnRules::none))),
    xNew_(x_.tentative()),
    UNew_(U_.tentative()),
    halfSize_(nullptr),
    damage_(nullptr),
    strength_(nullptr),
    reference_(nullptr),
    temperature_(nullptr),
    affine_(nullptr),
    hint_(nullptr),
    gasVolume_(nullptr),
    displacement_(nullptr),
    gasPressure_(nullptr),
    gasForce_(nullptr)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::materialPointCloud::cellOf(const label pointi) const
{
    const auto next = std::upper_bound(start_.begin(), start_.end(), pointi);
    return cells_[label(next - start_.begin()) - 1];
}

Foam::point Foam::mpm::materialPointCloud::position(const label pointi, const label celli) const
{
    point p(grid_.mesh().cellCentres()[celli]);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        p[grid_.direction(d)] = x_[d][pointi];
    }
    return p;
}

void Foam::mpm::materialPointCloud::add(const UList<newPoint>& points)
{
    const label n = n_ + points.size();
    const int D = grid_.nDim();

    reserve(n);

    for (cloudColumn& c : columns_)
    {
        c.fill(n_, n);
    }
    labelList cell(cellsOfPoints(n));

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
            FatalErrorInFunction << "Material point " << nextId_ << " of " << name() << " at "
                                 << from.x << " lies outside the mesh " << grid_.mesh().bounds()
                                 << "." << exit(FatalError);
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

void Foam::mpm::materialPointCloud::take(materialPointCloud& from, const UList<label>& cells)
{
    const label n = n_ + cells.size();
    reserve(n);

    // A column that the source lacks starts from its initial values
    forCarried(
        [&](cloudColumn& c)
        {
            const cloudColumn* source = from.findColumn(c.name());
            if (!source || !source->rules().carried)
            {
                c.fill(n_, n);
                return;
            }
            for (int i = 0; i < c.nComponents(); ++i)
            {
                const scalar* values = (*source)[i] + from.n_;
                std::copy(values, values + cells.size(), c[i] + n_);
            }
        });

    labelList cell(cellsOfPoints(n));
    forAll(cells, i)
    {
        cell[n_ + i] = cells[i];
    }
    nextId_ = max(nextId_, from.nextId_);
    n_ = n;
    order(cell);
    sorted_ = false;
}
