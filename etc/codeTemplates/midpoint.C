// A transfer scheme of a user, in one file and loaded with libs (...): FLIP
// whose points move with the mean of u^n and u^L, as equation (8) of the paper.

#include "FLIP.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace mpm
{

class midpoint
:
    public FLIP
{
public:

    TypeName("midpoint");

    explicit midpoint(const dictionary& dict)
    :
        FLIP(dict)
    {}

    moveCoefficients coefficients(const step& s) const override
    {
        moveCoefficients c(FLIP::coefficients(s));
        c.b1 = 0;
        c.b2 = c.b3 = 0.5;
        return c;
    }

    bool meanInGas(const bool) const override
    {
        return false;
    }
};

defineTypeNameAndDebug(midpoint, 0);
addToRunTimeSelectionTable(transferScheme, midpoint, dictionary);

} // End namespace mpm
} // End namespace Foam
