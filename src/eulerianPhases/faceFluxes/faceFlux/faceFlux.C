// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "faceFlux.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(faceFlux, 0);
defineRunTimeSelectionTable(faceFlux, dictionary);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::faceFlux>
Foam::mpm::faceFlux::New(const dictionary& dict, const gasFaces& faces)
{
    const word name(
        oneOfOrDefault(dict, "faceFlux", "impedance", dictionaryConstructorTablePtr_->sortedToc()));
    return dictionaryConstructorTablePtr_->cfind(name).val()(dict, faces);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::faceFlux::flux(const gasStates<false>&, const besideSolid&, const result&) const
{
    FatalErrorInFunction << "The faceFlux " << type() << " has no form beside solid:"
                         << " use impedance where points and gas act on each other."
                         << exit(FatalError);
}
