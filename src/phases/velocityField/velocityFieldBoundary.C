/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "velocityField.H"
#include "valuePointPatchField.H"
#include "basicSymmetryPointPatchField.H"
#include "fixedNormalSlipPointPatchField.H"
#include "calculatedPointPatchField.H"
#include "zeroGradientPointPatchField.H"
#include "coupledPointPatchField.H"
#include "emptyPointPatchField.H"
#include "wedgePointPatchField.H"
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

bool Foam::mpm::velocityField::drives() const
{
    for (const pointPatchField<vector>& pf : Ufield_.boundaryField())
    {
        if (const auto* value = isA<valuePointPatchField<vector>>(pf))
        {
            if (value->size() && pf.type() != "fixedValue")
            {
                return true;
            }
            for (const vector& U : *value)
            {
                if (U != vector::zero)
                {
                    return true;
                }
            }
        }
    }
    return false;
}


void Foam::mpm::velocityField::readBoundary()
{
    forAll(Ufield_.boundaryField(), patchi)
    {
        const pointPatchField<vector>& pf = Ufield_.boundaryField()[patchi];

        if
        (
            isA<emptyPointPatchField<vector>>(pf)
         || isA<wedgePointPatchField<vector>>(pf)
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
            << " (free); cyclic; empty; wedge." << exit(FatalError);
    }

    readFixed();
    shareFixed();
    fixedValue_.setSize(nDim_*fixedNode_.size());

    labelHashSet fixed;
    fixed.insert(fixedNode_);
    readSlip(fixed);
}


void Foam::mpm::velocityField::readFixed()
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


void Foam::mpm::velocityField::shareFixed()
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


void Foam::mpm::velocityField::readSlip(const labelHashSet& fixed)
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
        if (grid_.radial() >= 0)
        {
            vector radius(Zero);
            radius[grid_.direction(grid_.radial())] = 1;
            for (const label n : grid_.axisNodes())
            {
                const label key = parallel ? grid_.nodeKey()[n] : n;
                (isShared.found(n) ? mine : others).append
                (
                    faceNormal(labelPair(key, -1), radius)
                );
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

                if (entry.first.second() < 0)
                {
                    // No patch: the axis
                    continue;
                }
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


bool Foam::mpm::velocityField::holds(const label patchi) const
{
    const pointPatchField<vector>& pf = Ufield_.boundaryField()[patchi];
    return isSlip(pf) || isA<valuePointPatchField<vector>>(pf);
}


void Foam::mpm::velocityField::slip(const label node, scalar* v) const
{
    const auto at =
        std::lower_bound(slipNode_.begin(), slipNode_.end(), node);
    if (at == slipNode_.end() || *at != node)
    {
        return;
    }
    const scalar* R =
        slipProjection_.cdata() + nDim_*nDim_*(at - slipNode_.begin());
    scalar w[3] = {0, 0, 0};
    for (int a = 0; a < nDim_; ++a)
    {
        for (int b = 0; b < nDim_; ++b)
        {
            w[a] += R[nDim_*a + b]*v[b];
        }
    }
    std::copy(w, w + nDim_, v);
}


void Foam::mpm::velocityField::updateFixed(const scalar dt)
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

// ************************************************************************* //
