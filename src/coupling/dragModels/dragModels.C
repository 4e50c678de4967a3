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

namespace Foam
{
namespace mpm
{
namespace dragModels
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- C_D of a sphere times Re, which stays finite at Re = 0
static scalar dragCoefficientRe(const scalar Re)
{
    return Re < 1000 ? 24*(1 + 0.15*std::pow(Re, 0.687)) : 0.44*Re;
}


//- K of spheres of diameter d, C_D rho u/d = (C_D Re) mu/(theta_g d^2)
static scalar SchillerNaumannK(const dragModel::state& s, const scalar d)
{
    return 0.75*dragCoefficientRe(s.rho*s.U*d/s.mu)*s.mu/sqr(d)*s.thetaS;
}


static scalar WenYuK(const dragModel::state& s, const scalar d)
{
    const scalar Re = s.thetaG*s.rho*s.U*d/s.mu;
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


static scalar GidaspowK(const dragModel::state& s, const scalar d)
{
    return s.thetaG < 0.8 ? ErgunK(s, d) : WenYuK(s, d);
}

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

//- Models whose K has no viscosity
class inviscid
:
    public dragModel
{
public:

    using dragModel::dragModel;

    bool needsViscosity() const override
    {
        return false;
    }
};


class noDrag
:
    public inviscid
{
public:

    TypeName("none");

    explicit noDrag(const dictionary& dict)
    :
        inviscid(dict, wordList())
    {}

    scalar K(const state&) const override
    {
        return 0;
    }

    bool none() const override
    {
        return true;
    }
};


class stick
:
    public inviscid
{
public:

    TypeName("stick");

    explicit stick(const dictionary& dict)
    :
        inviscid(dict, wordList())
    {}

    scalar K(const state& s) const override
    {
        return s.thetaS > 0 ? sticking : 0;
    }
};


class constant
:
    public inviscid
{
    const scalar value_;

public:

    TypeName("constant");

    explicit constant(const dictionary& dict)
    :
        inviscid(dict, {"value"}),
        value_(positive(dict, "value"))
    {}

    scalar K(const state& s) const override
    {
        return s.thetaS*s.thetaG*value_;
    }
};


class Darcy
:
    public dragModel
{
    const scalar permeability_;

public:

    TypeName("Darcy");

    explicit Darcy(const dictionary& dict)
    :
        dragModel(dict, {"permeability"}),
        permeability_(positive(dict, "permeability"))
    {}

    scalar K(const state& s) const override
    {
        return sqr(s.thetaG)*s.mu/permeability_;
    }
};


//- Spheres of one diameter, with one of the functions above
template<scalar Law(const dragModel::state&, const scalar)>
class spheres
:
    public dragModel
{
    const scalar d_;

public:

    TypeName("spheres");

    explicit spheres(const dictionary& dict)
    :
        dragModel(dict, {"d"}),
        d_(positive(dict, "d"))
    {}

    scalar K(const state& s) const override
    {
        return Law(s, d_);
    }
};

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

#define addDrag(model)                                                         \
    defineTypeNameAndDebug(model, 0);                                          \
    addToRunTimeSelectionTable(dragModel, model, dictionary)

#define addSpheres(model)                                                      \
    typedef spheres<model##K> model;                                           \
    defineTemplateTypeNameAndDebugWithName(model, #model, 0);                  \
    addToRunTimeSelectionTable(dragModel, model, dictionary)

addDrag(noDrag);
addDrag(stick);
addDrag(constant);
addDrag(Darcy);
addSpheres(SchillerNaumann);
addSpheres(WenYu);
addSpheres(Ergun);
addSpheres(Gidaspow);

#undef addDrag
#undef addSpheres

} // End namespace dragModels
} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
