/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointRegion.H"
#include "selector.H"
#include "labelVector.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointRegion::checkEntries() const
{
    wordList valid
    ({
        "phase", "type", "pointsPerCell", "samples", "velocity", "stress",
        "pressure", "volumeFraction", "density", "overlap"
    });
    valid.append(shape_->keywords());
    checkKeywords(dict_, valid);
}


void Foam::mpm::pointRegion::readPointsPerCell()
{
    const word key("pointsPerCell");
    const token first(dict_.lookup(key));
    const labelVector perAxis
    (
        first.isNumber()
      ? labelVector::uniform(dict_.get<label>(key))
      : dict_.get<labelVector>(key)
    );

    nSub_ = nSamples_ = 1;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        n_[d] = perAxis[grid_.direction(d)];
        if (n_[d] < 1 || n_[d] > 16)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry " << key << " asks for " << n_[d]
                << " points in direction " << "xyz"[grid_.direction(d)]
                << " of a cell; it must be 1 to 16." << exit(FatalIOError);
        }
        nSub_ *= n_[d];
        nSamples_ *= m_;
    }
}


void Foam::mpm::pointRegion::readVelocity()
{
    U_ = dict_.getOrDefault<vector>("velocity", Zero);

    vector rest(U_);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        rest[grid_.direction(d)] = 0;
    }
    if (rest != vector(Zero))
    {
        FatalIOErrorInFunction(dict_)
            << "The velocity " << U_ << " has a component in an empty"
            << " direction of the mesh; it must be 0." << exit(FatalIOError);
    }
}


void Foam::mpm::pointRegion::readStress()
{
    sigma_ = Zero;

    const bool found = dict_.found("stress");
    const bool ambient = found && token(dict_.lookup("stress")).isWord();

    if (ambient)
    {
        oneOf(dict_, "stress", {"ambient"});
        const scalar p = dict_.get<scalar>("pressure");
        sigma_ = symmTensor(-p, 0, 0, -p, 0, -p);
        return;
    }
    if (dict_.found("pressure"))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry pressure only goes with:  stress ambient;"
            << exit(FatalIOError);
    }
    if (!found)
    {
        return;
    }

    sigma_ = dict_.get<symmTensor>("stress");

    bool isComputed[3] = {false, false, false};
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        isComputed[grid_.direction(d)] = true;
    }
    if
    (
        (sigma_.xy() != 0 && !(isComputed[0] && isComputed[1]))
     || (sigma_.xz() != 0 && !(isComputed[0] && isComputed[2]))
     || (sigma_.yz() != 0 && !(isComputed[1] && isComputed[2]))
    )
    {
        FatalIOErrorInFunction(dict_)
            << "The stress (xx xy xz yy yz zz) " << sigma_ << " has shear in"
            << " an empty direction of the mesh; it must be 0."
            << exit(FatalIOError);
    }
}


void Foam::mpm::pointRegion::local
(
    const label sub,
    const label sample,
    scalar* xi
) const
{
    label i = sub, k = sample;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        xi[d] = (i % n_[d] + (k % m_ + 0.5)/m_)/n_[d];
        i /= n_[d];
        k /= m_;
    }
}


void Foam::mpm::pointRegion::centre(const label sub, scalar* xi) const
{
    label i = sub;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        xi[d] = (i % n_[d] + 0.5)/n_[d];
        i /= n_[d];
    }
}


void Foam::mpm::pointRegion::fill(const label celli, const scalar rho)
{
    const int nDim = grid_.nDim();
    const hexMap map(grid_, celli);

    const boundBox cellBox(map.bounds()), shapeBox(shape_->bounds());
    for (int d = 0; d < nDim; ++d)
    {
        const int c = grid_.direction(d);
        if
        (
            cellBox.min()[c] > shapeBox.max()[c]
         || cellBox.max()[c] < shapeBox.min()[c]
        )
        {
            return;
        }
    }

    scalar xi[3];
    pointField x(nSub_*nSamples_);
    forAll(x, i)
    {
        local(i/nSamples_, i % nSamples_, xi);
        x[i] = map.position(xi);
    }
    const boolList inside(shape_->contains(celli, x));
    if (!inside.found(true))
    {
        return;
    }

    // Parts of the cell's volume; sub-cells of a box are alike
    scalarField part(nSub_, 1.0/nSub_);
    if (!grid_.hasLattice())
    {
        forAll(part, sub)
        {
            centre(sub, xi);
            part[sub] = map.determinant(xi);
        }
        if (!(min(part) > 0))
        {
            FatalErrorInFunction
                << "Cell " << celli << " at "
                << grid_.mesh().cellCentres()[celli]
                << " is folded over: the determinant of its map is "
                << min(part) << "; improve the mesh (checkMesh)."
                << exit(FatalError);
        }
        part /= sum(part);
    }

    cells_.append(celli);
    for (label sub = 0; sub < nSub_; ++sub)
    {
        label nInside = 0;
        for (label i = 0; i < nSamples_; ++i)
        {
            nInside += inside[sub*nSamples_ + i] ? 1 : 0;
        }
        if (!nInside)
        {
            continue;
        }

        centre(sub, xi);
        materialPointCloud::newPoint p;
        p.x = map.position(xi);
        p.U = U_;
        p.sigma = sigma_;
        p.volume =
            grid_.mesh().cellVolumes()[celli]*part[sub]*volumeFraction_
           *(scalar(nInside)/nSamples_);
        p.mass = rho*p.volume;
        p.halfSize = Zero;
        for (int d = 0; d < nDim; ++d)
        {
            p.halfSize[grid_.direction(d)] = mag(map.tangent(xi, d))/(2*n_[d]);
        }

        sub_.append(sub);
        points_.append(p);
        mass_ += p.mass;
        volume_ += p.volume;
    }
    start_.append(points_.size());
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointRegion::pointRegion
(
    const hexGrid& grid,
    const dictionary& dict,
    const wordList& phases
)
:
    grid_(grid),
    dict_(dict),
    name_(dict.dictName()),
    phase_(oneOf(dict, "phase", phases)),
    shape_(pointRegionShape::New(grid, dict)),
    m_(dict.getOrDefault<label>("samples", 1)),
    volumeFraction_
    (
        boundedOrDefault(dict, "volumeFraction", 1, SMALL, 1)
    ),
    mayOverlap_
    (
        oneOfOrDefault(dict, "overlap", "forbid", {"allow", "forbid"})
     == "allow"
    ),
    mass_(0),
    volume_(0)
{
    checkEntries();
    boundedOrDefault(dict, "samples", 1, 1, 8);
    readPointsPerCell();
    readVelocity();
    readStress();
    start_.append(0);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pointRegion::create(const scalar rho)
{
    const scalar density =
        dict_.found("density") ? positive(dict_, "density") : rho;

    for (label celli = 0; celli < grid_.nCells(); ++celli)
    {
        fill(celli, density);
    }

    if (points_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "Region " << name_ << " has no points: no sub-cell of the mesh "
            << grid_.mesh().bounds() << " has "
            << (m_ > 1 ? "a sample position" : "its centre")
            << " in the " << shape_->type() << ", which lies in "
            << shape_->bounds() << "." << exit(FatalIOError);
    }
}


Foam::scalar Foam::mpm::pointRegion::exactVolume() const
{
    const scalar v = shape_->volume();
    return v < 0 || !shape_->insideMesh() ? -1 : v*volumeFraction_;
}

// ************************************************************************* //
