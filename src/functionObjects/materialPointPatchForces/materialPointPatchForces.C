/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointPatchForces

Description
    Force and moment of the material points on patches whose condition fixes a
    velocity (fixedValue and others with a value) or its normal (slip,
    symmetry, symmetryPlane):

        F = - sum_l J_l/dt                                                [N]
        M = - sum_l (x_l - x_0) x J_l/dt                                 [N m]

    over the patch's nodes, with J_l the impulse that the condition gives to
    the material in a step (mpm::nodeReactions). Values are means over the time
    since the row before, sum J_l/sum dt: rows times their lengths add up to
    the whole impulse, however seldom they are written. A row is the mean since
    the start of the run if it is the first.

    The points' momentum obeys P(n+1) - P(n) = dt (m g - F) with F of all
    patches with a condition, to rounding.

    Patches of several velocity fields count all of them, or those listed.
    Where patches meet, a fixed velocity belongs to the first of the mesh's
    list, and each slip patch has the force along its normal. Directions that
    are not computed have no part in F and in the arm of M. The thickness of
    the mesh in these directions is the thickness that the force is for.

Usage
    \verbatim
    wallForce
    {
        type            materialPointPatchForces;
        libs            (mpmFunctionObjects);
        patches         (floor wall);
        origin          (0 0 0);
        writeControl    timeStep;
        writeInterval   10;
    }
    \endverbatim

    \table
        Property       | Description                      | Required | Default
        type           | materialPointPatchForces         | yes      |
        patches        | names of patches                 | yes      |
        velocityFields | names of velocity fields         | no       | all
        origin         | x_0 [m]                          | no       | (0 0 0)
    \endtable

    Files: <patch>.dat, and total.dat for the sum. The object must be executed
    in each step: it has no executeControl.

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "FlatOutput.H"
#include "StringStream.H"
#include "processorPolyPatch.H"

namespace Foam::functionObjects
{

class materialPointPatchForces : public materialPointOutput
{
    point origin_ = Zero;
    wordList patches_;

    //- Velocity fields by index
    labelList fields_;

    //- Index of each mesh patch in the list, or -1
    labelList place_;

    //- Impulse on each patch and its moment since the last row, and the
    //  time [N s], [N m s], [s]
    vectorField impulse_, moment_;
    scalar duration_ = 0;

    wordList keywords() const override { return {"patches", "velocityFields", "origin"}; }

    void prepare(const mpm::materialPointSystem& points) override
    {
        if (functionObject::postProcess)
        {
            WarningInFunction << "Forces on patches belong to time steps: " << type() << ' '
                              << name() << " writes nothing with -postProcess." << endl;
            fields_.clear();
            return;
        }
        requireEachStep(dict_, type());

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
                os << "Patch " << patches_[i];
            }
            else
            {
                os << "Sum of " << joined(patches_).c_str();
            }
            os << ", mean force and moment about " << origin_ << " on it since"
               << " the row before" << nl << "\tFx[N]\tFy[N]\tFz[N]\tMx[N.m]\tMy[N.m]\tMz[N.m]";
            headers[i] = os.str();
        }
        setFiles(files, headers);
    }

    void sample(const mpm::materialPointSystem& points) override
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
                os << tabs{impulse_[i] / duration_} << tabs{moment_[i] / duration_} << endl;
            }
        }
        impulse_ = vectorField(patches_.size(), Zero);
        moment_ = vectorField(patches_.size(), Zero);
        duration_ = 0;
    }

    //- Read the names of fields and patches; the names of patches with a
    //  condition
    void readFields(mpm::materialPointSystem& points)
    {
        wordList valid(points.fields().size());
        forAll(valid, fieldi)
        {
            valid[fieldi] = points.fields()[fieldi].name();
        }
        const wordList names(dict_.getOrDefault<wordList>("velocityFields", valid));

        fields_.clear();
        for (const word& name : names)
        {
            const label fieldi = valid.find(name);
            if (fieldi < 0 || fields_.found(fieldi))
            {
                FatalIOErrorInFunction(dict_)
                    << (fieldi < 0 ? "Unknown velocity field " : "Velocity field ") << name
                    << (fieldi < 0 ? "" : " is listed twice.") << nl << nl
                    << "Valid velocity fields are: " << flatOutput(valid) << nl
                    << exit(FatalIOError);
            }
            fields_.append(fieldi);
        }
        if (fields_.empty())
        {
            FatalIOErrorInFunction(dict_)
                << "The list of velocity fields is empty." << nl << nl
                << "Valid velocity fields are: " << flatOutput(valid) << nl << exit(FatalIOError);
        }
        for (const label fieldi : fields_)
        {
            points.fields()[fieldi].needReactions();
        }
    }

    void readPatches(const mpm::materialPointSystem& points)
    {
        // Patches that hold a node on any processor
        const polyBoundaryMesh& mesh = mesh_.boundaryMesh();
        labelList holds(mesh.size(), label(0));
        for (const label fieldi : fields_)
        {
            for (const mpm::nodeReactions::part& p : points.fields()[fieldi].reactions()->parts())
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

        OStringStream text;
        text << "Valid patches are: " << flatOutput(valid)
             << (valid.empty() ? ", as none fixes a velocity" : "") << nl;
        const string validPatches(text.str());

        patches_ = mpm::required<wordList>(dict_, "patches");
        if (patches_.empty())
        {
            FatalIOErrorInFunction(dict_) << "The list of patches is empty." << nl << nl
                                          << validPatches.c_str() << exit(FatalIOError);
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
                    << (patchi < 0               ? " is not in the mesh."
                            : !valid.found(name) ? " fixes no velocity: points cannot"
                                                   " push it, but by contact, whose force"
                                                   " is in the log (Contact ...)."
                                                 : " is listed twice.")
                    << nl << nl << validPatches.c_str() << exit(FatalIOError);
            }
            place_[patchi] = i;
        }
    }

public:
    TypeName("materialPointPatchForces");

    using materialPointOutput::materialPointOutput;

    //- Add the impulses of the step
    bool execute() override
    {
        const mpm::materialPointSystem& points = system();
        const mpm::pointGrid& grid = points.grid();

        for (const label fieldi : fields_)
        {
            const mpm::nodeReactions& reactions = *points.fields()[fieldi].reactions();

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
};

defineTypeNameAndDebug(materialPointPatchForces, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointPatchForces, dictionary);

} // End namespace Foam::functionObjects
