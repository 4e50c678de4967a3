// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fluidMixture.H"
#include "dictionaryTools.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::fluidMixture::touch(
    const label k, const share& s, const scalar theta, touching& t, scalar& P) const
{
    if (isStiff(k))
    {
        t = touchOf(k, s);
        P = t.C / (theta - t.least) - t.pInf;
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
            low = isStiff(k) ? max(low, -stiff_[k].pInf) : low;
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

inline Foam::scalar
Foam::mpm::fluidMixture::ofTwo(const touching& a, const touching& b, const scalar theta)
{
    // sum_k least_k + C_k/(P + pInf_k) = theta
    const scalar room = theta - a.least - b.least;
    const scalar one = room * (a.pInf + b.pInf) - a.C - b.C;
    const scalar none = room * a.pInf * b.pInf - a.C * b.pInf - b.C * a.pInf;
    const scalar root = std::sqrt(max(sqr(one) - 4 * room * none, scalar(0)));
    return one > 0 ? -2 * none / (one + root) : (root - one) / (2 * room);
}

Foam::mpm::fluidMixture::torn Foam::mpm::fluidMixture::leastOf(const fluid& f, const stiffened& s)
{
    scalar K = s.gamma * s.pInf, rho = f.rho0;
    if (!(s.gamma > 0) && rho > 0)
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
        fluid f{name, gasThermo::New(dict), 0, nullptr, nullptr, {0, 0}};
        stiffened s;
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
            s.gamma = thermo.gamma();
        }
        else
        {
            f.rho0 = thermo.equation().rho0();
            thermo.equation().isStiffened(s.gamma, s.pInf);
        }
        const bool burns = dict.found("detonation"), on = dict.found("afterburn");
        if ((burns || on) && thermo.isGammaLaw())
        {
            FatalIOErrorInFunction(dict)
                << "Fluid " << name << " is a gas of thermo " << thermo.type()
                << ": only one with an equationOfState of the products of an explosive (JWL)"
                << " can detonate or burn on." << exit(FatalIOError);
        }
        if (burns)
        {
            f.law = detonation::New(requiredDict(dict, "detonation"), thermo.equation());
        }
        if (on)
        {
            f.on = afterburn::New(requiredDict(dict, "afterburn"), thermo.equation());
        }
        s.set();
        f.least = leastOf(f, s);
        stiff_.append(s);
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
    if (isStiff(k))
    {
        const stiffened s(stiff_[k]);
        for (label i = 0; i < n; ++i)
        {
            strength[i] = p[i] + s.pInf;
            K[i] = s.K(p[i]);
            rhoE[i] = s.energy(p[i]);
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
    if (isStiff(k))
    {
        const stiffened s(stiff_[k]);
        scalar least = GREAT;
        for (label i = 0; i < n; ++i)
        {
            p[i] = (s.gamma - 1) * rho[i] * e[i] - s.gamma * s.pInf;
            strength[i] = p[i] + s.pInf;
            c2[i] = s.gamma * strength[i] / rho[i];
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
        if (m[k] > 0 && isStiff(k))
        {
            const scalar w = theta[k] * stiff_[k].iGm1;
            above -= w * stiff_[k].gamma * stiff_[k].pInf;
            below += w;
        }
        else if (m[k] > 0)
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

inline void Foam::mpm::fluidMixture::addModuli(
    moduli& all, const scalar theta, const scalar m, const scalar K, const scalar strength,
    const scalar iGamma, const scalar energy, const scalar p, scalar& soft)
{
    const scalar wet = liquid(K, p);
    all.frozen += theta * K;
    all.energy += theta * energy;
    all.strength = min(all.strength, strength);
    all.liquid += m * wet;
    all.store += wet * theta * strength * iGamma;
    all.stiffest = max(all.stiffest, K);
    soft += theta / K;
}

Foam::mpm::fluidMixture::moduli Foam::mpm::fluidMixture::at(
    const scalar* theta, const scalar* m, const scalar p, const scalar* F) const
{
    moduli all{0, 0, 0, GREAT, 0, 0, 0, false};
    scalar volume = 0, soft = 0, mass = 0;
    for (label k = 0; k < stiff_.size(); ++k)
    {
        if (!(m[k] > 0))
        {
            continue;
        }
        const stiffened& s = stiff_[k];
        if (s.gamma > 0 && p + s.pInf > 0)
        {
            const scalar strength = p + s.pInf;
            addModuli(
                all, theta[k], m[k], s.gamma * strength, strength, s.iGm1, s.energy(p), p, soft);
        }
        else
        {
            const scalar rho = m[k] / theta[k];
            const terms t(F ? at(k, rho, F[k]) : at(k, rho));
            const scalar least = fluids_[k].least.c2, iGamma = rho / t.B;
            scalar c = c2(t, rho, p);
            if (!(c > 0) && least > 0)
            {
                c = least;
                all.torn = true;
            }
            addModuli(
                all, theta[k], m[k], rho * c, rho * c / (1 + t.B / rho), iGamma, energy(t, rho, p),
                p, soft);
        }
        volume += theta[k];
        mass += m[k];
    }
    all.frozen /= volume;
    all.wood = volume / soft;
    all.liquid /= mass;
    return all;
}

bool Foam::mpm::fluidMixture::relaxPair(
    const share* s, const scalar theta, scalar& P, scalar* thetas) const
{
    const touching a(touchOf(0, s[0])), b(touchOf(1, s[1]));
    P = ofTwo(a, b, theta);
    if (!(a.least + b.least < theta && mag(P) < GREAT))
    {
        // Not in less volume than they have at endless pressure
        return false;
    }
    thetas[0] = a.least + a.C / (P + a.pInf);
    thetas[1] = b.least + b.C / (P + b.pInf);

    // What is left is rounding
    const scalar all = theta / (thetas[0] + thetas[1]);
    thetas[0] *= all;
    thetas[1] *= all;
    return mag(thetas[0]) < GREAT && mag(thetas[1]) < GREAT;
}

Foam::scalar Foam::mpm::fluidMixture::relax(
    const share* s, const scalar theta, scalar* thetas, label* looks, bool* common,
    const bool any) const
{
    scalar P = 0;
    if (isPair() && s[0].m > 0 && s[1].m > 0 && relaxPair(s, theta, P, thetas))
    {
        if (common)
        {
            *common = true;
        }
        if (looks)
        {
            *looks = 0;
        }
        return P;
    }
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
            const bool touched = !isStiff(k) || touch(k, s[k], s[k].A, t[k], own);
            found = found && touched;
            ++n;
        }
    }

    if (n == 2 && others == 0)
    {
        P = ofTwo(t[first], t[second], theta);

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
    words += f.law.valid() ? std::string(", " + f.law->description()) : "";
    words += f.on.valid() ? std::string(", " + f.on->description()) : "";
    return words;
}
