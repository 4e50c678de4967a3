// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointKernels.H"
#include "lanes.H"

namespace Foam::mpm
{

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

//  KNOTS: some direction is graded or a radius
template<int DIM, bool KNOTS = false>
class boxKernels : public pointKernels
{
    static constexpr int W = laneWidth<DIM>;
    typedef lanes<W> T;
    typedef lanes<4> quad;

    //- Cells around a cell and faces of one direction that its points reach
    static constexpr int nCells = DIM == 1 ? 3 : DIM == 2 ? 9 : 27;
    static constexpr int nFaces = 2 * nCells / 3;

    const fractionLattice& sums_;

    //- Computed direction of the radius; -1: none
    const int radial_;

    //- Directions that are graded or the radius
    bool knots_[DIM];

    //- Factors of the kernels of W points: hat at the lower and upper plane,
    //  spline of the cell below, the cell, the cell above
    struct factors
    {
        T n1[DIM][2], n2[DIM][3];
    };

    //- Values of a point: those of a place's faces in a direction below, two
    //  directions where there are more than one
    typedef std::conditional_t<DIM == 1, quad, lanePair<4>> values;

    //- Sums over the points of a cell, for the splines of the cells around it;
    //  for the hats of directions with knots
    template<class Value>
    struct sums
    {
        Value cell[nCells];
        Value hat[KNOTS ? DIM : 1][KNOTS ? nFaces : 1];
    };

    //- Places around a cell
    struct around
    {
        label cell[nCells];
        scalar lower[DIM], invWidth[DIM];

        //- Of the lower and upper face: place, 1/d_f; of a wedge's r^2, 1/d_f,
        //  2 r_f h/d_f, 1/r_f, the last three zero at the axis
        struct knot
        {
            scalar s, invD, scale = 1, invR = 1;
        };

        knot knots[KNOTS ? DIM : 1][2];
    };

    void prepareKnots(const label celli, const int d, around& s) const
    {
        const scalar* x =
            sums_.grid().lattice().planes(d).cdata() + sums_.grid().lattice().ijk(celli, d);
        for (int n = 0; n < 2; ++n)
        {
            typename around::knot& k = s.knots[d][n];
            const scalar h = min(x[n] - x[n - 1], x[n + 1] - x[n]);
            if (d != radial_)
            {
                k.s = x[n];
                k.invD = 1 / h;
                continue;
            }
            const bool atAxis = x[n] < 1e-6 * h;
            k.s = sqr(x[n]);
            const scalar D = min(k.s - sqr(max(x[n - 1], scalar(0))), sqr(x[n + 1]) - k.s);
            k.invD = atAxis ? 0 : 1 / D;
            k.scale = atAxis ? 0 : 2 * x[n] * h / D;
            k.invR = atAxis ? 0 : 1 / x[n];
        }
    }

    void prepare(const label celli, around& s) const
    {
        const pointGrid& grid = sums_.grid();
        const label place = sums_.place(celli);
        label step[DIM][3];
        for (int d = 0; d < DIM; ++d)
        {
            const label i = grid.lattice().ijk(celli, d);
            s.lower[d] = grid.lattice().planes(d)[i];
            s.invWidth[d] = grid.lattice().invWidth(d)[i];
            step[d][0] = sums_.below(celli, d);
            step[d][1] = 0;
            step[d][2] = sums_.above(celli, d);
            if (KNOTS && knots_[d])
            {
                prepareKnots(celli, d, s);
            }
        }
        for (int n = 0; n < nCells; ++n)
        {
            label at = place;
            int rest = n;
            for (int d = 0; d < DIM; ++d)
            {
                at += step[d][rest % 3];
                rest /= 3;
            }
            s.cell[n] = at;
        }
    }

    MPM_INLINE void evaluate(
        const around& s, const scalar* const (&x)[DIM], const label p, const int n,
        factors& K) const
    {
        for (int d = 0; d < DIM; ++d)
        {
            // Not beyond the last point: padding need not be a number
            const T xp = n == W ? load<W>(x[d] + p) : loadPart<W>(x[d] + p, n);
            if (KNOTS && knots_[d])
            {
                const typename around::knot &low = s.knots[d][0], &high = s.knots[d][1];
                const T none = {}, at = d == radial_ ? xp * xp : xp;
                const T c0 = laneMax(1.0 - (at - low.s) * low.invD, none);
                const T c1 = laneMax(1.0 - (high.s - at) * high.invD, none);
                K.n1[d][0] = low.scale * c0;
                K.n1[d][1] = high.scale * c1;
                K.n2[d][0] = low.scale > 0 ? 0.5 * c0 * c0 : none;
                K.n2[d][2] = 0.5 * c1 * c1;
                K.n2[d][1] = 1.0 - K.n2[d][0] - K.n2[d][2];
                continue;
            }
            const T xi = (xp - s.lower[d]) * s.invWidth[d];
            const T c = 1.0 - xi, t = xi - 0.5;
            K.n1[d][0] = c;
            K.n1[d][1] = xi;
            K.n2[d][0] = 0.5 * c * c;
            K.n2[d][1] = 0.75 - t * t;
            K.n2[d][2] = 0.5 * xi * xi;
        }
    }

    //- Kernels (times V) of the cells, in order
    static MPM_INLINE void cellKernels(const factors& K, double (&k)[nCells][W])
    {
        constexpr int nY = DIM > 1 ? 3 : 1, nZ = DIM > 2 ? 3 : 1;
        for (int z = 0; z < nZ; ++z)
        {
            for (int y = 0; y < nY; ++y)
            {
                T row = broadcast<W>(1);
                if constexpr (DIM > 1)
                {
                    row = K.n2[1][y];
                }
                if constexpr (DIM > 2)
                {
                    row *= K.n2[2][z];
                }
                for (int x = 0; x < 3; ++x)
                {
                    store<W>(k[(nY * z + y) * 3 + x], row * K.n2[0][x]);
                }
            }
        }
    }

    //- That of face n of direction d
    static MPM_INLINE T faceKernel(const factors& K, const int d, const int n)
    {
        T k = K.n1[d][n % 2];
        int rest = n / 2;
        for (int e = 0; e < DIM; ++e)
        {
            if (e != d)
            {
                k *= K.n2[e][rest % 3];
                rest /= 3;
            }
        }
        return k;
    }

    //- Steps in sums::cell along d, and the first of a line of three cells along it
    static constexpr int along(const int d) { return d == 0 ? 1 : d == 1 ? 3 : 9; }

    static constexpr int lineStart(const int d, const int line)
    {
        return line / along(d) * 3 * along(d) + line % along(d);
    }

    //- Place of the face of direction d at the lower end of a line's middle cell
    label placeOf(const around& s, const int d, const int line) const
    {
        return s.cell[lineStart(d, line) + along(d)];
    }

    //- Values q of each of n points to the sums
    template<class Value>
    MPM_INLINE void add(const factors& K, const Value (&q)[W], const int n, sums<Value>& to) const
    {
        alignas(64) double k[nCells][W];
        cellKernels(K, k);
        for (int l = 0; l < n; ++l)
        {
            // Without a loop the sums stay in registers
#pragma GCC unroll 27
            for (int c = 0; c < nCells; ++c)
            {
                to.cell[c] += k[c][l] * q[l];
            }
        }
        for (int d = 0; KNOTS && d < DIM; ++d)
        {
            for (int f = 0; knots_[d] && f < nFaces; ++f)
            {
                const T kernel = faceKernel(K, d, f);
                for (int l = 0; l < n; ++l)
                {
                    to.hat[d][f] += kernel[l] * q[l];
                }
            }
        }
    }

    //- Call f(place, side, sum) for the faces of direction d, sum of the half of the values
    //  that has theirs. Between equal cells a hat is one of the splines of three in a row,
    //  n1 = (n2_0 + n2_1 + n2_2)/2 -+ (n2_2 - n2_0)
    template<class Value, class Function>
    MPM_INLINE void
    forFaces(const around& s, const int d, const sums<Value>& of, const Function& f) const
    {
        const auto part = [&](const Value& q)
        {
            if constexpr (std::is_same<Value, quad>::value)
            {
                return q;
            }
            else
            {
                return halfOf<4>(q, d > 0);
            }
        };
        for (int line = 0; line < nFaces / 2; ++line)
        {
            const label at = placeOf(s, d, line);
            quad low, high;
            if (KNOTS && knots_[d])
            {
                low = part(of.hat[d][2 * line]);
                high = part(of.hat[d][2 * line + 1]);
            }
            else
            {
                const Value* q = of.cell + lineStart(d, line);
                const quad a = part(q[0]), b = part(q[along(d)]), c = part(q[2 * along(d)]);
                const quad half = 0.5 * (a + b + c);
                low = half - (c - a);
                high = half + (c - a);
            }
            f(at, 0, low);
            f(at + sums_.stride(d), 1, high);
        }
    }

    //- Of the flux at a face of the radius
    scalar scaleOf(const around& s, const int d, const int side) const
    {
        return KNOTS && d == radial_ ? s.knots[d][side].invR : 1;
    }

    //- The rows of W values, one of them per point
    static MPM_INLINE void spread(const T (&row)[4], quad (&q)[W])
    {
        for (int h = 0; h < W / 4; ++h)
        {
            quad r[4];
            for (int i = 0; i < 4; ++i)
            {
                if constexpr (W == 4)
                {
                    r[i] = row[i];
                }
                else
                {
                    r[i] = halfOf<4>(row[i], h);
                }
            }
            transpose<4>(r);
            for (int i = 0; i < 4; ++i)
            {
                q[4 * h + i] = r[i];
            }
        }
    }

    //- Volume, flux in each direction, mass and change of volume, one set per point
    static MPM_INLINE void
    spread(const T& v, const T (&flux)[DIM], const T& m, const T& dv, values (&q)[W])
    {
        const T low[4] = {v, flux[0], m, dv};
        if constexpr (DIM == 1)
        {
            spread(low, q);
        }
        else
        {
            const T high[4] = {v, flux[1], m, flux[DIM - 1]};
            quad a[W], b[W];
            spread(low, a);
            spread(high, b);
            for (int l = 0; l < W; ++l)
            {
                q[l] = joined<4>(a[l], b[l]);
            }
        }
    }

    //- q_0 a_0 + q_1 a_1 + q_2 a_2 for each row of three values
    template<int N, class Value>
    static MPM_INLINE void contract(const T (&a)[3], const Value (&q)[3 * N], T (&to)[N])
    {
        for (int r = 0; r < N; ++r)
        {
            to[r] = a[0] * q[3 * r] + a[1] * q[3 * r + 1] + a[2] * q[3 * r + 2];
        }
    }

    //- Sums along the directions other than d
    static MPM_INLINE T contracted(const factors& K, const int d, const T (&line)[nCells / 3])
    {
        if constexpr (DIM == 1)
        {
            return line[0];
        }
        else if constexpr (DIM == 2)
        {
            T sum[1];
            contract<1>(K.n2[d == 0], line, sum);
            return sum[0];
        }
        else
        {
            T row[3], sum[1];
            contract<3>(K.n2[d == 0], line, row);
            contract<1>(K.n2[d == 2 ? 1 : 2], row, sum);
            return sum[0];
        }
    }

    //- sum over cells of kernels times values
    static MPM_INLINE T atPoints(const factors& K, const scalar (&P)[nCells])
    {
        T line[nCells / 3];
        contract<nCells / 3>(K.n2[0], P, line);
        return contracted(K, 0, line);
    }

    //- The same over the faces of direction d
    static MPM_INLINE T atPoints(const factors& K, const int d, const scalar (&G)[nFaces])
    {
        T line[nCells / 3];
        for (int r = 0; r < nCells / 3; ++r)
        {
            line[r] = K.n1[d][0] * G[2 * r] + K.n1[d][1] * G[2 * r + 1];
        }
        return contracted(K, d, line);
    }

public:
    explicit boxKernels(const fractionLattice& sums) : sums_(sums), radial_(sums.grid().radial())
    {
        for (int d = 0; d < DIM; ++d)
        {
            knots_[d] = d == radial_ || sums.graded(d);
        }
    }

    void depart(materialPointCloud& cloud, scalar* face) const override
    {
        const scalar* x[DIM];
        const scalar* way[DIM];
        for (int d = 0; d < DIM; ++d)
        {
            x[d] = cloud.x()[d];
            way[d] = (*cloud.displacement())[d];
        }
        const scalar* v = (*cloud.gasVolume())[0];

        forAll(cloud.cells(), k)
        {
            around s;
            prepare(cloud.cells()[k], s);
            sums<quad> acc = {};
            const label end = cloud.start()[k + 1];
            for (label p = cloud.start()[k]; p < end; p += W)
            {
                const int n = int(min(label(W), end - p));
                factors K;
                evaluate(s, x, p, n, K);
                const T vp = 0.5 * load<W>(v + p);
                T row[4] = {};
                for (int d = 0; d < DIM; ++d)
                {
                    T w = load<W>(way[d] + p);
                    if (KNOTS && d == radial_)
                    {
                        // Half the change of r^2
                        w *= load<W>(x[d] + p) + 0.5 * w;
                    }
                    row[d] = vp * w;
                }
                quad q[W];
                spread(row, q);
                add(K, q, n, acc);
            }
            for (int d = 0; d < DIM; ++d)
            {
                scalar* to = face + size_t(faceStride) * sums_.nPlaces() * d;
                forFaces(
                    s, d, acc,
                    [&](const label place, const int side, const quad& q)
                    { to[size_t(faceStride) * place + flux] += q[d] * scaleOf(s, d, side); });
            }
        }
    }

    void arrive(materialPointCloud& cloud, const scalar* oldVolume, scalar* face, scalar* cell)
        const override
    {
        const scalar* x[DIM];
        const scalar* way[DIM];
        for (int d = 0; d < DIM; ++d)
        {
            x[d] = cloud.x()[d];
            way[d] = (*cloud.displacement())[d];
        }
        const scalar* v = (*cloud.gasVolume())[0];
        const scalar* m = cloud.mass()[0];

        forAll(cloud.cells(), k)
        {
            around s;
            prepare(cloud.cells()[k], s);
            sums<values> acc = {};
            const label end = cloud.start()[k + 1];
            for (label p = cloud.start()[k]; p < end; p += W)
            {
                const int n = int(min(label(W), end - p));
                factors K;
                evaluate(s, x, p, n, K);
                const T vp = load<W>(v + p);
                T ways[DIM];
                for (int d = 0; d < DIM; ++d)
                {
                    T w = load<W>(way[d] + p);
                    if (KNOTS && d == radial_)
                    {
                        w *= load<W>(x[d] + p) - 0.5 * w;
                    }
                    ways[d] = 0.5 * vp * w;
                }
                values q[W];
                spread(vp, ways, load<W>(m + p), oldVolume ? vp - load<W>(oldVolume + p) : T{}, q);
                add(K, q, n, acc);
            }
            for (int d = 0; d < DIM; ++d)
            {
                scalar* to = face + size_t(faceStride) * sums_.nPlaces() * d;
                forFaces(
                    s, d, acc,
                    [&](const label place, const int side, quad q)
                    {
                        if (d == 2)
                        {
                            q[int(flux)] = q[3];
                        }
                        q[int(flux)] *= scaleOf(s, d, side);
                        scalar* at = to + size_t(faceStride) * place;
                        mpm::store<4>(at, mpm::load<4>(at) + q);
                    });
            }
            for (int c = 0; c < nCells; ++c)
            {
                scalar* at = cell + size_t(cellStride) * s.cell[c];
                quad q;
                std::memcpy(&q, &acc.cell[c], sizeof(q));
                mpm::store<4>(at, mpm::load<4>(at) + q);
            }
        }
    }

    void gather(materialPointCloud& cloud, const scalar* P, const scalar* G) const override
    {
        const scalar* x[DIM];
        scalar* force[DIM];
        for (int d = 0; d < DIM; ++d)
        {
            x[d] = cloud.x()[d];
            force[d] = (*cloud.gasForce())[d];
        }
        const scalar* v = (*cloud.gasVolume())[0];
        scalar* pressure = (*cloud.gasPressure())[0];

        forAll(cloud.cells(), k)
        {
            around s;
            prepare(cloud.cells()[k], s);
            scalar Pc[nCells], Gf[DIM][nFaces];
            const scalar own = P[s.cell[nCells / 2]];
            for (int c = 0; c < nCells; ++c)
            {
                // Beyond the cell's own: a uniform one is exact
                Pc[c] = P[s.cell[c]] - own;
            }
            for (int d = 0; d < DIM; ++d)
            {
                const scalar* of = G + sums_.nPlaces() * d;
                for (int line = 0; line < nFaces / 2; ++line)
                {
                    const scalar* q = of + placeOf(s, d, line);
                    Gf[d][2 * line] = q[0] * scaleOf(s, d, 0);
                    Gf[d][2 * line + 1] = q[sums_.stride(d)] * scaleOf(s, d, 1);
                }
            }
            const label end = cloud.start()[k + 1];
            for (label p = cloud.start()[k]; p < end; p += W)
            {
                const int n = int(min(label(W), end - p));
                factors K;
                evaluate(s, x, p, n, K);

                storePart<W>(pressure + p, atPoints(K, Pc) + own, n);
                const T vp = load<W>(v + p);
                for (int d = 0; d < DIM; ++d)
                {
                    T g = atPoints(K, d, Gf[d]);
                    if (KNOTS && d == radial_)
                    {
                        g *= load<W>(x[d] + p);
                    }
                    storePart<W>(force[d] + p, -vp * g, n);
                }
            }
        }
    }
};

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

template<int DIM>
static autoPtr<pointKernels> newKernels(const fractionLattice& sums)
{
    bool knots = sums.grid().radial() >= 0;
    for (int d = 0; d < DIM; ++d)
    {
        knots = knots || sums.graded(d);
    }
    return knots ? autoPtr<pointKernels>(new boxKernels<DIM, true>(sums))
                 : autoPtr<pointKernels>(new boxKernels<DIM>(sums));
}

autoPtr<pointKernels> pointKernels::New(const fractionLattice& sums)
{
    const int D = sums.grid().nDim();
    return D == 1 ? newKernels<1>(sums) : D == 2 ? newKernels<2>(sums) : newKernels<3>(sums);
}

} // End namespace Foam::mpm
