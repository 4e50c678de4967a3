/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointBalance.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(materialPointBalance, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        materialPointBalance,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sums of a phase
struct sums
{
    label nPoints = 0, nFailed = 0;
    scalar mass = 0, kinetic = 0, strain = 0;
    vector momentum = Zero, angularMomentum = Zero;

    void add(const sums& s)
    {
        nPoints += s.nPoints;
        nFailed += s.nFailed;
        mass += s.mass;
        kinetic += s.kinetic;
        strain += s.strain;
        momentum += s.momentum;
        angularMomentum += s.angularMomentum;
    }

    void write(Ostream& os) const
    {
        os  << tab << nPoints << tab << mass;
        for (const scalar c : momentum)
        {
            os  << tab << c;
        }
        for (const scalar c : angularMomentum)
        {
            os  << tab << c;
        }
        os  << tab << kinetic << tab << strain << tab << kinetic + strain
            << tab << nFailed << endl;
    }
};


//- Over the points of all processors
sums sumsOf(const mpm::materialPointPhase& phase, const point& origin)
{
    const mpm::materialPointCloud& cloud = phase.cloud();
    const mpm::hexGrid& grid = cloud.grid();

    sums s;
    s.nPoints = cloud.size();
    s.mass = phase.mass();
    s.momentum = phase.momentum();
    s.kinetic = phase.kineticEnergy();
    s.strain = phase.strainEnergy();

    for (label p = 0; p < cloud.size(); ++p)
    {
        vector arm(Zero);
        for (int d = 0; d < grid.nDim(); ++d)
        {
            const int c = grid.direction(d);
            arm[c] = cloud.x()[d][p] - origin[c];
        }
        s.angularMomentum += cloud.mass()[0][p]*(arm ^ cloud.velocity(p));
    }
    if (const mpm::column* damage = cloud.damage())
    {
        for (label p = 0; p < cloud.size(); ++p)
        {
            s.nFailed += (*damage)[0][p] > 0;
        }
    }
    reduce(s.nPoints, sumOp<label>());
    reduce(s.nFailed, sumOp<label>());
    reduce(s.angularMomentum, sumOp<vector>());

    return s;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::materialPointBalance::keywords() const
{
    return {"phase", "phases", "origin"};
}


void Foam::functionObjects::materialPointBalance::prepare
(
    const mpm::pointPhaseSystem& points
)
{
    origin_ = dict_.getOrDefault<point>("origin", Zero);
    phases_ = selectedPhases(points);

    wordList files(phases_);
    files.append(word("total"));

    List<string> headers(files.size());
    forAll(files, i)
    {
        OStringStream os;
        if (i < phases_.size())
        {
            os  << "Phase " << phases_[i];
        }
        else
        {
            os  << "Sum of " << joined(phases_).c_str();
        }
        os  << ", angular momentum about " << origin_ << nl
            << "\tnPoints\tmass[kg]"
            << "\tPx[kg.m/s]\tPy[kg.m/s]\tPz[kg.m/s]"
            << "\tLx[kg.m2/s]\tLy[kg.m2/s]\tLz[kg.m2/s]"
            << "\tkinetic[J]\tstrain[J]\ttotal[J]\tnFailed";
        headers[i] = os.str();
    }
    setFiles(files, headers);
}


void Foam::functionObjects::materialPointBalance::sample
(
    const mpm::pointPhaseSystem& points
)
{
    sums total;
    forAll(phases_, phasei)
    {
        const sums s(sumsOf(phase(points, phases_[phasei]), origin_));
        total.add(s);
        if (Pstream::master())
        {
            s.write(row(phasei));
        }
    }
    if (Pstream::master())
    {
        total.write(row(phases_.size()));
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::materialPointBalance::materialPointBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    materialPointOutput(name, runTime, dict),
    origin_(Zero)
{
    read(dict);
}

// ************************************************************************* //
