/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointXT

Description
    Record for an x-t diagram: a quantity over time and over the place X where
    the material was at the start of the run (Lagrangian coordinate). The range
    of X along a direction is cut into equal bins b, and each row holds

        f_b = sum_{p in b} V_p f_p / sum_{p in b} V_p

    over all points of the listed phases whose start position lies in bin b,
    with their current volumes. A bin without points has 0.

Usage
    \verbatim
    stressXT
    {
        type            materialPointXT;
        libs            (mpmFunctionObjects);
        phases          (target flyer);
        field           sigma_yy;
        direction       y;
        range           (0 5.7e-3);
        nBins           300;
        writeControl    timeStep;
        writeInterval   5;
    }
    \endverbatim

    \table
        Property  | Description                             | Required | Default
        type      | materialPointXT                         | yes      |
        phases    | names of phases                         | no       | all
        field     | one value per point: mpm::pointQuantity | yes      |
        direction | x, y or z; must be computed             | yes      |
        range     | smallest and largest X [m]              | yes      |
        nBins     | number of bins                          | yes      |
    \endtable

    File: <field>.dat; the last line of its header holds the centres of the
    bins.

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "startState.H"
#include "pointQuantity.H"
#include "Pair.H"
#include <vector>

namespace Foam::functionObjects
{

class materialPointXT : public materialPointOutput
{
    wordList phases_;
    word field_;
    label nBins_ = 0;

    //- Start of each phase, and the bin of each of its points
    PtrList<mpm::startState> start_;
    List<labelList> bin_;

    wordList keywords() const override
    {
        return {"phase", "phases", "field", "direction", "range", "nBins"};
    }

    void prepare(const mpm::materialPointSystem& points) override
    {
        phases_ = selectedPhases(points);
        field_ = dict_.get<word>("field");
        nBins_ = label(mpm::bounded(dict_, "nBins", 1, 1e6));

        const Pair<scalar> range(dict_.get<Pair<scalar>>("range"));
        if (!(range.first() < range.second()))
        {
            FatalIOErrorInFunction(dict_)
                << "Entry range is (" << range.first() << ' ' << range.second()
                << "); the first value must be smaller than the second." << exit(FatalIOError);
        }

        const wordList axes({"x", "y", "z"});
        const int c = axes.find(mpm::oneOf(dict_, "direction", axes));
        DynamicList<word> computed;
        for (int d = 0; d < points.grid().nDim(); ++d)
        {
            computed.append(axes[points.grid().direction(d)]);
        }
        if (!computed.found(axes[c]))
        {
            FatalIOErrorInFunction(dict_)
                << "Direction " << axes[c] << " is not computed." << nl << nl
                << "Valid directions are: " << wordList(computed) << nl << exit(FatalIOError);
        }

        std::string unit;
        start_.clear();
        start_.setSize(phases_.size());
        forAll(phases_, i)
        {
            const mpm::materialPointPhase& material = phase(points, phases_[i]);
            const mpm::pointQuantity q(dict_, material, field_, nullptr);
            if (q.size() > 1)
            {
                FatalIOErrorInFunction(dict_)
                    << "Field " << field_ << " has " << q.size() << " components; choose one." << nl
                    << nl << "Valid choices are: " << q.titles() << nl << exit(FatalIOError);
            }
            unit = q.unit();
            start_.set(i, new mpm::startState(dict_, material));
        }
        makeBins(c, range.first(), range.second());

        OStringStream os;
        os.precision(writePrecision_);
        os << field_ << unit.c_str() << " of " << joined(phases_).c_str() << ", mean over bins of "
           << axes[c] << " at time " << start_[0].time() << nl
           << "Columns: time, then bins, whose centres [m] are" << nl;
        const scalar width = (range.second() - range.first()) / nBins_;
        for (label b = 0; b < nBins_; ++b)
        {
            os << tab << range.first() + (b + 0.5) * width;
        }
        setFiles(wordList(1, field_), List<string>(1, os.str()));
    }

    void sample(const mpm::materialPointSystem& points) override
    {
        scalarField sum(nBins_, Zero), volume(nBins_, Zero);

        forAll(phases_, i)
        {
            const mpm::materialPointPhase& material = phase(points, phases_[i]);
            const mpm::materialPointCloud& cloud = material.cloud();
            const mpm::pointQuantity q(dict_, material, field_, &start_[i]);

            for (label p = 0; p < cloud.size(); ++p)
            {
                // Points out of the range at the start have no place in the diagram
                const label first = start_[i].find(label(cloud.id()[0][p]));
                const label b = first < 0 ? -1 : bin_[i][first];
                if (b >= 0)
                {
                    scalar v[mpm::pointQuantity::maxSize];
                    q.get(p, v);
                    const scalar V = cloud.volume()[0][p];
                    sum[b] += V * v[0];
                    volume[b] += V;
                }
            }
        }

        Pstream::listCombineGather(sum, plusEqOp<scalar>());
        Pstream::listCombineGather(volume, plusEqOp<scalar>());
        if (!Pstream::master())
        {
            return;
        }
        Ostream& os = row(0);
        forAll(sum, b)
        {
            os << tab << (volume[b] > 0 ? sum[b] / volume[b] : 0);
        }
        os << endl;
    }

    //- Bins of all points along component c of the start position
    void makeBins(const int c, const scalar low, const scalar high)
    {
        std::vector<bool> used(nBins_, false);
        label nPoints = 0, nIn = 0;
        scalar first = VGREAT, last = -VGREAT;

        bin_.setSize(start_.size());
        forAll(start_, i)
        {
            // Points may have started on another processor: all know the bins of
            // all points that have one
            boolList inside(start_[i].x().size());
            forAll(inside, p)
            {
                const scalar x = start_[i].x()[p][c];
                first = min(first, x);
                last = max(last, x);
                inside[p] = x >= low && x <= high;
            }
            nPoints += returnReduce(inside.size(), sumOp<label>());
            start_[i].share(inside);

            const pointField& x = start_[i].x();
            bin_[i].setSize(x.size());
            nIn += x.size();
            forAll(x, p)
            {
                bin_[i][p] = min(nBins_ - 1, label(nBins_ * ((x[p][c] - low) / (high - low))));
                used[bin_[i][p]] = true;
            }
        }
        reduce(first, minOp<scalar>());
        reduce(last, maxOp<scalar>());

        if (!nIn)
        {
            FatalIOErrorInFunction(dict_) << "At the start no point is in the range (" << low << ' '
                                          << high << ")." << nl << nl << "They are in (" << first
                                          << ' ' << last << ")." << nl << exit(FatalIOError);
        }

        label nEmpty = 0;
        for (const bool filled : used)
        {
            nEmpty += !filled;
        }
        Info << type() << ' ' << name() << ": " << nIn << " of " << nPoints << " points in "
             << nBins_ << " bins, " << nEmpty << " of them empty" << endl;
    }

public:
    TypeName("materialPointXT");

    using materialPointOutput::materialPointOutput;
};

defineTypeNameAndDebug(materialPointXT, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointXT, dictionary);

} // End namespace Foam::functionObjects
