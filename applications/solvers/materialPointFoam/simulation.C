/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "simulation.H"
#include "phaseNames.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "timer.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::simulation::simulation(const fvMesh& mesh)
:
    mesh_(mesh),
    seconds_(0)
{
    const IOdictionary phaseProperties
    (
        IOobject
        (
            "phaseProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    if (phaseNames(phaseProperties, {"materialPoints", "rigid"}).size())
    {
        points_.reset(new materialPointSystem(mesh));
    }
    makeGas(phaseProperties);
    if (points_ && gas_)
    {
        coupling_.reset(new gasCoupling(*points_, *gas_, phaseProperties));
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::simulation::makeGas(const dictionary& phaseProperties)
{
    const wordList names(phaseNames(phaseProperties, {"gas"}));
    if (names.empty())
    {
        return;
    }
    if (names.size() > 1)
    {
        FatalIOErrorInFunction(phaseProperties)
            << "There are " << names.size() << " phases of type gas "
            << flatOutput(names) << "; there may be one."
            << exit(FatalIOError);
    }
    vector g(Zero);
    IOobject header
    (
        "g",
        mesh_.time().constant(),
        mesh_,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (header.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        g = uniformDimensionedVectorField(header).value();
        checkGravity(header.objectPath(), g, mesh_.geometricD());
    }
    gas_.reset
    (
        new eulerianGas
        (
            mesh_,
            names[0],
            requiredDict(phaseProperties, names[0]),
            g
        )
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::simulation::readModified()
{
    if (points_)
    {
        points_->readModified();
    }
}


bool Foam::mpm::simulation::advancePoints(const scalar dt, scalar& factor)
{
    return !points_ || points_->advance(dt, factor);
}


void Foam::mpm::simulation::advanceGas(const scalar dt)
{
    const timer t(gasSeconds());
    if (coupling_)
    {
        coupling_->advanceGas(dt);
    }
    else if (gas_)
    {
        gas_->faceFlux(dt);
        gas_->advance(dt);
    }
}


void Foam::mpm::simulation::correct()
{
    if (gas_)
    {
        const timer t(gasSeconds());
        gas_->correct();
    }
}


void Foam::mpm::simulation::report() const
{
    if (points_)
    {
        points_->report();
    }
    if (gas_)
    {
        gas_->report();
    }
}


void Foam::mpm::simulation::write()
{
    if (points_)
    {
        points_->writePoints();
    }
    if (gas_)
    {
        gas_->writeFields();
    }
}


void Foam::mpm::simulation::reportClock() const
{
    if (points_)
    {
        points_->reportClock();
    }
}

// ************************************************************************* //
