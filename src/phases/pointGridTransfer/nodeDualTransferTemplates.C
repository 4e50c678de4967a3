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

    // Other processors send sums for shared ones
    for (const label n : shared_.nodes())
    {
        stamp_[n] = stampNow_;
        nodes_.append(n);
    }
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
    shared_.sum(U.data(), P, DIM);
    return U.data();
}


template<template<int> class Shape, int DIM, bool HOOP>
bool nodeDualTransfer<Shape, DIM, HOOP>::hasMass(const label l) const
{
    for (label e = dual_.begin(l); e < dual_.begin(l + 1); ++e)
    {
        const label m = dual_.node(e);
        if (stamp_[m] != stampNow_)
        {
            continue;
        }
        if (m == l || !dual_.reduced(m))
        {
            return true;
        }
        for (label i = dual_.begin(m); i < dual_.begin(m + 1); ++i)
        {
            if (dual_.node(i) == l && dual_.W(i) > 0)
            {
                return true;
            }
        }
    }
    return false;
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::gradientAtWall
(
    const label m,
    const scalar* u,
    scalar* L
) const
{
    alignas(64) scalar U[P];
    dual_.template gather<P>(m, u, U);
    std::fill_n(L, DIM*P, 0.0);
    for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
    {
        const label l = dual_.node(e);
        const lanes<P> ul = load<P>(hasMass(l) ? u + P*l : U);
        for (int j = 0; j < DIM; ++j)
        {
            store<P>(L + P*j, load<P>(L + P*j) + dual_.G(e)[j]*ul);
        }
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::forceAtWall
(
    const label m,
    const scalar* F,
    scalar* f
) const
{
    lanes<P> rest = {};
    for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
    {
        lanes<P> part = {};
        for (int j = 0; j < DIM; ++j)
        {
            part += dual_.G(e)[j]*load<P>(F + P*j);
        }
        const label l = dual_.node(e);
        if (hasMass(l))
        {
            store<P>(f + P*l, load<P>(f + P*l) + part);
        }
        else
        {
            rest += part;
        }
    }
    alignas(64) scalar ofRest[P];
    store<P>(ofRest, rest);
    dual_.template spread<P>(m, ofRest, f);
}


template<template<int> class Shape, int DIM, bool HOOP>
const scalar* nodeDualTransfer<Shape, DIM, HOOP>::gradient
(
    const scalar* u
) const
{
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
            dual_.template gather<P>(m, u, L + DIM*P);
        }
    }
    shared_.sum(L_.data(), C, C);
    return L_.data();
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spread(scalar* q) const
{
    shared_.sum(a_.data(), P, P);
    for (const label m : nodes_)
    {
        dual_.template spread<P>(m, a_.data() + P*m, q);
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spreadForce
(
    const bool beside,
    scalar* f
) const
{
    shared_.sum(F_.data(), C, C);
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
        if (beside)
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
    shared_(grid.shared(0)),
    stamp_(grid.nNodes(), label(-1)),
    stampNow_(0),
    a_(P*grid.nNodes()),
    U_(P*grid.nNodes()),
    UL_(P*grid.nNodes()),
    dU_(P*grid.nNodes()),
    L_(C*grid.nNodes()),
    F_(C*grid.nNodes())
{}

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
        const label celli = cloud.cells()[k];
        ++stampNow_;
        nodes.clear();
        for (label i = 0; i < shape_.cells.nVertices(celli); ++i)
        {
            const label m = shape_.cells.nodes(celli)[i];
            for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
            {
                if (stamp_[dual_.node(e)] != stampNow_)
                {
                    stamp_[dual_.node(e)] = stampNow_;
                    nodes.append(dual_.node(e));
                }
            }
        }
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
    if (cloud.affine())
    {
        FatalErrorInFunction
            << "The shape function nodeDual does not work with affine"
            << " velocities of points yet: choose FLIP or FMPM."
            << exit(FatalError);
    }
    reach(cloud);
    clear(a_, P);
    base::project(cloud, state, a_.data());
    spread(mU);
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
const scalar* nodeDualTransfer<Shape, DIM, HOOP>::atShares
(
    const materialPointCloud& cloud,
    const scalar* u
) const
{
    reach(cloud);
    return gather(u, U_);
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spreadShares
(
    const materialPointCloud& cloud,
    scalar* q
) const
{
    reach(cloud);
    for (const label m : nodes_)
    {
        std::copy_n(q + P*m, P, a_.data() + P*m);
        std::fill_n(q + P*m, P, 0.0);
    }
    spread(q);
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
