/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "dictionaryTools.H"
#include "nearWords.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::requireKeyword(const dictionary& dict, const word& key)
{
    if (!dict.found(key))
    {
        const word near(nearWord(key, dict.toc()));
        const string instead
        (
            near.empty() ? string()
          : string(" (is it meant by " + near + "?)")
        );
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is missing in " << dict.name()
            << instead.c_str() << nl << nl
            << "Keywords found: " << flatOutput(dict.toc())
            << exit(FatalIOError);
    }
}


const Foam::dictionary& Foam::mpm::requiredDict
(
    const dictionary& dict,
    const word& key
)
{
    requireKeyword(dict, key);
    if (!dict.isDict(key))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " in " << dict.name() << " is not a"
            << " dictionary; it must be " << key << " { ... }"
            << exit(FatalIOError);
    }
    return dict.subDict(key);
}


Foam::scalar Foam::mpm::positive(const dictionary& dict, const word& key)
{
    requireKeyword(dict, key);
    const scalar value(dict.get<scalar>(key));

    if (!(value > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is " << value
            << "; it must be greater than 0." << exit(FatalIOError);
    }
    return value;
}


Foam::scalar Foam::mpm::bounded
(
    const dictionary& dict,
    const word& key,
    const scalar low,
    const scalar high
)
{
    requireKeyword(dict, key);
    const scalar value(dict.get<scalar>(key));

    if (!(value >= low && value <= high))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is " << value << "; it must be in ["
            << low << ", " << high << "]." << exit(FatalIOError);
    }
    return value;
}


Foam::label Foam::mpm::boundedLabelOrDefault
(
    const dictionary& dict,
    const word& key,
    const label defaultValue,
    const label low,
    const label high
)
{
    if (!dict.found(key))
    {
        return defaultValue;
    }
    const label value(dict.get<label>(key));

    if (value < low || value > high)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is " << value << "; it must be a whole"
            << " number in [" << low << ", " << high << "]."
            << exit(FatalIOError);
    }
    return value;
}


Foam::scalar Foam::mpm::boundedOrDefault
(
    const dictionary& dict,
    const word& key,
    const scalar defaultValue,
    const scalar low,
    const scalar high
)
{
    return dict.found(key) ? bounded(dict, key, low, high) : defaultValue;
}


Foam::word Foam::mpm::oneOf
(
    const dictionary& dict,
    const word& key,
    const wordList& valid
)
{
    requireKeyword(dict, key);
    if (dict.isDict(key))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is a dictionary; it must be a word: " << key
            << ' ' << valid.first() << ';' << nl << nl
            << "Valid choices are: " << flatOutput(valid)
            << exit(FatalIOError);
    }
    const word value(dict.get<word>(key));

    if (!valid.found(value))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown " << key << " " << value
            << meant(value, valid).c_str() << nl << nl
            << "Valid choices are: " << flatOutput(valid)
            << exit(FatalIOError);
    }
    return value;
}


Foam::word Foam::mpm::oneOfOrDefault
(
    const dictionary& dict,
    const word& key,
    const word& defaultValue,
    const wordList& valid
)
{
    return dict.found(key) ? oneOf(dict, key, valid) : defaultValue;
}


void Foam::mpm::checkKeywords(const dictionary& dict, const wordList& valid)
{
    for (const word& key : dict.toc())
    {
        if (!valid.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword " << key << " in " << dict.name()
                << meant(key, valid).c_str() << nl << nl
                << "Valid keywords are: " << flatOutput(valid)
                << exit(FatalIOError);
        }
    }
}

// ************************************************************************* //
