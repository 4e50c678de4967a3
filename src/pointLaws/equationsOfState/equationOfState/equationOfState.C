// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "equationOfState.H"
#include "noTraps.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(equationOfState, 0);
defineRunTimeSelectionTable(equationOfState, dictionary);
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- States that are worked on together
constexpr label room = 256;

//- Call f(first, n) for runs of n <= room states
template<class Function>
void inRuns(const label n, const Function& f)
{
    for (label first = 0; first < n; first += room)
    {
        f(first, min(room, n - first));
    }
}

}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::equationOfState>
Foam::mpm::equationOfState::New(const dictionary& dict, const scalar rho0)
{
    // Values of no material overflow; what comes of them is checked here
    const noTraps guard;
    constexpr scalar light = 299792458, most = 1e30;
    if (!(rho0 > 0 && rho0 < most))
    {
        FatalIOErrorInFunction(dict)
            << "The density rho of " << dict.name() << " is " << rho0
            << " kg/m3; it must be that of a material." << exit(FatalIOError);
    }
    autoPtr<equationOfState> equation(
        selectFromTable<equationOfState>(dict, dictionaryConstructorTablePtr_, dict, rho0));
    const scalar e0 = equation->e0();
    const scalar c2 = equation->c2(rho0, e0), p = equation->p(rho0, e0);
    if (!(c2 < sqr(light) && mag(p) < most && mag(e0) < most))
    {
        FatalIOErrorInFunction(dict)
            << "At the density " << rho0 << " kg/m3 the equation of state " << equation->type()
            << " in " << dict.name() << " has energy " << e0 << " J/kg, pressure " << p
            << " Pa and speed of sound " << std::sqrt(max(c2, scalar(0)))
            << " m/s, which is that of no"
            << " material: look at its entries and at rho." << exit(FatalIOError);
    }
    return equation;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::equationOfState::storedEnergy(const scalar) const
{
    NotImplemented;
    return 0;
}

Foam::scalar Foam::mpm::equationOfState::coldEnergy(const scalar) const
{
    NotImplemented;
    return 0;
}

void Foam::mpm::equationOfState::pressures(
    const label n, const scalar* rho, const scalar* e, scalar* p, scalar* c2, scalar* Gamma) const
{
    inRuns(
        n,
        [&](const label first, const label size)
        {
            scalar A[room], B[room], dA[room], dB[room];
            coefficients(size, rho + first, A, B, dA, dB);
            for (label i = 0; i < size; ++i)
            {
                const label j = first + i;
                p[j] = A[i] + B[i] * e[j];
                c2[j] = dA[i] + e[j] * dB[i] + p[j] * B[i] / sqr(rho[j]);
                Gamma[j] = B[i] / rho[j];
            }
        });
}

void Foam::mpm::equationOfState::energies(
    const label n, const scalar* rho, const scalar* p, scalar* e, scalar* c2, scalar* Gamma) const
{
    const bool energy = usesEnergy();
    inRuns(
        n,
        [&](const label first, const label size)
        {
            scalar A[room], B[room], dA[room], dB[room];
            coefficients(size, rho + first, A, B, dA, dB);
            for (label i = 0; i < size; ++i)
            {
                const label j = first + i;
                e[j] = energy ? (p[j] - A[i]) / B[i] : 0;
                c2[j] = dA[i] + e[j] * dB[i] + p[j] * B[i] / sqr(rho[j]);
                Gamma[j] = B[i] / rho[j];
            }
        });
}

void Foam::mpm::equationOfState::densities(const label n, const scalar* p, scalar* rho) const
{
    // Newton's method for all states of a run; those that are done stay
    inRuns(
        n,
        [&](const label first, const label size)
        {
            scalar A[room], B[room], dA[room], dB[room];
            bool done[room] = {};
            label left = size;
            for (int k = 0; k < 100 && left; ++k)
            {
                coefficients(size, rho + first, A, B, dA, dB);
                for (label i = 0; i < size; ++i)
                {
                    if (done[i])
                    {
                        continue;
                    }
                    scalar& r = rho[first + i];
                    const scalar change = (p[first + i] - A[i]) / dA[i];

                    // Convex: the way down may pass zero, that up be far
                    r = min(max(r + change, 0.1 * r), 2 * r);
                    done[i] = mag(change) <= 1e-15 * r || !(dA[i] > 0);
                    left -= done[i];
                }
            }
            coefficients(size, rho + first, A, B, dA, dB);
            for (label i = 0; i < size; ++i)
            {
                const scalar error = mag(p[first + i] - A[i]);
                if (!(error <= 1e-9 * (mag(p[first + i]) + rho[first + i] * dA[i])))
                {
                    rho[first + i] = -1;
                }
            }
        });
}

Foam::mpm::equationOfState::terms Foam::mpm::equationOfState::at(const scalar rho) const
{
    terms t;
    coefficients(1, &rho, &t.A, &t.B, &t.dA, &t.dB);
    return t;
}

Foam::scalar Foam::mpm::equationOfState::p(const scalar rho, const scalar e) const
{
    const terms t(at(rho));
    return t.A + t.B * e;
}

Foam::scalar Foam::mpm::equationOfState::e(const scalar rho, const scalar p) const
{
    const terms t(at(rho));
    return usesEnergy() ? (p - t.A) / t.B : 0;
}

Foam::scalar Foam::mpm::equationOfState::c2(const scalar rho, const scalar e) const
{
    const terms t(at(rho));
    const scalar p = t.A + t.B * e;
    return t.dA + e * t.dB + p * t.B / sqr(rho);
}

Foam::scalar Foam::mpm::equationOfState::c(const scalar rho, const scalar e) const
{
    return std::sqrt(max(c2(rho, e), scalar(0)));
}

bool Foam::mpm::equationOfState::stateOf(const scalar p, scalar& rho, scalar& e) const
{
    rho = rho0_;
    e = e0();
    if (pressureByEnergy())
    {
        const terms t(at(rho));
        e = (p - t.A) / t.B;
        return p > 0;
    }
    for (int i = 0; i < 100; ++i)
    {
        const terms t(at(rho));
        const scalar slope = t.dA + e * t.dB;
        const scalar change = (p - t.A - t.B * e) / slope;
        if (!(slope > 0) || !(mag(change) < 0.5 * rho))
        {
            return false;
        }
        rho += change;
        if (mag(change) <= 1e-15 * rho)
        {
            break;
        }
    }
    return mag(this->p(rho, e) - p) <= 1e-9 * (mag(p) + rho0_ * sqr(c(rho0_, e0())));
}
