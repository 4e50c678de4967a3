/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::JohnsonCook

Description
    Johnson and Cook's strength of metals; stress, pressure, return mapping and
    temperature: deviatoricPlasticity.

        Y = (A + B eps^n)(1 + C ln(max(rate/rate0, 1)))(1 - T*^m)      [Pa]
        T* = (T - T0)/(Tm - T0), 0 below T0; no strength from T* = 1 on

    with the equivalent plastic strain eps, its rate (implicit in the step) and
    the temperature T of the start of the step. The part beta of the plastic
    work becomes heat: dT = beta sigma_eq dEps/(rho cp).

Usage
    \table
        Property | Description                               | Required | Unit
        type     | JohnsonCook                               | yes      |
        A        | yield stress, > 0                         | yes      | Pa
        B        | >= 0                                      | yes      | Pa
        n        | 0 < n <= 1                                | yes      | -
        C        | >= 0                                      | yes      | -
        m        | > 0                                       | yes      | -
        referenceRate        | rate0, > 0                    | yes      | 1/s
        referenceTemperature | T0, > 0                       | yes      | K
        meltTemperature      | Tm, > T0                      | yes      | K
        cp       | heat capacity, > 0                        | yes      | J/kg/K
        beta     | part of plastic work that heats, 0 to 1   | yes      | -
        initialTemperature | of the points, > 0              | no       | T0
        rho, E, nu, G, K, equationOfState, bulkViscosity | see deviatoricPlasticity | |
    \endtable

    Reference: G. R. Johnson, W. H. Cook, 7th Int. Symp. Ballistics (1983) 541.

\*---------------------------------------------------------------------------*/

#include "deviatoricPlasticity.H"
#include "laneMath.H"

namespace Foam::mpm
{

class JohnsonCook : public deviatoricPlasticity<JohnsonCook>
{
    scalar A_, B_, n_, C_, m_, rate0_, T0_, Tm_;

public:
    TypeName("JohnsonCook");

    explicit JohnsonCook(const dictionary& dict) :
        deviatoricPlasticity<JohnsonCook>(
            dict,
            wordList(
                {"A", "B", "n", "C", "m", "referenceRate", "referenceTemperature",
                 "meltTemperature", "cp", "beta", "initialTemperature"})),
        A_(positive(dict, "A")),
        B_(bounded(dict, "B", 0, GREAT)),
        n_(bounded(dict, "n", 1e-6, 1)),
        C_(bounded(dict, "C", 0, 10)),
        m_(positive(dict, "m")),
        rate0_(positive(dict, "referenceRate")),
        T0_(positive(dict, "referenceTemperature")),
        Tm_(positive(dict, "meltTemperature"))
    {
        if (!(Tm_ > T0_))
        {
            FatalIOErrorInFunction(dict)
                << "Entry meltTemperature is " << Tm_ << "; it must be greater than"
                << " referenceTemperature, " << T0_ << "." << exit(FatalIOError);
        }
        rCp_ = 1 / positive(dict, "cp");
        betaOverCp_ = bounded(dict, "beta", 0, 1) * rCp_;
        startT_ = dict.found("initialTemperature") ? positive(dict, "initialTemperature") : T0_;
    }

    //- See deviatoricPlasticity
    static constexpr bool thermal = true;

    //- 1 - T*^m
    template<class T>
    MPM_INLINE T softening(const T temperature) const
    {
        const T t = (temperature - T0_) / (Tm_ - T0_);
        if (!(horizontalMax(t) > 0))
        {
            return T{} + 1.0;
        }
        const T x = select(t > 1e-300, t, T{} + 1e-300);
        return select(t < 1.0, 1.0 - lanePow(x, m_), T{});
    }

    template<class T>
    MPM_INLINE void
    strength(const T eps, const T rate, const T soft, T& Y, T& dYdEps, T& dYdRate) const
    {
        const T e = select(eps > 1e-300, eps, T{} + 1e-300);
        const T h = B_ * lanePow(e, n_);
        const T y = soft * (A_ + h);

        // No logarithm where nothing is faster than the reference
        T f = T{} + 1.0;
        dYdRate = T{};
        const T fast = rate / rate0_;
        if (C_ > 0 && horizontalMax(fast) > 1)
        {
            const T x = select(fast > 1.0, fast, T{} + 1.0);
            f += C_ * laneLog(x);
            dYdRate = select(fast > 1.0, y * C_ / (x * rate0_), T{});
        }
        Y = y * f;
        dYdEps = soft * f * n_ * h / e;
    }
};

defineTypeNameAndDebug(JohnsonCook, 0);
addToRunTimeSelectionTable(constitutiveModel, JohnsonCook, dictionary);

} // End namespace Foam::mpm
