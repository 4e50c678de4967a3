/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    The laws of detonation.H.

\*---------------------------------------------------------------------------*/

#include "detonation.H"
#include "detonationFront.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "addToRunTimeSelectionTable.H"
#include "StringStream.H"

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
        const scalar rho = rho0 * (1.02 + 1e-3 * i);
        const mpm::equationOfState::terms t(products.at(rho));
        const scalar half = 0.5 * (1 / rho0 - 1 / rho);
        const scalar p = (t.A + t.B * products.e0()) / (1 - t.B * half);
        if (p > 0 && t.B * half < 1)
        {
            least = min(least, std::sqrt(0.5 * p / half) / rho0);
        }
    }
    return least;
}

}

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam::mpm
{

class programmedBurn : public detonation
{
    detonationFront front_;

public:
    TypeName("programmedBurn");

    programmedBurn(const dictionary& dict, const equationOfState& products);

    // Member Functions

    scalar speed() const override { return front_.velocity(); }

    void start(const fvMesh& mesh, const boolList& charge, const bool fresh) override
    {
        front_.start(mesh, charge, fresh);
    }

    void burn(
        const labelUList& cells, const UList<scalar>&, const scalar t, const scalar dt,
        UList<scalar>& F) const override
    {
        front_.burn(cells, t + dt, F);
    }

    string description() const override { return "programmed burn, " + front_.description(); }
};

class pressureRate : public detonation
{
    // Private Data

    const scalar G_, b_, threshold_;

    //- May be null
    autoPtr<detonationFront> booster_;

public:
    TypeName("pressureRate");

    pressureRate(const dictionary& dict, const equationOfState& products);

    // Member Functions

    scalar speed() const override { return booster_.valid() ? booster_->velocity() : 0; }

    void start(const fvMesh& mesh, const boolList& charge, const bool fresh) override;

    void burn(
        const labelUList& cells, const UList<scalar>& p, const scalar t, const scalar dt,
        UList<scalar>& F) const override;

    string description() const override;
};

defineTypeNameAndDebug(programmedBurn, 0);
defineTypeNameAndDebug(pressureRate, 0);
addToRunTimeSelectionTable(detonation, programmedBurn, dictionary);
addToRunTimeSelectionTable(detonation, pressureRate, dictionary);

} // End namespace Foam::mpm

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::programmedBurn::programmedBurn(const dictionary& dict, const equationOfState& products) :
    detonation(dict, products, detonationFront::entries), front_(dict)
{
    const scalar D = speedOf(products);
    if (!(mag(front_.velocity() / D - 1) < 0.1))
    {
        WarningInFunction << "The detonation of " << dict.name() << " has the velocity "
                          << front_.velocity() << " m/s, but rho " << products.rho0()
                          << " kg/m3 and the products' equation with its E0 make a wave of " << D
                          << " m/s (Chapman and Jouguet)." << nl
                          << "    Units are m/s, kg/m3 and Pa (A, B, E0)." << endl;
    }
}

Foam::mpm::pressureRate::pressureRate(const dictionary& dict, const equationOfState& products) :
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

void Foam::mpm::pressureRate::start(const fvMesh& mesh, const boolList& charge, const bool fresh)
{
    if (booster_.valid())
    {
        booster_->start(mesh, charge, fresh);
    }
}

void Foam::mpm::pressureRate::burn(
    const labelUList& cells, const UList<scalar>& p, const scalar t, const scalar dt,
    UList<scalar>& F) const
{
    forAll(F, i)
    {
        if (F[i] < 1 && p[i] > threshold_)
        {
            F[i] = 1 - (1 - F[i]) * std::exp(-dt * G_ * std::pow(p[i], b_));
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
    os << "burns at the rate " << G_ << " p^" << b_ << " (1 - F)";
    if (threshold_ > 0)
    {
        os << " above " << threshold_ << " Pa";
    }
    if (booster_.valid())
    {
        os << ", booster " << booster_->description().c_str();
    }
    return os.str();
}
