// A contact law of a user: friction that grows with the slip,
//
//     |J_t| = mu J_n |v|/speed
//
// with the slip v at the end of the step.

#include "contactLaw.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class viscousFriction
:
    public contactLaw
{
    const scalar mu_, speed_;

public:

    TypeName("viscousFriction");

    explicit viscousFriction(const dictionary& dict)
    :
        contactLaw(dict, {"mu", "speed"}),
        mu_(positive(dict, "mu")),
        speed_(positive(dict, "speed"))
    {}

    scalar limit(const state& s) const override
    {
        // J_t = a M v and M v = M slip - J_t
        const scalar a = mu_*s.Jn/(speed_*s.M);
        return s.Jt*a/(1 + a);
    }
};

defineTypeNameAndDebug(viscousFriction, 0);
addToRunTimeSelectionTable(contactLaw, viscousFriction, dictionary);

} // End namespace Foam::mpm
