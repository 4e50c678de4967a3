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
void nodeDualTransfer<Shape, DIM, HOOP>::findFeeds()
{
    const label N = grid_.nNodes();
    mark_.setSize(N, 0);
    for (label m = 0; m < N; ++m)
    {
        for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
        {
            if (dual_.reduced(m))
            {
                mark_[dual_.node(e)] = 1;
                anyReduced_ = true;
            }
        }
    }
    reduce(anyReduced_, orOp<bool>());
    shared_.largest(mark_.data(), 1, 1);
    feeds_.setSize(N, false);
    for (label m = 0; m < N; ++m)
    {
        for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
        {
            feeds_[m] =
                feeds_[m] || (dual_.W(e) > 0 && mark_[dual_.node(e)] > 0);
        }
    }
}


template<template<int> class Shape, int DIM, bool HOOP>
void nodeDualTransfer<Shape, DIM, HOOP>::findMass() const
{
    if (!anyReduced_)
    {
        return;
    }
    for (const label m : nodes_)
    {
        for
        (
            label e = dual_.begin(m);
            feeds_[m] && e < dual_.begin(m + 1);
            ++e
        )
        {
            if (dual_.W(e) > 0)
            {
                massStamp_[dual_.node(e)] = stampNow_;
            }
        }
    }
    if (shared_.nodes().size())
    {
        for (const label l : shared_.nodes())
        {
            mark_[l] = hasMass(l);
        }
        shared_.largest(mark_.data(), 1, 1);
        for (const label l : shared_.nodes())
        {
            massStamp_[l] = mark_[l] > 0 ? stampNow_ : massStamp_[l];
        }
    }
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

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
