// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "dragModel.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

defineTypeNameAndDebug(dragModel, 0);
defineRunTimeSelectionTable(dragModel, dictionary);

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace dragModels
{

typedef dragModel::state state;

//- Laws: K of a state and of the value of their entry, where they have one
template<bool Viscous>
struct law
{
    static constexpr bool viscous = Viscous, zero = false, sticks = false;

    static wordList keys() { return {"d"}; }
};

struct none : law<false>
{
    static constexpr bool zero = true;

    static wordList keys() { return wordList(); }

    static scalar K(const state&, const scalar) { return 0; }
};

struct stick : law<false>
{
    static constexpr bool sticks = true;

    static wordList keys() { return wordList(); }

    static scalar K(const state& s, const scalar) { return s.thetaS > 0 ? dragModel::sticking : 0; }
};

struct constant : law<false>
{
    static wordList keys() { return {"value"}; }

    static scalar K(const state& s, const scalar value) { return s.thetaS * s.thetaG * value; }
};

struct Darcy : law<true>
{
    static wordList keys() { return {"permeability"}; }

    static scalar K(const state& s, const scalar permeability)
    {
        return sqr(s.thetaG) * s.mu / permeability;
    }
};

//- C_D of a sphere times Re, which stays finite at Re = 0
static scalar dragCoefficientRe(const scalar Re)
{
    return Re < 1000 ? 24 * (1 + 0.15 * std::pow(Re, 0.687)) : 0.44 * Re;
}

//- K of spheres of diameter d, C_D rho u/d = (C_D Re) mu/(theta_g d^2)
struct SchillerNaumann : law<true>
{
    static scalar K(const state& s, const scalar d)
    {
        return 0.75 * dragCoefficientRe(s.rho * s.U * d / s.mu) * s.mu / sqr(d) * s.thetaS;
    }
};

struct WenYu : law<true>
{
    static scalar K(const state& s, const scalar d)
    {
        const scalar Re = s.thetaG * s.rho * s.U * d / s.mu;
        return 0.75 * dragCoefficientRe(Re) * s.mu / (s.thetaG * sqr(d)) * s.thetaS
            * std::pow(s.thetaG, -1.65);
    }
};

struct Ergun : law<true>
{
    static scalar K(const state& s, const scalar d)
    {
        return 150 * sqr(s.thetaS) * s.mu / (s.thetaG * sqr(d)) + 1.75 * s.thetaS * s.rho * s.U / d;
    }
};

struct Gidaspow : law<true>
{
    static scalar K(const state& s, const scalar d)
    {
        return s.thetaG < 0.8 ? Ergun::K(s, d) : WenYu::K(s, d);
    }
};

template<class Law>
class model : public dragModel
{
    const scalar value_;

public:
    TypeName("model");

    explicit model(const dictionary& dict) :
        dragModel(dict, Law::keys()),
        value_(Law::keys().size() ? positive(dict, Law::keys()[0]) : 0)
    {
    }

    scalar K(const state& s) const override { return Law::K(s, value_); }

    bool needsViscosity() const override { return Law::viscous; }

    bool none() const override { return Law::zero; }

    bool sticks() const override { return Law::sticks; }
};

#define addDrag(Law)                                                                               \
    typedef model<Law> Law##Model;                                                                 \
    defineTemplateTypeNameAndDebugWithName(Law##Model, #Law, 0);                                   \
    addToRunTimeSelectionTable(dragModel, Law##Model, dictionary)

addDrag(none);
addDrag(stick);
addDrag(constant);
addDrag(Darcy);
addDrag(SchillerNaumann);
addDrag(WenYu);
addDrag(Ergun);
addDrag(Gidaspow);

#undef addDrag

} // End namespace dragModels
} // End namespace Foam::mpm

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::dragModel::dragModel(const dictionary& dict, const wordList& keywords) :
    normalOnly_(oneOfOrDefault(dict, "direction", "all", {"all", "normal"}) == "normal")
{
    wordList valid(keywords);
    valid.append("type");
    valid.append("direction");
    checkKeywords(dict, valid);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::dragModel> Foam::mpm::dragModel::New(const dictionary& dict)
{
    return selectFromTable<dragModel>(dict, dictionaryConstructorTablePtr_, dict);
}
