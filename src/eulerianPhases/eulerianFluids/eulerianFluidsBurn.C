// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianFluids::makeBurnt(const fieldStates* states)
{
    const auto make = [&](carriedShare& share, const word& name, const char* what, const auto& has)
    {
        DynamicList<label> of;
        PtrList<volScalarField> fields;
        for (label k = 0; k < n_; ++k)
        {
            if (has(k))
            {
                of.append(k);
                fields.append(newField(name, k, states, states || inFile(name, k), 0));
            }
        }
        share.start(n_, of, fields, Wb_.size(), what);
    };
    make(burnt_, "F", "burn fraction", [&](const label k) { return mixture_.detonates(k); });
    make(
        lambda_, "lambda", "share that has burned on",
        [&](const label k) { return mixture_.burnsOn(k); });
    carries_ = !burnt_.empty() || !lambda_.empty();
}

void Foam::mpm::eulerianFluids::startBurning()
{
    boolList charge(mesh_.nCells());
    for (const label k : burnt_.of())
    {
        const scalar trace = traceOf(k);
        forAll(charge, c)
        {
            charge[c] = mass_[n_ * c + k] > 0 && part_[n_ * c + k] > trace * theta_[c];
        }
        mixture_.detonates(k)->start(mesh_, charge, !restarted_);
    }
}

void Foam::mpm::eulerianFluids::remaining(
    const label k, const scalar dt, DynamicList<label>& cells, DynamicList<scalar>& masses)
{
    const labelList& slot = interfaces_->slot();
    cells.clear();
    masses.clear();
    forAll(slot, c)
    {
        const label s = slot[c];
        if (s < 0 && interfaces_->single()[c] != k)
        {
            continue;
        }
        const scalar m = s < 0 ? rho_[c] - dt / V_[c] * sums_[c].rho : shares_[n_ * s + k].m;
        if (m > 0)
        {
            cells.append(c);
            masses.append(m);
        }
    }
}

void Foam::mpm::eulerianFluids::burn(const scalar dt)
{
    const labelList& slot = interfaces_->slot();
    DynamicList<label> cells;
    DynamicList<scalar> m, p, F;
    forAll(burnt_.of(), j)
    {
        const label k = burnt_.of()[j];
        remaining(k, dt, cells, m);
        p.clear();
        F.clear();
        forAll(cells, i)
        {
            const label c = cells[i];
            const scalar mF = burnt_.flown(j, c, mass_[n_ * c + k], dt / V_[c]);
            p.append(W_[c].p);
            F.append(mF < (1 - 1e-9) * m[i] ? max(mF / m[i], scalar(0)) : 1);
        }
        mixture_.detonates(k)->burn(cells, p, mesh_.time().value(), dt, F);
        forAll(cells, i)
        {
            const label c = cells[i];
            burnt_.set(c, k, F[i]);
            if (slot[c] >= 0)
            {
                shares_[n_ * slot[c] + k].F = F[i];
            }
        }
        burnt_.clear(j);
    }
}

void Foam::mpm::eulerianFluids::burnOn(const scalar dt)
{
    const labelList& slot = interfaces_->slot();
    DynamicList<label> cells;
    DynamicList<scalar> m;
    forAll(lambda_.of(), j)
    {
        const label k = lambda_.of()[j];
        const afterburn& law = *mixture_.burnsOn(k);
        remaining(k, dt, cells, m);
        forAll(cells, i)
        {
            const label c = cells[i];
            const scalar h = dt / V_[c], F = burntOf(c, k);
            const scalar was = lambda_.flown(j, c, mass_[n_ * c + k], h) / m[i];
            const scalar x = F > 0 ? min(max(was / F, scalar(0)), scalar(1)) : 0;
            const scalar now = F > 0 ? F * law.burn(x, W_[c].p, dt) : 0;
            lambda_.set(c, k, now);

            // With what rounding has taken of lambda: the heat is that of all of it
            const scalar heat = law.Q() * m[i] * (now - was);
            sums_[c].rhoE -= heat / h;
            if (slot[c] >= 0)
            {
                shares_[n_ * slot[c] + k].e0 += heat;
            }
            if (flows_)
            {
                flows_->afterburn += heat * V_[c];
            }
        }
        lambda_.clear(j);
    }
}

void Foam::mpm::eulerianFluids::columnsFilled(const labelUList& cells)
{
    for (const label c : cells)
    {
        relaxedP_[c] = -1;
    }
    burnt_.filled(cells, mass_);
    lambda_.filled(cells, mass_);
}
