/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "fluidBalance.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(fluidBalance, 0);
    addToRunTimeSelectionTable(functionObject, fluidBalance, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::mpm::eulerianFlow& Foam::functionObjects::fluidBalance::flow() const
{
    return
        mesh_.lookupObject<mpm::eulerianFlow::handle>("eulerianFlow").flow();
}


Foam::scalarList Foam::functionObjects::fluidBalance::gained() const
{
    const mpm::eulerianFlow::flows& in = flow().gained();
    const label n = flow().fluidNames().size();
    scalarField s(n + 4, Zero);
    for (label k = 0; k < n; ++k)
    {
        s[k] = n == 1 ? in.mass : in.fluids.size() ? in.fluids[k] : 0;
    }
    const vector J(in.impulse + in.gravityImpulse);
    for (direction d = 0; d < 3; ++d)
    {
        s[n + d] = J[d];
    }
    s[n + 3] = in.energy + in.gravityWork + in.fixups;
    Pstream::listCombineGather(s, plusEqOp<scalar>());
    Pstream::listCombineScatter(s);
    if (before_.size())
    {
        s += before_;
    }
    return s;
}


void Foam::functionObjects::fluidBalance::prepare(const scalarList& kept)
{
    if (!mesh_.foundObject<mpm::eulerianFlow::handle>("eulerianFlow"))
    {
        FatalIOErrorInFunction(dict_)
            << type() << " " << name() << ": there is no gas and no fluid."
            << nl << "It works with materialPointFoam." << exit(FatalIOError);
    }
    mpm::eulerianFlow& flow = const_cast<mpm::eulerianFlow&>(this->flow());
    if (!flow.hasBudget())
    {
        flow.startBudget();
    }
    const wordList names(flow.fluidNames());
    const label n = names.size();
    if (first_.empty() && kept.size() == 2*(n + 4))
    {
        first_ = SubList<scalar>(kept, n + 4);
        before_ = SubList<scalar>(kept, n + 4, n + 4);
    }

    const string part
    (
        "Time[s]\tmass[kg]\tPx[kg.m/s]\tPy[kg.m/s]\tPz[kg.m/s]\tinternal[J]"
        "\tkinetic[J]\tvolume[m3]\tmassIn[kg]\tmassRest[kg]"
    );
    const string all
    (
        "\tJx[N.s]\tJy[N.s]\tJz[N.s]\tenergyIn[J]\trestx[kg.m/s]"
        "\tresty[kg.m/s]\trestz[kg.m/s]\tenergyRest[J]"
    );
    wordList files(names);
    List<string> headers(n, "Sums of a fluid\n" + part);
    if (n == 1)
    {
        headers[0] = "Sums of " + names[0] + "\n" + part + all;
    }
    else
    {
        files.append(word("total"));
        headers.append("Sums of all fluids\n" + part + all);
    }
    setFiles(files, headers);
}


void Foam::functionObjects::fluidBalance::writeRows()
{
    typedef mpm::eulerianFlow::fluidSums sums;
    const List<sums> mine(flow().fluidContents());
    const label n = mine.size();
    constexpr label width = 7;
    scalarField s(width*(n + 1), Zero);
    forAll(mine, k)
    {
        const sums& a = mine[k];
        const scalar row[width] =
        {
            a.mass, a.momentum.x(), a.momentum.y(), a.momentum.z(), a.internal,
            a.kinetic, a.volume
        };
        for (label j = 0; j < width; ++j)
        {
            s[width*k + j] = row[j];
            s[width*n + j] += row[j];
        }
    }
    Pstream::listCombineGather(s, plusEqOp<scalar>());
    Pstream::listCombineScatter(s);
    const scalarList in(gained());
    const scalar* total = s.cdata() + width*n;
    if (first_.empty())
    {
        first_.setSize(n + 4);
        for (label k = 0; k < n; ++k)
        {
            first_[k] = s[width*k] - in[k];
        }
        for (label d = 0; d < 3; ++d)
        {
            first_[n + d] = total[1 + d] - in[n + d];
        }
        first_[n + 3] = total[4] + total[5] - in[n + 3];
    }
    if (!writeToFile())
    {
        return;
    }
    scalar massIn = 0, massRest = 0;
    for (label k = 0; k <= n; ++k)
    {
        const bool whole = k == n || n == 1;
        if (k == n && n == 1)
        {
            break;
        }
        Ostream& os = row(k);
        for (label j = 0; j < width; ++j)
        {
            os  << tab << s[width*k + j];
        }
        const scalar rest = k < n ? s[width*k] - in[k] - first_[k] : massRest;
        os  << tab << (k < n ? in[k] : massIn) << tab << rest;
        massIn += k < n ? in[k] : 0;
        massRest += rest;
        if (whole)
        {
            for (label d = 0; d < 4; ++d)
            {
                os  << tab << in[n + d];
            }
            for (label d = 0; d < 3; ++d)
            {
                os  << tab << total[1 + d] - in[n + d] - first_[n + d];
            }
            os  << tab << total[4] + total[5] - in[n + 3] - first_[n + 3];
        }
        os  << endl;
    }
}


Foam::scalarList Foam::functionObjects::fluidBalance::kept() const
{
    scalarList all(first_);
    all.append(gained());
    return all;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::fluidBalance::fluidBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flowOutput(name, runTime, dict)
{
    read(dict);
}

// ************************************************************************* //
