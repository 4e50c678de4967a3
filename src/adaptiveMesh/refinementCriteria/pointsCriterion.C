// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "refinementCriterion.H"
#include "dictionaryTools.H"
#include "materialPointSystem.H"

namespace Foam::mpm
{

//- Cells with points of phases
class pointsCriterion : public refinementCriterion
{
    const wordList phases_;

    //- Of the phase of a region
    const word phaseKey{"phase"};

    bool has(const word& phase) const { return phases_.empty() || phases_.found(phase); }

public:
    TypeName("points");

    pointsCriterion(const dictionary& dict, const label maxLevel) :
        refinementCriterion(dict, maxLevel, {"phases"}),
        phases_(dict.getOrDefault<wordList>("phases", wordList()))
    {
    }

    void mark(const fvMesh& mesh, scalarField& need) const override
    {
        const materialPointSystem* points =
            mesh.cfindObject<materialPointSystem>("materialPointSystem");
        DynamicList<word> names;
        for (label i = 0; points && i < points->phases().size(); ++i)
        {
            const materialPointPhase& phase = points->phases()[i];
            names.append(phase.name());
            if (has(phase.name()))
            {
                UIndirectList<scalar>(need, phase.cloud().cells()) = 1;
            }
        }
        for (const word& name : phases_)
        {
            if (!names.found(name))
            {
                FatalIOErrorInFunction(dict())
                    << "Entry phases: there is no phase " << name << " with material points; valid"
                    << " are " << flatOutput(names) << "." << exit(FatalIOError);
            }
        }
    }

    void markStart(const polyMesh& mesh, scalarField& need) const override
    {
        for (const entry& e : regionsOf(mesh, "setMaterialPointsDict"))
        {
            if (e.isDict() && has(required<word>(e.dict(), phaseKey)))
            {
                markShape(mesh, e.dict(), false, need);
            }
        }
    }
};

defineTypeNameAndDebug(pointsCriterion, 0);
addToRunTimeSelectionTable(refinementCriterion, pointsCriterion, dictionary);

} // End namespace Foam::mpm
