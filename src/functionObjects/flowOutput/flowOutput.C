// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "flowOutput.H"
#include "IOdictionary.H"
#include "Time.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::functionObjects
{
defineTypeName(flowOutput::record);
}

// * * * * * * * * * * * * * * * * Record  * * * * * * * * * * * * * * * * * //

Foam::functionObjects::flowOutput::record::record(const flowOutput& of) :
    regIOobject(IOobject(
        of.name(), of.time_.timeName(), "uniform" / word("functionObjects"), of.time_,
        IOobject::NO_READ, IOobject::AUTO_WRITE)),
    of_(of)
{
}

bool Foam::functionObjects::flowOutput::record::writeData(Ostream& os) const
{
    const int digits = os.precision(17);
    // With the type of the list, without which a binary one cannot be read
    const scalarList kept(of_.kept());
    kept.writeEntry("state", os);
    os.precision(digits);
    return os.good();
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::flowOutput::start()
{
    scalarList kept;
    if (record_.empty())
    {
        IOobject io(
            name(), time_.timeName(), "uniform" / word("functionObjects"), time_,
            IOobject::MUST_READ, IOobject::NO_WRITE, false);
        if (returnReduce(io.typeHeaderOk<IOdictionary>(true), andOp<bool>()))
        {
            kept = IOdictionary(io).get<scalarList>("state");
        }
    }
    else
    {
        kept = this->kept();
    }
    prepare(kept);
    ready_ = true;
    if (record_.empty())
    {
        record_.reset(new record(*this));
        see();
        writeRows();
    }
}

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::flowOutput::setFiles(const wordList& names, const List<string>& headers)
{
    if (names != fileNames_)
    {
        fileNames_ = names;
        files_.clear();
        files_.setSize(names.size());
    }
    forAll(files_, i)
    {
        if (!files_.set(i) && writeToFile())
        {
            files_.set(i, createFile(names[i]).ptr());
            files_[i].width(0);
            folder_ = files_[i].name().path();
            std::istringstream lines(headers[i]);
            std::string line;
            while (std::getline(lines, line))
            {
                files_[i] << "# " << line.c_str() << nl;
            }
            files_[i].flush();
        }
    }
}

Foam::Ostream& Foam::functionObjects::flowOutput::row(const label filei)
{
    OFstream& os = files_[filei];
    os.precision(writePrecision_);
    os << time_.value();
    return os;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::flowOutput::flowOutput(
    const word& name, const Time& runTime, const dictionary& dict) :
    fvMeshFunctionObject(name, runTime, dict), writeFile(mesh_, name), ready_(false)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::flowOutput::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);
    if (!dict.found("writePrecision"))
    {
        writePrecision_ = 16;
    }
    dict_ = dict;
    ready_ = false;
    requireEachStep(dict, type());
    checkOutputKeywords(dict, keywords());

    if (functionObject::postProcess)
    {
        WarningInFunction << "Rows of all steps belong to the run: " << type() << ' ' << name()
                          << " writes nothing with -postProcess." << endl;
        return true;
    }

    // Mistakes stop the run before its first step
    if (mesh_.foundObject<volScalarField>("p"))
    {
        start();
    }
    return true;
}

bool Foam::functionObjects::flowOutput::execute()
{
    if (functionObject::postProcess)
    {
        return true;
    }
    if (!mesh_.foundObject<volScalarField>("p"))
    {
        FatalErrorInFunction << type() << " " << name() << ": there is no gas and no fluid."
                             << exit(FatalError);
    }
    if (!ready_)
    {
        start();
        return true;
    }
    see();
    return true;
}

bool Foam::functionObjects::flowOutput::write()
{
    if (ready_)
    {
        writeRows();
    }
    return true;
}

bool Foam::functionObjects::flowOutput::end()
{
    if (ready_)
    {
        finish();
    }
    return true;
}
