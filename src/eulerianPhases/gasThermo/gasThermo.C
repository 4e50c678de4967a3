/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasThermo.H"
#include "dictionaryTools.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(gasThermo, 0);
    defineRunTimeSelectionTable(gasThermo, dictionary);
}
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::gasThermo> Foam::mpm::gasThermo::New
(
    const dictionary& dict
)
{
    word name("equationOfState");
    if (!dict.found(name) || dict.found("thermo"))
    {
        if (!dict.found("thermo"))
        {
            FatalIOErrorInFunction(dict)
                << "One of the entries (thermo equationOfState) is missing in "
                << dict.name() << exit(FatalIOError);
        }
        name = oneOf
        (
            dict,
            "thermo",
            dictionaryConstructorTablePtr_->sortedToc()
        );
    }
    if
    (
        dict.found("equationOfState")
     && (name == "perfectGas" || name == "isentropic")
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entries thermo " << name << " and equationOfState in "
            << dict.name() << " exclude each other; give one of them."
            << exit(FatalIOError);
    }
    return dictionaryConstructorTablePtr_->cfind(name).val()(dict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::mpm::gasThermo::description() const
{
    OStringStream os;
    if (isGammaLaw())
    {
        os  << type() << ", gamma "
            << gamma_;
        if (!isentropic_)
        {
            os  << ", R " << R_ << " J/kg/K";
        }
    }
    else
    {
        os  << "equation of state " << equation_->type() << ", rho0 "
            << equation_->rho0() << " kg/m3";
        if (Cv_ > 0)
        {
            os  << ", Cv " << Cv_ << " J/kg/K";
        }
    }
    return os.str();
}

// ************************************************************************* //
