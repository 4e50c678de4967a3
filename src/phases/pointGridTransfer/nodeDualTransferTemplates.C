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
const dualNodes& nodeDualTransfer<Shape, DIM, HOOP>::reach
(
    const materialPointCloud& cloud
) const
{
    dualNodes& nodes =
        nodes_.try_emplace(&cloud, dual_, boundary_).first->second;
    nodes.update(cloud.cells(), shape_.cells);
    return nodes;
}


template<template<int> class Shape, int DIM, bool HOOP>
const scalar* nodeDualTransfer<Shape, DIM, HOOP>::gather
(
    const dualNodes& nodes,
    const scalar* u,
    const alignedArray& U
) const
{
    nodes.gather<P>(u, U.data());
    return U.data();
}


template<template<int> class Shape, int DIM, bool HOOP>
const scalar* nodeDualTransfer<Shape, DIM, HOOP>::gradient
(
    const dualNodes& nodes,
    const scalar* u
) const
{
    nodes.gradient<DIM>(u, L_.data());
    for (label i = 0; HOOP && i < nodes.nodes().size(); ++i)
    {
        const label m = nodes.nodes()[i];
        store<P>
        (
            L_.data() + CL*m + dualColumns<DIM>::besideGradient,
            load<P>(u + P*m)
        );
    }
    return L_.data();
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spread
(
    const dualNodes& nodes,
    scalar* q
) const
{
    nodes.spread<P>(a_.data(), P, q);
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spreadAffine
(
    const dualNodes& nodes,
    materialPointCloud& cloud,
    const passes::states state,
    scalar* q
) const
{
    const typename base::geometry geo(cloud, state == passes::tentative);
    const scalar* mass = cloud.mass()[0];
    const column& C =
        state == passes::current ? *cloud.affine() : *cloud.affineNew();

    // Column j of A_m in L_, one behind the other
    const auto A = [&](const int j) { return L_.data() + P*grid_.nNodes()*j; };
    for (int j = 0; j < DIM; ++j)
    {
        nodes.clear(A(j), P, P);
    }
    typename shapeType::accumulator acc[DIM];
    base::forGroups
    (
        cloud,
        [&](const typename shapeType::stencil&)
        {
            for (auto& a : acc)
            {
                a.clear();
            }
        },
        [&]
        (
            const typename shapeType::stencil& s,
            label,
            const label p,
            const int n
        )
        {
            T X[DIM], L[DIM];
            geo.load(p, X, L);
            typename shapeType::weights S;
            shape_.evaluate(s, X, L, S);
            const T m = load<W>(mass + p);
            for (int j = 0; j < DIM; ++j)
            {
                T a[DIM];
                for (int i = 0; i < DIM; ++i)
                {
                    a[i] = m*load<W>(C[i*DIM + j] + p);
                }
                shapeType::template scatter<DIM>(S, a, n, acc[j]);
            }
        },
        [&](const typename shapeType::stencil& s)
        {
            for (int j = 0; j < DIM; ++j)
            {
                shapeType::flush(acc[j], s.nodes, A(j));
            }
        }
    );

    const scalarList& offsets = dual_.offsets();
    for (const label m : nodes.nodes())
    {
        for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
        {
            lanes<P> v = load<P>(a_.data() + P*m);
            for (int j = 0; j < DIM; ++j)
            {
                v += offsets[DIM*e + j]*load<P>(A(j) + P*m);
            }
            scalar* to = q + P*dual_.node(e);
            store<P>(to, load<P>(to) + dual_.W(e)*v);
        }
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spreadForce
(
    const dualNodes& nodes,
    const bool beside,
    scalar* f
) const
{
    nodes.force<DIM>(F_.data(), beside && !HOOP, f);
    for (label i = 0; HOOP && i < nodes.nodes().size(); ++i)
    {
        const label m = nodes.nodes()[i];
        const scalar* F = F_.data() + CF*m + dualColumns<DIM>::symmetric;
        store<P>(f + P*m, load<P>(f + P*m) + load<P>(F));
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
nodeDualTransfer<Shape, DIM, HOOP>::nodeDualTransfer(const pointGrid& grid)
:
    base(grid),
    grid_(grid),
    dual_(shape_.dual),
    boundary_(dual_, grid.shared(shapeType::reach)),
    stamp_(grid.nNodes(), label(-1)),
    stampNow_(0),
    place_(grid.nNodes(), label(-1)),
    a_(P*grid.nNodes()),
    U_(P*grid.nNodes()),
    UL_(P*grid.nNodes()),
    dU_(P*grid.nNodes()),
    L_(CL*grid.nNodes()),
    F_(CF*grid.nNodes())
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
scalarList nodeDualTransfer<Shape, DIM, HOOP>::nodeVolumes
(
    const pointGrid&,
    const bool
) const
{
    // Of wedges the integrals are those over the section
    const cellSimplices& cells = shape_.cells;
    const scalarField& V = grid_.mesh().cellVolumes();
    scalarList volume(grid_.nNodes(), Zero);
    forAll(V, celli)
    {
        const label n = cells.nVertices(celli);
        scalar all = 0;
        for (label i = 0; i < n; ++i)
        {
            all += cells.integral(celli, i);
        }
        for (label i = 0; i < n; ++i)
        {
            const label m = cells.nodes(celli)[i];
            const scalar part = cells.integral(celli, i)*V[celli]/all;
            for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
            {
                volume[dual_.node(e)] += dual_.W(e)*part;
            }
        }
    }
    grid_.shared(shapeType::reach).sum(volume.data(), 1, 1);
    return volume;
}


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
    for (int i = 0; i < shapeType::count(s); ++i)
    {
        const label m = s.nodes[i];
        const scalar Sm = shapeType::weight(of, i)[0];
        for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
        {
            label& at = place_[dual_.node(e)];
            if (at < 0)
            {
                at = nodes.size();
                nodes.append(dual_.node(e));
                S.append(0);
                gradS.setSize(DIM*nodes.size(), 0);
            }
            S[at] += Sm*dual_.W(e);
            for (int d = 0; d < DIM; ++d)
            {
                gradS[DIM*at + d] += Sm*dual_.G(e)[d];
            }
        }
    }
    for (const label node : nodes)
    {
        place_[node] = -1;
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
    const dualNodes& nodes = reach(cloud);
    nodes.clear(a_.data(), P, P);
    base::project(cloud, state, a_.data());
    if (cloud.affine())
    {
        spreadAffine(nodes, cloud, state, mU);
    }
    else
    {
        spread(nodes, mU);
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::force
(
    materialPointCloud& cloud,
    scalar* f
) const
{
    const bool beside = HOOP || cloud.gasPressure();
    const dualNodes& nodes = reach(cloud);
    nodes.clear(F_.data(), CF, beside ? CF : CF/2);
    base::force(cloud, F_.data());
    spreadForce(nodes, beside, f);
}


template<template<int> class Shape, int DIM, bool HOOP>
scalar nodeDualTransfer<Shape, DIM, HOOP>::shortestWidth
(
    const materialPointCloud& cloud,
    const scalar shortestSide
) const
{
    // On boxes of one size each function has the width of a side, but for
    // rounding that would depend on where the points were at the start
    if (grid_.sameWidth() > 0)
    {
        return shortestSide;
    }

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
    const scalar* u,
    const labelUList& beside
) const
{
    gather(reach(cloud), u, U_);
    for (const label m : beside)
    {
        dual_.template gather<P>(m, u, U_.data() + P*m);
    }
    return U_.data();
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::spreadShares
(
    const materialPointCloud& cloud,
    scalar* q,
    const labelUList& beside
) const
{
    const dualNodes& nodes = reach(cloud);
    const auto take = [&](const label m, scalar* to)
    {
        std::copy_n(q + P*m, P, to);
        std::fill_n(q + P*m, P, 0.0);
    };
    for (const label m : nodes.nodes())
    {
        take(m, a_.data() + P*m);
    }
    alignedArray rest(P*beside.size());
    forAll(beside, i)
    {
        take(beside[i], rest.data() + P*i);
    }
    spread(nodes, q);
    forAll(beside, i)
    {
        dual_.template spread<P>(beside[i], rest.data() + P*i, q);
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
    const dualNodes& nodes = reach(cloud);
    nodes.clear(a_.data(), P, P);
    base::addBodyForce(cloud, b, a_.data());
    spread(nodes, f);
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
    const dualNodes& nodes = reach(cloud);
    return base::move
    (
        cloud,
        rule,
        {
            rule.take.needsU() ? gather(nodes, u.U, U_) : nullptr,
            rule.take.needsUL() ? gather(nodes, u.UL, UL_) : nullptr,
            rule.take.needsDU() || rule.energy
          ? gather(nodes, u.dU, dU_)
          : nullptr
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
    const dualNodes& nodes = reach(cloud);
    base::affine(cloud, moment, gradient(nodes, u), dt);
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
    const dualNodes& nodes = reach(cloud);
    nodes.clear(a_.data(), P, P);
    base::massTimes(cloud, tentative, gather(nodes, u, U_), a_.data());
    spread(nodes, mU);
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
    const dualNodes& nodes = reach(cloud);
    nodes.clear(F_.data(), CF, HOOP ? CF : CF/2);
    const passes::stressResult result
    (
        base::correctStress
        (
            cloud,
            law,
            failure,
            dt,
            square,
            gradient(nodes, u),
            f ? F_.data() : nullptr
        )
    );
    if (f)
    {
        spreadForce(nodes, HOOP, f);
    }
    return result;
}

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
