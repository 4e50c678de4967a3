/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointBalance

Description
    Sums over the points of each phase and of all listed phases together, to
    check conservation:

        m = sum_p m_p                                                    [kg]
        P = sum_p m_p u_p                                            [kg m/s]
        L = sum_p m_p (x_p - x_0) x u_p                             [kg m2/s]
        K = sum_p m_p u_p.u_p/2                                           [J]
        W = energy stored in the points by the phase's law                [J]

    If a phase has erosion or there is an outflow, also the sums of the points
    eroded or lost since the start (erodedPoints): with these m and P are kept.
    Of a free rigid body they are those of mass, velocity and angular momentum of
    the body (freeBody).

    In a gas also its mass, momentum and energy with what came through the
    boundaries, and gas and points together with the impulse J that they got from
    boundaries, patches with contact, gravity and rigid phases since the first row:

        rest = (P - J) - (P - J)_0                                   [kg m/s]

    which is rounding (body forces of phases are not in J). It needs every step:
    executeControl is refused in a gas. -postProcess writes the points alone.

    Directions that are not computed have no part in L. A point with damage
    greater than 0 has failed.

Usage
    \verbatim
    balance
    {
        type            materialPointBalance;
        libs            (mpmFunctionObjects);
        phases          (target flyer);
        origin          (0 0 0);
        writeControl    timeStep;
        writeInterval   1;
    }
    \endverbatim

    \table
        Property | Description             | Required | Default
        type     | materialPointBalance    | yes      |
        phases   | names of phases         | no       | all
        origin   | x_0 [m]                 | no       | (0 0 0)
    \endtable

    Files: <phase>.dat and total.dat; in a gas <gas>.dat and mixture.dat.

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "pointEnergy.H"
#include "pointErosion.H"
#include "pointContact.H"
#include "rigidBodies.H"

namespace Foam::functionObjects
{

namespace
{

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
        os << tab << nPoints << tab << mass << tabs{momentum} << tabs{angularMomentum} << tab
           << kinetic << tab << strain << tab << kinetic + strain << tab << nFailed;
        if (erodes)
        {
            os << tab << eroded.n << tab << eroded.mass << tabs{eroded.momentum} << tab
               << eroded.kinetic << tab << eroded.stored;
        }
        os << endl;
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
        s.angularMomentum += cloud.mass()[0][p] * (arm ^ cloud.velocity(p));
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

class materialPointBalance : public materialPointOutput
{
    point origin_ = Zero;
    wordList phases_;

    //- In a gas: impulse of boundaries and gravity on the points since the
    //  first row; P - J and mass less what came in of the first row
    vector impulse_ = Zero, momentum0_ = Zero;
    scalar mass0_ = 0;
    bool first_ = true;

    wordList keywords() const override { return {"phase", "phases", "origin"}; }

    void prepare(const mpm::materialPointSystem& points) override
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
                os << "Phase " << phases_[i];
            }
            else
            {
                os << "Sum of " << joined(phases_).c_str();
            }
            os << ", angular momentum about " << origin_ << nl << "\tnPoints\tmass[kg]"
               << "\tPx[kg.m/s]\tPy[kg.m/s]\tPz[kg.m/s]"
               << "\tLx[kg.m2/s]\tLy[kg.m2/s]\tLz[kg.m2/s]"
               << "\tkinetic[J]\tstrain[J]\ttotal[J]\tnFailed"
               << (points.erosion().erodes() ? "\tnEroded\terodedMass[kg]\terodedPx[kg.m/s]"
                                               "\terodedPy[kg.m/s]\terodedPz[kg.m/s]"
                                               "\terodedKinetic[J]\terodedStrain[J]"
                                             : "");
            headers[i] = os.str();
        }
        const mpm::pointCoupling* gas = points.coupling();
        if (gas && functionObject::postProcess)
        {
            WarningInFunction << "Impulses belong to time steps: " << type() << ' ' << name()
                              << " writes the points alone with -postProcess." << endl;
        }
        else if (gas)
        {
            requireEachStep(dict_, type(), "in a gas ");
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
            headers.append(
                gas->phaseName()
                + ", mass, impulse and energy through the"
                  " boundaries\n\tmass[kg]\tPx[kg.m/s]\tPy[kg.m/s]\tPz[kg.m/s]"
                  "\tenergy[J]\tmassIn[kg]\tJx[N.s]\tJy[N.s]\tJz[N.s]\tenergyIn[J]");
            files.append(word("mixture"));
            headers.append("Gas or fluids and all points, impulse of boundaries, contact, gravity"
                           " and rigid phases"
                           "\n\tmass[kg]\tmassRest[kg]\tPx[kg.m/s]\tPy[kg.m/s]\tPz[kg.m/s]"
                           "\tJx[N.s]\tJy[N.s]\tJz[N.s]\trestx[N.s]\tresty[N.s]\trestz[N.s]");
        }
        setFiles(files, headers);
    }

    void sample(const mpm::materialPointSystem& points) override
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
        if (points.coupling() && !functionObject::postProcess)
        {
            sampleGas(points);
        }
    }

    //- Rows of the gas and of the mixture
    void sampleGas(const mpm::materialPointSystem& points)
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
        if (const auto* contact = points.parts().find<mpm::pointContact>())
        {
            J -= contact->impulseOnPatches();
        }
        if (first_)
        {
            first_ = false;
            momentum0_ = P - J;
            mass0_ = mass - gas.massIn;
        }
        if (Pstream::master())
        {
            const label i = phases_.size() + 1;
            row(i) << tab << gas.mass << tabs{gas.momentum} << tab << gas.energy << tab
                   << gas.massIn << tabs{gas.boundaryImpulse} << tab << gas.boundary << endl;
            row(i + 1) << tab << mass << tab << mass - gas.massIn - mass0_ << tabs{P} << tabs{J}
                       << tabs{P - J - momentum0_} << endl;
        }
    }

public:
    TypeName("materialPointBalance");

    using materialPointOutput::materialPointOutput;

    //- Impulses of the step
    bool execute() override
    {
        const mpm::materialPointSystem& points = system();
        if (!points.coupling() || first_ || functionObject::postProcess)
        {
            return true;
        }
        scalar mass = 0;
        for (const mpm::materialPointPhase& phase : points.phases())
        {
            mass += phase.prescribed() ? 0 : phase.mass();
        }
        vector J(Zero);
        scalar dt = 0;
        for (const mpm::velocityField& field : points.fields())
        {
            const mpm::nodeReactions& reactions = *field.reactions();
            dt = reactions.dt();
            for (const mpm::nodeReactions::part& p : reactions.parts())
            {
                J += reactions.impulse(p);
            }
        }
        reduce(J, sumOp<vector>());
        impulse_ += J + mass * dt * points.g();

        return true;
    }
};

defineTypeNameAndDebug(materialPointBalance, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointBalance, dictionary);

} // End namespace Foam::functionObjects
