/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointProbes.H"
#include "pointErosion.H"
#include "FlatOutput.H"
#include "addToRunTimeSelectionTable.H"
#include "pointQuantity.H"
#include "dictionaryTools.H"
#include <algorithm>
#include <limits>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(materialPointProbes, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        materialPointProbes,
        dictionary
    );
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::materialPointProbes::keywords() const
{
    return {"phase", "fields", "points", "operation"};
}


void Foam::functionObjects::materialPointProbes::prepare
(
    const mpm::materialPointSystem& points
)
{
    phase_ = dict_.get<word>("phase");
    selectedPhases(points);
    const mpm::materialPointPhase& material = phase(points, phase_);

    fields_ = dict_.get<wordList>("fields");
    if (fields_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "The list of fields is empty." << nl << nl
            << "Valid fields are: "
            << flatOutput(mpm::pointQuantity::names(material)) << nl
            << exit(FatalIOError);
    }

    const dictionary& pointsDict = dict_.subDict("points");
    operation_ = mpm::oneOfOrDefault
    (
        dict_,
        "operation",
        pointsDict.found("box") ? "mean" : "none",
        {"none", "mean", "min", "max"}
    );

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
        const mpm::pointQuantity q
        (
            dict_,
            material,
            fields_[fieldi],
            start_ ? &*start_ : nullptr
        );
        OStringStream os;
        os  << "Phase " << phase_ << ", "
            << (each ? "" : (operation_ + " of ").c_str())
            << id_.size() << " points" << nl;
        for (label i = 0; start_ && i < (each ? id_.size() : 0); ++i)
        {
            os  << "Point " << id_[i] << " was at "
                << start_->x()[start_->find(id_[i])] << " at time "
                << start_->time() << nl;
        }
        for (label i = 0; i < (each ? id_.size() : 1); ++i)
        {
            for (const word& title : q.titles())
            {
                os  << tab << title.c_str();
                if (each)
                {
                    os  << '(' << id_[i] << ')';
                }
                os  << q.unit().c_str();
            }
        }
        headers[fieldi] = os.str();
    }
    setFiles(fields_, headers);

    Info<< type() << ' ' << name() << ": " << id_.size() << " points of "
        << phase_ << endl;
}


void Foam::functionObjects::materialPointProbes::shareStart()
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


void Foam::functionObjects::materialPointProbes::writeRow
(
    Ostream& os,
    const int n,
    const UList<scalar>& values,
    const UList<scalar>& V
) const
{
    // A volume of 0: eroded
    const scalar none = std::numeric_limits<scalar>::quiet_NaN();
    if (operation_ == "none")
    {
        forAll(V, i)
        {
            for (int c = 0; c < n; ++c)
            {
                os  << tab << (V[i] > 0 ? values[n*i + c] : none);
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
                const scalar v = values[n*i + c];
                const bool first = !(volume > 0);
                sum += V[i]*v;
                volume += V[i];
                if
                (
                    V[i] > 0
                 && (
                        first
                     || (operation_ == "min" ? v < result : v > result)
                    )
                )
                {
                    result = v;
                }
            }
            if (operation_ == "mean" && volume > 0)
            {
                result = sum/volume;
            }
            os  << tab << result;
        }
    }
    os  << endl;
}


void Foam::functionObjects::materialPointProbes::sample
(
    const mpm::materialPointSystem& points
)
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
        FatalErrorInFunction
            << type() << ' ' << name() << ": point " << id_[found.find(0)]
            << " of " << phase_ << " is no longer there." << exit(FatalError);
    }
    Pstream::listCombineGather(V, plusEqOp<scalar>());

    forAll(fields_, fieldi)
    {
        const mpm::pointQuantity q
        (
            dict_,
            material,
            fields_[fieldi],
            start_ ? &*start_ : nullptr
        );
        // One processor has a point; the others add zero. The master works in
        // the order of the list, whatever processors hold the points
        const int n = q.size();
        scalarField values(n*place.size(), Zero);
        forAll(place, i)
        {
            if (place[i] >= 0)
            {
                scalar v[mpm::pointQuantity::maxSize];
                q.get(place[i], v);
                std::copy_n(v, n, &values[n*i]);
            }
        }
        Pstream::listCombineGather(values, plusEqOp<scalar>());
        if (Pstream::master())
        {
            writeRow(row(fieldi), n, values, V);
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::materialPointProbes::materialPointProbes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    materialPointOutput(name, runTime, dict)
{
    read(dict);
}

// ************************************************************************* //
