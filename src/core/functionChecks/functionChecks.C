// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "functionChecks.H"
#include "nearWords.H"
#include "dictionary.H"
#include "error.H"
#include "ListOps.H"
#include "StringStream.H"
#include "wordList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The text of a list of libraries, empty: none
string libraries(const dictionary& dict)
{
    string text;
    for (const word key : {"libs", "functionObjectLibs"})
    {
        if (dict.found(key) && !dict.isDict(key))
        {
            OStringStream os;
            const entry& libs = dict.lookupEntry(key, keyType::REGEX);
            for (const token& t : libs.stream())
            {
                os << t << ' ';
            }
            text += os.str();
        }
    }
    return text;
}

//- Fatal for a number of steps that is no label: OpenFOAM v2506 ends with a trap
void checkIntervals(const dictionary& dict)
{
    const word keys[][2] = {
        {"writeInterval", "writeControl"}, {"executeInterval", "executeControl"}};
    for (const auto& [key, control] : keys)
    {
        if (dict.getOrDefault<word>(control, "timeStep") == "timeStep" && dict.found(key)
            && mag(dict.get<scalar>(key)) > labelMax)
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " is " << dict.get<scalar>(key)
                << "; it must be a whole number of steps." << exit(FatalIOError);
        }
    }
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::checkFunctions(const dictionary& control)
{
    const wordList own(
        {"blastProbes", "fluidBalance", "fluidHeight", "materialPointBalance",
         "materialPointEnergy", "materialPointExtent", "materialPointFields",
         "materialPointPatchForces", "materialPointProbes", "materialPointSeparation",
         "materialPointVTK", "materialPointXT"});
    const word library("mpmFunctionObjects");
    if (!control.isDict("functions"))
    {
        return;
    }
    const dictionary& functions = control.subDict("functions");
    string all(libraries(control));
    for (const entry& e : functions)
    {
        all += e.isDict() ? libraries(e.dict()) : string();
    }
    const auto has = [&](const string& text) { return text.find(library) != string::npos; };
    for (const entry& e : functions)
    {
        if (!e.isDict() || !e.dict().found("type"))
        {
            continue;
        }
        const dictionary& dict = e.dict();
        checkIntervals(dict);
        const word type(dict.get<word>("type"));
        const string libs(libraries(dict));
        const word near(nearWord(type, own));
        const bool ours = libs.empty()
            ? bool(near.size())
            : has(libs) && (near.size() || type.find("materialPoint") == 0);
        if (!own.found(type) && ours)
        {
            FatalIOErrorInFunction(dict)
                << "Unknown type " << type << " of function object " << e.keyword()
                << (near.size() ? "; is " : "") << near << (near.size() ? " meant?" : "") << nl
                << nl << "Valid types of " << library << " are: " << flatOutput(own)
                << exit(FatalIOError);
        }
        const bool none = libs.empty() && libraries(control).empty();
        const bool wrong = libs.find("mpmFunction") != string::npos;
        if (own.found(type) && !has(all) && (none || wrong))
        {
            FatalIOErrorInFunction(dict)
                << "Function object " << e.keyword() << " of type " << type << " needs libs ("
                << library << ");" << (wrong ? " its libs are " : "") << libs.c_str()
                << exit(FatalIOError);
        }
    }
}
