// A criterion of a user for system/adaptiveMeshDict: cells with points that are
// faster than  speed  [m/s]; those with more than a third of it stay fine.

#include "refinementCriterion.H"
#include "materialPointSystem.H"
#include "dictionaryTools.H"

namespace Foam::mpm
{

class fastPoints
:
    public refinementCriterion
{
    const scalar speed_;

public:

    TypeName("fastPoints");

    fastPoints(const dictionary& dict, const label maxLevel)
    :
        refinementCriterion(dict, maxLevel, {"speed"}),
        speed_(required<scalar>(dict, "speed"))
    {}

    // need: 1 and more: fine; more than 1/3: stays fine
    void mark(const fvMesh& mesh, scalarField& need) const override
    {
        const auto& all = mesh.lookupObject<materialPointSystem>("materialPointSystem");
        for (const materialPointPhase& phase : all.phases())
        {
            const materialPointCloud& cloud = phase.cloud();
            forAll(cloud.cells(), k)
            {
                scalar& most = need[cloud.cells()[k]];
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    scalar square = 0;
                    for (int d = 0; d < mesh.nGeometricD(); ++d)
                    {
                        square += sqr(cloud.U()[d][p]);
                    }
                    most = max(most, sqrt(square)/speed_);
                }
            }
        }
    }
};

defineTypeNameAndDebug(fastPoints, 0);
addToRunTimeSelectionTable(refinementCriterion, fastPoints, dictionary);

} // End namespace Foam::mpm
