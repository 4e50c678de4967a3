/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointProbes

Description
    Histories of chosen points of one phase. Points are followed by their id,
    wherever they go; they are chosen by their position at the start of the
    run:

        ids      the points with these ids
        nearest  for each location the point that was nearest to it
        box      all points that were in the box, borders included

    Directions that are not computed do not count in nearest and box. A point
    that has eroded has the values nan, and no part in an operation.

    An operation makes one value of all points: the mean with the current
    volumes as weights, sum_p V_p f_p/sum_p V_p, or the smallest or largest
    value of each component.

Usage
    \verbatim
    gauge
    {
        type            materialPointProbes;
        libs            (mpmFunctionObjects);
        phase           target;
        fields          (U displacement sigma_yy p damage);
        points          { nearest ((0 0 0) (0 1.9e-3 0)); }
        // points       { ids (12 55); }
        // points       { box (-1e-3 0 0) (1e-3 2e-4 1e-3); }
        operation       none;
        writeControl    timeStep;
        writeInterval   1;
    }
    \endverbatim

    \table
        Property  | Description                    | Required | Default
        type      | materialPointProbes            | yes      |
        phase     | name of the phase              | yes      |
        fields    | see mpm::pointQuantity         | yes      |
        points    | one of ids, nearest, box       | yes      |
        operation | none, mean, min or max         | no       | box: mean; or none
    \endtable

    Files: <field>.dat for each field.

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "startState.H"
#include "pointErosion.H"
#include "FlatOutput.H"
#include "boundBox.H"
#include "pointQuantity.H"
#include <algorithm>
#include <limits>

namespace Foam::functionObjects
{

class materialPointProbes : public materialPointOutput
{
    word phase_;
    wordList fields_;
    word operation_;

    //- Ids of the points in the order of the output
    labelList id_;
    mpm::idTable table_;

    //- Only if something refers to the start
    autoPtr<mpm::startState> start_;

    wordList keywords() const override { return {"phase", "fields", "points", "operation"}; }

    void prepare(const mpm::materialPointSystem& points) override
    {
        phase_ = dict_.get<word>("phase");
        selectedPhases(points);
        const mpm::materialPointPhase& material = phase(points, phase_);

        fields_ = dict_.get<wordList>("fields");
        if (fields_.empty())
        {
            FatalIOErrorInFunction(dict_)
                << "The list of fields is empty." << nl << nl
                << "Valid fields are: " << flatOutput(mpm::pointQuantity::names(material)) << nl
                << exit(FatalIOError);
        }

        const dictionary& pointsDict = dict_.subDict("points");
        operation_ = mpm::oneOfOrDefault(
            dict_, "operation", pointsDict.found("box") ? "mean" : "none",
            {"none", "mean", "min", "max"});

        // Unknown names end here
        bool needsStart = !pointsDict.found("ids");
        for (const word& field : fields_)
        {
            mpm::pointQuantity(dict_, material, field, nullptr);
            needsStart = needsStart || mpm::pointQuantity::needsStart(field);
        }
        start_.clear();
        if (needsStart)
        {
            start_.reset(new mpm::startState(dict_, material));
        }
        select(material, pointsDict, points.erosion().nGone(points.indexOf(phase_)));
        if (start_)
        {
            shareStart();
        }

        const bool each = operation_ == "none";
        List<string> headers(fields_.size());
        forAll(fields_, fieldi)
        {
            const mpm::pointQuantity q(
                dict_, material, fields_[fieldi], start_ ? &*start_ : nullptr);
            OStringStream os;
            os << "Phase " << phase_ << ", " << (each ? "" : (operation_ + " of ").c_str())
               << id_.size() << " points" << nl;
            for (label i = 0; start_ && i < (each ? id_.size() : 0); ++i)
            {
                os << "Point " << id_[i] << " was at " << start_->x()[start_->find(id_[i])]
                   << " at time " << start_->time() << nl;
            }
            for (label i = 0; i < (each ? id_.size() : 1); ++i)
            {
                for (const word& title : q.titles())
                {
                    os << tab << title.c_str();
                    if (each)
                    {
                        os << '(' << id_[i] << ')';
                    }
                    os << q.unit().c_str();
                }
            }
            headers[fieldi] = os.str();
        }
        setFiles(fields_, headers);

        Info << type() << ' ' << name() << ": " << id_.size() << " points of " << phase_ << endl;
    }

    void sample(const mpm::materialPointSystem& points) override
    {
        const mpm::materialPointPhase& material = phase(points, phase_);
        const mpm::materialPointCloud& cloud = material.cloud();

        // Points are sorted by cell in each step and may be on any processor
        labelList place(id_.size(), label(-1));
        labelList found(id_.size(), label(0));
        scalarField V(id_.size(), Zero);
        for (label p = 0; p < cloud.size(); ++p)
        {
            const label i = table_[label(cloud.id()[0][p])];
            if (i >= 0)
            {
                place[i] = p;
                found[i] = 1;
                V[i] = cloud.volume()[0][p];
            }
        }
        Pstream::listCombineGather(found, maxEqOp<label>());
        Pstream::listCombineScatter(found);
        if (found.found(0) && !points.erosion().nGone(points.indexOf(phase_)))
        {
            FatalErrorInFunction << type() << ' ' << name() << ": point " << id_[found.find(0)]
                                 << " of " << phase_ << " is no longer there." << exit(FatalError);
        }
        Pstream::listCombineGather(V, plusEqOp<scalar>());

        forAll(fields_, fieldi)
        {
            const mpm::pointQuantity q(
                dict_, material, fields_[fieldi], start_ ? &*start_ : nullptr);
            // One processor has a point; the others add zero. The master works in
            // the order of the list, whatever processors hold the points
            const int n = q.size();
            scalarField values(n * place.size(), Zero);
            forAll(place, i)
            {
                if (place[i] >= 0)
                {
                    scalar v[mpm::pointQuantity::maxSize];
                    q.get(place[i], v);
                    std::copy_n(v, n, &values[n * i]);
                }
            }
            Pstream::listCombineGather(values, plusEqOp<scalar>());
            if (Pstream::master())
            {
                writeRow(row(fieldi), n, values, V);
            }
        }
    }

    //- Fill id_ according to the entry points
    void select(const mpm::materialPointPhase& phase, const dictionary& dict, const label nEroded)
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
                << "There are no points in the list." << exit(FatalIOError);
        }
        labelList sorted(id_);
        Foam::sort(sorted);
        for (label i = 1; i < sorted.size(); ++i)
        {
            if (sorted[i] == sorted[i - 1])
            {
                FatalIOErrorInFunction(dict)
                    << "Point " << sorted[i] << " is chosen twice." << exit(FatalIOError);
            }
        }
        checkIds(phase, dict, nEroded);
        table_ = mpm::idTable(id_, phase.cloud().size());
    }

    //- Keep the start of the chosen points only, on all processors
    void shareStart()
    {
        boolList keep(start_->id().size());
        forAll(keep, p)
        {
            keep[p] = table_[start_->id()[p]] >= 0;
        }
        start_->share(keep);

        for (const label id : id_)
        {
            if (start_->find(id) < 0)
            {
                FatalIOErrorInFunction(dict_)
                    << "Point " << id << " of phase " << phase_ << " was not there"
                    << " at the start, time " << start_->time() << ": it has no"
                    << " displacement and no J." << exit(FatalIOError);
            }
        }
    }

    //- The values of all points, n of each, with their volumes V [m3]
    void
    writeRow(Ostream& os, const int n, const UList<scalar>& values, const UList<scalar>& V) const
    {
        // A volume of 0: eroded
        const scalar none = std::numeric_limits<scalar>::quiet_NaN();
        if (operation_ == "none")
        {
            forAll(V, i)
            {
                for (int c = 0; c < n; ++c)
                {
                    os << tab << (V[i] > 0 ? values[n * i + c] : none);
                }
            }
        }
        else
        {
            for (int c = 0; c < n; ++c)
            {
                scalar result = none, sum = 0, volume = 0;
                forAll(V, i)
                {
                    const scalar v = values[n * i + c];
                    const bool first = !(volume > 0);
                    sum += V[i] * v;
                    volume += V[i];
                    if (V[i] > 0 && (first || (operation_ == "min" ? v < result : v > result)))
                    {
                        result = v;
                    }
                }
                if (operation_ == "mean" && volume > 0)
                {
                    result = sum / volume;
                }
                os << tab << result;
            }
        }
        os << endl;
    }

    //- Fatal if more points are missing than have eroded
    void checkIds(
        const mpm::materialPointPhase& phase, const dictionary& dict, const label nEroded) const
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
                << "Unknown id " << id_[known.find(false)] << " of phase " << phase_ << nl << nl
                << "It has " << n << " points with ids from " << first << " to " << last << "."
                << nl << exit(FatalIOError);
        }
    }

    //- Ids of the points nearest to these locations
    void selectNearest(const mpm::pointGrid& grid, const pointField& locations)
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
                if (distance2 < best[i] || (distance2 == best[i] && id < id_[i]))
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

    //- Ids of the points in the box that dict describes
    void selectBox(const mpm::pointGrid& grid, const dictionary& dict)
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
            FatalIOErrorInFunction(dict) << "Entry box must be two corners, (xmin ymin zmin)"
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
            FatalIOErrorInFunction(dict) << "At time " << start_->time() << " no point of phase "
                                         << phase_ << " is in the box " << low << ' ' << high << nl
                                         << nl << "Its points are in the box " << all.min() << ' '
                                         << all.max() << nl << exit(FatalIOError);
        }
    }

public:
    TypeName("materialPointProbes");

    using materialPointOutput::materialPointOutput;
};

defineTypeNameAndDebug(materialPointProbes, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointProbes, dictionary);

} // End namespace Foam::functionObjects
