// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fluidMixture.H"
#include "dictionaryTools.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::fluidMixture::touch(
    const label k, const share& s, const scalar theta, touching& t, scalar& P) const
{
    const fluid& f = fluids_[k];
    if (f.gamma > 0)
    {
        const scalar w = 1 - 1 / f.gamma;
        t = {w * s.A, w * (s.e0 - f.pInf * s.A), f.pInf};
        P = t.C / (theta - t.least) - f.pInf;
        return t.C > 0;
    }
    const scalar rho = s.m / theta;
    const terms c(at(k, rho, s.F));
    const scalar Gamma = c.B / rho;
    const scalar below = theta + Gamma * (theta - s.A);
    if (!(below > 0))
    {
        P = GREAT;
        return false;
    }
    P = (Gamma * s.e0 + theta * c.A) / below;
    const scalar strength = rho * c2(c, rho, P) / (1 + Gamma);
    t.least = Gamma / (1 + Gamma) * s.A;
    t.C = (theta - t.least) * strength;
    t.pInf = strength - P;
    return strength > 0;
}

bool Foam::mpm::fluidMixture::pressureOf(
    const touching* t, const share* s, const scalar theta, scalar& P) const
{
    scalar room = theta;
    forAll(fluids_, k)
    {
        room -= s[k].m > 0 ? t[k].least : 0;
    }
    if (!(room > 0))
    {
        return false;
    }

    // No fluid takes more than the room of all: a lower bound
    P = -GREAT;
    forAll(fluids_, k)
    {
        P = s[k].m > 0 ? max(P, t[k].C / room - t[k].pInf) : P;
    }
    for (int step = 0; step < 100; ++step)
    {
        scalar excess = -room, slope = 0;
        forAll(fluids_, k)
        {
            if (s[k].m > 0)
            {
                const scalar v = t[k].C / (P + t[k].pInf);
                excess += v;
                slope += v / (P + t[k].pInf);
            }
        }
        const scalar next = P + excess / slope;
        if (!(excess > 1e-15 * theta) || next == P)
        {
            break;
        }
        P = next;
    }
    return P > -GREAT && P < GREAT;
}

bool Foam::mpm::fluidMixture::volumeOf(
    const label k, const share& s, const scalar P, scalar& theta, touching& t, label& looks) const
{
    if (isStiff(k))
    {
        scalar own;
        const bool found = touch(k, s, theta, t, own) && P + t.pInf > 0;
        theta = t.least + t.C / (P + t.pInf);
        return found;
    }
    scalar low = 0, high = GREAT;
    for (int step = 0; step < 200; ++step)
    {
        scalar own;
        ++looks;
        const bool found = touch(k, s, theta, t, own);

        // More pressure than outside: it expands
        (own > P ? low : high) = theta;
        scalar next = own > P ? 4 * theta : 0.25 * theta;
        if (found)
        {
            next = P + t.pInf > 0 ? max(0.25 * theta, min(4 * theta, t.least + t.C / (P + t.pInf)))
                                  : next;
            if (mag(next - theta) <= 1e-14 * theta)
            {
                return true;
            }
        }
        if (!(next > low && next < high))
        {
            next = low > 0 ? std::sqrt(low) * std::sqrt(high) : 0.25 * high;
        }
        if (next <= low || next >= high)
        {
            return found;
        }
        theta = next;
    }
    return false;
}

bool Foam::mpm::fluidMixture::enclose(
    const share* s, const scalar theta, scalar& P, scalar* thetas, label& looks) const
{
    FixedList<touching, most> t;
    scalar low = -GREAT, high = GREAT;
    forAll(fluids_, k)
    {
        if (s[k].m > 0)
        {
            thetas[k] = s[k].A;
            low = isStiff(k) ? max(low, -fluids_[k].pInf) : low;
        }
    }
    P = P > low && P < high ? P : max(low, scalar(0)) + 1;
    for (int step = 0; step < 400; ++step)
    {
        bool found = true;
        scalar sum = 0;
        for (label k = 0; found && k < size(); ++k)
        {
            if (s[k].m > 0)
            {
                scalar part = thetas[k];
                found = volumeOf(k, s[k], P, part, t[k], looks);
                thetas[k] = found ? part : s[k].A;
                sum += thetas[k];
            }
        }
        if (found && mag(sum - theta) <= 1e-14 * theta)
        {
            return true;
        }

        // More volume than there is: the pressure must rise
        (!found || sum > theta ? low : high) = P;
        scalar next = GREAT;
        if (!found || !pressureOf(t.begin(), s, theta, next))
        {
            next = GREAT;
        }
        if (!(next > low && next < high))
        {
            next = high == GREAT            ? P + 2 * (mag(P) + 1)
                : low == -GREAT             ? high - 2 * (mag(high) + 1)
                : low > 0 && high > 4 * low ? std::sqrt(low) * std::sqrt(high)
                                            : 0.5 * (low + high);
        }
        if (next <= low || next >= high)
        {
            return found;
        }
        P = next;
    }
    return false;
}

Foam::scalar Foam::mpm::fluidMixture::ofTwo(
    const label a, const label b, const share* s, const scalar theta) const
{
    // sum_k w_k (e0_k + P A_k)/(P + p_k) = theta,  w = (gamma - 1)/gamma
    const fluid& f = fluids_[a];
    const fluid& g = fluids_[b];
    const scalar w = 1 - 1 / f.gamma, v = 1 - 1 / g.gamma;
    const scalar e = w * s[a].e0, A = w * s[a].A;
    const scalar d = v * s[b].e0, B = v * s[b].A;
    const scalar p = f.pInf, q = g.pInf;
    const scalar two = theta - A - B;
    const scalar one = theta * (p + q) - e - d - A * q - B * p;
    const scalar none = theta * p * q - e * q - d * p;
    const scalar root = std::sqrt(max(sqr(one) - 4 * two * none, scalar(0)));
    return one > 0 ? -2 * none / (one + root) : (root - one) / (2 * two);
}

Foam::mpm::fluidMixture::torn Foam::mpm::fluidMixture::leastOf(const fluid& f) const
{
    scalar K = f.gamma * f.pInf, rho = f.rho0;
    if (!(f.gamma > 0) && rho > 0)
    {
        const terms t(f.law.valid() ? f.law->at(rho, 1) : f.thermo->equation().at(rho));
        K = rho * c2(t, rho, 1e5);
    }
    if (!(K > 0 && rho > 0))
    {
        return {0, 0};
    }
    return {1e-6 * K / rho, std::sqrt(K / rho)};
}

inline void Foam::mpm::fluidMixture::tear(
    const fluid& f, const scalar rho, const scalar e, scalar& p, scalar& c2, scalar& strength)
{
    if (f.least.tears(rho, p, strength) && rho > 0 && mag(e) < GREAT)
    {
        p = max(p, f.least.p(rho));
        c2 = f.least.c2;
        strength = rho * c2;
    }
}

bool Foam::mpm::fluidMixture::anyVolumes(
    const share* s, const scalar theta, scalar& P, scalar* thetas) const
{
    FixedList<touching, most> t;
    scalar own = 0, full = 0, most = 0, largest = 0;
    forAll(fluids_, k)
    {
        t[k] = {0, 0, 0};
        if (s[k].m > 0 && !touch(k, s[k], s[k].A, t[k], own))
        {
            const torn& l = fluids_[k].least;
            const scalar rho = s[k].m / s[k].A;
            const scalar p = mag(own) < 0.1 * GREAT ? max(own, l.p(rho)) : l.p(rho);
            const scalar stiff = max(rho * l.c2, p);
            t[k] = {0, s[k].A * stiff, stiff - p};
        }
        full += t[k].least;
        if (s[k].m > 0 && s[k].A > largest)
        {
            largest = s[k].A;
            most = t[k].C / (s[k].A - t[k].least) - t[k].pInf;
        }
    }
    const scalar shrink = min(0.9 * theta / max(full, VSMALL), 1.0);
    forAll(fluids_, k)
    {
        t[k].least *= shrink;
    }
    if (!pressureOf(t.begin(), s, theta, P))
    {
        // Traces whose pressure the largest does not see
        P = most;
        forAll(fluids_, k)
        {
            thetas[k] = s[k].m > 0 ? s[k].A : 0;
        }
        return mag(P) < GREAT;
    }
    bool finite = true;
    forAll(fluids_, k)
    {
        thetas[k] = s[k].m > 0 ? max(t[k].least + t[k].C / (P + t[k].pInf), 0.1 * s[k].A) : 0;
        finite = finite && thetas[k] >= 0 && thetas[k] < GREAT;
    }
    return finite;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fluidMixture::fluidMixture(const dictionary& properties, const wordList& names)
{
    if (names.size() > most)
    {
        FatalIOErrorInFunction(properties)
            << "There are " << names.size() << " phases of type fluid; at most " << most
            << " may share cells." << exit(FatalIOError);
    }
    for (const word& name : names)
    {
        const dictionary& dict = requiredDict(properties, name);
        fluid f{name, gasThermo::New(dict), 0, 0, 0, nullptr, {0, 0}};
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
        if (dict.found("detonation"))
        {
            const dictionary& law = requiredDict(dict, "detonation");
            if (thermo.isGammaLaw())
            {
                FatalIOErrorInFunction(law)
                    << "Fluid " << name << " is a gas of thermo " << thermo.type()
                    << ": only one with an equationOfState of"
                    << " the products of an explosive (JWL) can detonate." << exit(FatalIOError);
            }
            f.law = detonation::New(law, thermo.equation());
        }
        f.least = leastOf(f);
        fluids_.append(new fluid(std::move(f)));
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::fluidMixture::tears() const
{
    bool one = false;
    for (const fluid& f : fluids_)
    {
        one = one || f.least.c2 > 0;
    }
    return one;
}

void Foam::mpm::fluidMixture::states(
    const label k, const label n, const scalar* rho, const scalar* p, scalar* K, scalar* rhoE,
    scalar* strength, const scalar* F) const
{
    const fluid& f = fluids_[k];
    if (f.gamma > 0)
    {
        const scalar iGm1 = 1 / (f.gamma - 1);
        for (label i = 0; i < n; ++i)
        {
            strength[i] = p[i] + f.pInf;
            K[i] = f.gamma * strength[i];
            rhoE[i] = (p[i] + f.gamma * f.pInf) * iGm1;
        }
        return;
    }
    for (label i = 0; i < n; ++i)
    {
        const terms t(F ? at(k, rho[i], F[i]) : at(k, rho[i]));
        K[i] = rho[i] * c2(t, rho[i], p[i]);
        rhoE[i] = energy(t, rho[i], p[i]);
        strength[i] = K[i] / (1 + t.B / rho[i]);
    }
}

void Foam::mpm::fluidMixture::pressures(
    const label k, const label n, const scalar* rho, const scalar* e, scalar* p, scalar* c2,
    scalar* strength, const scalar* F) const
{
    const fluid& f = fluids_[k];
    if (f.gamma > 0)
    {
        scalar least = GREAT;
        for (label i = 0; i < n; ++i)
        {
            p[i] = (f.gamma - 1) * rho[i] * e[i] - f.gamma * f.pInf;
            strength[i] = p[i] + f.pInf;
            c2[i] = f.gamma * strength[i] / rho[i];
            least = min(least, p[i]);
        }
        for (label i = 0; f.least.c2 > 0 && !(least > 0) && i < n; ++i)
        {
            tear(f, rho[i], e[i], p[i], c2[i], strength[i]);
        }
        return;
    }
    for (label i = 0; i < n; ++i)
    {
        const terms t(F ? at(k, rho[i], F[i]) : at(k, rho[i]));
        p[i] = t.A + t.B * e[i];
        c2[i] = t.dA + e[i] * t.dB + p[i] * t.B / sqr(rho[i]);
        strength[i] = rho[i] * c2[i] / (1 + t.B / rho[i]);
        if (f.least.c2 > 0)
        {
            tear(f, rho[i], e[i], p[i], c2[i], strength[i]);
        }
    }
}

Foam::scalar Foam::mpm::fluidMixture::pressure(
    const scalar* theta, const scalar* m, const scalar energy, const scalar* F) const
{
    scalar above = energy, below = 0;
    forAll(fluids_, k)
    {
        if (m[k] > 0)
        {
            const scalar rho = m[k] / theta[k];
            const terms t(F ? at(k, rho, F[k]) : at(k, rho));
            const scalar w = theta[k] * rho / t.B;
            above += w * t.A;
            below += w;
        }
    }
    return above / below;
}

Foam::mpm::fluidMixture::moduli Foam::mpm::fluidMixture::at(
    const scalar* theta, const scalar* m, const scalar p, const scalar* F) const
{
    moduli all{0, 0, 0, GREAT, 0, 0, 0, false};
    scalar volume = 0, soft = 0, mass = 0;
    forAll(fluids_, k)
    {
        if (m[k] > 0)
        {
            const scalar rho = m[k] / theta[k];
            const terms t(F ? at(k, rho, F[k]) : at(k, rho));
            const scalar least = fluids_[k].least.c2;
            scalar c = c2(t, rho, p);
            if (!(c > 0) && least > 0)
            {
                c = least;
                all.torn = true;
            }
            all.frozen += m[k] * c;
            all.energy += theta[k] * energy(t, rho, p);
            all.strength = min(all.strength, rho * c / (1 + t.B / rho));
            const scalar wet = liquid(rho * c, p);
            all.liquid += m[k] * wet;
            all.store += wet * theta[k] * rho * c / (1 + t.B / rho) * rho / t.B;
            all.stiffest = max(all.stiffest, rho * c);
            soft += theta[k] / (rho * c);
            volume += theta[k];
            mass += m[k];
        }
    }
    all.frozen /= volume;
    all.wood = volume / soft;
    all.liquid /= mass;
    return all;
}

Foam::scalar Foam::mpm::fluidMixture::relax(
    const share* s, const scalar theta, scalar* thetas, label* looks, bool* common,
    const bool any) const
{
    label n = 0, first = -1, second = -1, others = 0, evaluations = 0;
    FixedList<touching, most> t;
    scalar own;
    bool found = true;
    forAll(fluids_, k)
    {
        thetas[k] = s[k].m > 0 ? s[k].A : 0;
        if (s[k].m > 0)
        {
            second = first < 0 ? second : k;
            first = first < 0 ? k : first;
            others += !isStiff(k);
            found = found && (!isStiff(k) || touch(k, s[k], s[k].A, t[k], own));
            ++n;
        }
    }

    scalar P = 0;
    if (n == 2 && others == 0)
    {
        P = ofTwo(first, second, s, theta);

        // Not in less volume than they have at endless pressure
        found = t[first].least + t[second].least < theta;
    }
    bool done = false;
    for (int step = 0; found && !done && step < 30; ++step)
    {
        for (label k = 0; others && found && k < size(); ++k)
        {
            if (s[k].m > 0 && !isStiff(k))
            {
                ++evaluations;
                found = touch(k, s[k], thetas[k], t[k], own);
            }
        }
        if (n != 2 || others)
        {
            found = found && pressureOf(t.begin(), s, theta, P);
        }
        done = true;
        for (label k = 0; found && k < size(); ++k)
        {
            if (s[k].m > 0)
            {
                const scalar next = t[k].least + t[k].C / (P + t[k].pInf);
                scalar& now = thetas[k];
                const bool small = isStiff(k) || mag(next - now) <= 1e-8 * now;
                now = small ? next : max(0.25 * now, min(4 * now, next));
                done = done && small;
            }
        }
    }
    if (!done || !found)
    {
        done = enclose(s, theta, P, thetas, evaluations);
    }
    bool finite = mag(P) < GREAT;
    forAll(fluids_, k)
    {
        finite = finite && mag(thetas[k]) < GREAT;
    }
    if (any && (!done || !finite))
    {
        done = anyVolumes(s, theta, P, thetas);
    }
    if (common)
    {
        *common = done;
    }

    // What is left is rounding
    scalar sum = 0;
    forAll(fluids_, k)
    {
        sum += thetas[k];
    }
    forAll(fluids_, k)
    {
        thetas[k] *= theta / sum;
    }
    if (looks)
    {
        *looks = evaluations;
    }
    return P;
}

Foam::string Foam::mpm::fluidMixture::description(const label k) const
{
    const fluid& f = fluids_[k];
    string words(f.thermo->description());
    if (f.law.valid())
    {
        words += ", " + f.law->description();
    }
    return words;
}
