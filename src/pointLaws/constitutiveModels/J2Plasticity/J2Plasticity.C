/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::J2Plasticity

Description
    Plasticity of von Mises with isotropic hardening, without rate and
    temperature. Stress, pressure and return mapping: deviatoricPlasticity. Yield stress
    of the equivalent plastic strain eps:

        Y = yield                       hardening none
        Y = yield + H eps               hardening linear, H >= 0
        Y = yield + B eps^n             hardening power, B >= 0, 0 < n <= 1

Usage
    \table
        Property  | Description                              | Required | Unit
        type      | J2Plasticity                             | yes      |
        yield     | yield stress, > 0                        | yes      | Pa
        hardening | none, linear or power                    | yes      |
        H         | modulus (linear)                         | yes      | Pa
        B, n      | coefficient, exponent (power)            | yes      | Pa, -
        rho, E, nu, G, K, equationOfState, bulkViscosity | see deviatoricPlasticity | |
    \endtable

\*---------------------------------------------------------------------------*/

#include "deviatoricPlasticity.H"
#include "laneMath.H"

namespace Foam::mpm
{

namespace
{

//- Keywords of the hardening, which must exist
wordList hardeningKeywords(const dictionary& dict)
{
    const word hardening(mpm::oneOf(dict, "hardening", {"none", "linear", "power"}));
    wordList keys({"yield", "hardening"});
    keys.append(
        hardening == "linear"      ? wordList({"H"})
            : hardening == "power" ? wordList({"B", "n"})
                                   : wordList());
    return keys;
}

}

class J2Plasticity : public deviatoricPlasticity<J2Plasticity>
{
    //- Yield stress, modulus H or coefficient B [Pa], exponent (0: linear)
    scalar yield_, B_, n_;

public:
    TypeName("J2Plasticity");

    explicit J2Plasticity(const dictionary& dict) :
        deviatoricPlasticity<J2Plasticity>(dict, hardeningKeywords(dict)),
        yield_(positive(dict, "yield")),
        B_(0),
        n_(0)
    {
        const word hardening(dict.get<word>("hardening"));
        if (hardening == "linear")
        {
            B_ = bounded(dict, "H", 0, GREAT);
        }
        else if (hardening == "power")
        {
            B_ = bounded(dict, "B", 0, GREAT);
            n_ = bounded(dict, "n", 1e-6, 1);
        }
    }

    //- See deviatoricPlasticity
    static constexpr bool thermal = false;

    template<class T>
    MPM_INLINE void strength(const T eps, const T, const T, T& Y, T& dYdEps, T& dYdRate) const
    {
        dYdRate = T{};
        if (n_ > 0)
        {
            const T e = select(eps > 1e-300, eps, T{} + 1e-300);
            const T h = B_ * lanePow(e, n_);
            Y = yield_ + h;
            dYdEps = n_ * h / e;
        }
        else
        {
            Y = yield_ + B_ * eps;
            dYdEps = T{} + B_;
        }
    }
};

defineTypeNameAndDebug(J2Plasticity, 0);
addToRunTimeSelectionTable(constitutiveModel, J2Plasticity, dictionary);

} // End namespace Foam::mpm
