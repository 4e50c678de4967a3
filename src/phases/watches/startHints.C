// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "startHints.H"
#include "phaseNames.H"
#include "dictionaryTools.H"
#include "Time.H"
#include "IFstream.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Do regions of setMaterialPointsDict fill a phase with the rho of its law?
//  What is wrong in the file setMaterialPoints says
bool filledWithRho(const fileName& file, const word& phase)
{
    if (!isFile(file))
    {
        return false;
    }
    bool filled = false, own = false;
    const bool threw = FatalIOError.throwExceptions();
    try
    {
        IFstream is(file);
        const dictionary dict(is);
        for (const entry& e : dict.subOrEmptyDict("regions"))
        {
            if (e.isDict() && e.dict().getOrDefault<word>("phase", "") == phase)
            {
                filled = true;
                own = own || e.dict().found("density");
            }
        }
    }
    catch (const Foam::error&)
    {
        filled = false;
    }
    FatalIOError.throwExceptions(threw);
    return filled && !own;
}

//- Mass [kg] and centre of mass [m] of the points of a velocity field
scalar
centreOfMass(const PtrList<mpm::materialPointPhase>& phases, const word& field, point& centre)
{
    scalar mass = 0;
    centre = Zero;
    for (const mpm::materialPointPhase& phase : phases)
    {
        const mpm::materialPointCloud& cloud = phase.cloud();
        forAll(cloud.cells(), k)
        {
            for (label p = cloud.start()[k];
                 phase.velocityField() == field && p < cloud.start()[k + 1]; ++p)
            {
                mass += cloud.mass()[0][p];
                centre += cloud.mass()[0][p] * cloud.position(p, cloud.cells()[k]);
            }
        }
    }
    reduce(mass, sumOp<scalar>());
    reduce(centre, sumOp<vector>());
    centre /= max(mass, VSMALL);
    return mass;
}

//- The first modulus of a law: "E 70 Pa", or "its moduli"
std::string modulus(const dictionary& law)
{
    for (const word key : {"E", "K", "G", "mu", "K0", "Ks"})
    {
        scalar value;
        if (law.readIfPresent(key, value))
        {
            return key + ' ' + Foam::name(value) + " Pa";
        }
    }
    return "its moduli";
}

//- Warn of a strength that is probably one in MPa: below 1e-6 of the modulus
void warnOfStrength(const mpm::materialPointPhase& phase, const dictionary& dict, const word& key)
{
    scalar value;
    const scalar E = phase.law().elasticModulus();
    if (dict.readIfPresent(key, value) && value > 0 && value < 1e-6 * E)
    {
        IOWarningInFunction(dict) << "Entry " << key << " of phase " << phase.name() << " is "
                                  << value << " Pa, " << value / E << " of its modulus " << E
                                  << " Pa: no matter"
                                  << " is that weak. In MPa it needs e6: 400e6 for 400 MPa."
                                  << endl;
    }
}

//- Warn of a number between 0 and the least that matter has
void warnOfLeast(
    const mpm::materialPointPhase& phase, const dictionary& dict, const word& key,
    const scalar least, const char* words)
{
    scalar value;
    if (dict.readIfPresent(key, value) && value > 0 && value < least)
    {
        IOWarningInFunction(dict) << "Entry " << key << " of phase " << phase.name() << " is "
                                  << value << ": " << words << endl;
    }
}

//- Warn of temperatures of Johnson and Cook's law and damage that differ
void warnOfDifference(
    const mpm::materialPointPhase& phase, const dictionary& law, const dictionary& damage,
    const word& key)
{
    scalar a, b;
    if (law.readIfPresent(key, a) && damage.readIfPresent(key, b)
        && mag(a - b) > 0.05 * max(mag(a), mag(b)))
    {
        IOWarningInFunction(damage)
            << "Entry " << key << " of the failureModel of phase " << phase.name() << " is " << b
            << " K, that of its law " << a << " K: both are the matter's." << endl;
    }
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::requireGas(const dictionary& phaseProperties, const wordList& names)
{
    const bool gas = phaseNames(phaseProperties, {"gas"}).size()
        || phaseNames(phaseProperties, {"fluid"}).size();
    for (const word& name : names)
    {
        const dictionary& dict = requiredDict(phaseProperties, name);
        for (const word key : {"drag", "heatTransfer"})
        {
            if (!gas && dict.found(key))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry " << key << " of phase " << name
                    << " acts between points and a gas, but phases " << flatOutput(names)
                    << " has none. Remove it, or add a"
                    << " phase of type gas or fluid." << exit(FatalIOError);
            }
        }
    }
}

void Foam::mpm::warnOfDensity(const materialPointPhase& phase)
{
    const materialPointCloud& cloud = phase.cloud();
    const Time& time = cloud.time();
    const fileName state(time.path() / time.timeName() / "uniform" / "materialPointState");
    scalar mass = 0, volume = 0;
    for (label p = 0; p < cloud.size(); ++p)
    {
        mass += cloud.mass()[0][p];
        volume += cloud.volume()[0][p];
    }
    reduce(mass, sumOp<scalar>());
    reduce(volume, sumOp<scalar>());
    const bool old = returnReduce(isFile(state), orOp<bool>());
    if (old || phase.prescribed() || !(volume > 0))
    {
        return;
    }
    const scalar rho = mass / volume;
    if (mag(rho - phase.rho()) > 0.01 * phase.rho() && Pstream::master()
        && filledWithRho(time.globalPath() / time.system() / "setMaterialPointsDict", phase.name()))
    {
        WarningInFunction << "The points of phase " << phase.name() << " have the density " << rho
                          << " kg/m3 (mass over volume), but its rho is " << phase.rho()
                          << " kg/m3: they were made with another rho. Run"
                          << " setMaterialPoints again"
                          << (Pstream::parRun() ? ", then decomposePar -force." : ".") << endl;
    }
}

void Foam::mpm::warnOfNormals(
    const dictionary& phaseProperties, const pointGrid& grid,
    const PtrList<materialPointPhase>& phases)
{
    for (const entry& e : phaseProperties.subOrEmptyDict("contact"))
    {
        if (!e.isDict() || !e.dict().found("normal"))
        {
            continue;
        }
        const wordList fields(e.dict().get<wordList>("fields"));
        const vector n(normalised(e.dict().get<vector>("normal")));
        point a, b;
        const scalar ma = centreOfMass(phases, fields[0], a);
        const scalar mb = centreOfMass(phases, fields[1], b);
        vector way(b - a);
        for (int d = 0; d < grid.nDim(); ++d)
        {
            // Around a period there are two ways
            if (grid.period(d) > 0)
            {
                way[grid.direction(d)] = 0;
            }
        }
        if (ma > 0 && mb > 0 && (n & way) < -1e-6 * mag(way))
        {
            IOWarningInFunction(e.dict())
                << "Contact " << e.keyword() << ": normal " << n
                << " is from the first field to the second, but points"
                << " against the way from the centre of mass of " << fields[0] << ' ' << a
                << " to that of " << fields[1] << ' ' << b
                << ": they may never touch. If it is reversed, write"
                << "  normal " << (0 * n - n) << ";" << endl;
        }
    }
}

void Foam::mpm::warnOfUnits(const materialPointPhase& phase, const dictionary& dict)
{
    if (phase.motion() || !phase.law().hasStress())
    {
        return;
    }
    const dictionary& law = requiredDict(dict, "constitutiveModel");
    const scalar rho = phase.rho();
    const scalar c = phase.law().waveSpeed();
    const bool solid = phase.law().holdsTogether();
    OStringStream waveSpeed, height, os;
    waveSpeed.precision(4);
    waveSpeed << c;
    height.precision(3);
    height << sqr(c) / 9.81;
    if (rho < 1e-4 && c > 1000)
    {
        // In mm a solid has 1e-9 t/mm3 or 1e-6 kg/mm3
        const bool tonnes = rho < 1e-7;
        os << rho << (tonnes ? " t/mm3 are " : " kg/mm3 are ") << (tonnes ? 1e12 : 1e9) * rho
           << " kg/m3: materialPointFoam works in"
           << " m, kg, s and Pa.";
    }
    else if (rho < 23 && c > 1000)
    {
        os << "rho " << rho << " kg/m3 is that of a gas. " << rho << " g/cm3 are " << 1000 * rho
           << " kg/m3.";
    }
    else if (c > 2e4)
    {
        os << "No matter is that fast (diamond 18 km/s): rho is " << rho << " kg/m3, "
           << modulus(law).c_str() << '.';
    }
    else if (solid && (c < 0.57 || (c < 13 && rho > 3000)))
    {
        // The strain rho g h/(rho c^2) at the foot is 1; dense matter is as soft only if its
        // modulus is in MPa: of silicon carbide c is 12 m/s then
        os << "By " << modulus(law).c_str() << " and rho " << rho << " kg/m3 a layer "
           << height.str().c_str() << " m high is squeezed flat by its own weight on earth."
           << " Moduli are in Pa: 1e6 for 1 MPa, 1e9 for 1 GPa.";
    }
    if (os.str().size())
    {
        IOWarningInFunction(law) << "The law of phase " << phase.name() << " has a wave speed of "
                                 << waveSpeed.str().c_str() << " m/s. " << os.str().c_str() << endl;
    }
    warnOfStrength(phase, law, "yield");
    if (law.get<word>("type") == "JohnsonCook")
    {
        warnOfStrength(phase, law, "A");
    }
    const dictionary& failure = dict.subOrEmptyDict("failureModel");
    warnOfStrength(phase, failure, "strength");
    warnOfLeast(phase, failure, "ambientPressure", 100, "it is in Pa, 1e5 for 1 bar.");
    warnOfLeast(
        phase, law.subOrEmptyDict("equationOfState"), "C0", 50,
        "it is in m/s, 5330 for 5.33 km/s.");
    if (law.get<word>("type") == "JohnsonCook")
    {
        warnOfLeast(phase, law, "G", 1e5, "it is in Pa, 77e9 for 77 GPa.");
        warnOfLeast(phase, law, "cp", 20, "it is in J/kg/K, 477 for 0.477 J/g/K.");
        warnOfLeast(
            phase, law, "referenceTemperature", 60, "it is in K, 294 for 21 degrees Celsius.");
        warnOfDifference(phase, law, failure, "referenceTemperature");
        warnOfDifference(phase, law, failure, "meltTemperature");
    }
}
