/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::maxPrincipalStress

Description
    A point fails when its largest principal Cauchy stress exceeds its tensile
    strength f: at once, or with a fracture energy along a straight softening
    branch (crack band). The stress it then carries: failureModel.

    Crack band. The energy to open a crack of unit area is Gf [J/m2] whatever
    the width h of the cells, because the branch falls as steeply as the width
    l of the band demands: with the largest principal stress s of the whole
    material and its direction n

        d = r/(r - 1) (1 - f/s),   r = 2 E Gf/(f^2 l) > 1,   l = h sum |n_i|

    and the damage d never falls. Zero stress at s = r f. l is the extent of
    the cell along n, more where the crack crosses the mesh obliquely. E is
    Young's modulus of the law, so Gf is exact under uniaxial stress. A band
    too wide for this, l >= 2 E Gf/f^2, is fatal: its branch would snap
    back. Column crack: the part of Gf that is spent,
    1 - (1 - d) s/f = d/(r - d (r - 1)). Where cracks run and what they take does
    not depend on the cells from about E Gf/(10 f^2) down (tutorials/halfCylinder).

    Measured with one crack through a bar (tests/cases/brittle): Gf within 2 %
    along the cells and within 13 % at 30 and 45 degrees, with cells of
    E Gf/(16 to 8 f^2) and two or more points per cell and direction. A bar
    that flies over the mesh while the crack opens takes 1.0 to 1.5 Gf until it
    is open, and more as it opens further: points that enter the crack's cell
    are torn with it.

    In a gas sigma = -p_0 I is the state without load. A failed point is dry: the
    gas is in its opening, and the pressure of the gas does not act on its
    stress.

Usage
    \table
        Property | Description                              | Required | Unit
        type     | maxPrincipalStress                       | yes      |
        strength | tensile strength (Weibull: scale), > 0   | yes      | Pa
        Gf       | fracture energy, > 0; none: brittle      | no       | J/m2
        limitOn  | total (sigma) or effective (sigma + p_0 I); total | no | -
        failed, weibull, ambientPressure | see failureModel | no       |
    \endtable

    Reference: Z. P. Bazant, B. H. Oh, Materials and structures 16 (1983) 155.

\*---------------------------------------------------------------------------*/

#include "failureModel.H"

namespace Foam::mpm
{

class maxPrincipalStress : public failureModel
{
    //- The limit is on sigma + p_0 I
    bool effective_;

    //- Fracture energy [J/m2], 0: brittle; Young's modulus [Pa]
    scalar Gf_, E_;

    //- Place of the column crack
    int crack_;

    //- Damage of point p at the stress s in the direction n above its
    //  limit; raises the part of Gf that is spent
    scalar damageOf(
        const pointBlock& b, const label p, const scalar s, const scalar (&n)[3],
        const scalar limit, scalar& crack) const;

public:
    TypeName("maxPrincipalStress");

    explicit maxPrincipalStress(const dictionary& dict) :
        failureModel(dict, "strength"),
        effective_(oneOfOrDefault(dict, "limitOn", "total", {"total", "effective"}) == "effective"),
        Gf_(dict.found("Gf") ? positive(dict, "Gf") : 0),
        E_(0),
        crack_(-1)
    {
        wordList valid(keywords);
        valid.append(wordList({"strength", "Gf", "limitOn"}));
        checkKeywords(dict, valid);
    }

    scalar widestBand(const scalar limit) const override
    {
        return Gf_ > 0 ? 2 * E_ * Gf_ / sqr(limit) : GREAT;
    }

    bool needsWidth() const override { return Gf_ > 0; }
    bool softens() const override { return Gf_ > 0; }

    void connect(const constitutiveModel& law, const int nDim) override
    {
        failureModel::connect(law, nDim);
        E_ = law.elasticModulus();
        crack_ = law.nColumns(nDim);
    }

    List<historyColumn> history() const override
    {
        const List<historyColumn> own({{"crack", historyColumn::scalars}});
        return Gf_ > 0 ? own : List<historyColumn>();
    }

    label correct(pointBlock& b) const override
    {
        label nFailed = 0;
        const scalar shift = effective_ ? ambient() : 0;
        scalar n[3], none = 0;
        scalar* crack = Gf_ > 0 ? b.history[crack_] : nullptr;

        for (label p = 0; p < b.n; ++p)
        {
            const scalar limit = b.strength ? b.strength[p] : strength();
            scalar& d = b.damage[p];

            if (d < 1 && largestBound(b, p) + shift > limit)
            {
                const scalar s = largestStress(b, p, n) + shift;
                if (s > limit)
                {
                    d = max(d, damageOf(b, p, s, n, limit, crack ? crack[p] : none));
                    nFailed += d >= 1;
                }
            }
            if (d > 0)
            {
                release(b, p);
            }
        }
        return nFailed;
    }
};

scalar maxPrincipalStress::damageOf(
    const pointBlock& b, const label p, const scalar s, const scalar (&n)[3], const scalar limit,
    scalar& crack) const
{
    if (Gf_ <= 0)
    {
        return 1;
    }
    const scalar across = mag(n[0]) + mag(n[1]) + mag(n[2]);
    const scalar l = max(across, scalar(1)) * b.width[p];
    const scalar r = 2 * E_ * Gf_ / (sqr(limit) * l);
    if (!(r > 1))
    {
        FatalErrorInFunction << "Softening needs bands narrower than 2 E Gf/strength^2 = " << r * l
                             << " m; that of " << b.nameOf(p).c_str() << " is " << l
                             << " m wide, in a cell of " << b.width[p]
                             << " m. Use smaller cells, or no Gf." << exit(FatalError);
    }
    const scalar d = min(r / (r - 1) * (1 - limit / s), scalar(1));
    crack = max(crack, d / (r - d * (r - 1)));
    return d;
}

defineTypeNameAndDebug(maxPrincipalStress, 0);
addToRunTimeSelectionTable(failureModel, maxPrincipalStress, dictionary);

} // End namespace Foam::mpm
