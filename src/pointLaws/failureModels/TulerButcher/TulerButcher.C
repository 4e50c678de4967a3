/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "TulerButcher.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(TulerButcher, 0);
    addToRunTimeSelectionTable(failureModel, TulerButcher, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::TulerButcher::TulerButcher(const dictionary& dict)
:
    failureModel(dict, "strength"),
    exponent_(positive(dict, "exponent")),
    impulse_(positive(dict, "impulse")),
    column_(-1)
{
    wordList valid(keywords);
    valid.append(wordList({"strength", "exponent", "impulse"}));
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::TulerButcher::connect
(
    const constitutiveModel& law,
    const int nDim
)
{
    failureModel::connect(law, nDim);
    column_ = law.nColumns(nDim);
}


Foam::label Foam::mpm::TulerButcher::correct(pointBlock& b) const
{
    label nFailed = 0;
    scalar* sum = b.history[column_];
    for (label p = 0; p < b.n; ++p)
    {
        const scalar limit = b.strength ? b.strength[p] : strength();
        if (b.damage[p] < 1 && largestBound(b, p) > limit)
        {
            const scalar over = largestStress(b, p) - limit;
            if (over > 0)
            {
                sum[p] += std::pow(over, exponent_)*b.dt/impulse_;
                if (sum[p] >= 1)
                {
                    b.damage[p] = 1;
                    ++nFailed;
                }
            }
        }
        if (b.damage[p] >= 1)
        {
            release(b, p);
        }
    }
    return nFailed;
}

// ************************************************************************* //
