/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "equationOfState.H"
#include "dictionaryTools.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(equationOfState, 0);
    defineRunTimeSelectionTable(equationOfState, dictionary);
}
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::equationOfState> Foam::mpm::equationOfState::New
(
    const dictionary& dict,
    const scalar rho0
)
{
    return selectFromTable<equationOfState>
    (
        dict,
        dictionaryConstructorTablePtr_,
        dict,
        rho0
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::equationOfState::storedEnergy(const scalar) const
{
    NotImplemented;
    return 0;
}


Foam::mpm::equationOfState::terms
Foam::mpm::equationOfState::at(const scalar rho) const
{
    terms t;
    coefficients(1, &rho, &t.A, &t.B, &t.dA, &t.dB);
    return t;
}


Foam::scalar
Foam::mpm::equationOfState::p(const scalar rho, const scalar e) const
{
    const terms t(at(rho));
    return t.A + t.B*e;
}


Foam::scalar
Foam::mpm::equationOfState::c(const scalar rho, const scalar e) const
{
    const terms t(at(rho));
    const scalar p = t.A + t.B*e;
    return std::sqrt(max(t.dA + e*t.dB + p*t.B/sqr(rho), scalar(0)));
}


bool Foam::mpm::equationOfState::stateOf
(
    const scalar p,
    scalar& rho,
    scalar& e
) const
{
    rho = rho0_;
    e = e0();
    if (pressureByEnergy())
    {
        const terms t(at(rho));
        e = (p - t.A)/t.B;
        return p > 0;
    }
    for (int i = 0; i < 100; ++i)
    {
        const terms t(at(rho));
        const scalar slope = t.dA + e*t.dB;
        const scalar change = (p - t.A - t.B*e)/slope;
        if (!(slope > 0) || !(mag(change) < 0.5*rho))
        {
            return false;
        }
        rho += change;
        if (mag(change) <= 1e-15*rho)
        {
            break;
        }
    }
    return mag(this->p(rho, e) - p) <= 1e-9*(mag(p) + rho0_*sqr(c(rho0_, e0())));
}

// ************************************************************************* //
