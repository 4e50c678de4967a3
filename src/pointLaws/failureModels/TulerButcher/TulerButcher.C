/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::TulerButcher

Description
    Tensile failure with a time dependence: a point fails when

        int (s - strength)^exponent dt >= impulse,    s > strength

    with its largest principal Cauchy stress s [Pa]. A pulse above the strength
    that is too short leaves the point intact. What a failed point carries:
    failureModel. Scatter acts on the strength.

    Column tensileImpulse: the integral over impulse, 1 where it fails.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | TulerButcher                             | yes      |
        strength | threshold (Weibull: scale), > 0          | yes      | Pa
        exponent | > 0 (published: 1 to 2)                  | yes      | -
        impulse  | > 0                                      | yes      | Pa^exponent s
        failed, weibull, ambientPressure | see failureModel | no       |
    \endtable

    Reference: F. R. Tuler, B. M. Butcher, Int. J. Fracture Mech. 4 (1968) 431.

\*---------------------------------------------------------------------------*/

#include "failureModel.H"

namespace Foam::mpm
{

class TulerButcher : public failureModel
{
    scalar exponent_, impulse_;

    //- Place of its column
    int column_;

public:
    TypeName("TulerButcher");

    explicit TulerButcher(const dictionary& dict) :
        failureModel(dict, "strength"),
        exponent_(positive(dict, "exponent")),
        impulse_(positive(dict, "impulse")),
        column_(-1)
    {
        wordList valid(keywords);
        valid.append(wordList({"strength", "exponent", "impulse"}));
        checkKeywords(dict, valid);
    }

    void connect(const constitutiveModel& law, const int nDim) override
    {
        failureModel::connect(law, nDim);
        column_ = law.nColumns(nDim);
    }

    List<historyColumn> history() const override
    {
        return {{"tensileImpulse", historyColumn::scalars}};
    }

    label correct(pointBlock& b) const override
    {
        label nFailed = 0;
        scalar* sum = b.history[column_];
        for (label p = 0; p < b.n; ++p)
        {
            const scalar limit = b.strength ? b.strength[p] : strength();
            if (b.damage[p] < 1 && largestBound(b, p) > limit)
            {
                const scalar over = largestStress(b, p) - limit;
                if (over > 0)
                {
                    sum[p] += std::pow(over, exponent_) * b.dt / impulse_;
                    if (sum[p] >= 1)
                    {
                        b.damage[p] = 1;
                        ++nFailed;
                    }
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

defineTypeNameAndDebug(TulerButcher, 0);
addToRunTimeSelectionTable(failureModel, TulerButcher, dictionary);

} // End namespace Foam::mpm
