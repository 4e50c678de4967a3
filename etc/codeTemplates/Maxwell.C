// A law of a user: an elastic solid whose stress relaxes,
//
//     d sigma/dt = C:D - sigma/relaxationTime
//
// with D constant in a step.

#include "pointwise.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class Maxwell
:
    public pointwise<Maxwell>
{
    const scalar K_, G_, time_;

public:

    TypeName("Maxwell");

    explicit Maxwell(const dictionary& dict)
    :
        pointwise<Maxwell>(dict),
        K_(positive(dict, "K")),
        G_(positive(dict, "G")),
        time_(positive(dict, "relaxationTime"))
    {
        checkKeywords(dict, {"type", "rho", "K", "G", "relaxationTime"});
    }

    symmTensor stress(materialState& s) const
    {
        const scalar keep = std::exp(-s.dt/time_);
        const symmTensor D(symm(s.dL));
        const symmTensor elastic(K_*tr(D)*symmTensor::I + 2*G_*dev(D));
        return keep*s.stress + (1 - keep)*time_/s.dt*elastic;
    }

    scalar waveSpeed() const override
    {
        return std::sqrt((K_ + 4*G_/3)/rho());
    }

    scalar strainEnergy(const pointBlock&) const override
    {
        return 0;
    }
};

defineTypeNameAndDebug(Maxwell, 0);
addToRunTimeSelectionTable(constitutiveModel, Maxwell, dictionary);

} // End namespace Foam::mpm
