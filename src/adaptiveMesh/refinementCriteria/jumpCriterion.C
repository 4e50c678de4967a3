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
            FatalIOErrorInFunction(dict) << "A jump needs an entry relative or absolute."
                                         << exit(FatalIOError);
        }
    }

    void mark(const fvMesh& mesh, boolList& marked) const override
    {
        const volScalarField& v = mesh.lookupObject<volScalarField>(
            oneOf(dict(), "field", mesh.sortedNames<volScalarField>()));
        const auto jumps = [&](const scalar a, const scalar b)
        {
            return mag(a - b) > absolute_
                || mag(a - b) > relative_ * 0.5 * (mag(a) + mag(b));
        };
        scalarField behind;
        syncTools::swapBoundaryCellList(mesh, v.primitiveField(), behind);
        for (label f = 0; f < mesh.nFaces(); ++f)
        {
            const label P = mesh.faceOwner()[f];
            if (mesh.isInternalFace(f))
            {
                const label N = mesh.faceNeighbour()[f];
                if (jumps(v[P], v[N]))
                {
                    marked[P] = marked[N] = true;
                }
            }
            else if (
                mesh.boundaryMesh()[mesh.boundaryMesh().whichPatch(f)].coupled()
                && jumps(v[P], behind[f - mesh.nInternalFaces()]))
            {
                marked[P] = true;
            }
        }
    }

    //- A fluid ends where its shape does
    void markStart(const polyMesh& mesh, boolList& marked) const override
    {
        const dictionary regions(systemDict(mesh, "setFluidsDict").subOrEmptyDict("regions"));
        for (const entry& e : regions)
        {
            if (e.isDict())
            {
                markShape(mesh, e.dict(), true, marked);
            }
        }
    }
};

defineTypeNameAndDebug(jumpCriterion, 0);
addToRunTimeSelectionTable(refinementCriterion, jumpCriterion, dictionary);

} // End namespace Foam::mpm
