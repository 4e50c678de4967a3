/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Included by shapeTransfer.H.

\*---------------------------------------------------------------------------*/

namespace Foam::mpm
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::weights(
    const label celli, const scalar* x, const scalar* halfSize, DynamicList<label>& nodes,
    DynamicList<scalar>& S, DynamicList<scalar>& gradS) const
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

    // By the same sums as the passes, with unit values at one point
    accumulator value;
    T one[1] = {broadcast<W>(1)};
    shapeType::template scatter<1>(g, one, 1, value);
    gradientAccumulator grad[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        T F[DIM * DIM];
        for (int i = 0; i < DIM * DIM; ++i)
        {
            F[i] = broadcast<W>(i == d ? 1 : 0);
        }
        shape_.toLocal(g, F);
        shapeType::scatterGradient(g, F, 1, grad[d]);
    }
    for (int n = 0; n < shapeType::count(s); ++n)
    {
        nodes.append(s.nodes[n]);
        S.append(shapeType::nodeSum(value, n, 0));
        for (int d = 0; d < DIM; ++d)
        {
            gradS.append(shapeType::nodeSum(grad[d], n, 0));
        }
    }
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::project(
    materialPointCloud& cloud, const states state, scalar* mU, scalar* share) const
{
    if (cloud.affine())
    {
        projectAffine(cloud, state, mU, share);
        return;
    }

    const scalar* mass = cloud.mass()[0];
    const column& v = state == current ? cloud.U() : cloud.UNew();
    const vectors U(v);
    scatterPoints<DIM + 1>(
        cloud, state == tentative, {&cloud.mass(), &v}, mU,
        [&](const stencil&, const weightsType&, const label p, T(&q)[DIM + 1])
        {
            q[DIM] = load<W>(mass + p);
            for (int d = 0; d < DIM; ++d)
            {
                q[d] = q[DIM] * load<W>(U.q[d] + p);
            }
        },
        share);
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::projectAffine(
    materialPointCloud& cloud, const states state, scalar* mU, scalar* share) const
{
    geometry geo(cloud, state == tentative);
    const scalar* mass = cloud.mass()[0];
    const column& C = state == current ? *cloud.affine() : *cloud.affineNew();
    const column& v = state == current ? cloud.U() : cloud.UNew();
    const vectors U(v);
    geo.fetch(&cloud.mass());
    geo.fetch(&v);
    geo.fetch(&C);

    accumulator acc;
    forGroups(
        cloud, [&](const stencil&) { acc.clear(); },
        [&](const stencil& s, const label celli, const label p, const int n)
        {
            T X[DIM], L[DIM], q[DIM + 1], A[DIM * DIM];
            geo.load(p, n, X, L);
            q[DIM] = load<W>(mass + p);
            for (int d = 0; d < DIM; ++d)
            {
                q[d] = q[DIM] * load<W>(U.q[d] + p);
            }
            for (int i = 0; i < DIM * DIM; ++i)
            {
                A[i] = q[DIM] * load<W>(C[i] + p);
            }
            shape_.scatterAffine(celli, s, X, L, q, A, n, acc);
        },
        [&](const stencil& s)
        {
            keepShares(acc, s, DIM, share);
            shapeType::flush(acc, s.nodes, mU);
        });
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::affine(
    materialPointCloud& cloud, const bool moment, const scalar* u, const scalar dt) const
{
    const geometry geo(cloud, false);
    column& C = *cloud.affineNew();

    forGroups(
        cloud, [&](const stencil&) {},
        [&](const stencil& s, const label celli, const label p, const int n)
        {
            T X[DIM], L[DIM], G[DIM * DIM], D[DIM];
            geo.load(p, n, X, L);
            gradientsType S;
            if (moment && shapeType::hasMoments)
            {
                shape_.moments(celli, s, X, L, S, D);
                shapeType::template gatherGradient<P>(S, s.nodes, u, G);
                for (int i = 0; i < DIM * DIM; ++i)
                {
                    G[i] /= D[i % DIM];
                }
            }
            else
            {
                shape_.evaluate(s, X, L, S);
                shapeType::template gatherGradient<P>(S, s.nodes, u, G);
                shape_.toPhysical(S, G);
            }
            for (int i = 0; i < DIM; ++i)
            {
                for (int j = 0; j < DIM; ++j)
                {
                    // - dt (C C + (C C)^T)/2
                    T symm = {};
                    for (int k = 0; moment && k < DIM; ++k)
                    {
                        symm += G[i * DIM + k] * G[k * DIM + j];
                        symm += G[j * DIM + k] * G[k * DIM + i];
                    }
                    store<W>(C[i * DIM + j] + p, G[i * DIM + j] - 0.5 * dt * symm);
                }
            }
        },
        [&](const stencil&) {});
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::forStencils(
    const materialPointCloud& cloud,
    const std::function<void(const label, const labelUList&)>& f) const
{
    forAll(cloud.cells(), k)
    {
        stencil s;
        shape_.prepare(cloud.cells()[k], s);
        f(k, labelUList(const_cast<label*>(s.nodes), shapeType::count(s)));
    }
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::addBodyForce(
    materialPointCloud& cloud, const column& b, scalar* f) const
{
    const scalar* mass = cloud.mass()[0];
    const vectors B(b);
    scatterPoints<DIM>(
        cloud, false, {&cloud.mass(), &b}, f,
        [&](const stencil&, const weightsType&, const label p, T(&q)[DIM])
        {
            const T m = load<W>(mass + p);
            for (int d = 0; d < DIM; ++d)
            {
                q[d] = m * load<W>(B.q[d] + p);
            }
        });
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::massTimes(
    materialPointCloud& cloud, const bool tentative, const scalar* u, scalar* mU) const
{
    const scalar* mass = cloud.mass()[0];
    scatterPoints<DIM>(
        cloud, tentative, {&cloud.mass()}, mU,
        [&](const stencil& s, const weightsType& S, const label p, T(&q)[DIM])
        {
            shapeType::template gather<DIM, P>(S, s.nodes, u, q);
            const T m = load<W>(mass + p);
            for (int d = 0; d < DIM; ++d)
            {
                q[d] *= m;
            }
        });
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::sumAtNodes(
    materialPointCloud& cloud, const scalar* w, const scalar* q, scalar* sums) const
{
    scatterPoints<2>(
        cloud, false, {}, sums,
        [&](const stencil&, const weightsType&, const label p, T(&of)[2])
        {
            of[1] = load<W>(w + p);
            of[0] = of[1] * load<W>(q + p);
        });
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::lessAtPoints(
    materialPointCloud& cloud, const scalar* u, scalar* q) const
{
    geometry geo(cloud, false);
    forGroups(
        cloud, [&](const stencil&) {},
        [&](const stencil& s, label, const label p, const int n)
        {
            T X[DIM], L[DIM], of[1];
            geo.load(p, n, X, L);
            weightsType S;
            shape_.evaluate(s, X, L, S);
            shapeType::template gather<1, P>(S, s.nodes, u, of);
            storePart<W>(q + p, load<W>(q + p) - of[0], n);
        },
        [&](const stencil&) {});
}

} // End namespace Foam::mpm
