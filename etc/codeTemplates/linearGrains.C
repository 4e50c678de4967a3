// A granular pressure of a user: p = k (a - alphaMin) of the fraction a where
// grains touch, so that waves run through them with sqrt(k/rho)

#include "granularPressure.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class linearGrains
:
    public granularPressure
{
    const scalar min_, k_;

public:

    TypeName("linear");

    explicit linearGrains(const dictionary& dict)
    :
        granularPressure(dict, {"alphaMin", "k"}),
        min_(bounded(dict, "alphaMin", 0, 1)),
        k_(positive(dict, "k"))
    {}

    scalar p(const scalar a) const override
    {
        return k_*max(a - min_, scalar(0));
    }

    scalar slope(const scalar a) const override
    {
        return a > min_ ? k_ : 0;
    }
};

defineTypeNameAndDebug(linearGrains, 0);
addToRunTimeSelectionTable(granularPressure, linearGrains, dictionary);

} // End namespace Foam::mpm
