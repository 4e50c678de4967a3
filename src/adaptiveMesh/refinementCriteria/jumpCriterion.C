// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "refinementCriterion.H"
#include "dictionaryTools.H"
#include "syncTools.H"
#include "volFields.H"

namespace Foam::mpm
{

//- Cells on both sides of a face across which a field jumps
class jumpCriterion : public refinementCriterion
{
    const word field_;
    const scalar relative_, absolute_;

public:
    TypeName("jump");

    jumpCriterion(const dictionary& dict, const label maxLevel) :
        refinementCriterion(dict, maxLevel, {"field", "relative", "absolute"}),
        field_(required<word>(dict, "field")),
        relative_(boundedOrDefault(dict, "relative", GREAT, 0, GREAT)),
        absolute_(boundedOrDefault(dict, "absolute", GREAT, 0, GREAT))
    {
        if (relative_ >= GREAT && absolute_ >= GREAT)
        {
            FatalIOErrorInFunction(dict)
                << "A jump needs an entry relative or absolute." << exit(FatalIOError);
        }
    }

    void mark(const fvMesh& mesh, scalarField& need) const override
    {
        const volScalarField& v = mesh.lookupObject<volScalarField>(
            oneOf(dict(), "field", mesh.sortedNames<volScalarField>()));
        const auto jump = [&](const scalar a, const scalar b)
        { return mag(a - b) / min(absolute_, max(relative_ * 0.5 * (mag(a) + mag(b)), VSMALL)); };
        scalarField behind;
        syncTools::swapBoundaryCellList(mesh, v.primitiveField(), behind);
        const label nInternal = mesh.nInternalFaces();
        for (label f = 0; f < nInternal; ++f)
        {
            const label P = mesh.faceOwner()[f], N = mesh.faceNeighbour()[f];
            const scalar j = jump(v[P], v[N]);
            need[P] = max(need[P], j);
            need[N] = max(need[N], j);
        }
        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            for (label f = pp.start(); pp.coupled() && f < pp.start() + pp.size(); ++f)
            {
                const label P = mesh.faceOwner()[f];
                need[P] = max(need[P], jump(v[P], behind[f - nInternal]));
            }
        }
    }

    //- A fluid ends where its shape does
    void markStart(const polyMesh& mesh, scalarField& need) const override
    {
        for (const entry& e : regionsOf(mesh, "setFluidsDict"))
        {
            if (e.isDict())
            {
                markShape(mesh, e.dict(), true, need);
            }
        }
    }
};

defineTypeNameAndDebug(jumpCriterion, 0);
addToRunTimeSelectionTable(refinementCriterion, jumpCriterion, dictionary);

} // End namespace Foam::mpm
