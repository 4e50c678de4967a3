/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::fluidHeight

Description
    Height of one of several fluids in vertical lines through the mesh: wave
    gauges. With s along the line, upwards, s = 0 at the place, alpha the share
    of the cell, and s_top where the line leaves the mesh:

        depth = int alpha_k ds                                            [m]
        level = s_top - int sum_(j lighter than k) alpha_j ds             [m]

    depth is what there is of the fluid, drops and what is under an overhang, too.
    level is its surface, of the place: lighter fluids are counted from the top down,
    so that what is beneath, heavier fluids or ground of points or of mesh, does not
    matter, but solid above the surface counts as fluid. Lighter by the mean density in
    the mesh now. Without solid, drops and bubbles the
    two differ by the depth of the place.

    Cells are cut exactly by the line (convex ones). Of a line between cells it is
    the mean of both sides. In 2D the place may lie anywhere through the thickness.

Usage
    \verbatim
    waves
    {
        type            fluidHeight;
        libs            (mpmFunctionObjects);
        fluid           water;
        probeLocations  ((1 0 0) (2 0 0));
        writeControl    timeStep;
        writeInterval   1;
    }
    \endverbatim
    \table
        Property       | Description                          | Required | Default
        type           | fluidHeight                          | yes      |
        fluid          | name of the phase                    | yes      |
        probeLocations | a place on each line [m]             | yes      |
        direction      | upwards       | without gravity yes | against gravity
    \endtable

    Files: depth.dat and level.dat, a column for each line.

\*---------------------------------------------------------------------------*/

#include "flowOutput.H"
#include "eulerianFlow.H"
#include "MinMax.H"
#include "pointField.H"
#include "volFields.H"

namespace Foam::functionObjects
{

class fluidHeight : public flowOutput
{
    //- Part of a line in a cell of this processor
    struct part
    {
        label line, cell;
        scalar length;
    };

    word fluid_;
    pointField places_;
    vector up_;
    DynamicList<part> parts_;

    //- s_top of each line
    scalarField top_;

    //- Where the line x + s up is in a cell, by the planes of its faces
    scalarMinMax within(const label c, const point& x) const
    {
        scalarMinMax s(-GREAT, GREAT);
        for (const label f : mesh_.cells()[c])
        {
            const vector S((mesh_.faceOwner()[f] == c ? 1 : -1) * mesh_.faceAreas()[f]);
            const scalar along = S & up_, out = S & (x - mesh_.faceCentres()[f]);
            if (mag(along) > 1e-12 * mag(S))
            {
                along > 0 ? s.max() = min(s.max(), -out / along)
                          : s.min() = max(s.min(), -out / along);
            }
            else if (out > 0)
            {
                return scalarMinMax(0, 0);
            }
        }
        return s;
    }

    void findCells()
    {
        // On four sides of the place, of which those outside count nothing
        const vector axis(mag(up_.x()) < 0.9 ? vector(1, 0, 0) : vector(0, 1, 0));
        const vector across(normalised(up_ ^ axis)), third(up_ ^ across);
        const scalar aside = 1e-7 * mesh_.bounds().mag();
        constexpr label nSides = 4;
        scalarField length(nSides * places_.size(), Zero), top(length.size(), -GREAT);
        List<DynamicList<part>> found(length.size());
        forAll(length, i)
        {
            point x(places_[i / nSides]);
            x += aside * ((i & 1 ? 1 : -1) * across + (i & 2 ? 0.7 : -0.7) * third);
            for (direction d = 0; d < 3; ++d)
            {
                x[d] = mesh_.geometricD()[d] < 0 ? mesh_.bounds().centre()[d] : x[d];
            }
            forAll(mesh_.cells(), c)
            {
                const scalarMinMax s(within(c, x));
                if (s.max() > s.min())
                {
                    found[i].append(part{i / nSides, c, s.max() - s.min()});
                    length[i] += s.max() - s.min();
                    top[i] = max(top[i], s.max());
                }
            }
        }
        reduce(length, sumOp<scalarField>());
        reduce(top, maxOp<scalarField>());

        parts_.clear();
        top_ = scalarField(places_.size(), Zero);
        forAll(places_, line)
        {
            label n = 0;
            for (label i = nSides * line; i < nSides * (line + 1); ++i)
            {
                n += length[i] > 0;
                top_[line] += length[i] > 0 ? top[i] : 0;
            }
            if (n == 0)
            {
                const boundBox& box = mesh_.bounds();
                FatalIOErrorInFunction(dict_)
                    << "The line through place " << places_[line] << " of probeLocations along "
                    << up_ << " does not meet the mesh, which lies in " << box.min() << " to "
                    << box.max() << "." << exit(FatalIOError);
            }
            top_[line] /= n;
            for (label i = nSides * line; i < nSides * (line + 1); ++i)
            {
                for (const part& p : found[i])
                {
                    parts_.append(part{p.line, p.cell, p.length / n});
                }
            }
        }
    }

    wordList keywords() const override { return {"fluid", "probeLocations", "direction"}; }

    void prepare(const scalarList&) override
    {
        const auto* handle = mesh_.findObject<mpm::eulerianFlow::handle>("eulerianFlow");
        const wordList names(handle ? handle->flow().fluidNames() : wordList());
        if (names.size() < 2)
        {
            FatalIOErrorInFunction(dict_)
                << type() << ' ' << name() << " needs phases of type fluid, two or more: there "
                << (names.empty() ? "is no gas and no fluid." : "is one.") << exit(FatalIOError);
        }
        fluid_ = mpm::oneOf(dict_, "fluid", names);
        mpm::requireKeyword(dict_, "probeLocations");
        places_ = dict_.get<pointField>("probeLocations");
        up_ = dict_.getOrDefault<vector>("direction", -handle->flow().g());
        if (places_.empty() || !(mag(up_) > 0))
        {
            FatalIOErrorInFunction(dict_)
                << (places_.empty() ? "Entry probeLocations has no place."
                        : dict_.found("direction")
                        ? "Entry direction must not be zero."
                        : "Entry direction is missing: there is no gravity that says what is up.")
                << exit(FatalIOError);
        }
        up_ = up_ / mag(up_) + vector::zero; // no -0

        // Places may lie in the ground, but above or below all of the mesh is a wrong unit
        const scalarField along(mesh_.bounds().points()() & up_);
        const scalar low = min(along), high = max(along), tol = 1e-6 * (high - low);
        for (const point& x : places_)
        {
            if ((x & up_) < low - tol || (x & up_) > high + tol)
            {
                FatalIOErrorInFunction(dict_)
                    << "Place " << x << " of probeLocations is " << (x & up_) << " m along " << up_
                    << ", where the mesh goes from " << low << " to " << high
                    << " m. Places are in m." << exit(FatalIOError);
            }
        }
        findCells();

        OStringStream os;
        os << "Probes: ";
        forAll(places_, i)
        {
            os << i << " at " << places_[i] << ", ";
        }
        const string head(os.str());
        string columns("\nTime[s]");
        forAll(places_, i)
        {
            columns += '\t' + Foam::name(i);
        }
        setFiles(
            {"depth", "level"}, {head + "field depth" + columns, head + "field level" + columns});
    }

    void see() override {}

    void writeRows() override
    {
        const mpm::eulerianFlow& flow =
            mesh_.lookupObject<mpm::eulerianFlow::handle>("eulerianFlow").flow();
        const wordList names(flow.fluidNames());
        const auto sums(flow.fluidContents());
        scalarField mass(names.size()), volume(names.size());
        forAll(names, k)
        {
            mass[k] = sums[k].mass;
            volume[k] = sums[k].volume;
        }
        reduce(mass, sumOp<scalarField>());
        reduce(volume, sumOp<scalarField>());

        // The fluid, the lighter ones
        const label n = places_.size(), own = names.find(fluid_);
        scalarField of(2 * n, Zero);
        forAll(names, j)
        {
            if (j != own && !(mass[j] * volume[own] < mass[own] * volume[j]))
            {
                continue;
            }
            const word& k = names[j];
            const auto& alpha = mesh_.lookupObject<volScalarField>(IOobject::groupName("alpha", k));
            for (const part& p : parts_)
            {
                of[p.line + (k == fluid_ ? 0 : n)] += p.length * alpha[p.cell];
            }
        }
        reduce(of, sumOp<scalarField>());
        if (writeToFile())
        {
            for (label filei = 0; filei < 2; ++filei)
            {
                Ostream& os = row(filei);
                forAll(places_, i)
                {
                    os << tab << (filei ? top_[i] - of[n + i] : of[i]);
                }
                os << endl;
            }
        }
    }

    scalarList kept() const override { return {}; }

public:
    TypeName("fluidHeight");

    using flowOutput::flowOutput;

    void updateMesh(const mapPolyMesh&) override { findCells(); }
};

defineTypeNameAndDebug(fluidHeight, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, fluidHeight, dictionary);

} // End namespace Foam::functionObjects
