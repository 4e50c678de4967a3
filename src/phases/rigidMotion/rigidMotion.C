// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "rigidMotion.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(rigidMotion, 0);
defineRunTimeSelectionTable(rigidMotion, dictionary);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::rigidMotion::rigidMotion(const pointGrid& grid) : grid_(grid) {}

Foam::autoPtr<Foam::mpm::rigidMotion>
Foam::mpm::rigidMotion::New(const dictionary& phaseDict, const pointGrid& grid)
{
    dictionary fixed;
    fixed.add("type", word("fixed"));
    const dictionary& dict = phaseDict.found("motion") ? requiredDict(phaseDict, "motion") : fixed;

    return selectFromTable<rigidMotion>(dict, dictionaryConstructorTablePtr_, dict, grid);
}

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::mpm::rigidMotion::checkDirection(const vector& v, const char* what) const
{
    vector across(v);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        across[grid_.direction(d)] = 0;
    }
    if (mag(across) > 1e-12 * mag(v))
    {
        FatalErrorInFunction << "The " << what << ' ' << v << " of a rigid phase has a"
                             << " component in a direction that is not computed (empty"
                             << " patches)." << exit(FatalError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::rigidMotion::setVelocity(materialPointCloud& cloud) const
{
    forAll(cloud.cells(), k)
    {
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            const vector U(placement_.velocityAt(cloud.position(p, cloud.cells()[k])));
            for (int d = 0; d < grid_.nDim(); ++d)
            {
                cloud.U()[d][p] = U[grid_.direction(d)];
            }
        }
    }
}

Foam::mpm::pointGridTransfer::moveResult Foam::mpm::rigidMotion::move(
    materialPointCloud& cloud, DynamicList<materialPointCloud::cellChange>& cellChanges) const
{
    const int D = grid_.nDim();
    pointGridTransfer::moveResult result{0, 0, -1, false, 0, Zero, 0};
    cellChanges.clear();

    forAll(cloud.cells(), k)
    {
        const label celli = cloud.cells()[k];
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            // Directions that are not computed stay on the mid-plane, where
            // the axis of a rotation has no arm
            point X(cloud.position(p, celli));
            for (int d = 0; d < D; ++d)
            {
                X[grid_.direction(d)] = (*cloud.reference())[d][p];
            }
            const point x(placement_.position(X));
            const vector U(placement_.velocityAt(x));

            // The motion's position may be whole periods away
            scalar at[3], old[3] = {0, 0, 0};
            const bool finite = std::isfinite(magSqr(x));
            for (int d = 0; d < D; ++d)
            {
                at[d] = x[grid_.direction(d)];
                const scalar L = grid_.period(d);
                if (finite && L > 0)
                {
                    at[d] -= L * std::round((at[d] - cloud.x()[d][p]) / L);
                }
            }

            // Pass cyclic sides as often as necessary
            label to = -1;
            bool wrapped = finite;
            while (to < 0 && wrapped)
            {
                std::copy(at, at + D, old);
                to = grid_.locate(celli, at);
                wrapped = !std::equal(at, at + D, old);
            }
            for (int d = 0; d < D; ++d)
            {
                const scalar h = grid_.width(celli, d);
                const scalar u = U[grid_.direction(d)];
                const scalar way = mag(at[d] - cloud.x()[d][p]);
                result.rate = max(result.rate, mag(u) / h);
                if (way < 0.5 * grid_.mesh().bounds().span()[grid_.direction(d)])
                {
                    result.travel = max(result.travel, way / h);
                }
                if (cloud.displacement())
                {
                    // Displacement of the step, not across a cyclic side
                    const scalar L = grid_.period(d);
                    scalar w = at[d] - cloud.x()[d][p];
                    w -= L > 0 ? L * std::round(w / L) : 0;
                    (*cloud.displacement())[d][p] = w;
                }
                cloud.xNew()[d][p] = at[d];
                cloud.UNew()[d][p] = u;
            }
            if (to < 0)
            {
                result.badPoint = p;
                result.left = finite;
            }
            else if (to != celli)
            {
                cellChanges.append(materialPointCloud::cellChange{p, to});
            }
        }
    }
    return result;
}
