// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fractionLattice.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "coupledPolyPatch.H"
#include "HashSet.H"
#include <unordered_map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fractionLattice::makeFaces()
{
    const polyMesh& mesh = grid_.mesh();
    faceDirection_.setSize(mesh.nFaces(), -1);
    faceSign_.setSize(mesh.nFaces(), 0);
    facePlace_.setSize(mesh.nFaces(), -1);

    const auto take = [&](const label facei)
    {
        const vector& S = mesh.faceAreas()[facei];
        int d = 0;
        for (int e = 1; e < grid_.nDim(); ++e)
        {
            if (mag(S[grid_.direction(e)]) > mag(S[grid_.direction(d)]))
            {
                d = e;
            }
        }
        const bool up = S[grid_.direction(d)] > 0;
        faceDirection_[facei] = d;
        faceSign_[facei] = up ? 1 : -1;
        facePlace_[facei] = placeOf_[mesh.faceOwner()[facei]] + (up ? stride_[d] : 0);
    };

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        take(facei);
    }
    DynamicList<label> walls, coupled;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        forAll(pp, i)
        {
            const label facei = pp.start() + i;
            take(facei);
            if (!isA<coupledPolyPatch>(pp))
            {
                walls.append(facei);
            }
            else if (faceSign_[facei] < 0)
            {
                coupled.append(facei);
            }
        }
    }
    walls_.transfer(walls);
    coupled_.transfer(coupled);
}

void Foam::mpm::fractionLattice::makeShared()
{
    const int D = grid_.nDim();

    // Key of each place that touches an own cell: its number among all places,
    // counted with a ring around the lattice of all processors
    std::unordered_map<label, DynamicList<label>> placesOfKey;
    labelHashSet candidates;
    const bool parallel = Pstream::parRun();
    const int nAround = D == 1 ? 3 : D == 2 ? 9 : 27;

    double all = 1;
    for (int d = 0; d < D; ++d)
    {
        all *= grid_.lattice().nAllLatticeCells(d) + 2;
    }
    if (all > labelMax)
    {
        FatalErrorInFunction << "The lattice of " << all << " places is too large for labels of "
                             << sizeof(label) * 8 << " bits." << exit(FatalError);
    }

    Map<label> keyOfPlace;
    for (label celli = 0; celli < grid_.nCells(); ++celli)
    {
        for (int n = 0; n < nAround; ++n)
        {
            label key = 0, stride = 1, place = 0, at[3] = {0, 0, 0};
            int rest = n;
            bool ring = false;
            for (int d = 0; d < D; ++d)
            {
                at[d] = grid_.lattice().ijk(celli, d) + rest % 3 - 1;
                rest /= 3;
                const label nAll = grid_.lattice().nAllLatticeCells(d);
                label i = grid_.lattice().window(d) + at[d];
                if (grid_.period(d) > 0)
                {
                    i = (i - 1 + nAll) % nAll + 1;
                }
                ring = ring || at[d] < 1 || at[d] > grid_.lattice().nLatticeCells(d);
                key += stride * i;
                stride *= nAll + 2;
                place += stride_[d] * at[d];
            }
            // Own cells far from any ring or ghost have no other place
            const label c = grid_.lattice().cellAt(at);
            if (ring || c < 0 || c >= grid_.nCells())
            {
                keyOfPlace.set(place, key);
                candidates.insert(place);
                // Its neighbours may be elsewhere too
                keyOfPlace.set(placeOf_[celli], -1);
            }
        }
    }

    // Keys of own cells that touch such a place
    for (label celli = 0; celli < grid_.nCells(); ++celli)
    {
        auto iter = keyOfPlace.find(placeOf_[celli]);
        if (iter.good() && iter.val() == -1)
        {
            label key = 0, stride = 1;
            for (int d = 0; d < D; ++d)
            {
                key += stride * (grid_.lattice().window(d) + grid_.lattice().ijk(celli, d));
                stride *= grid_.lattice().nAllLatticeCells(d) + 2;
            }
            iter.val() = key;
        }
    }

    const labelList places(keyOfPlace.sortedToc());
    for (const label place : places)
    {
        placesOfKey[keyOfPlace[place]].append(place);
    }

    DynamicList<labelList> same;
    DynamicList<label> first, keys;
    for (const label place : places)
    {
        const label key = keyOfPlace[place];
        const DynamicList<label>& group = placesOfKey[key];
        if (group[0] == place)
        {
            first.append(place);
            keys.append(key);
            if (group.size() > 1)
            {
                same.append(labelList(group));
            }
        }
    }
    same_.setSize(same.size());
    forAll(same_, i)
    {
        same_[i].transfer(same[i]);
    }
    if (parallel)
    {
        shared_.reset(new sharedNodes(first, keys));
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fractionLattice::fractionLattice(const pointGrid& grid) :
    grid_(grid), nPlaces_(1), stride_{0, 0, 0}, graded_{false, false, false}
{
    const int D = grid_.nDim();
    const string reason(grid_.noLattice());
    if (!reason.empty())
    {
        FatalErrorInFunction << "solidFraction lattice needs a lattice of boxes: " << reason.c_str()
                             << ". On other meshes choose"
                             << " solidFraction star." << exit(FatalError);
    }

    for (int d = 0; d < D; ++d)
    {
        stride_[d] = nPlaces_;
        nPlaces_ *= grid_.lattice().nLatticeCells(d) + 2;

        scalar least = GREAT, most = 0;
        for (label i = 1; i <= grid.lattice().nLatticeCells(d); ++i)
        {
            const scalar h = grid.lattice().planes(d)[i + 1] - grid.lattice().planes(d)[i];
            least = min(least, h);
            most = max(most, h);
        }
        reduce(least, minOp<scalar>());
        reduce(most, maxOp<scalar>());
        graded_[d] = most > (1 + 1e-4) * least;
    }
    placeOf_.setSize(grid_.nCells());
    below_.setSize(D * grid_.nCells());
    above_.setSize(D * grid_.nCells());
    forAll(placeOf_, celli)
    {
        placeOf_[celli] = 0;
        const unsigned walls = grid_.lattice().walls(celli);
        for (int d = 0; d < D; ++d)
        {
            placeOf_[celli] += stride_[d] * grid_.lattice().ijk(celli, d);
            below_[D * celli + d] = (walls >> 2 * d) & 1 ? 0 : -stride_[d];
            above_[D * celli + d] = (walls >> (2 * d + 1)) & 1 ? 0 : stride_[d];
        }
    }

    makeFaces();
    makeShared();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::fractionLattice::width(const label facei) const
{
    const int d = faceDirection_[facei];
    const label c = grid_.mesh().faceOwner()[facei];
    const scalar* x = grid_.lattice().planes(d).cdata() + grid_.lattice().ijk(c, d)
        + (faceSign_[facei] > 0 ? 1 : 0);
    return min(x[1] - x[0], x[0] - x[-1]);
}

void Foam::mpm::fractionLattice::sum(scalar* q, const int nComp) const
{
    sum(q, nComp, identity(same_.size()));
}

void Foam::mpm::fractionLattice::sum(scalar* q, const int nComp, const labelUList& groups) const
{
    for (const label g : groups)
    {
        const labelList& group = same_[g];
        scalar* to = q + nComp * group[0];
        for (label i = 1; i < group.size(); ++i)
        {
            for (int c = 0; c < nComp; ++c)
            {
                to[c] += q[nComp * group[i] + c];
            }
        }
    }
    if (shared_)
    {
        shared_->sum(q, nComp, nComp);
    }
    for (const label g : groups)
    {
        const labelList& group = same_[g];
        const scalar* from = q + nComp * group[0];
        for (label i = 1; i < group.size(); ++i)
        {
            for (int c = 0; c < nComp; ++c)
            {
                q[nComp * group[i] + c] = from[c];
            }
        }
    }
}
