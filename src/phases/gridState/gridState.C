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
#include <Eigen/Dense>
#include <map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gridState::readBoundary()
{
    const labelList& toNode = grid_.pointToNode();

    labelList fixedBy(grid_.nNodes(), label(-1));
    std::map<label, Eigen::Matrix3d> slip;

    forAll(Ufield_.boundaryField(), patchi)
    {
        const pointPatchField<vector>& pf = Ufield_.boundaryField()[patchi];
        const labelList& points = pf.patch().meshPoints();

        if
        (
            isA<emptyPointPatchField<vector>>(pf)
         || isA<coupledPointPatchField<vector>>(pf)
         || isA<calculatedPointPatchField<vector>>(pf)
         || isA<zeroGradientPointPatchField<vector>>(pf)
        )
        {
            continue;
        }
        else if (isA<valuePointPatchField<vector>>(pf))
        {
            DynamicList<label> node(fixedNode_), patch(fixedPatch_);
            DynamicList<label> index(fixedIndex_);
            forAll(points, i)
            {
                const label n = toNode[points[i]];
                if (fixedBy[n] != patchi && fixedBy[n] >= 0)
                {
                    // The first patch of the mesh's list wins
                    continue;
                }
                if (fixedBy[n] < 0)
                {
                    node.append(n);
                    patch.append(patchi);
                    index.append(i);
                    fixedBy[n] = patchi;
                }
            }
            fixedNode_ = node;
            fixedPatch_ = patch;
            fixedIndex_ = index;
        }
        else if
        (
            isA<basicSymmetryPointPatchField<vector>>(pf)
         && !isA<fixedNormalSlipPointPatchField<vector>>(pf)
        )
        {
            const polyPatch& pp =
                grid_.mesh().boundaryMesh()[pf.patch().index()];
            const labelListList& pointFaces = pp.pointFaces();
            forAll(points, i)
            {
                // pointNormals() would average over the edges of a patch
                // that has some. Faces at less than 45 degrees are one smooth
                // surface; others are surfaces of their own (edges, corners)
                DynamicList<vector> groups;
                for (const label facei : pointFaces[i])
                {
                    const vector nf(pp.faceNormals()[facei]);
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
                        groups.append(nf);
                    }
                }
                Eigen::Matrix3d& N =
                    slip.emplace
                    (
                        toNode[points[i]],
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
                    }
                }
            }
        }
        else
        {
            FatalErrorInFunction
                << "Patch " << pf.patch().name() << " of " << Ufield_.name()
                << " (" << Ufield_.objectPath() << ") has the type "
                << pf.type() << ", which material points do not know." << nl
                << "Valid types: fixedValue, timeVaryingUniformFixedValue and others with"
                << " a value (fixed velocity); slip, symmetry, symmetryPlane"
                << " (no normal velocity); calculated, zeroGradient (free);"
                << " cyclic; empty." << exit(FatalError);
        }
    }

    fixedValue_.setSize(nDim_*fixedNode_.size());

    DynamicList<label> nodes;
    DynamicList<scalar> projections;
    for (const auto& s : slip)
    {
        if (fixedBy[s.first] >= 0)
        {
            continue;
        }
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
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gridState::gridState(const hexGrid& grid, const word& name)
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
    stamp_(grid.nNodes(), label(-1)),
    stampNow_(0),
    UNew_(stride_*grid.nNodes())
{
    readBoundary();
    updateFixed(0);
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
    const bool homogeneous
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
    constrain(U, stride_, false);
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
    constrain(UL, 2*stride_, false);

    for (const label n : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            UL[2*stride_*n + stride_ + d] =
                UL[2*stride_*n + d] - U[stride_*n + d];
        }
    }
}


void Foam::mpm::gridState::startFilter(const bool tentative)
{
    // work = [increments v in 2 stride per node][sum of m S S^T v]
    if (!work_.data())
    {
        work_ = alignedArray(3*stride_*grid_.nNodes());
    }
    if (tentative && !Ustrain_.data())
    {
        Ustrain_ = alignedArray(stride_*grid_.nNodes());
    }
    scalar* v = work_.data();
    for (const label n : tentative ? activeNew_ : active_)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            if (tentative)
            {
                v[2*stride_*n + d] = UNew_.data()[stride_*n + d];
                Ustrain_.data()[stride_*n + d] = UNew_.data()[stride_*n + d];
            }
            else
            {
                v[2*stride_*n + d] = UL_.data()[2*stride_*n + d];
            }
        }
    }
}


void Foam::mpm::gridState::addFilter
(
    const bool tentative,
    const scalar weight,
    const scalar* Mv
)
{
    const labelList& nodes = tentative ? activeNew_ : active_;
    const scalar* mU = tentative ? mUNew_.data() : mU_.data();
    scalar* v = work_.data();

    for (const label n : nodes)
    {
        const scalar m = mU[stride_*n + nDim_];
        const scalar rm = m > 0 ? 1/m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            v[2*stride_*n + d] -= rm*Mv[stride_*n + d];
        }
    }

    // The sum keeps the fixed velocities: increments have none there
    constrain(v, 2*stride_, true);

    for (const label n : nodes)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            if (tentative)
            {
                Ustrain_.data()[stride_*n + d] +=
                    weight*v[2*stride_*n + d];
            }
            else
            {
                UL_.data()[2*stride_*n + d] += v[2*stride_*n + d];
            }
        }
    }
}


void Foam::mpm::gridState::accept()
{
    active_.transfer(activeNew_);
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
            sizeof(scalar)*stride_*(7 + (work_.data() ? 4 : 0))
          + sizeof(label)
        )
      + sizeof(label)*scalar(active_.size() + activeNew_.size());
}

// ************************************************************************* //
