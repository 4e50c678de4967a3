/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    Included by nodeDualTransfer.H.

\*---------------------------------------------------------------------------*/

namespace Foam
{
namespace mpm
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::reach
(
    const materialPointCloud& cloud
) const
{
    ++stampNow_;
    nodes_.clear();
    for (const label celli : cloud.cells())
    {
        const label* nodes = shape_.cells.nodes(celli);
        for (label i = 0; i < shape_.cells.nVertices(celli); ++i)
        {
            if (stamp_[nodes[i]] != stampNow_)
            {
                stamp_[nodes[i]] = stampNow_;
                nodes_.append(nodes[i]);
            }
        }
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::stencilOf
(
    const label celli,
    DynamicList<label>& nodes
) const
{
    ++stampNow_;
    nodes.clear();
    place_.setSize(grid_.nNodes());
    for (label i = 0; i < shape_.cells.nVertices(celli); ++i)
    {
        const label m = shape_.cells.nodes(celli)[i];
        for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
        {
            const label l = dual_.node(e);
            if (stamp_[l] != stampNow_)
            {
                stamp_[l] = stampNow_;
                place_[l] = nodes.size();
                nodes.append(l);
            }
        }
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::clear
(
    const alignedArray& q,
    const int stride
) const
{
    for (const label m : nodes_)
    {
        std::fill_n(q.data() + stride*m, stride, 0.0);
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
const scalar* nodeDualTransfer<Shape, DIM, HOOP>::gather
(
    const scalar* u,
    const alignedArray& U
) const
{
    for (const label m : nodes_)
    {
        dual_.template gather<P>(m, u, U.data() + P*m);
    }
    return U.data();
}


template<template<int> class Shape, int DIM, bool HOOP>
const scalar* nodeDualTransfer<Shape, DIM, HOOP>::gradient
(
    const scalar* u
) const
{
    findMass();
    for (const label m : nodes_)
    {
        scalar* L = L_.data() + C*m;
        if (dual_.reduced(m))
        {
            gradientAtWall(m, u, L);
        }
        else
        {
            dual_.template gradient<DIM, P>(m, u, L);
        }
        if constexpr (HOOP)
        {
            store<P>(L + DIM*P, load<P>(u + P*m));
        }
    }
    return L_.data();
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spread(scalar* q) const
{
    for (const label m : nodes_)
    {
        dual_.template spread<P>(m, a_.data() + P*m, q);
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spreadAffine
(
    materialPointCloud& cloud,
    const passes::states state,
    scalar* q
) const
{
    const typename base::geometry geo(cloud, state == passes::tentative);
    const scalar* mass = cloud.mass()[0];
    const column& C =
        state == passes::current ? *cloud.affine() : *cloud.affineNew();

    clear(F_, nodeDualTransfer::C);
    typename shapeType::gradientAccumulator acc;
    base::forGroups
    (
        cloud,
        [&](const typename shapeType::stencil&) { acc.clear(); },
        [&]
        (
            const typename shapeType::stencil& s,
            label,
            const label p,
            const int n
        )
        {
            T X[DIM], L[DIM], A[DIM*DIM];
            geo.load(p, X, L);
            typename shapeType::gradients S;
            shape_.evaluate(s, X, L, S);
            const T m = load<W>(mass + p);
            for (int i = 0; i < DIM*DIM; ++i)
            {
                A[i] = m*load<W>(C[i] + p);
            }
            shapeType::scatterGradient(S, A, n, acc);
        },
        [&](const typename shapeType::stencil& s)
        {
            shapeType::flushGradient(acc, s.nodes, F_.data());
        }
    );

    const scalarList& offsets = dual_.offsets();
    for (const label m : nodes_)
    {
        const scalar* A = F_.data() + nodeDualTransfer::C*m;
        for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
        {
            lanes<P> v = load<P>(a_.data() + P*m);
            for (int j = 0; j < DIM; ++j)
            {
                v += offsets[DIM*e + j]*load<P>(A + P*j);
            }
            scalar* to = q + P*dual_.node(e);
            store<P>(to, load<P>(to) + dual_.W(e)*v);
        }
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spreadForce
(
    const bool beside,
    scalar* f
) const
{
    for (const label m : nodes_)
    {
        const scalar* F = F_.data() + C*m;
        if (dual_.reduced(m))
        {
            forceAtWall(m, F, f);
        }
        else
        {
            dual_.template force<DIM, P>(m, F, f);
        }
        if (HOOP)
        {
            store<P>(f + P*m, load<P>(f + P*m) + load<P>(F + DIM*P));
        }
        else if (beside)
        {
            dual_.template spread<P>(m, F + DIM*P, f);
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
nodeDualTransfer<Shape, DIM, HOOP>::nodeDualTransfer(const pointGrid& grid)
:
    base(grid),
    grid_(grid),
    dual_(shape_.dual),
    shared_(grid.shared(shapeType::reach)),
    anyReduced_(false),
    stamp_(grid.nNodes(), label(-1)),
    stampNow_(0),
    massStamp_(grid.nNodes(), label(-1)),
    a_(P*grid.nNodes()),
    U_(P*grid.nNodes()),
    UL_(P*grid.nNodes()),
    dU_(P*grid.nNodes()),
    L_(C*grid.nNodes()),
    F_(C*grid.nNodes()),
    nStencil_(-1)
{
    findFeeds();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::weights
(
    const label celli,
    const scalar* x,
    const scalar*,
    DynamicList<label>& nodes,
    DynamicList<scalar>& S,
    DynamicList<scalar>& gradS
) const
{
    typename shapeType::stencil s;
    shape_.prepare(celli, s);
    T X[DIM];
    for (int d = 0; d < DIM; ++d)
    {
        X[d] = broadcast<W>(x[d]);
    }
    typename shapeType::weights of;
    shape_.evaluate(s, X, X, of);

    nodes.clear();
    S.clear();
    gradS.clear();
    for (int i = 0; i < s.n; ++i)
    {
        const label m = s.nodes[i];
        for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
        {
            label at = nodes.find(dual_.node(e));
            if (at < 0)
            {
                at = nodes.size();
                nodes.append(dual_.node(e));
                S.append(0);
                gradS.setSize(DIM*nodes.size(), 0);
            }
            S[at] += of.S[i][0]*dual_.W(e);
            for (int d = 0; d < DIM; ++d)
            {
                gradS[DIM*at + d] += of.S[i][0]*dual_.G(e)[d];
            }
        }
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::forStencils
(
    const materialPointCloud& cloud,
    const std::function<void(const label, const labelUList&)>& f
) const
{
    DynamicList<label> nodes;
    forAll(cloud.cells(), k)
    {
        stencilOf(cloud.cells()[k], nodes);
        f(k, nodes);
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::project
(
    materialPointCloud& cloud,
    const passes::states state,
    scalar* mU
) const
{
    reach(cloud);
    clear(a_, P);
    base::project(cloud, state, a_.data());
    if (cloud.affine())
    {
        spreadAffine(cloud, state, mU);
    }
    else
    {
        spread(mU);
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::force
(
    materialPointCloud& cloud,
    scalar* f
) const
{
    reach(cloud);
    clear(F_, C);
    base::force(cloud, F_.data());
    findMass();
    spreadForce(HOOP || cloud.gasPressure(), f);
}


template<template<int> class Shape, int DIM, bool HOOP>
scalar nodeDualTransfer<Shape, DIM, HOOP>::shortestWidth
(
    const materialPointCloud& cloud,
    const scalar shortestSide
) const
{
    // Without points that of the cells
    scalar most = cloud.cells().size() ? 0 : 1/shortestSide;
    for (const label celli : cloud.cells())
    {
        for (int d = 0; d < DIM; ++d)
        {
            most = max(most, shape_.inverseWidths[DIM*celli + d]);
        }
    }
    return 1/most;
}


template<template<int> class Shape, int DIM, bool HOOP>
label nodeDualTransfer<Shape, DIM, HOOP>::nStencil() const
{
    if (nStencil_ < 0)
    {
        DynamicList<label> nodes;
        for (label celli = 0; celli < grid_.nCells(); ++celli)
        {
            stencilOf(celli, nodes);
            nStencil_ = max(nStencil_, nodes.size());
        }
    }
    return nStencil_;
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::massShares
(
    materialPointCloud& cloud,
    scalar* share
) const
{
    // Of the vertices of the cells, then of the nodes that they reach
    constexpr int most = shapeType::maxNodes;
    const label n = nStencil();
    static thread_local std::vector<scalar> ofVertices;
    ofVertices.resize(most*cloud.cells().size());
    base::massShares(cloud, ofVertices.data());

    DynamicList<label> nodes;
    forAll(cloud.cells(), k)
    {
        const label celli = cloud.cells()[k];
        stencilOf(celli, nodes);
        scalar* to = share + n*k;
        std::fill_n(to, n, 0.0);
        for (label i = 0; i < shape_.cells.nVertices(celli); ++i)
        {
            const scalar mass = ofVertices[most*k + i];
            const label m = shape_.cells.nodes(celli)[i];
            for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
            {
                to[place_[dual_.node(e)]] += mass*dual_.W(e);
            }
        }
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::addBodyForce
(
    materialPointCloud& cloud,
    const column& b,
    scalar* f
) const
{
    reach(cloud);
    clear(a_, P);
    base::addBodyForce(cloud, b, a_.data());
    spread(f);
}


template<template<int> class Shape, int DIM, bool HOOP>
pointGridTransfer::moveResult nodeDualTransfer<Shape, DIM, HOOP>::move
(
    materialPointCloud& cloud,
    const passes::moveRule& rule,
    const passes::nodeVelocities& u,
    DynamicList<materialPointCloud::cellChange>& cellChanges
) const
{
    reach(cloud);
    return base::move
    (
        cloud,
        rule,
        {
            rule.take.needsU() ? gather(u.U, U_) : nullptr,
            rule.take.needsUL() ? gather(u.UL, UL_) : nullptr,
            rule.take.needsDU() || rule.energy ? gather(u.dU, dU_) : nullptr
        },
        cellChanges
    );
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::affine
(
    materialPointCloud& cloud,
    const bool moment,
    const scalar* u,
    const scalar dt
) const
{
    reach(cloud);
    base::affine(cloud, moment, gradient(u), dt);
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::massTimes
(
    materialPointCloud& cloud,
    const bool tentative,
    const scalar* u,
    scalar* mU
) const
{
    reach(cloud);
    clear(a_, P);
    base::massTimes(cloud, tentative, gather(u, U_), a_.data());
    spread(mU);
}


template<template<int> class Shape, int DIM, bool HOOP>
pointGridTransfer::stressResult
nodeDualTransfer<Shape, DIM, HOOP>::correctStress
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
    reach(cloud);
    clear(F_, C);
    const passes::stressResult result
    (
        base::correctStress
        (
            cloud,
            law,
            failure,
            dt,
            square,
            gradient(u),
            f ? F_.data() : nullptr
        )
    );
    if (f)
    {
        spreadForce(HOOP, f);
    }
    return result;
}

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
