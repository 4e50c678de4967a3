// The thermo of a user: a mixture of perfect gases, each with its mass fraction
// Y, R and Cp,
//
//     R = sum Y R_i,  Cp = sum Y Cp_i,  gamma = Cp/(Cp - R)

#include "gasThermo.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class gasMixture
:
    public gasThermo
{
public:

    TypeName("mixture");

    explicit gasMixture(const dictionary& dict)
    {
        const dictionary& components = requiredDict(dict, "components");
        scalar Cp = 0, sumY = 0;
        for (const word& name : components.toc())
        {
            const dictionary& gas = requiredDict(components, name);
            checkKeywords(gas, {"Y", "R", "Cp"});
            const scalar Y = bounded(gas, "Y", 0, 1);
            R_ += Y*positive(gas, "R");
            Cp += Y*positive(gas, "Cp");
            sumY += Y;
        }
        if (mag(sumY - 1) > 1e-6)
        {
            FatalIOErrorInFunction(components)
                << "The mass fractions Y have the sum " << sumY << ", not 1."
                << exit(FatalIOError);
        }
        gamma_ = Cp/(Cp - R_);
    }

    wordList keywords() const override { return {"thermo", "components"}; }
};

defineTypeNameAndDebug(gasMixture, 0);
addToRunTimeSelectionTable(gasThermo, gasMixture, dictionary);

} // End namespace Foam::mpm
