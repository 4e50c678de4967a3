// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fractionWatch.H"
#include "cellSums.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::mpm::fractionWatch::advice(const label celli) const
{
    label worst = -1;
    scalar most = 0, growth = 1;
    forAll(points_.phases(), phasei)
    {
        materialPointPhase& phase = points_.phases()[phasei];
        materialPointCloud& cloud = phase.cloud();
        forAll(cloud.cells(), k)
        {
            if (cloud.cells()[k] != celli)
            {
                continue;
            }
            const scalar v = cellSum(cloud, k, (*cloud.gasVolume())[0]);
            if (v > most)
            {
                worst = phasei;
                most = v;
                growth = v * phase.rho() / cellSum(cloud, k, cloud.mass()[0]);
            }
        }
    }

    OStringStream os;
    if (worst < 0)
    {
        os << "No point is in the cell. Look at what the start was warned of (density of a charge,"
           << " pressures, units); a smaller maxCo and maxCoGas may help.";
        return os.str();
    }
    const materialPointPhase& phase = points_.phases()[worst];
    os << "Points of " << phase.name() << " fill " << most / fraction_.mesh().V()[celli]
       << " of the cell. ";
    if (phase.grains() && !grains_.acts(worst))
    {
        os << "Nothing keeps its grains apart. Valid choices in phase " << phase.name()
           << ": granularPressure { type JohnsonJackson;"
           << " alphaMin 0.5; alphaMax 0.65; } or a constitutiveModel with a"
           << " stress; or a smaller volumeFraction in setMaterialPointsDict.";
    }
    else if (phase.grains())
    {
        os << "Its granularPressure did not hold them: a smaller alphaMax, a"
           << " larger Fr, a smaller maxCo.";
    }
    else
    {
        os << "Their volume is " << growth << " times that of the unstressed material. ";
        if (growth < 1.05)
        {
            os << "They have not grown, so they overlap: they did from the start"
               << " (setMaterialPointsDict), or something holds some of them in which"
               << " others run: a wall in 0/U." << phase.velocityField() << " where they leave"
               << " it (slip holds the patch's normal velocity in both directions), another"
               << " body of the same velocityField. Valid choices: calculated and contact in"
               << " place of slip or fixedValue there; contact between the bodies; a"
               << " smaller maxCo.";
            return os.str();
        }
        os << "Points that have grown larger than a cell, as the"
           << " products of an explosion do, fill cells unevenly. Valid choices:"
           << " as many points per cell at the start as the volume should grow"
           << " (pointsPerCell in setMaterialPointsDict); gas of their energy"
           << " in their place (p and T." << gas_.name() << "); no gas around"
           << " them.";
    }
    return os.str();
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fractionWatch::fractionWatch(
    materialPointSystem& points, eulerianFlow& gas, const solidFraction& fraction,
    const granularForce& grains) :
    points_(points),
    gas_(gas),
    fraction_(fraction),
    grains_(grains),
    energy_(0),
    asks_(false),
    at_(-1),
    fixed_(0),
    time_(0)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fractionWatch::measureEnergy() const
{
    const int D = points_.grid().nDim();
    scalar sum = gas_.energy() - gas_.fixed().energy;
    for (const materialPointPhase& phase : points_.phases())
    {
        const materialPointCloud& cloud = phase.cloud();
        const scalar* m = cloud.mass()[0];
        for (int d = 0; d < D; ++d)
        {
            const scalar* U = cloud.U()[d];
            for (label p = 0; p < cloud.size(); ++p)
            {
                sum += 0.5 * m[p] * sqr(U[p]);
            }
        }
    }
    energy_ = returnReduce(sum, sumOp<scalar>());
}

void Foam::mpm::fractionWatch::check()
{
    // Sum of all fractions beyond which points overlap: grains keep their
    // volume; others in disorder have up to 1.25 (tests/cases/bodiesInGas)
    constexpr scalar mostGrains = 1.1, mostOthers = 1.3;

    const fvMesh& mesh = fraction_.mesh();
    asks_ = true;
    at_ = -1;
    fixed_ = gas_.fixed().energy;
    time_ = mesh.time().value();
    scalar most = mostGrains;
    for (const materialPointPhase& phase : points_.phases())
    {
        if (!phase.grains() && !phase.motion())
        {
            most = mostOthers;
        }
    }
    scalar worst = 0;
    for (const materialPointPhase& phase : points_.phases())
    {
        for (const label c : phase.cloud().cells())
        {
            const scalar over = Theta(c) - most;
            if (over > worst)
            {
                worst = over;
                at_ = c;
            }
        }
    }
    if (at_ >= 0)
    {
        OStringStream os;
        os << "Volume fractions of cell " << at_ << " at " << mesh.cellCentres()[at_]
           << " add up to " << Theta(at_) << ", time " << time_ << ". " << advice(at_).c_str();
        gas_.condemn(at_, os.str());
    }
}

bool Foam::mpm::fractionWatch::judge(const scalar fixed)
{
    // Share of the energy of all that fix-ups may have added
    constexpr scalar mostFixed = 0.1;

    const bool most = asks_ && mag(fixed) > mostFixed * energy_;
    asks_ = false;
    const label at = gas_.fixedCell();
    if (most && at_ < 0 && at >= 0)
    {
        OStringStream os;
        os << "Fix-ups have added " << fixed << " J to gas " << gas_.name()
           << "; without them it and the motion of the points had " << energy_
           << " J. The largest was in cell " << at << " at " << fraction_.mesh().cellCentres()[at]
           << ", theta " << gas_.theta()[at] << ", all fractions " << Theta(at) << "; time "
           << time_ << ". " << advice(at).c_str();
        gas_.condemn(at, os.str());
    }
    return most;
}

void Foam::mpm::fractionWatch::report() const
{
    scalar least = GREAT, most = -GREAT;
    forAll(gas_.theta(), c)
    {
        least = min(least, Theta(c));
        most = max(most, Theta(c));
    }
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());
    measureEnergy();
    Info << "Theta: min " << least << ", max " << most << endl;
}

void Foam::mpm::fractionWatch::write() const
{
    const fvMesh& mesh = fraction_.mesh();
    volScalarField field(
        IOobject(
            "Theta", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false),
        mesh, dimensionedScalar("Theta", dimless, 0));
    forAll(field, c)
    {
        field[c] = Theta(c);
    }
    field.write();
}
