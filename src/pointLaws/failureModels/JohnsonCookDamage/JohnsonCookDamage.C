/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::JohnsonCookDamage

Description
    Ductile failure of Johnson and Cook: the damage grows with the equivalent
    plastic strain eps of the law, and at d = 1 the point fails.

        dd = dEps/epsF
        epsF = (D1 + D2 exp(D3 S))(1 + D4 ln(max(rate/rate0, 1)))(1 + D5 T*)
        S = mean stress/sigma_eq, -3 to 1.5
        T* = (T - T0)/(Tm - T0), 0 to 1

    epsF is at least minFailureStrain: with D1 < 0 it else falls to 0 where S is
    high, and one step of noise in the pressure fails a point. The stress is
    that of the whole material until then; what a failed point carries:
    failureModel. A scattered limit (Weibull) multiplies epsF. The law must have
    the column plasticStrain, and T where D5 is not 0. Damage between 0 and 1 is
    in the column damage.

    Column damageStrain: the plastic strain already counted.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | JohnsonCookDamage                        | yes      |
        D1 to D5 | constants                                | yes      | -
        referenceRate | rate0, > 0                          | yes      | 1/s
        referenceTemperature | T0, > 0                      | yes      | K
        meltTemperature | Tm, > T0                          | yes      | K
        minFailureStrain | least epsF, 1e-6 to 1             | 1e-6     | -
        failed, weibull, ambientPressure | see failureModel | no       |
    \endtable

    Reference: G. R. Johnson, W. H. Cook, Eng. Fract. Mech. 21 (1985) 31.

\*---------------------------------------------------------------------------*/

#include "failureModel.H"

namespace Foam::mpm
{

class JohnsonCookDamage : public failureModel
{
    scalar D1_, D2_, D3_, D4_, D5_, rate0_, T0_, Tm_, least_;

    //- Places of the columns; T -1: none
    int plastic_, temperature_, counted_;

public:
    TypeName("JohnsonCookDamage");

    explicit JohnsonCookDamage(const dictionary& dict) :
        failureModel(dict, word()),
        D1_(bounded(dict, "D1", -100, 100)),
        D2_(bounded(dict, "D2", -100, 100)),
        D3_(bounded(dict, "D3", -100, 100)),
        D4_(bounded(dict, "D4", -100, 100)),
        D5_(bounded(dict, "D5", -100, 100)),
        rate0_(positive(dict, "referenceRate")),
        T0_(positive(dict, "referenceTemperature")),
        Tm_(positive(dict, "meltTemperature")),
        least_(boundedOrDefault(dict, "minFailureStrain", 1e-6, 1e-6, 1)),
        plastic_(-1),
        temperature_(-1),
        counted_(-1)
    {
        wordList valid(keywords);
        valid.append(wordList(
            {"D1", "D2", "D3", "D4", "D5", "referenceRate", "referenceTemperature",
             "meltTemperature", "minFailureStrain"}));
        if (!(Tm_ > T0_))
        {
            FatalIOErrorInFunction(dict)
                << "Entry meltTemperature is " << Tm_ << "; it must be greater than"
                << " referenceTemperature, " << T0_ << "." << exit(FatalIOError);
        }
        checkKeywords(dict, valid);
    }

    void connect(const constitutiveModel& law, const int nDim) override
    {
        failureModel::connect(law, nDim);
        plastic_ = law.columnOf("plasticStrain", nDim);
        temperature_ = law.columnOf("T", nDim);
        counted_ = law.nColumns(nDim);
        if (plastic_ < 0 || (temperature_ < 0 && D5_ != 0))
        {
            FatalErrorInFunction << "The failure model " << type() << " needs a law with "
                                 << (plastic_ < 0 ? "plastic strain" : "temperature (D5 is not 0)")
                                 << "; " << law.type() << " has none." << exit(FatalError);
        }
    }

    List<historyColumn> history() const override
    {
        return {{"damageStrain", historyColumn::scalars}};
    }

    label correct(pointBlock& b) const override
    {
        label nFailed = 0;
        const scalar* eps = b.history[plastic_];
        const scalar* T = temperature_ < 0 ? nullptr : b.history[temperature_];
        scalar* counted = b.history[counted_];
        for (label p = 0; p < b.n; ++p)
        {
            const scalar dEps = eps[p] - counted[p];
            if (b.damage[p] < 1 && dEps > 0)
            {
                counted[p] = eps[p];

                const scalar mean = (b.stress[0][p] + b.stress[1][p] + b.stress[2][p]) / 3;
                scalar ss = 0;
                for (int i = 0; i < nStress(b.nDim); ++i)
                {
                    ss += i < 3 ? sqr(b.stress[i][p] - mean) : 2 * sqr(b.stress[i][p]);
                }
                const scalar S =
                    max(min(mean / max(std::sqrt(1.5 * ss), VSMALL), scalar(1.5)), scalar(-3));
                const scalar rate = dEps / (b.dt * rate0_);
                const scalar t = T ? min(max((T[p] - T0_) / (Tm_ - T0_), scalar(0)), scalar(1)) : 0;
                const scalar epsF = (b.strength ? b.strength[p] : scalar(1))
                    * (D1_ + D2_ * std::exp(D3_ * S)) * (1 + D4_ * (rate > 1 ? std::log(rate) : 0))
                    * (1 + D5_ * t);

                b.damage[p] += dEps / max(epsF, least_);
                if (b.damage[p] >= 1)
                {
                    b.damage[p] = 1;
                    ++nFailed;
                }
            }
            if (b.damage[p] >= 1)
            {
                release(b, p);
            }
        }
        return nFailed;
    }
};

defineTypeNameAndDebug(JohnsonCookDamage, 0);
addToRunTimeSelectionTable(failureModel, JohnsonCookDamage, dictionary);

} // End namespace Foam::mpm
