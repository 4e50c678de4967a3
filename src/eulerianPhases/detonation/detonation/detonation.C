// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "detonation.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(detonation, 0);
defineRunTimeSelectionTable(detonation, dictionary);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::detonation::detonation(
    const dictionary& dict, const equationOfState& products, const wordList& entries) :
    products_(products),
    q_(products.e0()),
    K_(dict.found("K") ? bounded(dict, "K", SMALL, 1e15) : products.rho0() * sqr(2500.0)),
    n_(boundedOrDefault(dict, "n", 7, 1.000001, 20))
{
    wordList valid(entries);
    valid.append("type");
    valid.append("K");
    valid.append("n");
    checkKeywords(dict, valid);
    if (!products.ofReaction())
    {
        FatalIOErrorInFunction(dict)
            << "A fluid with the equation of state " << products.type()
            << " cannot detonate: that of the fluid must be one of the products"
            << " of an explosive, with their energy E0 (JWL)." << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::detonation>
Foam::mpm::detonation::New(const dictionary& dict, const equationOfState& products)
{
    return selectFromTable<detonation>(dict, dictionaryConstructorTablePtr_, dict, products);
}
