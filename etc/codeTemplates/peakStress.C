// A column of a user: the largest equivalent stress that each point of a phase
// has had at the end of a step [Pa], kept by a part of the step. The column is
// written, read by a restart, sent and sorted with the points.

#include "materialPointSystem.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

struct peakStress
:
    public stepPart
{
    materialPointCloud& cloud_;
    column& peak_;

    TypeName("peakStress");

    peakStress(const word& name, const dictionary& d, materialPointSystem& p)
    :
        stepPart(name),
        cloud_
        (
            p.phases()
            [
                p.indexOf
                (
                    oneOf(d, "phase", materialPointPhase::names(p.properties()))
                )
            ].cloud()
        ),
        peak_(cloud_.need(name, column::scalars, columnRules(columnRules::sinceRun)))
    {
        checkKeywords(d, {"type", "phase"});
    }

    void end(const scalar) override
    {
        for (label p = 0; p < cloud_.size(); ++p)
        {
            const scalar now = std::sqrt(1.5)*mag(dev(cloud_.sigma(p)));
            peak_[0][p] = max(peak_[0][p], now);
        }
    }
};

defineTypeNameAndDebug(peakStress, 0);
addToRunTimeSelectionTable(stepPart, peakStress, dictionary);

} // End namespace Foam::mpm
