/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointRegion.H"

#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::pointRegion::standsInRows
(
    const pointGrid& grid,
    const pointRegionShape& shape
)
{
    if (!grid.hasLattice() || shape.type() != "box")
    {
        return false;
    }
    const int r = grid.radial();
    return
        r < 0
     || shape.bounds().min()[grid.direction(r)] >= grid.lattice().planes(r)[2];
}


void Foam::mpm::pointRegion::row
(
    const int d,
    scalarList& centre,
    scalarList& size
) const
{
    constexpr scalar tolerance = 1e-9;

    // Cells of the mesh; planes have one more at each end
    const scalarList& planes = grid_.lattice().planes(d);
    const label nCells = planes.size() - 3;
    const int c = grid_.direction(d);
    const scalar low = max(shape_->bounds().min()[c], planes[1]);
    const scalar high = min(shape_->bounds().max()[c], planes[nCells + 1]);
    const scalar h = (planes[nCells + 1] - planes[1])/nCells;

    bool equal = d != grid_.radial();
    for (label i = 1; i <= nCells; ++i)
    {
        equal = equal && mag(planes[i + 1] - planes[i] - h) < tolerance*h;
    }

    DynamicList<scalar> x, w;
    if (!(low < high))
    {}
    else if (equal)
    {
        // No point is wider than a cell
        const label n = max
        (
            label((high - low)/h*n_[d] + 0.5),
            label(std::ceil((high - low)/h - tolerance))
        );
        for (label i = 0; i < n; ++i)
        {
            x.append(low + (i + 0.5)/n*(high - low));
            w.append((high - low)/n);
        }
    }
    else
    {
        for (label i = 1; i <= nCells; ++i)
        {
            const scalar s = (planes[i + 1] - planes[i])/n_[d];
            for (label j = 0; j < n_[d]; ++j)
            {
                const scalar at = planes[i] + (j + 0.5)*s;
                if (at >= low && at < high)
                {
                    x.append(at);
                    w.append(s);
                }
            }
        }
    }
    centre.transfer(x);
    size.transfer(w);
}


void Foam::mpm::pointRegion::fillRows(const scalar rho)
{
    const int nDim = grid_.nDim();
    const int radial = grid_.radial();

    scalarList centre[3], size[3];
    label n = 1;
    for (int d = 0; d < nDim; ++d)
    {
        row(d, centre[d], size[d]);
        n *= centre[d].size();
    }

    DynamicList<materialPointCloud::newPoint> points(n);
    labelList cellOf(n, -1);
    for (label i = 0; i < n; ++i)
    {
        materialPointCloud::newPoint p;
        p.x = p.U = p.halfSize = Zero;
        p.sigma = sigma_;
        p.T = T_;
        p.volume =
            volumeFraction_
           *(radial < 0 ? shape_->section() : grid_.sector());
        scalar x[3] = {0, 0, 0};
        label rest = i;
        for (int d = 0; d < nDim; ++d)
        {
            const int c = grid_.direction(d);
            const label j = rest % centre[d].size();
            rest /= centre[d].size();
            x[d] = p.x[c] = centre[d][j];
            p.halfSize[c] = 0.5*size[d][j];
            p.volume *= size[d][j]*(d == radial ? x[d] : 1);
        }
        p.mass = rho*p.volume;
        cellOf[i] = grid_.find(x);
        points.append(p);
    }

    store(points, cellOf);
}


void Foam::mpm::pointRegion::store
(
    const UList<materialPointCloud::newPoint>& points,
    const labelUList& cellOf
)
{
    // In the order of cells
    labelList order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b) { return cellOf[a] < cellOf[b]; }
    );
    for (const label i : order)
    {
        const label celli = cellOf[i];
        if (celli < 0)
        {
            continue;
        }
        materialPointCloud::newPoint p(points[i]);
        for (int e = 0; e < 3; ++e)
        {
            if (p.halfSize[e] == 0)
            {
                p.x[e] = grid_.mesh().cellCentres()[celli][e];
            }
        }
        if (cells_.empty() || cells_.last() != celli)
        {
            cells_.append(celli);
            const label from = start_.last();   // append() may move the list
            start_.append(from);
        }
        points_.append(p);
        ++start_.last();
    }
}

// ************************************************************************* //
