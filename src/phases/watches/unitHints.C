/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "unitHints.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The first modulus of a law: "E 70", or "its moduli"
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
void warnOfStrength
(
    const mpm::materialPointPhase& phase,
    const dictionary& dict,
    const word& key
)
{
    scalar value;
    const scalar E = phase.law().elasticModulus();
    if (dict.readIfPresent(key, value) && value > 0 && value < 1e-6*E)
    {
        IOWarningInFunction(dict)
            << "Entry " << key << " of phase " << phase.name() << " is " << value
            << " Pa, " << value/E << " of its modulus " << E << " Pa: no matter"
            << " is that weak. In MPa it needs e6: 400e6 for 400 MPa." << endl;
    }
}


//- Warn of a number between 0 and the least that matter has
void warnOfLeast
(
    const mpm::materialPointPhase& phase,
    const dictionary& dict,
    const word& key,
    const scalar least,
    const char* words
)
{
    scalar value;
    if (dict.readIfPresent(key, value) && value > 0 && value < least)
    {
        IOWarningInFunction(dict)
            << "Entry " << key << " of phase " << phase.name() << " is " << value
            << ": " << words << endl;
    }
}


//- Warn of temperatures of Johnson and Cook's law and damage that differ
void warnOfDifference
(
    const mpm::materialPointPhase& phase,
    const dictionary& law,
    const dictionary& damage,
    const word& key
)
{
    scalar a, b;
    if
    (
        law.readIfPresent(key, a) && damage.readIfPresent(key, b)
     && mag(a - b) > 0.05*max(mag(a), mag(b))
    )
    {
        IOWarningInFunction(damage)
            << "Entry " << key << " of the failureModel of phase "
            << phase.name() << " is " << b << " K, that of its law " << a
            << " K: both are the matter's." << endl;
    }
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::warnOfUnits
(
    const materialPointPhase& phase,
    const dictionary& dict
)
{
    if (phase.motion() || !phase.law().hasStress())
    {
        return;
    }
    const dictionary& law = requiredDict(dict, "constitutiveModel");
    const scalar rho = phase.rho();
    const scalar c = phase.law().waveSpeed();
    const bool solid = phase.law().holdsTogether();
    OStringStream waveSpeed, os;
    waveSpeed.precision(4);
    waveSpeed << c;
    if (rho < 1e-4 && c > 1000)
    {
        // In mm a solid has 1e-9 t/mm3 or 1e-6 kg/mm3
        const bool tonnes = rho < 1e-7;
        os  << rho << (tonnes ? " t/mm3 are " : " kg/mm3 are ")
            << (tonnes ? 1e12 : 1e9)*rho << " kg/m3: materialPointFoam works in"
            << " m, kg, s and Pa.";
    }
    else if (rho < 23 && c > 1000)
    {
        os  << "rho " << rho << " kg/m3 is that of a gas. " << rho
            << " g/cm3 are " << 1000*rho << " kg/m3.";
    }
    else if (c > 2e4)
    {
        os  << "No matter is that fast (diamond 18 km/s): rho is " << rho
            << " kg/m3, " << modulus(law).c_str() << '.';
    }
    else if (solid && c < 0.57)
    {
        os  << "No solid is that slow: " << modulus(law).c_str()
            << ". A modulus in GPa needs e9: 70e9 for 70 GPa.";
    }
    else if (solid && c < 20 && rho > 3000)
    {
        os  << "Matter of rho " << rho << " kg/m3 is not that slow: "
            << modulus(law).c_str() << ". A modulus in MPa needs e6: 70000e6"
            << " for 70000 MPa.";
    }
    if (os.str().size())
    {
        IOWarningInFunction(law)
            << "The law of phase " << phase.name() << " has a wave speed of "
            << waveSpeed.str().c_str() << " m/s. " << os.str().c_str() << endl;
    }
    warnOfStrength(phase, law, "yield");
    if (law.get<word>("type") == "JohnsonCook")
    {
        warnOfStrength(phase, law, "A");
    }
    const dictionary& failure = dict.subOrEmptyDict("failureModel");
    warnOfStrength(phase, failure, "strength");
    if (law.get<word>("type") == "JohnsonCook")
    {
        warnOfLeast
        (
            phase, law, "G", 1e5, "it is in Pa, 77e9 for 77 GPa."
        );
        warnOfLeast
        (
            phase, law, "cp", 20, "it is in J/kg/K, 477 for 0.477 J/g/K."
        );
        warnOfLeast
        (
            phase, law, "referenceTemperature", 60,
            "it is in K, 294 for 21 degrees Celsius."
        );
        warnOfDifference(phase, law, failure, "referenceTemperature");
        warnOfDifference(phase, law, failure, "meltTemperature");
    }
}

// ************************************************************************* //
