// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "limitedGradients.H"
#include "sharedPoints.H"
#include "wedgePolyPatch.H"
#include "principalAxes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- Inverse of a symmetric tensor, but in eigendirections e that keep(e, value)
//  refuses or that have next to no value
template<class Keep>
tensor pseudoInverse(const tensor& K, const Keep& keep)
{
    const principalAxes<3> axes(K.cdata());
    tensor result(Zero);
    for (int i = 0; i < 3; ++i)
    {
        const scalar value = axes.value[i];
        const vector e(axes.direction[i][0], axes.direction[i][1], axes.direction[i][2]);
        if (value > 1e-12 * axes.value[2] && keep(e, value))
        {
            result += e * e / value;
        }
    }
    return result;
}

//- Part of a vector in the directions that have cells
vector inPlane(const vector& a, const Vector<label>& directions)
{
    vector b(a);
    for (direction i = 0; i < 3; ++i)
    {
        if (directions[i] == -1)
        {
            b[i] = 0;
        }
    }
    return b;
}

template<class Moments>
void addMoments(Moments& m, const scalar w, const vector& d)
{
    label k = 0;
    m[k++] += w;
    for (direction i = 0; i < 3; ++i)
    {
        m[k++] += w * d[i];
    }
    for (direction i = 0; i < 3; ++i)
    {
        for (direction j = i; j < 3; ++j)
        {
            m[k++] += w * d[i] * d[j];
        }
    }
}

template<class Moments>
vector firstMoment(const Moments& m)
{
    return vector(m[1], m[2], m[3]);
}

template<class Moments>
tensor secondMoment(const Moments& m)
{
    return tensor(m[4], m[5], m[6], m[5], m[7], m[8], m[6], m[8], m[9]);
}

struct turnMoments
{
    template<class Moments>
    void operator()(const vectorTensorTransform& t, const bool forward, List<Moments>& values) const
    {
        if (!t.hasR())
        {
            return;
        }
        const tensor R(forward ? t.R() : t.R().T());
        for (Moments& m : values)
        {
            const vector a(R & firstMoment(m));
            const tensor b(R & secondMoment(m) & R.T());
            m[1] = a.x();
            m[2] = a.y();
            m[3] = a.z();
            m[4] = b.xx();
            m[5] = b.xy();
            m[6] = b.xz();
            m[7] = b.yy();
            m[8] = b.yz();
            m[9] = b.zz();
        }
    }
};

scalar weightOf(const vector& d) { return 1 / max(magSqr(d), VSMALL); }

constexpr int W = limitedGradients::width;

//- To what is around a point: a state with its weight
MPM_INLINE void addState(scalar* to, const lanes<W> w, const scalar weight)
{
    store<W>(to, load<W>(to) + weight * w);
    store<W>(to + W, laneMin(load<W>(to + W), w));
    store<W>(to + 2 * W, laneMax(load<W>(to + 2 * W), w));
}

struct combineAround
{
    template<class Around>
    void operator()(Around& a, const Around& b) const
    {
        scalar* const to = a.data();
        const scalar* const from = b.cdata();
        store<W>(to, load<W>(to) + load<W>(from));
        store<W>(to + W, laneMin(load<W>(to + W), load<W>(from + W)));
        store<W>(to + 2 * W, laneMax(load<W>(to + 2 * W), load<W>(from + 2 * W)));
    }
};

//- Nothing around a point
FixedList<scalar, 3 * W> nothingAround()
{
    FixedList<scalar, 3 * W> e(Zero);
    for (int i = 0; i < W; ++i)
    {
        e[W + i] = VGREAT;
        e[2 * W + i] = -VGREAT;
    }
    return e;
}

//- Into the frame beyond a side that turns. Extremes have none
struct turnAround
{
    template<class Around>
    void operator()(const vectorTensorTransform& t, const bool forward, List<Around>& values) const
    {
        if (!t.hasR())
        {
            return;
        }
        const tensor R(forward ? t.R() : t.R().T());
        for (Around& e : values)
        {
            const vector u(R & vector(e[1], e[2], e[3]));
            const scalar rho = e[0], p = e[4];
            e = nothingAround();
            e[0] = rho;
            e[1] = u.x();
            e[2] = u.y();
            e[3] = u.z();
            e[4] = p;
        }
    }
};

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::limitedGradients::setCorners()
{
    const vectorField& C = mesh_.cellCentres();
    const pointField& points = mesh_.points();
    const labelListList& cellPoints = mesh_.cellPoints();
    const Vector<label>& directions = mesh_.geometricD();

    // Of two points in a direction without cells one is enough
    const auto counts = [&](const vector& arm)
    {
        bool yes = true;
        for (direction i = 0; i < 3; ++i)
        {
            yes = yes && (directions[i] != -1 || arm[i] < 1e-6 * mag(arm));
        }
        return yes;
    };

    label nPoints = 0;
    number_.setSize(mesh_.nPoints(), -1);
    DynamicList<corner> corners(8 * mesh_.nCells());
    start_.setSize(mesh_.nCells() + 1, 0);
    forAll(cellPoints, c)
    {
        for (const label v : cellPoints[c])
        {
            const vector arm(points[v] - C[c]);
            if (counts(arm))
            {
                if (number_[v] < 0)
                {
                    number_[v] = nPoints++;
                }
                corners.append(corner{number_[v], 0, inPlane(arm, directions), Zero});
            }
        }
        start_[c + 1] = corners.size();
    }
    corners_.transfer(corners);
    points_.setSize(nPoints);
}

void Foam::mpm::limitedGradients::setFaceCorners(
    const labelUList& boundaryFaces, const labelUList& coupledFaceList, List<vector>& places)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    vectorField delta(mesh_.nFaces() - nInternal, Zero);
    for (const fvPatch& patch : mesh_.boundary())
    {
        const vectorField d(patch.delta());
        forAll(d, i)
        {
            delta[patch.start() - nInternal + i] = d[i];
        }
    }

    DynamicList<faceCorner> ofFaces;
    DynamicList<vector> place;
    const auto add = [&](const label f, const bool weighs)
    {
        const label i = f - nInternal;
        const vector foot(mesh_.cellCentres()[own[f]] + delta[i]);
        for (const label v : mesh_.faces()[f])
        {
            if (number_[v] >= 0)
            {
                ofFaces.append(faceCorner{i, number_[v], scalar(weighs ? 1 : 0)});
                place.append(inPlane(foot - mesh_.points()[v], mesh_.geometricD()));
            }
        }
    };
    for (const label f : boundaryFaces)
    {
        add(f, true);
    }

    // Sides that turn: their extremes do not come with share
    for (const label f : coupledFaceList)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[mesh_.boundaryMesh().whichPatch(f)];
        if (!refCast<const coupledPolyPatch>(pp).parallel())
        {
            turned_ = true;
            add(f, false);
        }
    }
    ofFaces_.transfer(ofFaces);
    places.transfer(place);
}

void Foam::mpm::limitedGradients::setAxis()
{
    labelList sides(mesh_.nPoints(), 0);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp) && pp.size())
        {
            axis_ = refCast<const wedgePolyPatch>(pp).axis();
            for (const label v : pp.meshPoints())
            {
                ++sides[v];
            }
        }
    }
    DynamicList<label> onAxis;
    forAll(sides, v)
    {
        if (sides[v] == 2 && number_[v] >= 0)
        {
            onAxis.append(number_[v]);
        }
    }
    onAxis_.transfer(onAxis);
}

void Foam::mpm::limitedGradients::setWeights(const List<vector>& facePlaces)
{
    const moments none(Zero);
    List<moments> sums(points_.size(), none);
    for (const corner& at : corners_)
    {
        addMoments(sums[at.point], weightOf(at.arm), -at.arm);
    }
    forAll(ofFaces_, i)
    {
        const vector& d = facePlaces[i];
        if (ofFaces_[i].weight > 0)
        {
            addMoments(sums[ofFaces_[i].point], weightOf(d), d);
        }
    }
    if (coupled_)
    {
        shareOfPoints(
            mesh_, number_, sums, none,
            [](moments& a, const moments& b)
            {
                forAll(a, i)
                {
                    a[i] += b[i];
                }
            },
            turnMoments());
    }

    // Value at the point: mean less slope times the mean place
    vectorField mean(sums.size()), back(sums.size());
    forAll(sums, v)
    {
        const moments& m = sums[v];
        const vector d(firstMoment(m) / m[0]);
        mean[v] = d;
        back[v] =
            d
            & pseudoInverse(
                secondMoment(m) / m[0] - d * d,
                [&](const vector& e, const scalar spread) { return spread > 0.05 * sqr(d & e); });
    }
    const auto weight = [&](const label v, const vector& d)
    { return weightOf(d) / sums[v][0] * (1 - (back[v] & (d - mean[v]))); };
    for (corner& at : corners_)
    {
        at.weight = weight(at.point, -at.arm);
    }
    forAll(ofFaces_, i)
    {
        faceCorner& at = ofFaces_[i];
        if (at.weight > 0)
        {
            at.weight = weight(at.point, facePlaces[i]);
        }
    }
}

void Foam::mpm::limitedGradients::setSlopes()
{
    for (label c = 0; c < mesh_.nCells(); ++c)
    {
        const label n = start_[c + 1] - start_[c];
        moments sums(Zero);
        for (label k = start_[c]; k < start_[c + 1]; ++k)
        {
            addMoments(sums, 1, corners_[k].arm);
        }
        const vector mean(firstMoment(sums) / n);
        const tensor K(pseudoInverse(
            secondMoment(sums) - n * (mean * mean),
            [](const vector&, const scalar) { return true; }));
        for (label k = start_[c]; k < start_[c + 1]; ++k)
        {
            corners_[k].slope = K & (corners_[k].arm - mean);
        }
    }
}

void Foam::mpm::limitedGradients::aroundPoints()
{
    const label nCells = mesh_.nCells();
    const scalar* const states = states_.cdata();
    points_ = nothingAround();
    for (label c = 0; c < nCells; ++c)
    {
        const state w = load<width>(states + width * c);
        for (label k = start_[c]; k < start_[c + 1]; ++k)
        {
            const corner& at = corners_[k];
            addState(points_[at.point].data(), w, at.weight);
        }
    }
    for (const faceCorner& at : ofFaces_)
    {
        addState(
            points_[at.point].data(), load<width>(states + width * (nCells + at.face)), at.weight);
    }
    if (coupled_)
    {
        const List<around> mine(turned_ ? points_ : List<around>());
        shareOfPoints(mesh_, number_, points_, nothingAround(), combineAround(), turnAround());
        forAll(mine, v)
        {
            scalar* const to = points_[v].data();
            const scalar* const from = mine[v].cdata();
            for (int i = 0; i < W; ++i)
            {
                to[W + i] = min(to[W + i], from[W + i]);
                to[2 * W + i] = max(to[2 * W + i], from[2 * W + i]);
            }
        }
    }
    for (const label v : onAxis_)
    {
        around& e = points_[v];
        const vector u((vector(e[1], e[2], e[3]) & axis_) * axis_);
        e[1] = u.x();
        e[2] = u.y();
        e[3] = u.z();
    }
}

void Foam::mpm::limitedGradients::cellGradients()
{
    // A change of less is none, for the limiter. Where all around a point have the same value
    // there is no room, and a change is rounding: this much of the values is left for it. A
    // gradient without any larger change is none: what is uniform stays so to the last bit
    constexpr scalar none = 1e-300, rounding = 1e-13;

    const label nCells = mesh_.nCells();
    for (label c = 0; c < nCells; ++c)
    {
        const label first = start_[c], last = start_[c + 1];
        const state w = load<width>(states_.cdata() + width * c);
        state x{}, y{}, z{}, size = laneAbs(w);
        for (label k = first; k < last; ++k)
        {
            const corner& at = corners_[k];
            const state d = load<width>(points_[at.point].cdata()) - w;
            size = laneMax(size, laneAbs(d));
            x += d * at.slope.x();
            y += d * at.slope.y();
            z += d * at.slope.z();
        }

        state limit = broadcast<width>(1), most{};
        for (label k = first; k < last; ++k)
        {
            const corner& at = corners_[k];
            const scalar* const e = points_[at.point].cdata();
            const state change = x * at.arm.x() + y * at.arm.y() + z * at.arm.z();
            const state room =
                select(change > 0, load<width>(e + 2 * width), load<width>(e + width)) - w;
            most = laneMax(most, laneAbs(change));
            limit = select(
                laneAbs(change) > none,
                laneMin(limit, (laneAbs(room) + rounding * size) / laneAbs(change)), limit);
        }
        limit = select(most > rounding * size, limit, broadcast<width>(0));
        scalar* const g = gradients_.data() + 3 * width * c;
        store<width>(g, x * limit);
        store<width>(g + width, y * limit);
        store<width>(g + 2 * width, z * limit);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::limitedGradients::limitedGradients(
    const fvMesh& mesh, const labelUList& boundaryFaces, const labelUList& coupledFaceList) :
    mesh_(mesh),
    axis_(Zero),
    coupled_(returnReduce(coupledFaceList.size(), sumOp<label>()) > 0),
    turned_(false),
    states_(width * (mesh.nCells() + mesh.nFaces() - mesh.nInternalFaces()), Zero),
    gradients_(3 * width * mesh.nCells(), Zero)
{
    setCorners();
    List<vector> facePlaces;
    setFaceCorners(boundaryFaces, coupledFaceList, facePlaces);
    setAxis();
    setWeights(facePlaces);
    setSlopes();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::limitedGradients::update(const UList<gasState>& W, const UList<gasState>& Wb)
{
    static_assert(sizeof(gasState) == 5 * sizeof(scalar), "rho, u, p");

    scalar* to = states_.data();
    for (const UList<gasState>* list : {&W, &Wb})
    {
        for (const gasState& w : *list)
        {
            std::memcpy(to, &w, sizeof(gasState));
            to += width;
        }
    }
    aroundPoints();
    cellGradients();
}
