// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "constitutiveModel.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(constitutiveModel, 0);
defineRunTimeSelectionTable(constitutiveModel, dictionary);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::constitutiveModel::constitutiveModel(const dictionary& dict) :
    rho_(positive(dict, "rho"))
{
}

Foam::autoPtr<Foam::mpm::constitutiveModel>
Foam::mpm::constitutiveModel::New(const dictionary& dict)
{
    return selectFromTable<constitutiveModel>(dict, dictionaryConstructorTablePtr_, dict);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::mpm::constitutiveModel::columnOf(const word& name, const int nDim) const
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
                FatalErrorInFunction << "The law " << type() << " does not support points that"
                                     << " start with a stress; give none in"
                                     << " setMaterialPointsDict." << exit(FatalError);
            }
        }
    }
}

Foam::scalar Foam::mpm::constitutiveModel::waveSpeedOf(
    const pointBlock& block, const label p, const scalar width) const
{
    if (!waveSpeedVaries())
    {
        return waveSpeed();
    }

    // A step without motion on a copy of the point, with room for lanes
    constexpr int nLanes = 16;
    alignas(64) scalar copy[pointBlock::maxHistory + 9][nLanes];
    alignas(64) scalar zero[nLanes] = {};
    int n = 0;
    const auto copied = [&](const scalar* value)
    {
        std::fill_n(copy[n], nLanes, value ? value[p] : 0);
        return copy[n++];
    };

    pointBlock one(block);
    one.n = 1;
    one.dt = 1;
    one.waveSpeed = 0;
    std::fill_n(one.dL, 9, zero);
    one.hoop = nullptr;
    one.mass = copied(block.mass);
    one.volume = copied(block.volume);
    for (int i = 0; i < nStress(block.nDim); ++i)
    {
        one.stress[i] = copied(block.stress[i]);
    }
    for (int h = 0; h < nColumns(block.nDim); ++h)
    {
        one.history[h] = copied(block.history[h]);
    }
    one.damage = block.damage ? copied(block.damage) : nullptr;
    one.strength = nullptr;
    alignas(64) scalar widths[nLanes];
    std::fill_n(widths, nLanes, width);
    one.width = needsWidth() ? widths : nullptr;

    correct(one);
    return one.waveSpeed;
}
