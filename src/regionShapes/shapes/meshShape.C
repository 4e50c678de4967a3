// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "meshShape.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(meshShape, 0);
addToRunTimeSelectionTable(pointRegionShape, meshShape, dictionary);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::mpm::meshShape::file(const pointGrid& grid, const dictionary& dict)
{
    fileName name(required<fileName>(dict, "file").expand());
    return name.isAbsolute() ? name : grid.mesh().time().globalPath() / name;
}

Foam::wordList Foam::mpm::meshShape::groups(const dictionary& dict)
{
    DynamicList<word> words;
    if (dict.found("group"))
    {
        const tokenList& tokens = dict.lookup("group");
        for (const token& t : tokens)
        {
            if (t.isLabel())
            {
                words.append(Foam::name(t.labelToken()));
            }
            else if (t.isWord() || t.isString())
            {
                words.append(word(t.isWord() ? t.wordToken() : t.stringToken(), false));
            }
            else if (!t.isPunctuation())
            {
                words.clear();
                break;
            }
        }
        if (words.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Entry group must be the name or number of a physical group,"
                << " or a list of them:  group (steel 3);" << exit(FatalIOError);
        }
    }
    return wordList(std::move(words));
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::meshShape::meshShape(const pointGrid& grid, const dictionary& dict) :
    pointRegionShape(grid),
    body_(
        file(grid, dict), dict, grid, groups(dict),
        dict.found("scale") ? positive(dict, "scale") : 1)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::meshShape::keywords() const { return {"file", "group", "scale"}; }

bool Foam::mpm::meshShape::contains(const label, const point& x) const { return body_.contains(x); }

Foam::scalar Foam::mpm::meshShape::volume() const
{
    return body_.volume() * (grid_.radial() < 0 ? section() : grid_.sector());
}
