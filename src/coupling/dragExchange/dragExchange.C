// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "dragExchange.H"
#include "pointEnergy.H"
#include "dictionaryTools.H"
#include "lanes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam::mpm
{

//- A node's components, and what follows them up to four
static inline lanes<4> ofNode(const scalar* u, const int stride, const label node)
{
    if (stride == 4)
    {
        return load<4>(u + 4 * node);
    }
    lanes<4> q = {};
    for (int d = 0; d < min(stride, 4); ++d)
    {
        q[d] = u[stride * node + d];
    }
    return q;
}

} // End namespace Foam::mpm

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::dragExchange::read(const label phasei, const dictionary& dict)
{
    dictionary stick;
    stick.add("type", "stick");
    models_.set(phasei, dragModel::New(dict.found("drag") ? requiredDict(dict, "drag") : stick));
    normalOnly_ = normalOnly_ || models_[phasei].normalOnly();
    sticks_ = sticks_ || models_[phasei].sticks();
    if (models_[phasei].needsViscosity() && !(mu_ > 0))
    {
        FatalIOErrorInFunction(dict) << "The drag of " << points_.phases()[phasei].name()
                                     << " needs the viscosity of the gas: add mu [Pa s] to phase "
                                     << gas_.name() << "." << exit(FatalIOError);
    }
}

Foam::mpm::solidOnFaces::faceDrag Foam::mpm::dragExchange::readForm(const dictionary& dict) const
{
    const wordList words({"none", "velocity", "impedance"});
    const word form(oneOfOrDefault(dict, "faceDrag", normalOnly_ ? "none" : "impedance", words));
    return solidOnFaces::faceDrag(words.find(form));
}

void Foam::mpm::dragExchange::findBetween()
{
    const PtrList<velocityField>& fields = points_.fields();
    between_ = false;
    if (!sticks_ || fields.size() < 2)
    {
        return;
    }

    // Largest number of a field at a node, and of its negative
    fieldAt_.setSize(2 * points_.grid().nNodes(), -GREAT);
    for (const label n : marked_)
    {
        fieldAt_[2 * n] = fieldAt_[2 * n + 1] = -GREAT;
    }
    marked_.clear();
    const int D = points_.grid().nDim();
    forAll(fields, fieldi)
    {
        const scalar* mU = fields[fieldi].momentum();
        const int stride = fields[fieldi].stride();
        for (const label n : fields[fieldi].active())
        {
            if (mU[stride * n + D] > 0)
            {
                fieldAt_[2 * n] = max(fieldAt_[2 * n], scalar(fieldi));
                fieldAt_[2 * n + 1] = max(fieldAt_[2 * n + 1], scalar(-fieldi));
                marked_.append(n);
                between_ = between_ || isShared(n);
            }
        }
    }

    // Shared nodes of processors are active, and have the mass of all
    reduce(between_, orOp<bool>());
}

bool Foam::mpm::dragExchange::isBetween(const label celli) const
{
    for (const label n : points_.grid().nodesOf(celli))
    {
        if (isShared(n))
        {
            return true;
        }
    }
    return false;
}

Foam::vector Foam::mpm::dragExchange::impulse(
    const label phasei, const label celli, const scalar M, const vector& Us, const scalar thetaS,
    const vector& A, const scalar dt)
{
    const dragModel& model = models_[phasei];
    const scalar rho = gas_.rho()[celli];
    vector given(J_[celli]);
    if (before_ > 0)
    {
        given += Jbefore_[celli];
    }
    const vector ug((gas_.rhoU()[celli] + given) / rho);
    vector seen(Us - ug), relative(seen);
    seen -= ahead_[celli] / rho;
    relative -= (before_ + dt) / rho * fraction_.gasPush()[celli];
    if (before_ > 0)
    {
        seen -= aheadBefore_[celli] / rho;
    }

    const scalar solid = fraction_.theta()[celli];
    const bool gap = between_ && model.sticks() && isBetween(celli);
    if ((model.normalOnly() || gap) && solid <= fraction_.fullForNormal())
    {
        const vector& n = fraction_.normals()[celli];
        if (magSqr(n) > 0)
        {
            relative = n * (n & relative);
            seen = n * (n & seen);
        }
    }

    // The pores of a full cell are there for the gas' equations alone
    const bool full = model.none() && solid > fraction_.fullOfSolid();
    scalar K = 0;
    const bool surface = magSqr(A) > 0;
    if (surface)
    {
        const vector n(A / mag(A));
        relative = n * (n & relative);
        seen = n * (n & seen);
        const eulerianFlow::waveState wave(gas_.wave(celli));
        K = wave.surface * std::sqrt(wave.K * rho / gas_.theta()[celli]) * mag(A)
            / fraction_.mesh().V()[celli];
    }
    else
    {
        K = full ? dragModel::sticking : coefficient(phasei, celli, thetaS, mag(seen));
    }
    if (!(K > 0))
    {
        return Zero;
    }
    if (!(Kc_[celli] > 0))
    {
        cells_.append(celli);
    }

    // Of a surface and in a gap no drag of the faces, but the cell has some
    Kc_[celli] += surface || gap ? VSMALL : K;

    // Harmonic masses; a rigid phase has no end of it: a free body takes
    // the impulse at the end of the step
    const scalar shared = M < GREAT ? rho * M / (rho + M) : rho;
    const scalar a = dt * K / shared;
    const vector J(a / (1 + a) * shared * relative);
    ahead_[celli] += a / (1 + a) * shared * (seen - relative);
    held_[celli] += surface || gap ? 0 : rho * M * a / (rho * (1 + a) + M);

    J_[celli] += J;
    Q_[celli] += J & (M < GREAT ? Us - 0.5 * J / M : Us);

    return J;
}

Foam::vector Foam::mpm::dragExchange::momentumOf(
    const labelUList& nodes, const UList<scalar>& share, const scalar* U, const int stride,
    scalar& M) const
{
    const pointGrid& grid = points_.grid();
    M = 0;
    lanes<4> sum = {};
    forAll(nodes, i)
    {
        if (share[i] > 0)
        {
            M += share[i];
            sum += share[i] * ofNode(U, stride, nodes[i]);
        }
    }
    vector mU(Zero);
    for (int d = 0; d < grid.nDim(); ++d)
    {
        mU[grid.direction(d)] = sum[d];
    }
    return mU;
}

void Foam::mpm::dragExchange::startImpulse(const velocityField& field)
{
    const int stride = field.stride();
    impulse_.setSize(stride * points_.grid().nNodes());
    for (const label node : field.active())
    {
        std::fill_n(impulse_.begin() + stride * node, stride, 0.0);
    }
}

const Foam::scalar* Foam::mpm::dragExchange::atCells(const label phasei) const
{
    const velocityField& field = points_.fields()[points_.fieldOf(phasei)];
    return levels_ ? levels_->atShares(
               points_.phases()[phasei].cloud(), field.UL(), fraction_.nodesBeside(phasei))
                   : field.UL();
}

void Foam::mpm::dragExchange::take(
    const labelUList& nodes, const UList<scalar>& share, const int stride, const scalar V,
    const scalar M, const vector& J)
{
    const pointGrid& grid = points_.grid();
    const int D = grid.nDim();
    lanes<4> ofMass = {};
    for (int d = 0; d < D; ++d)
    {
        ofMass[d] = V / M * J[grid.direction(d)];
    }
    forAll(nodes, i)
    {
        if (share[i] > 0)
        {
            const lanes<4> left = ofNode(impulse_.cdata(), stride, nodes[i]) - share[i] * ofMass;
            scalar* to = impulse_.begin() + stride * nodes[i];
            if (stride == 4)
            {
                store<4>(to, left);
            }
            else
            {
                to[0] = left[0];
            }
        }
    }
}

void Foam::mpm::dragExchange::addImpulse(const label phasei)
{
    if (levels_)
    {
        levels_->spreadShares(
            points_.phases()[phasei].cloud(), impulse_.data(), fraction_.nodesBeside(phasei));
    }
    points_.addImpulse(points_.fieldOf(phasei), impulse_.data());
}

void Foam::mpm::dragExchange::clear()
{
    for (const label c : cells_)
    {
        J_[c] = Zero;
        Q_[c] = 0;
        ahead_[c] = Zero;
        Kc_[c] = held_[c] = 0;
    }
    cells_.clear();
}

void Foam::mpm::dragExchange::dragNodes(const label phasei, const scalar dt)
{
    const velocityField& field = points_.fields()[points_.fieldOf(phasei)];
    const int stride = field.stride();
    startImpulse(field);
    const scalar* U = atCells(phasei);
    const bool exact = fraction_.dragByNodes();
    given_.clear();
    forDragged(
        phasei,
        [&](const label celli, const labelUList& nodes, const UList<scalar>& share,
            const scalar thetaS, const vector& A)
        {
            scalar M = 0;
            const vector mU(momentumOf(nodes, share, U, stride, M));
            const scalar V = fraction_.mesh().V()[celli];
            const vector J(impulse(phasei, celli, M / V, mU / M, thetaS, A, dt));
            take(nodes, share, stride, V, M, J);
            if (exact)
            {
                given_.append(given{J, (mU - V * J) / M});
            }
        });
    addImpulse(phasei);
    if (!exact)
    {
        return;
    }

    // U_s after is that of the nodes, which other cells move and hold too
    U = atCells(phasei);
    const given* of = given_.cdata();
    forDragged(
        phasei,
        [&](const label celli, const labelUList& nodes, const UList<scalar>& share, const scalar,
            const vector&)
        {
            scalar M = 0;
            const vector mU(momentumOf(nodes, share, U, stride, M));
            Q_[celli] += 0.5 * (of->J & (mU / M - of->U));
            ++of;
        });
}

void Foam::mpm::dragExchange::dragBody(const label phasei, const scalar dt)
{
    materialPointCloud& cloud = points_.phases()[phasei].cloud();
    rigidNodes& rigid = points_.fields()[points_.fieldOf(phasei)].rigid();
    freeBody* body = points_.phases()[phasei].motion()->free();
    const scalar* mass = cloud.mass()[0];
    const scalar* volume = (*cloud.gasVolume())[0];

    // Velocity U of the body at x, its place in the cell
    const auto drag = [&](const label celli, const vector& U, const point& x, const scalar thetaS,
                          const vector& A)
    {
        const vector J(
            fraction_.mesh().V()[celli] * impulse(phasei, celli, GREAT, U, thetaS, A, dt));
        if (further_)
        {
            present_.append(presence{phasei, celli, GREAT, U, thetaS, A});
        }
        rigid.addLoad(phasei, -J);
        if (body)
        {
            body->addLoad(-J, x);
            toBodies_ -= J & U;
        }
        else
        {
            work_ += J & U;
        }
    };

    forAll(cloud.cells(), k)
    {
        const label celli = cloud.cells()[k];
        const scalar V = fraction_.mesh().V()[celli];
        const scalar m = cellSum(cloud, k, mass);
        const vector mU(
            cellSumOf(cloud, k, [&](const label p) { return mass[p] * cloud.velocity(p); }));
        vector mx(Zero);
        if (body)
        {
            mx = cellSumOf(
                cloud, k, [&](const label p) { return mass[p] * cloud.position(p, celli); });
        }
        drag(celli, mU / m, mx / m, fraction_.ofPoints(cellSum(cloud, k, volume), V), Zero);
    }

    const rigidMotion::placement& now = points_.phases()[phasei].motion()->now();
    fraction_.forDenseCells(
        phasei,
        [&](const label celli, const labelUList&, const UList<scalar>&, const scalar thetaS)
        {
            const point& x = fraction_.mesh().cellCentres()[celli];
            drag(celli, now.velocityAt(x), x, thetaS, Zero);
        });
    fraction_.surface().forCells(
        phasei,
        [&](const label celli, const labelUList&, const vector& A)
        {
            const point& x = fraction_.mesh().cellCentres()[celli];
            drag(celli, now.velocityAt(x), x, fraction_.theta()[celli], A);
        });
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::dragExchange::dragExchange(
    materialPointSystem& points, eulerianFlow& gas, solidFraction& fraction,
    const dictionary& phaseProperties) :
    points_(points),
    gas_(gas),
    fraction_(fraction),
    mu_(boundedOrDefault(requiredDict(phaseProperties, gas.name()), "mu", 0, 0, GREAT)),
    models_(points.phases().size()),
    normalOnly_(false),
    sticks_(false),
    between_(false),
    form_(solidOnFaces::none),
    J_(fraction.mesh().nCells(), Zero),
    Q_(fraction.mesh().nCells(), 0),
    ahead_(fraction.mesh().nCells(), Zero),
    before_(0),
    Kc_(fraction.mesh().nCells(), 0),
    held_(fraction.mesh().nCells(), 0),
    K_(fraction.mesh().nFaces(), 0),
    inertia_(fraction.mesh().nFaces(), 0),
    levels_(dynamic_cast<const twoLevelShares*>(&points.gridTransfer())),
    work_(0),
    toBodies_(0),
    further_(false),
    owed_(points.phases().size()),
    owes_(false)
{
    forAll(points_.phases(), phasei)
    {
        read(phasei, requiredDict(phaseProperties, points_.phases()[phasei].name()));
        if (models_[phasei].sticks() && !gas_.oneThermo())
        {
            fraction_.wantSurface(phasei);
        }
    }
    form_ = readForm(requiredDict(phaseProperties, gas.name()));
    const fvMesh& mesh = fraction.mesh();
    firstFace_.setSize(mesh.nCells() + 1, 0);
    forAll(mesh.cells(), c)
    {
        for (const label f : mesh.cells()[c])
        {
            if (f < mesh.nInternalFaces())
            {
                cellFaces_.append(f);
            }
        }
        firstFace_[c + 1] = cellFaces_.size();
    }
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        for (label i = 0; pp.coupled() && i < pp.size(); ++i)
        {
            coupledFaces_.append(pp.start() + i);
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::dragExchange::coefficient(
    const label phasei, const label celli, const scalar thetaS, const scalar U) const
{
    const scalar theta = gas_.theta()[celli];
    return models_[phasei].K(dragModel::state{thetaS, theta, gas_.rho()[celli] / theta, mu_, U});
}

void Foam::mpm::dragExchange::exchange(const scalar dt)
{
    clear();
    present_.clear();
    work_ = toBodies_ = 0;
    findBetween();
    if (normalOnly_ || between_)
    {
        fraction_.updateNormals();
    }
    if (owes_)
    {
        pay();
    }

    forAll(points_.phases(), phasei)
    {
        const materialPointPhase& phase = points_.phases()[phasei];
        const bool free = models_[phasei].none() && phase.grains();
        if (!free && phase.motion())
        {
            dragBody(phasei, dt);
        }
        else if (!free)
        {
            dragNodes(phasei, dt);
        }
        if (further_ && !phase.motion())
        {
            findPresent(phasei);
        }
    }
    if (points_.energy().active())
    {
        points_.energy().book(points_.energy().sums().step.drag, toBodies_);
    }
}

void Foam::mpm::dragExchange::updateFaces()
{
    const fvMesh& mesh = fraction_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const scalarField& V = mesh.V();
    const scalarField& rho = gas_.rho();
    mass_.setSize(mesh.nCells());
    for (const label c : cells_)
    {
        mass_[c] = (rho[c] + min(held_[c], 15 * rho[c])) * V[c];
    }
    const auto mass = [&](const label c) { return Kc_[c] > 0 ? mass_[c] : rho[c] * V[c]; };
    const auto set = [&](const label f)
    {
        K_[f] = max(Kc_[own[f]], Kc_[nei[f]]);
        inertia_[f] = min(mass(own[f]), mass(nei[f]));
        faces_.append(f);
    };
    for (const label f : faces_)
    {
        K_[f] = inertia_[f] = 0;
    }
    faces_.clear();

    // Once: with the owner where that has drag
    for (const label c : cells_)
    {
        for (label i = firstFace_[c]; i < firstFace_[c + 1]; ++i)
        {
            const label f = cellFaces_[i];
            if (own[f] == c || !(Kc_[own[f]] > 0))
            {
                set(f);
            }
        }
    }

    // Of the cells behind the others: K and mass
    scalarList behind(2 * (mesh.nFaces() - nei.size()), scalar(0));
    for (const label f : coupledFaces_)
    {
        scalar* b = behind.data() + 2 * (f - nei.size());
        b[0] = Kc_[own[f]];
        b[1] = mass(own[f]);
    }
    fraction_.coupled().swap(behind, 2);
    for (const label f : coupledFaces_)
    {
        const scalar* b = behind.cdata() + 2 * (f - nei.size());
        K_[f] = max(Kc_[own[f]], b[0]);
        inertia_[f] = min(mass(own[f]), b[1]);
    }
}

void Foam::mpm::dragExchange::keep(const scalar dt)
{
    Jbefore_.setSize(J_.size(), Zero);
    aheadBefore_.setSize(ahead_.size(), Zero);
    Qbefore_.setSize(Q_.size(), 0);
    hasBefore_.setSize(J_.size(), false);
    for (const label c : cells_)
    {
        if (!hasBefore_[c])
        {
            hasBefore_[c] = true;
            cellsBefore_.append(c);
        }
        Jbefore_[c] += J_[c];
        Qbefore_[c] += Q_[c];
        aheadBefore_[c] += ahead_[c];
    }
    before_ += dt;
}

void Foam::mpm::dragExchange::addToGas()
{
    if (owes_)
    {
        gas_.addSources(paidCells_, returned_, paid_, vectorField());
        for (vectorField& J : owed_)
        {
            J = Zero;
        }
        owedWork_ = 0;
        owes_ = false;
    }
    if (!(before_ > 0))
    {
        gas_.addSources(cells_, J_, Q_, ahead_);
        return;
    }
    gas_.addSources(cellsBefore_, Jbefore_, Qbefore_, aheadBefore_);
    for (const label c : cellsBefore_)
    {
        hasBefore_[c] = false;
        Jbefore_[c] = Zero;
        Qbefore_[c] = 0;
        aheadBefore_[c] = Zero;
    }
    cellsBefore_.clear();
    before_ = 0;
}

void Foam::mpm::dragExchange::show(solidOnFaces& pores) const
{
    pores.K = K_.cdata();
    pores.inertia = inertia_.cdata();
    pores.fd = form_;
}
