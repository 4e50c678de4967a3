// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fluidInterfaces.H"
#include "emptyPolyPatch.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fluidInterfaces::setWidths()
{
    const fvMesh& mesh = faces_.mesh;
    const vectorField& S = mesh.faceAreas();
    const auto width = [&](const label f, const label c)
    {
        scalar across = 0;
        for (const label g : mesh.cells()[c])
        {
            across += mag(S[g] & S[f]);
        }
        return 2 * mesh.V()[c] * mag(S[f]) / across;
    };
    widthOwn_.setSize(mesh.nFaces(), 0);
    widthNei_.setSize(mesh.nInternalFaces(), 0);
    for (label f = 0; f < mesh.nFaces(); ++f)
    {
        widthOwn_[f] = width(f, mesh.faceOwner()[f]);
    }
    for (label f = 0; f < mesh.nInternalFaces(); ++f)
    {
        widthNei_[f] = width(f, mesh.faceNeighbour()[f]);
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
            *w = 1 / mag(mesh.points()[p] - mesh.cellCentres()[c]);
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
