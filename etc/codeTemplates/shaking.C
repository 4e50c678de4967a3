// A body force of a user: b = amplitude sin(2 pi frequency t)

#include "bodyForce.H"
#include "dictionaryTools.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class shaking
:
    public pointwiseBodyForce<shaking>
{
    const vector amplitude_;
    const scalar frequency_;

public:

    TypeName("shaking");

    explicit shaking(const dictionary& dict)
    :
        amplitude_(required<vector>(dict, "amplitude")),
        frequency_(positive(dict, "frequency"))
    {
        checkKeywords(dict, {"type", "amplitude", "frequency"});
    }

    vector acceleration(const point&, const point&, const scalar time) const
    {
        return amplitude_*std::sin(constant::mathematical::twoPi*frequency_*time);
    }
};

defineTypeNameAndDebug(shaking, 0);
addToRunTimeSelectionTable(bodyForce, shaking, dictionary);

} // End namespace Foam::mpm
