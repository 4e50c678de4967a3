/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "maxPrincipalStrain.H"
#include "selector.H"
#include "spectral.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(maxPrincipalStrain, 0);
    addToRunTimeSelectionTable(failureModel, maxPrincipalStrain, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::maxPrincipalStrain::maxPrincipalStrain(const dictionary& dict)
:
    failureModel(dict, "strain"),
    stretch_(false)
{
    wordList valid(keywords);
    valid.append("strain");
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::maxPrincipalStrain::connect
(
    const constitutiveModel& law,
    const int nDim
)
{
    stretch_ = law.columnOf("leftStretch", nDim) == 0;
    if (!stretch_ && law.columnOf("elasticStrain", nDim) != 0)
    {
        FatalErrorInFunction
            << "The failure model " << type() << " needs a law with a column"
            << " leftStretch or elasticStrain; " << law.type()
            << " has none." << exit(FatalError);
    }
}


Foam::label Foam::mpm::maxPrincipalStrain::correct(pointBlock& b) const
{
    label nFailed = 0;
    for (label p = 0; p < b.n; ++p)
    {
        const scalar strain = b.strength ? b.strength[p] : strength();
        const scalar limit = stretch_ ? std::expm1(2*strain) : strain;
        if (b.damage[p] < 1)
        {
            // No principal value exceeds the norm
            scalar norm = 0;
            for (int i = 0; i < nStress(b.nDim); ++i)
            {
                norm += (i < 3 ? 1 : 2)*sqr(b.history[i][p]);
            }
            if (norm > sqr(limit))
            {
                double h[9];
                for (int i = 0; i < 9; ++i)
                {
                    const int r = i/3, c = i % 3;
                    const bool stored = r == c || (r < b.nDim && c < b.nDim);
                    h[i] = stored ? b.history[symmSlot(r, c)][p] : 0;
                }
                if (largestPrincipal(h) > limit)
                {
                    b.damage[p] = 1;
                    ++nFailed;
                }
            }
        }
        if (b.damage[p] > 0)
        {
            release(b, p);
        }
    }
    return nFailed;
}

// ************************************************************************* //
