/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::GradyKipp

Description
    Dynamic fragmentation: flaws open at a tensile strain e in the number

        n(e) = k e^m                                                  [1/m3]

    and each grows as a sphere of the speed c. The damage is the volume they
    relieve; at a constant strain rate its integral is that of

        d(D^(1/3))/dt = (m + 3)/3 A^(1/3) e^(m/3),   e = s/E > 0

        A = 8 pi c^3 k/((m + 1)(m + 2)(m + 3))

    with the largest principal stress s of the whole material and Young's
    modulus E of the law. So D = A e^(m + 3)/rate^3 at a constant rate, and
    under uniaxial stress (1 - D) E e is largest at D = 1/(m + 4):

        s_f = E (m + 3)/(m + 4) (rate^3/((m + 4) A))^(1/(m + 3))

    Strength rises with rate^(3/(m + 3)). Nothing depends on the cells, but
    softening has no length: after s_f it may localise in a cell. Points soften
    by D (failureModel); a scatter multiplies the strain e at which flaws open.

Usage
    \table
        Property   | Description                          | Required | Unit
        type       | GradyKipp                            | yes      |
        k          | flaws at strain 1, > 0               | yes      | 1/m3
        m          | exponent of the flaws, 1 to 100      | yes      | -
        crackSpeed | c, > 0; some 0.4 of the wave speed   | yes      | m/s
        failed, weibull, ambientPressure | see failureModel | no     |
    \endtable

    References: D. E. Grady, M. E. Kipp, Int. J. Rock Mech. Min. Sci. 17 (1980)
    147; form of the rate: H. J. Melosh, E. V. Ryan, E. Asphaug, J. Geophys. Res.
    97 (1992) 14735.

\*---------------------------------------------------------------------------*/

#include "failureModel.H"
#include "mathematicalConstants.H"

namespace Foam::mpm
{

class GradyKipp : public failureModel
{
    scalar m_;

    //- (m + 3)/3 A^(1/3) [1/s]; Young's modulus [Pa]
    scalar growth_, E_;

public:
    TypeName("GradyKipp");

    explicit GradyKipp(const dictionary& dict) :
        failureModel(dict, word()),
        m_(bounded(dict, "m", 1, 100)),
        growth_(positive(dict, "crackSpeed")),
        E_(0)
    {
        wordList valid(keywords);
        valid.append(wordList({"k", "m", "crackSpeed"}));
        checkKeywords(dict, valid);

        growth_ *= (m_ + 3) / 3
            * std::cbrt(
                       8 * constant::mathematical::pi * positive(dict, "k")
                       / ((m_ + 1) * (m_ + 2) * (m_ + 3)));
    }

    bool softens() const override { return true; }

    void connect(const constitutiveModel& law, const int nDim) override
    {
        failureModel::connect(law, nDim);
        E_ = law.elasticModulus();
    }

    label correct(pointBlock& b) const override
    {
        label nFailed = 0;
        for (label p = 0; p < b.n; ++p)
        {
            scalar& d = b.damage[p];
            if (d < 1 && largestBound(b, p) > 0)
            {
                const scalar e = max(largestStress(b, p), scalar(0))
                    / (E_ * (b.strength ? b.strength[p] : scalar(1)));
                d = min(pow3(std::cbrt(d) + growth_ * std::pow(e, m_ / 3) * b.dt), scalar(1));
                nFailed += d >= 1;
            }
            if (d > 0)
            {
                release(b, p);
            }
        }
        return nFailed;
    }
};

defineTypeNameAndDebug(GradyKipp, 0);
addToRunTimeSelectionTable(failureModel, GradyKipp, dictionary);

} // End namespace Foam::mpm
