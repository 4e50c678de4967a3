/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointProbes.H"
#include "boundBox.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::materialPointProbes::checkIds
(
    const mpm::materialPointPhase& phase,
    const dictionary& dict,
    const label nEroded
) const
{
    const mpm::materialPointCloud& cloud = phase.cloud();
    labelList there(cloud.size());
    forAll(there, p)
    {
        there[p] = label(cloud.id()[0][p]);
    }
    const mpm::idTable table(there, there.size());

    boolList known(id_.size());
    forAll(id_, i)
    {
        known[i] = table[id_[i]] >= 0;
    }
    Pstream::listCombineGather(known, orEqOp<bool>());
    Pstream::listCombineScatter(known);

    label nMissing = 0;
    for (const bool k : known)
    {
        nMissing += !k;
    }
    if (nMissing > nEroded)
    {
        const label n = returnReduce(there.size(), sumOp<label>());
        const label first = gMin(there), last = gMax(there);
        FatalIOErrorInFunction(dict)
            << "Unknown id " << id_[known.find(false)] << " of phase "
            << phase_ << nl << nl << "It has " << n
            << " points with ids from " << first << " to " << last << "." << nl
            << exit(FatalIOError);
    }
}


void Foam::functionObjects::materialPointProbes::selectNearest
(
    const mpm::pointGrid& grid,
    const pointField& locations
)
{
    // Twice as large as the mesh
    boundBox near(grid.mesh().bounds());
    near.inflate(0.5);

    id_.setSize(locations.size(), labelMax);
    scalarField best(locations.size(), VGREAT);
    forAll(locations, i)
    {
        for (int d = 0; d < grid.nDim(); ++d)
        {
            const int c = grid.direction(d);
            if (locations[i][c] < near.min()[c] || locations[i][c] > near.max()[c])
            {
                FatalIOErrorInFunction(dict_)
                    << "Entry nearest has the place " << locations[i]
                    << ", far outside the mesh " << grid.mesh().bounds() << "."
                    << exit(FatalIOError);
            }
        }
        forAll(start_->x(), p)
        {
            scalar distance2 = 0;
            for (int d = 0; d < grid.nDim(); ++d)
            {
                const int c = grid.direction(d);
                distance2 += sqr(start_->x()[p][c] - locations[i][c]);
            }
            // The lowest id of points at the same distance
            const label id = start_->id()[p];
            if
            (
                distance2 < best[i]
             || (distance2 == best[i] && id < id_[i])
            )
            {
                best[i] = distance2;
                id_[i] = id;
            }
        }
    }

    // The same rule among processors
    scalarField nearest(best);
    Pstream::listCombineGather(nearest, minEqOp<scalar>());
    Pstream::listCombineScatter(nearest);
    forAll(id_, i)
    {
        if (best[i] > nearest[i])
        {
            id_[i] = labelMax;
        }
    }
    Pstream::listCombineGather(id_, minEqOp<label>());
    Pstream::listCombineScatter(id_);
}


void Foam::functionObjects::materialPointProbes::selectBox
(
    const mpm::pointGrid& grid,
    const dictionary& dict
)
{
    ITstream& is = dict.lookupEntry("box", keyType::LITERAL).stream();
    const point low(is), high(is);

    bool right = !is.nRemainingTokens();
    for (int d = 0; d < grid.nDim(); ++d)
    {
        right = right && low[grid.direction(d)] <= high[grid.direction(d)];
    }
    if (!right)
    {
        FatalIOErrorInFunction(dict)
            << "Entry box must be two corners, (xmin ymin zmin)"
            << " (xmax ymax zmax)." << exit(FatalIOError);
    }

    DynamicList<label> ids;
    forAll(start_->x(), p)
    {
        bool inside = true;
        for (int d = 0; d < grid.nDim(); ++d)
        {
            const int c = grid.direction(d);
            const scalar x = start_->x()[p][c];
            inside = inside && x >= low[c] && x <= high[c];
        }
        if (inside)
        {
            ids.append(start_->id()[p]);
        }
    }

    List<labelList> parts(Pstream::nProcs());
    parts[Pstream::myProcNo()] = ids;
    Pstream::gatherList(parts);
    Pstream::scatterList(parts);
    id_.clear();
    for (const labelList& part : parts)
    {
        id_.append(part);
    }
    Foam::sort(id_);

    if (id_.empty())
    {
        const boundBox all(start_->x(), true);
        FatalIOErrorInFunction(dict)
            << "At time " << start_->time() << " no point of phase " << phase_
            << " is in the box " << low << ' ' << high << nl << nl
            << "Its points are in the box "
            << all.min() << ' ' << all.max() << nl
            << exit(FatalIOError);
    }
}


void Foam::functionObjects::materialPointProbes::select
(
    const mpm::materialPointPhase& phase,
    const dictionary& dict,
    const label nEroded
)
{
    mpm::checkKeywords(dict, {"ids", "nearest", "box"});
    if (dict.size() != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Give one of ids, nearest and box." << exit(FatalIOError);
    }

    const mpm::pointGrid& grid = phase.cloud().grid();

    if (dict.found("ids"))
    {
        id_ = dict.get<labelList>("ids");
    }
    else if (dict.found("nearest"))
    {
        selectNearest(grid, dict.get<pointField>("nearest"));
    }
    else
    {
        selectBox(grid, dict);
    }

    if (id_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There are no points in the list."  << exit(FatalIOError);
    }
    labelList sorted(id_);
    Foam::sort(sorted);
    for (label i = 1; i < sorted.size(); ++i)
    {
        if (sorted[i] == sorted[i - 1])
        {
            FatalIOErrorInFunction(dict)
                << "Point " << sorted[i] << " is chosen twice."
                << exit(FatalIOError);
        }
    }
    checkIds(phase, dict, nEroded);
    table_ = mpm::idTable(id_, phase.cloud().size());
}

// ************************************************************************* //
