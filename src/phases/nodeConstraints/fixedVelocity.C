// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fixedVelocity.H"
#include "valuePointPatchField.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fixedVelocity::read()
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
                node_.append(n);
                patch_.append(patchi);
                index_.append(i);
                parts_.append({n, patchi, true, {}, point(Zero)});
            }
        }
    }
}

Foam::Map<Foam::labelPair> Foam::mpm::fixedVelocity::winners() const
{
    // Key and patch of each shared fixed node, from every processor
    labelHashSet isShared;
    isShared.insert(shared_.nodes());
    Map<label> nodeOfKey;
    for (const label n : shared_.nodes())
    {
        nodeOfKey.insert(grid_.nodeKey()[n], n);
    }
    List<List<labelPair>> known(Pstream::nProcs());
    {
        DynamicList<labelPair> mine;
        forAll(node_, i)
        {
            if (isShared.found(node_[i]))
            {
                mine.append(labelPair(grid_.nodeKey()[node_[i]], patch_[i]));
            }
        }
        known[Pstream::myProcNo()].transfer(mine);
    }
    Pstream::gatherList(known);
    Pstream::scatterList(known);

    // The first patch wins, on the lowest processor that has it
    Map<labelPair> best;
    forAll(known, proci)
    {
        for (const labelPair& entry : known[proci])
        {
            const auto iter = nodeOfKey.cfind(entry.first());
            if (!iter.good())
            {
                continue;
            }
            labelPair& b = best(iter.val(), labelPair(labelMax, labelMax));
            const labelPair candidate(entry.second(), proci);
            b = candidate < b ? candidate : b;
        }
    }
    return best;
}

void Foam::mpm::fixedVelocity::share()
{
    Map<label> mineAt;
    forAll(node_, i)
    {
        mineAt.insert(node_[i], i);
    }
    const Map<labelPair> best(winners());
    forAllConstIters(best, iter)
    {
        elsewhere_ = true;
        if (iter.val().second() == Pstream::myProcNo())
        {
            continue;
        }
        const auto at = mineAt.cfind(iter.key());
        if (at.good())
        {
            patch_[at.val()] = -1;
            parts_[at.val()].patch = iter.val().first();
        }
        else
        {
            node_.append(iter.key());
            patch_.append(-1);
            index_.append(-1);
            parts_.append({iter.key(), iter.val().first(), true, {}, point(Zero)});
        }
    }
    reduce(elsewhere_, orOp<bool>());
    if (elsewhere_)
    {
        work_.setSize(grid_.nDim() * grid_.nNodes());
    }
}

void Foam::mpm::fixedVelocity::exchange()
{
    // One processor has the value, the others add zero
    const int D = grid_.nDim();
    for (const label n : shared_.nodes())
    {
        for (int d = 0; d < D; ++d)
        {
            work_[D * n + d] = 0;
        }
    }
    forAll(node_, i)
    {
        for (int d = 0; d < D; ++d)
        {
            work_[D * node_[i] + d] = value_[D * i + d];
        }
    }
    shared_.sum(work_.data(), D, D);
    forAll(node_, i)
    {
        for (int d = 0; d < D; ++d)
        {
            value_[D * i + d] = work_[D * node_[i] + d];
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fixedVelocity::fixedVelocity(
    const pointGrid& grid, const sharedNodes& shared, pointVectorField& Ufield) :
    grid_(grid), shared_(shared), Ufield_(Ufield), elsewhere_(false)
{
    read();
    if (Pstream::parRun())
    {
        share();
    }
    value_.setSize(grid_.nDim() * node_.size());
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fixedVelocity::update(const scalar dt)
{
    if (node_.empty() && !elsewhere_)
    {
        return;
    }

    // The velocity at the end of the step: evaluate at the time t + dt
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

    const int D = grid_.nDim();
    forAll(node_, i)
    {
        if (patch_[i] < 0)
        {
            for (int d = 0; d < D; ++d)
            {
                value_[D * i + d] = 0;
            }
            continue;
        }
        const valuePointPatchField<vector>& pf =
            refCast<const valuePointPatchField<vector>>(Ufield_.boundaryField()[patch_[i]]);
        for (int d = 0; d < D; ++d)
        {
            value_[D * i + d] = pf[index_[i]][grid_.direction(d)];
        }
    }

    if (elsewhere_)
    {
        exchange();
    }
}

void Foam::mpm::fixedVelocity::impose(
    scalar* u, const int stride, const bool homogeneous, const bool) const
{
    const int D = grid_.nDim();
    forAll(node_, i)
    {
        for (int d = 0; d < D; ++d)
        {
            u[stride * node_[i] + d] = homogeneous ? 0 : value_[D * i + d];
        }
    }
}
