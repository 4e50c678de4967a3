/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "deviatoricPlasticity.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::mpm::elasticConstants::keywords({"E", "nu", "G"});

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::elasticConstants::elasticConstants(const dictionary& dict)
:
    G(0),
    K(0)
{
    if (!dict.found("E") && !dict.found("nu"))
    {
        G = positive(dict, "G");
        return;
    }
    for (const word key : {"G", "K", "equationOfState"})
    {
        if (dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " beside E or nu in " << dict.name()
                << ": give E and nu, or G and one of K and equationOfState."
                << exit(FatalIOError);
        }
    }
    const scalar E = positive(dict, "E");
    const scalar nu = bounded(dict, "nu", -0.999, 0.499999);
    G = E/(2*(1 + nu));
    K = E/(3*(1 - 2*nu));
}

// ************************************************************************* //
