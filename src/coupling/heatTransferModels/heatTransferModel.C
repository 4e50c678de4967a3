// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "heatTransferModel.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

defineTypeNameAndDebug(heatTransferModel, 0);
defineRunTimeSelectionTable(heatTransferModel, dictionary);

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace heatTransferModels
{

class constantHeat : public heatTransferModel
{
    const scalar value_;

public:
    TypeName("constant");

    explicit constantHeat(const dictionary& dict) : value_(positive(dict, "value"))
    {
        checkKeywords(dict, {"type", "value"});
    }

    scalar H(const state& s) const override { return s.thetaS * s.thetaG * value_; }

    bool needsConductivity() const override { return false; }
};

//- Nu of spheres of diameter d
static scalar RanzMarshallNu(const heatTransferModel::state& s, const scalar d)
{
    return 2 + 0.6 * std::sqrt(s.rho * s.U * d / s.mu) * std::cbrt(s.Pr);
}

static scalar GunnNu(const heatTransferModel::state& s, const scalar d)
{
    const scalar e = s.thetaG, Re = e * s.rho * s.U * d / s.mu;
    const scalar Pr3 = std::cbrt(s.Pr);
    return (7 + e * (5 * e - 10)) * (1 + 0.7 * std::pow(Re, 0.2) * Pr3)
        + (1.33 + e * (1.2 * e - 2.4)) * std::pow(Re, 0.7) * Pr3;
}

template<scalar Nu(const heatTransferModel::state&, const scalar)>
class spheres : public heatTransferModel
{
    const scalar d_;

public:
    TypeName("spheres");

    explicit spheres(const dictionary& dict) : d_(positive(dict, "d"))
    {
        checkKeywords(dict, {"type", "d"});
    }

    scalar H(const state& s) const override
    {
        return 6 * s.thetaS * s.mu * s.Cp / s.Pr * Nu(s, d_) / sqr(d_);
    }
};

defineTypeNameAndDebug(constantHeat, 0);

#define addSpheres(Nusselt)                                                                        \
    typedef spheres<Nusselt##Nu> Nusselt;                                                          \
    defineTemplateTypeNameAndDebugWithName(Nusselt, #Nusselt, 0);                                  \
    addToRunTimeSelectionTable(heatTransferModel, Nusselt, dictionary)

addToRunTimeSelectionTable(heatTransferModel, constantHeat, dictionary);
addSpheres(RanzMarshall);
addSpheres(Gunn);

#undef addSpheres

} // End namespace heatTransferModels

} // End namespace Foam::mpm

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::heatTransferModel>
Foam::mpm::heatTransferModel::New(const dictionary& dict)
{
    return selectFromTable<heatTransferModel>(dict, dictionaryConstructorTablePtr_, dict);
}
