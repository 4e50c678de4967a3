// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fatalMessages.H"
#include "dictionaryTools.H"
#include "nearWords.H"
#include "functionChecks.H"
#include "OSspecific.H"
#include "Time.H"
#include "IFstream.H"
#include "Pstream.H"
#include "HashSet.H"
#include "IOobject.H"
#include "token.H"
#include <csignal>
#include <cstdlib>
#include <exception>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

template<class Error>
[[noreturn]] void end(const Error& e)
{
    Perr << nl << e << nl << "\nFOAM exiting\n" << endl;
    if (Pstream::parRun())
    {
        Pstream::exit(1);
    }
    std::exit(1);
}

//- What has been read of the entry at hand
struct lastEntry
{
    string keyword;

    //- The token before
    token before;

    //- Values of lists stand in braces, too: 3{0}
    bool inList = false;

    //- Without its semicolon? Directives (#) and macros ($) need none
    bool open() const
    {
        return keyword.size() && keyword[0] != '#' && keyword[0] != '$' && !inList;
    }

    void add(const token& t)
    {
        if (t == token::BEGIN_BLOCK && before.isNumber())
        {
            inList = true;
        }
        else if (t == token::END_BLOCK && inList)
        {
            inList = false;
        }
        else if (t == token::END_STATEMENT || t == token::BEGIN_BLOCK || t == token::END_BLOCK)
        {
            keyword.clear();
        }
        else if (keyword.empty())
        {
            keyword = t.isWord() ? t.wordToken()
                : t.isString()   ? t.stringToken()
                                 : string("of a list");
        }
        before = t;
    }
};

//- Called in place of unwinding: the end of argList would exit with status 0
[[noreturn]] void endOnError()
{
    if (const std::exception_ptr thrown = std::current_exception())
    {
        try
        {
            std::rethrow_exception(thrown);
        }
        catch (const IOerror& e)
        {
            end(e);
        }
        catch (const error& e)
        {
            end(e);
        }
        catch (...)
        {
        }
    }
    std::abort();
}

//- Called by std::abort(): later OpenFOAM than v1912 aborts on some mistakes of the user
//  although exceptions are on. Its message has been printed then, and is still there
void endAfterMessage(int signal)
{
    if (FatalError.message().size() || FatalIOError.message().size())
    {
        std::_Exit(1);
    }
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

//- Warn of words of controlDict that are nearly one that is read. Any word may
//  stand there: as a variable, or for a library
void warnOfWords(const dictionary& control)
{
    const wordList own(
        {"adjustTimeStep", "maxCo", "maxCoGas", "maxDeltaT", "minDeltaT", "maxEnergyGrowth",
         "maxSubSteps", "maxGasSubSteps", "reportInterval", "rebuildInterval"});
    const wordHashSet openFOAM(
        {"FoamFile",
         "application",
         "startFrom",
         "startTime",
         "stopAt",
         "endTime",
         "beginTime",
         "deltaT",
         "writeControl",
         "writeInterval",
         "writeFrequency",
         "purgeWrite",
         "writeFormat",
         "writeVersion",
         "writePrecision",
         "writeCompression",
         "secondaryWriteControl",
         "secondaryWriteInterval",
         "secondaryPurgeWrite",
         "timeFormat",
         "timePrecision",
         "graphFormat",
         "runTimeModifiable",
         "fileHandler",
         "profiling",
         "libs",
         "functions",
         "maxDi",
         "maxAlphaCo",
         "maxAcousticCo",
         "maxFo"});
    for (const word& key : control.toc())
    {
        if (own.found(key) || openFOAM.found(key))
        {
            continue;
        }
        const word near(mpm::nearWord(key, own));
        if (near.size())
        {
            IOWarningInFunction(control)
                << "Entry " << key << " is not read; is " << near << " meant?" << endl;
        }
    }
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::exitOnFatal()
{
    std::set_terminate(endOnError);
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    if (!env("FOAM_ABORT"))
    {
        std::signal(SIGABRT, endAfterMessage);
    }
}

void Foam::mpm::requireClosed(const fileName& file)
{
    IFstream is(file);
    if (!is.good())
    {
        return;
    }

    label nOpen = 0;
    lastEntry last;
    token t;
    while (is.read(t).good() && t.good())
    {
        nOpen += t == token::BEGIN_BLOCK ? 1 : 0;
        nOpen -= t == token::END_BLOCK ? 1 : 0;
        if (nOpen < 0)
        {
            break;
        }
        if (t == token::END_BLOCK && last.open())
        {
            FatalIOErrorInFunction(is) << "File " << file << ": entry " << last.keyword
                                       << " has no semicolon before the closing brace in line "
                                       << t.lineNumber() << "." << exit(FatalIOError);
        }
        last.add(t);
    }
    if (nOpen)
    {
        FatalIOErrorInFunction(is) << "File " << file
                                   << (nOpen > 0 ? " ends inside a dictionary: "
                                                 : " has more closing braces than opening ones: ")
                                   << (nOpen > 0 ? "a closing brace is missing, or the file was cut"
                                                   " off."
                                                 : "an opening brace is missing.")
                                   << exit(FatalIOError);
    }
}

void Foam::mpm::checkControlDict(const fileName& file)
{
    requireClosed(file);

    IFstream is(file);
    if (!is.good())
    {
        return;
    }
    const dictionary control(is);
    warnOfWords(control);
    checkFunctions(control);
    if (control.found("writeInterval") && control.found("endTime"))
    {
        const scalar interval = positive(control, "writeInterval");
        const scalar end = mag(control.get<scalar>("endTime"));
        if (end / labelMax >= interval)
        {
            FatalIOErrorInFunction(control)
                << "Entry writeInterval is " << interval << ": too small for a"
                << " run to endTime " << end << "." << exit(FatalIOError);
        }
    }
}

void Foam::mpm::requireCaseFile(const Time& time, const fileName& name)
{
    if (Pstream::master() && !exists(time.path() / name) && !exists(time.path() / name + ".gz")
        && !exists(time.globalPath() / name) && !exists(time.globalPath() / name + ".gz"))
    {
        const fileName project(getEnv("MPM_PROJECT_DIR"));
        // The template has no fluids
        const bool fluids = name == "system/setFluidsDict";
        const fileName of(fluids ? "tutorials/damBreak" : "etc/caseTemplate");
        const fileName from(of / name);
        FatalErrorInFunction << "The case " << time.globalPath() << " has no file " << name << "."
                             << nl << "Copy " << (project.empty() ? from : project / from).c_str()
                             << " and change it; " << of.c_str()
                             << " is a small case with every file that a run needs." << nl << "If "
                             << name << " is there, run in the folder of the case, or"
                             << " with  -case <folder>." << exit(FatalError);
    }
}

void Foam::mpm::checkGravity(const fileName& file, const vector& g, const Vector<label>& computed)
{
    for (int d = 0; d < 3; ++d)
    {
        if (computed[d] < 0 && g[d] != 0)
        {
            FatalErrorInFunction << "Gravity in " << file << " is " << g << ": it acts along "
                                 << "xyz"[d] << ", which the mesh does not compute (patches of"
                                 << " type empty or wedge)." << nl
                                 << "The computed directions are:" << (computed[0] > 0 ? " x" : "")
                                 << (computed[1] > 0 ? " y" : "") << (computed[2] > 0 ? " z" : "")
                                 << exit(FatalError);
        }
    }
    if (mag(g) > 100)
    {
        WarningInFunction << "Gravity in " << file << " is " << g << " m/s2, " << mag(g) / 9.81
                          << " times that of the earth: it is in m/s2, whatever"
                          << " the unit of the mesh's drawing." << endl;
    }
}

Foam::label Foam::mpm::announcedSize(const IOobject& io)
{
    IOobject object(io);
    IFstream is(object.objectPath());
    if (!is.good() || !object.readHeader(is))
    {
        return -1;
    }
    const token first(is);
    if (!first.isLabel())
    {
        return -1;
    }
    if (first.labelToken() < 0)
    {
        cannotRead(
            object.objectPath(),
            "its list has the size " + std::to_string(first.labelToken()) + ".");
    }
    return first.labelToken();
}

void Foam::mpm::cannotRead(const fileName& file, const string& problem)
{
    FatalErrorInFunction << "File " << file << " cannot be read: " << problem.c_str()
                         << exit(FatalError);
}
