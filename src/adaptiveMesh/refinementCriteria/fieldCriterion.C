// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "refinementCriterion.H"
#include "dictionaryTools.H"
#include "volFields.H"

namespace Foam::mpm
{

//- Cells whose value lies between two
class fieldCriterion : public refinementCriterion
{
    const word field_;
    const scalar min_, max_;

public:
    TypeName("field");

    fieldCriterion(const dictionary& dict, const label maxLevel) :
        refinementCriterion(dict, maxLevel, {"field", "min", "max"}),
        field_(required<word>(dict, "field")),
        min_(boundedOrDefault(dict, "min", -GREAT, -GREAT, GREAT)),
        max_(boundedOrDefault(dict, "max", GREAT, -GREAT, GREAT))
    {
    }

    void mark(const fvMesh& mesh, scalarField& need) const override
    {
        const volScalarField& v = mesh.lookupObject<volScalarField>(
            oneOf(dict(), "field", mesh.sortedNames<volScalarField>()));
        forAll(need, c)
        {
            need[c] = v[c] >= min_ && v[c] <= max_ ? 1 : 0;
        }
    }
};

defineTypeNameAndDebug(fieldCriterion, 0);
addToRunTimeSelectionTable(refinementCriterion, fieldCriterion, dictionary);

} // End namespace Foam::mpm
