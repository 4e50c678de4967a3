// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointContact.H"
#include "materialPointSystem.H"
#include "pointEnergy.H"
#include "dictionaryTools.H"
#include "largestOfAll.H"
#include "twoLevelShares.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointContact::relative(
    const contactNode& m, const scalar* ua, const scalar* ub, const int step, const bool settling,
    scalar* du) const
{
    const contactPair& pair = pairs_[m.pair];
    const int stride = fields_[pair.a].stride();
    const scalar* Ja = impulse_[pair.a].cdata() + stride * m.node;
    for (int d = 0; d < nDim_; ++d)
    {
        du[d] = -(settling && m.bodyA >= 0 ? m.bodyU[0][d] : ua[step * m.node + d]) - m.ia * Ja[d];
        if (pair.b >= 0)
        {
            du[d] += (settling && m.bodyB >= 0 ? m.bodyU[1][d] : ub[step * m.node + d])
                + m.ib * impulse_[pair.b][stride * m.node + d];
        }
    }
}

void Foam::mpm::pointContact::computeImpulses(
    const List<scalar*>& u, const int step, const scalar dt, const bool settling,
    const bool ofStrain)
{
    const label sweeps = pairs_.size() > 1 ? 5 : 1;
    const auto give = [&](const contactNode& m, const int d, const scalar J)
    {
        const contactPair& pair = pairs_[m.pair];
        const int stride = fields_[pair.a].stride();
        impulse_[pair.a][stride * m.node + d] -= J;
        if (pair.b >= 0)
        {
            impulse_[pair.b][stride * m.node + d] += J;
        }
    };

    for (contactNode& m : contactNodes_)
    {
        m.stickImpulse = 0;
        m.Jn = m.Jt[0] = m.Jt[1] = m.Jt[2] = 0;
    }
    for (label sweep = 0; sweep < sweeps; ++sweep)
    {
        for (contactNode& m : contactNodes_)
        {
            const contactPair& pair = pairs_[m.pair];
            const scalar M = 1 / (m.ia + m.ib);
            scalar du[3] = {0, 0, 0};
            relative(m, u[pair.a], pair.b < 0 ? nullptr : u[pair.b], step, settling, du);

            scalar un = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                un += du[d] * m.n[d];
            }
            const scalar approach = m.gap > 0 ? m.gap / max(dt, VSMALL) : 0;
            const bool held = ofStrain && m.pressed;
            const bool sticks = ofStrain && m.held;
            const scalar Jn = held ? m.Jn - M * un : max(scalar(0), m.Jn - M * (approach + un));

            // Tangential: the impulse that ends the slip, limited by friction
            scalar slip[3], size = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                slip[d] = m.Jt[d] - M * (du[d] - un * m.n[d]);
                size += sqr(slip[d]);
            }
            size = std::sqrt(size);
            const contactLaw& law = *pair.how.law;
            const contactLaw::state s{Jn, size, M, dt};
            const scalar limit = sticks ? GREAT : Jn > 0 ? law.limit(s) : 0;
            const bool stuck = sticks || (Jn > 0 && size <= limit);
            const scalar part = stuck ? 1 : size > 0 ? min(scalar(1), limit / size) : 0;
            for (int d = 0; d < nDim_; ++d)
            {
                const scalar Jt = part * slip[d];
                give(m, d, (Jn - m.Jn) * m.n[d] + Jt - m.Jt[d]);
                m.Jt[d] = Jt;
            }
            m.Jn = Jn;
            m.stickImpulse = size;
            m.closed = held || Jn > 0;
            m.stuck = stuck;
            m.slope = settling && Jn > 0 && !stuck ? law.slope(s) : 0;
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointContact::pointContact(materialPointSystem& points) :
    stepPart("contact"),
    points_(points),
    grid_(points.grid()),
    phases_(points.phases()),
    fields_(points.fields()),
    fieldOf_(points.fieldOf()),
    gridTransfer_(points.gridTransfer()),
    nDim_(grid_.nDim()),
    any_(false),
    has_(fields_.size(), false),
    position_(grid_.nodePositions()),
    gradient_(fields_.size()),
    impulse_(fields_.size()),
    prescribedStamp_(grid_.nNodes(), label(-1)),
    stamp_(0),
    owner_(grid_.nNodes(), label(-1)),
    otherOwner_(grid_.nNodes(), label(-1)),
    placeOf_(grid_.nNodes(), label(-1)),
    other_(grid_.nNodes(), scalar(-1)),
    nReach_(dynamic_cast<const twoLevelShares*>(&gridTransfer_) ? 8 : 4),
    reach_(nReach_ * grid_.nNodes(), -GREAT)
{
    read(requiredDict(points.properties(), "contact"));
    findEdges();
    pressed_.setSize(pairs_.size());
    if (nReach_ > 4)
    {
        setBalls();
    }
    forAll(fields_, fieldi)
    {
        for (const rigidNodes::bodyOf& b : fields_[fieldi].rigid().bodies())
        {
            bodies_.append(bodyOf{fieldi, b.phase, b.body});
        }
        if (has_[fieldi])
        {
            impulse_[fieldi].setSize(fields_[fieldi].stride() * grid_.nNodes(), scalar(0));
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::pointContact::between(const label a, const label b) const
{
    for (const contactPair& pair : pairs_)
    {
        if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a))
        {
            return true;
        }
    }
    return false;
}

void Foam::mpm::pointContact::update()
{
    contactNodes_.clear();
    forAll(pairs_, pairi)
    {
        meet(pairi);
    }
    any_ = onAny(!contactNodes_.empty());
    if (any_)
    {
        sumGradients();
        setNormals();
        setGaps();
        markPressed();
    }
}

Foam::scalar Foam::mpm::pointContact::applyImpulses(const scalar dt, const bool withWork)
{
    for (contactPair& pair : pairs_)
    {
        pair.step = Zero;
        pair.nClosed = pair.pushedGap = pair.push = 0;
    }
    release();
    if (!any_)
    {
        return 0;
    }

    List<scalar*> u(fields_.size(), nullptr);
    forAll(fields_, fieldi)
    {
        u[fieldi] = fields_[fieldi].UL();
    }
    const int step = fields_[0].stride();
    if (bodies_.size())
    {
        solveBodies(u, step, dt);
    }
    else
    {
        computeImpulses(u, step, dt, false);
    }

    for (contactNode& m : contactNodes_)
    {
        contactPair& pair = pairs_[m.pair];
        const scalar part = fields_[pair.a].part(m.node);
        m.pressed = m.closed;
        m.held = m.closed && m.stuck;
        if (m.closed)
        {
            pressed_[m.pair].append(2 * m.node + m.held);
            pair.nClosed += part;
            pair.pushedGap += part * m.Jn * m.gap;
            pair.push += part * m.Jn;
        }
        for (int d = 0; d < nDim_; ++d)
        {
            m.J[d] = m.Jn * m.n[d] + m.Jt[d];
            pair.step[grid_.direction(d)] += part * m.J[d];
        }
    }
    scalar work = 0;
    forAll(fields_, fieldi)
    {
        if (has_[fieldi])
        {
            fields_[fieldi].rigid().addImpulse(
                impulse_[fieldi].cdata(), fields_[fieldi].momentum(), fields_[fieldi].stride());
            work += fields_[fieldi].addImpulse(impulse_[fieldi].cdata(), withWork, true);
        }
    }
    clearImpulses();
    return work;
}

Foam::scalar Foam::mpm::pointContact::work(scalar& driven) const
{
    // On free bodies where J acts
    scalar work = 0;
    driven = 0;
    for (const contactNode& m : contactNodes_)
    {
        const contactPair& pair = pairs_[m.pair];
        for (const label fieldi : {pair.a, pair.b})
        {
            if (fieldi < 0)
            {
                continue;
            }
            const bool isA = fieldi == pair.a;
            const label b = isA ? m.bodyA : m.bodyB;
            // Its reaction is on the other side
            const bool drives = b < 0 && (isA ? m.ia : m.ib) <= 0;
            const velocityField& field = fields_[fieldi];
            vector ub(Zero);
            if (b >= 0)
            {
                const freeBody& body = *bodies_[b].body;
                ub = body.at(m.at, false) * (0.5 * (body.start(false) + body.step()));
            }
            scalar w = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                const label i = field.stride() * m.node + d;
                w += field.part(m.node) * (isA ? -m.J[d] : m.J[d])
                    * (b >= 0 ? ub[grid_.direction(d)] : points_.energy().meanVelocity(fieldi)[i]);
            }
            work += drives ? 0 : w;
            driven -= drives ? w : 0;
        }
    }
    return work;
}

void Foam::mpm::pointContact::impulse(const scalar dt)
{
    pointEnergy& energy = points_.energy();
    const scalar boundary = applyImpulses(dt, energy.active());
    if (energy.active())
    {
        energy.book(energy.sums().step.boundary, boundary);
    }
}

void Foam::mpm::pointContact::moving(const scalar)
{
    pointEnergy& energy = points_.energy();
    if (energy.active())
    {
        scalar driven;
        const scalar all = work(driven);
        energy.book(energy.sums().step.contact, all);
        energy.book(energy.sums().step.driven, driven);
    }
}

void Foam::mpm::pointContact::strainVelocity(const scalar dt)
{
    if (!any_)
    {
        return;
    }
    List<scalar*> u(fields_.size(), nullptr);
    forAll(fields_, fieldi)
    {
        u[fieldi] = fields_[fieldi].strainU();
    }
    const int stride = fields_[0].stride();
    computeImpulses(u, stride, dt, false, true);
    for (const contactNode& m : contactNodes_)
    {
        const contactPair& pair = pairs_[m.pair];
        for (int side = 0; side < 2; ++side)
        {
            const label fieldi = side == 0 ? pair.a : pair.b;
            for (int d = 0; fieldi >= 0 && d < nDim_; ++d)
            {
                scalar& J = impulse_[fieldi][stride * m.node + d];
                u[fieldi][stride * m.node + d] += (side == 0 ? m.ia : m.ib) * J;
                J = 0;
            }
        }
    }
    forAll(fields_, fieldi)
    {
        if (has_[fieldi])
        {
            fields_[fieldi].constrain(u[fieldi], stride, false, false);
        }
    }
}

void Foam::mpm::pointContact::filtered(const bool changes)
{
    if (!any_)
    {
        return;
    }
    if (changes && bodies_.size())
    {
        shareIncrement();
    }
    for (contactNode& m : contactNodes_)
    {
        if (!m.closed || hard(m))
        {
            continue;
        }
        contactPair& pair = pairs_[m.pair];
        velocityField* field[2] = {&fields_[pair.a], pair.b < 0 ? nullptr : &fields_[pair.b]};
        const scalar inverse[2] = {m.ia, m.ib};
        const label at = fields_[pair.a].stride() * m.node;
        const scalar part = fields_[pair.a].part(m.node);
        scalar dv[3] = {0, 0, 0}, dvn = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            dv[d] = (field[1] ? field[1]->increment()[at + d] : 0) - field[0]->increment()[at + d];
            dvn += dv[d] * m.n[d];
        }
        const scalar M = 1 / (m.ia + m.ib);
        for (int d = 0; d < nDim_; ++d)
        {
            const scalar take = M * (m.stuck ? dv[d] : dvn * m.n[d]);
            for (int side = 0; side < 2 && field[side]; ++side)
            {
                const scalar J = side == 0 ? take : -take;
                field[side]->increment()[at + d] += inverse[side] * J;
                if (changes)
                {
                    // An increment of du is added to it anyway
                    if (field[side]->filtered() != velocityField::ofDU)
                    {
                        field[side]->dU()[at + d] += inverse[side] * J;
                    }
                    impulse_[side == 0 ? pair.a : pair.b][at + d] += inverse[side] > 0 ? 0 : J;
                }
            }
            if (changes)
            {
                m.J[d] -= take;
                pair.step[grid_.direction(d)] -= part * take;
            }
        }
    }

    // What rigid bodies and patches take of it
    for (label fieldi = 0; changes && fieldi < fields_.size(); ++fieldi)
    {
        if (has_[fieldi])
        {
            velocityField& field = fields_[fieldi];
            const scalar* J = impulse_[fieldi].cdata();
            field.rigid().addImpulse(J, field.momentum(), field.stride());
            field.addToIncrement(J);
        }
    }
    if (changes)
    {
        clearImpulses();
    }
}

void Foam::mpm::pointContact::accepted(const scalar)
{
    for (contactPair& pair : pairs_)
    {
        pair.sum += pair.step;
    }
    if (!points_.strainsEarly())
    {
        update();
    }
}

void Foam::mpm::pointContact::end(const scalar)
{
    // Of use to a strain at the start of the next step only
    if (!points_.strainsEarly())
    {
        release();
    }
    update();
}

Foam::vector Foam::mpm::pointContact::impulseOnPatches() const
{
    vector sum(Zero);
    for (const contactPair& pair : pairs_)
    {
        sum += pair.b < 0 ? pair.sum : vector(Zero);
    }
    return returnReduce(sum, sumOp<vector>());
}

void Foam::mpm::pointContact::report() const
{
    for (const contactPair& pair : pairs_)
    {
        const scalar closed = returnReduce(pair.nClosed, sumOp<scalar>());
        const scalar push = returnReduce(pair.push, sumOp<scalar>());
        scalar gap = GREAT;
        for (const contactNode& m : contactNodes_)
        {
            if (!(push > 0) && &pairs_[m.pair] == &pair && m.gap >= 0)
            {
                gap = min(gap, m.gap);
            }
        }
        reduce(gap, minOp<scalar>());
        if (push > 0)
        {
            gap = returnReduce(pair.pushedGap, sumOp<scalar>()) / push;
        }
        const vector sum(returnReduce(pair.sum, sumOp<vector>()));
        const vector step(returnReduce(pair.step, sumOp<vector>()));
        const vector force(pair.force.next(sum, points_.time().value(), step, points_.deltaT()));
        Info << "Contact " << pair.how.name << " between " << fields_[pair.a].name() << " and "
             << (pair.b >= 0 ? "" : "patch ") << (pair.b >= 0 ? fields_[pair.b].name() : pair.patch)
             << ": force " << force << " N, impulse " << sum << " N s, gap ";
        if (gap < GREAT)
        {
            Info << gap << " m";
        }
        else
        {
            Info << "none";
        }
        Info << ", closed nodes " << std::round(closed) << endl;
    }
    if (nUnsettled_)
    {
        Info << "Contact of free bodies: not converged in " << nUnsettled_
             << " solutions of this run (a smaller maxCo helps)" << endl;
    }
}
