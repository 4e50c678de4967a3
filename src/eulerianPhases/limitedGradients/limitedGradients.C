/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "limitedGradients.H"
#include "sharedPoints.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

constexpr int W = limitedGradients::width;

//- To what is around a point: a state with its weight
MPM_INLINE void addState(scalar* to, const lanes<W> w, const scalar weight)
{
    store<W>(to, load<W>(to) + weight*w);
    store<W>(to + W, laneMin(load<W>(to + W), w));
    store<W>(to + 2*W, laneMax(load<W>(to + 2*W), w));
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
        store<W>
        (
            to + 2*W,
            laneMax(load<W>(to + 2*W), load<W>(from + 2*W))
        );
    }
};


//- Nothing around a point
FixedList<scalar, 3*W> nothingAround()
{
    FixedList<scalar, 3*W> e(Zero);
    for (int i = 0; i < W; ++i)
    {
        e[W + i] = VGREAT;
        e[2*W + i] = -VGREAT;
    }
    return e;
}


//- Into the frame beyond a side that turns. Extremes have none
struct turnAround
{
    template<class Around>
    void operator()
    (
        const vectorTensorTransform& t,
        const bool forward,
        List<Around>& values
    ) const
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

void Foam::mpm::limitedGradients::aroundPoints()
{
    const label nCells = mesh_.nCells();
    const scalar* const states = states_.cdata();
    points_ = nothingAround();
    for (label c = 0; c < nCells; ++c)
    {
        const state w = load<width>(states + width*c);
        for (label k = start_[c]; k < start_[c + 1]; ++k)
        {
            const corner& at = corners_[k];
            addState(points_[at.point].data(), w, at.weight);
        }
    }
    for (const faceCorner& at : ofFaces_)
    {
        addState
        (
            points_[at.point].data(),
            load<width>(states + width*(nCells + at.face)),
            at.weight
        );
    }
    if (coupled_)
    {
        const List<around> mine(turned_ ? points_ : List<around>());
        shareOfPoints
        (
            mesh_, number_, points_, nothingAround(), combineAround(), turnAround()
        );
        forAll(mine, v)
        {
            scalar* const to = points_[v].data();
            const scalar* const from = mine[v].cdata();
            for (int i = 0; i < W; ++i)
            {
                to[W + i] = min(to[W + i], from[W + i]);
                to[2*W + i] = max(to[2*W + i], from[2*W + i]);
            }
        }
    }
    for (const label v : onAxis_)
    {
        around& e = points_[v];
        const vector u((vector(e[1], e[2], e[3]) & axis_)*axis_);
        e[1] = u.x();
        e[2] = u.y();
        e[3] = u.z();
    }
}


void Foam::mpm::limitedGradients::cellGradients()
{
    // A change of less is none, for the limiter
    constexpr scalar none = 1e-300;

    const label nCells = mesh_.nCells();
    for (label c = 0; c < nCells; ++c)
    {
        const label first = start_[c], last = start_[c + 1];
        const state w = load<width>(states_.cdata() + width*c);
        state x{}, y{}, z{};
        for (label k = first; k < last; ++k)
        {
            const corner& at = corners_[k];
            const state d = load<width>(points_[at.point].cdata()) - w;
            x += d*at.slope.x();
            y += d*at.slope.y();
            z += d*at.slope.z();
        }

        state limit = broadcast<width>(1);
        for (label k = first; k < last; ++k)
        {
            const corner& at = corners_[k];
            const scalar* const e = points_[at.point].cdata();
            const state change =
                x*at.arm.x() + y*at.arm.y() + z*at.arm.z();
            const state room = select
            (
                change > 0, load<width>(e + 2*width), load<width>(e + width)
            ) - w;
            limit = select
            (
                laneAbs(change) > none, laneMin(limit, room/change), limit
            );
        }
        scalar* const g = gradients_.data() + 3*width*c;
        store<width>(g, x*limit);
        store<width>(g + width, y*limit);
        store<width>(g + 2*width, z*limit);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::limitedGradients::limitedGradients
(
    const fvMesh& mesh,
    const labelUList& boundaryFaces,
    const labelUList& coupledFaceList
)
:
    mesh_(mesh),
    axis_(Zero),
    coupled_(returnReduce(coupledFaceList.size(), sumOp<label>()) > 0),
    turned_(false),
    states_
    (
        width*(mesh.nCells() + mesh.nFaces() - mesh.nInternalFaces()),
        Zero
    ),
    gradients_(3*width*mesh.nCells(), Zero)
{
    setCorners();
    List<vector> facePlaces;
    setFaceCorners(boundaryFaces, coupledFaceList, facePlaces);
    setAxis();
    setWeights(facePlaces);
    setSlopes();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::limitedGradients::update
(
    const UList<gasState>& W,
    const UList<gasState>& Wb
)
{
    static_assert(sizeof(gasState) == 5*sizeof(scalar), "rho, u, p");

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

// ************************************************************************* //
