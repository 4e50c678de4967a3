/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::maxPrincipalStrain

Description
    A point fails when its largest principal logarithmic strain exceeds its
    limit. It is the total strain, log(b)/2 with the left Cauchy-Green tensor
    b = F F^T: that of the law's column leftStretch; with laws that only
    have an elastic strain (J2Plasticity, JohnsonCook, DruckerPrager,
    MohrCoulomb) a column leftStretch (b - I) of this model, from the start of the
    run on. What a failed point carries: failureModel.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | maxPrincipalStrain                       | yes      |
        strain   | limit (Weibull: scale), > 0              | yes      | -
        failed, weibull, ambientPressure | see failureModel | no       |
    \endtable

    Reference: B. de Saint-Venant, Comptes rendus 70 (1870) 473.

\*---------------------------------------------------------------------------*/

#include "failureModel.H"
#include "spectral.H"
#include "leftStretch.H"

namespace Foam::mpm
{

class maxPrincipalStrain : public failureModel
{
    //- Index of the column leftStretch; true if it belongs to this model
    int stretch_;
    bool own_;

    //- Step of the model's own column
    template<int DIM>
    void strain(pointBlock b) const;

public:
    TypeName("maxPrincipalStrain");

    explicit maxPrincipalStrain(const dictionary& dict) :
        failureModel(dict, "strain"), stretch_(0), own_(false)
    {
        wordList valid(keywords);
        valid.append("strain");
        checkKeywords(dict, valid);
    }

    void connect(const constitutiveModel& law, const int nDim) override
    {
        failureModel::connect(law, nDim);
        stretch_ = law.columnOf("leftStretch", nDim);
        own_ = stretch_ < 0;
        if (own_)
        {
            stretch_ = law.nColumns(nDim);
        }
        if (own_ && law.columnOf("elasticStrain", nDim) < 0)
        {
            FatalErrorInFunction << "The failure model " << type() << " needs a law with a column"
                                 << " leftStretch or elasticStrain; " << law.type() << " has none."
                                 << exit(FatalError);
        }
    }

    List<historyColumn> history() const override
    {
        const List<historyColumn> own({{"leftStretch", historyColumn::stresses}});
        return own_ ? own : List<historyColumn>();
    }

    label correct(pointBlock& b) const override
    {
        if (own_)
        {
            forDimension(b.nDim, [&](auto D) { this->strain<decltype(D)::value>(b); });
        }
        scalar* const* c = b.history + stretch_;
        label nFailed = 0;
        for (label p = 0; p < b.n; ++p)
        {
            const scalar strain = b.strength ? b.strength[p] : strength();
            const scalar limit = std::expm1(2 * strain);
            if (b.damage[p] < 1)
            {
                // No principal value exceeds the norm
                scalar norm = 0;
                for (int i = 0; i < nStress(b.nDim); ++i)
                {
                    norm += (i < 3 ? 1 : 2) * sqr(c[i][p]);
                }
                if (norm > sqr(limit))
                {
                    double h[9];
                    fullTensor(c, b.nDim, p, h);
                    if (largestPrincipal(h) > limit)
                    {
                        b.damage[p] = 1;
                        ++nFailed;
                    }
                }
            }
            if (b.damage[p] > 0)
            {
                release(b, p);
            }
        }
        return nFailed;
    }
};

template<int DIM>
void maxPrincipalStrain::strain(pointBlock b) const
{
    constexpr int W = laneWidth<DIM>;

    for (int i = 0; i < nStress(DIM); ++i)
    {
        b.history[i] = b.history[stretch_ + i];
    }
    if (DIM == 2 && b.hoop)
    {
        updateHoopStretch<DIM>(b);
    }
    const int nExp = expTerms(largestIncrement<DIM>(b));
    for (label p = 0; p < b.n; p += W)
    {
        lanes<W> c[DIM * DIM];
        updateLeftStretch<DIM>(b, laneGroup<W>(p, b.n), nExp, c);
    }
}

defineTypeNameAndDebug(maxPrincipalStrain, 0);
addToRunTimeSelectionTable(failureModel, maxPrincipalStrain, dictionary);

} // End namespace Foam::mpm
