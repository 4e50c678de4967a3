/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointEnergy

Description
    The energy budget of all phases over time [J]: see energyBudget for the
    terms. Summed from the start of the run (through restarts) or from the time
    when the function object was added.

        K + W = K_0 + W_0 + transfer + boundary + external + failure + erosion
                + dissipation + remap + damping + contact + residual

    Columns erosion, damping and contact are there if the case has any. In a
    gas the residual is that of points and gas. The energy of the gas (gas,
    gasGained since the start) and its gain by boundaries, gravity, prescribed
    bodies, dry points and fix-ups are further columns:

        K + W + E = (K + W + E)_0 + transfer + boundary + external + failure
                    + gasBoundary + gasExternal + gasRigid + gasDry
                    + gasFixups + dissipation + remap + contact + lastStep + heat
                    + granular + residual

    with half the work of stresses in the last step, lastStep (energyBudget),
    and what the gas gives to the points by pressure and drag, and exchange, the
    part of the residual by which that is more than the gas loses.

    heat, what the gas gains from that of the points, and granular, the work of
    granularPressure, are there where a phase has the model.

    The first row is that of the first step. With -postProcess there is no
    budget: nothing is written.

Usage
    \verbatim
    energy
    {
        type            materialPointEnergy;
        libs            (mpmFunctionObjects);
        writeControl    timeStep;
        writeInterval   10;
    }
    \endverbatim

    File: energy.dat.

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "pointEnergy.H"
#include "pointErosion.H"

namespace Foam::functionObjects
{

class materialPointEnergy : public materialPointOutput
{
    virtual wordList keywords() const { return wordList(); }

    void prepare(const mpm::materialPointSystem& points) override
    {
        if (!functionObject::postProcess)
        {
            points.energy().startBudget();
        }
        string header("Energy budget of all phases\n"
                      "\tkinetic[J]\tstrain[J]\ttotal[J]\ttransfer[J]\tboundary[J]"
                      "\texternal[J]\tresidual[J]\tfailure[J]");
        if (points.coupling())
        {
            header += "\tgas[J]\tgasGained[J]\tgasBoundary[J]\tgasExternal[J]"
                      "\tgasRigid[J]\tgasDry[J]\tgasFixups[J]";
        }
        if (points.erosion().erodes())
        {
            header += "\terosion[J]";
        }
        header += "\tdissipation[J]\tremap[J]";
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
            header += "\tlastStep[J]\tpressure[J]\tdrag[J]\texchange[J]";
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

    void sample(const mpm::materialPointSystem& points) override
    {
        if (const mpm::energyBudget* b = points.energy().budget())
        {
            Ostream& os = row(0);
            os << tab << b->kinetic << tab << b->strain << tab << b->kinetic + b->strain << tab
               << b->transfer() << tab << b->work.boundary << tab << b->work.external << tab
               << b->residual() << tab << b->losses.failure;
            if (b->hasGas)
            {
                const mpm::gasBudget& g = b->gas;
                for (const scalar e :
                     {g.energy, g.energy - g.energy0, g.boundary, g.external, g.rigid, g.dry,
                      g.fixups})
                {
                    os << tab << e;
                }
            }
            if (points.erosion().erodes())
            {
                os << tab << b->erosion();
            }
            os << tab << b->losses.dissipation << tab << b->remap();
            if (points.damps())
            {
                os << tab << b->damping;
            }
            if (points.energy().hasContact())
            {
                os << tab << b->work.contact;
            }
            if (b->hasGas)
            {
                os << tab << b->lastStep << tab << b->pressure() << tab << b->work.drag << tab
                   << b->exchange();
                if (points.coupling()->exchangesHeat())
                {
                    os << tab << b->gas.heat;
                }
                if (points.coupling()->pressesGrains())
                {
                    os << tab << b->gas.granular;
                }
            }
            os << endl;
        }
    }

public:
    TypeName("materialPointEnergy");

    using materialPointOutput::materialPointOutput;
};

defineTypeNameAndDebug(materialPointEnergy, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointEnergy, dictionary);

} // End namespace Foam::functionObjects
