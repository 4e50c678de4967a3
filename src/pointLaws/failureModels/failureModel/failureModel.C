// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "failureModel.H"
#include "spectral.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(failureModel, 0);
defineRunTimeSelectionTable(failureModel, dictionary);
}

const Foam::wordList
    Foam::mpm::failureModel::keywords({"type", "failed", "weibull", "ambientPressure"});

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::uniformOf(const uint64_t seed, const uint64_t id)
{
    // Two rounds of a mixing function with full avalanche on 64 bits
    uint64_t z = seed * 0x9e3779b97f4a7c15ULL + id + 1;
    for (int round = 0; round < 2; ++round)
    {
        z ^= z >> 30;
        z *= 0xbf58476d1ce4e5b9ULL;
        z ^= z >> 27;
        z *= 0x94d049bb133111ebULL;
        z ^= z >> 31;
    }
    // 53 bits, centred in their interval: neither 0 nor 1 occurs
    return (scalar(z >> 11) + 0.5) / 9007199254740992.0;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::failureModel::failureModel(const dictionary& dict, const word& limit) :
    strength_(limit.empty() ? 1 : positive(dict, limit)),
    modulus_(0),
    seed_(0),
    referenceVolume_(0),
    ambient_(boundedOrDefault(dict, "ambientPressure", 0, 0, GREAT)),
    nothing_(
        oneOfOrDefault(dict, "failed", "compression", {"compression", "nothing"}) == "nothing"),
    law_(nullptr),
    nHistory_(0),
    strain_(-1),
    strainKind_(noStrain),
    energy_(-1)
{
    if (dict.found("weibull"))
    {
        const dictionary& w = requiredDict(dict, "weibull");
        checkKeywords(w, {"modulus", "seed", "referenceVolume"});
        modulus_ = positive(w, "modulus");
        requireKeyword(w, "seed");
        seed_ = uint64_t(boundedLabelOrDefault(w, "seed", 0, 0, labelMax));
        if (w.found("referenceVolume"))
        {
            referenceVolume_ = positive(w, "referenceVolume");
        }
    }
}

Foam::autoPtr<Foam::mpm::failureModel> Foam::mpm::failureModel::New(const dictionary& dict)
{
    return selectFromTable<failureModel>(dict, dictionaryConstructorTablePtr_, dict);
}

namespace
{

using Foam::scalar;

//- Principal values in the plane of a 2D point's stress + shift I, and half
//  their difference
struct principal2D
{
    scalar radius, high, low;

    principal2D(const Foam::mpm::pointBlock& b, const Foam::label p, const scalar shift)
    {
        const scalar xx = b.stress[0][p], yy = b.stress[1][p];
        const scalar mean = 0.5 * (xx + yy) + shift;
        radius = std::hypot(0.5 * (xx - yy), b.stress[3][p]);
        high = mean + radius;
        low = mean - radius;
    }
};

}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::failureModel::strength(const uint64_t id, const scalar volume) const
{
    if (!scatters())
    {
        return strength_;
    }
    const scalar scale =
        referenceVolume_ > 0 ? std::pow(referenceVolume_ / volume, 1 / modulus_) : 1;
    return strength_ * scale * std::pow(-std::log1p(-uniformOf(seed_, id)), scalar(1) / modulus_);
}

Foam::scalar Foam::mpm::failureModel::largestStress(const pointBlock& b, const label p)
{
    if (b.nDim == 1)
    {
        return max(b.stress[0][p], max(b.stress[1][p], b.stress[2][p]));
    }
    if (b.nDim == 2)
    {
        return max(principal2D(b, p, 0).high, b.stress[2][p]);
    }
    double sigma[9];
    fullStress(b, p, sigma);
    return largestPrincipal(sigma);
}

Foam::scalar
Foam::mpm::failureModel::largestStress(const pointBlock& b, const label p, scalar (&n)[3])
{
    n[0] = n[1] = n[2] = 0;
    if (b.nDim == 3)
    {
        double sigma[9];
        fullStress(b, p, sigma);
        return largestPrincipal(sigma, n);
    }
    const scalar s = largestStress(b, p);
    if (b.nDim == 1)
    {
        n[0] = s == b.stress[0][p];
    }
    else if (s > b.stress[2][p])
    {
        const principal2D q(b, p, 0);
        if (q.radius > 0)
        {
            const scalar c = 0.5 * (b.stress[0][p] - b.stress[1][p]) / q.radius;
            n[0] = std::sqrt(max(0.5 * (1 + c), scalar(0)));
            n[1] = std::sqrt(max(0.5 * (1 - c), scalar(0)));
            if (b.stress[3][p] < 0)
            {
                n[1] = -n[1];
            }
        }
        else
        {
            n[0] = 1;
        }
    }
    return s;
}

void Foam::mpm::failureModel::releaseTension(pointBlock& b, const label p) const
{
    const int D = b.nDim;
    const scalar d = b.damage[p];
    if (D == 2)
    {
        // <A> = A, 0, or high (A - low I)/(high - low)
        const principal2D s(b, p, ambient_);
        const scalar part = s.low >= 0 ? 1 : s.high > 0 ? s.high / (2 * s.radius) : 0;
        const scalar low = s.low < 0 ? s.low : 0;
        for (int i = 0; i < 2; ++i)
        {
            scalar& a = b.stress[i][p];
            a += d * (ambient_ - part * (a + ambient_ - low));
        }
        scalar& across = b.stress[2][p];
        across += d * (ambient_ - max(across + ambient_, scalar(0)));
        b.stress[3][p] *= 1 - d * part;
        return;
    }
    double sigma[9], tension[9];
    fullStress(b, p, sigma);
    for (int i = 0; i < 3; ++i)
    {
        sigma[4 * i] += ambient_;
    }
    isotropicFunction<3>(
        sigma, [](double x) { return x > 0 ? x : 0.0; }, tension);
    for (int i = 0; i < 3; ++i)
    {
        b.stress[i][p] += d * (ambient_ - tension[4 * i]);
    }
    for (int i = 0; i < D; ++i)
    {
        for (int j = i + 1; j < D; ++j)
        {
            b.stress[symmSlot(i, j)][p] -= d * tension[3 * i + j];
        }
    }
}

Foam::scalar Foam::mpm::failureModel::normSquare(const pointBlock& b, const label p)
{
    scalar sum = 0;
    for (int i = 0; i < nStress(b.nDim); ++i)
    {
        sum += (i < 3 ? 1 : 2) * sqr(b.stress[i][p]);
    }
    return sum;
}

Foam::scalar Foam::mpm::failureModel::givenBack(const pointBlock& b, const label p) const
{
    const scalar v = b.volume[p];
    if (strainKind_ == noStrain)
    {
        return v * normSquare(b, p) / (2 * law_->elasticModulus());
    }
    if (strainKind_ == volumetric)
    {
        const scalar tr = b.stress[0][p] + b.stress[1][p] + b.stress[2][p];
        return max(v * tr * b.history[strain_][p] / 6, scalar(0));
    }
    scalar c[9];
    fullTensor(b.history + strain_, b.nDim, p, c);
    if (strainKind_ == stretch)
    {
        scalar h[9];
        isotropicFunction<3>(
            c, [](double x) { return 0.5 * std::log1p(max(x, -1 + SMALL)); }, h);
        std::copy(h, h + 9, c);
    }
    scalar sigma[9], sum = 0;
    fullStress(b, p, sigma);
    for (int i = 0; i < 9; ++i)
    {
        sum += sigma[i] * c[i];
    }
    return max(0.5 * v * sum, scalar(0));
}

void Foam::mpm::failureModel::connect(const constitutiveModel& law, const int nDim)
{
    law_ = &law;
    nHistory_ = law.nColumns(nDim);
    energy_ = law.columnOf("e", nDim);
    shared_.clear();
    for (const word name : {"T", "plasticStrain"})
    {
        if (law.columnOf(name, nDim) >= 0)
        {
            shared_.append(law.columnOf(name, nDim));
        }
    }
    strainKind_ = noStrain;
    const struct
    {
        const char* name;
        decltype(strainKind_) kind;
    } strains[] = {
        {"elasticStrain", logarithmic}, {"leftStretch", stretch}, {"volumeStrain", volumetric}};
    for (const auto& s : strains)
    {
        strain_ = law.columnOf(s.name, nDim);
        if (strain_ >= 0)
        {
            strainKind_ = s.kind;
            break;
        }
    }
}

void Foam::mpm::failureModel::start(pointBlock& b) const
{
    if (energy_ < 0 && shared_.empty())
    {
        return;
    }
    const int N = nStress(b.nDim), n = N + shared_.size() + 2;
    if (before_.size() < n * b.n)
    {
        before_.setSize(n * b.n);
    }
    scalar* to = before_.begin();
    const auto keep = [&](const scalar* from)
    {
        std::copy(from, from + b.n, to);
        to += b.n;
    };
    for (const int c : shared_)
    {
        keep(b.history[c]);
    }
    if (energy_ >= 0)
    {
        for (int i = 0; i < N; ++i)
        {
            keep(b.stress[i]);
        }
        keep(b.history[energy_]);
    }
}

Foam::label Foam::mpm::failureModel::finish(pointBlock& b) const
{
    if (energy_ < 0 && shared_.empty())
    {
        return correct(b);
    }
    const int N = nStress(b.nDim), nShared = shared_.size();
    const scalar* stress = before_.begin() + nShared * b.n;
    const scalar* e = stress + N * b.n;
    scalar* norm = before_.begin() + (nShared + N + 1) * b.n;
    for (label p = 0; p < b.n; ++p)
    {
        norm[p] = normSquare(b, p);
    }
    const label nFailed = correct(b);
    for (label p = 0; p < b.n; ++p)
    {
        if (!released(b.damage[p]))
        {
            continue;
        }
        const scalar part = norm[p] > 0 ? min(std::sqrt(normSquare(b, p) / norm[p]), scalar(1)) : 1;
        for (int i = 0; i < nShared; ++i)
        {
            const scalar a = before_[i * b.n + p];
            scalar& now = b.history[shared_[i]][p];
            now = a + part * (now - a);
        }
        if (energy_ >= 0)
        {
            scalar kept[6];
            for (int i = 0; i < N; ++i)
            {
                kept[i] = b.stress[i][p];
            }
            b.history[energy_][p] = e[p]
                + 0.5
                    * (stressWork(b, p, volumeBefore(b, p), stress + p, b.n)
                       + stressWork(b, p, b.volume[p], kept, 1))
                    / b.mass[p];
        }
    }
    return nFailed;
}

Foam::scalar Foam::mpm::failureModel::storedEnergy(const pointBlock& b) const
{
    if (!law_ || energy_ >= 0)
    {
        return law_ ? law_->strainEnergy(b) : 0;
    }
    scalar sum = 0;
    for (label p = 0; p < b.n;)
    {
        if (released(b.damage[p]))
        {
            sum += min(law_->strainEnergy(b.part(p, 1, nHistory_)), givenBack(b, p));
            ++p;
            continue;
        }
        const label first = p;
        while (p < b.n && !released(b.damage[p]))
        {
            ++p;
        }
        sum += law_->strainEnergy(b.part(first, p - first, nHistory_));
    }
    return sum;
}
