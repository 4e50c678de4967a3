/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "programmedBurn.H"
#include "noTraps.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(programmedBurn, 0);
    addToRunTimeSelectionTable(detonation, programmedBurn, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Speed of Chapman and Jouguet [m/s]: the least D of D^2 = v0^2 p/(v0 - v)
//  on the Hugoniot e - e0 = p (v0 - v)/2
scalar speedOf(const mpm::equationOfState& products)
{
    const mpm::noTraps guard;
    const scalar rho0 = products.rho0();
    scalar least = GREAT;
    for (label i = 0; i <= 1000; ++i)
    {
        const scalar rho = rho0*(1.02 + 1e-3*i);
        const mpm::equationOfState::terms t(products.at(rho));
        const scalar half = 0.5*(1/rho0 - 1/rho);
        const scalar p = (t.A + t.B*products.e0())/(1 - t.B*half);
        if (p > 0 && t.B*half < 1)
        {
            least = min(least, std::sqrt(0.5*p/half)/rho0);
        }
    }
    return least;
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::programmedBurn::programmedBurn
(
    const dictionary& dict,
    const equationOfState& products
)
:
    detonation(dict, products, detonationFront::entries),
    front_(dict)
{
    const scalar D = speedOf(products);
    if (!(mag(front_.velocity()/D - 1) < 0.1))
    {
        WarningInFunction
            << "The detonation of " << dict.name() << " has the velocity "
            << front_.velocity() << " m/s, but rho " << products.rho0()
            << " kg/m3 and the products' equation with its E0 make a wave of "
            << D << " m/s (Chapman and Jouguet)." << nl
            << "    Units are m/s, kg/m3 and Pa (A, B, E0)." << endl;
    }
}

// ************************************************************************* //
