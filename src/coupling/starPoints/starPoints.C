// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "starPoints.H"
#include "simplexShape.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam::mpm
{

//- HOOP: on wedges (DIM 2)
template<int DIM, bool HOOP = false>
class starPointsOf final : public starPoints
{
    typedef simplexShape<DIM> shape;
    typedef typename shape::T T;
    typedef typename shape::stencil stencil;
    typedef lanes<8> row;

    static constexpr int W = shape::W;

    static_assert(2 * DIM + 1 <= vertexStride && moved + DIM <= spare);
    static_assert(!HOOP || DIM == 2, "the plane of a wedge is 2D");

    //- Places of v/r in the rows of points, with v before and after; nobody
    //  reads them in those of nodes
    static constexpr int sectionOld = 6, section = 7;

    const pointGrid& grid_;
    const cellSimplices& cells_;
    const labelUList& start_;

    //- Rows of the simplices of a cell, of its vertices
    alignedArray ofSimplices_, ofVertices_;

    //- Pressure at the origin and its gradient in the simplices of a cell
    alignedArray gradP_;

    //- Computed direction of the radius, volume over radius and section, where
    //  HOOP is
    const int radial_;
    const scalar sector_;

    //- Points of a group: their functions of the corners and simplices
    struct place
    {
        T lambda[DIM], simplex;
    };

    static label mostSimplices(const cellSimplices& cells, const label nCells)
    {
        label most = 1;
        for (label c = 0; c < nCells; ++c)
        {
            most = max(most, cells.nSimplices(c));
        }
        return most;
    }

    //- One copy for all passes: same arithmetic
    static __attribute__((noinline)) void
    find(const stencil& s, const scalar* const (&x)[DIM], const label p, place& at)
    {
        T X[DIM];
        for (int d = 0; d < DIM; ++d)
        {
            X[d] = load<W>(x[d] + p);
        }
        shape::find(s, X, at.lambda, at.simplex);
    }

    void prepare(const label celli, stencil& s) const
    {
        s.celli = celli;
        s.n = cells_.nVertices(celli);
        s.nSimplices = cells_.nSimplices(celli);
        s.simplex = cells_.isSimplex(celli);
        s.nodes = cells_.nodes(celli);
        s.corners = cells_.corners(celli);
        s.inverses = cells_.inverses(celli);
        for (int d = 0; d < DIM; ++d)
        {
            s.O[d] = cells_.origin(celli)[d];
        }
    }

    //- Call start(stencil), point(stencil, p, place, lane) for each point,
    //  end(stencil) of each cell
    template<class Start, class Point, class End>
    void forPoints(
        materialPointCloud& cloud, const Start& start, const Point& point, const End& end) const
    {
        const scalar* x[DIM];
        for (int d = 0; d < DIM; ++d)
        {
            x[d] = cloud.x()[d];
        }
        forAll(cloud.cells(), k)
        {
            stencil s;
            prepare(cloud.cells()[k], s);
            start(s);
            const label last = cloud.start()[k + 1];
            for (label p = cloud.start()[k]; p < last; p += W)
            {
                place at;
                find(s, x, p, at);
                const int n = min(label(W), last - p);
                for (int i = 0; i < n; ++i)
                {
                    point(s, p + i, at, i);
                }
            }
            end(s);
        }
    }

    //- Rows of points to their simplex and vertices
    template<class Row>
    void scatter(materialPointCloud& cloud, const Row& of, const sums& to) const;

    void finish(const stencil& s, const row& ofOrigin, const sums& to) const;

    //- 1/r of a ring of volume v
    scalar inverseRadius(const scalar r, const scalar v) const
    {
        return 1 / max(r, 0.1 * std::cbrt(v / sector_));
    }

public:
    starPointsOf(const pointGrid& grid, const cellSimplices& cells, const labelUList& start) :
        grid_(grid),
        cells_(cells),
        start_(start),
        ofSimplices_(8 * mostSimplices(cells, grid.nCells())),
        ofVertices_(8 * max(cells.maxVertices(), label(1))),
        gradP_(DIM * mostSimplices(cells, grid.nCells())),
        radial_(grid.radial()),
        sector_(grid.sector())
    {
    }

    void depart(materialPointCloud& cloud, const sums& to) const override;

    void arrive(materialPointCloud& cloud, const scalar* oldVolume, const sums& to) const override;

    void gather(materialPointCloud& cloud, const scalar* P, const scalar share, const scalar* push)
        const override;
};

} // End namespace Foam::mpm

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int DIM, bool HOOP>
template<class Row>
void Foam::mpm::starPointsOf<DIM, HOOP>::scatter(
    materialPointCloud& cloud, const Row& of, const sums& to) const
{
    scalar* ofSimplices = ofSimplices_.data();
    scalar* ofVertices = ofVertices_.data();
    row ofOrigin = {};
    forPoints(
        cloud,
        [&](const stencil& s)
        {
            ofOrigin = row{};
            std::fill_n(ofSimplices, 8 * s.nSimplices, 0.0);
            std::fill_n(ofVertices, 8 * s.n, 0.0);
        },
        [&](const stencil& s, const label p, const place& at, const int lane)
        {
            const row q = of(p);
            const int simplex = int(at.simplex[lane]);
            scalar* sum = ofSimplices + 8 * simplex;
            store<8>(sum, load<8>(sum) + q);
            double rest = 1;
            for (int k = 0; k < DIM; ++k)
            {
                const double lambda = at.lambda[k][lane];
                rest -= lambda;
                scalar* vertex = ofVertices + 8 * s.corners[DIM * simplex + k];
                store<8>(vertex, load<8>(vertex) + lambda * q);
            }
            ofOrigin += rest * q;
        },
        [&](const stencil& s) { finish(s, ofOrigin, to); });
}

template<int DIM, bool HOOP>
void Foam::mpm::starPointsOf<DIM, HOOP>::finish(
    const stencil& s, const row& ofOrigin, const sums& to) const
{
    const scalar* ofSimplices = ofSimplices_.data();
    scalar* vertex = to.vertices + vertexStride * start_[s.celli];
    const scalar* I = s.inverses;
    const label* corner = s.corners;
    row gradOrigin = {}, all = {};
    for (int i = 0; i < s.nSimplices; ++i, I += DIM * DIM, corner += DIM)
    {
        const scalar* q = ofSimplices + 8 * i;
        all += load<8>(q);
        for (int k = 0; k < DIM; ++k)
        {
            row grad = {};
            for (int d = 0; d < DIM; ++d)
            {
                grad[gradOld(DIM) + d] = q[volumeOld] * I[DIM * k + d];
                grad[gradNew(DIM) + d] = q[volume] * I[DIM * k + d];
                grad[way(DIM)] += q[moved + d] * I[DIM * k + d];
            }
            gradOrigin -= grad;
            scalar* at = vertex + vertexStride * corner[k];
            store<8>(at, load<8>(at) + grad);
        }
    }
    for (int i = 0; i < s.n; ++i)
    {
        const double b = cells_.originShare(s.celli, i);
        scalar* at = vertex + vertexStride * i;
        store<8>(at, load<8>(at) + b * gradOrigin);
        if constexpr (HOOP)
        {
            const scalar* q = ofVertices_.data() + 8 * i;
            at[gradOld(DIM) + radial_] += q[sectionOld] + b * ofOrigin[sectionOld];
            at[gradNew(DIM) + radial_] += q[section] + b * ofOrigin[section];
        }
        scalar* node = to.nodes + nodeStride * s.nodes[i];
        store<8>(node, load<8>(node) + load<8>(ofVertices_.data() + 8 * i) + b * ofOrigin);
    }
    to.cells[cellStride * s.celli] += all[volume];
    to.cells[cellStride * s.celli + 1] += all[dilation];
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int DIM, bool HOOP>
void Foam::mpm::starPointsOf<DIM, HOOP>::depart(materialPointCloud& cloud, const sums& to) const
{
    const scalar* v = (*cloud.gasVolume())[0];
    const scalar* dx[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        dx[d] = (*cloud.displacement())[d];
    }
    scatter(
        cloud,
        [&](const label p)
        {
            row q = {};
            for (int d = 0; d < DIM; ++d)
            {
                q[moved + d] = 0.5 * v[p] * dx[d][p];
            }
            return q;
        },
        to);
}

template<int DIM, bool HOOP>
void Foam::mpm::starPointsOf<DIM, HOOP>::arrive(
    materialPointCloud& cloud, const scalar* oldVolume, const sums& to) const
{
    const scalar* v = (*cloud.gasVolume())[0];
    const scalar* m = cloud.mass()[0];
    const scalar* r = HOOP ? cloud.x()[radial_] : nullptr;
    const scalar* dx[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        dx[d] = (*cloud.displacement())[d];
    }
    scatter(
        cloud,
        [&](const label p)
        {
            row q = {};
            q[volume] = v[p];
            q[mass] = m[p];
            if constexpr (HOOP)
            {
                q[section] = v[p] * inverseRadius(r[p], v[p]);
                if (oldVolume)
                {
                    q[sectionOld] = oldVolume[p] * inverseRadius(r[p], oldVolume[p]);
                }
            }
            if (oldVolume)
            {
                q[volumeOld] = oldVolume[p];
                q[dilation] = v[p] - oldVolume[p];
                for (int d = 0; d < DIM; ++d)
                {
                    q[moved + d] = 0.5 * oldVolume[p] * dx[d][p];
                }
            }
            return q;
        },
        to);
}

template<int DIM, bool HOOP>
void Foam::mpm::starPointsOf<DIM, HOOP>::gather(
    materialPointCloud& cloud, const scalar* P, const scalar share, const scalar* push) const
{
    const scalar* v = (*cloud.gasVolume())[0];
    scalar* pressure = (*cloud.gasPressure())[0];
    scalar* F[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        F[d] = (*cloud.gasForce())[d];
    }
    scalar* gradP = gradP_.data();
    scalar ofOrigin = 0, pushOrigin[DIM] = {};
    forPoints(
        cloud,
        [&](const stencil& s)
        {
            // Differences: equal values give no gradient
            const scalar base = P[s.nodes[0]];
            ofOrigin = base;
            for (int i = 0; i < s.n; ++i)
            {
                ofOrigin += cells_.originShare(s.celli, i) * (P[s.nodes[i]] - base);
            }
            for (int d = 0; push && d < DIM; ++d)
            {
                pushOrigin[d] = 0;
                for (int i = 0; i < s.n; ++i)
                {
                    pushOrigin[d] += cells_.originShare(s.celli, i) * push[DIM * s.nodes[i] + d];
                }
            }
            const scalar* I = s.inverses;
            const label* corner = s.corners;
            for (int i = 0; i < s.nSimplices; ++i)
            {
                for (int d = 0; d < DIM; ++d)
                {
                    scalar& g = gradP[DIM * i + d];
                    g = 0;
                    for (int k = 0; k < DIM; ++k)
                    {
                        g += I[DIM * k + d] * (P[s.nodes[corner[k]]] - ofOrigin);
                    }
                }
                I += DIM * DIM;
                corner += DIM;
            }
        },
        [&](const stencil& s, const label p, const place& at, const int lane)
        {
            const int simplex = int(at.simplex[lane]);
            scalar sum = ofOrigin;
            for (int k = 0; k < DIM; ++k)
            {
                sum += at.lambda[k][lane] * (P[s.nodes[s.corners[DIM * simplex + k]]] - ofOrigin);
            }
            pressure[p] = sum;
            for (int d = 0; d < DIM; ++d)
            {
                F[d][p] = -share * v[p] * gradP[DIM * simplex + d];
            }
            for (int d = 0; push && d < DIM; ++d)
            {
                scalar H = pushOrigin[d];
                for (int k = 0; k < DIM; ++k)
                {
                    const label l = s.nodes[s.corners[DIM * simplex + k]];
                    H += at.lambda[k][lane] * (push[DIM * l + d] - pushOrigin[d]);
                }
                F[d][p] += v[p] * H;
            }
        },
        [](const stencil&) {});
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::starPoints> Foam::mpm::starPoints::New(
    const pointGrid& grid, const cellSimplices& cells, const labelUList& start)
{
    if (grid.radial() >= 0)
    {
        return autoPtr<starPoints>(new starPointsOf<2, true>(grid, cells, start));
    }
    switch (grid.nDim())
    {
    case 1:
        return autoPtr<starPoints>(new starPointsOf<1>(grid, cells, start));
    case 2:
        return autoPtr<starPoints>(new starPointsOf<2>(grid, cells, start));
    default:
        return autoPtr<starPoints>(new starPointsOf<3>(grid, cells, start));
    }
}
