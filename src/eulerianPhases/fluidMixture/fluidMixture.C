/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "fluidMixture.H"
#include "dictionaryTools.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::fluidMixture::density
(
    const label k,
    const share& s,
    const scalar P,
    scalar& rho,
    scalar& slope
) const
{
    // F(rho) = m e(rho, P) - e0 + P (m/rho - A) falls: F' = -m c^2/B
    scalar r = rho;
    for (int step = 0; step < 60; ++step)
    {
        const terms t(at(k, r));
        const scalar e = (P - t.A)/t.B, c = c2(t, r, P);
        if (!(c > 0))
        {
            return false;
        }
        const scalar F = s.m*e - s.e0 + P*(s.m/r - s.A);
        scalar change = F*t.B/(s.m*c);
        change = max(-0.5*r, min(change, r));
        r += change;
        if (mag(change) <= 1e-14*r)
        {
            rho = r;
            const scalar theta = s.m/r;
            slope = (1 + t.B/r*(theta - s.A)/theta)/c;
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::mpm::fluidMixture::ofTwo
(
    const label a,
    const label b,
    const share* s,
    const scalar theta
) const
{
    // sum_k w_k (e0_k + P A_k)/(P + p_k) = theta,  w = (gamma - 1)/gamma
    const fluid& f = fluids_[a];
    const fluid& g = fluids_[b];
    const scalar w = 1 - 1/f.gamma, v = 1 - 1/g.gamma;
    const scalar e = w*s[a].e0, A = w*s[a].A;
    const scalar d = v*s[b].e0, B = v*s[b].A;
    const scalar p = f.pInf, q = g.pInf;
    const scalar two = theta - A - B;
    const scalar one = theta*(p + q) - e - d - A*q - B*p;
    const scalar none = theta*p*q - e*q - d*p;
    const scalar root = std::sqrt(max(sqr(one) - 4*two*none, scalar(0)));
    return one > 0 ? -2*none/(one + root) : (root - one)/(2*two);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fluidMixture::fluidMixture
(
    const dictionary& properties,
    const wordList& names
)
{
    for (const word& name : names)
    {
        const dictionary& dict = requiredDict(properties, name);
        fluid f{name, gasThermo::New(dict), 0, 0, 0};
        const gasThermo& thermo = *f.thermo;
        if (!thermo.hasEnergy())
        {
            FatalIOErrorInFunction(dict)
                << "Fluid " << name << " has no energy: its pressure depends"
                << " on the density alone. Fluids that share cells need"
                << " perfectGas or an equationOfState with an energy"
                << " (stiffenedGas in place of Tait: gamma n, pInf K/n - p0)."
                << exit(FatalIOError);
        }
        if (thermo.isGammaLaw())
        {
            f.gamma = thermo.gamma();
        }
        else
        {
            f.rho0 = thermo.equation().rho0();
            thermo.equation().isStiffened(f.gamma, f.pInf);
        }
        fluids_.append(new fluid(std::move(f)));
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fluidMixture::states
(
    const label k,
    const label n,
    const scalar* rho,
    const scalar* p,
    scalar* K,
    scalar* rhoE,
    scalar* strength
) const
{
    const fluid& f = fluids_[k];
    if (f.gamma > 0)
    {
        const scalar iGm1 = 1/(f.gamma - 1);
        for (label i = 0; i < n; ++i)
        {
            strength[i] = p[i] + f.pInf;
            K[i] = f.gamma*strength[i];
            rhoE[i] = (p[i] + f.gamma*f.pInf)*iGm1;
        }
        return;
    }
    for (label i = 0; i < n; ++i)
    {
        const terms t(at(k, rho[i]));
        K[i] = rho[i]*c2(t, rho[i], p[i]);
        rhoE[i] = energy(t, rho[i], p[i]);
        strength[i] = K[i]/(1 + t.B/rho[i]);
    }
}


void Foam::mpm::fluidMixture::pressures
(
    const label k,
    const label n,
    const scalar* rho,
    const scalar* e,
    scalar* p,
    scalar* c2,
    scalar* strength
) const
{
    const fluid& f = fluids_[k];
    if (f.gamma > 0)
    {
        for (label i = 0; i < n; ++i)
        {
            p[i] = (f.gamma - 1)*rho[i]*e[i] - f.gamma*f.pInf;
            strength[i] = p[i] + f.pInf;
            c2[i] = f.gamma*strength[i]/rho[i];
        }
        return;
    }
    for (label i = 0; i < n; ++i)
    {
        const terms t(at(k, rho[i]));
        p[i] = t.A + t.B*e[i];
        c2[i] = t.dA + e[i]*t.dB + p[i]*t.B/sqr(rho[i]);
        strength[i] = rho[i]*c2[i]/(1 + t.B/rho[i]);
    }
}


Foam::scalar Foam::mpm::fluidMixture::pressure
(
    const scalar* theta,
    const scalar* m,
    const scalar energy
) const
{
    scalar above = energy, below = 0;
    forAll(fluids_, k)
    {
        if (m[k] > 0)
        {
            const scalar rho = m[k]/theta[k];
            const terms t(at(k, rho));
            const scalar w = theta[k]*rho/t.B;
            above += w*t.A;
            below += w;
        }
    }
    return above/below;
}


Foam::mpm::fluidMixture::moduli Foam::mpm::fluidMixture::at
(
    const scalar* theta,
    const scalar* m,
    const scalar p
) const
{
    moduli all{0, 0, 0, GREAT};
    scalar volume = 0, soft = 0;
    forAll(fluids_, k)
    {
        if (m[k] > 0)
        {
            const scalar rho = m[k]/theta[k];
            const terms t(at(k, rho));
            const scalar c = c2(t, rho, p);
            all.frozen += m[k]*c;
            all.energy += theta[k]*energy(t, rho, p);
            all.strength = min(all.strength, rho*c/(1 + t.B/rho));
            soft += theta[k]/(rho*c);
            volume += theta[k];
        }
    }
    all.frozen /= volume;
    all.wood = volume/soft;
    return all;
}


Foam::scalar Foam::mpm::fluidMixture::relax
(
    const share* s,
    const scalar theta,
    const scalar guess,
    scalar* rho,
    scalar* thetas
) const
{
    label n = 0, first = -1, second = -1;
    bool stiff = true;
    scalar lowest = -GREAT;
    forAll(fluids_, k)
    {
        thetas[k] = 0;
        if (s[k].m > 0)
        {
            second = first < 0 ? second : k;
            first = first < 0 ? k : first;
            stiff = stiff && isStiff(k);
            lowest = isStiff(k) ? max(lowest, -fluids_[k].pInf) : lowest;
            ++n;
        }
    }

    scalar P = guess;
    if (n == 2 && stiff)
    {
        P = ofTwo(first, second, s, theta);
    }
    scalar low = lowest, high = GREAT;
    scalar sum = 0;
    for (int step = 0; step < 100; ++step)
    {
        scalar slope = 0;
        sum = 0;
        bool found = P > lowest;
        for (label k = 0; found && k < size(); ++k)
        {
            if (!(s[k].m > 0))
            {
                continue;
            }
            const fluid& f = fluids_[k];
            if (f.gamma > 0)
            {
                const scalar w = 1 - 1/f.gamma;
                thetas[k] = w*(s[k].e0 + P*s[k].A)/(P + f.pInf);
                slope += (w*s[k].A - thetas[k])/(P + f.pInf);
            }
            else
            {
                scalar of = 0;
                found = density(k, s[k], P, rho[k], of);
                thetas[k] = s[k].m/rho[k];
                slope -= thetas[k]/rho[k]*of;
            }
            sum += thetas[k];
        }
        if (n == 2 && stiff)
        {
            break;
        }

        // More volume than there is: the pressure must rise
        const bool tooMuch = !found || sum > theta;
        (tooMuch ? low : high) = P;
        if (found && mag(sum - theta) <= 1e-13*theta)
        {
            break;
        }
        scalar next = found && slope < 0 ? P + (theta - sum)/slope : GREAT;
        if (!(next > low && next < high))
        {
            next =
                high < GREAT
              ? (low > -GREAT ? 0.5*(low + high) : high - 2*(mag(high) + 1))
              : P + 2*(mag(P) + 1);
        }
        if (next == P)
        {
            break;
        }
        P = next;
    }

    // What is left is rounding
    forAll(fluids_, k)
    {
        if (s[k].m > 0)
        {
            thetas[k] *= theta/sum;
            rho[k] = s[k].m/thetas[k];
        }
    }
    return P;
}


Foam::string Foam::mpm::fluidMixture::description(const label k) const
{
    return fluids_[k].thermo->description();
}

// ************************************************************************* //
