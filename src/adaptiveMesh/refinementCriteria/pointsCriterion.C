// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "refinementCriterion.H"
#include "dictionaryTools.H"
#include "materialPointSystem.H"

namespace Foam::mpm
{

//- Cells with points of phases; of a column whose first component is at least min
class pointsCriterion : public refinementCriterion
{
    const wordList phases_;
    const word column_;
    const scalar min_;

    //- Of the phase of a region
    const word phaseKey{"phase"};

    bool has(const word& phase) const { return phases_.empty() || phases_.found(phase); }

public:
    TypeName("points");

    pointsCriterion(const dictionary& dict, const label maxLevel) :
        refinementCriterion(dict, maxLevel, {"phases", "column", "min"}),
        phases_(dict.getOrDefault<wordList>("phases", wordList())),
        column_(dict.getOrDefault<word>("column", word::null)),
        min_(column_.empty() ? 0 : required<scalar>(dict, "min"))
    {
    }

    void mark(const fvMesh& mesh, scalarField& need) const override
    {
        const materialPointSystem* points =
            mesh.cfindObject<materialPointSystem>("materialPointSystem");
        DynamicList<word> names, columns;
        bool found = column_.empty();
        for (label i = 0; points && i < points->phases().size(); ++i)
        {
            const materialPointPhase& phase = points->phases()[i];
            names.append(phase.name());
            const materialPointCloud& cloud = phase.cloud();
            if (!has(phase.name()))
            {
                continue;
            }
            if (column_.empty())
            {
                UIndirectList<scalar>(need, cloud.cells()) = 1;
                continue;
            }
            columns.append(cloud.columnNames());
            const column* values = cloud.findColumn(column_);
            found = found || values;
            forAll(cloud.cells(), k)
            {
                scalar& most = need[cloud.cells()[k]];
                for (label p = cloud.start()[k]; values && p < cloud.start()[k + 1]; ++p)
                {
                    most = (*values)[0][p] >= min_ ? 1 : most;
                }
            }
        }
        if (!found && names.size())
        {
            FatalIOErrorInFunction(dict())
                << "Entry column: no points have a column " << column_ << "; valid are "
                << flatOutput(columns) << "." << exit(FatalIOError);
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
        if (column_.size())
        {
            return;
        }
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
