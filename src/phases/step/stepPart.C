// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "stepParts.H"
#include "dictionaryTools.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(stepPart, 0);
defineRunTimeSelectionTable(stepPart, dictionary);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::stepPart>
Foam::mpm::stepPart::New(const word& name, const dictionary& dict, materialPointSystem& points)
{
    return selectFromTable<stepPart>(dict, dictionaryConstructorTablePtr_, name, dict, points);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::stepParts::add(stepPart& part)
{
    all_.append(&part);
    std::stable_sort(
        all_.begin(), all_.end(),
        [](const stepPart* a, const stepPart* b) { return a->order() < b->order(); });
}

void Foam::mpm::stepParts::select(const dictionary* dict, materialPointSystem& points)
{
    for (const word& name : dict ? dict->toc() : wordList())
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
        own(stepPart::New(name, requiredDict(*dict, name), points).ptr());
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

Foam::wordList Foam::mpm::stepParts::stateKeys() const
{
    wordList keys;
    for (const stepPart* part : all_)
    {
        keys.append(part->stateKeys());
    }
    return keys;
}
