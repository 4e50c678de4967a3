/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "fluidInterfaces.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fluidInterfaces::swapLabels(labelList& ofBoth) const
{
    if (coupled_.empty())
    {
        return;
    }
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells(), nInternal = mesh.nInternalFaces();
    scalarField values(mesh.nFaces() - nInternal, 0);
    for (const label f : faces_.coupled)
    {
        values[f - nInternal] = ofBoth[mesh.faceOwner()[f]];
    }
    coupled_.swap(values);
    for (const label f : faces_.coupled)
    {
        ofBoth[nCells + f - nInternal] = label(values[f - nInternal]);
    }
}


void Foam::mpm::fluidInterfaces::sortCells(const contents& of)
{
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells(), nInternal = mesh.nInternalFaces();
    const auto sort = [&](const label at, const scalar* part, const scalar all)
    {
        label only = -1, most = -1, several = 0;
        for (label k = 0; k < n_; ++k)
        {
            if (part[k] > 0)
            {
                only = k;
                ++several;
            }
            if (part[k] > (1 - foreign)*all)
            {
                most = k;
            }
        }
        single_[at] = several == 1 ? only : -1;
        major_[at] = most;
    };
    for (label c = 0; c < nCells; ++c)
    {
        sort(c, of.part.cdata() + n_*c, of.theta[c]);
    }
    for (const label f : faces_.boundary)
    {
        const label i = f - nInternal;
        if (of.alphaB[n_*i] < 0)
        {
            // Nothing of its own comes in
            single_[nCells + i] = single_[mesh.faceOwner()[f]];
            major_[nCells + i] = major_[mesh.faceOwner()[f]];
        }
        else
        {
            sort(nCells + i, of.alphaB.cdata() + n_*i, 1);
        }
    }
    swapLabels(single_);
    swapLabels(major_);
}


void Foam::mpm::fluidInterfaces::setSlots()
{
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells(), nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    for (const label c : cells_)
    {
        slot_[c] = -1;
    }
    cells_.clear();
    near_ = false;
    const auto add = [&](const label c)
    {
        if (slot_[c] < 0)
        {
            slot_[c] = cells_.size();
            cells_.append(c);
        }
    };
    const auto meet = [](const label a, const label b)
    {
        return a >= 0 && b >= 0 && a != b;
    };
    for (label c = 0; c < nCells; ++c)
    {
        if (single_[c] < 0)
        {
            add(c);
            near_[c] = major_[c] < 0;
        }
    }
    for (label f = 0; f < nInternal; ++f)
    {
        const label P = own[f], N = nei[f];
        if (single_[P] != single_[N])
        {
            add(P);
            add(N);
            if (meet(major_[P], major_[N]))
            {
                near_[P] = near_[N] = true;
            }
        }
    }
    for (const labelList* list : {&faces_.coupled, &faces_.boundary})
    {
        for (const label f : *list)
        {
            const label P = own[f], B = nCells + f - nInternal;
            if (single_[P] != single_[B])
            {
                add(P);
                near_[P] = near_[P] || meet(major_[P], major_[B]);
            }
        }
    }
    labelList near(near_.size(), 0);
    if (!coupled_.empty())
    {
        forAll(near_, i)
        {
            near[i] = near_[i];
        }
        swapLabels(near);
        for (const label f : faces_.coupled)
        {
            near_[nCells + f - nInternal] = near[nCells + f - nInternal];
        }
    }
}


void Foam::mpm::fluidInterfaces::setGradients(const contents& of)
{
    const fvMesh& mesh = faces_.mesh;
    const label width = nShares_ + 1;
    marked_.setSize(mesh.nPoints());
    pointSums_.setSize(width*mesh.nPoints());
    marked_ = false;
    DynamicList<label> points;
    for (const label c : cells_)
    {
        for (const label p : mesh.cellPoints()[c])
        {
            marked_[p] = true;
        }
    }
    if (Pstream::parRun() || !coupled_.empty())
    {
        syncTools::syncPointList(mesh, marked_, orEqOp<bool>(), false);
    }
    forAll(marked_, p)
    {
        if (marked_[p])
        {
            points.append(p);
            scalar* sum = pointSums_.begin() + width*p;
            std::fill_n(sum, width, 0.0);
            for (const label c : mesh.pointCells()[p])
            {
                const scalar w = 1/mag(mesh.points()[p] - mesh.cellCentres()[c]);
                sum[nShares_] += w;
                for (label k = 0; k < nShares_; ++k)
                {
                    sum[k] += w*of.part[n_*c + k]/of.theta[c];
                }
            }
        }
    }
    if (Pstream::parRun() || !coupled_.empty())
    {
        scalarList one(mesh.nPoints(), Zero);
        for (label k = 0; k < width; ++k)
        {
            for (const label p : points)
            {
                one[p] = pointSums_[width*p + k];
            }
            syncTools::syncPointList
            (
                mesh, one, plusEqOp<scalar>(), scalar(0)
            );
            for (const label p : points)
            {
                pointSums_[width*p + k] = one[p];
            }
        }
    }

    gradient_.setSize(nShares_*cells_.size());
    forAll(cells_, s)
    {
        const label c = cells_[s];
        for (label k = 0; k < nShares_; ++k)
        {
            vector& g = gradient_[nShares_*s + k];
            g = Zero;
            const scalar own = of.part[n_*c + k]/of.theta[c];
            if (!(own > wisp && own < 1 - wisp))
            {
                continue;
            }
            for (const label f : mesh.cells()[c])
            {
                scalar mean = 0;
                for (const label p : mesh.faces()[f])
                {
                    const scalar* sum = pointSums_.begin() + width*p;
                    mean += sum[k]/sum[nShares_];
                }
                mean /= mesh.faces()[f].size();
                g +=
                    (mean - own)*(mesh.faceOwner()[f] == c ? 1 : -1)
                   *mesh.faceAreas()[f];
            }
            for (direction d = 0; d < 3; ++d)
            {
                if (mesh.geometricD()[d] < 0)
                {
                    g[d] = 0;
                }
            }
        }
    }
}

// ************************************************************************* //
