/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "maxPrincipalStrain.H"
#include "dictionaryTools.H"
#include "spectral.H"
#include "leftStretch.H"
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
    stretch_(0),
    own_(false)
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
    failureModel::connect(law, nDim);
    stretch_ = law.columnOf("leftStretch", nDim);
    own_ = stretch_ < 0;
    if (own_)
    {
        stretch_ = law.nColumns(nDim);
    }
    if (own_ && law.columnOf("elasticStrain", nDim) < 0)
    {
        FatalErrorInFunction
            << "The failure model " << type() << " needs a law with a column"
            << " leftStretch or elasticStrain; " << law.type()
            << " has none." << exit(FatalError);
    }
}


template<int DIM>
void Foam::mpm::maxPrincipalStrain::strain(pointBlock b) const
{
    constexpr int W = laneWidth<DIM>;

    for (int i = 0; i < nStress(DIM); ++i)
    {
        b.history[i] = b.history[stretch_ + i];
    }
    if (DIM == 2 && b.hoop)
    {
        updateHoopStretch<DIM>(b);
    }
    const int nExp = expTerms(largestIncrement<DIM>(b));
    for (label p = 0; p < b.n; p += W)
    {
        lanes<W> c[DIM*DIM];
        updateLeftStretch<DIM>(b, laneGroup<W>(p, b.n), nExp, c);
    }
}


Foam::label Foam::mpm::maxPrincipalStrain::correct(pointBlock& b) const
{
    if (own_)
    {
        switch (b.nDim)
        {
            case 1: strain<1>(b); break;
            case 2: strain<2>(b); break;
            default: strain<3>(b);
        }
    }
    scalar* const* c = b.history + stretch_;
    label nFailed = 0;
    for (label p = 0; p < b.n; ++p)
    {
        const scalar strain = b.strength ? b.strength[p] : strength();
        const scalar limit = std::expm1(2*strain);
        if (b.damage[p] < 1)
        {
            // No principal value exceeds the norm
            scalar norm = 0;
            for (int i = 0; i < nStress(b.nDim); ++i)
            {
                norm += (i < 3 ? 1 : 2)*sqr(c[i][p]);
            }
            if (norm > sqr(limit))
            {
                double h[9];
                for (int i = 0; i < 9; ++i)
                {
                    const int r = i/3, s = i % 3;
                    const bool stored = r == s || (r < b.nDim && s < b.nDim);
                    h[i] = stored ? c[symmSlot(r, s)][p] : 0;
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
