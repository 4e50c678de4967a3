/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pressureRate.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"
#include "StringStream.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(pressureRate, 0);
    addToRunTimeSelectionTable(detonation, pressureRate, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pressureRate::pressureRate
(
    const dictionary& dict,
    const equationOfState& products
)
:
    detonation(dict, products, {"G", "b", "threshold", "booster"}),
    G_(positive(dict, "G")),
    b_(bounded(dict, "b", 0, 10)),
    threshold_(boundedOrDefault(dict, "threshold", 0, 0, GREAT))
{
    if (dict.found("booster"))
    {
        const dictionary& front = requiredDict(dict, "booster");
        checkKeywords(front, detonationFront::entries);
        booster_.reset(new detonationFront(front));
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pressureRate::start
(
    const fvMesh& mesh,
    const boolList& charge,
    const bool fresh
)
{
    if (booster_.valid())
    {
        booster_->start(mesh, charge, fresh);
    }
}


void Foam::mpm::pressureRate::burn
(
    const labelUList& cells,
    const UList<scalar>& p,
    const scalar t,
    const scalar dt,
    UList<scalar>& F
) const
{
    forAll(F, i)
    {
        if (F[i] < 1 && p[i] > threshold_)
        {
            F[i] = 1 - (1 - F[i])*std::exp(-dt*G_*std::pow(p[i], b_));
            F[i] = F[i] > 0.9999 ? 1 : F[i];
        }
    }
    if (booster_.valid())
    {
        booster_->burn(cells, t + dt, F);
    }
}


Foam::string Foam::mpm::pressureRate::description() const
{
    OStringStream os;
    os  << "burns at the rate " << G_ << " p^" << b_ << " (1 - F)";
    if (threshold_ > 0)
    {
        os  << " above " << threshold_ << " Pa";
    }
    if (booster_.valid())
    {
        os  << ", booster " << booster_->description().c_str();
    }
    return os.str();
}

// ************************************************************************* //
