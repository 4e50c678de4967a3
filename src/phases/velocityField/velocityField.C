// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "velocityField.H"
#include "shapeConcept.H"
#include "pointMesh.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Names of the files U.* of a folder
string filesOf(const fileName& folder)
{
    string all;
    for (const fileName& file : readDir(folder))
    {
        if (file.startsWith("U."))
        {
            all += (all.empty() ? "" : " ") + file;
        }
    }
    return all.empty() ? string("none") : all;
}

//- The field of a file, which must be there, or of a state
pointVectorField
fieldOfNodes(const IOobject& io, const pointMesh& mesh, const mpm::fieldStates* states)
{
    if (!states && returnReduce(io.localFilePath(pointVectorField::typeName).empty(), orOp<bool>()))
    {
        FatalErrorInFunction << "there is no such file." << nl
                             << "It holds the velocity of the mesh points of velocityField "
                             << io.group() << " with its boundary conditions: a pointVectorField"
                             << " for each velocityField of constant/phaseProperties (without"
                             << " the entry: the name of the phase). If the word is misspelt mend"
                             << " velocityField of the phase that has it. Files of velocity there: "
                             << filesOf(io.path()).c_str() << "." << exit(FatalError);
    }
    return mpm::fileOrState<pointVectorField>(io, mesh, states);
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::velocityField::velocityField(
    const pointGrid& grid, const word& name, const label reach, const fieldStates* states) :
    grid_(grid),
    name_(name),
    nDim_(grid.nDim()),
    stride_(grid.nDim() == 1 ? 2 : 4),
    Ufield_(fieldOfNodes(
        IOobject(
            IOobject::groupName("U", name), grid.mesh().time().timeName(), grid.mesh(),
            IOobject::MUST_READ, IOobject::AUTO_WRITE),
        pointMesh::New(grid.mesh()), states)),
    mU_(stride_ * grid.nNodes()),
    mUNew_(stride_ * grid.nNodes()),
    f_(stride_ * grid.nNodes()),
    U_(stride_ * grid.nNodes()),
    UL_(stride_ * grid.nNodes()),
    dU_(stride_ * grid.nNodes()),
    filtered_(ofUL),
    strainIsU_(true),
    stamp_(grid.nNodes(), label(-1)),
    stampNow_(0),
    shared_(grid.shared(reach)),
    fixed_(grid, shared_, Ufield_),
    slip_(grid, shared_, Ufield_, fixed_.nodes()),
    rigid_(grid),
    UNew_(stride_ * grid.nNodes())
{
    if (Ufield_.dimensions() != dimVelocity)
    {
        FatalErrorInFunction << "Field " << Ufield_.objectPath() << " has the dimensions "
                             << Ufield_.dimensions() << "; they must be " << dimVelocity
                             << " (m/s)." << exit(FatalError);
    }
    checkBoundary();
    addConstraint(fixed_);
    addConstraint(slip_);
    addConstraint(rigid_);
    fixed_.update(0);

    if (Pstream::parRun())
    {
        share_.setSize(grid.nNodes(), 1);
        shared_.sum(share_.begin(), 1, 1);
        for (scalar& part : share_)
        {
            part = 1 / part;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::velocityField::clearForce()
{
    zero(f_);
    if (load_.data())
    {
        forComponents([&](const label i) { load_.data()[i] = 0; });
    }
}

void Foam::mpm::velocityField::constrain(
    scalar* u, const int stride, const bool homogeneous, const bool tentative) const
{
    for (const nodeConstraint* constraint : constraints_)
    {
        constraint->impose(u, stride, homogeneous, tentative);
    }
}

void Foam::mpm::velocityField::constrainStep(scalar* u, const bool homogeneous)
{
    const scalar* mU = mU_.data();
    if (reactions_)
    {
        reactions_->add(active_, -1, u, mU, stride_);
    }
    for (nodeConstraint* constraint : constraints_)
    {
        constraint->addImpulse(u, homogeneous, mU, stride_);
    }
    constrain(u, stride_, homogeneous, false);
    if (reactions_)
    {
        reactions_->add(active_, 1, u, mU, stride_);
    }
}

void Foam::mpm::velocityField::velocity()
{
    const scalar* __restrict__ mU = mUNew_.data();
    scalar* __restrict__ U = UNew_.data();

    for (const label n : activeNew_)
    {
        const scalar m = mU[stride_ * n + nDim_];
        const scalar rm = m > 0 ? 1 / m : 0;
        for (int d = 0; d < nDim_; ++d)
        {
            U[stride_ * n + d] = rm * mU[stride_ * n + d];
        }
    }
    rigid_.fill(mU, stride_);
    rigid_.combine(U, mU, stride_);
    constrain(U, stride_, false, true);
}

void Foam::mpm::velocityField::momentumStep(const scalar dt, const vector& g, const bool turn)
{
    const scalar* __restrict__ mU = mU_.data();
    const scalar* __restrict__ U = U_.data();
    const scalar* __restrict__ f = f_.data();
    scalar* __restrict__ UL = UL_.data();
    scalar* __restrict__ dU = dU_.data();

    scalar gd[3] = {0, 0, 0};
    for (int d = 0; d < nDim_; ++d)
    {
        gd[d] = g[grid_.direction(d)];
    }

    forNumber(
        nDim_,
        [&](const auto D)
        {
            for (const label n : active_)
            {
                const scalar m = mU[stride_ * n + D];
                const scalar dtm = m > 0 ? dt / m : 0;
                for (int d = 0; d < D; ++d)
                {
                    const label i = stride_ * n + d;
                    UL[i] = m > 0 ? U[i] + dtm * f[i] + dt * gd[d] : 0;
                }
            }
        });
    if (reactions_)
    {
        reactions_->start(dt, active_, shared_);
    }
    rigid_.begin(dt, g);
    rigid_.take(UL, mU, stride_);
    constrainStep(UL, false);
    rigid_.addTractionImpulse(dt);

    forComponents([&](const label i) { dU[i] = UL[i] - U[i]; });
    turning_.clear();
    if (turn && slip_.turns())
    {
        turnWithWalls();
    }
}

Foam::labelList Foam::mpm::velocityField::constrained() const
{
    labelHashSet nodes;
    for (const nodeConstraint* constraint : constraints_)
    {
        constraint->mark(nodes);
    }
    // Other nodes hold values of an earlier step
    DynamicList<label> active(nodes.size());
    for (const label n : nodes.size() ? active_ : labelList::null())
    {
        if (nodes.found(n))
        {
            active.append(n);
        }
    }
    Foam::sort(active);
    return labelList(std::move(active));
}

Foam::scalar Foam::mpm::velocityField::boundaryWork(const scalar dt, const vector& g) const
{
    scalar w = 0;
    const labelHashSet turning(turning_);
    const auto add = [&](const label n)
    {
        const scalar m = mU_.data()[stride_ * n + nDim_];
        const scalar part = share_.size() ? share_[n] : 1;
        for (int d = 0; m > 0 && d < nDim_; ++d)
        {
            const scalar du = dU_.data()[stride_ * n + d];
            const scalar J =
                m * (du - dt * g[grid_.direction(d)]) - dt * f_.data()[stride_ * n + d];
            const scalar u =
                turning.found(n) ? mU_.data()[stride_ * n + d] / m : U_.data()[stride_ * n + d];
            w += part * J * (u + 0.5 * du);
        }
    };
    for (const label n : constrained())
    {
        add(n);
    }

    return w + rigid_.tractionWork(dt, U_.data(), dU_.data(), stride_);
}

Foam::scalar Foam::mpm::velocityField::addImpulse(
    const scalar* impulse, const bool withWork, const bool bodiesKnow)
{
    const scalar* mU = mU_.data();
    scalar* UL = UL_.data();
    scalar* dU = dU_.data();
    forMasses(
        mU,
        [&](const label i, const scalar rm)
        {
            // du gets the change that is left after boundary conditions
            dU[i] -= UL[i];
            UL[i] += rm * impulse[i];
        });

    // Impulse J = m (u* - u) of the conditions, at the mean velocity
    const labelList nodes(withWork ? constrained() : labelList());
    scalar work = 0;
    scalarList free(nDim_ * nodes.size());
    forAll(nodes, i)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            free[nDim_ * i + d] = UL[stride_ * nodes[i] + d];
        }
    }
    if (!bodiesKnow)
    {
        rigid_.take(UL, mU, stride_);
    }
    constrainStep(UL, false);
    forAll(nodes, i)
    {
        const label n = nodes[i];
        const scalar m = (share_.size() ? share_[n] : 1) * mU[stride_ * n + nDim_];
        for (int d = 0; m > 0 && d < nDim_; ++d)
        {
            const scalar u = UL[stride_ * n + d];
            work += m * (u - free[nDim_ * i + d]) * 0.5 * (U_.data()[stride_ * n + d] + u);
        }
    }
    forComponents([&](const label i) { dU[i] += UL[i]; });
    return work;
}

void Foam::mpm::velocityField::accept()
{
    active_.transfer(activeNew_);
    rigid_.accept();
    if (reactions_)
    {
        reactions_->accept();
    }
    mU_.swap(mUNew_);
    U_.swap(UNew_);
}

void Foam::mpm::velocityField::replace()
{
    active_.transfer(activeNew_);
    rigid_.takeNew();
    mU_.swap(mUNew_);
    U_.swap(UNew_);
}

Foam::scalar Foam::mpm::velocityField::maxStrain(const labelList& cells, const scalar dt) const
{
    scalar largest = 0;
    forDimension(nDim_, [&](const auto D) { largest = largestSlope<decltype(D)::value>(cells); });
    return dt * largest;
}

template<int DIM>
Foam::scalar Foam::mpm::velocityField::largestSlope(const labelList& cells) const
{
    constexpr int P = nodeStride<DIM>;
    typedef lanes<P> T;
    const scalar* mU = mUNew_.data();
    const scalar* U = UNew_.data();

    // The other lanes of a node are no components
    laneMask<P> held = {};
    for (int e = 0; e < DIM; ++e)
    {
        held[e] = -1;
    }
    const auto raise = [&](const label a, const label b, T& most) __attribute__((always_inline))
    {
        if (mU[P * a + DIM] > 0 && mU[P * b + DIM] > 0)
        {
            most = laneMax(most, laneAbs(mpm::load<P>(U + P * b) - mpm::load<P>(U + P * a)));
        }
    };
    const auto largestOf = [&](const T& most) { return horizontalMax(select(held, most, T{})); };

    scalar largest = 0;
    if (grid_.hasHexes())
    {
        const hexCells& hexes = grid_.hexes();
        for (const label celli : cells)
        {
            const label* corners = hexes.corners(celli);
            for (int d = 0; d < DIM; ++d)
            {
                T most = {};
                for (int n = 0; n < (1 << DIM); ++n)
                {
                    if (!((n >> d) & 1))
                    {
                        raise(corners[n], corners[n | (1 << d)], most);
                    }
                }
                largest = max(largest, largestOf(most) * grid_.inverseWidth(celli, d));
            }
        }
        return largest;
    }
    for (const label celli : cells)
    {
        // All nodes of a simplex are joined by edges
        const SubList<label> nodes(grid_.nodesOf(celli));
        T most = {};
        if (DIM > 1 && nodes.size() == DIM + 1)
        {
            for (int i = 1; i <= DIM; ++i)
            {
                for (int j = 0; j < i; ++j)
                {
                    raise(nodes[j], nodes[i], most);
                }
            }
        }
        else
        {
            for (const label edgei : grid_.mesh().cellEdges()[celli])
            {
                const edge& e = grid_.mesh().edges()[edgei];
                raise(grid_.pointToNode()[e.first()], grid_.pointToNode()[e.second()], most);
            }
        }
        largest = max(largest, largestOf(most) / grid_.shortestSide(celli));
    }
    return largest;
}

void Foam::mpm::velocityField::needReactions()
{
    if (!reactions_)
    {
        DynamicList<nodeReactions::part> parts(fixed_.parts());
        parts.append(slip_.parts());
        reactions_.reset(new nodeReactions(grid_, parts, shared_));
    }
}

void Foam::mpm::velocityField::addProjected(const scalar share)
{
    const auto add = [&](const labelUList& nodes, const scalar part)
    { reactions_->addProjected(nodes, part, U_.data(), mU_.data(), stride_); };
    if (reactions_ && share > 0)
    {
        add(active_, share);
    }
    if (reactions_)
    {
        // All of it where the wall turns the points
        add(turning_, 1 - share);
    }
}

void Foam::mpm::velocityField::turnToSide(const label pointi, vector& u) const
{
    const int r = grid_.direction(grid_.radial());
    const int across = 3 - r - grid_.direction(1 - grid_.radial());
    const point& x = grid_.mesh().points()[pointi];
    const scalar radius = std::hypot(x[r], x[across]);
    if (radius > 0)
    {
        const scalar ur = u[r];
        u[r] = ur * x[r] / radius;
        u[across] = ur * x[across] / radius;
    }
}

void Foam::mpm::velocityField::writeField()
{
    vectorField& U = Ufield_.primitiveFieldRef();
    U = Zero;
    labelList isActive(grid_.nNodes(), label(0));
    for (const label n : active_)
    {
        isActive[n] = 1;
    }
    forAll(U, pointi)
    {
        const label n = grid_.pointToNode()[pointi];
        if (isActive[n])
        {
            for (int d = 0; d < nDim_; ++d)
            {
                U[pointi][grid_.direction(d)] = U_.data()[stride_ * n + d];
            }
            if (grid_.radial() >= 0)
            {
                turnToSide(pointi, U[pointi]);
            }
        }
    }
}

Foam::scalar Foam::mpm::velocityField::bytes() const
{
    return scalar(grid_.nNodes())
        * (sizeof(scalar) * stride_ * (7 + (increment_.data() ? 2 : 0) + (Ustrain_.data() ? 1 : 0))
           + sizeof(label))
        + sizeof(label)
        * scalar(active_.size() + activeNew_.size() + ringStart_.size() + ring_.size());
}
