// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "farField.H"
#include "mixedFvPatchFields.H"
#include "farFieldFvPatchField.H"

// * * * * * * * * * * * * * * * * * Medium  * * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- log of K(p)/K along an isentrope
scalar logRatio(const mpm::farField::medium::part& a, const scalar dp)
{
    return std::log(max(1 + a.n * dp / a.K, 1e-3));
}

}

Foam::scalar Foam::mpm::farField::medium::rho(const label k, const scalar at) const
{
    const part& a = parts[k];
    return a.rho * std::exp(logRatio(a, at - p) / a.n);
}

Foam::scalar Foam::mpm::farField::medium::rho(const scalar at) const
{
    scalar volume = 0;
    for (label k = 0; k < size; ++k)
    {
        volume += parts[k].Y / rho(k, at);
    }
    return 1 / volume;
}

Foam::scalar Foam::mpm::farField::medium::softness(const scalar at) const
{
    scalar sum = 0;
    for (label k = 0; k < size; ++k)
    {
        const part& a = parts[k];
        const scalar r = logRatio(a, at - p);
        sum += a.Y / (a.rho * a.K) * std::exp(-r * (1 + 1 / a.n));
    }
    return sum;
}

Foam::scalar Foam::mpm::farField::medium::impedance(const scalar pFar, const scalar pL) const
{
    const scalar dp = pL - pFar;
    const part& a = parts[0];
    if (outside && size == 1 && dp > 0)
    {
        return std::sqrt(a.rho * (a.K + 0.5 * (a.n + 1) * dp));
    }
    if (mag(dp) <= 1e-12 * a.K)
    {
        return 1 / std::sqrt(softness(pL));
    }

    if (size == 1)
    {
        // u = 2/(n - 1) (c - c_inf), n = 1: c log
        const scalar e = 0.5 * (a.n - 1) / a.n;
        const auto c = [&](const scalar at)
        {
            const scalar r = logRatio(a, at - p);
            return (mag(e) < 1e-9 ? r : std::expm1(e * r) / e) / a.n;
        };
        return dp / ((c(pL) - c(pFar)) * std::sqrt(a.K / a.rho));
    }

    // Gauss' rule, half of it
    constexpr scalar x[] = {0, 0.538469310105683, 0.906179845938664};
    constexpr scalar w[] = {0.568888888888889, 0.478628670499366, 0.236926885056189};
    const scalar middle = 0.5 * (pL + pFar);
    scalar sum = w[0] * std::sqrt(softness(middle));
    for (label j = 1; j < 3; ++j)
    {
        sum += w[j] * std::sqrt(softness(middle + 0.5 * dp * x[j]));
        sum += w[j] * std::sqrt(softness(middle - 0.5 * dp * x[j]));
    }
    return 2 / sum;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::farField::farField(const volVectorField& U, const volScalarField& p) :
    mesh_(p.mesh()), layer_(mesh_), hasLayers_(false)
{
    DynamicList<face> faces;
    forAll(p.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const bool ofP = isA<farFieldFvPatchField<scalar>>(p.boundaryField()[patchi]);
        const bool ofU = isA<farFieldFvPatchField<vector>>(U.boundaryField()[patchi]);
        if (ofP != ofU)
        {
            const regIOobject &first = p, &second = U;
            const regIOobject& has = ofP ? first : second;
            const regIOobject& lacks = ofP ? second : first;
            FatalErrorInFunction << "Patch " << patch.name() << " has the condition farField in "
                                 << has.name() << " but not in " << lacks.name()
                                 << "; both have it or none." << nl << "    Write  " << patch.name()
                                 << " { type farField; value uniform "
                                 << (ofP ? "(0 0 0)" : Foam::name(p.size() ? p[0] : 0).c_str())
                                 << "; }  in " << lacks.objectPath() << ", or another condition in "
                                 << has.objectPath()
                                 << " (a file of time 0 that is not there has none)."
                                 << exit(FatalError);
        }
        if (!ofP)
        {
            continue;
        }
        const auto& pf = refCast<const farFieldFvPatchField<scalar>>(p.boundaryField()[patchi]);
        hasLayers_ = hasLayers_ || pf.layer() > 0;
        forAll(patch, i)
        {
            const label f = patch.start() + i;
            const vector& S = mesh_.faceAreas()[f];
            const vector n(S / mag(S));
            scalar cosine = 1;
            if (pf.hasSource())
            {
                const vector d(mesh_.faceCentres()[f] - pf.source());
                cosine = max((d & n) / max(mag(d), VSMALL), scalar(0.2));
            }
            faces.append({f, patchi, i, n, cosine});
        }
    }
    faces_.transfer(faces);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::farField::setValues(
    const UList<gasState>& W, const vector& g, volVectorField& U, volScalarField& p)
{
    forAll(p.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!isA<farFieldFvPatchField<scalar>>(p.boundaryField()[patchi]))
        {
            continue;
        }
        scalarField& pFar =
            refCast<farFieldFvPatchField<scalar>>(p.boundaryFieldRef()[patchi]).far();
        vectorField& uFar =
            refCast<farFieldFvPatchField<vector>>(U.boundaryFieldRef()[patchi]).far();
        const bool setP = pFar.empty(), setU = uFar.empty();
        pFar.setSize(patch.size());
        uFar.setSize(patch.size());
        forAll(patch, i)
        {
            const label c = patch.faceCells()[i];
            if (setP)
            {
                const vector d(patch.Cf()[i] - mesh_.cellCentres()[c]);
                pFar[i] = W[c].p + W[c].rho * (g & d);
            }
            if (setU)
            {
                uFar[i] = W[c].u;
            }
        }
    }

    p_.setSize(faces_.size());
    u_.setSize(faces_.size());
    forAll(faces_, i)
    {
        const face& a = faces_[i];
        p_[i] = refCast<const farFieldFvPatchField<scalar>>(p.boundaryField()[a.patch]).far()[a.i];
        u_[i] = refCast<const farFieldFvPatchField<vector>>(U.boundaryField()[a.patch]).far()[a.i];
    }

    DynamicList<farLayer::panel> panels;
    forAll(faces_, i)
    {
        const face& a = faces_[i];
        const scalar layer =
            refCast<const farFieldFvPatchField<scalar>>(p.boundaryField()[a.patch]).layer();
        if (layer > 0)
        {
            const point& centre = mesh_.faceCentres()[a.f];
            scalar radius = 0;
            for (const label v : mesh_.faces()[a.f])
            {
                radius = max(radius, mag(mesh_.points()[v] - centre));
            }
            panels.append({centre, a.n, radius, layer, u_[i] & a.n});
        }
    }
    layer_.set(panels);
}

void Foam::mpm::farField::warnOfPressure(const UList<gasState>& W, const volScalarField& p) const
{
    DynamicList<word> patches;
    scalar value = 0, cells = 0;
    forAll(p.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!isA<farFieldFvPatchField<scalar>>(p.boundaryField()[patchi]))
        {
            continue;
        }
        const scalarField& far =
            refCast<const farFieldFvPatchField<scalar>>(p.boundaryField()[patchi]).far();
        scalar low = GREAT, high = -GREAT;
        for (const label c : patch.faceCells())
        {
            low = min(low, W[c].p);
            high = max(high, W[c].p);
        }
        reduce(low, minOp<scalar>());
        reduce(high, maxOp<scalar>());
        const scalar least = gMin(far), most = gMax(far);
        const bool below = 1000 * most < low;
        if (low > 0 && high > -GREAT && (below || least > 1000 * high))
        {
            patches.append(patch.name());
            value = below ? most : least;
            cells = below ? low : high;
        }
    }
    if (patches.size())
    {
        WarningInFunction << "The farField of " << p.objectPath() << " on patch " << patches[0]
                          << (patches.size() > 1 ? " and others" : "") << " has the farValue "
                          << value << " Pa, but the cells there start with " << cells
                          << " Pa: a wave"
                          << " of that difference will run in. 1 bar is 1e5 Pa; without"
                          << " farValue it is the pressure of the cells." << endl;
    }
}

Foam::mpm::farField::state
Foam::mpm::farField::at(const label i, const gasState& L, const scalar zL, const medium& of) const
{
    const vector& n = faces_[i].n;
    const scalar uL = L.u & n, uFar = u_[i] & n, pFar = p_[i];
    const scalar c = zL / L.rho;
    state s;
    if (uL >= c)
    {
        s.u = uL;
        s.p = L.p;
    }
    else if (uFar <= -c)
    {
        s.u = uFar;
        s.p = pFar;
    }
    else
    {
        const scalar zR = of.impedance(pFar, L.p) / faces_[i].cosine;
        const scalar sum = zL + zR;
        s.u = (zL * uL + zR * uFar + (L.p - pFar)) / sum;
        s.p = (zR * L.p + zL * pFar + zL * zR * (uL - uFar)) / sum;
    }
    s.behind.p = s.p;
    s.behind.u = s.u > 0 ? L.u + (s.u - uL) * n : u_[i] + (s.u - uFar) * n;
    s.behind.rho = of.rho(s.p);
    return s;
}

bool Foam::mpm::farField::fixes(const fvPatchScalarField& condition)
{
    return condition.fixesValue() && !isA<mixedFvPatchScalarField>(condition);
}
