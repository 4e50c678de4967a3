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
    oneCrack_
    (
        Gf_ > 0
     && dict.found("cracksPerCell")
     && oneOfOrDefault(dict, "cracksPerCell", "any", {"any", "one"}) == "one"
    ),
    E_(0),
    M_(0),
    opening_(-1)
{
    wordList valid(keywords);
    valid.append(wordList({"strength", "Gf", "limitOn"}));
    if (Gf_ > 0)
    {
        valid.append("cracksPerCell");
    }
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::maxPrincipalStress::damageOf
(
    const pointBlock& b,
    const label p,
    const scalar s,
    const scalar (&n)[3],
    const scalar limit
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
            << r*l << " m; there is one of " << l << " m in a cell of "
            << b.width[p] << " m. Use smaller cells, or no Gf."
            << exit(FatalError);
    }
    return min(r/(r - 1)*(1 - limit/s), scalar(1));
}


Foam::scalar Foam::mpm::maxPrincipalStress::spent
(
    const pointBlock& b,
    const label p
) const
{
    const scalar limit = b.strength ? b.strength[p] : strength();
    const scalar r = 2*E_*Gf_/(sqr(limit)*b.width[p]);
    const scalar d = b.damage[p];
    return d/(d + r*(1 - d));
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::maxPrincipalStress::connect
(
    const constitutiveModel& law,
    const int nDim
)
{
    E_ = law.elasticModulus();
    M_ = law.rho()*sqr(law.waveSpeed());
    opening_ = nColumns(law, nDim);
}


void Foam::mpm::maxPrincipalStress::share
(
    const pointBlock& b,
    scalar* const* dL,
    const label* start,
    const label nCells,
    const label begin
) const
{
    const int D = b.nDim;
    scalar* const* opening = b.history + opening_;

    for (label k = 0; k < nCells; ++k)
    {
        const label p0 = max(start[k] - begin, label(0));
        const label p1 = min(start[k + 1] - begin, b.n);
        label crack = -1;
        scalar most = 0;
        for (label p = p0; p < p1; ++p)
        {
            if (b.damage[p] > most)
            {
                most = b.damage[p];
                crack = p;
            }
        }
        scalar open = 0;
        for (int i = 0; crack >= 0 && i < D; ++i)
        {
            open += opening[strainSlot(D, i, i)][crack];
        }
        if (!(open > 0))
        {
            continue;
        }

        scalar nn[9];
        for (int i = 0; i < D*D; ++i)
        {
            nn[i] =
                opening[strainSlot(D, min(i/D, i % D), max(i/D, i % D))][crack]
               /open;
        }
        // Traction and opening as if the pressure of the gas were in the crack
        const auto across = [&](const label p, scalar& e)
        {
            scalar t = -b.damage[p]*ambient();
            e = 0;
            for (int i = 0; i < D*D; ++i)
            {
                const int r = min(i/D, i % D), c = max(i/D, i % D);
                t += nn[i]*b.stress[symmSlot(r, c)][p];
                e += nn[i]*dL[i][p];
            }
            return t;
        };
        scalar e;
        const scalar traction = across(crack, e);
        const scalar least = 0.5*spent(b, crack);
        for (label p = p0; p < p1; ++p)
        {
            if (p != crack && spent(b, p) < least)
            {
                const scalar t = across(p, e);
                const scalar change =
                    (traction - t)/(M_*max(1 - b.damage[p], scalar(0.1))) - e;
                for (int i = 0; i < D*D; ++i)
                {
                    dL[i][p] += change*nn[i];
                }
            }
        }
    }
}


Foam::label Foam::mpm::maxPrincipalStress::correct(pointBlock& b) const
{
    label nFailed = 0;
    const scalar shift = effective_ ? ambient() : 0;
    scalar n[3];

    for (label p = 0; p < b.n; ++p)
    {
        const scalar limit = b.strength ? b.strength[p] : strength();
        scalar& d = b.damage[p];

        if (d < 1 && largestBound(b, p) + shift > limit)
        {
            const scalar s = largestStress(b, p, n) + shift;
            if (s > limit)
            {
                d = max(d, damageOf(b, p, s, n, limit));
                nFailed += d >= 1;
            }
        }
        if (d > 0)
        {
            if (oneCrack_)
            {
                const scalar open =
                    max(largestStress(b, p, n) + ambient(), scalar(0));
                for (int i = 0; i < b.nDim; ++i)
                {
                    for (int j = i; j < b.nDim; ++j)
                    {
                        b.history[opening_ + strainSlot(b.nDim, i, j)][p] =
                            open*n[i]*n[j];
                    }
                }
            }
            release(b, p);
        }
    }
    return nFailed;
}

// ************************************************************************* //
