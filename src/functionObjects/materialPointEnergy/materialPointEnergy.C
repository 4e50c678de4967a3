/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointEnergy.H"
#include "pointEnergy.H"
#include "pointErosion.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(materialPointEnergy, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        materialPointEnergy,
        dictionary
    );
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::materialPointEnergy::keywords() const
{
    return wordList();
}


void Foam::functionObjects::materialPointEnergy::prepare
(
    const mpm::materialPointSystem& points
)
{
    if (!functionObject::postProcess)
    {
        points.energy().startBudget();
    }
    string header
    (
        "Energy budget of all phases\n"
        "\tkinetic[J]\tstrain[J]\ttotal[J]\ttransfer[J]\tboundary[J]"
        "\texternal[J]\tresidual[J]\tfailure[J]"
    );
    if (points.coupling())
    {
        header +=
            "\tgas[J]\tgasGained[J]\tgasBoundary[J]\tgasExternal[J]"
            "\tgasRigid[J]\tgasDry[J]\tgasFixups[J]";
    }
    if (points.erosion().erodes())
    {
        header += "\terosion[J]";
    }
    header += "\tdissipation[J]";
    if (!points.coupling())
    {
        header += "\tremap[J]";
    }
    if (points.damps())
    {
        header += "\tdamping[J]";
    }
    if (points.energy().hasContact())
    {
        header += "\tcontact[J]";
    }
    if (points.coupling())
    {
        header += "\tlastStep[J]";
        if (points.coupling()->exchangesHeat())
        {
            header += "\theat[J]";
        }
        if (points.coupling()->pressesGrains())
        {
            header += "\tgranular[J]";
        }
    }
    setFiles(wordList(1, "energy"), List<string>(1, header));
}


void Foam::functionObjects::materialPointEnergy::sample
(
    const mpm::materialPointSystem& points
)
{
    if (const mpm::energyBudget* b = points.energy().budget())
    {
        Ostream& os = row(0);
        os  << tab << b->kinetic << tab << b->strain
            << tab << b->kinetic + b->strain << tab << b->transfer()
            << tab << b->work.boundary << tab << b->work.external
            << tab << b->residual() << tab << b->losses.failure;
        if (b->hasGas)
        {
            const mpm::gasBudget& g = b->gas;
            for
            (
                const scalar e :
                {
                    g.energy, g.energy - g.energy0, g.boundary, g.external,
                    g.rigid, g.dry, g.fixups
                }
            )
            {
                os  << tab << e;
            }
        }
        if (points.erosion().erodes())
        {
            os  << tab << b->erosion();
        }
        os  << tab << b->losses.dissipation;
        if (!b->hasGas)
        {
            os  << tab << b->remap();
        }
        if (points.damps())
        {
            os  << tab << b->damping;
        }
        if (points.energy().hasContact())
        {
            os  << tab << b->work.contact;
        }
        if (b->hasGas)
        {
            os  << tab << b->lastStep();
            if (points.coupling()->exchangesHeat())
            {
                os  << tab << b->gas.heat;
            }
            if (points.coupling()->pressesGrains())
            {
                os  << tab << b->gas.granular;
            }
        }
        os  << endl;
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::materialPointEnergy::materialPointEnergy
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    materialPointOutput(name, runTime, dict)
{
    read(dict);
}

// ************************************************************************* //
