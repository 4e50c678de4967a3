// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "freeBody.H"
#include "dictionaryTools.H"
#include "principalAxes.H"
#include "cyclicPolyPatch.H"
#include "transform.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(freeBody, 0);
addToRunTimeSelectionTable(rigidMotion, freeBody, dictionary);
}

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sum of six numbers over processors
mpm::vector6 sumOfAll(const mpm::vector6& v)
{
    return mpm::vector6(
        returnReduce(v.linear(), sumOp<vector>()), returnReduce(v.angular(), sumOp<vector>()));
}

mpm::matrix6 unity()
{
    mpm::matrix6 I(Zero);
    for (int i = 0; i < 6; ++i)
    {
        I(i, i) = 1;
    }
    return I;
}

//- exp(w): rotation by |w| about w
quaternion turn(const vector& w)
{
    const scalar angle = mag(w);
    const scalar half = 0.5 * angle;
    return quaternion(std::cos(half), (angle > 1e-8 ? std::sin(half) / angle : 0.5) * w);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::freeBody::readConstraints(const dictionary& dict)
{
    const bool wedge = grid_.radial() >= 0;
    const int D = grid_.nDim();
    std::fill(free_, free_ + 6, false);
    for (int d = 0; d < D; ++d)
    {
        free_[grid_.direction(d)] = !wedge || d != grid_.radial();
    }
    if (D == 3)
    {
        free_[3] = free_[4] = free_[5] = true;
    }
    else if (D == 2 && !wedge)
    {
        free_[6 - grid_.direction(0) - grid_.direction(1)] = true;
    }

    const wordList held(dict.getOrDefault<wordList>("constraints", wordList()));
    const wordList valid({"x", "y", "z", "rotationX", "rotationY", "rotationZ", "rotation"});
    for (const word& w : held)
    {
        const label i = valid.find(w);
        if (i < 0)
        {
            FatalIOErrorInFunction(dict) << "Unknown word " << w << " in constraints." << nl
                                         << "Valid words: " << valid << exit(FatalIOError);
        }
        for (label j = min(i, label(3)); j < 6; ++j)
        {
            if (i == 6 ? j >= 3 : j == i)
            {
                free_[j] = false;
            }
        }
    }
    bool turns = false, cyclic = false;
    for (int d = 0; d < 3; ++d)
    {
        turns = turns || free_[3 + d];
    }
    for (const polyPatch& pp : grid_.mesh().boundaryMesh())
    {
        cyclic = cyclic || isA<cyclicPolyPatch>(pp);
    }
    if (turns && cyclic)
    {
        FatalIOErrorInFunction(dict) << "On a mesh with cyclic sides a free body cannot turn: add"
                                     << "  constraints (rotation);" << exit(FatalIOError);
    }
    const vector* values[2] = {&velocity0_, &angularVelocity0_};
    const char* names[2] = {"velocity", "angularVelocity"};
    for (int i = 0; i < 6; ++i)
    {
        if (!free_[i] && (*values[i / 3])[i % 3] != 0)
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << names[i / 3] << " is " << *values[i / 3] << "; its component "
                << "xyz"[i % 3] << " must be 0, for it"
                << " is held by constraints or not computed (empty or wedge"
                << " patches)." << exit(FatalIOError);
        }
    }
}

void Foam::mpm::freeBody::measure(const materialPointCloud& cloud)
{
    const int D = grid_.nDim();
    scalar m = 0;
    vector mx(Zero);
    const auto place = [&](const label p)
    {
        vector x(Zero);
        for (int d = 0; d < D; ++d)
        {
            x[grid_.direction(d)] = cloud.x()[d][p];
        }
        return x;
    };
    for (label p = 0; p < cloud.size(); ++p)
    {
        m += cloud.mass()[0][p];
        mx += cloud.mass()[0][p] * place(p);
    }
    reduce(m, sumOp<scalar>());
    reduce(mx, sumOp<vector>());
    const point centre(mx / m);

    // Inertia of the points taken as boxes
    symmTensor I(Zero);
    forAll(cloud.cells(), k)
    {
        const label celli = cloud.cells()[k];
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            const vector r(place(p) - centre);
            vector square(cmptMultiply(r, r));
            for (int d = 0; d < D; ++d)
            {
                const scalar half = cloud.halfSize() ? (*cloud.halfSize())[d][p]
                                                     : 0.5 * grid_.width(celli, d)
                        * std::pow(cloud.volume()[0][p] / grid_.mesh().cellVolumes()[celli],
                                   1.0 / D);
                square[grid_.direction(d)] += sqr(half) / 3;
            }
            I += cloud.mass()[0][p]
                * symmTensor(
                     square.y() + square.z(), -r.x() * r.y(), -r.x() * r.z(),
                     square.x() + square.z(), -r.y() * r.z(), square.x() + square.y());
        }
    }
    reduce(I, sumOp<symmTensor>());

    mass_ = givenMass_ > 0 ? givenMass_ : m;
    inertia0_ = mag(givenInertia_) > 0 ? givenInertia_ : (mass_ / m) * I;
    placement_.origin = centre;
}

Foam::symmTensor Foam::mpm::freeBody::inertia(const quaternion& q) const
{
    return transform(q.R(), inertia0_);
}

Foam::mpm::matrix6 Foam::mpm::freeBody::massMatrix(const quaternion& q) const
{
    const symmTensor I(inertia(q));
    const tensor full(I);
    matrix6 B(Zero);
    for (int i = 0; i < 3; ++i)
    {
        B(i, i) = free_[i] ? mass_ : 1;
        for (int j = 0; j < 3; ++j)
        {
            B(3 + i, 3 + j) = free_[3 + i] && free_[3 + j] ? full(i, j) : scalar(i == j);
        }
    }
    return B;
}

Foam::mpm::vector6 Foam::mpm::freeBody::masked(const vector6& v) const
{
    vector6 w(v);
    for (int i = 0; i < 6; ++i)
    {
        w[i] = free_[i] ? v[i] : 0;
    }
    return w;
}

Foam::vector Foam::mpm::freeBody::spin(const quaternion& q, const vector& L) const
{
    return massMatrix(q).solve(masked(vector6(Zero, L))).angular();
}

Foam::mpm::vector6 Foam::mpm::freeBody::velocityOf(const state6& s) const
{
    return vector6(s.V, spin(s.q, s.L));
}

void Foam::mpm::freeBody::setPlacement(const state6& s)
{
    placement_.R = s.q.R();
    placement_.shift = s.shift;
    placement_.velocity = s.V;
    placement_.spin = spin(s.q, s.L);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::freeBody::freeBody(const dictionary& dict, const pointGrid& grid) :
    rigidMotion(grid),
    velocity0_(dict.getOrDefault<vector>("velocity", Zero)),
    angularVelocity0_(dict.getOrDefault<vector>("angularVelocity", Zero)),
    givenMass_(dict.found("mass") ? positive(dict, "mass") : 0),
    givenInertia_(Zero),
    mass_(0),
    inertia0_(Zero),
    start_(Zero),
    startNew_(Zero),
    step_(Zero),
    combined_(unity()),
    combinedNew_(unity()),
    shares_(false),
    sharesNew_(false),
    push_(Zero),
    load_(Zero),
    gravity_(Zero),
    work_(0),
    gravityWork_(0)
{
    checkKeywords(dict, {"type", "velocity", "angularVelocity", "mass", "inertia", "constraints"});
    readConstraints(dict);
    if (dict.found("inertia"))
    {
        if (grid.nDim() == 3)
        {
            givenInertia_ = dict.get<symmTensor>("inertia");
            const tensor I(givenInertia_);
            const principalAxes<3> axes(I.cdata(), false);
            const scalar* e = axes.value;
            if (!(e[0] > 0) || e[2] > 1.0000001 * (e[0] + e[1]))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry inertia is " << givenInertia_ << " with the"
                    << " principal values " << e[0] << ' ' << e[1] << ' ' << e[2]
                    << "; they must be greater than 0, and none"
                    << " greater than the sum of the others." << exit(FatalIOError);
            }
        }
        else
        {
            const scalar I = positive(dict, "inertia");
            givenInertia_ = symmTensor(I, 0, 0, I, 0, I);
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::freeBody::start(const scalar, const materialPointCloud& cloud)
{
    measure(cloud);
    now_.shift = Zero;
    now_.V = velocity0_;
    now_.q = quaternion::I;
    now_.L = inertia0_ & angularVelocity0_;
    for (int d = 0; d < 3; ++d)
    {
        now_.L[d] = free_[3 + d] ? now_.L[d] : 0;
    }
    new_ = now_;
    setPlacement(now_);
}

Foam::dictionary Foam::mpm::freeBody::state() const
{
    dictionary state;
    state.add("mass", mass_);
    state.add("centre", placement_.origin);
    state.add("inertia", inertia0_);
    state.add("displacement", now_.shift);
    state.add("velocity", now_.V);
    state.add("turnAngle", now_.q.w());
    state.add("turnAxis", now_.q.v());
    state.add("angularMomentum", now_.L);
    return state;
}

void Foam::mpm::freeBody::setState(const scalar, const dictionary& state)
{
    mass_ = required<scalar>(state, "mass");
    placement_.origin = required<point>(state, "centre");
    inertia0_ = required<symmTensor>(state, "inertia");
    now_.shift = required<vector>(state, "displacement");
    now_.V = required<vector>(state, "velocity");
    now_.q = quaternion(required<scalar>(state, "turnAngle"), required<vector>(state, "turnAxis"));
    now_.L = required<vector>(state, "angularMomentum");
    if (givenMass_ > 0 && mag(givenMass_ - mass_) > 1e-12 * mass_)
    {
        FatalErrorInFunction << "A free body of mass " << mass_ << " kg restarts with mass "
                             << givenMass_ << " in constant/phaseProperties." << nl
                             << "Mass and inertia of a body stay those of its start."
                             << exit(FatalError);
    }
    // The constraints may have changed since the time was written
    bool turns = false;
    for (int d = 0; d < 3; ++d)
    {
        now_.V[d] = free_[d] ? now_.V[d] : 0;
        turns = turns || free_[3 + d];
    }
    if (!turns)
    {
        now_.L = Zero;
    }
    new_ = now_;
    setPlacement(now_);
}

Foam::mpm::matrix36 Foam::mpm::freeBody::at(const point& x, const bool tentative) const
{
    const vector r(x - centre(tentative));
    matrix36 G;
    for (int d = 0; d < 3; ++d)
    {
        vector e(Zero);
        e[d] = 1;
        G[d] = free_[d] ? e : vector(Zero);
        G[3 + d] = free_[3 + d] ? e ^ r : vector(Zero);
    }
    return G;
}

void Foam::mpm::freeBody::combine(const matrix6& A, const vector6& rhs)
{
    sharesNew_ = false;
    for (int i = 0; i < 6; ++i)
    {
        sharesNew_ = sharesNew_ || A(i, i) > 0;
    }
    combinedNew_ = massMatrix(new_.q) + A;
    startNew_ = velocityOf(new_);
    if (sharesNew_)
    {
        startNew_ += masked(combinedNew_.solve(rhs));
    }
}

void Foam::mpm::freeBody::acceptNodes()
{
    start_ = startNew_;
    combined_ = combinedNew_;
    shares_ = sharesNew_;
}

void Foam::mpm::freeBody::begin(const scalar dt, const vector& g)
{
    gravity_ = dt * g;
    step_ =
        start_ + vector6(gravity_, Zero) + massMatrix(now_.q).solve(masked(dt * sumOfAll(push_)));
    step_ = masked(step_);
    load_ = Zero;
}

Foam::mpm::vector6 Foam::mpm::freeBody::response(const vector6& impulse) const
{
    return masked(combined_.solve(masked(impulse)));
}

void Foam::mpm::freeBody::setPush(const vector& force, const vector& torque)
{
    push_ = vector6(force, torque);
}

void Foam::mpm::freeBody::addLoad(const vector& impulse, const point& x)
{
    load_ += vector6(impulse, (x - centre(false)) ^ impulse);
}

void Foam::mpm::freeBody::finish(const scalar dt, const scalar a)
{
    const matrix6 B(massMatrix(now_.q));
    step_ += B.solve(masked(sumOfAll(load_)));

    const vector6 V(velocityOf(now_));
    const vector6 dV(step_ - start_);
    const vector6 mean(V + 0.5 * dV);
    work_ = mean && (B * dV);
    gravityWork_ = 0;
    for (int d = 0; d < 3; ++d)
    {
        gravityWork_ += free_[d] ? mass_ * gravity_[d] * mean[d] : 0;
    }

    const vector6 change(a * (start_ - V) + dV);
    const vector6 momentum(B * change);
    const vector6 meanNodes(0.5 * (start_ + step_));
    new_.shift = now_.shift + dt * meanNodes.linear();
    new_.V = now_.V + change.linear();
    new_.L = now_.L + momentum.angular();

    // Midpoint, with the angular momentum of the mean
    const vector L((B * meanNodes).angular());
    vector w(meanNodes.angular());
    for (int i = 0; i < 50 && grid_.nDim() == 3; ++i)
    {
        quaternion half(turn(0.5 * dt * w) * now_.q);
        half.normalize();
        const vector wNew(spin(half, L));
        const scalar moved = mag(wNew - w);
        w = wNew;
        if (moved <= 1e-15 * mag(w))
        {
            break;
        }
    }
    new_.q = turn(dt * w) * now_.q;
    new_.q.normalize();
    setPlacement(new_);
}

Foam::vector Foam::mpm::freeBody::angularMomentum(const point& origin) const
{
    vector arm(Zero);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        const int c = grid_.direction(d);
        arm[c] = (centre(false) - origin)[c];
    }
    return now_.L + (arm ^ momentum());
}

Foam::scalar Foam::mpm::freeBody::kineticEnergy() const
{
    return 0.5 * (mass_ * magSqr(now_.V) + (now_.L & spin(now_.q, now_.L)));
}
