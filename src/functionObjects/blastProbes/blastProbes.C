/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::blastProbes

Description
    Histories of the pressure at places and, as means over the areas, on
    patches; of each a summary, from all steps of the run:

        p0       ambient: the entry, else that of the start           [Pa]
        arrival  first time of p - p0 = threshold                     [s]
        peak     max(p - p0), and its time                            [Pa, s]
        duration from the arrival to the first p - p0 = 0 after it    [s]
        I+       int max(p - p0, 0) dt until the end of the duration  [Pa s]
        I-       int min(p - p0, 0) dt                                [Pa s]
        later I+ int max(p - p0, 0) dt after that: other shocks       [Pa s]

    with p linear between steps, so that integrals are by the trapezoidal rule
    and the two times exact for that. What has not come yet is nan.

    The value at a place is that of its cell. On a face between cells: of the one
    with the nearest centre, of several such the first by coordinates, so that
    processors do not matter. In cells with more solid than fluid it is the
    pressure of the pores, which the run warns of at its start.

Usage
    \verbatim
    gauges
    {
        type            blastProbes;
        libs            (mpmFunctionObjects);
        probeLocations  ((1 0 0) (2 0 0));
        patches         (wall);
        threshold       1000;
        writeControl    timeStep;
        writeInterval   1;
    }
    \endverbatim
    \table
        Property       | Description                        | Required | Default
        type           | blastProbes                        | yes      |
        probeLocations | places [m]          | one of both |
        patches        | names of patches    | is needed   |
        field          | scalar field of the cells          | no       | p
        ambient        | p0 [Pa]                  | no | of the start
        threshold      | overpressure of the arrival [Pa]   | no | 0.01 abs(p0)
    \endtable

    A restart goes on with the probes that were there; one that is new starts then, with a
    warning, and its p0, without the entry, is the p of then.

    Files: <field>.dat, a row each writeInterval; summary.dat, a row for each
    probe, written anew at each time that the run writes and at its end.

\*---------------------------------------------------------------------------*/

#include "flowOutput.H"
#include "pointField.H"
#include "eulerianFlow.H"
#include "volFields.H"
#include "Time.H"

namespace Foam::functionObjects
{

namespace
{

//- Not yet
constexpr scalar never = -ROOTVGREAT;

//- A number that may not be there yet
void writeNumber(Ostream& os, const scalar v)
{
    os << tab;
    if (v == never)
    {
        os << "nan";
    }
    else
    {
        os << v;
    }
}

}

class blastProbes : public flowOutput
{
public:
    //- What is known of a probe
    struct history
    {
        scalar ambient = never, threshold = never, arrival = never;
        scalar peak = never, peakTime = never, end = never;
        scalar positive = 0, negative = 0, later = 0;

        //- Last time and value
        scalar t = never, p = 0;

        static constexpr label size = 11;
        scalar* begin() { return &ambient; }
        const scalar* begin() const { return &ambient; }

        //- A value of a later time
        void add(const scalar time, const scalar value)
        {
            const scalar b = value - ambient;
            scalar& up = end == never ? positive : later;
            if (b > peak)
            {
                peak = b;
                peakTime = time;
            }
            if (t == never)
            {
                arrival = b >= threshold ? time : never;
            }
            else if (time > t)
            {
                const scalar a = p - ambient, dt = time - t;
                const auto when = [&](const scalar level)
                { return t + dt * (level - a) / (b - a); };
                if (arrival == never && b >= threshold)
                {
                    arrival = when(threshold);
                }
                else if (arrival != never && end == never && b <= 0)
                {
                    end = a > 0 ? when(0) : time;
                }

                // Trapezia on both sides of zero
                if (a * b >= 0)
                {
                    (a + b > 0 ? up : negative) += 0.5 * dt * (a + b);
                }
                else
                {
                    const scalar first = dt * a / (a - b);
                    (a > 0 ? up : negative) += 0.5 * first * a;
                    (b > 0 ? up : negative) += 0.5 * (dt - first) * b;
                }
            }
            t = time;
            p = value;
        }
    };

private:
    word field_;
    pointField places_;
    wordList patches_;

    //- Cell of each place on this processor, -1: on another
    labelList cells_;

    //- Places that have been told to be in solid
    boolList inSolid_;

    List<history> histories_;

    void findCells()
    {
        // Distance to the centre, then the centre
        typedef FixedList<scalar, 4> key;
        const vectorField& C = mesh_.cellCentres();
        const auto before = [](const key& a, const key& b)
        {
            for (label d = 0; d < 4; ++d)
            {
                if (mag(a[d] - b[d]) > 1e-9 * (mag(a[0]) + mag(b[0])))
                {
                    return a[d] < b[d];
                }
            }
            return false;
        };

        cells_.setSize(places_.size());
        forAll(places_, i)
        {
            const point& x = places_[i];
            key best(VGREAT);
            label found = mesh_.findCell(x);
            const auto holds = [&](const label c)
            {
                for (const label f : mesh_.cells()[c])
                {
                    const vector& S = mesh_.faceAreas()[f];
                    const scalar out =
                        (mesh_.faceOwner()[f] == c ? 1 : -1) * ((x - mesh_.faceCentres()[f]) & S);
                    if (out > 1e-9 * mag(S) * std::cbrt(mesh_.cellVolumes()[c]))
                    {
                        return false;
                    }
                }
                return true;
            };
            if (found >= 0)
            {
                labelHashSet around;
                around.insert(found);
                for (const label pointi : mesh_.cellPoints()[found])
                {
                    around.insert(mesh_.pointCells()[pointi]);
                }
                const label first = found;
                for (const label c : around)
                {
                    if (c != first && !holds(c))
                    {
                        continue;
                    }
                    const key k{mag(x - C[c]), C[c].x(), C[c].y(), C[c].z()};
                    if (before(k, best))
                    {
                        best = k;
                        found = c;
                    }
                }
            }
            List<key> all(Pstream::nProcs(), key(VGREAT));
            all[Pstream::myProcNo()] = best;
            Pstream::gatherList(all);
            Pstream::scatterList(all);
            label owner = 0;
            forAll(all, proci)
            {
                owner = before(all[proci], all[owner]) ? proci : owner;
            }
            if (all[owner][0] == VGREAT)
            {
                const boundBox& box = mesh_.bounds();
                FatalIOErrorInFunction(dict_)
                    << "Place " << x << " of probeLocations is not in the mesh,"
                    << " which lies in " << box.min() << " to " << box.max() << "."
                    << exit(FatalIOError);
            }
            cells_[i] = owner == Pstream::myProcNo() ? found : -1;
        }
    }

    void findPatches()
    {
        const polyBoundaryMesh& patches = mesh_.boundaryMesh();
        for (const word& name : patches_)
        {
            if (patches.findPatchID(name) < 0)
            {
                DynamicList<word> valid;
                for (const polyPatch& pp : patches)
                {
                    if (!pp.coupled())
                    {
                        valid.append(pp.name());
                    }
                }
                FatalIOErrorInFunction(dict_)
                    << "Patch " << name << " is not in the mesh." << nl << nl
                    << "Valid patches are: " << flatOutput(valid) << exit(FatalIOError);
            }
        }
    }

    //- Of each place once
    void warnOfSolid()
    {
        inSolid_.setSize(places_.size(), false);
        if (!inSolid_.found(false))
        {
            return;
        }
        const auto* flow = mesh_.findObject<mpm::eulerianFlow::handle>("eulerianFlow");
        scalarField theta(places_.size(), -1);
        forAll(cells_, i)
        {
            if (flow && cells_[i] >= 0)
            {
                theta[i] = flow->flow().theta()[cells_[i]];
            }
        }
        reduce(theta, maxOp<scalarField>());
        forAll(theta, i)
        {
            if (theta[i] >= 0 && theta[i] < 0.5 && !inSolid_[i])
            {
                inSolid_[i] = true;
                WarningInFunction << name() << ": place " << places_[i] << " is in solid, "
                                  << field_ << " there is that of the pores, from " << time_.value()
                                  << " s on, its largest in summary.dat, too." << endl;
            }
        }
    }

    //- Values now, on all processors
    scalarList values() const
    {
        const volScalarField& f = mesh_.lookupObject<volScalarField>(field_);
        const label n = places_.size();
        scalarField v(n + 2 * patches_.size(), Zero);
        forAll(cells_, i)
        {
            if (cells_[i] >= 0)
            {
                v[i] = f[cells_[i]];
            }
        }
        forAll(patches_, j)
        {
            const label patchi = mesh_.boundaryMesh().findPatchID(patches_[j]);
            const scalarField& area = mesh_.magSf().boundaryField()[patchi];
            const scalarField& b = f.boundaryField()[patchi];
            forAll(b, i)
            {
                v[n + 2 * j] += area[i] * b[i];
                v[n + 2 * j + 1] += area[i];
            }
        }

        // One message of all
        Pstream::listCombineGather(v, plusEqOp<scalar>());
        Pstream::listCombineScatter(v);
        forAll(patches_, j)
        {
            v[n + j] = v[n + 2 * j] / max(v[n + 2 * j + 1], VSMALL);
        }
        v.setSize(n + patches_.size());
        return v;
    }

    void writeSummary() const
    {
        if (!writeToFile())
        {
            return;
        }
        OFstream os(folder_ / "summary.dat");
        os.precision(writePrecision_);
        os << "# At " << time_.value() << " s. Probes are places, then patches" << nl
           << "# Probe\tx[m]\ty[m]\tz[m]\tambient\tarrival[s]\tpeak"
           << "\tpeakTime[s]\tduration[s]\tpositiveImpulse\tnegativeImpulse\tlaterImpulse" << nl;
        forAll(histories_, i)
        {
            const history& h = histories_[i];
            os << i;
            for (direction d = 0; d < 3; ++d)
            {
                writeNumber(os, i < places_.size() ? places_[i][d] : never);
            }
            writeNumber(os, h.ambient);
            writeNumber(os, h.arrival);
            writeNumber(os, h.peak);
            writeNumber(os, h.peakTime);
            writeNumber(os, h.end == never ? never : h.end - h.arrival);
            writeNumber(os, h.positive);
            writeNumber(os, h.negative);
            writeNumber(os, h.later);
            os << nl;
        }
    }

    //- What tells probe i from others: its place, or the number of its patch
    vector mark(const label i) const
    {
        return i < places_.size()
            ? places_[i]
            : vector(never, never, mesh_.boundaryMesh().findPatchID(patches_[i - places_.size()]));
    }

    //- Histories of the probes that were there
    void goOn(const scalarList& kept)
    {
        constexpr label size = history::size + vector::nComponents;
        OStringStream anew;
        for (label i = 0; kept.size() && i < histories_.size(); ++i)
        {
            const vector own(mark(i));
            const scalar* found = nullptr;
            for (label j = 0; j + size <= kept.size(); j += size)
            {
                const scalar* at = kept.cdata() + j + history::size;
                found = vector(at[0], at[1], at[2]) == own ? kept.cdata() + j : found;
            }
            if (found)
            {
                std::copy(found, found + history::size, histories_[i].begin());
            }
            else if (i < places_.size())
            {
                anew << "place " << own << ", ";
            }
            else
            {
                anew << "patch " << patches_[i - places_.size()] << ", ";
            }
        }
        if (anew.str().size())
        {
            WarningInFunction << name() << " had other probes when " << time_.timeName()
                              << " was written. New are " << anew.str().c_str()
                              << "their ambient is the " << field_
                              << " of now where the entry ambient gives no other." << endl;
        }
    }

    wordList keywords() const override
    {
        return {"probeLocations", "patches", "field", "ambient", "threshold"};
    }

    void prepare(const scalarList& kept) override
    {
        field_ = dict_.getOrDefault<word>("field", "p");
        if (!mesh_.foundObject<volScalarField>(field_))
        {
            FatalIOErrorInFunction(dict_)
                << "There is no scalar field " << field_ << "." << nl << nl
                << "Valid fields are: " << flatOutput(mesh_.sortedNames<volScalarField>())
                << exit(FatalIOError);
        }
        places_ = dict_.getOrDefault<pointField>("probeLocations", pointField());
        patches_ = dict_.getOrDefault<wordList>("patches", wordList());
        if (places_.empty() && patches_.empty())
        {
            FatalIOErrorInFunction(dict_)
                << "One of the entries (probeLocations patches) is missing in " << dict_.name()
                << exit(FatalIOError);
        }
        findCells();
        findPatches();
        warnOfSolid();

        const label n = places_.size() + patches_.size();
        histories_ = List<history>(n);
        goOn(kept);
        const scalarList now(values());
        forAll(histories_, i)
        {
            history& h = histories_[i];
            if (h.t == never)
            {
                h.ambient = dict_.getOrDefault<scalar>("ambient", now[i]);
                h.threshold = dict_.found("threshold") ? mpm::positive(dict_, "threshold")
                                                       : 0.01 * mag(h.ambient);
            }
        }

        OStringStream os;
        os << "Probes: ";
        forAll(places_, i)
        {
            os << i << " at " << places_[i] << ", ";
        }
        forAll(patches_, i)
        {
            os << places_.size() + i << " patch " << patches_[i] << ", ";
        }
        os << "field " << field_ << nl << "Time[s]";
        for (label i = 0; i < n; ++i)
        {
            os << tab << i;
        }
        setFiles({field_}, {os.str()});
    }

    void see() override
    {
        const scalarList now(values());
        forAll(histories_, i)
        {
            histories_[i].add(time_.value(), now[i]);
        }
    }

    void writeRows() override
    {
        warnOfSolid();
        if (writeToFile())
        {
            Ostream& os = row(0);
            for (const history& h : histories_)
            {
                os << tab << h.p;
            }
            os << endl;
        }
        if (time_.writeTime())
        {
            writeSummary();
        }
    }

    void finish() override { writeSummary(); }

    scalarList kept() const override
    {
        constexpr label size = history::size + vector::nComponents;
        scalarList all(size * histories_.size());
        forAll(histories_, i)
        {
            const vector own(mark(i));
            for (label j = 0; j < size; ++j)
            {
                all[size * i + j] =
                    j < history::size ? histories_[i].begin()[j] : own[j - history::size];
            }
        }
        return all;
    }

public:
    TypeName("blastProbes");

    using flowOutput::flowOutput;

    void updateMesh(const mapPolyMesh&) override { findCells(); }
};

defineTypeNameAndDebug(blastProbes, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, blastProbes, dictionary);

} // End namespace Foam::functionObjects
