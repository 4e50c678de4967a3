// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fluctuationExchange.H"
#include "dictionaryTools.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fluctuationExchange::exchange(const label phasei, const scalar dt)
{
    materialPointCloud& cloud = points_.phases()[phasei].cloud();
    const scalar* m = cloud.mass()[0];
    const scalar* v = (*cloud.gasVolume())[0];
    scalar* T = cloud.history()[column_[phasei]][0];
    const scalar rootPi = std::sqrt(constant::mathematical::pi);

    scalarList energy(cloud.cells().size(), scalar(0));
    forAll(cloud.cells(), k)
    {
        const label c = cloud.cells()[k];
        const scalar V = fraction_.mesh().V()[c];
        const scalar M = cellSum(cloud, k, m);
        const vector mU(
            cellSumOf(cloud, k, [&](const label p) { return m[p] * cloud.velocity(p); }));
        const scalar u = mag(gas_.rhoU()[c] / gas_.rho()[c] - mU / M);
        const scalar thetaS = fraction_.ofPoints(cellSum(cloud, k, v), V);
        const scalar b = drag_.coefficient(phasei, c, thetaS, u) * V / M;

        // Of s^3 what is left of the start, and what J has added
        const scalar x = 3 * b * dt, left = std::exp(-x);
        const scalar J = sqr(b * u) * d_[phasei] / (4 * rootPi);
        const scalar fed = J * dt * (x > 1e-8 ? -std::expm1(-x) / x : 1);
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            const scalar before = T[p];
            T[p] = sqr(std::cbrt(left * before * std::sqrt(before) + fed));
            energy[k] -= 1.5 * m[p] * (T[p] - before) / V;
        }
    }
    if (gas_.hasEnergy())
    {
        gas_.addHeat(cloud.cells(), energy);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fluctuationExchange::fluctuationExchange(
    materialPointSystem& points, eulerianFlow& gas, const solidFraction& fraction,
    const dragExchange& drag, const dictionary& phaseProperties) :
    points_(points),
    gas_(gas),
    fraction_(fraction),
    drag_(drag),
    column_(points.phases().size(), -1),
    d_(points.phases().size(), scalar(0))
{
    forAll(column_, phasei)
    {
        const materialPointPhase& phase = points_.phases()[phasei];
        const UPtrList<column>& history = phase.cloud().history();
        forAll(history, i)
        {
            if (drag_.finite(phasei) && history[i].name() == "granularTemperature")
            {
                column_[phasei] = i;
            }
        }
        if (column_[phasei] >= 0)
        {
            const dictionary& dict = requiredDict(phaseProperties, phase.name());
            d_[phasei] = positive(requiredDict(dict, "constitutiveModel"), "d");
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fluctuationExchange::exchange(const scalar dt)
{
    forAll(column_, phasei)
    {
        if (column_[phasei] >= 0)
        {
            exchange(phasei, dt);
        }
    }
}
