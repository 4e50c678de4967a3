// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "heatExchange.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::heatExchange::read(const label phasei, const dictionary& dict)
{
    const dictionary& heatDict = requiredDict(dict, "heatTransfer");
    models_.set(phasei, heatTransferModel::New(heatDict).ptr());
    gas_.needTemperature(heatDict);
    if (models_[phasei].needsConductivity() && !(mu_ > 0 && Pr_ > 0))
    {
        FatalIOErrorInFunction(heatDict)
            << "The heat transfer of " << points_.phases()[phasei].name()
            << " needs the viscosity and the Prandtl number of the gas: add mu"
            << " [Pa s] and Pr to phase " << gas_.name() << "." << exit(FatalIOError);
    }
}

void Foam::mpm::heatExchange::exchange(const label phasei, const scalar dt)
{
    const scalar CvS = points_.phases()[phasei].Cv();
    materialPointCloud& cloud = points_.phases()[phasei].cloud();
    const scalar* m = cloud.mass()[0];
    const scalar* v = (*cloud.gasVolume())[0];
    scalar* T = (*cloud.temperature())[0];

    scalarList energy(cloud.cells().size());
    forAll(cloud.cells(), k)
    {
        const label c = cloud.cells()[k];
        const scalar V = fraction_.mesh().V()[c];
        const label begin = cloud.start()[k], end = cloud.start()[k + 1];

        // One pass for all sums: points are read once
        scalar M = 0, mT = 0, volume = 0;
        vector mU(Zero);
        for (label p = begin; p < end; ++p)
        {
            M += m[p];
            mT += m[p] * T[p];
            volume += v[p];
            mU += m[p] * cloud.velocity(p);
        }
        const scalar rho = gas_.rho()[c], theta = gas_.theta()[c];
        const vector u(gas_.rhoU()[c] / rho);
        const eulerianFlow::heatState gas(gas_.heat(c));

        const scalar H = models_[phasei].H(heatTransferModel::state{
            fraction_.ofPoints(volume, V), theta, rho / theta, mu_, gas.Cp, Pr_, mag(u - mU / M)});
        const scalar g = dt * H / gas.rhoCv, b = dt * H * V / (M * CvS);
        const scalar TgNew = (gas.T * (1 + b) + g * mT / M) / (1 + b + g);

        scalar gained = 0;
        for (label p = begin; p < end; ++p)
        {
            const scalar change = (TgNew - T[p]) * (b / (1 + b));
            gained += m[p] * change;
            T[p] += change;
        }
        energy[k] = -CvS * gained / V;
        gain_ -= CvS * gained;
    }
    gas_.addHeat(cloud.cells(), energy);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::heatExchange::heatExchange(
    materialPointSystem& points, eulerianFlow& gas, const solidFraction& fraction,
    const dictionary& phaseProperties) :
    points_(points),
    gas_(gas),
    fraction_(fraction),
    mu_(boundedOrDefault(requiredDict(phaseProperties, gas.name()), "mu", 0, 0, GREAT)),
    Pr_(boundedOrDefault(requiredDict(phaseProperties, gas.name()), "Pr", 0, 0, GREAT)),
    models_(points.phases().size()),
    gain_(0)
{
    forAll(points_.phases(), phasei)
    {
        const dictionary& dict = requiredDict(phaseProperties, points_.phases()[phasei].name());
        if (dict.found("heatTransfer"))
        {
            read(phasei, dict);
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::heatExchange::acts() const
{
    forAll(models_, phasei)
    {
        if (models_.set(phasei))
        {
            return true;
        }
    }
    return false;
}

void Foam::mpm::heatExchange::exchange(const scalar dt)
{
    gain_ = 0;
    forAll(models_, phasei)
    {
        if (models_.set(phasei))
        {
            exchange(phasei, dt);
        }
    }
}

void Foam::mpm::heatExchange::report() const
{
    forAll(models_, phasei)
    {
        if (!models_.set(phasei))
        {
            continue;
        }
        const materialPointPhase& phase = points_.phases()[phasei];
        const materialPointCloud& cloud = phase.cloud();
        const scalar* m = cloud.mass()[0];
        const scalar* T = (*cloud.temperature())[0];
        scalar heat = 0, least = GREAT, most = -GREAT;
        for (label p = 0; p < cloud.size(); ++p)
        {
            heat += m[p] * T[p];
            least = min(least, T[p]);
            most = max(most, T[p]);
        }
        Info << "Heat of " << phase.name() << ": "
             << phase.Cv() * returnReduce(heat, sumOp<scalar>()) << ", T "
             << returnReduce(least, minOp<scalar>()) << " to "
             << returnReduce(most, maxOp<scalar>()) << endl;
    }
}
