// Heat transfer of a user: spheres of the diameter d with
//
//     Nu = 2 + (0.4 Re^1/2 + 0.06 Re^2/3) Pr^0.4,   Re = rho u d/mu
//
// Whitaker, AIChE J. 18 (1972) 361, without his ratio of viscosities.

#include "heatTransferModel.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class WhitakerHeat
:
    public heatTransferModel
{
    const scalar d_;

public:

    TypeName("Whitaker");

    explicit WhitakerHeat(const dictionary& dict)
    :
        d_(positive(dict, "d"))
    {
        checkKeywords(dict, {"type", "d"});
    }

    scalar H(const state& s) const override
    {
        const scalar Re = s.rho*s.U*d_/s.mu;
        const scalar Nu =
            2
          + (0.4*std::sqrt(Re) + 0.06*std::cbrt(sqr(Re)))*std::pow(s.Pr, 0.4);
        return 6*s.thetaS*s.mu*s.Cp/s.Pr*Nu/sqr(d_);
    }
};

defineTypeNameAndDebug(WhitakerHeat, 0);
addToRunTimeSelectionTable(heatTransferModel, WhitakerHeat, dictionary);

} // End namespace Foam::mpm
