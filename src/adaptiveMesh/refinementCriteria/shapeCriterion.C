// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "refinementCriterion.H"
#include "dictionaryTools.H"
#include "Time.H"

namespace Foam::mpm
{

//- Cells in a shape, for a time
class shapeCriterion : public refinementCriterion
{
    const dictionary& shape_;
    const scalar from_, to_;

public:
    TypeName("shape");

    shapeCriterion(const dictionary& dict, const label maxLevel) :
        refinementCriterion(dict, maxLevel, {"shape", "from", "to"}),
        shape_(requiredDict(this->dict(), "shape")),
        from_(boundedOrDefault(dict, "from", -GREAT, -GREAT, GREAT)),
        to_(boundedOrDefault(dict, "to", GREAT, -GREAT, GREAT))
    {
    }

    void mark(const fvMesh& mesh, scalarField& need) const override { markStart(mesh, need); }

    void markStart(const polyMesh& mesh, scalarField& need) const override
    {
        const scalar t = mesh.time().value();
        if (t >= from_ && t <= to_)
        {
            markShape(mesh, shape_, false, need);
        }
    }
};

defineTypeNameAndDebug(shapeCriterion, 0);
addToRunTimeSelectionTable(refinementCriterion, shapeCriterion, dictionary);

} // End namespace Foam::mpm
