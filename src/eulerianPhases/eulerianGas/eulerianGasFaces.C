/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "eulerianGas.H"
#include "noTraps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::eulerianGas::faceFlux(const scalar dt, const solidOnFaces* pores)
{
    const noTraps guard;

    if (pores)
    {
        if (!thermo_.isGammaLaw())
        {
            FatalErrorInFunction
                << "Gas " << name_ << " has an equationOfState: it runs without"
                << " solid only." << exit(FatalError);
        }
        porous_ = true;
        markNearSolid(*pores);
    }
    if (!reconstruction_.upwind())
    {
        reconstruction_.update
        (
            dt, {&thermo_, W_, Wb_, t_, tb_}, rho0_, U_, p_,
            pores ? &near_ : nullptr
        );
    }

    const mpm::faceFlux::result to{phi_, pStar_, out_};
    if (pores)
    {
        faceFlux_->flux
        (
            allStates<false>(), {dt, theta_, thetaB_, near_, *pores}, to
        );
        farFaces(pores);
        limitOutflow<true>(dt, pores);
        return;
    }
    if (thermo_.isGammaLaw())
    {
        faceFlux_->flux(allStates<false>(), to);
    }
    else
    {
        faceFlux_->flux(allStates<true>(), to);
    }
    farFaces(nullptr);
    limitOutflow<false>(dt, pores);
}

// ************************************************************************* //
