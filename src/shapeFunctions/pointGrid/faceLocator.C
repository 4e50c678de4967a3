/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder
\*---------------------------------------------------------------------------*/

#include "faceLocator.H"
#include "gridNodes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar
Foam::mpm::faceLocator::beyond(const label celli, const label facei, const scalar* x) const
{
    // The same number for both cells, but for the sign
    const vector& S = mesh_.faceAreas()[facei];
    const point& C = mesh_.faceCentres()[facei];
    scalar out = 0, sqrS = 0;
    for (int d = 0; d < nDim_; ++d)
    {
        const int c = axes_.direction(d);
        out += (x[d] - C[c]) * S[c];
        sqrS += sqr(S[c]);
    }
    out /= sqrt(max(sqrS, VSMALL));
    return mesh_.faceOwner()[facei] == celli ? out : -out;
}

Foam::label Foam::mpm::faceLocator::behind(const label celli, const label facei) const
{
    return !mesh_.isInternalFace(facei)     ? coupled_.cell[facei - mesh_.nInternalFaces()]
        : mesh_.faceOwner()[facei] == celli ? mesh_.faceNeighbour()[facei]
                                            : mesh_.faceOwner()[facei];
}

void Foam::mpm::faceLocator::pass(const label facei, scalar* x) const
{
    const vector& shift = coupled_.separation[facei - mesh_.nInternalFaces()];
    for (int d = 0; d < nDim_; ++d)
    {
        x[d] += shift[axes_.direction(d)];
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::faceLocator::faceLocator(
    const polyMesh& mesh, const gridAxes& axes, ghostCells& ghosts) :
    mesh_(mesh),
    axes_(axes),
    nDim_(axes.nDim()),
    coupled_(mesh, ghosts),
    isEmpty_(gridNodes::emptyFaces(mesh)),
    width_(nDim_ * mesh.nCells())
{
    forAll(mesh.cells(), celli)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            scalar covered = VSMALL;
            for (const label facei : mesh.cells()[celli])
            {
                covered += 0.5 * mag(mesh.faceAreas()[facei][axes_.direction(d)]);
            }
            width_[nDim_ * celli + d] = mesh.cellVolumes()[celli] / covered;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::faceLocator::locate(const label from, scalar* x) const
{
    // Between the planes of a warped face neither cell has the point: then the
    // one that it is less beyond
    label celli = from, before = -1, best = -1;
    scalar beyondBefore = 0, least = GREAT;
    for (int step = 0; step < 200 && celli >= 0; ++step)
    {
        if (celli >= mesh_.nCells())
        {
            // Its processor goes on
            return celli;
        }

        scalar worst = 0;
        label through = -1;
        for (const label facei : mesh_.cells()[celli])
        {
            if (isEmpty_.test(facei))
            {
                continue;
            }
            const bool inside = mesh_.isInternalFace(facei);
            const scalar allowed =
                inside ? 0 : (behind(celli, facei) < 0 ? 1e-10 : 1e-12) * width(celli, 0);
            const scalar out = beyond(celli, facei, x);

            // On a face between two cells the owner has the point
            const bool onFace = inside && out == 0 && mesh_.faceOwner()[facei] != celli;
            if (out > max(allowed, worst) || (onFace && through < 0))
            {
                worst = out;
                through = facei;
            }
        }
        if (through < 0)
        {
            return celli;
        }

        const label next = behind(celli, through);
        if (next == before && next >= 0 && mesh_.isInternalFace(through))
        {
            const bool here = worst < beyondBefore || (worst == beyondBefore && celli < before);
            return here ? celli : before;
        }
        // Round an edge of such faces
        if (step > 100 && mesh_.isInternalFace(through) && worst < least)
        {
            least = worst;
            best = celli;
        }
        before = mesh_.isInternalFace(through) ? celli : -1;
        beyondBefore = worst;
        if (next >= 0 && !mesh_.isInternalFace(through))
        {
            pass(through, x);
        }
        celli = next;
    }
    return celli < 0 ? -1 : best;
}

Foam::label Foam::mpm::faceLocator::find(scalar* x) const
{
    if (!mesh_.nCells())
    {
        return -1;
    }
    point p(mesh_.cellCentres()[0]);
    for (int d = 0; d < nDim_; ++d)
    {
        p[axes_.direction(d)] = x[d];
    }
    return locate(mesh_.findNearestCell(p), x);
}

Foam::label Foam::mpm::faceLocator::neighbour(const label celli, const int d, const int side) const
{
    label best = -1;
    scalar most = -GREAT;
    for (const label facei : mesh_.cells()[celli])
    {
        const vector& S = mesh_.faceAreas()[facei];
        const bool outward = (mesh_.faceOwner()[facei] == celli) == bool(side);
        const scalar along = (outward ? 1 : -1) * S[axes_.direction(d)] / max(mag(S), VSMALL);
        if (!isEmpty_.test(facei) && along > most)
        {
            most = along;
            best = facei;
        }
    }
    return best < 0 ? -1 : behind(celli, best);
}
