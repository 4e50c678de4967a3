// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointLoads.H"
#include "materialPointSystem.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointLoads::pointLoads(materialPointSystem& points) : stepPart("loads"), points_(points)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pointLoads::force(const scalar time)
{
    forAll(points_.phases(), phasei)
    {
        materialPointPhase& phase = points_.phases()[phasei];
        velocityField& field = points_.fields()[points_.fieldOf(phasei)];
        if (phase.hasBodyForce())
        {
            points_.gridTransfer().addBodyForce(
                phase.cloud(), phase.acceleration(time), field.force());
        }
        for (const surfaceLoad& load : phase.surfaceLoads())
        {
            load.addForce(
                points_.gridTransfer(), phase.cloud(), time, field.load(), field.stride());
        }
    }
}

bool Foam::mpm::pointLoads::timeDependent() const
{
    for (const materialPointPhase& phase : points_.phases())
    {
        if (phase.hasBodyForce() || phase.surfaceLoads().size())
        {
            return true;
        }
    }
    return false;
}
