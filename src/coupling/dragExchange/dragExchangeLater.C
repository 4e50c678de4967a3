// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "dragExchange.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::dragExchange::pay()
{
    for (const label c : paidCells_)
    {
        returned_[c] = Zero;
        paid_[c] = 0;
    }
    paidCells_.clear();
    returned_.setSize(J_.size(), Zero);
    paid_.setSize(J_.size(), 0);
    forAll(owed_, phasei)
    {
        if (owed_[phasei].empty())
        {
            continue;
        }
        isPaid_.setSize(J_.size());
        isPaid_ = false;
        if (points_.phases()[phasei].motion())
        {
            payBody(phasei);
        }
        else
        {
            payNodes(phasei);
        }

        // The phase has left the cell
        forAll(isPaid_, c)
        {
            const vector& J = owed_[phasei][c];
            if (!isPaid_[c] && magSqr(J) > 0)
            {
                returned_[c] -= J;
                paidCells_.append(c);
            }
        }
    }
    isPaid_ = false;
    label n = 0;
    for (const label c : paidCells_)
    {
        if (!isPaid_[c])
        {
            isPaid_[c] = true;
            paidCells_[n++] = c;
            paid_[c] -= owedWork_[c];
        }
    }
    paidCells_.setSize(n);
}

void Foam::mpm::dragExchange::bookPaid(const label phasei, const label celli, const scalar Q)
{
    isPaid_[celli] = true;
    paid_[celli] += Q;
    paidCells_.append(celli);
}

void Foam::mpm::dragExchange::payNodes(const label phasei)
{
    const velocityField& field = points_.fields()[points_.fieldOf(phasei)];
    const int stride = field.stride();
    startImpulse(field);

    // J of half of the velocities before and after, of the nodes
    const auto book = [&](const scalar* U, const bool after)
    {
        forDragged(
            phasei,
            [&](const label c, const labelUList& nodes, const UList<scalar>& share, const scalar,
                const vector&)
            {
                const vector& J = owed_[phasei][c];
                scalar M = 0;
                const vector mU(momentumOf(nodes, share, U, stride, M));
                if (!(magSqr(J) > 0) || !(M > 0))
                {
                    return;
                }
                bookPaid(phasei, c, 0.5 * (J & mU) / M);
                if (!after)
                {
                    take(nodes, share, stride, fraction_.mesh().V()[c], M, J);
                }
            });
    };
    book(atCells(phasei), false);
    addImpulse(phasei);
    book(atCells(phasei), true);
}

void Foam::mpm::dragExchange::payBody(const label phasei)
{
    rigidNodes& rigid = points_.fields()[points_.fieldOf(phasei)].rigid();
    freeBody* body = points_.phases()[phasei].motion()->free();
    const rigidMotion::placement& now = points_.phases()[phasei].motion()->now();
    forAll(owed_[phasei], c)
    {
        const vector& J = owed_[phasei][c];
        if (!(magSqr(J) > 0))
        {
            continue;
        }
        const scalar V = fraction_.mesh().V()[c];
        const point& x = fraction_.mesh().cellCentres()[c];
        const vector U(now.velocityAt(x));
        rigid.addLoad(phasei, -V * J);
        if (body)
        {
            body->addLoad(-V * J, x);
            toBodies_ -= V * (J & U);
        }
        else
        {
            work_ += V * (J & U);
        }
        bookPaid(phasei, c, J & U);
    }
}

void Foam::mpm::dragExchange::findPresent(const label phasei)
{
    const velocityField& field = points_.fields()[points_.fieldOf(phasei)];
    const scalar* U = atCells(phasei);
    forDragged(
        phasei,
        [&](const label c, const labelUList& nodes, const UList<scalar>& share, const scalar thetaS,
            const vector& A)
        {
            scalar M = 0;
            const vector mU(momentumOf(nodes, share, U, field.stride(), M));
            if (M > 0)
            {
                present_.append(
                    presence{phasei, c, M / fraction_.mesh().V()[c], mU / M, thetaS, A});
            }
        });
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::dragExchange::further(const scalar dt)
{
    clear();
    for (presence& s : present_)
    {
        if (models_[s.phasei].none() && points_.phases()[s.phasei].grains())
        {
            continue;
        }
        const vector J(impulse(s.phasei, s.celli, s.M, s.U, s.thetaS, s.A, dt));
        if (!(magSqr(J) > 0))
        {
            continue;
        }
        owedOf(s.phasei)[s.celli] += J;
        owedWork()[s.celli] += J & (s.M < GREAT ? s.U - 0.5 * J / s.M : s.U);
        if (s.M < GREAT)
        {
            s.U -= J / s.M;
        }
    }
    updateFaces();
    gas_.addSources(cells_, J_, Q_, ahead_);
}

void Foam::mpm::dragExchange::owe(const UList<vector>& impulse)
{
    // The heaviest in each cell takes it
    const scalarField& V = fraction_.mesh().V();
    labelList first(J_.size(), -1);
    forAll(present_, i)
    {
        label& k = first[present_[i].celli];
        if (k < 0 || present_[i].M > present_[k].M)
        {
            k = i;
        }
    }
    DynamicList<label> cells;
    vectorField momentum(J_.size(), Zero);
    scalarField energy(J_.size(), 0);
    forAll(impulse, c)
    {
        if (!(magSqr(impulse[c]) > 0))
        {
            continue;
        }
        const vector J(-impulse[c] / V[c]);
        if (first[c] >= 0)
        {
            const presence& s = present_[first[c]];
            owedOf(s.phasei)[c] += J;
            owedWork()[c] += J & s.U;
        }
        else
        {
            momentum[c] = -J;
            energy[c] = -J & (gas_.rhoU()[c] - 0.5 * J) / gas_.rho()[c];
            cells.append(c);
        }
    }
    gas_.addSources(cells, momentum, energy, vectorField());
    resume();
}

Foam::vectorField& Foam::mpm::dragExchange::owedOf(const label phasei)
{
    owed_[phasei].setSize(J_.size(), Zero);
    return owed_[phasei];
}

Foam::scalarField& Foam::mpm::dragExchange::owedWork()
{
    owedWork_.setSize(J_.size(), 0);
    return owedWork_;
}

void Foam::mpm::dragExchange::resume()
{
    owedWork();
    bool any = false;
    for (const vectorField& J : owed_)
    {
        for (const vector& j : J)
        {
            any = any || magSqr(j) > 0;
        }
    }
    owes_ = returnReduce(any, orOp<bool>());

    // All processors pay the same phases
    forAll(owed_, phasei)
    {
        if (returnReduce(owed_[phasei].size() > 0, orOp<bool>()))
        {
            owedOf(phasei);
        }
    }
}

Foam::vector Foam::mpm::dragExchange::owedMomentum() const
{
    vector all(Zero);
    for (const vectorField& J : owed_)
    {
        if (J.size())
        {
            all += sum(fraction_.mesh().V().field() * J);
        }
    }
    return all;
}

Foam::scalar Foam::mpm::dragExchange::owedEnergy() const
{
    return owedWork_.empty() ? 0 : sum(fraction_.mesh().V().field() * owedWork_);
}
