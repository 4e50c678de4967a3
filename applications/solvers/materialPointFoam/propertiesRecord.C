// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "propertiesRecord.H"
#include "fullPrecision.H"
#include "version.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

fileName recordFile(const Time& time) { return time.timePath() / "uniform" / "phaseProperties"; }

bool same(const ITstream& a, const ITstream& b)
{
    bool equal = a.size() == b.size();
    for (label i = 0; equal && i < a.size(); ++i)
    {
        equal = a[i].isNumber() && b[i].isNumber() ? a[i].number() == b[i].number() : a[i] == b[i];
    }
    return equal;
}

//- On one line, of a long list its beginning
std::string text(const entry* e)
{
    if (!e)
    {
        return "absent";
    }
    if (e->isDict())
    {
        return "a dictionary";
    }
    OStringStream os;
    os.precision(10);
    const tokenList& tokens = e->stream();
    forAll(tokens, i)
    {
        os << (i ? " " : "") << tokens[i];
    }
    const std::string all(os.str());
    return all.size() > 60 ? all.substr(0, 57) + "..." : all;
}

//- Lines of what differs; a dictionary that is absent is empty
void compare(
    const dictionary& before, const dictionary& now, const std::string& path,
    DynamicList<string>& lines)
{
    wordList keys(before.toc());
    for (const word& key : now.toc())
    {
        if (!before.found(key, keyType::LITERAL))
        {
            keys.append(key);
        }
    }
    for (const word& key : keys)
    {
        const entry* a = before.findEntry(key, keyType::LITERAL);
        const entry* b = now.findEntry(key, keyType::LITERAL);
        const std::string place = path + key;
        if ((!a || a->isDict()) && (!b || b->isDict()))
        {
            const dictionary none;
            compare(a ? a->dict() : none, b ? b->dict() : none, place + ".", lines);
        }
        else if (!a || !b || a->isDict() || b->isDict() || !same(a->stream(), b->stream()))
        {
            lines.append("    " + place + ": " + text(a) + " before, " + text(b) + " now");
        }
    }
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::writePropertiesRecord(const Time& time, const dictionary& phaseProperties)
{
    const fullPrecision allDigits;
    const fileName file(recordFile(time));
    mkDir(file.path());
    OFstream os(file);
    os.precision(17);
    os << "// " << version << nl;
    phaseProperties.write(os, false);
}

void Foam::mpm::warnOfChangedProperties(const Time& time, const dictionary& phaseProperties)
{
    const fileName file(recordFile(time));
    if (!Pstream::master() || !isFile(file))
    {
        return;
    }
    IFstream is(file);
    DynamicList<string> lines;
    compare(dictionary(is), phaseProperties, "", lines);
    if (lines.size())
    {
        std::string all;
        for (const string& line : lines)
        {
            all += "\n" + line;
        }
        WarningInFunction << "Since time " << time.timeName() << " was written"
                          << " constant/phaseProperties has changed:" << all.c_str() << endl;
    }
}
