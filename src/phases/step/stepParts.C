/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "stepParts.H"
#include "dictionaryTools.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::stepParts::add(stepPart& part)
{
    all_.append(&part);
    std::stable_sort
    (
        all_.begin(),
        all_.end(),
        [](const stepPart* a, const stepPart* b)
        {
            return a->order() < b->order();
        }
    );
}


void Foam::mpm::stepParts::select
(
    const dictionary* dict,
    materialPointSystem& points
)
{
    if (!dict)
    {
        return;
    }
    for (const word& name : dict->toc())
    {
        for (const stepPart* part : all_)
        {
            if (part->name() == name)
            {
                FatalIOErrorInFunction(*dict)
                    << "A part of the step is named " << name << " already;"
                    << " choose another name." << exit(FatalIOError);
            }
        }
        own
        (
            stepPart::New(name, requiredDict(*dict, name), points).ptr()
        );
    }
}


Foam::scalar Foam::mpm::stepParts::courantRate() const
{
    scalar rate = 0;
    for (const stepPart* part : all_)
    {
        rate += part->courantRate();
    }
    return rate;
}


bool Foam::mpm::stepParts::changesForce() const
{
    for (const stepPart* part : all_)
    {
        if (part->changesForce())
        {
            return true;
        }
    }
    return false;
}


bool Foam::mpm::stepParts::changesStrain() const
{
    for (const stepPart* part : all_)
    {
        if (part->changesStrain())
        {
            return true;
        }
    }
    return false;
}


bool Foam::mpm::stepParts::drives() const
{
    for (const stepPart* part : all_)
    {
        if (part->drives())
        {
            return true;
        }
    }
    return false;
}


bool Foam::mpm::stepParts::timeDependent() const
{
    for (const stepPart* part : all_)
    {
        if (part->timeDependent())
        {
            return true;
        }
    }
    return false;
}


Foam::wordList Foam::mpm::stepParts::stateKeys() const
{
    wordList keys;
    for (const stepPart* part : all_)
    {
        keys.append(part->stateKeys());
    }
    return keys;
}


void Foam::mpm::stepParts::addState(dictionary& state) const
{
    for (const stepPart* part : all_)
    {
        part->addState(state);
    }
}


void Foam::mpm::stepParts::setState(const dictionary& state)
{
    for (stepPart* part : all_)
    {
        part->setState(state);
    }
}


void Foam::mpm::stepParts::addFields(fieldStates& fields) const
{
    for (const stepPart* part : all_)
    {
        part->addFields(fields);
    }
}


void Foam::mpm::stepParts::report() const
{
    for (const stepPart* part : all_)
    {
        part->report();
    }
}


void Foam::mpm::stepParts::write()
{
    for (stepPart* part : all_)
    {
        part->write();
    }
}

// ************************************************************************* //
