// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "activeRegion.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::activeRegion::addCell(const label celli)
{
    if (hasCell_[celli])
    {
        return;
    }
    hasCell_[celli] = true;
    cells_.append(celli);
    for (const label f : mesh_.cells()[celli])
    {
        if (f < mesh_.nInternalFaces() && !hasFace_[f])
        {
            hasFace_[f] = true;
            faces_.append(f);
        }
    }
}

void Foam::mpm::activeRegion::addRing(const label celli, const label rings)
{
    addCell(celli);
    if (rings == 0)
    {
        return;
    }
    if (byPoints_)
    {
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            for (const label c : mesh_.pointCells()[pointi])
            {
                addRing(c, c == celli ? 0 : rings - 1);
            }
        }
        return;
    }
    for (const label c : mesh_.cellCells()[celli])
    {
        addRing(c, rings - 1);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::activeRegion::activeRegion(const fvMesh& mesh) :
    mesh_(mesh), rings_(0), byPoints_(false), all_(true), steps_(-1), nCells_(0), nFaces_(0)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::activeRegion::use(const label rings, const bool byPoints)
{
    rings_ = rings;
    byPoints_ = byPoints;
    hasCell_.setSize(mesh_.nCells());
    spread_.setSize(mesh_.nCells());
    hasFace_.setSize(mesh_.nInternalFaces());
    rate_.setSize(mesh_.nCells(), 0);
}

void Foam::mpm::activeRegion::join()
{
    for (const label c : changed_)
    {
        touch(c);
    }
    changed_.clear();
    const auto inOrder = [](DynamicList<label>& list, label& n)
    {
        std::sort(list.begin() + n, list.end());
        std::inplace_merge(list.begin(), list.begin() + n, list.end());
        n = list.size();
    };
    if (nCells_ < cells_.size())
    {
        inOrder(cells_, nCells_);
        inOrder(faces_, nFaces_);
    }
}
