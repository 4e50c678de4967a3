// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointRegion.H"
#include "dictionaryTools.H"
#include "meshShape.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const char* const unitAdvice =
    "if its unit is not m, write  scale  with the unit in m beside its file"
    " (1e-3 for mm, 1e-2 for cm, 0.0254 for inches).";

//- Units of drawings
const struct
{
    const char* text;
    Foam::scalar metres;
    const char* name;
} lengths[] = {{"1e-3", 1e-3, "mm"}, {"1e-2", 1e-2, "cm"}, {"0.0254", 0.0254, "inches"}};

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointRegion::local(const label sub, const label sample, scalar* xi) const
{
    label i = sub, k = sample;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        xi[d] = (i % n_[d] + (k % m_ + 0.5) / m_) / n_[d];
        i /= n_[d];
        k /= m_;
    }
}

void Foam::mpm::pointRegion::centre(const label sub, scalar* xi) const
{
    label i = sub;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        xi[d] = (i % n_[d] + 0.5) / n_[d];
        i /= n_[d];
    }
}

Foam::scalarField Foam::mpm::pointRegion::parts(const label celli, const hexMap& map) const
{
    // Sub-cells of a box are alike, but for the radius on a wedge
    scalarField part(nSub_, 1.0 / nSub_);
    if (!grid_.hasLattice() || grid_.radial() >= 0)
    {
        scalar xi[3];
        forAll(part, sub)
        {
            centre(sub, xi);
            part[sub] = map.determinant(xi);
            if (grid_.radial() >= 0)
            {
                part[sub] *= map.position(xi)[grid_.direction(grid_.radial())];
            }
        }
        if (!(min(part) > 0))
        {
            FatalErrorInFunction << "Cell " << celli << " at " << grid_.mesh().cellCentres()[celli]
                                 << " is folded over: the determinant of its map is " << min(part)
                                 << "; improve the mesh (checkMesh)." << exit(FatalError);
        }
        part /= sum(part);
    }
    return part;
}

void Foam::mpm::pointRegion::fill(const label celli, const scalar rho)
{
    const int nDim = grid_.nDim();
    const hexMap map(grid_, celli);

    const boundBox cellBox(map.bounds()), shapeBox(shape_->bounds());
    for (int d = 0; d < nDim; ++d)
    {
        const int c = grid_.direction(d);
        if (cellBox.min()[c] > shapeBox.max()[c] || cellBox.max()[c] < shapeBox.min()[c])
        {
            return;
        }
    }

    const scalar inCell = shares_ ? shares_->share(celli) : scalar(1);
    if (inCell <= 0)
    {
        return;
    }
    const label nBefore = points_.size();
    scalarField part;
    for (label sub = 0; sub < nSub_; ++sub)
    {
        cutPoint c;
        scalar share = 1;
        const int found = shares_ && inCell == 1 ? 1 : cutSubCell(celli, map, sub, c, share);
        if (found == 0)
        {
            continue;
        }
        if (part.empty())
        {
            part = parts(celli, map);
        }

        scalar xi[3];
        centre(sub, xi);
        materialPointCloud::newPoint p;
        p.x = map.position(xi);
        if (rings_.size())
        {
            const int r = grid_.radial();
            const label j = r == 0 ? sub % n_[0] : sub / n_[0];
            p.x[grid_.direction(r)] = rings_[grid_.lattice().ijk(celli, r) * n_[r] + j];
        }
        p.U = Zero;
        p.sigma = sigma_;
        p.T = T_;
        p.volume = grid_.mesh().cellVolumes()[celli] * part[sub] * volumeFraction_;
        if (found == 2)
        {
            p.volume *= share;
        }
        p.mass = rho * p.volume;
        p.halfSize = Zero;
        for (int d = 0; d < nDim; ++d)
        {
            p.halfSize[grid_.direction(d)] = mag(map.tangent(xi, d)) / (2 * n_[d]);
        }
        if (found == 2)
        {
            c.point = points_.size();
            cutOf_.insert(c.point, cut_.size());
            cut_.append(c);
        }
        sub_.append(sub);
        points_.append(p);
    }
    if (inCell < 1)
    {
        scaleTo(inCell, celli, nBefore, rho);
    }
    if (points_.size() > nBefore)
    {
        cells_.append(celli);
        start_.append(points_.size());
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointRegion::pointRegion(
    const pointGrid& grid, const dictionary& dict, const wordList& phases, const bool inGas) :
    grid_(grid),
    dict_(dict),
    name_(dict.dictName()),
    phase_(oneOf(dict, "phase", phases)),
    shape_(pointRegionShape::New(grid, dict)),
    sampled_(oneOfOrDefault(dict, "parts", "exact", {"exact", "sampled"}) == "sampled"),
    whole_(true),
    rows_(inGas && !sampled_ && standsInRows(grid, *shape_)),
    inGas_(inGas),
    byElements_(isA<meshShape>(*shape_) && !(inGas && grid.hasLattice()) && !sampled_),
    byCorners_(!grid.hasHexes()),
    emptyFaces_(gridNodes::emptyFaces(grid.mesh())),
    m_(boundedLabelOrDefault(dict, "samples", sampled_ ? 1 : 4, 1, 8)),
    volumeFraction_(boundedOrDefault(dict, "volumeFraction", 1, SMALL, 1)),
    T_(dict.found("temperature") ? positive(dict, "temperature") : 0),
    mayOverlap_(oneOfOrDefault(dict, "overlap", "forbid", {"allow", "forbid"}) == "allow"),
    mass_(0),
    volume_(0),
    density_(0),
    asked_(0),
    lost_(0)
{
    checkEntries();
    readPointsPerCell();
    setRings();
    if (grid_.hasLattice() && !sampled_ && !byElements_)
    {
        formula_.reset(new shapeFormula);
        if (!shape_->formula(*formula_))
        {
            formula_.clear();
            if (const triSurface* s = shape_->facets())
            {
                cutter_.reset(new facetCutter(grid_, n_, *s));
            }
        }
    }
    if (!sampled_ && !byElements_ && !formula_ && !cutter_)
    {
        shape_->formula(whole_);
        shares_.reset(new cellCutter(grid_, whole_, columns_));
    }
    readVelocity();
    readStress();
    start_.append(0);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pointRegion::checkTemperature(const bool hasTemperature) const
{
    if (hasTemperature)
    {
        requireKeyword(dict_, "temperature");
        if (T_ < 100)
        {
            IOWarningInFunction(dict_)
                << "Region " << name_ << " has the temperature " << T_ << ": it is in K. " << T_
                << " degrees Celsius are " << T_ + 273.15 << " K." << endl;
        }
    }
    else if (T_ > 0)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry temperature in region " << name_ << ": phase " << phase_
            << " has no heatTransfer in constant/phaseProperties and so no"
            << " temperature." << exit(FatalIOError);
    }
}

bool Foam::mpm::pointRegion::fromFile() const
{
    return shape_->facets() || isA<meshShape>(*shape_);
}

std::string Foam::mpm::pointRegion::bodyName() const
{
    return isA<meshShape>(*shape_) ? "body's mesh (file " + dict_.get<fileName>("file").name() + ")"
                                   : std::string(type());
}

Foam::scalar Foam::mpm::pointRegion::sizeRatio() const
{
    return bounds().mag() / mag(shape_->computed(grid_.mesh().bounds().span()));
}

Foam::string Foam::mpm::pointRegion::unitThatFits() const
{
    const boundBox body(bounds());
    const boundBox& mesh = grid_.mesh().bounds();
    for (const auto& unit : lengths)
    {
        bool fits = unit.metres * sizeRatio() > 0.01;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const int c = grid_.direction(d);
            const scalar more = 1e-3 * mesh.span()[c];
            fits = fits && unit.metres * body.min()[c] > mesh.min()[c] - more
                && unit.metres * body.max()[c] < mesh.max()[c] + more;
        }
        if (fits)
        {
            return "  scale " + string(unit.text) + ";  (" + unit.name
                + ") beside"
                  " its file would put it into the mesh.";
        }
    }
    return "";
}

Foam::string Foam::mpm::pointRegion::sizeHint() const
{
    // Drawings are in mm: a thousand times too large or, scaled twice, small
    const scalar ratio = sizeRatio();
    if (!fromFile())
    {
        return "";
    }
    const string fits(unitThatFits());
    if (ratio < 20 && ratio > 0.02)
    {
        const bool large = ratio > 2 && points_.empty() && fits.size();
        return large ? " Is its unit not m?" + fits : string();
    }
    return " The " + bodyName() + " is " + Foam::name(ratio)
        + " times as large as the"
          " mesh: "
        + (ratio < 1         ? "look at  scale  beside its file,"
                               " and in blockMeshDict."
               : fits.size() ? fits.substr(2)
                             : unitAdvice);
}

void Foam::mpm::pointRegion::checkScale() const
{
    // A thousand times the mesh, or a hundred times and at home in it in mm
    const scalar ratio = sizeRatio();
    const string fits(unitThatFits());
    if (fromFile() && (ratio >= 1000 || (ratio >= 100 && fits.find("1e-3") != string::npos)))
    {
        FatalIOErrorInFunction(dict_)
            << "Region " << name_ << ":" << sizeHint().c_str() << nl << "It lies in " << bounds()
            << " m, the mesh in " << grid_.mesh().bounds()
            << " m. If the mesh is meant to cut a part"
            << " out of it: a region of type intersection with a box around the"
            << " part." << exit(FatalIOError);
    }
}

void Foam::mpm::pointRegion::checkRoom() const
{
    const scalar all = volumeFraction_ * sum(grid_.mesh().cellVolumes());
    if (!fromFile() || volume_ < 0.999999 * all)
    {
        return;
    }
    const boundBox& mesh = grid_.mesh().bounds();
    const boundBox body(bounds());
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        const int c = grid_.direction(d);
        const scalar more = 1e-3 * mesh.span()[c];
        if (body.min()[c] > mesh.min()[c] - more || body.max()[c] < mesh.max()[c] + more)
        {
            return;
        }
    }
    FatalIOErrorInFunction(dict_) << "Region " << name_ << " fills the whole mesh " << mesh
                                  << ": the " << bodyName().c_str() << " of " << body.span()
                                  << " m from " << body.min() << " to " << body.max()
                                  << " is larger on all sides. It"
                                  << " is " << body.mag() / mag(shape_->computed(mesh.span()))
                                  << " times as large: " << unitAdvice << exit(FatalIOError);
}

void Foam::mpm::pointRegion::create(const scalar rho)
{
    const scalar density = dict_.found("density") ? positive(dict_, "density") : rho;
    density_ = density;
    checkScale();

    if (rows_)
    {
        fillRows(density);
    }
    else if (byElements_)
    {
        fillElements(density);
    }
    else
    {
        for (label celli = 0; celli < grid_.nCells(); ++celli)
        {
            byCorners_ ? fillCorners(celli, density) : fill(celli, density);
        }
    }
    if (!sampled_)
    {
        joinSmallParts();
        joinSmallCells();
        correct();
    }
    if (!grid_.hasLattice() && !sampled_)
    {
        fitParts();
    }
    else if (inGas_ && !sampled_)
    {
        placeInGas();
    }
    else
    {
        placeCutPoints();
    }
    cut_.clearStorage();
    cutOf_.clear();

    if (points_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "Region " << name_ << " has no points: no sub-cell of the mesh "
            << grid_.mesh().bounds() << " has a part in the " << bodyName().c_str()
            << ", which lies in " << shape_->bounds() << " [m]."
            << (shape_->facets() && grid_.nDim() < 3
                    ? " In 2D it is the section of the surface with the middle of the"
                      " mesh's thickness."
                    : "")
            << sizeHint().c_str() << exit(FatalIOError);
    }
    for (materialPointCloud::newPoint& p : points_)
    {
        p.U = velocityAt(p.x);
        mass_ += p.mass;
        volume_ += p.volume;
    }
    checkRoom();
}

Foam::scalar Foam::mpm::pointRegion::exactVolume() const
{
    return shape_->insideMesh() ? wholeVolume() : -1;
}

Foam::scalar Foam::mpm::pointRegion::askedVolume() const
{
    if (asked_ != 0)
    {
        return asked_;
    }
    asked_ = exactVolume();
    shapeFormula formula(true);
    shape_->formula(formula);
    bool tells = !byElements_;
    for (const pointRegionShape* body : formula.bodies())
    {
        tells = tells && body->facets();
    }
    if (asked_ > 0 || !tells)
    {
        return asked_;
    }
    cellCutter::columns columns;
    const cellCutter cutter(grid_, formula, columns);
    const scalarField& V = grid_.mesh().cellVolumes();
    const boundBox& mesh = grid_.mesh().bounds();
    const int r = grid_.radial() < 0 ? 0 : grid_.direction(grid_.radial());
    scalar box = shape_->section();
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        box *= mesh.span()[grid_.direction(d)];
    }
    box *= grid_.radial() < 0 ? scalar(1) : grid_.sector() * mesh.midpoint()[r];
    if (!formula.hasCells() && mag(sum(V) - box) < 1e-10 * box)
    {
        asked_ = volumeFraction_ * cutter.volumeInBounds();
        return asked_;
    }
    asked_ = 0;
    forAll(V, celli)
    {
        const boundBox cell(grid_.mesh().points(), grid_.mesh().cellPoints()[celli], false);
        bool apart = false;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const int c = grid_.direction(d);
            apart = apart || cell.min()[c] > shape_->bounds().max()[c]
                || cell.max()[c] < shape_->bounds().min()[c];
        }
        asked_ += apart ? 0 : volumeFraction_ * V[celli] * cutter.share(celli);
    }
    return asked_;
}

Foam::scalar Foam::mpm::pointRegion::wholeVolume() const
{
    const scalar v = cutter_ ? cutter_->volume() * shape_->section() : shape_->volume();
    return v < 0 ? -1 : v * volumeFraction_;
}

bool Foam::mpm::pointRegion::isAmbient() const
{
    return !hasStress() || token(dict_.lookup("stress")).isWord();
}

void Foam::mpm::pointRegion::setReferencePressure(const scalar p)
{
    if (!hasStress() && p > 0)
    {
        sigma_ = symmTensor(-p, 0, 0, -p, 0, -p);
    }
}

Foam::scalar Foam::mpm::pointRegion::widestCell() const
{
    scalar widest = 0;
    for (const label celli : cells_)
    {
        scalar size = 1;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            size *= grid_.width(celli, d);
        }
        widest = max(widest, std::pow(size, 1.0 / grid_.nDim()));
    }
    return widest;
}

Foam::boundBox Foam::mpm::pointRegion::bounds() const
{
    const boundBox bb(shape_->bounds());
    return boundBox(shape_->computed(bb.min()), shape_->computed(bb.max()));
}

Foam::boundBox Foam::mpm::pointRegion::pointBounds() const
{
    boundBox bb;
    for (const materialPointCloud::newPoint& p : points_)
    {
        bb.add(shape_->computed(p.x - p.halfSize));
        bb.add(shape_->computed(p.x + p.halfSize));
    }
    return bb;
}
