// A law of a user, in one file and loaded with libs (...): linear elastic for
// small strains, until it returns a stress that is not a number.

#include "pointwise.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class nanLaw : public pointwise<nanLaw>
{
    const scalar E_, nanAfter_;
    mutable scalar nCalls_ = 0;

public:
    TypeName("nanLaw");

    explicit nanLaw(const dictionary& dict) :
        pointwise<nanLaw>(dict), E_(positive(dict, "E")), nanAfter_(positive(dict, "nanAfter"))
    {
        checkKeywords(dict, {"type", "rho", "E", "nanAfter"});
    }

    symmTensor stress(materialState& s) const
    {
        // Raises the invalid-operation flag once, when the calls are used up
        const scalar left = nanAfter_ - ++nCalls_;
        const scalar factor = left == -1 ? std::sqrt(left) : scalar(1);
        return factor * (s.stress + E_ * symm(s.dL));
    }

    scalar waveSpeed() const override { return std::sqrt(E_ / rho()); }

    scalar strainEnergy(const pointBlock&) const override { return 0; }
};

defineTypeNameAndDebug(nanLaw, 0);
addToRunTimeSelectionTable(constitutiveModel, nanLaw, dictionary);

} // End namespace Foam::mpm
