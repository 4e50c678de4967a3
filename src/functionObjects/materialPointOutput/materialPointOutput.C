// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointOutput.H"
#include <sstream>
#include "OSspecific.H"
#include "pointQuantity.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::OFstream* Foam::functionObjects::materialPointOutput::openFile(const word& name) const
{
    const Time& runTime = mesh_.time();

    scalar t = late_ ? runTime.value() : runTime.startTime().value();
    if (useUserTime_)
    {
        t = runTime.timeToUserTime(t);
    }

    // Existing files are not overwritten
    const fileName path(baseFileDir() / prefix_ / Time::timeName(t) / name);
    fileName free(path + ".dat");
    for (int i = 1; isFile(free); ++i)
    {
        free = path + '_' + std::to_string(i) + ".dat";
    }
    mkDir(path.path());

    OFstream* os = new OFstream(free);
    if (!os->good())
    {
        FatalErrorInFunction << "Cannot write " << free << exit(FatalError);
    }
    initStream(*os);
    os->width(0);

    return os;
}

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

const Foam::mpm::materialPointSystem* Foam::functionObjects::materialPointOutput::findPoints() const
{
    return mesh_.cfindObject<mpm::materialPointSystem>("materialPointSystem");
}

const Foam::mpm::materialPointSystem& Foam::functionObjects::materialPointOutput::system()
{
    const mpm::materialPointSystem* points = findPoints();

    if (!points)
    {
        FatalErrorInFunction << type() << " " << name() << ": there are no material points." << nl
                             << "This function object works with materialPointFoam and"
                             << " materialPointFoam -postProcess." << exit(FatalError);
    }
    if (!ready_)
    {
        prepare(*points);
        ready_ = true;
    }
    return *points;
}

Foam::wordList Foam::functionObjects::materialPointOutput::selectedPhases(
    const mpm::materialPointSystem& points) const
{
    DynamicList<word> valid;
    for (const mpm::materialPointPhase& p : points.phases())
    {
        valid.append(p.name());
    }

    wordList names;
    if (dict_.found("phase"))
    {
        if (dict_.found("phases"))
        {
            FatalIOErrorInFunction(dict_)
                << "Give either phase or phases, not both." << exit(FatalIOError);
        }
        names.setSize(1, dict_.get<word>("phase"));
    }
    else if (dict_.found("phases"))
    {
        names = dict_.get<wordList>("phases");
    }
    else
    {
        names = valid;
    }

    forAll(names, i)
    {
        if (!valid.found(names[i]))
        {
            FatalIOErrorInFunction(dict_)
                << "Unknown phase " << names[i] << mpm::meant(names[i], valid).c_str() << nl << nl
                << "Valid phases are: " << wordList(valid) << nl << exit(FatalIOError);
        }
        if (names.find(names[i]) != i)
        {
            FatalIOErrorInFunction(dict_)
                << "Phase " << names[i] << " is listed twice." << exit(FatalIOError);
        }
    }
    if (names.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "The list of phases is empty." << nl << nl << "Valid phases are: " << wordList(valid)
            << nl << exit(FatalIOError);
    }
    return names;
}

const Foam::mpm::materialPointPhase& Foam::functionObjects::materialPointOutput::phase(
    const mpm::materialPointSystem& points, const word& name)
{
    for (const mpm::materialPointPhase& p : points.phases())
    {
        if (p.name() == name)
        {
            return p;
        }
    }
    FatalErrorInFunction << "There is no phase " << name << "." << exit(FatalError);

    return points.phases()[0];
}

Foam::autoPtr<Foam::mpm::startState> Foam::functionObjects::materialPointOutput::startOf(
    const mpm::materialPointPhase& phase, const wordList& quantities) const
{
    autoPtr<mpm::startState> start;
    forAll(quantities, i)
    {
        mpm::pointQuantity(dict_, phase, quantities[i], nullptr);
        if (quantities.find(quantities[i]) != i)
        {
            FatalIOErrorInFunction(dict_)
                << "Field " << quantities[i] << " is listed twice." << exit(FatalIOError);
        }
        if (!start && mpm::pointQuantity::needsStart(quantities[i]))
        {
            start.reset(new mpm::startState(dict_, phase));
            start->share(boolList(start->id().size(), true));
        }
    }
    return start;
}

Foam::string Foam::functionObjects::materialPointOutput::joined(const wordList& names)
{
    string all;
    for (const word& name : names)
    {
        all += (all.empty() ? "" : " ") + name;
    }
    return all;
}

void Foam::functionObjects::materialPointOutput::setFiles(
    const wordList& names, const List<string>& headers)
{
    if (names != fileNames_ || headers != headers_)
    {
        fileNames_ = names;
        headers_ = headers;
        files_.clear();
        files_.setSize(names.size());
    }
}

Foam::Ostream& Foam::functionObjects::materialPointOutput::row(const label filei)
{
    const Time& runTime = mesh_.time();

    if (!files_.set(filei))
    {
        files_.set(filei, openFile(fileNames_[filei]));

        OFstream& os = files_[filei];
        std::istringstream lines(headers_[filei]);
        std::string line, next;
        std::getline(lines, line);
        while (std::getline(lines, next))
        {
            os << "# " << line.c_str() << nl;
            line = next;
        }
        os << "# Time[s]" << line.c_str() << endl;
    }

    OFstream& os = files_[filei];
    os << (useUserTime_ ? runTime.timeOutputValue() : runTime.value());
    return os;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::materialPointOutput::materialPointOutput(
    const word& name, const Time& runTime, const dictionary& dict) :
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name),
    ready_(false),

    // A startTime of controlDict is no start of -postProcess
    late_(functionObject::postProcess || runTime.timeIndex() > runTime.startTimeIndex()),
    sampled_(true)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::materialPointOutput::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    // Balances need all digits, whatever controlDict has for fields
    if (!dict.found("writePrecision"))
    {
        writePrecision_ = 16;
    }

    dict_ = dict;
    ready_ = false;

    // writeToFile_ is false on all processors but the master
    sampled_ = dict.getOrDefault<bool>("writeToFile", true);

    checkOutputKeywords(dict, keywords());

    // Mistakes in the dictionary stop the run before its first step
    if (const mpm::materialPointSystem* points = findPoints())
    {
        prepare(*points);
        ready_ = true;
    }
    return true;
}

bool Foam::functionObjects::materialPointOutput::write()
{
    const mpm::materialPointSystem& points = system();
    if (sampled_)
    {
        sample(points);
        late_ = true;
    }
    return true;
}
