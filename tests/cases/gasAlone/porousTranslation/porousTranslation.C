/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    porousTranslation

Description
    Test of the gas beside solid without a solver of the solid: points of a slab
    move with the velocity of the gas through a periodic 1D mesh. Fractions and
    fluxes of the faces come from the points by the hat function, fractions of
    the cells by the quadratic B-spline, which fit together exactly if the flux
    is integrated over the step: pressure and velocity must stay uniform and
    theta must stay 1 minus the cells' fraction. Prints the largest deviations.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fvMesh.H"
#include "surfaceFields.H"
#include "Time.H"
#include "volFields.H"
#include "eulerianGas.H"
#include "dictionaryTools.H"
#include <random>

using namespace Foam;

namespace
{

scalar hat(const scalar r) { return max(1 - mag(r), scalar(0)); }

//- Integral of the hat function
scalar hatIntegral(const scalar r)
{
    const scalar s = min(mag(r), scalar(1));
    return sign(r) * (s - 0.5 * s * s);
}

scalar spline(const scalar r)
{
    const scalar s = mag(r);
    return s < 0.5 ? 0.75 - s * s : s < 1.5 ? 0.5 * sqr(1.5 - s) : 0;
}

}

int main(int argc, char* argv[])
{
    argList::noParallel();
    argList::addOption("drag", "K", "drag of the faces [kg/m3/s]");
    argList::addOption("jitter", "j", "random shift of points [spacings]");
    argList::addOption("steps", "n", "number of steps");
#include "setRootCase.H"
#include "createTime.H"
    const fvMesh mesh(
        IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));

    const IOdictionary properties(
        IOobject("phaseProperties", runTime.constant(), mesh, IOobject::MUST_READ));
    mpm::eulerianGas gas(mesh, "air", mpm::requiredDict(properties, "air"), vector::zero);

    const scalar length = mesh.bounds().span().x();
    const scalar h = length / mesh.nCells();
    const scalar area = mesh.V()[0] / h;
    const scalar U = gas.states()[0].u.x(), p0 = gas.states()[0].p;
    const scalar eps = 1e-2;
    const scalar jitter = args.opt<scalar>("jitter", 0);

    // Slab over 0.3 to 0.6 of the length, 4 points per cell
    scalarField x;
    std::mt19937 random(1);
    for (scalar at = 0.3 * length; at < 0.6 * length; at += 0.25 * h)
    {
        const scalar shift = std::uniform_real_distribution<>(-0.5, 0.5)(random);
        x.append(at + 0.125 * h + jitter * shift * 0.25 * h);
    }
    const scalar v = (1 - eps) * 0.25;

    // Periodic distance in cells
    const auto distance = [&](const scalar a, const scalar b)
    {
        const scalar d = a - b;
        return (d - length * std::round(d / length)) / h;
    };
    const auto cellFraction = [&](const label c)
    {
        scalar sum = 0;
        for (const scalar xp : x)
        {
            sum += v * spline(distance(xp, mesh.cellCentres()[c].x()));
        }
        return sum;
    };
    // Now, and the mean over a move that has just ended
    const auto faceFraction = [&](const label f)
    {
        scalar sum = 0;
        for (const scalar xp : x)
        {
            sum += v * hat(distance(xp, mesh.faceCentres()[f].x()));
        }
        return sum;
    };
    const auto meanFaceFraction = [&](const label f, const scalar move)
    {
        scalar sum = 0;
        for (const scalar xp : x)
        {
            const scalar r = distance(xp, mesh.faceCentres()[f].x());
            sum += v * (hatIntegral(r) - hatIntegral(r - move / h)) * h / move;
        }
        return sum;
    };

    scalarField theta(mesh.nCells());
    forAll(theta, c)
    {
        theta[c] = max(1 - cellFraction(c), eps);
    }
    gas.setTheta(theta);

    const label n = mesh.nFaces();
    scalarField raw(n, 0), rawNew(n, 0), thetaS0(n, 0), thetaS(n, 0), phiS(n, 0), uS(n, 0),
        K(n, args.opt<scalar>("drag", 0)), limit(n, 0), rhoS(n, 2700), inertia(n, GREAT),
        dilation(mesh.nCells(), 0);
    mpm::solidOnFaces pores;
    pores.thetaS0 = thetaS0.cdata();
    pores.thetaS = thetaS.cdata();
    pores.phiS = phiS.cdata();
    pores.uS = uS.cdata();
    pores.K = K.cdata();
    pores.dragLimit = limit.cdata();
    pores.inertia = inertia.cdata();
    pores.rhoS = rhoS.cdata();
    pores.dilation = dilation.cdata();
    pores.eps = eps;
    pores.fd = mpm::solidOnFaces::impedance;

    const auto across = [&](const label f) { return mag(mesh.faceAreas()[f].x()) > 0.5 * area; };
    for (label f = 0; f < n; ++f)
    {
        raw[f] = across(f) ? faceFraction(f) : 0;
    }

    const label nSteps = args.opt<label>("steps", 500);
    scalar worstP = 0, worstU = 0, worstTheta = 0;
    for (label step = 0; step < nSteps; ++step)
    {
        const scalar dt = 0.3 / gas.courantRate();
        for (scalar& xp : x)
        {
            xp += U * dt;
        }
        for (label f = 0; f < n; ++f)
        {
            if (!across(f))
            {
                continue;
            }
            rawNew[f] = faceFraction(f);
            const scalar mean = meanFaceFraction(f, U * dt);
            const scalar S = mesh.faceAreas()[f].x();
            thetaS0[f] = min(max(raw[f], scalar(0)), 1 - eps);
            thetaS[f] = min(max(mean, scalar(0)), 1 - eps);
            phiS[f] = thetaS[f] * U * S;
            uS[f] = U * sign(S);
            limit[f] = thetaS[f];
        }
        raw = rawNew;

        gas.step(dt, &pores);
        runTime.setDeltaT(dt);
        ++runTime;
        gas.correct();

        forAll(theta, c)
        {
            const mpm::gasState& w = gas.states()[c];
            worstP = max(worstP, mag(w.p / p0 - 1));
            worstU = max(worstU, mag(w.u.x() / U - 1));
            worstTheta = max(worstTheta, mag(gas.theta()[c] + cellFraction(c) - 1));
        }
    }
    Info << "pressure " << worstP << " velocity " << worstU << " theta " << worstTheta << " fixups "
         << gas.fixed().limited << ' ' << gas.fixed().theta << ' ' << gas.fixed().isentropic << nl
         << "End" << endl;

    return 0;
}
