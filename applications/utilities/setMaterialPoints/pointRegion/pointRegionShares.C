// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointRegion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointRegion::corners(const hexMap& map, const label sub, point (&x)[8]) const
{
    for (int n = 0; n < 8; ++n)
    {
        scalar xi[3];
        label i = sub;
        bool across[3] = {true, true, true};
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            xi[d] = (i % n_[d] + ((n >> d) & 1)) / scalar(n_[d]);
            i /= n_[d];
            across[grid_.direction(d)] = false;
        }
        x[n] = map.position(xi);
        for (int c = 0, d = grid_.nDim(); c < 3; ++c)
        {
            x[n][c] += across[c] ? ((n >> d++) & 1) - 0.5 : scalar(0);
        }
    }
}

int Foam::mpm::pointRegion::shareSubCell(
    const label celli, const hexMap& map, const label sub, cutPoint& c, scalar& part) const
{
    point x[8];
    corners(map, sub, x);
    volumeMoment all, in;
    for (const polytope& p : polytope::ofHexahedron(x))
    {
        all.add(1, p.moment());
        in.add(1, shares_->part(celli, p));
    }
    if (in.V < tolerance * all.V)
    {
        return 0;
    }
    if (in.V > (1 - tolerance) * all.V)
    {
        return 1;
    }
    part = in.V / all.V;
    c.mean = in.X / in.V;
    c.area = in.V;
    c.whole = all.V;
    c.variance = Zero;
    scalar xi[3];
    centre(sub, xi);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        c.variance[grid_.direction(d)] =
            sqr(mag(map.tangent(xi, d)) / (2 * n_[d])) / 3 * std::pow(part, 2.0 / grid_.nDim());
    }
    c.addSurfaces(whole_.nSurfaces());
    if (grid_.radial() >= 0)
    {
        const int r = grid_.direction(grid_.radial());
        part *= c.mean[r] * all.V / all.X[r];
    }
    return 2;
}

Foam::mpm::volumeMoment
Foam::mpm::pointRegion::inShape(const label celli, const cellParts::simplex& s) const
{
    polytope p;
    const point* x = s.x.cdata();
    if (s.n == 4)
    {
        const bool turned = (((x[1] - x[0]) ^ (x[2] - x[0])) & (x[3] - x[0])) > 0;
        const point &a = x[0], &b = turned ? x[2] : x[1], &c = turned ? x[1] : x[2], &d = x[3];
        p.addFace({a, b, c});
        p.addFace({b, a, d});
        p.addFace({c, b, d});
        p.addFace({a, c, d});
        return shares_->part(celli, p);
    }
    // Drawn out along the third direction
    vector up(1, 1, 1);
    up[grid_.direction(0)] = up[grid_.direction(1)] = 0;
    const bool turned = (((x[1] - x[0]) ^ (x[2] - x[0])) & up) < 0;
    const point a(x[0] - 0.5 * up), b(x[turned ? 2 : 1] - 0.5 * up),
        c(x[turned ? 1 : 2] - 0.5 * up);
    p.addFace({a, c, b});
    p.addFace({a + up, b + up, c + up});
    p.addFace({a, b, b + up, a + up});
    p.addFace({b, c, c + up, b + up});
    p.addFace({c, a, a + up, c + up});
    return shares_->part(celli, p);
}

void Foam::mpm::pointRegion::scaleTo(
    const scalar share, const label celli, const label first, const scalar rho)
{
    const scalar V = share * grid_.mesh().cellVolumes()[celli] * volumeFraction_;
    scalar sum = 0;
    for (label p = first; p < points_.size(); ++p)
    {
        sum += points_[p].volume;
    }
    lost_ += sum > 0 ? 0 : V;
    for (label p = first; p < points_.size(); ++p)
    {
        points_[p].volume *= V / sum;
        points_[p].mass = rho * points_[p].volume;
    }
}

bool Foam::mpm::pointRegion::nearer(const point& x, const point& a, const point& b)
{
    constexpr scalar equal = 1e-9;
    const scalar da = mag(a - x), db = mag(b - x);
    if (mag(da - db) > equal * db)
    {
        return da < db;
    }
    for (direction c = 0; c < 3; ++c)
    {
        if (mag(a[c] - b[c]) > equal * db)
        {
            return a[c] < b[c];
        }
    }
    return false;
}

void Foam::mpm::pointRegion::joinSmallCells()
{
    if (grid_.hasLattice())
    {
        return;
    }
    for (const cutPoint& c : cut_)
    {
        if (c.point >= 0)
        {
            points_[c.point].x = c.mean;
        }
    }
    Map<label> placeOf;
    scalarField filled(cells_.size(), Zero);
    forAll(cells_, k)
    {
        placeOf.insert(cells_[k], k);
        for (label p = start_[k]; p < start_[k + 1]; ++p)
        {
            filled[k] += points_[p].volume / volumeFraction_;
        }
        filled[k] /= grid_.mesh().cellVolumes()[cells_[k]];
    }
    boolList gone(points_.size(), false);
    bool any = false;
    forAll(cells_, k)
    {
        if (filled[k] >= smallPart)
        {
            continue;
        }
        const vectorField& C = grid_.mesh().cellCentres();
        label best = -1;
        for (const label celli : grid_.mesh().cellCells()[cells_[k]])
        {
            const auto other = placeOf.cfind(celli);
            if (other.good() && filled[*other] >= smallPart
                && (best < 0 || nearer(C[cells_[k]], C[celli], C[cells_[best]])))
            {
                best = *other;
            }
        }
        for (label p = start_[k]; p < start_[k + 1]; ++p)
        {
            const materialPointCloud::newPoint& from = points_[p];
            gone[p] = any = true;
            if (best < 0)
            {
                // correct() gives its volume to others
                lost_ += from.volume;
                continue;
            }
            label nearest = start_[best];
            for (label q = nearest; q < start_[best + 1]; ++q)
            {
                nearest = nearer(from.x, points_[q].x, points_[nearest].x) ? q : nearest;
            }
            materialPointCloud::newPoint& to = points_[nearest];
            to.x += from.volume / (from.volume + to.volume) * (from.x - to.x);
            to.volume += from.volume;
            to.mass += from.mass;
            if (cutOf_.found(nearest))
            {
                cut_[cutOf_[nearest]].mean = to.x;
            }
        }
    }
    if (any)
    {
        remove(gone);
    }
}

void Foam::mpm::pointRegion::correct()
{
    // Beyond this the reason is another one
    constexpr scalar most = 0.1, rounding = 1e-12;

    const scalar exact = rows_ || byElements_ ? -1 : exactVolume();
    scalar all = 0, cut = 0;
    for (const materialPointCloud::newPoint& p : points_)
    {
        all += p.volume;
    }
    for (const cutPoint& c : cut_)
    {
        cut += c.point < 0 ? 0 : points_[c.point].volume;
    }
    const scalar missing = exact > 0 ? exact - all : lost_;
    if (mag(missing) < rounding * all || mag(missing) > most * cut)
    {
        return;
    }
    for (const cutPoint& c : cut_)
    {
        if (c.point >= 0)
        {
            points_[c.point].volume *= 1 + missing / cut;
            points_[c.point].mass *= 1 + missing / cut;
        }
    }
}
