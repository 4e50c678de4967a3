// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "stressUpdate.H"
#include "dictionaryTools.H"
#include "materialPointSystem.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(stressUpdate, 0);
defineRunTimeSelectionTable(stressUpdate, word);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::stressUpdate> Foam::mpm::stressUpdate::New(const dictionary& dict)
{
    const word name(
        oneOfOrDefault(dict, "stressUpdate", "MUSL", wordConstructorTablePtr_->sortedToc()));
    if (name == "USL" && dict.getOrDefault<word>("shapeFunction", "") == "linear")
    {
        WarningInFunction << "stressUpdate USL with shapeFunction linear grows without bound where"
                          << " a node has little mass, also in free flight. MUSL and USAVG do not,"
                          << " nor does USL with GIMP or quadraticBSpline." << endl;
    }
    return wordConstructorTablePtr_->cfind(name).val()();
}

// * * * * * * * * * * * * * * * Stress Updates  * * * * * * * * * * * * * * //

namespace Foam::mpm
{

class MUSL : public stressUpdate
{
public:
    TypeName("MUSL");

    bool early() const override { return false; }

    void end(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocity();
        points.correctStress(dt, true, dt);
    }
};

defineTypeNameAndDebug(MUSL, 0);
addToRunTimeSelectionTable(stressUpdate, MUSL, word);

class USL : public stressUpdate
{
public:
    TypeName("USL");

    scalar square() const override { return -0.5; }

    void moved(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocityL();
        points.correctStress(dt, false);
    }

    void end(materialPointSystem& points, const scalar dt) const override { points.force(dt); }
};

defineTypeNameAndDebug(USL, 0);
addToRunTimeSelectionTable(stressUpdate, USL, word);

class USF : public stressUpdate
{
public:
    TypeName("USF");

    void start(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocity();
        points.correctStress(dt, true);
    }
};

defineTypeNameAndDebug(USF, 0);
addToRunTimeSelectionTable(stressUpdate, USF, word);

class USAVG : public stressUpdate
{
public:
    TypeName("USAVG");

    scalar square() const override { return 0; }

    void start(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocity();
        points.correctStress(0.5 * dt, true);
    }

    void moved(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocityAnew();
        points.correctStress(0.5 * dt, false);
    }
};

defineTypeNameAndDebug(USAVG, 0);
addToRunTimeSelectionTable(stressUpdate, USAVG, word);

} // End namespace Foam::mpm
