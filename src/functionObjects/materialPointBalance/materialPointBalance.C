/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointBalance.H"
#include "pointEnergy.H"
#include "pointErosion.H"
#include "rigidBodies.H"
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
    mpm::erodedPoints eroded;

    void add(const sums& s)
    {
        nPoints += s.nPoints;
        nFailed += s.nFailed;
        mass += s.mass;
        kinetic += s.kinetic;
        strain += s.strain;
        momentum += s.momentum;
        angularMomentum += s.angularMomentum;
        eroded += s.eroded;
    }

    void write(Ostream& os, const bool erodes) const
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
            << tab << nFailed;
        if (erodes)
        {
            os  << tab << eroded.n << tab << eroded.mass;
            for (const scalar c : eroded.momentum)
            {
                os  << tab << c;
            }
            os  << tab << eroded.kinetic << tab << eroded.stored;
        }
        os  << endl;
    }
};


//- Over the points of all processors
sums sumsOf(const mpm::materialPointPhase& phase, const point& origin)
{
    const mpm::materialPointCloud& cloud = phase.cloud();
    const mpm::pointGrid& grid = cloud.grid();

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
            s.nFailed += (*damage)[0][p] >= 1;
        }
    }
    reduce(s.nPoints, sumOp<label>());
    reduce(s.nFailed, sumOp<label>());
    reduce(s.angularMomentum, sumOp<vector>());
    if (phase.motion() && phase.motion()->free())
    {
        s.angularMomentum = phase.motion()->free()->angularMomentum(origin);
    }

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
    const mpm::materialPointSystem& points
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
            << "\tkinetic[J]\tstrain[J]\ttotal[J]\tnFailed"
            << (
                   points.erosion().erodes()
                 ? "\tnEroded\terodedMass[kg]\terodedPx[kg.m/s]"
                   "\terodedPy[kg.m/s]\terodedPz[kg.m/s]"
                   "\terodedKinetic[J]\terodedStrain[J]"
                 : ""
               );
        headers[i] = os.str();
    }
    if (const mpm::pointCoupling* gas = points.coupling())
    {
        for (const word& key : wordList({"executeControl", "executeInterval"}))
        {
            if (dict_.found(key))
            {
                FatalIOErrorInFunction(dict_)
                    << "Remove " << key << ": in a gas " << type()
                    << " must see each step; writeControl and writeInterval"
                    << " set when it writes." << exit(FatalIOError);
            }
        }
        mpm::materialPointSystem& system =
            *mesh_.getObjectPtr<mpm::materialPointSystem>(points.name());
        for (mpm::velocityField& field : system.fields())
        {
            field.needReactions();
        }
        if (!points.energy().active())
        {
            points.coupling()->startBudget();
        }
        first_ = true;
        impulse_ = Zero;

        files.append(gas->phaseName());
        headers.append
        (
            "Gas " + gas->phaseName() + ", mass, impulse and energy through the"
            " boundaries\n\tmass[kg]\tPx[kg.m/s]\tPy[kg.m/s]\tPz[kg.m/s]"
            "\tenergy[J]\tmassIn[kg]\tJx[N.s]\tJy[N.s]\tJz[N.s]\tenergyIn[J]"
        );
        files.append(word("mixture"));
        headers.append
        (
            "Gas and all points, impulse of boundaries, gravity and rigid phases"
            "\n\tmass[kg]\tmassRest[kg]\tPx[kg.m/s]\tPy[kg.m/s]\tPz[kg.m/s]"
            "\tJx[N.s]\tJy[N.s]\tJz[N.s]\trestx[N.s]\tresty[N.s]\trestz[N.s]"
        );
    }
    setFiles(files, headers);
}


bool Foam::functionObjects::materialPointBalance::execute()
{
    const mpm::materialPointSystem& points = system();
    if (!points.coupling() || first_)
    {
        return true;
    }
    scalar mass = 0;
    for (const mpm::materialPointPhase& phase : points.phases())
    {
        mass += phase.prescribed() ? 0 : phase.mass();
    }
    vector J(Zero);
    for (const mpm::velocityField& field : points.fields())
    {
        const mpm::nodeReactions& reactions = *field.reactions();
        for (const mpm::nodeReactions::part& p : reactions.parts())
        {
            J += reactions.impulse(p);
        }
    }
    reduce(J, sumOp<vector>());
    impulse_ += J + mass*points.deltaT()*points.g();

    return true;
}


void Foam::functionObjects::materialPointBalance::sampleGas
(
    const mpm::materialPointSystem& points
)
{
    const mpm::gasBudget gas(points.coupling()->balance());
    scalar mass = gas.mass;
    vector P(gas.momentum);
    vector J(gas.boundaryImpulse + gas.gravityImpulse + impulse_);
    forAll(points.phases(), phasei)
    {
        const mpm::materialPointPhase& phase = points.phases()[phasei];
        if (phase.prescribed())
        {
            J -= points.rigid().impulse(phasei);
        }
        else
        {
            mass += phase.mass();
            P += phase.momentum();
        }
    }
    if (first_)
    {
        first_ = false;
        momentum0_ = P - J;
        mass0_ = mass - gas.massIn;
    }
    if (Pstream::master())
    {
        const auto write = [](Ostream& os, const vector& v)
        {
            for (const scalar c : v)
            {
                os  << tab << c;
            }
        };
        const label i = phases_.size() + 1;
        {
            Ostream& os = row(i);
            os  << tab << gas.mass;
            write(os, gas.momentum);
            os  << tab << gas.energy << tab << gas.massIn;
            write(os, gas.boundaryImpulse);
            os  << tab << gas.boundary << endl;
        }
        Ostream& os = row(i + 1);
        os  << tab << mass << tab << mass - gas.massIn - mass0_;
        write(os, P);
        write(os, J);
        write(os, P - J - momentum0_);
        os  << endl;
    }
}


void Foam::functionObjects::materialPointBalance::sample
(
    const mpm::materialPointSystem& points
)
{
    sums total;
    forAll(phases_, phasei)
    {
        sums s(sumsOf(phase(points, phases_[phasei]), origin_));
        s.eroded = points.erosion().eroded(points.indexOf(phases_[phasei]));
        total.add(s);
        if (Pstream::master())
        {
            s.write(row(phasei), points.erosion().erodes());
        }
    }
    if (Pstream::master())
    {
        total.write(row(phases_.size()), points.erosion().erodes());
    }
    if (points.coupling())
    {
        sampleGas(points);
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
    origin_(Zero),
    impulse_(Zero),
    momentum0_(Zero),
    mass0_(0),
    first_(true)
{
    read(dict);
}

// ************************************************************************* //
