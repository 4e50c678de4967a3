/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "JohnsonCook.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(JohnsonCook, 0);
    addToRunTimeSelectionTable(constitutiveModel, JohnsonCook, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::JohnsonCook::JohnsonCook(const dictionary& dict)
:
    deviatoricPlasticity<JohnsonCook>
    (
        dict,
        wordList
        ({
            "A", "B", "n", "C", "m", "referenceRate", "referenceTemperature",
            "meltTemperature", "cp", "beta", "initialTemperature"
        })
    ),
    A_(positive(dict, "A")),
    B_(bounded(dict, "B", 0, GREAT)),
    n_(bounded(dict, "n", 1e-6, 1)),
    C_(bounded(dict, "C", 0, 10)),
    m_(positive(dict, "m")),
    rate0_(positive(dict, "referenceRate")),
    T0_(positive(dict, "referenceTemperature")),
    Tm_(positive(dict, "meltTemperature"))
{
    if (!(Tm_ > T0_))
    {
        FatalIOErrorInFunction(dict)
            << "Entry meltTemperature is " << Tm_ << "; it must be greater than"
            << " referenceTemperature, " << T0_ << "." << exit(FatalIOError);
    }
    rCp_ = 1/positive(dict, "cp");
    betaOverCp_ = bounded(dict, "beta", 0, 1)*rCp_;
    startT_ = dict.found("initialTemperature")
      ? positive(dict, "initialTemperature")
      : T0_;
}

// ************************************************************************* //
