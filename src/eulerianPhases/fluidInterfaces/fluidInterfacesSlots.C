/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "fluidInterfaces.H"
#include "emptyPolyPatch.H"
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


void Foam::mpm::fluidInterfaces::setWeights()
{
    const fvMesh& mesh = faces_.mesh;
    weightStart_.setSize(mesh.nPoints() + 1, 0);
    forAll(mesh.pointCells(), p)
    {
        weightStart_[p + 1] = weightStart_[p] + mesh.pointCells()[p].size();
    }
    weights_.setSize(weightStart_.last());
    scalarList sum(mesh.nPoints(), Zero);
    forAll(sum, p)
    {
        scalar* w = weights_.begin() + weightStart_[p];
        for (const label c : mesh.pointCells()[p])
        {
            *w = 1/mag(mesh.points()[p] - mesh.cellCentres()[c]);
            sum[p] += *w++;
        }
    }
    if (Pstream::parRun() || !coupled_.empty())
    {
        syncTools::syncPointList(mesh, sum, plusEqOp<scalar>(), scalar(0));
    }
    forAll(sum, p)
    {
        for (label i = weightStart_[p]; i < weightStart_[p + 1]; ++i)
        {
            weights_[i] /= sum[p];
        }
    }
    const label nInternal = mesh.nInternalFaces();
    empty_.setSize(mesh.nFaces() - nInternal, false);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        for (label f = pp.start(); f < pp.start() + pp.size(); ++f)
        {
            empty_[f - nInternal] = isA<emptyPolyPatch>(pp);
        }
    }
}


void Foam::mpm::fluidInterfaces::setMeans(const contents& of)
{
    const fvMesh& mesh = faces_.mesh;
    marked_.setSize(mesh.nPoints());
    pointMeans_.setSize(nShares_*mesh.nPoints());
    shares_.setSize(nShares_*mesh.nCells());
    marked_ = false;
    for (const label c : cells_)
    {
        for (const label p : mesh.cellPoints()[c])
        {
            marked_[p] = true;
        }
    }
    const bool sync = Pstream::parRun() || !coupled_.empty();
    if (sync)
    {
        syncTools::syncPointList(mesh, marked_, orEqOp<bool>(), false);
    }
    forAll(of.theta, c)
    {
        for (label k = 0; k < nShares_; ++k)
        {
            shares_[nShares_*c + k] = of.part[n_*c + k]/of.theta[c];
        }
    }
    const labelListList& pointCells = mesh.pointCells();
    forAll(marked_, p)
    {
        scalar* mean = pointMeans_.begin() + nShares_*p;
        std::fill_n(mean, nShares_, 0.0);
        if (marked_[p])
        {
            const scalar* w = weights_.cdata() + weightStart_[p];
            for (const label c : pointCells[p])
            {
                for (label k = 0; k < nShares_; ++k)
                {
                    mean[k] += *w*shares_[nShares_*c + k];
                }
                ++w;
            }
        }
    }
    if (sync)
    {
        scalarList one(mesh.nPoints(), Zero);
        for (label k = 0; k < nShares_; ++k)
        {
            forAll(one, p)
            {
                one[p] = pointMeans_[nShares_*p + k];
            }
            syncTools::syncPointList
            (
                mesh, one, plusEqOp<scalar>(), scalar(0)
            );
            forAll(one, p)
            {
                pointMeans_[nShares_*p + k] = one[p];
            }
        }
    }
}


void Foam::mpm::fluidInterfaces::setGradients(const contents& of)
{
    setMeans(of);
    const fvMesh& mesh = faces_.mesh;
    const label nInternal = mesh.nInternalFaces();
    const labelUList& owner = mesh.faceOwner();
    const vectorField& S = mesh.faceAreas();
    const faceList& faces = mesh.faces();
    const cellList& cells = mesh.cells();
    const Vector<label>& directions = mesh.geometricD();
    gradient_.setSize(nShares_*cells_.size());
    forAll(cells_, s)
    {
        const label c = cells_[s];
        for (label k = 0; k < nShares_; ++k)
        {
            vector& g = gradient_[nShares_*s + k];
            g = Zero;
            const scalar own = shares_[nShares_*c + k];
            if (!(own > wisp && own < 1 - wisp))
            {
                continue;
            }
            for (const label f : cells[c])
            {
                if (f >= nInternal && empty_[f - nInternal])
                {
                    continue;
                }
                const face& points = faces[f];
                scalar mean = 0;
                for (const label p : points)
                {
                    mean += pointMeans_[nShares_*p + k];
                }
                mean /= points.size();
                g += (mean - own)*(owner[f] == c ? 1 : -1)*S[f];
            }
            for (direction d = 0; d < 3; ++d)
            {
                if (directions[d] < 0)
                {
                    g[d] = 0;
                }
            }
        }
    }
}

// ************************************************************************* //
