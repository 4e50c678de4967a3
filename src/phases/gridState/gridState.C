/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gridState.H"
#include "valuePointPatchField.H"
#include "basicSymmetryPointPatchField.H"
#include "fixedNormalSlipPointPatchField.H"
#include "calculatedPointPatchField.H"
#include "zeroGradientPointPatchField.H"
#include "coupledPointPatchField.H"
#include "emptyPointPatchField.H"
#include "pointMesh.H"
#include "Time.H"
#include "Tuple2.H"
#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- True where the normal velocity is zero and the tangential free
bool isSlip(const pointPatchField<vector>& pf)
{
    return
        isA<basicSymmetryPointPatchField<vector>>(pf)
     && !isA<fixedNormalSlipPointPatchField<vector>>(pf);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gridState::readBoundary()
{
    forAll(Ufield_.boundaryField(), patchi)
    {
        const pointPatchField<vector>& pf = Ufield_.boundaryField()[patchi];

        if
        (
            isA<emptyPointPatchField<vector>>(pf)
         || isA<coupledPointPatchField<vector>>(pf)
         || isA<calculatedPointPatchField<vector>>(pf)
         || isA<zeroGradientPointPatchField<vector>>(pf)
         || isA<valuePointPatchField<vector>>(pf)
         || isSlip(pf)
        )
        {
            continue;
        }
        FatalErrorInFunction
            << "Patch " << pf.patch().name() << " of " << Ufield_.name()
            << " (" << Ufield_.objectPath() << ") has the type "
            << pf.type() << ", which material points do not know." << nl
            << "Valid types: fixedValue, timeVaryingUniformFixedValue and"
            << " others with a value (fixed velocity); slip, symmetry,"
            << " symmetryPlane (no normal velocity); calculated, zeroGradient"
            << " (free); cyclic; empty." << exit(FatalError);
    }

    readFixed();
    shareFixed();
    fixedValue_.setSize(nDim_*fixedNode_.size());

    labelHashSet fixed;
    fixed.insert(fixedNode_);
    readSlip(fixed);
}


void Foam::mpm::gridState::readFixed()
{
    // The first patch of the mesh's list wins
    labelHashSet known;
    forAll(Ufield_.boundaryField(), patchi)
    {
        const pointPatchField<vector>& pf = Ufield_.boundaryField()[patchi];
        if (!isA<valuePointPatchField<vector>>(pf))
        {
            continue;
        }
        const labelList& points = pf.patch().meshPoints();
        forAll(points, i)
        {
            const label n = grid_.pointToNode()[points[i]];
            if (known.insert(n))
            {
                fixedNode_.append(n);
                fixedPatch_.append(patchi);
                fixedIndex_.append(i);
                parts_.append({n, patchi, true, {}, point(Zero)});
            }
        }
    }
}


void Foam::mpm::gridState::shareFixed()
{
    fixedElsewhere_ = false;
    if (!Pstream::parRun())
    {
        return;
    }

    // Of each shared fixed node the key and the patch on every processor
    labelHashSet isShared;
    isShared.insert(shared_.nodes());
    Map<label> nodeOfKey;
    for (const label n : shared_.nodes())
    {
        nodeOfKey.insert(grid_.nodeKey()[n], n);
    }
    Map<label> mineAt;
    List<List<labelPair>> known(Pstream::nProcs());
    {
        DynamicList<labelPair> mine;
        forAll(fixedNode_, i)
        {
            if (isShared.found(fixedNode_[i]))
            {
                mine.append
                (
                    labelPair(grid_.nodeKey()[fixedNode_[i]], fixedPatch_[i])
                );
                mineAt.insert(fixedNode_[i], i);
            }
        }
        known[Pstream::myProcNo()].transfer(mine);
    }
    Pstream::gatherList(known);
    Pstream::scatterList(known);

    // The first patch wins, of the lowest processor that knows it
    Map<labelPair> best;
    forAll(known, proci)
    {
        for (const labelPair& entry : known[proci])
        {
            const auto iter = nodeOfKey.cfind(entry.first());
            if (!iter.found())
            {
                continue;
            }
            labelPair& b =
                best(iter.val(), labelPair(labelMax, labelMax));
            const labelPair candidate(entry.second(), proci);
            b = candidate < b ? candidate : b;
        }
    }
    forAllConstIters(best, iter)
    {
        fixedElsewhere_ = true;
        if (iter.val().second() == Pstream::myProcNo())
        {
            continue;
        }
        const auto at = mineAt.cfind(iter.key());
        if (at.found())
        {
            fixedPatch_[at.val()] = -1;
            parts_[at.val()].patch = iter.val().first();
        }
        else
        {
            fixedNode_.append(iter.key());
            fixedPatch_.append(-1);
            fixedIndex_.append(-1);
            parts_.append
            (
                {iter.key(), iter.val().first(), true, {}, point(Zero)}
            );
        }
    }
    reduce(fixedElsewhere_, orOp<bool>());
    if (fixedElsewhere_)
    {
        fixedWork_.setSize(nDim_*grid_.nNodes());
    }
}


void Foam::mpm::gridState::readSlip(const labelHashSet& fixed)
{
    // Key (in serial the node), patch and unit normal of each face around a
    // slip node
    typedef Tuple2<labelPair, vector> faceNormal;
    const bool parallel = Pstream::parRun();
    List<List<faceNormal>> normals(Pstream::nProcs());
    labelHashSet isShared;
    isShared.insert(shared_.nodes());
    {
        DynamicList<faceNormal> mine, others;
        forAll(Ufield_.boundaryField(), patchi)
        {
            const pointPatchField<vector>& pf = Ufield_.boundaryField()[patchi];
            if (!isSlip(pf))
            {
                continue;
            }
            const polyPatch& pp =
                grid_.mesh().boundaryMesh()[pf.patch().index()];
            forAll(pp.meshPoints(), i)
            {
                const label n = grid_.pointToNode()[pp.meshPoints()[i]];
                const label key = parallel ? grid_.nodeKey()[n] : n;
                DynamicList<faceNormal>& to =
                    isShared.found(n) ? mine : others;
                for (const label facei : pp.pointFaces()[i])
                {
                    to.append
                    (
                        faceNormal
                        (
                            labelPair(key, patchi),
                            pp.faceNormals()[facei]
                        )
                    );
                }
            }
        }
        normals[Pstream::myProcNo()].transfer(mine);
        if (parallel)
        {
            Pstream::gatherList(normals);
            Pstream::scatterList(normals);
        }
        normals[Pstream::myProcNo()].append(others);
    }

    Map<label> nodeOfKey;
    if (parallel)
    {
        forAll(grid_.nodeKey(), n)
        {
            nodeOfKey.insert(grid_.nodeKey()[n], n);
        }
    }

    // Faces of a node and patch in an order that all processors share
    std::map<labelPair, std::vector<vector>> ofNode;
    for (const List<faceNormal>& list : normals)
    {
        for (const faceNormal& f : list)
        {
            label n = f.first().first();
            if (parallel)
            {
                const auto iter = nodeOfKey.cfind(n);
                n = iter.found() ? iter.val() : -1;
            }
            if (n >= 0 && !fixed.found(n))
            {
                ofNode[labelPair(n, f.first().second())].push_back(f.second());
            }
        }
    }

    std::map<label, Eigen::Matrix3d> slip;
    for (auto& entry : ofNode)
    {
        // pointNormals() would average over the edges of a patch that has
        // some. Faces at less than 45 degrees are one smooth surface; others
        // are surfaces of their own (edges, corners)
        std::vector<vector>& faces = entry.second;
        std::sort
        (
            faces.begin(),
            faces.end(),
            [](const vector& a, const vector& b)
            {
                return
                    a.x() != b.x() ? a.x() < b.x()
                  : a.y() != b.y() ? a.y() < b.y()
                  : a.z() < b.z();
            }
        );
        std::vector<vector> groups;
        for (const vector& nf : faces)
        {
            bool known = false;
            for (vector& g : groups)
            {
                if (!known && (g & nf) > 0.7*mag(g))
                {
                    g += nf;
                    known = true;
                }
            }
            if (!known)
            {
                groups.push_back(nf);
            }
        }
        Eigen::Matrix3d& N =
            slip.emplace
            (
                entry.first.first(),
                Eigen::Matrix3d(Eigen::Matrix3d::Zero())
            ).first->second;
        for (const vector& g : groups)
        {
            Eigen::Vector3d v(Eigen::Vector3d::Zero());
            for (int d = 0; d < nDim_; ++d)
            {
                v(d) = g[grid_.direction(d)];
            }
            if (v.norm() > 0)
            {
                v.normalize();
            }
            const Eigen::Vector3d rest(v - N*v);
            if (rest.norm() > 1e-3)
            {
                N += rest*rest.transpose()/rest.squaredNorm();

                nodeReactions::part part
                {
                    entry.first.first(),
                    entry.first.second(),
                    false,
                    {},
                    point(Zero)
                };
                for (int d = 0; d < nDim_; ++d)
                {
                    part.normal[d] = rest(d)/rest.norm();
                }
                parts_.append(part);
            }
        }
    }

    DynamicList<label> nodes;
    DynamicList<scalar> projections;
    for (const auto& s : slip)
    {
        nodes.append(s.first);
        for (int i = 0; i < nDim_; ++i)
        {
            for (int j = 0; j < nDim_; ++j)
            {
                projections.append((i == j ? 1 : 0) - s.second(i, j));
            }
        }
    }
    slipNode_.transfer(nodes);
    slipProjection_.transfer(projections);
}


void Foam::mpm::gridState::updateFixed(const scalar dt)
{
    // The velocity that the step ends with: time is set on for the evaluation
    Time& time = const_cast<Time&>(grid_.mesh().time());
    const scalar now = time.value();
    time.setTime(now + dt, time.timeIndex());

    forAll(Ufield_.boundaryField(), patchi)
    {
        pointPatchField<vector>& pf = Ufield_.boundaryFieldRef()[patchi];
        if (isA<valuePointPatchField<vector>>(pf))
        {
            pf.updateCoeffs();
            pf.evaluate();
        }
    }

    time.setTime(now, time.timeIndex());

    forAll(fixedNode_, i)
    {
        if (fixedPatch_[i] < 0)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                fixedValue_[nDim_*i + d] = 0;
            }
            continue;
        }
        const valuePointPatchField<vector>& pf =
            refCast<const valuePointPatchField<vector>>
            (
                Ufield_.boundaryField()[fixedPatch_[i]]
            );
        for (int d = 0; d < nDim_; ++d)
        {
            fixedValue_[nDim_*i + d] =
                pf[fixedIndex_[i]][grid_.direction(d)];
        }
    }

    if (fixedElsewhere_)
    {
        // One processor has the value, the others add zero
        for (const label n : shared_.nodes())
        {
            for (int d = 0; d < nDim_; ++d)
            {
                fixedWork_[nDim_*n + d] = 0;
            }
        }
        forAll(fixedNode_, i)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                fixedWork_[nDim_*fixedNode_[i] + d] = fixedValue_[nDim_*i + d];
            }
        }
        shared_.sum(fixedWork_.data(), nDim_, nDim_);
        forAll(fixedNode_, i)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                fixedValue_[nDim_*i + d] = fixedWork_[nDim_*fixedNode_[i] + d];
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gridState::gridState
(
    const hexGrid& grid,
    const word& name,
    const label reach
)
:
    grid_(grid),
    name_(name),
    nDim_(grid.nDim()),
    stride_(grid.nDim() == 1 ? 2 : 4),
    Ufield_
    (
        IOobject
        (
            IOobject::groupName("U", name),
            grid.mesh().time().timeName(),
            grid.mesh(),
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        pointMesh::New(grid.mesh())
    ),
    mU_(stride_*grid.nNodes()),
    mUNew_(stride_*grid.nNodes()),
    f_(stride_*grid.nNodes()),
    U_(stride_*grid.nNodes()),
    UL_(2*stride_*grid.nNodes()),
    strainIsU_(true),
    stamp_(grid.nNodes(), label(-1)),
    stampNow_(0),
    shared_(grid.shared(reach)),
    fixedElsewhere_(false),
    rigid_(grid),
    UNew_(stride_*grid.nNodes())
{
    if (Ufield_.dimensions() != dimVelocity)
    {
        FatalErrorInFunction
            << "Field " << Ufield_.objectPath() << " has the dimensions "
            << Ufield_.dimensions() << "; they must be " << dimVelocity
            << " (m/s)." << exit(FatalError);
    }
    readBoundary();
    updateFixed(0);

    if (Pstream::parRun())
    {
        share_.setSize(grid.nNodes(), 1);
        shared_.sum(share_.begin(), 1, 1);
        for (scalar& part : share_)
        {
            part = 1/part;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::gridState::activate
(
    const UList<const labelList*>& cells,
    const int reach
)
{
    ++stampNow_;
    DynamicList<label> nodes(active_.size() + active_.size()/8 + 16);

    // Always: other processors send their sums
    for (const label n : shared_.nodes())
    {
        stamp_[n] = stampNow_;
        nodes.append(n);
    }

    const label nc = label(1) << nDim_;
    const auto take = [&](const label celli)
    {
        const label* c = grid_.corners(celli);
        for (label n = 0; n < nc; ++n)
        {
            if (stamp_[c[n]] != stampNow_)
            {
                stamp_[c[n]] = stampNow_;
                nodes.append(c[n]);
            }
        }
    };

    for (const labelList* list : cells)
    {
        for (const label celli : *list)
        {
            if (!reach)
            {
                take(celli);
                continue;
            }
            // All nodes of the wider stencil
            label ijk[3] = {0, 0, 0}, at[3] = {0, 0, 0};
            for (int d = 0; d < nDim_; ++d)
            {
                ijk[d] = grid_.ijk(celli, d) - 1;
            }
            for (label k = 0; k < (nDim_ > 2 ? 4 : 1); ++k)
            {
                at[2] = ijk[2] + k;
                for (label j = 0; j < (nDim_ > 1 ? 4 : 1); ++j)
                {
                    at[1] = ijk[1] + j;
                    for (label i = 0; i < 4; ++i)
                    {
                        at[0] = ijk[0] + i;
                        const label n = grid_.nodeAt(at);
                        if (n >= 0 && stamp_[n] != stampNow_)
                        {
                            stamp_[n] = stampNow_;
                            nodes.append(n);
                        }
                    }
                }
            }
        }
    }
    activeNew_.transfer(nodes);
}


void Foam::mpm::gridState::keepActive()
{
    activeNew_ = active_;
}


void Foam::mpm::gridState::clearMomentum()
{
    for (const label n : activeNew_)
    {
        for (int c = 0; c < stride_; ++c)
        {
            mUNew_.data()[stride_*n + c] = 0;
        }
    }
}


void Foam::mpm::gridState::clearForce()
{
    for (const label n : active_)
    {
        for (int c = 0; c < stride_; ++c)
        {
            f_.data()[stride_*n + c] = 0;
        }
    }
}


void Foam::mpm::gridState::constrain
(
    scalar* u,
    const int stride,
    const bool homogeneous,
    const bool tentative
) const
{
    forAll(fixedNode_, i)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            u[stride*fixedNode_[i] + d] =
                homogeneous ? 0 : fixedValue_[nDim_*i + d];
        }
    }
    forAll(slipNode_, i)
    {
        scalar* un = u + stride*slipNode_[i];
        const scalar* R = slipProjection_.cdata() + nDim_*nDim_*i;
        scalar v[3];
        for (int a = 0; a < nDim_; ++a)
        {
            v[a] = 0;
            for (int b = 0; b < nDim_; ++b)
            {
                v[a] += R[nDim_*a + b]*un[b];
            }
        }
        for (int a = 0; a < nDim_; ++a)
        {
            un[a] = v[a];
        }
    }
    rigid_.impose(u, stride, homogeneous, tentative);
}


void Foam::mpm::gridState::velocity()
{
    const scalar* __restrict__ mU = mUNew_.data();
    scalar* __restrict__ U = UNew_.data();

    for (const label n : activeNew_)
    {
        const scalar m = mU[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            U[stride_*n + d] = rm*mU[stride_*n + d];
        }
    }
    constrain(U, stride_, false, true);
}


void Foam::mpm::gridState::momentumStep(const scalar dt, const vector& g)
{
    const scalar* __restrict__ mU = mU_.data();
    const scalar* __restrict__ U = U_.data();
    const scalar* __restrict__ f = f_.data();
    scalar* __restrict__ UL = UL_.data();

    scalar gd[3] = {0, 0, 0};
    for (int d = 0; d < nDim_; ++d)
    {
        gd[d] = g[grid_.direction(d)];
    }

    for (const label n : active_)
    {
        const scalar m = mU[stride_*n + nDim_];
        const scalar dtm = m > 0 ? dt/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            UL[2*stride_*n + d] =
                m > 0 ? U[stride_*n + d] + dtm*f[stride_*n + d] + dt*gd[d] : 0;
        }
    }
    if (reactions_)
    {
        reactions_->start(dt, active_, shared_);
        reactions_->add(active_, -1, UL, 2*stride_, mU, stride_);
    }
    rigid_.addImpulse(UL, 2*stride_, false, mU, stride_);
    constrain(UL, 2*stride_, false, false);
    if (reactions_)
    {
        reactions_->add(active_, 1, UL, 2*stride_, mU, stride_);
    }

    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            UL[2*stride_*n + stride_ + d] =
                UL[2*stride_*n + d] - U[stride_*n + d];
        }
    }
}


Foam::labelList Foam::mpm::gridState::constrained() const
{
    labelHashSet nodes(fixedNode_);
    nodes.insert(slipNode_);
    nodes.insert(rigid_.nodes());
    return nodes.sortedToc();
}


Foam::scalar Foam::mpm::gridState::boundaryWork
(
    const scalar dt,
    const vector& g
) const
{
    scalar w = 0;
    const auto add = [&](const label n)
    {
        const scalar m = mU_.data()[stride_*n + nDim_];
        const scalar part = share_.size() ? share_[n] : 1;
        for (int d = 0; m > 0 && d < nDim_; ++d)
        {
            const scalar du = UL_.data()[2*stride_*n + stride_ + d];
            const scalar J =
                m*(du - dt*g[grid_.direction(d)])
              - dt*f_.data()[stride_*n + d];
            w += part*J*(U_.data()[stride_*n + d] + 0.5*du);
        }
    };
    for (const label n : constrained())
    {
        add(n);
    }

    return w;
}


void Foam::mpm::gridState::strainFromU(const bool copy)
{
    strainIsU_ = !copy;
    if (copy)
    {
        scalar* to = strainMomentum();
        for (const label n : active_)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                to[stride_*n + d] = U_.data()[stride_*n + d];
            }
        }
    }
}


void Foam::mpm::gridState::strainFromUL(const scalar weight)
{
    scalar* to = strainMomentum();
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            const scalar u =
                U_.data()[stride_*n + d]
              + UL_.data()[2*stride_*n + stride_ + d];
            to[stride_*n + d] = u + weight*(UL_.data()[2*stride_*n + d] - u);
        }
    }
}


Foam::scalar* Foam::mpm::gridState::strainMomentum()
{
    strainIsU_ = false;
    if (!Ustrain_.data())
    {
        Ustrain_ = alignedArray(stride_*grid_.nNodes());
    }
    for (const label n : active_)
    {
        for (int c = 0; c < stride_; ++c)
        {
            Ustrain_.data()[stride_*n + c] = 0;
        }
    }
    return Ustrain_.data();
}


void Foam::mpm::gridState::strainFromMomentum()
{
    scalar* u = Ustrain_.data();
    shared_.sum(u, stride_, nDim_ + 1);
    for (const label n : active_)
    {
        const scalar m = u[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            u[stride_*n + d] *= rm;
        }
    }
    constrain(u, stride_, false, false);
}


Foam::scalar Foam::mpm::gridState::addImpulse
(
    const scalar* impulse,
    const bool withWork
)
{
    const scalar* mU = mU_.data();
    scalar* UL = UL_.data();
    for (const label n : active_)
    {
        const scalar m = mU[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            // The increment takes what is left after boundary conditions
            UL[2*stride_*n + stride_ + d] -= UL[2*stride_*n + d];
            UL[2*stride_*n + d] += rm*impulse[stride_*n + d];
        }
    }

    // Impulse J = m (u* - u) of the conditions, at the mean velocity
    const labelList nodes(withWork ? constrained() : labelList());
    scalar work = 0;
    scalarList free(nDim_*nodes.size());
    forAll(nodes, i)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            free[nDim_*i + d] = UL[2*stride_*nodes[i] + d];
        }
    }
    if (reactions_)
    {
        reactions_->add(active_, -1, UL, 2*stride_, mU, stride_);
    }
    rigid_.addImpulse(UL, 2*stride_, false, mU, stride_);
    constrain(UL, 2*stride_, false, false);
    if (reactions_)
    {
        reactions_->add(active_, 1, UL, 2*stride_, mU, stride_);
    }
    forAll(nodes, i)
    {
        const label n = nodes[i];
        const scalar m =
            (share_.size() ? share_[n] : 1)*mU[stride_*n + nDim_];
        for (int d = 0; m > 0 && d < nDim_; ++d)
        {
            const scalar u = UL[2*stride_*n + d];
            work +=
                m*(u - free[nDim_*i + d])*0.5*(U_.data()[stride_*n + d] + u);
        }
    }
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            UL[2*stride_*n + stride_ + d] += UL[2*stride_*n + d];
        }
    }
    return work;
}


void Foam::mpm::gridState::startFilter(const series s)
{
    // work = [increments v in 2 stride per node][sum of m S S^T v]
    if (!work_.data())
    {
        work_ = alignedArray(3*stride_*grid_.nNodes());
    }
    const scalar* from =
        s == FMPM ? UL_.data() : s == XPIC ? U_.data() : Ustrain_.data();
    const int step = s == FMPM ? 2*stride_ : stride_;
    scalar* v = work_.data();
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            v[2*stride_*n + d] = from[step*n + d];
        }
    }
}


Foam::scalar* Foam::mpm::gridState::zeroProduct()
{
    scalar* Mv = work_.data() + 2*stride_*grid_.nNodes();
    for (const label n : active_)
    {
        for (int c = 0; c < stride_; ++c)
        {
            Mv[stride_*n + c] = 0;
        }
    }
    return Mv;
}


void Foam::mpm::gridState::addFilter(const series s, const scalar weight)
{
    const scalar* mU = mU_.data();
    scalar* v = work_.data();
    const scalar* Mv = v + 2*stride_*grid_.nNodes();

    for (const label n : active_)
    {
        const scalar m = mU[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            v[2*stride_*n + d] -= rm*Mv[stride_*n + d];
        }
    }

    // The sum keeps the fixed velocities: increments have none there
    const bool takes = reactions_ && s != strain;
    if (takes)
    {
        reactions_->add(active_, -1, v, 2*stride_, mU, stride_);
    }
    if (s != strain)
    {
        rigid_.addImpulse(v, 2*stride_, true, mU, stride_);
    }
    constrain(v, 2*stride_, true, false);
    if (takes)
    {
        reactions_->add(active_, 1, v, 2*stride_, mU, stride_);
    }

    scalar* to = s == strain ? Ustrain_.data() : UL_.data();
    const int step = s == strain ? stride_ : 2*stride_;
    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            to[step*n + d] += weight*v[2*stride_*n + d];
        }
    }
}


void Foam::mpm::gridState::accept()
{
    active_.transfer(activeNew_);
    rigid_.accept();
    mU_.swap(mUNew_);
    U_.swap(UNew_);
}


void Foam::mpm::gridState::reject()
{
    activeNew_.clear();
}


Foam::scalar Foam::mpm::gridState::maxStrain
(
    const labelList& cells,
    const scalar dt
) const
{
    const scalar* mU = mUNew_.data();
    const scalar* U = UNew_.data();
    const label nc = label(1) << nDim_;
    scalar largest = 0;

    for (const label celli : cells)
    {
        const label* c = grid_.corners(celli);
        for (int d = 0; d < nDim_; ++d)
        {
            scalar du = 0;
            for (label n = 0; n < nc; ++n)
            {
                if ((n >> d) & 1)
                {
                    continue;
                }
                const scalar* lo = U + stride_*c[n];
                const scalar* hi = U + stride_*c[n | (1 << d)];
                if
                (
                    mU[stride_*c[n] + nDim_] > 0
                 && mU[stride_*c[n | (1 << d)] + nDim_] > 0
                )
                {
                    for (int e = 0; e < nDim_; ++e)
                    {
                        du = max(du, mag(hi[e] - lo[e]));
                    }
                }
            }
            largest = max
            (
                largest,
                grid_.hasLattice()
              ? du*grid_.invWidth(d)[grid_.ijk(celli, d)]
              : du/grid_.width(celli, d)
            );
        }
    }
    return dt*largest;
}


void Foam::mpm::gridState::needReactions()
{
    if (!reactions_)
    {
        reactions_.reset(new nodeReactions(grid_, parts_, shared_));
    }
}


void Foam::mpm::gridState::addProjected(const scalar share)
{
    if (reactions_ && share > 0)
    {
        reactions_->addProjected
        (
            active_,
            share,
            U_.data(),
            mU_.data(),
            stride_
        );
    }
}


void Foam::mpm::gridState::writeField()
{
    vectorField& U = Ufield_.primitiveFieldRef();
    U = Zero;
    labelList isActive(grid_.nNodes(), label(0));
    for (const label n : active_)
    {
        isActive[n] = 1;
    }
    forAll(U, pointi)
    {
        const label n = grid_.pointToNode()[pointi];
        if (isActive[n])
        {
            for (int d = 0; d < nDim_; ++d)
            {
                U[pointi][grid_.direction(d)] = U_.data()[stride_*n + d];
            }
        }
    }
}


Foam::scalar Foam::mpm::gridState::bytes() const
{
    return
        scalar(grid_.nNodes())
       *(
            sizeof(scalar)*stride_
           *(7 + (work_.data() ? 3 : 0) + (Ustrain_.data() ? 1 : 0))
          + sizeof(label)
        )
      + sizeof(label)*scalar(active_.size() + activeNew_.size());
}

// ************************************************************************* //
