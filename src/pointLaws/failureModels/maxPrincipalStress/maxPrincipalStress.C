/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "maxPrincipalStress.H"
#include "selector.H"
#include "spectral.H"
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
    failureModel(dict)
{
    checkKeywords
    (
        dict,
        {"type", "strength", "weibull", "ambientPressure", "limitOn"}
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::maxPrincipalStress::correct(pointBlock& b) const
{
    const int D = b.nDim;
    label nFailed = 0;
    const scalar ambient = this->ambient(), shift = limitShift();

    for (label p = 0; p < b.n; ++p)
    {
        const scalar limit = b.strength ? b.strength[p] : strength();

        // No principal stress exceeds mean + 2 sqrt(J2/3): settles nearly
        // all points without their principal values
        const scalar xx = b.stress[0][p], yy = b.stress[1][p];
        const scalar zz = b.stress[2][p];
        const scalar mean = (xx + yy + zz)/3;
        scalar J2 = 0.5*(sqr(xx - mean) + sqr(yy - mean) + sqr(zz - mean));
        for (int s = 3; s < nStress(D); ++s)
        {
            J2 += sqr(b.stress[s][p]);
        }
        const scalar bound = mean + 1.1547005383792517*std::sqrt(J2);

        if (!(b.damage[p] > 0 ? bound > -ambient : bound + shift > limit))
        {
            for (int i = 0; b.damage[p] > 0 && i < 3; ++i)
            {
                b.stress[i][p] += ambient;
            }
            continue;
        }

        double sigma[9], kept[9];
        fullStress(b, p, sigma);

        if (b.damage[p] <= 0)
        {
            if (!(largestPrincipal(sigma) + shift > limit))
            {
                continue;
            }
            b.damage[p] = 1;
            ++nFailed;
        }

        for (int i = 0; i < 3; ++i)
        {
            sigma[4*i] += ambient;
        }
        isotropicFunction<3>
        (
            sigma,
            [](double x) { return x < 0 ? x : 0.0; },
            kept
        );
        for (int i = 0; i < 3; ++i)
        {
            b.stress[i][p] = kept[4*i];
        }
        for (int i = 0; i < D; ++i)
        {
            for (int j = i + 1; j < D; ++j)
            {
                b.stress[symmSlot(i, j)][p] = kept[3*i + j];
            }
        }
    }
    return nFailed;
}

// ************************************************************************* //
