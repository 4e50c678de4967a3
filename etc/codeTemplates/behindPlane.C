// An erosion criterion of a user: points leave behind a plane,
// (x - origin).normal > 0.

#include "erosionCriterion.H"
#include "vector.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class behindPlane
:
    public erosionCriterion
{
    const int nDim_;
    const vector origin_, normal_;

public:

    TypeName("behindPlane");

    behindPlane(const dictionary& dict, const erodible& of)
    :
        nDim_(of.nDim),
        origin_(required<vector>(dict, "origin")),
        normal_(required<vector>(dict, "normal"))
    {
        checkKeywords(dict, {"type", "origin", "normal"});
    }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (label p = 0; p < b.points.n; ++p)
        {
            scalar over = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                over += (b.x[d][p] - origin_[b.axis[d]])*normal_[b.axis[d]];
            }
            gone[p] = gone[p] || over > 0;
        }
    }
};

defineTypeNameAndDebug(behindPlane, 0);
addToRunTimeSelectionTable(erosionCriterion, behindPlane, dictionary);

} // End namespace Foam::mpm
