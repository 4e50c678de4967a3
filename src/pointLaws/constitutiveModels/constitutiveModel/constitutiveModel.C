/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "constitutiveModel.H"
#include "selector.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(constitutiveModel, 0);
    defineRunTimeSelectionTable(constitutiveModel, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::constitutiveModel::constitutiveModel(const dictionary& dict)
:
    rho_(positive(dict, "rho"))
{}


Foam::autoPtr<Foam::mpm::constitutiveModel>
Foam::mpm::constitutiveModel::New(const dictionary& dict)
{
    return selectFromTable<constitutiveModel>
    (
        dict,
        dictionaryConstructorTablePtr_,
        dict
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::mpm::constitutiveModel::columnOf
(
    const word& name,
    const int nDim
) const
{
    int n = 0;
    for (const historyColumn& h : history())
    {
        if (h.name == name)
        {
            return n;
        }
        n += h.nComponents(nDim);
    }
    return -1;
}


int Foam::mpm::constitutiveModel::nColumns(const int nDim) const
{
    int n = 0;
    for (const historyColumn& h : history())
    {
        n += h.nComponents(nDim);
    }
    return n;
}


void Foam::mpm::constitutiveModel::initialise(pointBlock& block) const
{
    for (int i = 0; i < nStress(block.nDim); ++i)
    {
        for (label p = 0; p < block.n; ++p)
        {
            if (block.stress[i][p] != 0)
            {
                FatalErrorInFunction
                    << "The law " << type() << " has no state for points that"
                    << " start with a stress; give none in"
                    << " setMaterialPointsDict." << exit(FatalError);
            }
        }
    }
}

// ************************************************************************* //
