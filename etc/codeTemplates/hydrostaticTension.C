// A failure model of a user: a point fails where its mean stress is above the
// strength.

#include "failureModel.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class hydrostaticTension
:
    public failureModel
{
public:

    TypeName("hydrostaticTension");

    explicit hydrostaticTension(const dictionary& dict)
    :
        failureModel(dict, "strength")
    {
        wordList valid(keywords);
        valid.append("strength");
        checkKeywords(dict, valid);
    }

    label correct(pointBlock& b) const override
    {
        label nFailed = 0;
        for (label p = 0; p < b.n; ++p)
        {
            const scalar limit = b.strength ? b.strength[p] : strength();
            const scalar mean =
                (b.stress[0][p] + b.stress[1][p] + b.stress[2][p])/3;
            if (b.damage[p] < 1 && mean > limit)
            {
                b.damage[p] = 1;
                ++nFailed;
            }
            if (b.damage[p] >= 1)
            {
                release(b, p);
            }
        }
        return nFailed;
    }
};

defineTypeNameAndDebug(hydrostaticTension, 0);
addToRunTimeSelectionTable(failureModel, hydrostaticTension, dictionary);

} // End namespace Foam::mpm
