/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    compareMaterialPoints

Description
    Compares two cases, or two times of a case: all columns of the clouds by
    the points' ids, and the fields on cells and mesh points. Either may be
    decomposed, into whatever number of processors.

    For each column: the largest difference and the L2 norm, absolute and
    relative to the largest value of both cases, and which point is worst and
    where. The last line, by which -tolerance judges, is relative to the largest
    value that the field or column of that name has in any phase: U of a body at
    rest is rounding, whatever it is relative to itself. Points, columns, clouds
    and fields that one case alone has are listed. The field cellWeights of
    decomposePar counts only where -fields names it.

Usage
    \verbatim
    compareMaterialPoints serial parallel -tolerance 1e-12
    compareMaterialPoints . . -time 0.1 -time2 0.2
    compareMaterialPoints . . -processors second
    \endverbatim

    Options:
      - -time \<value\>        the time (default: the last of the first case)
      - -time2 \<value\>       of the second case (default: the same)
      - -processors \<which\>  read processor*, not the whole case: first,
                               second or both
      - -fields \<list\>       only these columns and fields
      - -tolerance \<value\>   exit status 1 if a relative largest difference
                               is above, or if one case alone has something

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "caseTime.H"
#include "difference.H"
#include "noTraps.H"
#include <cstdlib>
#include <iomanip>
#include <sstream>

using namespace Foam;
using namespace Foam::mpm;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Result of the comparison
class comparison
{
    const caseTime& a_;
    const caseTime& b_;

    //- Only these; all if empty
    const wordList only_;

    label nMissing_ = 0;

    //- Of each row its kind (U of U.plate, of a column U) and largest difference; the
    //  largest value of each kind
    DynamicList<Tuple2<word, scalar>> rows_;
    HashTable<scalar> scales_;

    //- cellWeights are no result: what decomposePar reads, in one case perhaps
    bool skip(const word& name) const
    {
        return only_.size() ? !only_.found(name) : name == "cellWeights";
    }

    void heading(const std::string& of, const std::string& unit) const
    {
        std::ostringstream os;
        os << '\n'
           << std::left << std::setw(24) << of << std::right << std::setw(10) << unit
           << std::setw(12) << "largest" << std::setw(12) << "relative" << std::setw(12) << "L2"
           << std::setw(12) << "relative"
           << "  worst at";
        Info << os.str().c_str() << nl;
    }

    void missing(const std::string& what, const bool first)
    {
        ++nMissing_;
        Info << "Only in the " << (first ? "first" : "second") << " case: " << what.c_str() << nl;
    }

    //- One row; where says the place of the worst value
    template<class Where>
    void row(const word& name, const difference& d, const Where& where)
    {
        const word kind(name.substr(0, name.find('.')));
        rows_.append(Tuple2<word, scalar>(kind, d.largest));
        scalar& scale = scales_(kind, 0);
        scale = max(scale, d.scale);

        std::ostringstream os;
        os << std::left << std::setw(24) << "  " + name << std::right << std::setw(10)
           << d.nCompared << std::setprecision(3) << std::scientific;
        for (const scalar v : {d.largest, d.relative(d.largest), d.L2, d.relative(d.L2)})
        {
            os << std::setw(12) << v;
        }
        Info << os.str().c_str();
        if (d.worst >= 0)
        {
            Info << "  " << where(d.worst).c_str();
        }
        Info << nl;
    }

    //- Ids of a cloud; fatal if one occurs twice
    labelList ids(const caseTime& c, const word& cloud) const
    {
        const caseTime::values v(c.column(cloud, "id", labelList()));
        labelList result(v.numbers.size());
        forAll(result, i)
        {
            result[i] = label(v.numbers[i]);
        }
        const label twice = difference::twice(result);
        if (twice >= 0)
        {
            FatalErrorInFunction << "Cloud " << cloud << " in " << c.path() << ", time " << c.name()
                                 << ", has two points with id " << twice << "." << exit(FatalError);
        }
        return result;
    }

    //- True if both have it
    bool both(const word& name, const std::string& what, const wordList& inA, const wordList& inB)
    {
        if (!inA.found(name) || !inB.found(name))
        {
            missing(what, inA.found(name));
            return false;
        }
        return true;
    }

    static wordList unionOf(const wordList& a, const wordList& b)
    {
        wordHashSet all(a);
        all.insert(b);
        return all.sortedToc();
    }

    static std::string text(const point& x)
    {
        std::ostringstream os;
        os << '(' << x.x() << ' ' << x.y() << ' ' << x.z() << ')';
        return os.str();
    }

public:
    comparison(const caseTime& a, const caseTime& b, const wordList& only) :
        a_(a), b_(b), only_(only)
    {
    }

    void compareCloud(const word& cloud)
    {
        const labelList idA(ids(a_, cloud)), idB(ids(b_, cloud));
        heading("cloud " + cloud, "points");

        const caseTime::values xA(a_.column(cloud, "x", idA));
        const auto where = [&](const label id)
        {
            const label at = xA.names.find(id);
            return "id " + Foam::name(id)
                + (at < 0 || xA.nComponents != 3 ? std::string()
                                                 : " "
                           + text(point(
                               xA.numbers[3 * at], xA.numbers[3 * at + 1],
                               xA.numbers[3 * at + 2])));
        };

        bool saidMissing = false;
        const wordList inA(a_.columns(cloud)), inB(b_.columns(cloud));
        for (const word& name : unionOf(inA, inB))
        {
            if (skip(name) || !both(name, "column " + name + " of " + cloud, inA, inB))
            {
                continue;
            }
            const caseTime::values a(a_.column(cloud, name, idA));
            const caseTime::values b(b_.column(cloud, name, idB));
            if (a.nComponents != b.nComponents)
            {
                missing("this type of " + name + " of " + cloud, true);
                continue;
            }
            const difference d(a, b);
            row(name, d, where);

            if (!saidMissing)
            {
                saidMissing = true;
                for (const bool first : {true, false})
                {
                    const label n = first ? d.nOnlyFirst : d.nOnlySecond;
                    if (n)
                    {
                        missing(
                            Foam::name(n) + " points of " + cloud + ", the first with id "
                                + Foam::name(first ? d.firstOnlyFirst : d.firstOnlySecond),
                            first);
                    }
                }
            }
        }
    }

    void compareFields()
    {
        const wordList inA(a_.fields()), inB(b_.fields());
        heading("fields", "values");
        for (const word& name : unionOf(inA, inB))
        {
            if (skip(name) || !both(name, "field " + name, inA, inB))
            {
                continue;
            }
            bool onCells = true, onCellsB = true;
            const caseTime::values a(a_.field(name, onCells));
            const caseTime::values b(b_.field(name, onCellsB));
            if (!a.nComponents && !b.nComponents)
            {
                continue;
            }
            if (a.nComponents != b.nComponents || onCells != onCellsB)
            {
                missing("this type of field " + name, true);
                continue;
            }
            const difference d(a, b);
            row(name, d,
                [&](const label i)
                {
                    return std::string(onCells ? "cell " : "mesh point ") + Foam::name(i) + " "
                        + text(a_.position(i, onCells));
                });
            if (d.nOnlyFirst || d.nOnlySecond)
            {
                missing(
                    Foam::name(max(d.nOnlyFirst, d.nOnlySecond)) + " values of field " + name,
                    d.nOnlyFirst > 0);
            }
        }
    }

    void compareClouds()
    {
        const wordList inA(a_.clouds()), inB(b_.clouds());
        for (const word& cloud : unionOf(inA, inB))
        {
            if (both(cloud, "cloud " + cloud, inA, inB))
            {
                compareCloud(cloud);
            }
        }
    }

    //- The last lines; false if the cases differ by more than the tolerance
    bool finish(const bool judge, const scalar tolerance) const
    {
        if (rows_.empty())
        {
            FatalErrorInFunction << "The cases have nothing in common to compare."
                                 << exit(FatalError);
        }
        scalar worst = 0;
        word of;
        for (const Tuple2<word, scalar>& r : rows_)
        {
            const scalar relative =
                r.second() > 0 ? r.second() / max(scales_[r.first()], VSMALL) : 0;
            if (relative > worst)
            {
                worst = relative;
                of = r.first();
            }
        }
        Info << nl << "Largest relative difference: " << worst;
        if (of.size())
        {
            Info << ", of " << of << ", to its largest value in any phase";
        }
        Info << nl << "Only in one case: " << nMissing_ << nl;
        const bool same = worst <= tolerance && !nMissing_;
        if (judge)
        {
            Info << (same ? "Within" : "NOT within") << " the tolerance " << tolerance << nl;
        }
        Info << endl;
        return same || !judge;
    }
};

fileName caseOf(const string& argument)
{
    fileName path(argument);
    path.toAbsolute();
    path.clean();
    return path;
}

void describe(const char* which, const caseTime& c)
{
    Info << which << ": " << c.path() << ", time " << c.name();
    if (c.decomposed())
    {
        Info << ", of " << c.nPieces() << " processors";
    }
    Info << nl;
}

}

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::addNote("Compare the material points (by id) and the fields of two cases or of"
                     " two times; each may be decomposed.");
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addArgument("first case");
    argList::addArgument("second case");
    argList::addOption(
        "time", "value", "Time to compare (default: the last one of the first case)");
    argList::addOption("time2", "value", "Time of the second case (default: that of the first)");
    argList::addOption(
        "processors", "first|second|both",
        "Read the processor folders of this case, even if the whole case has"
        " the time");
    argList::addOption("fields", "list", "Only these columns and fields, e.g. '(x U sigma)'");
    argList::addOption(
        "tolerance", "value",
        "Exit status 1 if a largest difference relative to the field's maximum"
        " is above this, or if one case alone has something");
    const argList args(argc, argv);

    const word processors(args.getOrDefault<word>("processors", "none"));
    if (!wordList({"none", "first", "second", "both"}).found(processors))
    {
        FatalErrorInFunction << "Unknown -processors " << processors << nl
                             << "Valid choices are: first second both" << exit(FatalError);
    }
    const scalar tolerance = args.getOrDefault<scalar>("tolerance", 0);
    if (tolerance < 0)
    {
        FatalErrorInFunction << "The tolerance " << tolerance << " must not be negative."
                             << exit(FatalError);
    }

    // Differences of what is not finite are what one looks for
    const noTraps guard;

    const caseTime a(
        caseOf(args[1]), !args.found("time"), args.getOrDefault<scalar>("time", 0),
        processors == "first" || processors == "both");
    const caseTime b(
        caseOf(args[2]), false, args.getOrDefault<scalar>("time2", a.value()),
        processors == "second" || processors == "both");
    describe("First ", a);
    describe("Second", b);

    wordList only;
    args.readListIfPresent("fields", only);

    comparison c(a, b, only);
    c.compareClouds();
    c.compareFields();

    // Not by return: at its end argList exits with 0 in some versions
    std::exit(c.finish(args.found("tolerance"), tolerance) ? 0 : 1);
}
