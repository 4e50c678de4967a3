// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "solidSurface.H"
#include "cellSums.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam::mpm
{

// Beside phases, in phaseIn_
static constexpr label none = -1, listed = -2;

} // End namespace Foam::mpm

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::solidSurface::mark()
{
    const bool several = phases_.size() > 1;
    forAll(phases_, phasei)
    {
        materialPointCloud& cloud = points_.phases()[phasei].cloud();
        const scalar* volume = (*cloud.gasVolume())[0];
        forAll(cloud.cells(), k)
        {
            const label c = cloud.cells()[k];
            const scalar v = several ? cellSum(cloud, k, volume) : 0;
            if (phaseIn_[c] == none || v > volume_[c])
            {
                phaseIn_[c] = phasei;
                volume_[c] = v;
            }
        }
    }
}

void Foam::mpm::solidSurface::findBeside(scalarList& behind)
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const auto list = [&](const label c)
    {
        if (phaseIn_[c] == none)
        {
            phaseIn_[c] = listed;
            beside_.append(c);
        }
    };
    for (const materialPointPhase& phase : points_.phases())
    {
        for (const label c : phase.cloud().cells())
        {
            for (const label f : mesh_.cells()[c])
            {
                if (f < nei.size())
                {
                    list(own[f] == c ? nei[f] : own[f]);
                }
            }
        }
    }
    if (coupled_.empty())
    {
        return;
    }
    behind = coupled_.behind(phaseIn_);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                if (behind[patch.start() + i - nei.size()] >= 0)
                {
                    list(patch.faceCells()[i]);
                }
            }
        }
    }
}

void Foam::mpm::solidSurface::addCell(
    const label celli, const scalarList& behind, const std::function<vector(label)>& area)
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const labelList& toNode = points_.grid().pointToNode();
    for (const label f : mesh_.cells()[celli])
    {
        label phasei = none;
        if (f < nei.size())
        {
            phasei = phaseIn_[own[f] == celli ? nei[f] : own[f]];
        }
        else if (
            behind.size() && mesh_.boundaryMesh()[mesh_.boundaryMesh().whichPatch(f)].coupled())
        {
            phasei = label(behind[f - nei.size()]);
        }
        if (phasei < 0 || !phases_[phasei].wanted)
        {
            continue;
        }
        ofPhase& of = phases_[phasei];
        if (of.cells.empty() || of.cells.last() != celli)
        {
            of.cells.append(celli);
            of.start.append(of.nodes.size());
            of.A.append(Zero);
        }
        of.A.last() += own[f] == celli ? area(f) : -area(f);
        for (const label pointi : mesh_.faces()[f])
        {
            const label node = toNode[pointi];
            bool is = false;
            for (label i = of.start.last(); i < of.nodes.size() && !is; ++i)
            {
                is = of.nodes[i] == node;
            }
            if (!is)
            {
                of.nodes.append(node);
            }
        }
    }
}

void Foam::mpm::solidSurface::unmark()
{
    for (const materialPointPhase& phase : points_.phases())
    {
        for (const label c : phase.cloud().cells())
        {
            phaseIn_[c] = none;
        }
    }
    for (const label c : beside_)
    {
        phaseIn_[c] = none;
    }
    beside_.clear();
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::solidSurface::solidSurface(
    materialPointSystem& points, const fvMesh& mesh, const coupledFaces& coupled) :
    points_(points),
    mesh_(mesh),
    coupled_(coupled),
    phases_(points.phases().size()),
    any_(false),
    phaseIn_(mesh.nCells(), label(none)),
    volume_(mesh.nCells(), scalar(0))
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::solidSurface::find(
    const std::function<vector(label)>& area, const std::function<bool(label)>& full)
{
    if (!any_)
    {
        return;
    }
    for (ofPhase& of : phases_)
    {
        of.cells.clear();
        of.start.clear();
        of.nodes.clear();
        of.A.clear();
    }
    mark();
    scalarList behind;
    findBeside(behind);
    for (const label c : beside_)
    {
        if (!full(c))
        {
            addCell(c, behind, area);
        }
    }
    unmark();
}
