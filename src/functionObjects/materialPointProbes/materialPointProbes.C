/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointProbes.H"
#include "FlatOutput.H"
#include "addToRunTimeSelectionTable.H"
#include "pointQuantity.H"
#include "selector.H"

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
    const mpm::pointPhaseSystem& points
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
    select(material, pointsDict);

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


void Foam::functionObjects::materialPointProbes::sample
(
    const mpm::pointPhaseSystem& points
)
{
    const mpm::materialPointPhase& material = phase(points, phase_);
    const mpm::materialPointCloud& cloud = material.cloud();

    // Points are sorted by cell in each step
    labelList place(id_.size(), label(-1));
    for (label p = 0; p < cloud.size(); ++p)
    {
        const label i = table_[label(cloud.id()[0][p])];
        if (i >= 0)
        {
            place[i] = p;
        }
    }
    if (place.found(-1))
    {
        FatalErrorInFunction
            << type() << ' ' << name() << ": point " << id_[place.find(-1)]
            << " of " << phase_ << " is no longer there." << exit(FatalError);
    }

    forAll(fields_, fieldi)
    {
        const mpm::pointQuantity q
        (
            dict_,
            material,
            fields_[fieldi],
            start_ ? &*start_ : nullptr
        );
        scalar v[mpm::pointQuantity::maxSize];
        scalar result[mpm::pointQuantity::maxSize] = {};
        scalar volume = 0;

        Ostream& os = row(fieldi);
        forAll(place, i)
        {
            q.get(place[i], v);
            const scalar V = cloud.volume()[0][place[i]];
            volume += V;
            for (int c = 0; c < q.size(); ++c)
            {
                if (operation_ == "none")
                {
                    os  << tab << v[c];
                }
                else if (operation_ == "mean")
                {
                    result[c] += V*v[c];
                }
                else if
                (
                    i == 0
                 || (operation_ == "min" ? v[c] < result[c] : v[c] > result[c])
                )
                {
                    result[c] = v[c];
                }
            }
        }
        for (int c = 0; operation_ != "none" && c < q.size(); ++c)
        {
            os  << tab << (operation_ == "mean" ? result[c]/volume : result[c]);
        }
        os  << endl;
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
