// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "phaseNames.H"
#include "dictionaryTools.H"
#include "ListOps.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::phaseNames(const dictionary& dict, const wordList& types)
{
    requireKeyword(dict, "phases");
    const wordList names(dict.get<wordList>("phases"));
    if (names.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There are no phases; list at least one in phases (...);" << exit(FatalIOError);
    }
    constexpr label most = 1000;
    if (names.size() > most)
    {
        FatalIOErrorInFunction(dict) << "There are " << names.size() << " phases; at most " << most
                                     << " are possible." << exit(FatalIOError);
    }
    forAll(names, i)
    {
        if (names.find(names[i]) != i)
        {
            FatalIOErrorInFunction(dict)
                << "Phase " << names[i] << " is listed twice." << exit(FatalIOError);
        }
    }
    wordList valid(names);
    valid.append("phases");
    valid.append("contact");
    valid.append("outflow");
    valid.append("stepParts");
    valid.append("fluids");
    valid.append("FoamFile");
    for (const entry& e : dict)
    {
        if (e.isDict() && !valid.found(e.keyword()))
        {
            const string near(meant(e.keyword(), valid));
            FatalIOErrorInFunction(dict)
                << "Dictionary " << e.keyword() << " is not a phase: not in"
                << " the list phases " << flatOutput(names) << (near.empty() ? "." : near.c_str())
                << nl << "Add it there, or remove the dictionary; others that may"
                << " be there are contact, fluids, outflow and stepParts." << exit(FatalIOError);
        }
    }
    checkKeywords(dict, valid);

    DynamicList<word> found, gases, fluids;
    for (const word& name : names)
    {
        const word kind(oneOfOrDefault(
            requiredDict(dict, name), "type", "materialPoints",
            {"materialPoints", "rigid", "gas", "fluid"}));
        if (types.found(kind))
        {
            found.append(name);
        }
        if (kind == "gas" || kind == "fluid")
        {
            (kind == "gas" ? gases : fluids).append(name);
        }
    }
    if (gases.size() && fluids.size())
    {
        FatalIOErrorInFunction(requiredDict(dict, gases[0]))
            << "Phase " << gases[0] << " is of type gas, but phase " << fluids[0]
            << " of type fluid. What shares cells with a fluid is"
            << " a fluid too: write  type fluid;  here, with the files p,"
            << " U, alpha." << gases[0] << " and T." << gases[0] << " in place of U." << gases[0]
            << "." << exit(FatalIOError);
    }
    return wordList(std::move(found));
}
