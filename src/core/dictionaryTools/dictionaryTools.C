// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "dictionaryTools.H"
#include "labelList.H"
#include "ListOps.H"
#include <algorithm>
#include <cctype>
#include <utility>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Letters to add, remove or replace between two words
label editDistance(const std::string& a, const std::string& b)
{
    labelList row(identity(label(b.size() + 1)));
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        label corner = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const label above = row[j + 1];
            row[j + 1] = min(min(row[j], above) + 1, corner + label(a[i] != b[j]));
            corner = above;
        }
    }
    return row.last();
}

//- Two neighbouring letters have changed places
bool swapped(const std::string& a, const std::string& b)
{
    const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    return at.first != a.end() && at.second != b.end() && at.first + 1 != a.end()
        && at.second + 1 != b.end() && at.first[0] == at.second[1] && at.first[1] == at.second[0]
        && std::equal(at.first + 2, a.end(), at.second + 2, b.end());
}

std::string small(std::string s)
{
    std::transform(s.begin(), s.end(), s.begin(), ::tolower);
    return s;
}

//- Of a long word letters are left out: minFailStrain of minFailureStrain
bool shortened(const std::string& a, const std::string& b)
{
    std::size_t n = 0;
    for (const char c : b)
    {
        n += n < a.size() && c == a[n];
    }
    return a.size() > 6 && n == a.size() && 3 * a.size() > 2 * b.size();
}

std::string withoutDigits(std::string s)
{
    s.erase(std::remove_if(s.begin(), s.end(), ::isdigit), s.end());
    return s;
}

//- Other names, in small letters, and ours
const std::pair<const char*, const char*> otherNames[] = {
    {"poissonratio", "nu"},
    {"poissonsratio", "nu"},
    {"poisson", "nu"},
    {"youngmodulus", "E"},
    {"youngsmodulus", "E"},
    {"young", "E"},
    {"elasticmodulus", "E"},
    {"modulus", "E"},
    {"bulkmodulus", "K"},
    {"shearmodulus", "G"},
    {"shearmodulus", "mu"},
    {"density", "rho"},
    {"yieldstress", "yield"},
    {"yieldstrength", "yield"},
    {"tensilestrength", "strength"},
    {"fractureenergy", "Gf"},
    {"friction", "mu"},
    {"frictioncoefficient", "mu"},
    {"viscosity", "mu"},
    {"particlespercell", "pointsPerCell"},
    {"ppc", "pointsPerCell"},
    {"material", "phase"},
    {"center", "centre"},
    {"u", "velocity"}};

bool sameName(const word& a, const word& b)
{
    for (const auto& n : otherNames)
    {
        if ((small(a) == n.first && b == n.second) || (small(b) == n.first && a == n.second))
        {
            return true;
        }
    }
    return false;
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::word Foam::mpm::nearWord(const word& key, const UList<word>& words)
{
    word near;
    label least = labelMax;
    for (const word& w : words)
    {
        const std::size_t size = min(key.size(), w.size());
        label distance = labelMax;
        if (w == key)
        {
            continue;
        }
        if (sameName(key, w) || (size > 1 && small(key) == small(w)))
        {
            distance = 0;
        }
        else if (
            size > 2 && withoutDigits(key) != withoutDigits(w)
            && editDistance(key, w) <= (w.size() > 6 ? 2 : 1))
        {
            distance = editDistance(key, w);
        }
        else if (withoutDigits(key) != withoutDigits(w) && swapped(key, w))
        {
            distance = 1;
        }
        if (distance < least)
        {
            near = w;
            least = distance;
        }
    }

    // The only one that begins with it, J2 of J2Plasticity, or that it shortens
    label n = 0;
    for (const word& w : words)
    {
        if (least == labelMax && key.size() > 1 && key.size() < w.size()
            && (small(w.substr(0, key.size())) == small(key) || shortened(small(key), small(w)))
            && n++ == 0)
        {
            near = w;
        }
    }
    return n > 1 ? word() : near;
}

Foam::string Foam::mpm::meant(const word& key, const UList<word>& words)
{
    const word near(nearWord(key, words));
    return near.empty() ? string() : string("; is " + near + " meant?");
}

void Foam::mpm::requireKeyword(const dictionary& dict, const word& key)
{
    if (!dict.found(key))
    {
        const word near(nearWord(key, dict.toc()));
        const string instead(near.empty() ? string() : string(" (is it meant by " + near + "?)"));
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is missing in " << dict.name() << instead.c_str() << nl << nl
            << "Keywords found: " << flatOutput(dict.toc()) << exit(FatalIOError);
    }
}

const Foam::dictionary& Foam::mpm::requiredDict(const dictionary& dict, const word& key)
{
    requireKeyword(dict, key);
    if (!dict.isDict(key))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " in " << dict.name() << " is not a"
            << " dictionary; it must be " << key << " { ... }" << exit(FatalIOError);
    }
    return dict.subDict(key);
}

Foam::scalar Foam::mpm::positive(const dictionary& dict, const word& key)
{
    requireKeyword(dict, key);
    const scalar value(dict.get<scalar>(key));

    if (!(value > 0))
    {
        FatalIOErrorInFunction(dict) << "Entry " << key << " is " << value
                                     << "; it must be greater than 0." << exit(FatalIOError);
    }
    return value;
}

Foam::scalar
Foam::mpm::bounded(const dictionary& dict, const word& key, const scalar low, const scalar high)
{
    requireKeyword(dict, key);
    const scalar value(dict.get<scalar>(key));

    if (!(value >= low && value <= high))
    {
        FatalIOErrorInFunction(dict) << "Entry " << key << " is " << value << "; it must be in ["
                                     << low << ", " << high << "]." << exit(FatalIOError);
    }
    return value;
}

Foam::label Foam::mpm::boundedLabelOrDefault(
    const dictionary& dict, const word& key, const label defaultValue, const label low,
    const label high)
{
    if (!dict.found(key))
    {
        return defaultValue;
    }
    const label value(required<label>(dict, key));

    if (value < low || value > high)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is " << value << "; it must be a whole"
            << " number in [" << low << ", " << high << "]." << exit(FatalIOError);
    }
    return value;
}

Foam::scalar Foam::mpm::boundedOrDefault(
    const dictionary& dict, const word& key, const scalar defaultValue, const scalar low,
    const scalar high)
{
    return dict.found(key) ? bounded(dict, key, low, high) : defaultValue;
}

Foam::word Foam::mpm::oneOf(const dictionary& dict, const word& key, const wordList& valid)
{
    requireKeyword(dict, key);
    if (dict.isDict(key))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is a dictionary; it must be a word: " << key << ' '
            << valid.first() << ';' << nl << nl << "Valid choices are: " << flatOutput(valid)
            << exit(FatalIOError);
    }
    // A number is no word: OpenFOAM would not say which are
    const token first(dict.lookup(key));
    const word value(first.isNumber() ? word(name(first.number())) : dict.get<word>(key));

    if (!valid.found(value))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown " << key << " " << value << meant(value, valid).c_str() << nl << nl
            << "Valid choices are: " << flatOutput(valid) << exit(FatalIOError);
    }
    return value;
}

Foam::word Foam::mpm::oneOfOrDefault(
    const dictionary& dict, const word& key, const word& defaultValue, const wordList& valid)
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
                << "Unknown keyword " << key << " in " << dict.name() << meant(key, valid).c_str()
                << nl << nl << "Valid keywords are: " << flatOutput(valid) << exit(FatalIOError);
        }
    }
}
