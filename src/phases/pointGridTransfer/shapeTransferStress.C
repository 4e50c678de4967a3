/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Included by shapeTransfer.H.

\*---------------------------------------------------------------------------*/

namespace Foam::mpm
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::shiftToMean(
    const scalar* const (&diagonal)[nDiagonal], const scalar* weight, const scalar* damage,
    const label n, scalar* shift)
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
        shift[i] = -tr / nDiagonal;
        sumW += w;
        sum += w * shift[i];
    }
    const scalar mean = sum / sumW;
    for (label i = 0; i < n; ++i)
    {
        shift[i] = damage && damage[i] > 0 ? 0 : shift[i] - mean;
    }
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::shiftStress(
    const column& stress, const scalar* volume, const scalar* damage, const label begin,
    const label end, scalar* shift)
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
    shiftToMean(diagonal, volume + begin, damage ? damage + begin : nullptr, end - begin, shift);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::force(materialPointCloud& cloud, scalar* f) const
{
    geometry geo(cloud, false);
    const scalar* volume = cloud.volume()[0];
    const column& stress = cloud.stress();
    for (const column* used :
         {&cloud.stress(), &cloud.volume(), cloud.gasPressure(), cloud.gasForce()})
    {
        geo.fetch(used);
    }
    const scalar* pressure = cloud.gasPressure() ? (*cloud.gasPressure())[0] : nullptr;
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

    gradientAccumulator acc;
    forGroups(
        cloud, [&](const stencil&) { acc.clear(); },
        [&](const stencil& s, label, const label p, const int n)
        {
            T X[DIM], L[DIM], F[DIM * DIM];
            geo.load(p, n, X, L);
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
                const T vP = load<W>(volume + p) * load<W>(pressure + p);
                T q[DIM];
                for (int d = 0; d < DIM; ++d)
                {
                    F[d * (DIM + 1)] -= vP;
                    q[d] = load<W>(push[d] + p);
                }
                if constexpr (HOOP)
                {
                    q[radial_] -= vP * inverseRadius(s, X);
                }
                shapeType::template scatter<DIM>(S, q, n, acc);
            }
            shape_.toLocal(S, F);
            shapeType::scatterGradient(S, F, n, acc);
        },
        [&](const stencil& s) { shapeType::flushGradient(acc, s.nodes, f); });
}

template<template<int> class Shape, int DIM, bool HOOP>
pointGridTransfer::stressResult shapeTransfer<Shape, DIM, HOOP>::correctStress(
    materialPointCloud& cloud, const constitutiveModel& law, const failureModel* failure,
    const scalar dt, const scalar square, const scalar* u, scalar* f,
    const scalar* dilatation) const
{
    static thread_local typename stressPass::buffers room;
    stressPass pass(*this, cloud, room, dt, square);
    const bool needsWidth = law.needsWidth() || (failure && failure->needsWidth());
    const labelList& cells = cloud.cells();
    const labelList& first = cloud.start();
    stressResult result{0, -1, 0, -1};

    while (pass.next())
    {
        for (; pass.begin < first[pass.k1]; pass.begin += bufferSize)
        {
            pass.end = min(first[pass.k1], pass.begin + bufferSize);
            if (needsWidth)
            {
                pass.findWidths();
            }
            for (label k = pass.k0; k < pass.k1; ++k)
            {
                pass.velocityGradient(cells[k], pass.part(k), u);
            }
            if (dilatation)
            {
                pass.addToTraces(dilatation);
            }
            bool allFinite = pass.changeVolumes();

            pointBlock block(pass.block());
            block.width = needsWidth ? room.width : nullptr;
            if (failure)
            {
                failure->start(block);
            }
            law.correct(block);
            if (block.waveSpeed > result.waveSpeed)
            {
                result.waveSpeed = block.waveSpeed;
                result.fastest = pass.begin;
            }
            if (failure)
            {
                result.nFailed += failure->finish(block);
            }

            // Zero times a number that is not finite is not zero: one sum
            // tells for the block
            T notFinite = {};
            if (f)
            {
                for (label k = pass.k0; k < pass.k1; ++k)
                {
                    pass.addForce(cells[k], pass.part(k), f, notFinite);
                }
            }
            else
            {
                pass.addNotFinite(notFinite);
            }
            for (int l = 0; l < W; ++l)
            {
                allFinite = allFinite && notFinite[l] == 0;
            }
            if (!allFinite && result.badPoint < 0)
            {
                result.badPoint = pass.firstBad();
            }
        }
    }
    return result;
}

} // End namespace Foam::mpm
