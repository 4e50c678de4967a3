/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    The drag models of dragModel.H.

\*---------------------------------------------------------------------------*/

#include "dragModel.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{

//- C_D of a sphere times Re, which stays finite at Re = 0
static scalar dragCoefficientRe(const scalar Re)
{
    return Re < 1000 ? 24*(1 + 0.15*std::pow(Re, 0.687)) : 0.44*Re;
}

static scalar WenYuK(const dragModel::state& s, const scalar d)
{
    const scalar Re = s.thetaG*s.rho*s.U*d/s.mu;
    // C_D rho u/d = (C_D Re) mu/(theta_g d^2)
    return
        0.75*dragCoefficientRe(Re)*s.mu/(s.thetaG*sqr(d))
       *s.thetaS*std::pow(s.thetaG, -1.65);
}

static scalar ErgunK(const dragModel::state& s, const scalar d)
{
    return
        150*sqr(s.thetaS)*s.mu/(s.thetaG*sqr(d))
      + 1.75*s.thetaS*s.rho*s.U/d;
}

static scalar constantK(const dragModel::state& s, const scalar value)
{
    return s.thetaS*s.thetaG*value;
}

static scalar stickK(const dragModel::state& s, const scalar)
{
    return s.thetaS > 0 ? dragModel::sticking : 0;
}

static scalar noneK(const dragModel::state&, const scalar)
{
    return 0;
}

static scalar SchillerNaumannK(const dragModel::state& s, const scalar d)
{
    return
        0.75*dragCoefficientRe(s.rho*s.U*d/s.mu)*s.mu/sqr(d)*s.thetaS;
}

static scalar GidaspowK(const dragModel::state& s, const scalar d)
{
    return s.thetaG < 0.8 ? ErgunK(s, d) : WenYuK(s, d);
}

static scalar DarcyK(const dragModel::state& s, const scalar permeability)
{
    return sqr(s.thetaG)*s.mu/permeability;
}

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

//- A drag of one number
class simpleDrag
:
    public dragModel
{
public:

    typedef scalar (*coefficient)(const state& s, const scalar value);

private:

    const coefficient K_;
    const bool viscous_;
    const scalar value_;

public:

    //- With the keyword of its number; empty: it has none
    simpleDrag
    (
        const dictionary& dict,
        const word& keyword,
        const coefficient K,
        const bool viscous
    )
    :
        dragModel(dict, keyword.empty() ? wordList() : wordList(1, keyword)),
        K_(K),
        viscous_(viscous),
        value_(keyword.empty() ? 0 : positive(dict, keyword))
    {}

    scalar K(const state& s) const override
    {
        return K_(s, value_);
    }

    bool needsViscosity() const override
    {
        return viscous_;
    }

    bool none() const override
    {
        return K_ == noneK;
    }
};


//- Entry of the selection table
struct addDrag
{
    addDrag
    (
        const word& name,
        autoPtr<dragModel> (*make)(const dictionary&)
    )
    {
        dragModel::constructdictionaryConstructorTables();
        dragModel::dictionaryConstructorTablePtr_->insert(name, make);
    }
};


template<simpleDrag::coefficient K, bool viscous>
autoPtr<dragModel> ofSize(const dictionary& dict)
{
    return autoPtr<dragModel>(new simpleDrag(dict, "d", K, viscous));
}

static const addDrag none
(
    "none",
    [](const dictionary& dict)
    { return autoPtr<dragModel>(new simpleDrag(dict, "", noneK, false)); }
);
static const addDrag stick
(
    "stick",
    [](const dictionary& dict)
    { return autoPtr<dragModel>(new simpleDrag(dict, "", stickK, false)); }
);
static const addDrag constant
(
    "constant",
    [](const dictionary& dict)
    { return autoPtr<dragModel>(new simpleDrag(dict, "value", constantK, false)); }
);
static const addDrag Darcy
(
    "Darcy",
    [](const dictionary& dict)
    { return autoPtr<dragModel>(new simpleDrag(dict, "permeability", DarcyK, true)); }
);
static const addDrag SchillerNaumann("SchillerNaumann", ofSize<SchillerNaumannK, true>);
static const addDrag WenYu("WenYu", ofSize<WenYuK, true>);
static const addDrag Ergun("Ergun", ofSize<ErgunK, true>);
static const addDrag Gidaspow("Gidaspow", ofSize<GidaspowK, true>);

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
