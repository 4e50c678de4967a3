/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointSeparation

Description
    Numerical fracture, without damage: initial neighbours that are now more
    than a cell apart, so that no node connects them although nothing may have
    failed. Two points of a phase are neighbours if the boxes that they
    filled at the start had a side in common: with half sizes l, in one
    direction d

        |X_j - X_i|_d < 1.5 (l_i + l_j)_d

    and in the others |X_j - X_i| < 0.5 (l_i + l_j). They are apart if

        max_d |x_j - x_i|_d/h_d > 1

    with h_d the larger of the extents of their cells. A pair has failed if one
    of the two has damage 1. Pairs with an eroded point do not count. A pair
    with one point beyond a cyclic patch is apart.

    The log has a line for each phase.

Usage
    \verbatim
    separation
    {
        type            materialPointSeparation;
        libs            (mpmFunctionObjects);
        phases          (rod target);
        writeControl    writeTime;
    }
    \endverbatim

    \table
        Property | Description                | Required | Default
        type     | materialPointSeparation    | yes      |
        phases   | names of phases            | no       | all but debris
    \endtable

    Files: <phase>.dat with pairs and those of them apart, neither point failed
    and failed, and the largest distance of the first in cells. The time folder
    of the start, as setMaterialPoints writes it, must be there.

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "startState.H"
#include "labelPair.H"
#include "pointErosion.H"
#include "separationWatch.H"
#include <cstdint>
#include <unordered_map>

namespace Foam::functionObjects
{

namespace
{

//- The lists of all processors one after the other, on the master
template<class Type>
List<Type> gathered(const UList<Type>& mine)
{
    List<List<Type>> parts(Pstream::nProcs());
    parts[Pstream::myProcNo()] = mine;
    Pstream::gatherList(parts);
    List<Type> all;
    for (const List<Type>& part : parts)
    {
        all.append(part);
    }
    return all;
}

}

class materialPointSeparation : public materialPointOutput
{
    wordList phases_;

    //- Ids of the neighbours of each phase, on the master
    List<List<labelPair>> pairs_;

    wordList keywords() const override { return {"phase", "phases"}; }

    void prepare(const mpm::materialPointSystem& points) override
    {
        phases_ = selectedPhases(points);
        if (!dict_.found("phase") && !dict_.found("phases"))
        {
            phases_ = wordList(subsetList<word>(
                phases_,
                [&](const word& name)
                { return !points.erosion().isDebris(points.indexOf(name)); }));
        }
        pairs_.setSize(phases_.size());
        List<string> headers(phases_.size());
        forAll(phases_, phasei)
        {
            const mpm::startState start(dict_, phase(points, phases_[phasei]), true);
            const labelList id(gathered(start.id()));
            const vectorField X(gathered(start.x()));
            const vectorField l(gathered(start.halfSize()));
            if (Pstream::master())
            {
                pairs_[phasei] = neighbours(points.grid(), X, l);
                for (labelPair& pair : pairs_[phasei])
                {
                    pair = labelPair(id[pair.first()], id[pair.second()]);
                }
            }
            headers[phasei] = "Phase " + phases_[phasei] + ", neighbours at time " + start.time()
                + " and those of them more than a cell apart; failed: a point has"
                  " damage 1\n\tpairs\tapart\tfailedPairs\tfailedApart"
                  "\tlargest[cells]";
        }
        setFiles(phases_, headers);
    }

    void sample(const mpm::materialPointSystem& points) override
    {
        const mpm::pointGrid& grid = points.grid();
        forAll(phases_, phasei)
        {
            const mpm::materialPointCloud& cloud = phase(points, phases_[phasei]).cloud();
            const label n = cloud.size();
            labelList id(n);
            vectorField x(n), h(n, Zero);
            scalarField damage(n, Zero);
            forAll(cloud.cells(), k)
            {
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    const label celli = cloud.cells()[k];
                    id[p] = label(cloud.id()[0][p]);
                    x[p] = cloud.position(p, celli);
                    for (int d = 0; d < grid.nDim(); ++d)
                    {
                        h[p][grid.direction(d)] = mpm::separationWatch::extent(grid, celli, d);
                    }
                    damage[p] = cloud.damage() ? (*cloud.damage())[0][p] : 0;
                }
            }
            id = gathered(id);
            x = gathered(x);
            h = gathered(h);
            damage = gathered(damage);
            if (!Pstream::master())
            {
                continue;
            }

            const mpm::idTable table(id, id.size());
            label nPairs[2] = {0, 0}, nApart[2] = {0, 0};
            scalar largest = 0;
            for (const labelPair& pair : pairs_[phasei])
            {
                const label p = table[pair.first()], q = table[pair.second()];
                if (p < 0 || q < 0)
                {
                    continue;
                }
                scalar distance = 0;
                for (int d = 0; d < grid.nDim(); ++d)
                {
                    const int c = grid.direction(d);
                    distance = max(distance, mag(x[q][c] - x[p][c]) / max(h[p][c], h[q][c]));
                }
                const int failed = damage[p] >= 1 || damage[q] >= 1;
                ++nPairs[failed];
                nApart[failed] += distance > 1;
                largest = failed ? largest : max(largest, distance);
            }
            row(phasei) << tab << nPairs[0] << tab << nApart[0] << tab << nPairs[1] << tab
                        << nApart[1] << tab << largest << endl;
            Info << type() << ' ' << phases_[phasei] << ": more than a cell apart " << nApart[0]
                 << " of " << nPairs[0] << " pairs of neighbours without failure, " << nApart[1]
                 << " of " << nPairs[1] << " failed" << endl;
        }
    }

    //- Neighbours among points at X with half sizes l, by place
    static List<labelPair>
    neighbours(const mpm::pointGrid& grid, const vectorField& X, const vectorField& l)
    {
        // Bins as wide as neighbours can be apart; those of a point and the next
        // ones hold them all
        const int D = grid.nDim();
        vector low(vector::max), width(Zero);
        forAll(X, p)
        {
            low = min(low, X[p]);
            width = max(width, 3.0001 * l[p]);
        }
        const auto binOf = [&](const label p, const int d)
        {
            const int c = grid.direction(d);
            return std::int64_t(std::floor((X[p][c] - low[c]) / width[c]));
        };
        const auto keyOf = [](const std::int64_t(&bin)[3])
        {
            constexpr std::int64_t n = std::int64_t(1) << 21;
            return (bin[2] * n + bin[1]) * n + bin[0];
        };
        std::unordered_map<std::int64_t, DynamicList<label>> bins;
        forAll(X, p)
        {
            std::int64_t bin[3] = {1, 1, 1};
            for (int d = 0; d < D; ++d)
            {
                bin[d] += binOf(p, d);
            }
            bins[keyOf(bin)].append(p);
        }

        const auto touch = [&](const label p, const label q)
        {
            int nBeside = 0;
            for (int d = 0; d < D; ++d)
            {
                const int c = grid.direction(d);
                const scalar r = mag(X[q][c] - X[p][c]) / (l[p][c] + l[q][c]);
                if (!(r < 1.5))
                {
                    return false;
                }
                nBeside += r < 0.5;
            }
            return nBeside == D - 1;
        };

        DynamicList<labelPair> pairs(D * X.size());
        forAll(X, p)
        {
            std::int64_t at[3] = {1, 1, 1};
            for (int d = 0; d < D; ++d)
            {
                at[d] += binOf(p, d);
            }
            for (int n = 0; n < (D == 1 ? 3 : D == 2 ? 9 : 27); ++n)
            {
                const std::int64_t bin[3] = {
                    at[0] + n % 3 - 1, at[1] + (D > 1 ? n / 3 % 3 - 1 : 0),
                    at[2] + (D > 2 ? n / 9 - 1 : 0)};
                const auto found = bins.find(keyOf(bin));
                if (found == bins.end())
                {
                    continue;
                }
                for (const label q : found->second)
                {
                    if (q > p && touch(p, q))
                    {
                        pairs.append(labelPair(p, q));
                    }
                }
            }
        }
        return List<labelPair>(std::move(pairs));
    }

public:
    TypeName("materialPointSeparation");

    using materialPointOutput::materialPointOutput;
};

defineTypeNameAndDebug(materialPointSeparation, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointSeparation, dictionary);

} // End namespace Foam::functionObjects
