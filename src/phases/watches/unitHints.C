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
    if (rho < 23 && c > 1000)
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
}

// ************************************************************************* //
