// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "separationWatch.H"
#include "Time.H"
#include "PstreamReduceOps.H"
#include "ListListOps.H"
#include "ListOps.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Neighbours that are not this much further apart than at the start have not come
//  apart: they may have a cell between them from the start where cells are finer
//  than the points. With 2 points per cell and direction, whose distance is at most
//  0.7 cells, it decides nothing
constexpr scalar leastStretch = 1.4;

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::separationWatch::separationWatch(const materialPointPhase& phase) : warned_(false)
{
    const materialPointCloud& cloud = phase.cloud();
    const pointGrid& grid = cloud.grid();
    const int D = grid.nDim();
    const labelList& cells = cloud.cells();
    const label n = returnReduce(cloud.size(), sumOp<label>());
    const label every = max(label(1), n / 10000);

    // Size of a point in a direction
    const auto size = [&](const label celli, const label p, const int d)
    {
        if (const column* l = cloud.halfSize())
        {
            return 2 * (*l)[d][p];
        }
        const auto k = std::lower_bound(cells.begin(), cells.end(), celli) - cells.begin();
        return grid.width(celli, d)
            / std::round(std::pow(cloud.start()[k + 1] - cloud.start()[k], 1.0 / D));
    };

    // Pairs of ids: each chosen point with those above it in each direction,
    // in its own cell and the next
    DynamicList<labelPair> found;
    DynamicList<scalar> distance;
    forAll(cells, k)
    {
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            if (label(cloud.id()[0][p]) % every)
            {
                continue;
            }
            for (int d = 0; d < D; ++d)
            {
                for (const label celli : {cells[k], grid.neighbour(cells[k], d, 1)})
                {
                    const auto at = std::lower_bound(cells.begin(), cells.end(), celli);
                    if (at == cells.end() || *at != celli)
                    {
                        continue;
                    }
                    const label m = at - cells.begin();
                    for (label q = cloud.start()[m]; q < cloud.start()[m + 1]; ++q)
                    {
                        bool next = q != p;
                        scalar sum = 0;
                        for (int e = 0; e < D; ++e)
                        {
                            const scalar way =
                                (cloud.x()[e][q] - cloud.x()[e][p]) / size(cells[k], p, e);
                            next = next && mag(way - (e == d)) < 0.4;
                            sum += sqr(cloud.x()[e][q] - cloud.x()[e][p]);
                        }
                        if (next)
                        {
                            distance.append(std::sqrt(sum));
                            found.append(
                                labelPair(label(cloud.id()[0][p]), label(cloud.id()[0][q])));
                        }
                    }
                }
            }
        }
    }

    // The same lists on all processors
    List<List<labelPair>> parts(Pstream::nProcs());
    parts[Pstream::myProcNo()] = found;
    Pstream::gatherList(parts);
    Pstream::scatterList(parts);
    List<scalarList> distances(Pstream::nProcs());
    distances[Pstream::myProcNo()] = distance;
    Pstream::gatherList(distances);
    Pstream::scatterList(distances);
    distance_ = ListListOps::combine<scalarList>(distances, accessOp<scalarList>());
    label nPairs = 0;
    for (const List<labelPair>& part : parts)
    {
        nPairs += part.size();
    }
    pairs_.setSize(nPairs);
    id_.setSize(2 * nPairs);
    nPairs = 0;
    for (const List<labelPair>& part : parts)
    {
        for (const labelPair& pair : part)
        {
            pairs_[nPairs] = pair;
            id_[2 * nPairs] = pair.first();
            id_[2 * nPairs + 1] = pair.second();
            ++nPairs;
        }
    }
    inplaceUniqueSort(id_);
    for (labelPair& pair : pairs_)
    {
        pair = labelPair(findSortedIndex(id_, pair.first()), findSortedIndex(id_, pair.second()));
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar
Foam::mpm::separationWatch::extent(const pointGrid& grid, const label celli, const int d)
{
    if (grid.hasLattice())
    {
        return grid.width(celli, d);
    }
    const polyMesh& mesh = grid.mesh();
    const int c = grid.direction(d);
    scalar low = GREAT, high = -GREAT;
    for (const label facei : mesh.cells()[celli])
    {
        for (const label pointi : mesh.faces()[facei])
        {
            low = min(low, mesh.points()[pointi][c]);
            high = max(high, mesh.points()[pointi][c]);
        }
    }
    return high - low;
}

void Foam::mpm::separationWatch::look(const materialPointPhase& phase)
{
    if (warned_ || pairs_.empty())
    {
        return;
    }
    const materialPointCloud& cloud = phase.cloud();
    const pointGrid& grid = cloud.grid();
    const int D = grid.nDim();

    // Position and cell width of local points; width 0: on other processors
    vectorField x(id_.size(), Zero), h(id_.size(), Zero);
    labelList failed(id_.size(), label(0));
    forAll(cloud.cells(), k)
    {
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            const label i = findSortedIndex(id_, label(cloud.id()[0][p]));
            if (i < 0)
            {
                continue;
            }
            x[i] = cloud.position(p, cloud.cells()[k]);
            for (int d = 0; d < D; ++d)
            {
                h[i][grid.direction(d)] = extent(grid, cloud.cells()[k], d);
            }
            failed[i] = cloud.damage() && (*cloud.damage())[0][p] >= 1;
        }
    }
    Pstream::listCombineGather(x, plusEqOp<vector>());
    Pstream::listCombineGather(h, plusEqOp<vector>());
    Pstream::listCombineGather(failed, maxEqOp<label>());
    Pstream::listCombineScatter(x);
    Pstream::listCombineScatter(h);
    Pstream::listCombineScatter(failed);

    label nPairs = 0;
    DynamicList<labelPair> apart;
    forAll(pairs_, pairi)
    {
        const labelPair& pair = pairs_[pairi];
        const label i = pair.first(), j = pair.second();
        if (h[i] == vector::zero || h[j] == vector::zero || failed[i] || failed[j])
        {
            continue;
        }
        ++nPairs;
        if (mag(x[i] - x[j]) < leastStretch * distance_[pairi])
        {
            continue;
        }
        for (int d = 0; d < D; ++d)
        {
            const int c = grid.direction(d);
            const scalar way = mag(x[i][c] - x[j][c]);
            if (way > max(h[i][c], h[j][c])
                && !(grid.hasLattice() && way > 0.5 * grid.period(d) && grid.period(d) > 0))
            {
                apart.append(pair);
                break;
            }
        }
    }

    // Shear or a gap? It is a gap if no point lies in the middle
    labelList filled(apart.size(), label(0));
    forAll(apart, i)
    {
        const point middle(0.5 * (x[apart[i].first()] + x[apart[i].second()]));
        scalar at[3] = {0, 0, 0};
        for (int d = 0; d < D; ++d)
        {
            at[d] = middle[grid.direction(d)];
        }
        const label celli = grid.find(at);
        filled[i] = std::binary_search(cloud.cells().begin(), cloud.cells().end(), celli);
    }
    Pstream::listCombineGather(filled, maxEqOp<label>());
    Pstream::listCombineScatter(filled);

    label nApart = 0, first = -1;
    forAll(apart, i)
    {
        if (!filled[i])
        {
            first = nApart++ ? first : i;
        }
    }
    if (nApart < 3)
    {
        return;
    }
    warned_ = true;
    const label i = apart[first].first(), j = apart[first].second();
    WarningInFunction << "Numerical fracture: of " << phase.name() << ", " << nApart << " of the "
                      << nPairs << " pairs of neighbours checked"
                      << " are more than a cell apart with an empty cell between them, though"
                      << " nothing has failed there, at time " << cloud.time().timeName()
                      << "; e.g. the points " << id_[i] << " and " << id_[j] << " at " << x[i]
                      << " and " << x[j] << '.' << nl
                      << "Points separate from a stretch of about their number per"
                      << " cell and direction: give more pointsPerCell in"
                      << " setMaterialPointsDict, or a failureModel if the material should"
                      << " break. The function object materialPointSeparation counts all"
                      << " pairs." << endl;
}
