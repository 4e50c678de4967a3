// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointKernels.H"
#include "lanes.H"

namespace Foam::mpm
{

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

template<int DIM, bool HOOP = false>
class boxKernels : public pointKernels
{
    static constexpr int W = laneWidth<DIM>;
    typedef lanes<W> T;
    typedef lanes<4> quad;

    //- Cells around a cell and faces of one direction that its points reach
    static constexpr int nCells = DIM == 1 ? 3 : DIM == 2 ? 9 : 27;
    static constexpr int nFaces = 2 * nCells / 3;

    const fractionLattice& sums_;

    //- Computed direction of the radius where HOOP is
    const int radial_;

    //- Factors of the kernels of W points: hat at the lower and upper plane,
    //  spline of the cell below, the cell, the cell above
    struct factors
    {
        T n1[DIM][2], n2[DIM][3];
    };

    //- Places around a cell
    struct around
    {
        label cell[nCells];
        label face[DIM][nFaces];
        scalar lower[DIM], invWidth[DIM];

        //- Of a wedge's lower and upper face: r^2, 1/d_f, 2 r_f h/d_f, 1/r_f;
        //  the last three are zero at the axis
        scalar s[2], invD[2], scale[2], invR[2];
    };

    void prepareRadius(const label celli, around& s) const
    {
        const label i = sums_.grid().lattice().ijk(celli, radial_);
        const scalar* r = sums_.grid().lattice().planes(radial_).cdata() + i;
        for (int n = 0; n < 2; ++n)
        {
            const scalar h = r[n] - r[n - 1];
            const bool atAxis = r[n] < 1e-6 * h;
            const scalar d = sqr(r[n]) - sqr(max(r[n - 1], scalar(0)));
            s.s[n] = sqr(r[n]);
            s.invD[n] = atAxis ? 0 : 1 / d;
            s.scale[n] = atAxis ? 0 : 2 * r[n] * h / d;
            s.invR[n] = atAxis ? 0 : 1 / r[n];
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
        }
        if constexpr (HOOP)
        {
            prepareRadius(celli, s);
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
        for (int d = 0; d < DIM; ++d)
        {
            for (int n = 0; n < nFaces; ++n)
            {
                label at = place + (n % 2) * sums_.stride(d);
                int rest = n / 2;
                for (int e = 0; e < DIM; ++e)
                {
                    if (e != d)
                    {
                        at += step[e][rest % 3];
                        rest /= 3;
                    }
                }
                s.face[d][n] = at;
            }
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
            if (HOOP && d == radial_)
            {
                const T none = {}, r2 = xp * xp;
                const T c0 = laneMax(1.0 - (r2 - s.s[0]) * s.invD[0], none);
                const T c1 = laneMax(1.0 - (s.s[1] - r2) * s.invD[1], none);
                K.n1[d][0] = s.scale[0] * c0;
                K.n1[d][1] = s.scale[1] * c1;
                K.n2[d][0] = s.scale[0] > 0 ? 0.5 * c0 * c0 : none;
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

    //- Kernels (times V) of cells and of the faces of direction d
    static MPM_INLINE T cellKernel(const factors& K, const int n)
    {
        T k = K.n2[0][n % 3];
        if constexpr (DIM > 1)
            k *= K.n2[1][(n / 3) % 3];
        if constexpr (DIM > 2)
            k *= K.n2[2][n / 9];
        return k;
    }

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

    //- Add values of the first n lanes times the kernel, four per face
    static MPM_INLINE void
    addFaces(const factors& K, const int d, const T (&q)[3], const int n, quad (&acc)[nFaces])
    {
        alignas(64) double Q[W][4], k[nFaces][W];
        for (int l = 0; l < W; ++l)
        {
            Q[l][0] = q[0][l];
            Q[l][1] = q[1][l];
            Q[l][2] = q[2][l];
            Q[l][3] = 0;
        }
        for (int f = 0; f < nFaces; ++f)
        {
            store<W>(k[f], faceKernel(K, d, f));
        }
        for (int l = 0; l < n; ++l)
        {
            const quad v = mpm::load<4>(Q[l]);
            for (int f = 0; f < nFaces; ++f)
            {
                acc[f] += k[f][l] * v;
            }
        }
    }

    void flushFaces(const around& s, quad (&acc)[DIM][nFaces], scalar* face) const
    {
        for (int f = 0; HOOP && f < nFaces; ++f)
        {
            acc[radial_][f][int(flux)] *= s.invR[f % 2];
        }
        for (int d = 0; d < DIM; ++d)
        {
            scalar* to = face + size_t(faceStride) * sums_.nPlaces() * d;
            for (int f = 0; f < nFaces; ++f)
            {
                scalar* q = to + size_t(faceStride) * s.face[d][f];
                mpm::store<4>(q, mpm::load<4>(q) + acc[d][f]);
            }
        }
    }

public:
    explicit boxKernels(const fractionLattice& sums) : sums_(sums), radial_(sums.grid().radial()) {}

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
            quad acc[DIM][nFaces] = {};
            const label end = cloud.start()[k + 1];
            for (label p = cloud.start()[k]; p < end; p += W)
            {
                const int n = int(min(label(W), end - p));
                factors K;
                evaluate(s, x, p, n, K);
                const T vp = 0.5 * load<W>(v + p);
                for (int d = 0; d < DIM; ++d)
                {
                    T w = load<W>(way[d] + p);
                    if (HOOP && d == radial_)
                    {
                        // Half the change of r^2
                        w *= load<W>(x[d] + p) + 0.5 * w;
                    }
                    const T q[3] = {T{}, vp * w, T{}};
                    addFaces(K, d, q, n, acc[d]);
                }
            }
            flushFaces(s, acc, face);
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
            quad acc[DIM][nFaces] = {};
            T dilated[nCells] = {}, filled[nCells] = {};
            const label end = cloud.start()[k + 1];
            for (label p = cloud.start()[k]; p < end; p += W)
            {
                const int n = int(min(label(W), end - p));
                factors K;
                evaluate(s, x, p, n, K);
                const T vp = loadPart<W>(v + p, n);
                const T mp = load<W>(m + p);
                for (int d = 0; d < DIM; ++d)
                {
                    T w = load<W>(way[d] + p);
                    if (HOOP && d == radial_)
                    {
                        w *= load<W>(x[d] + p) - 0.5 * w;
                    }
                    const T q[3] = {vp, 0.5 * vp * w, mp};
                    addFaces(K, d, q, n, acc[d]);
                }
                T filling = vp;
                T dv = oldVolume ? vp - loadPart<W>(oldVolume + p, n) : T{};
                for (int l = n; l < W; ++l)
                {
                    filling[l] = dv[l] = 0;
                }
                for (int c = 0; c < nCells; ++c)
                {
                    const T kernel = cellKernel(K, c);
                    dilated[c] += kernel * dv;
                    filled[c] += kernel * filling;
                }
            }
            flushFaces(s, acc, face);
            for (int c = 0; c < nCells; ++c)
            {
                scalar* q = cell + size_t(cellStride) * s.cell[c];
                scalar a = 0, b = 0;
                for (int l = 0; l < W; ++l)
                {
                    a += dilated[c][l];
                    b += filled[c][l];
                }
                q[dilation] += a;
                q[fraction] += b;
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
            for (int c = 0; c < nCells; ++c)
            {
                Pc[c] = P[s.cell[c]];
            }
            for (int d = 0; d < DIM; ++d)
            {
                for (int f = 0; f < nFaces; ++f)
                {
                    Gf[d][f] = G[sums_.nPlaces() * d + s.face[d][f]];
                    if (HOOP && d == radial_)
                    {
                        Gf[d][f] *= s.invR[f % 2];
                    }
                }
            }
            const label end = cloud.start()[k + 1];
            for (label p = cloud.start()[k]; p < end; p += W)
            {
                const int n = int(min(label(W), end - p));
                factors K;
                evaluate(s, x, p, n, K);

                // Around the cell's own pressure: a uniform one is exact
                const scalar own = Pc[nCells / 2];
                T Pp = {};
                for (int c = 0; c < nCells; ++c)
                {
                    Pp += cellKernel(K, c) * (Pc[c] - own);
                }
                storePart<W>(pressure + p, Pp + own, n);
                const T vp = load<W>(v + p);
                for (int d = 0; d < DIM; ++d)
                {
                    T g = {};
                    for (int f = 0; f < nFaces; ++f)
                    {
                        g += faceKernel(K, d, f) * Gf[d][f];
                    }
                    if (HOOP && d == radial_)
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

autoPtr<pointKernels> pointKernels::New(const fractionLattice& sums)
{
    if (sums.grid().radial() >= 0)
    {
        return autoPtr<pointKernels>(new boxKernels<2, true>(sums));
    }
    switch (sums.grid().nDim())
    {
    case 1:
        return autoPtr<pointKernels>(new boxKernels<1>(sums));
    case 2:
        return autoPtr<pointKernels>(new boxKernels<2>(sums));
    default:
        return autoPtr<pointKernels>(new boxKernels<3>(sums));
    }
}

} // End namespace Foam::mpm
