// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "cellLayers.H"
#include "globalMeshData.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::cellLayers::cellLayers(const polyMesh& mesh) :
    mesh_(mesh),
    pointStart_(mesh.nCells() + 1, 0),
    cellStart_(mesh.nPoints() + 1, 0),
    shared_(mesh.globalData().coupledPatch().meshPoints()),
    coupled_(returnReduce(shared_.size(), sumOp<label>()) > 0),
    atPoint_(mesh.nPoints(), -1),
    listed_(mesh.nCells(), false)
{
    // atPoint_: the last cell that had the point
    DynamicList<label> points(10 * mesh.nCells());
    forAll(mesh.cells(), c)
    {
        for (const label f : mesh.cells()[c])
        {
            for (const label p : mesh.faces()[f])
            {
                if (atPoint_[p] != c)
                {
                    atPoint_[p] = c;
                    points.append(p);
                    ++cellStart_[p + 1];
                }
            }
        }
        pointStart_[c + 1] = points.size();
    }
    points_.transfer(points);
    atPoint_ = labelMin;
    for (label p = 0; p < mesh.nPoints(); ++p)
    {
        cellStart_[p + 1] += cellStart_[p];
    }
    cells_.setSize(points_.size());
    labelList next(cellStart_);
    for (label c = 0; c < mesh.nCells(); ++c)
    {
        for (label i = pointStart_[c]; i < pointStart_[c + 1]; ++i)
        {
            cells_[next[points_[i]]++] = c;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::mpm::cellLayers::spread(
    labelList& values, const labelUList& less, const labelUList& from) const
{
    DynamicList<label> touched;
    for (const label c : from)
    {
        for (label i = pointStart_[c]; i < pointStart_[c + 1]; ++i)
        {
            label& v = atPoint_[points_[i]];
            if (v == labelMin)
            {
                touched.append(points_[i]);
            }
            v = max(v, values[c]);
        }
    }
    if (coupled_)
    {
        const labelList before(UIndirectList<label>(atPoint_, shared_));
        syncTools::syncPointList(mesh_, atPoint_, maxEqOp<label>(), labelMin);
        forAll(shared_, i)
        {
            if (before[i] == labelMin && atPoint_[shared_[i]] != labelMin)
            {
                touched.append(shared_[i]);
            }
        }
    }
    DynamicList<label> raised;
    for (const label p : touched)
    {
        for (label i = cellStart_[p]; i < cellStart_[p + 1]; ++i)
        {
            const label c = cells_[i];
            const label v = atPoint_[p] - less[c];
            if (v > values[c])
            {
                values[c] = v;
                if (!listed_[c])
                {
                    raised.append(c);
                    listed_[c] = true;
                }
            }
        }
        atPoint_[p] = labelMin;
    }
    for (const label c : raised)
    {
        listed_[c] = false;
    }
    return labelList(std::move(raised));
}
