// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointGrid.H"
#include "faceLocator.H"
#include "hexLocator.H"
#include "simplexLocator.H"
#include "coupledPolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(pointGrid, 0);
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Lengths of cyclic directions: of pairs of patches along an axis. Collective
void setPeriods(const polyMesh& mesh, const mpm::gridAxes& axes, scalar (&period)[3])
{
    vector length(Zero);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const coupledPolyPatch* sides = isA<coupledPolyPatch>(pp);
        if (sides && sides->separated())
        {
            const vector apart(cmptMag(sides->separation()[0]));
            for (int d = 0; d < axes.nDim(); ++d)
            {
                const scalar L = apart[axes.direction(d)];
                if (L > (1 - 1e-9) * mag(apart))
                {
                    length[d] = L;
                }
            }
        }
    }
    reduce(length, maxOp<vector>());
    for (int d = 0; d < axes.nDim(); ++d)
    {
        period[d] = length[d];
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointGrid::noHexes() const
{
    FatalErrorInFunction << noHexes_.c_str() << ". This needs"
                         << " a mesh of hexahedra (shape functions: linear; on meshes of"
                         << " boxes also GIMP and B-splines). On other cells the shape function"
                         << " nodeDual works." << nl
                         << "Cells beside locally refined ones have more faces: for finer cells"
                         << " in a place grade the blocks of the mesh (simpleGrading), or refine"
                         << " all." << exit(FatalError);
}

void Foam::mpm::pointGrid::noLatticeHere() const
{
    FatalErrorInFunction << "The mesh has no lattice: " << noLattice_.c_str() << '.'
                         << exit(FatalError);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointGrid::pointGrid(const polyMesh& mesh) :
    MeshObject<polyMesh, GeometricMeshObject, pointGrid>(mesh),
    gridAxes(mesh),
    nodes_(mesh, *this),
    ghosts_(mesh),
    sameWidth_(0),
    period_{0, 0, 0}
{
    noHexes_ = hexCells::refusal(mesh, *this);
    if (noHexes_.empty())
    {
        hexes_.reset(new hexCells(mesh, *this, nodes_, ghosts_));
        lattice_.reset(new gridLattice(mesh, *this, *hexes_, nodes_, ghosts_));
        noLattice_ = lattice_->refused();
        for (int d = 0; d < nDim(); ++d)
        {
            period_[d] = lattice_->period(d);
        }
        if (noLattice_.empty())
        {
            sameWidth_ = lattice_->sameWidth();
            return;
        }
        lattice_.clear();
        setPeriods(mesh, *this, period_);
        noHexes_ = hexLocator(mesh, *this, *hexes_).folded();
    }
    if (noHexes_.empty())
    {
        nodes_.addRing();
        locator_.reset(new hexLocator(mesh, *this, *hexes_));
        return;
    }

    // Cells of any kind
    setPeriods(mesh, *this, period_);
    hexes_.clear();
    noLattice_ = noHexes_;
    nodes_.joinPoints();
    nodes_.addRing();
    locator_.reset(new faceLocator(mesh, *this, ghosts_));
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::mpm::pointGrid::nodePositions() const
{
    pointField x(nodes_.positions());
    if (lattice_)
    {
        lattice_->addGhostPositions(nodes_.points(), x);
    }
    return x;
}

const Foam::labelList& Foam::mpm::pointGrid::axisNodes() const
{
    static const labelList none;
    return hexes_ ? hexes_->axisNodes() : none;
}

const Foam::mpm::cellSimplices& Foam::mpm::pointGrid::simplices() const
{
    if (!simplices_)
    {
        simplices_.reset(new cellSimplices(*this, cellSimplices::boxes));
        if (!lattice_)
        {
            locator_.reset(new simplexLocator(mesh(), *this, nodes_, *simplices_, ghosts_));
        }
    }
    return *simplices_;
}

void Foam::mpm::pointGrid::localCoordinates(const label celli, const scalar* x, scalar* xi) const
{
    if (lattice_)
    {
        lattice_->localCoordinates(celli, x, xi);
    }
    else
    {
        hexLocator(mesh(), *this, hexes()).localCoordinates(celli, x, xi);
    }
}

Foam::scalarList
Foam::mpm::pointGrid::nodeVolumes(const sharedNodes& sums, const bool byRadius) const
{
    scalarList volume(nNodes(), Zero);
    const scalarField& V = mesh().cellVolumes();
    forAll(V, celli)
    {
        const SubList<label> nodes(nodesOf(celli));
        if (!byRadius || radial() < 0 || !hexes_)
        {
            for (const label n : nodes)
            {
                volume[n] += V[celli] / nodes.size();
            }
            continue;
        }
        scalar x[8];
        hexes().cornerPositions(celli, x);
        const scalar r0 = x[radial()], r1 = x[6 + radial()];
        const scalar inner = (2 * r0 + r1) / (3 * (r0 + r1));
        forAll(nodes, n)
        {
            const scalar part = 0.5 * ((n >> radial()) & 1 ? 1 - inner : inner);
            volume[nodes[n]] += part * V[celli];
        }
    }
    sums.sum(volume.data(), 1, 1);
    return volume;
}

Foam::scalar
Foam::mpm::pointGrid::divergence(const label celli, const scalar* U, const int stride) const
{
    const label n = label(1) << nDim();
    const label* corners = hexes().corners(celli);
    scalar div = 0;
    for (int d = 0; d < nDim(); ++d)
    {
        const scalar width = this->width(celli, d);
        for (label i = 0; i < n; ++i)
        {
            const scalar u = U[stride * corners[i] + d];
            div += ((i >> d) & 1 ? u : -u) * 2 / (n * width);
        }
    }
    return div;
}
