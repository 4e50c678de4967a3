/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"
#include "dictionaryTools.H"
#include "noTraps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gasCoupling::readHeat
(
    const label phasei,
    const dictionary& dict
)
{
    if (!dict.found("heatTransfer"))
    {
        return;
    }
    const dictionary& heatDict = requiredDict(dict, "heatTransfer");
    heat_.set(phasei, heatTransferModel::New(heatDict).ptr());
    if (!gas_.thermo().hasTemperature())
    {
        FatalIOErrorInFunction(heatDict)
            << "The gas " << gas_.name() << " (" << gas_.thermo().description().c_str()
            << ") has no temperature and exchanges no heat. Use thermo"
            << " perfectGas."
            << exit(FatalIOError);
    }
    if (heat_[phasei].needsConductivity() && !(mu_ > 0 && Pr_ > 0))
    {
        FatalIOErrorInFunction(heatDict)
            << "The heat transfer of " << points_.phases()[phasei].name()
            << " needs the viscosity and the Prandtl number of the gas: add mu"
            << " [Pa s] and Pr to phase " << gas_.name() << "."
            << exit(FatalIOError);
    }
}


void Foam::mpm::gasCoupling::exchangeHeat(const scalar dt)
{
    const noTraps guard;
    const gasThermo& thermo = gas_.thermo();
    const scalar Cv = thermo.Cv();

    forAll(heat_, phasei)
    {
        if (!heat_.set(phasei))
        {
            continue;
        }
        const materialPointPhase& phase = points_.phases()[phasei];
        materialPointCloud& cloud = points_.phases()[phasei].cloud();
        const scalar* m = cloud.mass()[0];
        const scalar* v = (*cloud.gasVolume())[0];
        scalar* T = (*cloud.temperature())[0];
        const scalar CvS = phase.Cv();

        scalarList energy(cloud.cells().size());
        forAll(cloud.cells(), k)
        {
            const label c = cloud.cells()[k];
            const label begin = cloud.start()[k], end = cloud.start()[k + 1];
            const scalar V = mesh_.V()[c];

            scalar M = 0, mT = 0, volume = 0;
            vector mU(Zero);
            for (label p = begin; p < end; ++p)
            {
                M += m[p];
                mT += m[p]*T[p];
                volume += v[p];
                mU += m[p]*cloud.velocity(p);
            }
            const scalar rho = gas_.rho()[c], theta = gas_.theta()[c];
            const vector u(gas_.rhoU()[c]/rho);
            const scalar Tg =
                (gas_.rhoE()[c]/rho - 0.5*magSqr(u))/Cv;

            const scalar H = heat_[phasei].H
            (
                heatTransferModel::state
                {
                    min((1 - eps_)*volume/V, 1 - eps_),
                    theta,
                    rho/theta,
                    mu_,
                    thermo.Cp(),
                    Pr_,
                    mag(u - mU/M)
                }
            );
            const scalar g = dt*H/(rho*Cv), b = dt*H*V/(M*CvS);
            const scalar TgNew = (Tg*(1 + b) + g*mT/M)/(1 + b + g);

            scalar gained = 0;
            for (label p = begin; p < end; ++p)
            {
                const scalar change = (TgNew - T[p])*(b/(1 + b));
                gained += m[p]*change;
                T[p] += change;
            }
            energy[k] = -CvS*gained/V;
        }
        gas_.addHeat(cloud.cells(), energy);
    }
}


void Foam::mpm::gasCoupling::reportHeat() const
{
    forAll(heat_, phasei)
    {
        if (!heat_.set(phasei))
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
            heat += m[p]*T[p];
            least = min(least, T[p]);
            most = max(most, T[p]);
        }
        Info<< "Heat of " << phase.name() << ": "
            << phase.Cv()*returnReduce(heat, sumOp<scalar>()) << ", T "
            << returnReduce(least, minOp<scalar>()) << " to "
            << returnReduce(most, maxOp<scalar>()) << endl;
    }
}

// ************************************************************************* //
