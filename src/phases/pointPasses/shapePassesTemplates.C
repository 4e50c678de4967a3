/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    Included by shapePasses.H.

\*---------------------------------------------------------------------------*/

namespace Foam
{
namespace mpm
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::weights
(
    const label celli,
    const scalar* x,
    const scalar* halfSize,
    DynamicList<label>& nodes,
    DynamicList<scalar>& S,
    DynamicList<scalar>& gradS
) const
{
    stencil s;
    shape_.prepare(celli, s);
    T X[DIM], L[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        X[d] = broadcast<W>(x[d]);
        L[d] = broadcast<W>(halfSize ? halfSize[d] : 0);
    }
    gradientsType g;
    shape_.evaluate(s, X, L, g);

    nodes.clear();
    S.clear();
    gradS.clear();

    // Through the same sums as the passes: unit values at one point
    accumulator value;
    T one[1] = {broadcast<W>(1)};
    shapeType::template scatter<1>(g, one, 1, value);
    accumulator grad[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        T F[DIM*DIM];
        for (int i = 0; i < DIM*DIM; ++i)
        {
            F[i] = broadcast<W>(i == d ? 1 : 0);
        }
        shape_.toLocal(g, F);
        shapeType::scatterGradient(g, F, 1, grad[d]);
    }
    for (int n = 0; n < shapeType::nNodes; ++n)
    {
        const int r = n/(2*shapeType::NP), i = n % (2*shapeType::NP);
        nodes.append(s.nodes[n]);
        S.append(value.a[r][i/2][P*(i % 2)]);
        for (int d = 0; d < DIM; ++d)
        {
            gradS.append(grad[d].a[r][i/2][P*(i % 2)]);
        }
    }
}


template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::project
(
    materialPointCloud& cloud,
    const states state,
    scalar* mU
) const
{
    if (cloud.affine())
    {
        projectAffine(cloud, state, mU);
        return;
    }

    const geometry geo(cloud, state == tentative);
    const scalar* mass = cloud.mass()[0];
    const scalar* U[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        U[d] = state == current ? cloud.U()[d] : cloud.UNew()[d];
    }

    accumulator acc;
    forGroups
    (
        cloud,
        [&](const stencil&) { acc.clear(); },
        [&](const stencil& s, label, const label p, const int n)
        {
            T X[DIM], L[DIM], q[DIM + 1];
            geo.load(p, X, L);
            weightsType S;
            shape_.evaluate(s, X, L, S);
            q[DIM] = load<W>(mass + p);
            for (int d = 0; d < DIM; ++d)
            {
                q[d] = q[DIM]*load<W>(U[d] + p);
            }
            shapeType::template scatter<DIM + 1>(S, q, n, acc);
        },
        [&](const stencil& s) { shapeType::flush(acc, s.nodes, mU); }
    );
}


template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::projectAffine
(
    materialPointCloud& cloud,
    const states state,
    scalar* mU
) const
{
    const geometry geo(cloud, state == tentative);
    const scalar* mass = cloud.mass()[0];
    const column& C = state == current ? *cloud.affine() : *cloud.affineNew();
    const scalar* U[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        U[d] = state == current ? cloud.U()[d] : cloud.UNew()[d];
    }

    accumulator acc;
    forGroups
    (
        cloud,
        [&](const stencil&) { acc.clear(); },
        [&](const stencil& s, const label celli, const label p, const int n)
        {
            T X[DIM], L[DIM], q[DIM + 1], A[DIM*DIM];
            geo.load(p, X, L);
            q[DIM] = load<W>(mass + p);
            for (int d = 0; d < DIM; ++d)
            {
                q[d] = q[DIM]*load<W>(U[d] + p);
            }
            for (int i = 0; i < DIM*DIM; ++i)
            {
                A[i] = q[DIM]*load<W>(C[i] + p);
            }
            shape_.scatterAffine(celli, s, X, L, q, A, n, acc);
        },
        [&](const stencil& s) { shapeType::flush(acc, s.nodes, mU); }
    );
}


template<template<int> class Shape, int DIM>
template<int STRIDE>
void shapePasses<Shape, DIM>::affineFrom
(
    materialPointCloud& cloud,
    const bool moment,
    const scalar* u
) const
{
    const geometry geo(cloud, false);
    column& C = *cloud.affineNew();

    forGroups
    (
        cloud,
        [&](const stencil&) {},
        [&](const stencil& s, const label celli, const label p, const int)
        {
            T X[DIM], L[DIM], G[DIM*DIM], D[DIM];
            geo.load(p, X, L);
            gradientsType S;
            if (moment && shapeType::hasMoments)
            {
                shape_.moments(celli, s, X, L, S, D);
                shapeType::template gatherGradient<STRIDE>(S, s.nodes, u, G);
                for (int i = 0; i < DIM*DIM; ++i)
                {
                    G[i] /= D[i % DIM];
                }
            }
            else
            {
                shape_.evaluate(s, X, L, S);
                shapeType::template gatherGradient<STRIDE>(S, s.nodes, u, G);
                shape_.toPhysical(S, G);
            }
            for (int i = 0; i < DIM*DIM; ++i)
            {
                store<W>(C[i] + p, G[i]);
            }
        },
        [&](const stencil&) {}
    );
}


template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::affine
(
    materialPointCloud& cloud,
    const bool moment,
    const scalar* u,
    const label stride
) const
{
    if (stride == P)
    {
        affineFrom<P>(cloud, moment, u);
    }
    else
    {
        affineFrom<2*P>(cloud, moment, u);
    }
}


template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::force
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
            minusVolumeStress(stress, volume, p, F);
            if (pressure)
            {
                const T vP = load<W>(volume + p)*load<W>(pressure + p);
                T q[DIM];
                for (int d = 0; d < DIM; ++d)
                {
                    F[d*(DIM + 1)] -= vP;
                    q[d] = load<W>(push[d] + p);
                }
                shapeType::template scatter<DIM>(S, q, n, acc);
            }
            shape_.toLocal(S, F);
            shapeType::scatterGradient(S, F, n, acc);
        },
        [&](const stencil& s) { shapeType::flush(acc, s.nodes, f); }
    );
}


template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::forStencils
(
    const materialPointCloud& cloud,
    const std::function<void(const label, const label*)>& f
) const
{
    forAll(cloud.cells(), k)
    {
        stencil s;
        shape_.prepare(cloud.cells()[k], s);
        f(k, s.nodes);
    }
}


template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::massShares
(
    materialPointCloud& cloud,
    scalar* share
) const
{
    const geometry geo(cloud, false);
    const scalar* mass = cloud.mass()[0];

    accumulator acc;
    forGroups
    (
        cloud,
        [&](const stencil&) { acc.clear(); },
        [&](const stencil& s, label, const label p, const int n)
        {
            T X[DIM], L[DIM];
            geo.load(p, X, L);
            weightsType S;
            shape_.evaluate(s, X, L, S);
            const T q[1] = {load<W>(mass + p)};
            shapeType::template scatter<1>(S, q, n, acc);
        },
        [&](const stencil&)
        {
            for (int i = 0; i < shapeType::nNodes; ++i)
            {
                const int r = i/(2*shapeType::NP), j = i % (2*shapeType::NP);
                *share++ = acc.a[r][j/2][P*(j % 2)];
            }
        }
    );
}


template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::addBodyForce
(
    materialPointCloud& cloud,
    const column& b,
    scalar* f
) const
{
    const geometry geo(cloud, false);
    const scalar* mass = cloud.mass()[0];

    accumulator acc;
    forGroups
    (
        cloud,
        [&](const stencil&) { acc.clear(); },
        [&](const stencil& s, label, const label p, const int n)
        {
            T X[DIM], L[DIM], q[DIM];
            geo.load(p, X, L);
            weightsType S;
            shape_.evaluate(s, X, L, S);
            const T m = load<W>(mass + p);
            for (int d = 0; d < DIM; ++d)
            {
                q[d] = m*load<W>(b[d] + p);
            }
            shapeType::template scatter<DIM>(S, q, n, acc);
        },
        [&](const stencil& s) { shapeType::flush(acc, s.nodes, f); }
    );
}


template<template<int> class Shape, int DIM>
pointPasses::moveResult shapePasses<Shape, DIM>::move
(
    materialPointCloud& cloud,
    const moveRule& rule,
    const scalar* u,
    DynamicList<materialPointCloud::mover>& movers
) const
{
    const geometry geo(cloud, false);
    const hexGrid& grid = cloud.grid();
    const scalar* U[DIM];
    scalar* xNew[DIM];
    scalar* UNew[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        U[d] = cloud.U()[d];
        xNew[d] = cloud.xNew()[d];
        UNew[d] = cloud.UNew()[d];
    }
    scalar* ways[DIM] = {};
    for (int d = 0; cloud.way() && d < DIM; ++d)
    {
        ways[d] = (*cloud.way())[d];
    }
    const double dt = rule.dt, a = rule.PICfraction;

    moveResult result{0, 0, -1, false, 0, Zero, 0};
    T travel = {}, rate = {}, work = {}, momentum[DIM] = {}, body = {};
    const scalar* mass = cloud.mass()[0];
    const scalar lane[] = {0, 1, 2, 3, 4, 5, 6, 7};
    movers.clear();

    forGroups
    (
        cloud,
        [&](const stencil&) {},
        [&](const stencil& s, const label celli, const label p, const int n)
        {
            T X[DIM], L[DIM], V[DIM];
            geo.load(p, X, L);
            weightsType S;
            shape_.evaluate(s, X, L, S);

            T dX[DIM], du[DIM];
            if (rule.kind == transfer::FLIP)
            {
                T uL[DIM];
                shapeType::template gather<DIM, 2*P>(S, s.nodes, u, uL);
                shapeType::template gather<DIM, 2*P>(S, s.nodes, u + P, du);
                for (int d = 0; d < DIM; ++d)
                {
                    // (7) and (8)
                    V[d] = (1 - a)*(load<W>(U[d] + p) + du[d]) + a*uL[d];
                    dX[d] = dt*(uL[d] - 0.5*du[d]);
                }
            }
            else
            {
                shapeType::template gather<DIM, 2*P>(S, s.nodes, u, V);
                T un[DIM];
                if (rule.kind == transfer::XPIC)
                {
                    shapeType::template gather<DIM, P>(S, s.nodes, rule.U, un);
                }
                for (int d = 0; d < DIM; ++d)
                {
                    const T v = load<W>(U[d] + p);
                    dX[d] =
                        rule.kind == transfer::FMPM ? 0.5*dt*(V[d] + v)
                      : rule.kind == transfer::XPIC ? dt*(un[d] + 0.5*(V[d] - v))
                      : dt*V[d];
                }
            }

            if (rule.energy)
            {
                if (rule.kind != transfer::FLIP)
                {
                    shapeType::template gather<DIM, 2*P>
                    (
                        S, s.nodes, u + P, du
                    );
                }
                // Lanes beyond n may hold anything
                const auto own = load<W>(lane) < broadcast<W>(n);
                const T none = {};
                const T m = select(own, load<W>(mass + p), none);
                for (int d = 0; d < DIM; ++d)
                {
                    const T w =
                        m*select(own, load<W>(U[d] + p) + 0.5*du[d], none);
                    work += w*select(own, du[d], none);
                    momentum[d] += w;
                    if (rule.bodyForce)
                    {
                        const T b = load<W>((*rule.bodyForce)[d] + p);
                        body += w*select(own, b, none);
                    }
                }
            }

            // Lanes beyond n belong to another cell: they do not count
            T way = {}, fast = {};
            for (int d = 0; d < DIM; ++d)
            {
                X[d] += dX[d];
                if (ways[d])
                {
                    storePart<W>(ways[d] + p, dX[d], n);
                }
                const double ih = shape_.inverseWidth(s, d);
                way = laneMax(way, laneAbs(dX[d])*ih);
                fast = laneMax(fast, laneAbs(V[d])*ih);
                store<W>(xNew[d] + p, X[d]);
                store<W>(UNew[d] + p, V[d]);
            }
            if (n < W)
            {
                for (int l = n; l < W; ++l)
                {
                    way[l] = 0;
                    fast[l] = 0;
                }
            }
            travel = laneMax(travel, way);
            rate = laneMax(rate, fast);

            const auto out = shape_.left(s, X);
            if (anyOf<W>(out))
            {
                for (int l = 0; l < n; ++l)
                {
                    if (!out[l])
                    {
                        continue;
                    }
                    scalar x[DIM > 2 ? DIM : 3];
                    bool finite = true;
                    for (int d = 0; d < DIM; ++d)
                    {
                        x[d] = X[d][l];
                        finite = finite && std::isfinite(x[d]);
                    }
                    // A point that goes too far is not followed: the step
                    // will be redone
                    const label to =
                        finite && way[l] <= 2 ? grid.locate(celli, x)
                      : finite ? celli : -1;
                    if (to < 0)
                    {
                        result.badPoint = p + l;
                        result.left = finite;
                        continue;
                    }
                    for (int d = 0; d < DIM; ++d)
                    {
                        xNew[d][p + l] = x[d];
                    }
                    if (to != celli)
                    {
                        movers.append(materialPointCloud::mover{p + l, to});
                    }
                }
            }
        },
        [&](const stencil&) {}
    );

    result.travel = horizontalMax(travel);
    result.rate = horizontalMax(rate);
    for (int l = 0; l < W; ++l)
    {
        result.work += work[l];
        result.bodyWork += body[l];
        for (int d = 0; d < DIM; ++d)
        {
            result.momentum[grid.direction(d)] += momentum[d][l];
        }
    }
    return result;
}


template<template<int> class Shape, int DIM>
void shapePasses<Shape, DIM>::massTimes
(
    materialPointCloud& cloud,
    const bool tentative,
    const scalar* u,
    scalar* mU
) const
{
    const geometry geo(cloud, tentative);
    const scalar* mass = cloud.mass()[0];

    accumulator acc;
    forGroups
    (
        cloud,
        [&](const stencil&) { acc.clear(); },
        [&](const stencil& s, label, const label p, const int n)
        {
            T X[DIM], L[DIM], q[DIM];
            geo.load(p, X, L);
            weightsType S;
            shape_.evaluate(s, X, L, S);
            shapeType::template gather<DIM, 2*P>(S, s.nodes, u, q);
            const T m = load<W>(mass + p);
            for (int d = 0; d < DIM; ++d)
            {
                q[d] *= m;
            }
            shapeType::template scatter<DIM>(S, q, n, acc);
        },
        [&](const stencil& s) { shapeType::flush(acc, s.nodes, mU); }
    );
}


template<template<int> class Shape, int DIM>
pointPasses::stressResult shapePasses<Shape, DIM>::correctStress
(
    materialPointCloud& cloud,
    const constitutiveModel& law,
    const failureModel* failure,
    const scalar dt,
    const scalar* u,
    scalar* f
) const
{
    // Blocks of cells whose velocity gradients stay in the cache while the
    // law works on them
    constexpr label blockSize = 256;
    constexpr label bufferSize = blockSize + 256;
    alignas(64) static thread_local scalar dL[DIM*DIM][bufferSize + W];

    alignas(64) static thread_local scalar width[bufferSize + W];
    const bool needsWidth =
        law.needsWidth() || (failure && failure->needsWidth());

    const geometry geo(cloud, false);
    column& stress = cloud.stress();
    scalar* volume = cloud.volume()[0];
    const scalar* mass = cloud.mass()[0];
    const labelList& cells = cloud.cells();
    const labelList& first = cloud.start();
    stressResult result{0, -1, 0};

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
                        store<W>(dL[i] + (p - begin), dt*G[i]);
                    }
                }
            }

            // v <- v det(exp(dt L)) = v exp(dt tr L)
            T largest = {};
            const label nHere = end - begin;
            for (label i = nHere; i < nHere + W; ++i)
            {
                for (int c = 0; c < DIM*DIM; ++c)
                {
                    dL[c][i] = 0;
                }
            }
            for (label i = 0; i < nHere; i += W)
            {
                T tr = load<W>(dL[0] + i);
                for (int d = 1; d < DIM; ++d)
                {
                    tr += load<W>(dL[d*(DIM + 1)] + i);
                }
                largest = laneMax(largest, laneAbs(tr));
            }
            const int terms = expTerms(min(horizontalMax(largest), 2.0));
            for (label i = 0; i < nHere; i += W)
            {
                T tr = load<W>(dL[0] + i);
                for (int d = 1; d < DIM; ++d)
                {
                    tr += load<W>(dL[d*(DIM + 1)] + i);
                }
                const int n = int(min(label(W), nHere - i));
                const T v = load<W>(volume + begin + i)*expSeries(tr, terms);
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

            law.correct(block);
            result.waveSpeed = max(result.waveSpeed, block.waveSpeed);
            if (failure)
            {
                result.nFailed += failure->correct(block);
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
                const label pEnd = min(first[k + 1], end);
                for (label p = max(first[k], begin); p < pEnd; p += W)
                {
                    T X[DIM], L[DIM], F[DIM*DIM];
                    geo.load(p, X, L);
                    gradientsType S;
                    shape_.evaluate(s, X, L, S);
                    minusVolumeStress(stress, volume, p, F);
                    for (int i = 0; i < DIM*DIM; ++i)
                    {
                        notFinite += 0.0*F[i];
                    }
                    shape_.toLocal(S, F);
                    shapeType::scatterGradient
                    (
                        S,
                        F,
                        int(min(label(W), pEnd - p)),
                        acc
                    );
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
                // Lanes of the next points are seen here and found later
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
