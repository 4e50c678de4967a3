/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "APIC.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(APIC, 0);
    addToRunTimeSelectionTable(transferScheme, APIC, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::APIC::APIC(const dictionary& dict)
:
    affine_
    (
        oneOfOrDefault
        (
            dict,
            "affineMatrix",
            "gradient",
            {"gradient", "moment"}
        ) == "moment"
      ? moment : gradient
    )
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::APIC::write(Ostream& os, const bool) const
{
    os  << "transfer APIC, affine matrix from the "
        << (affine_ == moment ? "moments of u^L" : "gradient of u^n")
        << ": x moves with u^L" << nl;
}

// ************************************************************************* //
