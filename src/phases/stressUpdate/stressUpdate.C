/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "stressUpdate.H"
#include "materialPointSystem.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

struct MUSL
:
    public stressUpdate
{
    const char* name() const override { return "MUSL"; }

    bool early() const override { return false; }

    void end(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocity();
        points.correctStress(dt, true, dt);
    }
};


struct USL
:
    public stressUpdate
{
    const char* name() const override { return "USL"; }

    scalar square() const override { return -0.5; }

    void moved(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocityL();
        points.correctStress(dt, false);
    }

    void end(materialPointSystem& points, const scalar dt) const override
    {
        points.force(dt);
    }
};


struct USF
:
    public stressUpdate
{
    const char* name() const override { return "USF"; }

    void start(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocity();
        points.correctStress(dt, true);
    }
};


struct USAVG
:
    public stressUpdate
{
    const char* name() const override { return "USAVG"; }

    scalar square() const override { return 0; }

    void start(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocity();
        points.correctStress(0.5*dt, true);
    }

    void moved(materialPointSystem& points, const scalar dt) const override
    {
        points.strainVelocityAnew();
        points.correctStress(0.5*dt, false);
    }
};

}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::stressUpdate>
Foam::mpm::stressUpdate::New(const dictionary& dict)
{
    const word name
    (
        oneOfOrDefault
        (
            dict,
            "stressUpdate",
            "MUSL",
            {"MUSL", "USL", "USF", "USAVG"}
        )
    );
    return autoPtr<stressUpdate>
    (
        name == "USL" ? static_cast<stressUpdate*>(new USL)
      : name == "USF" ? static_cast<stressUpdate*>(new USF)
      : name == "USAVG" ? static_cast<stressUpdate*>(new USAVG)
      : static_cast<stressUpdate*>(new MUSL)
    );
}

// ************************************************************************* //
