// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "ownPressure.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::ownPressure::found Foam::mpm::ownPressure::gammaLaw(
    const conserved& from, const faceRates& rates, const primitives& to, activeRegion& region) const
{
    const scalar* const theta = from.theta.cdata();
    const scalar* const rho = from.rho.cdata();
    const vector* const rhoU = from.rhoU.cdata();
    const scalar* const rhoE = from.rhoE.cdata();
    const vector* const rate = rates.directions.cdata();
    const scalar* const rateOfAll = rates.all.cdata();
    gasState* const W = to.W.data();
    scalar* const p = to.p.data();
    vector* const U = to.U.data();
    scalar* const rho0 = to.rho0.data();
    scalar* const T = to.T;
    const scalar gamma = thermo_.gamma();
    const scalar R = thermo_.R();
    const bool energy = thermo_.hasEnergy();

    found result{0, -1};
    region.forCells(
        [&](const label c)
        {
            gasState& w = W[c];
            const gasState before(w);
            const scalar iTheta = 1 / theta[c];
            w.rho = rho[c] * iTheta;
            w.u = rhoU[c] / rho[c];
            w.p = energy ? (gamma - 1) * (rhoE[c] - 0.5 * (rhoU[c] & w.u)) * iTheta
                         : thermo_.pIsentropic(w.rho);

            p[c] = w.p;
            U[c] = w.u;
            rho0[c] = w.rho;
            if (T)
            {
                T[c] = w.p / (w.rho * R);
            }

            const scalar r =
                (cmptMag(w.u) & rate[c]) + std::sqrt(gamma * w.p / w.rho) * rateOfAll[c];
            if (!(w.rho > 0 && w.p > 0 && r < GREAT))
            {
                result.bad = result.bad < 0 ? c : result.bad;
            }
            result.rate = max(result.rate, r);
            region.set(c, r, w.rho != before.rho || w.p != before.p || w.u != before.u);
        });
    if (region.used())
    {
        result.rate = region.largestRate();
    }
    return result;
}

Foam::mpm::ownPressure::found Foam::mpm::ownPressure::general(
    const conserved& from, const faceRates& rates, const primitives& to) const
{
    constexpr label room = gasThermo::room;
    const bool energy = thermo_.hasEnergy();
    scalar rho0[room], e[room], p[room], c2[room], Gamma[room];

    found result{0, -1};
    const label nCells = from.rho.size();
    for (label first = 0; first < nCells; first += room)
    {
        const label n = min(room, nCells - first);
        for (label i = 0; i < n; ++i)
        {
            const label c = first + i;
            const vector u(from.rhoU[c] / from.rho[c]);
            rho0[i] = from.rho[c] / from.theta[c];
            e[i] = energy ? (from.rhoE[c] - 0.5 * (from.rhoU[c] & u)) / from.rho[c] : 0;
            to.W[c].u = u;
        }
        thermo_.equation().pressures(n, rho0, e, p, c2, Gamma);
        for (label i = 0; i < n; ++i)
        {
            const label c = first + i;
            gasState& w = to.W[c];
            w.rho = rho0[i];
            w.p = p[i];
            to.terms[c].set(rho0[i], e[i], c2[i], Gamma[i]);
            to.p[c] = w.p;
            to.U[c] = w.u;
            to.rho0[c] = w.rho;

            const scalar r = (cmptMag(w.u) & rates.directions[c]) + std::sqrt(c2[i]) * rates.all[c];
            if (!(w.rho > 0 && c2[i] > 0 && r < GREAT))
            {
                result.bad = result.bad < 0 ? c : result.bad;
            }
            result.rate = max(result.rate, r);
        }
    }
    return result;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::ownPressure::conserve(
    const conserved& to, const scalarField& p, const vectorField& U, const scalar* T,
    const scalarField& rho0) const
{
    if (thermo_.isGammaLaw())
    {
        const scalar iGm1 = 1 / (thermo_.gamma() - 1);
        forAll(to.rho, c)
        {
            to.rho[c] = to.theta[c] * thermo_.rho(p[c], T ? T[c] : 1);
            to.rhoU[c] = to.rho[c] * U[c];
            if (thermo_.hasEnergy())
            {
                to.rhoE[c] = to.theta[c] * p[c] * iGm1 + 0.5 * to.rho[c] * magSqr(U[c]);
            }
        }
        return;
    }

    const equationOfState& equation = thermo_.equation();
    const label n = to.rho.size();
    scalarField rho(rho0);
    if (thermo_.hasEnergy())
    {
        scalarField e(n), c2(n), Gamma(n);
        equation.energies(n, rho.cdata(), p.cdata(), e.data(), c2.data(), Gamma.data());
        forAll(e, c)
        {
            to.rhoE[c] = to.theta[c] * rho[c] * (e[c] + 0.5 * magSqr(U[c]));
        }
    }
    else
    {
        rho = equation.rho0();
        equation.densities(n, p.cdata(), rho.data());
    }
    forAll(rho, c)
    {
        to.rho[c] = to.theta[c] * rho[c];
        to.rhoU[c] = to.rho[c] * U[c];
    }
}

bool Foam::mpm::ownPressure::markBad(const conserved& s, boolList& bad) const
{
    bool none = true;
    if (thermo_.isGammaLaw())
    {
        forAll(bad, c)
        {
            bad[c] = !isPositive(s, c);
            none = none && !bad[c];
        }
        return none;
    }

    constexpr label room = gasThermo::room;
    scalar rho0[room], e[room], p[room], c2[room], Gamma[room];
    for (label first = 0; first < bad.size(); first += room)
    {
        const label n = min(room, bad.size() - first);
        for (label i = 0; i < n; ++i)
        {
            const label c = first + i;
            rho0[i] = s.rho[c] / s.theta[c];
            e[i] = (s.rhoE[c] - 0.5 * magSqr(s.rhoU[c]) / s.rho[c]) / s.rho[c];
        }
        thermo_.equation().pressures(n, rho0, e, p, c2, Gamma);
        for (label i = 0; i < n; ++i)
        {
            bad[first + i] = !(rho0[i] > 0 && c2[i] > 0);
            none = none && !bad[first + i];
        }
    }
    return none;
}
