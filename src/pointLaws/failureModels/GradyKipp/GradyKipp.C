/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "GradyKipp.H"
#include "dictionaryTools.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(GradyKipp, 0);
    addToRunTimeSelectionTable(failureModel, GradyKipp, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::GradyKipp::GradyKipp(const dictionary& dict)
:
    failureModel(dict, word()),
    m_(bounded(dict, "m", 1, 100)),
    growth_(positive(dict, "crackSpeed")),
    E_(0)
{
    wordList valid(keywords);
    valid.append(wordList({"k", "m", "crackSpeed"}));
    checkKeywords(dict, valid);

    growth_ *=
        (m_ + 3)/3
       *std::cbrt
        (
            8*constant::mathematical::pi*positive(dict, "k")
           /((m_ + 1)*(m_ + 2)*(m_ + 3))
        );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::GradyKipp::connect
(
    const constitutiveModel& law,
    const int nDim
)
{
    failureModel::connect(law, nDim);
    E_ = law.elasticModulus();
}


Foam::label Foam::mpm::GradyKipp::correct(pointBlock& b) const
{
    label nFailed = 0;
    for (label p = 0; p < b.n; ++p)
    {
        scalar& d = b.damage[p];
        if (d < 1 && largestBound(b, p) > 0)
        {
            const scalar e =
                max(largestStress(b, p), scalar(0))
               /(E_*(b.strength ? b.strength[p] : scalar(1)));
            d = min
            (
                pow3(std::cbrt(d) + growth_*std::pow(e, m_/3)*b.dt),
                scalar(1)
            );
            nFailed += d >= 1;
        }
        if (d > 0)
        {
            release(b, p);
        }
    }
    return nFailed;
}

// ************************************************************************* //
