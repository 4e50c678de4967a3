// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "starFraction.H"
#include "lanes.H"
#include "addToRunTimeSelectionTable.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(starFraction, 0);
addToRunTimeSelectionTable(solidFraction, starFraction, dictionary);
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

starOperators makeStars(const pointGrid& grid)
{
    try
    {
        return starOperators(grid);
    }
    catch (const string& reason)
    {
        FatalErrorInFunction << "Material points in a gas do not work on this mesh: "
                             << reason.c_str() << "." << exit(FatalError);
        throw;
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::mpm::starFraction::inAxes(const scalar* q) const
{
    const pointGrid& grid = stars_.grid();
    vector v(Zero);
    for (int d = 0; d < grid.nDim(); ++d)
    {
        v[grid.direction(d)] = q[d];
    }
    return v;
}

void Foam::mpm::starFraction::shiftLevels()
{
    if (!arrived_)
    {
        return;
    }
    arrived_ = false;
    for (const label l : nodes_)
    {
        old_[l] = volumeOf(node_, l);
        forAll(ofPhase_, phasei)
        {
            oldOfPhase_[phasei][l] = volumeOf(ofPhase_[phasei], l);
        }
    }
}

void Foam::mpm::starFraction::clear()
{
    const auto zero = [](scalarList& q, const label i, const int stride)
    { std::fill_n(q.begin() + stride * i, stride, 0.0); };
    for (const label c : cells_)
    {
        for (label v = stars_.start(c); v < stars_.start(c + 1); ++v)
        {
            zero(vertex_, v, starPoints::vertexStride);
        }
        zero(cell_, c, starPoints::cellStride);
        hasSums_[c] = false;
    }
    for (const label l : nodes_)
    {
        zero(node_, l, starPoints::nodeStride);
        for (scalarList& q : ofPhase_)
        {
            zero(q, l, starPoints::nodeStride);
        }
        hasNode_[l] = false;
    }
    cells_.clear();
    nodes_.clear();
}

void Foam::mpm::starFraction::touch()
{
    for (const materialPointPhase& phase : points_.phases())
    {
        for (const label c : phase.cloud().cells())
        {
            if (hasSums_[c])
            {
                continue;
            }
            hasSums_[c] = true;
            cells_.append(c);
            const label* nodes = stars_.cells().nodes(c);
            for (label i = 0; i < stars_.cells().nVertices(c); ++i)
            {
                if (!hasNode_[nodes[i]])
                {
                    hasNode_[nodes[i]] = true;
                    nodes_.append(nodes[i]);
                }
            }
        }
    }
}

void Foam::mpm::starFraction::share()
{
    const sharedStars* others = stars_.others();
    if (!others)
    {
        return;
    }
    constexpr int stride = starPoints::nodeStride;
    const labelList& shared = others->nodes().nodes();
    const auto mark = [&](const label l) -> scalar&
    { return ofPhase_[0][stride * l + starPoints::spare]; };
    for (const label l : shared)
    {
        mark(l) = hasNode_[l];
    }
    forAll(ofPhase_, phasei)
    {
        scalarList& q = ofPhase_[phasei];
        DynamicList<label>& beside = beside_[phasei];
        beside.clear();
        for (const label l : shared)
        {
            if (!(volumeOf(q, l) > 0))
            {
                beside.append(l);
            }
        }
        others->nodes().sum(q.begin(), stride, stride);
        label n = 0;
        for (const label l : beside)
        {
            if (volumeOf(q, l) > 0)
            {
                beside[n++] = l;
            }
        }
        beside.setSize(n);
    }
    for (const label l : shared)
    {
        if (mark(l) > 0 && !hasNode_[l])
        {
            hasNode_[l] = true;
            nodes_.append(l);
        }
    }
    others->sendRows(
        hasNode_, [&](const label l) { return stars_.verticesOf(l); }, vertex_.cdata(),
        starPoints::way(stars_.grid().nDim()) + 1);
}

void Foam::mpm::starFraction::collectNodes()
{
    share();

    // In an order that does not depend on the past: a restart sums the same
    std::sort(nodes_.begin(), nodes_.end());
    constexpr int stride = starPoints::nodeStride;
    for (const label l : nodes_)
    {
        std::fill_n(node_.begin() + stride * l, stride, 0.0);
        for (const scalarList& q : ofPhase_)
        {
            for (int i = 0; i < stride; ++i)
            {
                node_[stride * l + i] += q[stride * l + i];
            }
        }
    }
}

Foam::mpm::starPoints::sums Foam::mpm::starFraction::sumsOf(const label phasei)
{
    return {vertex_.begin(), ofPhase_[phasei].begin(), cell_.begin()};
}

void Foam::mpm::starFraction::sumFaces()
{
    typedef lanes<faceStride> row;
    static_assert(faceStride == 8, "rows of lanes");

    for (const label f : faces_)
    {
        std::fill_n(face_.begin() + faceStride * f, faceStride, 0.0);
        hasFace_[f] = false;
    }
    faces_.clear();

    const int D = stars_.grid().nDim();
    const sharedStars* others = stars_.others();
    std::vector<row> sum;
    for (const label l : nodes_)
    {
        const SubList<label> faces(stars_.facesOf(l));
        const SubList<label> vertices(stars_.verticesOf(l));
        const starOperators::star& star = stars_.ofNode(l);
        const label n = faces.size();
        sum.assign(n, row{});
        const auto add = [&](const scalar* of, const label i)
        {
            const row q = load<faceStride>(of);
            const scalar* g = star.g.begin() + n * i;
            for (label k = 0; k < n; ++k)
            {
                sum[k] += g[k] * q;
            }
        };
        forAll(vertices, i)
        {
            const label v = vertices[i];
            if (hasSums_[stars_.cellOf(v)])
            {
                add(vertex_.begin() + faceStride * v, i);
            }
        }
        if (const starPart* part = others ? others->othersOf(l) : nullptr)
        {
            const scalar* rows = others->rowsOf(l);
            forAll(part->vertices, i)
            {
                add(rows + faceStride * i, vertices.size() + i);
            }
        }
        const scalar* q = node_.begin() + starPoints::nodeStride * l;
        for (label k = 0; k < n; ++k)
        {
            const scalar* B = star.B.begin() + D * k;
            for (int d = 0; d < D; ++d)
            {
                sum[k][starPoints::gradOld(D) + d] -= q[starPoints::volumeOld] * B[d];
                sum[k][starPoints::gradNew(D) + d] -= q[starPoints::volume] * B[d];
                sum[k][starPoints::way(D)] -= q[starPoints::moved + d] * B[d];
            }
            const label f = faces[k];
            if (!hasFace_[f])
            {
                hasFace_[f] = true;
                faces_.append(f);
            }
            scalar* to = face_.begin() + faceStride * f;
            store<faceStride>(to, load<faceStride>(to) + sum[k]);
        }
    }

    // The other faces of cyclic pairs
    const label nFaces = faces_.size();
    for (label k = 0; k < nFaces; ++k)
    {
        const label f = faces_[k], other = stars_.mate(f);
        if (other >= 0)
        {
            hasFace_[other] = true;
            faces_.append(other);
            for (int i = 0; i < faceStride; ++i)
            {
                face_[faceStride * other + i] = -face_[faceStride * f + i];
            }
        }
    }
}

void Foam::mpm::starFraction::updateVelocities()
{
    const pointGrid& grid = stars_.grid();
    const int D = grid.nDim();
    forAll(velocity_, phasei)
    {
        const materialPointPhase& phase = points_.phases()[phasei];
        const velocityField& field = points_.fields()[points_.fieldOf(phasei)];
        scalarList& u = velocity_[phasei];
        const scalar* U = phase.motion() ? nullptr
            : levels_ ? levels_->atShares(phase.cloud(), field.U(), beside_[phasei])
                      : field.U();
        for (const label l : nodes_)
        {
            // A node that the last point has left keeps its velocity
            if (!(volumeOf(ofPhase_[phasei], l) > 0))
            {
                continue;
            }
            const vector rigid(
                U ? vector(Zero)
                  : phase.motion()->now().velocityAt(grid.mesh().points()[grid.nodePoint()[l]]));
            for (int d = 0; d < D; ++d)
            {
                u[D * l + d] = U ? U[field.stride() * l + d] : rigid[grid.direction(d)];
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::starFraction::starFraction(materialPointSystem& points, const dictionary& gasDict) :
    solidFraction(points, gasDict, 1),
    stars_(makeStars(points.grid())),
    sums_(starPoints::New(points.grid(), stars_.cells(), stars_.starts())),
    levels_(dynamic_cast<const twoLevelShares*>(&points.gridTransfer())),
    gap_(levels_ ? 0.4 : 0.1),
    vertex_(starPoints::vertexStride * stars_.nVertices(), Zero),
    cell_(starPoints::cellStride * mesh_.nCells(), Zero),
    node_(starPoints::nodeStride * points.grid().nNodes(), Zero),
    ofPhase_(points.phases().size(), scalarList(node_.size(), Zero)),
    old_(points.grid().nNodes(), Zero),
    oldOfPhase_(points.phases().size(), scalarList(old_.size(), Zero)),
    velocity_(points.phases().size(), scalarList(points.grid().nDim() * old_.size(), Zero)),
    face_(faceStride * mesh_.nFaces(), Zero),
    beside_(points.phases().size()),
    hasSums_(mesh_.nCells(), false),
    hasNode_(old_.size(), false),
    hasFace_(mesh_.nFaces(), false),
    isAround_(mesh_.nCells(), false),
    arrived_(false),
    area0_(mesh_.nFaces(), Zero),
    area_(mesh_.nFaces(), Zero),
    areaNew_(mesh_.nFaces(), Zero),
    velocityOfFaces_(mesh_.nFaces(), Zero),
    ofSector_(points.grid().radial() < 0 ? bitSet() : gridNodes::emptyFaces(mesh_)),
    soundLimit_(mesh_.nFaces(), Zero),
    dense_(points.phases().size()),
    largest_(old_.size(), Zero),
    around1_(mesh_.nCells(), Zero),
    failed_(old_.size(), false)
{
    const bitSet isEmpty(gridNodes::emptyFaces(mesh_));
    scalarField limit(mesh_.nCells());
    forAll(limit, c)
    {
        label n = 0;
        for (const label f : mesh_.cells()[c])
        {
            n += !isEmpty.test(f);
        }
        limit[c] = 0.8 / n;
    }
    DynamicList<label> sides;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        for (label i = 0; !pp.coupled() && i < pp.size(); ++i)
        {
            if (!isEmpty.test(pp.start() + i))
            {
                sides.append(pp.start() + i);
            }
        }
    }
    sides_.transfer(sides);
    const scalarList behind(coupled_.behind(limit));
    forAll(soundLimit_, f)
    {
        const label i = f - mesh_.nInternalFaces();
        soundLimit_[f] =
            min(limit[mesh_.faceOwner()[f]], i < 0 ? limit[mesh_.faceNeighbour()[f]] : behind[i]);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::starFraction::show(solidOnFaces& pores) const
{
    solidFraction::show(pores);
    pores.area0 = area0_.cdata();
    pores.area = area_.cdata();
    pores.U = velocityOfFaces_.cdata();
    pores.soundLimit = soundLimit_.cdata();
    pores.leak = 0;
}

void Foam::mpm::starFraction::initialise()
{
    updateVolumes();

    // In a run: nothing of points that have left
    for (const label l : nodes_)
    {
        old_[l] = 0;
        for (scalarList& old : oldOfPhase_)
        {
            old[l] = 0;
        }
    }
    for (const label f : faces_)
    {
        area0_[f] = area_[f] = areaNew_[f] = velocityOfFaces_[f] = Zero;
        thetaS0_[f] = thetaS_[f] = phiS_[f] = uS_[f] = 0;
        rhoS_[f] = dragLimit_[f] = 0;
    }
    clear();
    touch();
    forAll(points_.phases(), phasei)
    {
        sums_->arrive(points_.phases()[phasei].cloud(), nullptr, sumsOf(phasei));
    }
    collectNodes();
    sumFaces();
    const int D = stars_.grid().nDim();
    for (const label f : faces_)
    {
        areaNew_[f] = (1 - eps_) * inAxes(face_.begin() + faceStride * f + starPoints::gradNew(D));
    }
    updateVelocities();
    updateTheta();
    findDense();
    findSurface();
    arrived_ = true;
}

void Foam::mpm::starFraction::setPressure(const UList<scalar>& p, const UList<scalar>& pBehind)
{
    stars_.toNodes(p, P_, &nodes_);
    updateGasPush(p, pBehind, areaNew_);
}

void Foam::mpm::starFraction::gather(const label phasei, const scalarField* pOwn)
{
    if (pOwn)
    {
        updatePush(phasei, *pOwn);
    }
    sums_->gather(
        points_.phases()[phasei].cloud(), P_.cdata(), 1 - eps_, pOwn ? push_.cdata() : nullptr);
}

void Foam::mpm::starFraction::depart()
{
    shiftLevels();
    clear();
    touch();
    forAll(points_.phases(), phasei)
    {
        sums_->depart(points_.phases()[phasei].cloud(), sumsOf(phasei));
    }
}

void Foam::mpm::starFraction::arrive(const scalar dt)
{
    updateVolumes();
    touch();
    forAll(points_.phases(), phasei)
    {
        sums_->arrive(points_.phases()[phasei].cloud(), oldVolume_[phasei].cdata(), sumsOf(phasei));
    }
    collectNodes();
    arrived_ = true;

    updateVelocities();
    for (const label f : faces_)
    {
        area0_[f] = areaNew_[f];
        area_[f] = areaNew_[f] = velocityOfFaces_[f] = Zero;
        thetaS_[f] = phiS_[f] = uS_[f] = 0;
        rhoS_[f] = dragLimit_[f] = 0;
    }
    sumFaces();
    for (const label f : faces_)
    {
        updateFace(f, dt);
    }
    updateSides();
    updateTheta();
    limitDrag();
    updateDilation(dt);
    findDense();
    findSurface();
}
