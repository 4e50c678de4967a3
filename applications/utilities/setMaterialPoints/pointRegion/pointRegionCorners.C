// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointRegion.H"
#include "cornerRegions.H"
#include "simplexParts.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointRegion::cutRegions(
    const label celli, const cellParts& c, scalarField& part, pointField& x) const
{
    List<volumeMoment> in(c.size());
    for (const cellParts::simplex& s : c.simplices())
    {
        in[s.part].add(1, inShape(celli, s));
    }
    forAll(in, i)
    {
        part[i] = in[i].V / c.volume()[i];
    }
    // A small one joins the nearest of the others, which are left as they are
    const bool small = max(part) < smallPart;
    boolList joins(in.size(), false);
    forAll(in, i)
    {
        joins[i] = small ? i != findMax(part) : part[i] < smallPart;
    }
    forAll(in, i)
    {
        label to = -1;
        for (label j = 0; joins[i] && part[i] > 0 && j < in.size(); ++j)
        {
            to = !joins[j] && (to < 0 || nearer(x[i], x[j], x[to])) ? j : to;
        }
        if (to >= 0)
        {
            in[to].add(1, in[i]);
        }
    }
    forAll(in, i)
    {
        part[i] = joins[i] ? 0 : in[i].V / c.volume()[i];
        if (mag(part[i] - 1) < tolerance)
        {
            part[i] = 1;
        }
        else if (part[i] > 0)
        {
            x[i] = in[i].X / in[i].V;
        }
    }
}

Foam::autoPtr<Foam::mpm::cellParts> Foam::mpm::pointRegion::partsOf(const label celli) const
{
    const polyMesh& mesh = grid_.mesh();
    if (bySimplices_)
    {
        return autoPtr<cellParts>(new simplexParts(grid_, celli, n_[0]));
    }
    if (grid_.nDim() == 3)
    {
        return autoPtr<cellParts>(new cornerRegions(mesh, celli));
    }
    label side = -1;
    for (const label facei : mesh.cells()[celli])
    {
        side = side < 0 && emptyFaces_.test(facei) ? facei : side;
    }
    return autoPtr<cellParts>(new cornerRegions(mesh.faces()[side], mesh.points()));
}

void Foam::mpm::pointRegion::fillCorners(const label celli, const scalar rho)
{
    const polyMesh& mesh = grid_.mesh();
    const boundBox cellBox(mesh.points(), mesh.cellPoints()[celli], false);
    const boundBox shapeBox(shape_->bounds());
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        const int k = grid_.direction(d);
        if (cellBox.min()[k] > shapeBox.max()[k] || cellBox.max()[k] < shapeBox.min()[k])
        {
            return;
        }
    }

    const scalar share = shares_ ? shares_->share(celli) : scalar(1);
    if (share <= 0)
    {
        return;
    }
    const autoPtr<cellParts> parts(partsOf(celli));
    const cellParts& c = *parts;

    // Of the cell's volume; of rings the volumes are the sections times their
    // radius. The simplices of cells with warped faces have their own
    const int radial = grid_.radial();
    const auto rings = [&](const scalarField& section, const pointField& at)
    { return radial < 0 ? section : scalarField(section * at.component(grid_.direction(radial))); };
    pointField x(c.size());
    forAll(x, i)
    {
        x[i] = c.centre(i);
    }
    const scalar whole =
        bySimplices_ && grid_.nDim() == 3 ? mesh.cellVolumes()[celli] : sum(rings(c.volume(), x));

    scalarField inside(c.size(), scalar(1));
    if (share < 1)
    {
        cutRegions(celli, c, inside, x);
    }
    scalarField section(c.volume() * inside);
    if (n_[0] == 1)
    {
        const scalar all = sum(section);
        const bool cut = min(inside) < 1 && all > 0;
        x = pointField(1, cut ? point(sum(section * x) / all) : mesh.cellCentres()[celli]);
        section = scalarField(1, all);
    }
    scalarField part(rings(section, x) / whole);
    if (n_[0] == 1 && min(inside) == 1)
    {
        part = 1;
    }
    if (sampled_)
    {
        // Whole points
        const boolList has(shape_->contains(celli, x));
        forAll(x, i)
        {
            part[i] *= has[i];
        }
    }
    addParts(celli, rho, share, part, x);
}

void Foam::mpm::pointRegion::addParts(
    const label celli, const scalar rho, const scalar share, const scalarField& part,
    const pointField& x)
{
    const scalar whole = grid_.mesh().cellVolumes()[celli];
    const label nBefore = points_.size();
    forAll(x, i)
    {
        if (!(part[i] > 0))
        {
            continue;
        }
        materialPointCloud::newPoint p;
        p.x = grid_.mesh().cellCentres()[celli];
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            p.x[grid_.direction(d)] = x[i][grid_.direction(d)];
        }
        p.U = Zero;
        p.sigma = sigma_;
        p.T = T_;
        p.volume = whole * part[i] * volumeFraction_;
        p.mass = rho * p.volume;
        p.halfSize = Zero;

        // Those of a cube (square) of the same volume
        const scalar size = p.volume / volumeFraction_ / shape_->section();
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            p.halfSize[grid_.direction(d)] = 0.5 * std::pow(size, 1.0 / grid_.nDim());
        }
        if (share < 1)
        {
            cutPoint c;
            c.point = points_.size();
            c.mean = p.x;
            c.addSurfaces(whole_.nSurfaces());
            cutOf_.insert(c.point, cut_.size());
            cut_.append(c);
        }
        sub_.append(i);
        points_.append(p);
    }
    if (share < 1)
    {
        scaleTo(share, celli, nBefore, rho);
    }
    if (points_.size() > nBefore)
    {
        cells_.append(celli);
        start_.append(points_.size());
    }
}

bool Foam::mpm::pointRegion::cornersOverlap(
    const pointRegion& other, const label k, point& where) const
{
    for (label p = start_[k]; p < start_[k + 1]; ++p)
    {
        where = points_[p].x;
        if (other.shape_->contains(cells_[k], where))
        {
            return true;
        }
    }
    return false;
}

bool Foam::mpm::pointRegion::overlaps(
    const pointRegion& other, const label k, const label otherK, point& where) const
{
    if (byCorners_ || byElements_ || other.byElements_)
    {
        return cornersOverlap(other, k, where);
    }
    const label celli = cells_[k];
    const hexMap map(grid_, celli);

    // Rows of a box fill what lies in it
    const label n = rows_ ? nSub_ : start_[k + 1] - start_[k];
    for (label j = 0; j < n; ++j)
    {
        const label sub = rows_ ? j : sub_[start_[k] + j];

        // Positions away from the shapes' sides, which they may share
        for (label sample = 0; sample < nSamples_; ++sample)
        {
            scalar xi[3];
            local(sub, sample, xi);

            // Has the other region a point here?
            label otherSub = 0, stride = 1;
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                const label i = label(xi[d] * other.n_[d]);
                otherSub += stride * min(i, other.n_[d] - 1);
                stride *= other.n_[d];
            }
            if (!other.rows_
                && !std::binary_search(
                    other.sub_.begin() + other.start_[otherK],
                    other.sub_.begin() + other.start_[otherK + 1], otherSub))
            {
                continue;
            }

            where = map.position(xi);
            if (shape_->contains(celli, where) && other.shape_->contains(celli, where))
            {
                return true;
            }
        }
    }
    return false;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::pointRegion::overlap(const pointRegion& other, point& where) const
{
    if (mayOverlap_ || other.mayOverlap_)
    {
        return -1;
    }

    label j = 0;
    forAll(cells_, k)
    {
        while (j < other.cells_.size() && other.cells_[j] < cells_[k])
        {
            ++j;
        }
        if (j == other.cells_.size())
        {
            return -1;
        }

        // Both ways: sub-cells may be of different size
        if (other.cells_[j] == cells_[k]
            && (overlaps(other, k, j, where) || other.overlaps(*this, j, k, where)))
        {
            return cells_[k];
        }
    }
    return -1;
}

void Foam::mpm::pointRegion::checkOverlap(const pointRegion& other) const
{
    point where;
    const label celli = overlap(other, where);
    if (celli >= 0)
    {
        FatalIOErrorInFunction(dict_)
            << "Regions " << other.name_ << " and " << name_ << " overlap: both have points at "
            << where << " (cell " << celli << "), and their phases share a velocity field." << nl
            << "Change a shape, or write  overlap allow;  in one of"
            << " the regions if that is meant." << exit(FatalIOError);
    }
}
