/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Included by shapeTransfer.H.

\*---------------------------------------------------------------------------*/

namespace Foam::mpm
{

// * * * * * * * * * * * * * * * Nested Classes  * * * * * * * * * * * * * * //

//- The pieces of correctStress(), which takes the points in blocks of cells
//  whose velocity gradients stay in the cache while the law works on them. All
//  are inlined: the members then live in registers
template<template<int> class Shape, int DIM, bool HOOP>
struct shapeTransfer<Shape, DIM, HOOP>::stressPass
{
    //- Components of the velocity gradient
    static constexpr int N = DIM * DIM + (HOOP ? 1 : 0);

    //- Points that go together as whole cells
    static constexpr label blockSize = 256;

    //- Velocity gradient times dt, width of the cell, shift of traces
    struct buffers
    {
        alignas(64) scalar dL[N][bufferSize + laneWidth<DIM>];
        alignas(64) scalar width[bufferSize + laneWidth<DIM>];
        alignas(64) scalar shift[bufferSize + laneWidth<DIM>];
    };

    //- Points of a cell in the block
    struct range
    {
        label begin, end;
    };

    const shapeTransfer& transfer;
    materialPointCloud& cloud;
    buffers& room;
    const scalar dt, square;
    const bool cellMeans;

    //- Of the velocity gradient, with the columns of the law; of the force
    geometry geo;
    const geometry geoOfForce;

    column& stress;
    scalar* volume;
    const scalar* damage;
    const labelList& first;

    //- Cells from k0, before k1; points from begin, before end
    label k0, k1, begin, end;

    stressPass(
        const shapeTransfer& t, materialPointCloud& c, buffers& b, const scalar deltaT,
        const scalar squareOfGradient) :
        transfer(t),
        cloud(c),
        room(b),
        dt(deltaT),
        square(squareOfGradient),
        cellMeans(t.cellMeans),
        geo(c, false),
        geoOfForce(c, false),
        stress(c.stress()),
        volume(c.volume()[0]),
        damage(c.damage() ? (*c.damage())[0] : nullptr),
        first(c.start()),
        k0(0),
        k1(0),
        begin(0),
        end(0)
    {
        geo.fetch(&c.stress());
        geo.fetch(&c.volume());
        for (const column& h : c.history())
        {
            geo.fetch(&h);
        }
    }

    //- Whole cells while they fit; a cell with more points than the buffer
    //  goes in pieces. False: no more cells
    MPM_INLINE bool next()
    {
        k0 = k1;
        if (k0 >= cloud.cells().size())
        {
            return false;
        }
        ++k1;
        while (k1 < cloud.cells().size() && first[k1 + 1] - first[k0] <= blockSize)
        {
            ++k1;
        }
        begin = first[k0];
        return true;
    }

    MPM_INLINE range part(const label k) const
    {
        return range{max(first[k], begin), min(first[k + 1], end)};
    }

    MPM_INLINE void findWidths() const
    {
        for (label k = k0; k < k1; ++k)
        {
            const scalar l = transfer.meanWidth(cloud.grid(), cloud.cells()[k]);
            const range r(part(k));
            std::fill(room.width + (r.begin - begin), room.width + (r.end - begin), l);
        }
    }

    //- Velocity gradient times dt of the points of a cell
    MPM_INLINE void velocityGradient(const label celli, const range r, const scalar* u) const
    {
        stencil s;
        transfer.shape_.prepare(celli, s);
        for (label p = r.begin; p < r.end; p += W)
        {
            const label i = p - begin;
            T X[DIM], L[DIM], G[DIM * DIM];
            geo.load(p, int(min(label(W), r.end - p)), X, L);
            gradientsType S;
            transfer.shape_.evaluate(s, X, L, S);
            shapeType::template gatherGradient<P>(S, s.nodes, u, G);
            transfer.shape_.toPhysical(S, G);
            storeGradient(G, i);
            if constexpr (HOOP)
            {
                T U[DIM];
                shapeType::gatherBeside(S, s.nodes, u, U);
                const T hoop = dt * U[transfer.radial_] * transfer.inverseRadius(s, X);
                store<W>(room.dL[N - 1] + i, hoop + square * hoop * hoop);
            }
        }
        if (cellMeans && r.begin < r.end)
        {
            meanOfTraces(r);
        }
    }

    //- dt L + square (dt L)^2
    MPM_INLINE void storeGradient(T (&G)[DIM * DIM], const label at) const
    {
        for (int i = 0; i < DIM * DIM; ++i)
        {
            G[i] *= dt;
        }
        for (int i = 0; i < DIM; ++i)
        {
            for (int j = 0; j < DIM; ++j)
            {
                T GG = G[i * DIM] * G[j];
                for (int k = 1; k < DIM; ++k)
                {
                    GG += G[i * DIM + k] * G[k * DIM + j];
                }
                store<W>(room.dL[i * DIM + j] + at, G[i * DIM + j] + square * GG);
            }
        }
    }

    //- The trace of the points of a cell is their mean
    MPM_INLINE void meanOfTraces(const range r) const
    {
        const label i = r.begin - begin;
        const scalar* diagonal[nDiagonal];
        for (int d = 0; d < nDiagonal; ++d)
        {
            diagonal[d] = room.dL[d < DIM ? d * (DIM + 1) : N - 1] + i;
        }
        shiftToMean(
            diagonal, volume + r.begin, damage ? damage + r.begin : nullptr, r.end - r.begin,
            room.shift + i);
        for (int d = 0; d < nDiagonal; ++d)
        {
            scalar* to = room.dL[d < DIM ? d * (DIM + 1) : N - 1];
            for (label j = i; j < r.end - begin; ++j)
            {
                to[j] += room.shift[j];
            }
        }
    }

    //- Of the points of the block
    MPM_INLINE void addToTraces(const scalar* dilatation) const
    {
        for (int d = 0; d < nDiagonal; ++d)
        {
            scalar* to = room.dL[d < DIM ? d * (DIM + 1) : N - 1];
            for (label p = begin; p < end; ++p)
            {
                to[p - begin] += dilatation[p] / nDiagonal;
            }
        }
    }

    MPM_INLINE T trace(const label i) const
    {
        T tr = load<W>(room.dL[0] + i);
        for (int d = 1; d < DIM; ++d)
        {
            tr += load<W>(room.dL[d * (DIM + 1)] + i);
        }
        if constexpr (HOOP)
        {
            tr += load<W>(room.dL[N - 1] + i);
        }
        return tr;
    }

    //- v <- v det f = v exp(tr log f). False: a volume has turned over, as none
    //  does in a step in which the series holds
    MPM_INLINE bool changeVolumes() const
    {
        T largest = {};
        const label nHere = end - begin;
        for (label i = nHere; i < nHere + laneWidth<DIM>; ++i)
        {
            for (int c = 0; c < N; ++c)
            {
                room.dL[c][i] = 0;
            }
        }
        for (label i = 0; i < nHere; i += W)
        {
            largest = laneMax(largest, laneAbs(trace(i)));
        }
        const scalar most = horizontalMax(largest);
        const int terms = expTerms(min(most, 2.0));
        for (label i = 0; i < nHere; i += W)
        {
            const int n = int(min(label(W), nHere - i));
            const T v = load<W>(volume + begin + i) * expSeries(trace(i), terms);
            if (n == W)
            {
                store<W>(volume + begin + i, v);
            }
            else
            {
                storePart<W>(volume + begin + i, v, n);
            }
        }
        bool all = true;
        for (label p = begin; most > 2 && p < end; ++p)
        {
            all = all && volume[p] > 0;
        }
        return all;
    }

    //- What the law gets
    MPM_INLINE pointBlock block() const
    {
        pointBlock b(cloud.block(begin, end - begin));
        b.dt = dt;
        for (int i = 0; i < DIM * DIM; ++i)
        {
            b.dL[i] = room.dL[i];
        }
        b.hoop = HOOP ? room.dL[N - 1] : nullptr;
        return b;
    }

    //- Force of the new stress of the points of a cell
    MPM_INLINE void addForce(const label celli, const range r, scalar* f, T& notFinite) const
    {
        stencil s;
        transfer.shape_.prepare(celli, s);
        gradientAccumulator acc;
        if (cellMeans && r.begin < r.end)
        {
            shiftStress(stress, volume, damage, r.begin, r.end, room.shift + (r.begin - begin));
        }
        for (label p = r.begin; p < r.end; p += W)
        {
            T X[DIM], L[DIM], F[DIM * DIM];
            const int n = int(min(label(W), r.end - p));
            geoOfForce.load(p, n, X, L);
            gradientsType S;
            transfer.shape_.evaluate(s, X, L, S);
            const T more = cellMeans ? load<W>(room.shift + (p - begin)) : T{};
            minusVolumeStress(stress, volume, p, more, F);
            for (int i = 0; i < DIM * DIM; ++i)
            {
                notFinite += 0.0 * F[i];
            }
            if constexpr (HOOP)
            {
                T q[DIM];
                transfer.minusHoopForce(s, stress, volume, p, more, X, q);
                shapeType::template scatter<DIM>(S, q, n, acc);
                for (int d = 0; d < DIM; ++d)
                {
                    notFinite += 0.0 * q[d];
                }
            }
            transfer.shape_.toLocal(S, F);
            shapeType::scatterGradient(S, F, n, acc);
        }
        shapeType::flushGradient(acc, s.nodes, f);
    }

    //- Zero times volume and stress of a point
    MPM_INLINE scalar zero(const label p) const
    {
        scalar sum = 0 * volume[p];
        for (int i = 0; i < nStress(DIM); ++i)
        {
            sum += 0 * stress[i][p];
        }
        return sum;
    }

    //- Where no force is asked for
    MPM_INLINE void addNotFinite(T& notFinite) const
    {
        for (label p = begin; p < end; ++p)
        {
            notFinite[0] += zero(p);
        }
    }

    //- First point of the block that is not finite or has no volume, -1: lanes of
    //  the next points are seen here and found later
    MPM_INLINE label firstBad() const
    {
        for (label p = begin; p < end; ++p)
        {
            if (!(zero(p) == 0 && volume[p] > 0))
            {
                return p;
            }
        }
        return -1;
    }
};

} // End namespace Foam::mpm
