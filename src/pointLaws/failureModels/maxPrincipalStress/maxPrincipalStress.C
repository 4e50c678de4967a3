/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "maxPrincipalStress.H"
#include "selector.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(maxPrincipalStress, 0);
    addToRunTimeSelectionTable(failureModel, maxPrincipalStress, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::maxPrincipalStress::maxPrincipalStress(const dictionary& dict)
:
    failureModel(dict, "strength"),
    effective_
    (
        oneOfOrDefault(dict, "limitOn", "total", {"total", "effective"})
     == "effective"
    ),
    Gf_(dict.found("Gf") ? positive(dict, "Gf") : 0),
    E_(0)
{
    wordList valid(keywords);
    valid.append(wordList({"strength", "Gf", "limitOn"}));
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::maxPrincipalStress::damageOf
(
    const pointBlock& b,
    const label p,
    const scalar s,
    const scalar limit
) const
{
    if (Gf_ <= 0)
    {
        return 1;
    }
    const scalar r = 2*E_*Gf_/(sqr(limit)*b.width[p]);
    if (!(r > 1))
    {
        FatalErrorInFunction
            << "Softening needs cells narrower than 2 E Gf/strength^2 = "
            << r*b.width[p] << " m; there is one of " << b.width[p]
            << " m. Use smaller cells, or no Gf." << exit(FatalError);
    }
    return min(r/(r - 1)*(1 - limit/s), scalar(1));
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::maxPrincipalStress::connect
(
    const constitutiveModel& law,
    const int
)
{
    E_ = law.elasticModulus();
}


Foam::label Foam::mpm::maxPrincipalStress::correct(pointBlock& b) const
{
    label nFailed = 0;
    const scalar shift = effective_ ? ambient() : 0;

    for (label p = 0; p < b.n; ++p)
    {
        const scalar limit = b.strength ? b.strength[p] : strength();
        scalar& d = b.damage[p];

        if (d < 1 && largestBound(b, p) + shift > limit)
        {
            const scalar s = largestStress(b, p) + shift;
            if (s > limit)
            {
                d = max(d, damageOf(b, p, s, limit));
                nFailed += d >= 1;
            }
        }
        if (d > 0)
        {
            release(b, p);
        }
    }
    return nFailed;
}

// ************************************************************************* //
