/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointPatchForces.H"
#include "addToRunTimeSelectionTable.H"
#include "FlatOutput.H"
#include "dictionaryTools.H"
#include "processorPolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(materialPointPatchForces, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        materialPointPatchForces,
        dictionary
    );
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::materialPointPatchForces::keywords() const
{
    return {"patches", "velocityFields", "origin"};
}


void Foam::functionObjects::materialPointPatchForces::readFields
(
    mpm::materialPointSystem& points
)
{
    wordList valid(points.fields().size());
    forAll(valid, fieldi)
    {
        valid[fieldi] = points.fields()[fieldi].name();
    }
    const wordList names
    (
        dict_.getOrDefault<wordList>("velocityFields", valid)
    );

    fields_.clear();
    for (const word& name : names)
    {
        const label fieldi = valid.find(name);
        if (fieldi < 0 || fields_.found(fieldi))
        {
            FatalIOErrorInFunction(dict_)
                << (fieldi < 0 ? "Unknown velocity field " : "Velocity field ")
                << name << (fieldi < 0 ? "" : " is listed twice.") << nl << nl
                << "Valid velocity fields are: " << flatOutput(valid) << nl
                << exit(FatalIOError);
        }
        fields_.append(fieldi);
    }
    if (fields_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "The list of velocity fields is empty." << nl << nl
            << "Valid velocity fields are: " << flatOutput(valid) << nl
            << exit(FatalIOError);
    }
    for (const label fieldi : fields_)
    {
        points.fields()[fieldi].needReactions();
    }
}


void Foam::functionObjects::materialPointPatchForces::readPatches
(
    const mpm::materialPointSystem& points
)
{
    // Patches that hold a node on any processor
    const polyBoundaryMesh& mesh = mesh_.boundaryMesh();
    labelList holds(mesh.size(), label(0));
    for (const label fieldi : fields_)
    {
        for
        (
            const mpm::nodeReactions::part& p :
            points.fields()[fieldi].reactions()->parts()
        )
        {
            holds[p.patch] = 1;
        }
    }
    DynamicList<word> valid;
    forAll(mesh, patchi)
    {
        // Processor patches come last and are not the same everywhere
        if (!isA<processorPolyPatch>(mesh[patchi]))
        {
            if (returnReduce(holds[patchi], maxOp<label>()))
            {
                valid.append(mesh[patchi].name());
            }
        }
    }

    patches_ = mpm::required<wordList>(dict_, "patches");
    if (patches_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "The list of patches is empty." << nl << nl
            << "Valid patches are: " << flatOutput(valid) << nl
            << exit(FatalIOError);
    }
    place_ = labelList(mesh.size(), label(-1));
    forAll(patches_, i)
    {
        const word& name = patches_[i];
        const label patchi = mesh.findPatchID(name);
        if (!valid.found(name) || place_[patchi] >= 0)
        {
            FatalIOErrorInFunction(dict_)
                << "Patch " << name
                <<
                (
                    patchi < 0 ? " is not in the mesh."
                  : !valid.found(name) ? " fixes no velocity: points cannot"
                    " push it."
                  : " is listed twice."
                )
                << nl << nl << "Valid patches are: " << flatOutput(valid) << nl
                << exit(FatalIOError);
        }
        place_[patchi] = i;
    }
}


void Foam::functionObjects::materialPointPatchForces::prepare
(
    const mpm::materialPointSystem& points
)
{
    if (functionObject::postProcess)
    {
        WarningInFunction
            << "Forces on patches belong to time steps: " << type() << ' '
            << name() << " writes nothing with -postProcess." << endl;
        fields_.clear();
        return;
    }
    for (const word& key : wordList({"executeControl", "executeInterval"}))
    {
        if (dict_.found(key))
        {
            FatalIOErrorInFunction(dict_)
                << "Remove " << key << ": " << type() << " must see each step;"
                << " writeControl and writeInterval set when it writes."
                << exit(FatalIOError);
        }
    }

    origin_ = dict_.getOrDefault<point>("origin", Zero);

    // Reactions are kept from now on
    readFields(*mesh_.getObjectPtr<mpm::materialPointSystem>(points.name()));
    readPatches(points);

    impulse_ = vectorField(patches_.size(), Zero);
    moment_ = vectorField(patches_.size(), Zero);
    duration_ = 0;

    wordList files(patches_);
    files.append(word("total"));
    List<string> headers(files.size());
    forAll(files, i)
    {
        OStringStream os;
        if (i < patches_.size())
        {
            os  << "Patch " << patches_[i];
        }
        else
        {
            os  << "Sum of " << joined(patches_).c_str();
        }
        os  << ", mean force and moment about " << origin_ << " on it since"
            << " the row before" << nl
            << "\tFx[N]\tFy[N]\tFz[N]\tMx[N.m]\tMy[N.m]\tMz[N.m]";
        headers[i] = os.str();
    }
    setFiles(files, headers);
}


void Foam::functionObjects::materialPointPatchForces::sample
(
    const mpm::materialPointSystem& points
)
{
    Pstream::listCombineGather(impulse_, plusEqOp<vector>());
    Pstream::listCombineGather(moment_, plusEqOp<vector>());

    if (Pstream::master() && duration_ > 0)
    {
        impulse_.append(sum(impulse_));
        moment_.append(sum(moment_));
        forAll(impulse_, i)
        {
            Ostream& os = row(i);
            for (const vector& v : {impulse_[i], moment_[i]})
            {
                for (const scalar c : v)
                {
                    os  << tab << c/duration_;
                }
            }
            os  << endl;
        }
    }
    impulse_ = vectorField(patches_.size(), Zero);
    moment_ = vectorField(patches_.size(), Zero);
    duration_ = 0;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::materialPointPatchForces::materialPointPatchForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    materialPointOutput(name, runTime, dict),
    origin_(Zero),
    duration_(0)
{
    read(dict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::materialPointPatchForces::execute()
{
    const mpm::materialPointSystem& points = system();
    const mpm::pointGrid& grid = points.grid();

    for (const label fieldi : fields_)
    {
        const mpm::nodeReactions& reactions =
            *points.fields()[fieldi].reactions();

        for (const mpm::nodeReactions::part& p : reactions.parts())
        {
            const label i = place_[p.patch];
            if (i < 0)
            {
                continue;
            }
            vector arm(Zero);
            for (int d = 0; d < grid.nDim(); ++d)
            {
                const int c = grid.direction(d);
                arm[c] = p.x[c] - origin_[c];
            }
            // The wall gets the opposite of what the material gets
            const vector J(-reactions.impulse(p));
            impulse_[i] += J;
            moment_[i] += arm ^ J;
        }
    }
    if (fields_.size())
    {
        duration_ += points.fields()[fields_[0]].reactions()->dt();
    }

    return true;
}

// ************************************************************************* //
