// A transfer scheme of a user, in one file and loaded with libs (...): points
// have the velocity of the nodes.

#include "transferScheme.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace mpm
{

class PIC
:
    public transferScheme
{
public:

    TypeName("PIC");

    explicit PIC(const dictionary&)
    {}

    moveCoefficients coefficients(const step&) const override
    {
        return {0, 0, 1, 0, 0, 1, 0};
    }
};

defineTypeNameAndDebug(PIC, 0);
addToRunTimeSelectionTable(transferScheme, PIC, dictionary);

} // End namespace mpm
} // End namespace Foam
