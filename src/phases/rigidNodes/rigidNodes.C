/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "rigidNodes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::rigidNodes::setVelocity
(
    const label phasei,
    const rigidMotion& motion,
    nodeSet& set
)
{
    const int D = grid_.nDim();
    set.value.resize(D*set.node.size());
    forAll(set.node, i)
    {
        if (set.phase[i] == phasei)
        {
            const vector u
            (
                motion.now().velocityAt(position_[set.node[i]])
            );
            for (int d = 0; d < D; ++d)
            {
                set.value[D*i + d] = u[grid_.direction(d)];
            }
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::rigidNodes::rigidNodes(const hexGrid& grid)
:
    grid_(grid)
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::rigidNodes::setPhases(const label n)
{
    step_.setSize(n, vector(Zero));
    sum_.setSize(n, vector(Zero));
}


Foam::scalar* Foam::mpm::rigidNodes::clearMass
(
    const labelList& active,
    const int stride
)
{
    if (!mass_.data())
    {
        mass_ = alignedArray(stride*grid_.nNodes());
        position_ = grid_.nodePositions();
    }
    for (const label n : active)
    {
        for (int c = 0; c < stride; ++c)
        {
            mass_.data()[stride*n + c] = 0;
        }
    }
    return mass_.data();
}


void Foam::mpm::rigidNodes::clear()
{
    next_.node.clear();
    next_.phase.clear();
    next_.value.clear();
    next_.part.clear();
}


void Foam::mpm::rigidNodes::add
(
    const label phasei,
    const rigidMotion& motion,
    const scalar largest,
    const labelList& active,
    const int stride
)
{
    // Nodes that an earlier phase of the list has are marked by a negative
    // mass
    for (const label n : next_.node)
    {
        mass_.data()[stride*n + grid_.nDim()] = -1;
    }
    for (const label n : active)
    {
        if (mass_.data()[stride*n + grid_.nDim()] > 1e-9*largest)
        {
            next_.node.append(n);
            next_.phase.append(phasei);
        }
    }
    setVelocity(phasei, motion, next_);
}


Foam::scalar* Foam::mpm::rigidNodes::marks
(
    const labelList& active,
    const int stride
)
{
    scalar* marks = clearMass(active, stride);
    for (const label n : next_.node)
    {
        marks[stride*n] = 1;
    }
    return marks;
}


void Foam::mpm::rigidNodes::setParts(const scalar* marks, const int stride)
{
    next_.part.resize(next_.node.size());
    forAll(next_.node, i)
    {
        next_.part[i] = 1/marks[stride*next_.node[i]];
    }
}


void Foam::mpm::rigidNodes::newVelocity
(
    const label phasei,
    const rigidMotion& motion
)
{
    setVelocity(phasei, motion, now_);
}


void Foam::mpm::rigidNodes::impose
(
    scalar* u,
    const int stride,
    const bool homogeneous,
    const bool tentative
) const
{
    const nodeSet& set = tentative ? next_ : now_;
    const int D = grid_.nDim();
    forAll(set.node, i)
    {
        for (int d = 0; d < D; ++d)
        {
            u[stride*set.node[i] + d] = homogeneous ? 0 : set.value[D*i + d];
        }
    }
}


void Foam::mpm::rigidNodes::addImpulse
(
    const scalar* u,
    const int stride,
    const bool homogeneous,
    const scalar* mU,
    const int massStride
)
{
    const int D = grid_.nDim();
    forAll(now_.node, i)
    {
        const label n = now_.node[i];
        const scalar m = now_.part[i]*mU[massStride*n + D];
        for (int d = 0; d < D; ++d)
        {
            step_[now_.phase[i]][grid_.direction(d)] +=
                m*(u[stride*n + d] - (homogeneous ? 0 : now_.value[D*i + d]));
        }
    }
}


void Foam::mpm::rigidNodes::addProjectionImpulse
(
    const scalar a,
    const scalar* U,
    const scalar* mU,
    const int stride
)
{
    const int D = grid_.nDim();
    forAll(now_.node, i)
    {
        const label n = now_.node[i];
        for (int d = 0; d < D; ++d)
        {
            step_[now_.phase[i]][grid_.direction(d)] +=
                a*now_.part[i]
               *(mU[stride*n + d] - mU[stride*n + D]*U[stride*n + d]);
        }
    }
}


void Foam::mpm::rigidNodes::addImpulse
(
    const scalar* J,
    const scalar* mU,
    const int stride
)
{
    const int D = grid_.nDim();
    forAll(now_.node, i)
    {
        for (int d = 0; d < D && !(mU[stride*now_.node[i] + D] > 0); ++d)
        {
            step_[now_.phase[i]][grid_.direction(d)] +=
                now_.part[i]*J[stride*now_.node[i] + d];
        }
    }
}


void Foam::mpm::rigidNodes::newTime()
{
    step_ = Zero;
}


void Foam::mpm::rigidNodes::takeNew()
{
    now_.node.swap(next_.node);
    now_.phase.swap(next_.phase);
    now_.value.swap(next_.value);
    now_.part.swap(next_.part);
}


void Foam::mpm::rigidNodes::accept()
{
    takeNew();
    forAll(step_, phasei)
    {
        sum_[phasei] += step_[phasei];
    }
}


Foam::vector Foam::mpm::rigidNodes::stepImpulse(const label phasei) const
{
    return returnReduce(step_[phasei], sumOp<vector>());
}


Foam::vector Foam::mpm::rigidNodes::impulse(const label phasei) const
{
    return returnReduce(sum_[phasei], sumOp<vector>());
}


void Foam::mpm::rigidNodes::setImpulse
(
    const label phasei,
    const vector& impulse
)
{
    sum_[phasei] = Pstream::master() ? impulse : vector(Zero);
}

// ************************************************************************* //
