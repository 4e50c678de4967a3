// A stress update of a user, in one file and loaded with libs (...): the whole
// step with u^L at x^n, before the points are sorted. USL by another name.

#include "stressUpdate.H"
#include "materialPointSystem.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace mpm
{

class fullStepAtL
:
    public stressUpdate
{
public:

    TypeName("fullStepAtL");

    scalar square() const override { return -0.5; }

    void moved(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocityL();
        points.correctStress(dt, false);
    }

    void end(materialPointSystem& points, const scalar dt) const override
    {
        points.force(dt);
    }
};

defineTypeNameAndDebug(fullStepAtL, 0);
addToRunTimeSelectionTable(stressUpdate, fullStepAtL, word);

} // End namespace mpm
} // End namespace Foam
