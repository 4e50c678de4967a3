// A part of the step of a user: a spring to the centre of mass of a phase,
// F = -k (centre - rest), given to its points as one acceleration.

#include "materialPointSystem.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"
#include <numeric>

namespace Foam::mpm
{

struct wallSpring
:
    public stepPart
{
    materialPointSystem& points_;
    const label phase_;
    const scalar k_;
    const vector rest_;

    TypeName("wallSpring");

    wallSpring(const word& name, const dictionary& d, materialPointSystem& p)
    :
        stepPart(name),
        points_(p),
        phase_(p.indexOf(oneOf(d, "phase", materialPointPhase::names(p.properties())))),
        k_(positive(d, "k")),
        rest_(required<vector>(d, "rest"))
    {
        checkKeywords(d, {"type", "phase", "k", "rest"});
    }

    void force(const scalar) override
    {
        materialPointCloud& cloud = points_.phases()[phase_].cloud();
        const scalar* m = cloud.mass()[0];
        const scalar* end = m + cloud.size();
        scalar M = std::accumulate(m, end, scalar(0));
        reduce(M, sumOp<scalar>());
        column a("a", column::vectors, points_.grid().nDim());
        a.reserve(cloud.size(), 0);
        for (int d = 0; d < points_.grid().nDim(); ++d)
        {
            scalar mx = std::inner_product(m, end, cloud.x()[d], scalar(0));
            reduce(mx, sumOp<scalar>());
            const scalar off = mx/M - rest_[points_.grid().direction(d)];
            std::fill(a[d], a[d] + cloud.size(), -k_*off/M);
        }
        points_.gridTransfer().addBodyForce
        (cloud, a, points_.fields()[points_.fieldOf(phase_)].load());
    }
};

defineTypeNameAndDebug(wallSpring, 0);
addToRunTimeSelectionTable(stepPart, wallSpring, dictionary);

} // End namespace Foam::mpm
