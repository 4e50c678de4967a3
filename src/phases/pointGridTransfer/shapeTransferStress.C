/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    Included by shapeTransfer.H.

\*---------------------------------------------------------------------------*/

namespace Foam
{
namespace mpm
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::shiftToMean
(
    const scalar* const (&diagonal)[nDiagonal],
    const scalar* weight,
    const scalar* damage,
    const label n,
    scalar* shift
)
{
    scalar sumW = VSMALL, sum = 0;
    for (label i = 0; i < n; ++i)
    {
        scalar tr = 0;
        for (int d = 0; d < nDiagonal; ++d)
        {
            tr += diagonal[d][i];
        }
        const scalar w = damage && damage[i] > 0 ? 0 : weight[i];
        shift[i] = -tr/nDiagonal;
        sumW += w;
        sum += w*shift[i];
    }
    const scalar mean = sum/sumW;
    for (label i = 0; i < n; ++i)
    {
        shift[i] = damage && damage[i] > 0 ? 0 : shift[i] - mean;
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::shiftStress
(
    const column& stress,
    const scalar* volume,
    const scalar* damage,
    const label begin,
    const label end,
    scalar* shift
)
{
    const scalar* diagonal[nDiagonal];
    for (int d = 0; d < DIM; ++d)
    {
        diagonal[d] = stress[symmSlot(d, d)] + begin;
    }
    if (HOOP)
    {
        diagonal[nDiagonal - 1] = stress[2] + begin;
    }
    shiftToMean
    (
        diagonal,
        volume + begin,
        damage ? damage + begin : nullptr,
        end - begin,
        shift
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::force
(
    materialPointCloud& cloud,
    scalar* f
) const
{
    const geometry geo(cloud, false);
    const scalar* volume = cloud.volume()[0];
    const column& stress = cloud.stress();
    const scalar* pressure =
        cloud.gasPressure() ? (*cloud.gasPressure())[0] : nullptr;
    const scalar* push[DIM] = {};
    for (int d = 0; pressure && d < DIM; ++d)
    {
        push[d] = (*cloud.gasForce())[d];
    }

    static thread_local std::vector<scalar> shift;
    if (cellMeans)
    {
        const labelList& first = cloud.start();
        shift.resize(first.size() ? first.last() + W : 0);
        const scalar* damage = cloud.damage() ? (*cloud.damage())[0] : nullptr;
        for (label k = 0; k < cloud.cells().size(); ++k)
        {
            // In the same pieces as correctStress()
            for (label p = first[k]; p < first[k + 1]; p += bufferSize)
            {
                const label end = min(first[k + 1], p + bufferSize);
                shiftStress(stress, volume, damage, p, end, shift.data() + p);
            }
        }
    }

    accumulator acc;
    forGroups
    (
        cloud,
        [&](const stencil&) { acc.clear(); },
        [&](const stencil& s, label, const label p, const int n)
        {
            T X[DIM], L[DIM], F[DIM*DIM];
            geo.load(p, X, L);
            gradientsType S;
            shape_.evaluate(s, X, L, S);
            const T more = cellMeans ? load<W>(shift.data() + p) : T{};
            minusVolumeStress(stress, volume, p, more, F);
            if constexpr (HOOP)
            {
                T q[DIM];
                minusHoopForce(s, stress, volume, p, more, X, q);
                shapeType::template scatter<DIM>(S, q, n, acc);
            }
            if (pressure)
            {
                const T vP = load<W>(volume + p)*load<W>(pressure + p);
                T q[DIM];
                for (int d = 0; d < DIM; ++d)
                {
                    F[d*(DIM + 1)] -= vP;
                    q[d] = load<W>(push[d] + p);
                }
                if constexpr (HOOP)
                {
                    q[radial_] -= vP*inverseRadius(s, X);
                }
                shapeType::template scatter<DIM>(S, q, n, acc);
            }
            shape_.toLocal(S, F);
            shapeType::scatterGradient(S, F, n, acc);
        },
        [&](const stencil& s) { shapeType::flush(acc, s.nodes, f); }
    );
}


template<template<int> class Shape, int DIM, bool HOOP>
pointGridTransfer::stressResult shapeTransfer<Shape, DIM, HOOP>::correctStress
(
    materialPointCloud& cloud,
    const constitutiveModel& law,
    const failureModel* failure,
    const scalar dt,
    const scalar square,
    const scalar* u,
    scalar* f
) const
{
    // Blocks of cells whose velocity gradients stay in the cache while the
    // law works on them
    constexpr label blockSize = 256;
    constexpr int N = DIM*DIM + (HOOP ? 1 : 0);
    alignas(64) static thread_local scalar dL[N][bufferSize + W];

    alignas(64) static thread_local scalar width[bufferSize + W];
    alignas(64) static thread_local scalar shift[bufferSize + W];
    const bool needsWidth =
        law.needsWidth() || (failure && failure->needsWidth());

    const geometry geo(cloud, false);
    column& stress = cloud.stress();
    scalar* volume = cloud.volume()[0];
    const scalar* mass = cloud.mass()[0];
    const scalar* damage = cloud.damage() ? (*cloud.damage())[0] : nullptr;
    const labelList& cells = cloud.cells();
    const labelList& first = cloud.start();
    stressResult result{0, -1, 0, -1};

    for (label k0 = 0; k0 < cells.size();)
    {
        // Whole cells while they fit; a cell with more points than the buffer
        // goes in pieces
        label k1 = k0 + 1;
        while
        (
            k1 < cells.size()
         && first[k1 + 1] - first[k0] <= blockSize
        )
        {
            ++k1;
        }

        for
        (
            label begin = first[k0];
            begin < first[k1];
            begin += bufferSize
        )
        {
            const label end = min(first[k1], begin + bufferSize);

            for (label k = k0; needsWidth && k < k1; ++k)
            {
                scalar product = 1;
                for (int d = 0; d < DIM; ++d)
                {
                    product *= cloud.grid().width(cells[k], d);
                }
                const scalar l =
                    DIM == 1 ? product
                  : DIM == 2 ? std::sqrt(product)
                  : std::cbrt(product);
                std::fill
                (
                    width + (max(first[k], begin) - begin),
                    width + (min(first[k + 1], end) - begin),
                    l
                );
            }

            // Velocity gradient and volume
            for (label k = k0; k < k1; ++k)
            {
                stencil s;
                shape_.prepare(cells[k], s);
                const label pEnd = min(first[k + 1], end);
                for (label p = max(first[k], begin); p < pEnd; p += W)
                {
                    T X[DIM], L[DIM], G[DIM*DIM];
                    geo.load(p, X, L);
                    gradientsType S;
                    shape_.evaluate(s, X, L, S);
                    shapeType::template gatherGradient<P>(S, s.nodes, u, G);
                    shape_.toPhysical(S, G);
                    for (int i = 0; i < DIM*DIM; ++i)
                    {
                        G[i] *= dt;
                    }
                    for (int i = 0; i < DIM; ++i)
                    {
                        for (int j = 0; j < DIM; ++j)
                        {
                            T GG = G[i*DIM]*G[j];
                            for (int k = 1; k < DIM; ++k)
                            {
                                GG += G[i*DIM + k]*G[k*DIM + j];
                            }
                            store<W>
                            (
                                dL[i*DIM + j] + (p - begin),
                                G[i*DIM + j] + square*GG
                            );
                        }
                    }
                    if constexpr (HOOP)
                    {
                        T U[DIM];
                        shapeType::template gather<DIM, P>(S, s.nodes, u, U);
                        const T hoop = dt*U[radial_]*inverseRadius(s, X);
                        store<W>
                        (
                            dL[N - 1] + (p - begin),
                            hoop + square*hoop*hoop
                        );
                    }
                }
                const label pBegin = max(first[k], begin);
                if (cellMeans && pBegin < pEnd)
                {
                    const label i = pBegin - begin;
                    const scalar* diagonal[nDiagonal];
                    for (int d = 0; d < nDiagonal; ++d)
                    {
                        diagonal[d] = dL[d < DIM ? d*(DIM + 1) : N - 1] + i;
                    }
                    shiftToMean
                    (
                        diagonal,
                        volume + pBegin,
                        damage ? damage + pBegin : nullptr,
                        pEnd - pBegin,
                        shift + i
                    );
                    for (int d = 0; d < nDiagonal; ++d)
                    {
                        scalar* to = dL[d < DIM ? d*(DIM + 1) : N - 1];
                        for (label j = i; j < pEnd - begin; ++j)
                        {
                            to[j] += shift[j];
                        }
                    }
                }
            }

            // v <- v det f = v exp(tr log f)
            T largest = {};
            const label nHere = end - begin;
            for (label i = nHere; i < nHere + W; ++i)
            {
                for (int c = 0; c < N; ++c)
                {
                    dL[c][i] = 0;
                }
            }
            const auto trace = [&](const label i) __attribute__((always_inline))
            {
                T tr = load<W>(dL[0] + i);
                for (int d = 1; d < DIM; ++d)
                {
                    tr += load<W>(dL[d*(DIM + 1)] + i);
                }
                if constexpr (HOOP)
                {
                    tr += load<W>(dL[N - 1] + i);
                }
                return tr;
            };
            for (label i = 0; i < nHere; i += W)
            {
                largest = laneMax(largest, laneAbs(trace(i)));
            }
            const int terms = expTerms(min(horizontalMax(largest), 2.0));
            for (label i = 0; i < nHere; i += W)
            {
                const int n = int(min(label(W), nHere - i));
                const T v =
                    load<W>(volume + begin + i)*expSeries(trace(i), terms);
                if (n == W)
                {
                    store<W>(volume + begin + i, v);
                }
                else
                {
                    storePart<W>(volume + begin + i, v, n);
                }
            }

            // Law and failure
            pointBlock block;
            block.nDim = DIM;
            block.n = nHere;
            block.dt = dt;
            for (int i = 0; i < DIM*DIM; ++i)
            {
                block.dL[i] = dL[i];
            }
            block.hoop = HOOP ? dL[N - 1] : nullptr;
            block.mass = mass + begin;
            block.volume = volume + begin;
            for (int i = 0; i < nStress(DIM); ++i)
            {
                block.stress[i] = stress[i] + begin;
            }
            int h = 0;
            for (column& c : cloud.history())
            {
                for (int i = 0; i < c.nComponents(); ++i)
                {
                    block.history[h++] = c[i] + begin;
                }
            }
            block.damage =
                cloud.damage() ? (*cloud.damage())[0] + begin : nullptr;
            block.strength =
                cloud.strength() ? (*cloud.strength())[0] + begin : nullptr;

            block.width = needsWidth ? width : nullptr;

            if (failure)
            {
                failure->start(block);
            }
            law.correct(block);
            if (block.waveSpeed > result.waveSpeed)
            {
                result.waveSpeed = block.waveSpeed;
                result.fastest = begin;
            }
            if (failure)
            {
                result.nFailed += failure->finish(block);
            }

            // Zero times a number that is not finite is not zero: one sum
            // tells for the block
            T notFinite = {};
            for (label p = begin; !f && p < end; ++p)
            {
                notFinite[0] += 0.0*volume[p];
                for (int i = 0; i < nStress(DIM); ++i)
                {
                    notFinite[0] += 0.0*stress[i][p];
                }
            }

            // Force of the new stress
            for (label k = k0; f && k < k1; ++k)
            {
                stencil s;
                shape_.prepare(cells[k], s);
                accumulator acc;
                const label pBegin = max(first[k], begin);
                const label pEnd = min(first[k + 1], end);
                if (cellMeans && pBegin < pEnd)
                {
                    shiftStress
                    (
                        stress,
                        volume,
                        damage,
                        pBegin,
                        pEnd,
                        shift + (pBegin - begin)
                    );
                }
                for (label p = pBegin; p < pEnd; p += W)
                {
                    T X[DIM], L[DIM], F[DIM*DIM];
                    geo.load(p, X, L);
                    gradientsType S;
                    shape_.evaluate(s, X, L, S);
                    const T more =
                        cellMeans ? load<W>(shift + (p - begin)) : T{};
                    minusVolumeStress(stress, volume, p, more, F);
                    for (int i = 0; i < DIM*DIM; ++i)
                    {
                        notFinite += 0.0*F[i];
                    }
                    const int n = int(min(label(W), pEnd - p));
                    if constexpr (HOOP)
                    {
                        T q[DIM];
                        minusHoopForce(s, stress, volume, p, more, X, q);
                        shapeType::template scatter<DIM>(S, q, n, acc);
                        for (int d = 0; d < DIM; ++d)
                        {
                            notFinite += 0.0*q[d];
                        }
                    }
                    shape_.toLocal(S, F);
                    shapeType::scatterGradient(S, F, n, acc);
                }
                shapeType::flush(acc, s.nodes, f);
            }

            bool allFinite = true;
            for (int l = 0; l < W; ++l)
            {
                allFinite = allFinite && notFinite[l] == 0;
            }
            if (!allFinite && result.badPoint < 0)
            {
                // Lanes beyond the block belong to points that are checked later
                for (label p = begin; p < end && result.badPoint < 0; ++p)
                {
                    scalar sum = 0*volume[p];
                    for (int i = 0; i < nStress(DIM); ++i)
                    {
                        sum += 0*stress[i][p];
                    }
                    if (!(sum == 0))
                    {
                        result.badPoint = p;
                    }
                }
            }
        }
        k0 = k1;
    }
    return result;
}

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
