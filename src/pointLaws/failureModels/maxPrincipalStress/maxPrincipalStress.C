/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "maxPrincipalStress.H"
#include "dictionaryTools.H"
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
    E_(0),
    crack_(-1)
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
    const scalar (&n)[3],
    const scalar limit,
    scalar& crack
) const
{
    if (Gf_ <= 0)
    {
        return 1;
    }
    const scalar across = mag(n[0]) + mag(n[1]) + mag(n[2]);
    const scalar l = max(across, scalar(1))*b.width[p];
    const scalar r = 2*E_*Gf_/(sqr(limit)*l);
    if (!(r > 1))
    {
        FatalErrorInFunction
            << "Softening needs bands narrower than 2 E Gf/strength^2 = "
            << r*l << " m; that of " << b.nameOf(p).c_str() << " is " << l
            << " m wide, in a cell of " << b.width[p] << " m. Use smaller cells, or no Gf."
            << exit(FatalError);
    }
    const scalar d = min(r/(r - 1)*(1 - limit/s), scalar(1));
    crack = max(crack, d/(r - d*(r - 1)));
    return d;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::maxPrincipalStress::connect
(
    const constitutiveModel& law,
    const int nDim
)
{
    failureModel::connect(law, nDim);
    E_ = law.elasticModulus();
    crack_ = law.nColumns(nDim);
}


Foam::scalar
Foam::mpm::maxPrincipalStress::widestBand(const scalar limit) const
{
    return Gf_ > 0 ? 2*E_*Gf_/sqr(limit) : GREAT;
}


Foam::label Foam::mpm::maxPrincipalStress::correct(pointBlock& b) const
{
    label nFailed = 0;
    const scalar shift = effective_ ? ambient() : 0;
    scalar n[3], none = 0;
    scalar* crack = Gf_ > 0 ? b.history[crack_] : nullptr;

    for (label p = 0; p < b.n; ++p)
    {
        const scalar limit = b.strength ? b.strength[p] : strength();
        scalar& d = b.damage[p];

        if (d < 1 && largestBound(b, p) + shift > limit)
        {
            const scalar s = largestStress(b, p, n) + shift;
            if (s > limit)
            {
                d = max
                (
                    d,
                    damageOf(b, p, s, n, limit, crack ? crack[p] : none)
                );
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
