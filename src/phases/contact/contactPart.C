/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "contactPart.H"
#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::contactPart::contactPart(materialPointSystem& points)
:
    stepPart("contact"),
    points_(points),
    contact_
    (
        pointContact::New
        (
            points.properties(),
            points.grid(),
            points.phases(),
            points.fields(),
            points.fieldOf(),
            points.gridTransfer()
        )
    )
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::contactPart::impulse(const scalar dt)
{
    pointEnergy& energy = points_.energy();
    const scalar boundary = contact_->applyImpulses(dt, energy.active());
    if (energy.active())
    {
        energy.sums().step.boundary +=
            returnReduce(boundary, sumOp<scalar>());
    }
}


void Foam::mpm::contactPart::filtered(const bool changesMomentum)
{
    contact_->filter(changesMomentum);
}


void Foam::mpm::contactPart::exchange(const scalar)
{
    pointEnergy& energy = points_.energy();
    if (energy.active())
    {
        scalar driven;
        const scalar work = contact_->work(driven);
        energy.sums().step.contact += returnReduce(work, sumOp<scalar>());
        energy.sums().step.driven += returnReduce(driven, sumOp<scalar>());
    }
}


void Foam::mpm::contactPart::strainVelocity(const scalar dt)
{
    contact_->applyStrainImpulses(dt);
}


void Foam::mpm::contactPart::started()
{
    contact_->update();
}


void Foam::mpm::contactPart::accepted(const scalar)
{
    contact_->accept();
    if (!points_.strainsEarly())
    {
        contact_->update();
    }
}


void Foam::mpm::contactPart::end(const scalar)
{
    // Of use to a strain at the start of the next step only
    if (!points_.strainsEarly())
    {
        contact_->release();
    }
    contact_->update();
}


void Foam::mpm::contactPart::addState(dictionary& state) const
{
    state.add("contact", contact_->state());
}


void Foam::mpm::contactPart::setState(const dictionary& state)
{
    if (state.found("contact"))
    {
        contact_->setState(requiredDict(state, "contact"));
    }
}


void Foam::mpm::contactPart::report() const
{
    contact_->report(points_.deltaT());
}

// ************************************************************************* //
