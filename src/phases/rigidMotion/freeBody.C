// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "freeBody.H"
#include "dictionaryTools.H"
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
mpm::freeBody::vector6 sumOfAll(const mpm::freeBody::vector6& v)
{
    mpm::freeBody::vector6 sum(v);
    for (int part = 0; part < 6; part += 3)
    {
        const vector s(returnReduce(vector(v(part), v(part + 1), v(part + 2)), sumOp<vector>()));
        for (int d = 0; d < 3; ++d)
        {
            sum(part + d) = s[d];
        }
    }
    return sum;
}

vector part(const mpm::freeBody::vector6& v, const int from)
{
    return vector(v(from), v(from + 1), v(from + 2));
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

Foam::mpm::freeBody::matrix6 Foam::mpm::freeBody::massMatrix(const quaternion& q) const
{
    const symmTensor I(inertia(q));
    matrix6 B(matrix6::Zero());
    B.diagonal().head<3>().setConstant(mass_);
    B.block<3, 3>(3, 3) << I.xx(), I.xy(), I.xz(), I.xy(), I.yy(), I.yz(), I.xz(), I.yz(), I.zz();
    for (int i = 0; i < 6; ++i)
    {
        if (!free_[i])
        {
            B.row(i).setZero();
            B.col(i).setZero();
            B(i, i) = 1;
        }
    }
    return B;
}

Foam::mpm::freeBody::vector6 Foam::mpm::freeBody::masked(const vector6& v) const
{
    vector6 w(v);
    for (int i = 0; i < 6; ++i)
    {
        w(i) = free_[i] ? v(i) : 0;
    }
    return w;
}

Foam::vector Foam::mpm::freeBody::spin(const quaternion& q, const vector& L) const
{
    vector6 momentum(vector6::Zero());
    momentum.tail<3>() << L.x(), L.y(), L.z();
    return part(massMatrix(q).ldlt().solve(masked(momentum)), 3);
}

Foam::mpm::freeBody::vector6 Foam::mpm::freeBody::velocityOf(const state6& s) const
{
    const vector w(spin(s.q, s.L));
    vector6 V;
    V << s.V.x(), s.V.y(), s.V.z(), w.x(), w.y(), w.z();
    return V;
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
    start_(vector6::Zero()),
    startNew_(vector6::Zero()),
    step_(vector6::Zero()),
    combined_(matrix6::Identity()),
    combinedNew_(matrix6::Identity()),
    shares_(false),
    sharesNew_(false),
    push_(vector6::Zero()),
    load_(vector6::Zero()),
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
            Eigen::Matrix3d I;
            I << givenInertia_.xx(), givenInertia_.xy(), givenInertia_.xz(), givenInertia_.xy(),
                givenInertia_.yy(), givenInertia_.yz(), givenInertia_.xz(), givenInertia_.yz(),
                givenInertia_.zz();
            const Eigen::Vector3d e(
                Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(I).eigenvalues());
            if (!(e(0) > 0) || e(2) > 1.0000001 * (e(0) + e(1)))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry inertia is " << givenInertia_ << " with the"
                    << " principal values " << e(0) << ' ' << e(1) << ' ' << e(2)
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

Foam::mpm::freeBody::matrix36 Foam::mpm::freeBody::at(const point& x, const bool tentative) const
{
    const vector r(x - centre(tentative));
    matrix36 G(matrix36::Zero());
    G(0, 0) = G(1, 1) = G(2, 2) = 1;
    G.block<3, 3>(0, 3) << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
    for (int i = 0; i < 6; ++i)
    {
        if (!free_[i])
        {
            G.col(i).setZero();
        }
    }
    return G;
}

void Foam::mpm::freeBody::combine(const matrix6& A, const vector6& rhs)
{
    sharesNew_ = A.diagonal().maxCoeff() > 0;
    combinedNew_ = massMatrix(new_.q) + A;
    startNew_ = velocityOf(new_);
    if (sharesNew_)
    {
        startNew_ += masked(combinedNew_.ldlt().solve(rhs));
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
    step_ = start_;
    step_.head<3>() +=
        vector6((vector6() << gravity_.x(), gravity_.y(), gravity_.z(), 0, 0, 0).finished())
            .head<3>();
    step_ += massMatrix(now_.q).ldlt().solve(masked(dt * sumOfAll(push_)));
    step_ = masked(step_);
    load_.setZero();
}

Foam::mpm::freeBody::vector6 Foam::mpm::freeBody::response(const vector6& impulse) const
{
    return masked(combined_.ldlt().solve(masked(impulse)));
}

void Foam::mpm::freeBody::setPush(const vector& force, const vector& torque)
{
    push_ << force.x(), force.y(), force.z(), torque.x(), torque.y(), torque.z();
}

void Foam::mpm::freeBody::addLoad(const vector& impulse, const point& x)
{
    const vector T((x - centre(false)) ^ impulse);
    load_ += (vector6() << impulse.x(), impulse.y(), impulse.z(), T.x(), T.y(), T.z()).finished();
}

void Foam::mpm::freeBody::finish(const scalar dt, const scalar a)
{
    const matrix6 B(massMatrix(now_.q));
    step_ += B.ldlt().solve(masked(sumOfAll(load_)));

    const vector6 V(velocityOf(now_));
    const vector6 dV(step_ - start_);
    const vector6 mean(V + 0.5 * dV);
    work_ = mean.dot(B * dV);
    gravityWork_ = 0;
    for (int d = 0; d < 3; ++d)
    {
        gravityWork_ += free_[d] ? mass_ * gravity_[d] * mean(d) : 0;
    }

    const vector6 change(a * (start_ - V) + dV);
    const vector6 momentum(B * change);
    const vector6 meanNodes(0.5 * (start_ + step_));
    new_.shift = now_.shift + dt * part(meanNodes, 0);
    new_.V = now_.V + part(change, 0);
    new_.L = now_.L + part(momentum, 3);

    // Midpoint, with the angular momentum of the mean
    const vector L(part(B * meanNodes, 3));
    vector w(part(meanNodes, 3));
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
