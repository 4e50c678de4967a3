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

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

class noDrag
:
    public dragModel
{
public:

    TypeName("none");

    explicit noDrag(const dictionary& dict)
    :
        dragModel(dict, wordList())
    {}

    scalar K(const state&) const override
    {
        return 0;
    }

    bool needsViscosity() const override
    {
        return false;
    }

    bool none() const override
    {
        return true;
    }
};


class stick
:
    public dragModel
{
public:

    TypeName("stick");

    explicit stick(const dictionary& dict)
    :
        dragModel(dict, wordList())
    {}

    scalar K(const state& s) const override
    {
        return s.thetaS > 0 ? sticking : 0;
    }

    bool needsViscosity() const override
    {
        return false;
    }
};


class constant
:
    public dragModel
{
    const scalar value_;

public:

    TypeName("constant");

    explicit constant(const dictionary& dict)
    :
        dragModel(dict, {"value"}),
        value_(positive(dict, "value"))
    {}

    scalar K(const state& s) const override
    {
        return s.thetaS*s.thetaG*value_;
    }

    bool needsViscosity() const override
    {
        return false;
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


//- Spheres of one diameter
class spheres
:
    public dragModel
{
protected:

    const scalar d_;

    explicit spheres(const dictionary& dict)
    :
        dragModel(dict, {"d"}),
        d_(positive(dict, "d"))
    {}

    scalar WenYuK(const state& s) const
    {
        const scalar Re = s.thetaG*s.rho*s.U*d_/s.mu;
        // C_D rho u/d = (C_D Re) mu/(theta_g d^2)
        return
            0.75*dragCoefficientRe(Re)*s.mu/(s.thetaG*sqr(d_))
           *s.thetaS*std::pow(s.thetaG, -1.65);
    }

    scalar ErgunK(const state& s) const
    {
        return
            150*sqr(s.thetaS)*s.mu/(s.thetaG*sqr(d_))
          + 1.75*s.thetaS*s.rho*s.U/d_;
    }
};


class SchillerNaumann
:
    public spheres
{
public:

    TypeName("SchillerNaumann");

    explicit SchillerNaumann(const dictionary& dict)
    :
        spheres(dict)
    {}

    scalar K(const state& s) const override
    {
        return
            0.75*dragCoefficientRe(s.rho*s.U*d_/s.mu)*s.mu/sqr(d_)*s.thetaS;
    }
};


class WenYu
:
    public spheres
{
public:

    TypeName("WenYu");

    explicit WenYu(const dictionary& dict)
    :
        spheres(dict)
    {}

    scalar K(const state& s) const override
    {
        return WenYuK(s);
    }
};


class Ergun
:
    public spheres
{
public:

    TypeName("Ergun");

    explicit Ergun(const dictionary& dict)
    :
        spheres(dict)
    {}

    scalar K(const state& s) const override
    {
        return ErgunK(s);
    }
};


class Gidaspow
:
    public spheres
{
public:

    TypeName("Gidaspow");

    explicit Gidaspow(const dictionary& dict)
    :
        spheres(dict)
    {}

    scalar K(const state& s) const override
    {
        return s.thetaG < 0.8 ? ErgunK(s) : WenYuK(s);
    }
};

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

#define addDrag(model)                                                         \
    defineTypeNameAndDebug(model, 0);                                          \
    addToRunTimeSelectionTable(dragModel, model, dictionary)

addDrag(noDrag);
addDrag(stick);
addDrag(constant);
addDrag(Darcy);
addDrag(SchillerNaumann);
addDrag(WenYu);
addDrag(Ergun);
addDrag(Gidaspow);

#undef addDrag

} // End namespace dragModels
} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
