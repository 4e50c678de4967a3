// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::eulerianFluids::isGiven(const dictionary& properties) const
{
    const dictionary& dict = settings(properties);
    if (oneOfOrDefault(dict, "velocity", "computed", wordList({"computed", "given"})) != "given")
    {
        return false;
    }
    const wordList phases(required<wordList>(properties, "phases"));
    if (phases.size() > n_ || mag(g_) > 0)
    {
        FatalIOErrorInFunction(dict)
            << "velocity given is for fluids alone and without gravity, but there "
            << (phases.size() > n_ ? "are phases of points." : "is a file constant/g.")
            << " Valid here: velocity computed." << exit(FatalIOError);
    }
    return true;
}

void Foam::mpm::eulerianFluids::givenFaces()
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const auto set = [&](const label f, const gasState& N)
    {
        const gasState& P = W_[own[f]];
        phi_[f] = 0.5 * ((P.u + N.u) & S_[f]);
        pStar_[f] = 0.5 * (P.p + N.p);
        out_[own[f]] += max(phi_[f], scalar(0));
    };
    for (label f = 0; f < nInternal; ++f)
    {
        set(f, W_[nei[f]]);
        out_[nei[f]] -= min(phi_[f], scalar(0));
    }
    for (const label f : faces_.coupled)
    {
        set(f, Wb_[f - nInternal]);
    }
}

void Foam::mpm::eulerianFluids::keepMotion()
{
    forAll(rho_, c)
    {
        const gasState& w = W_[c];
        const scalar kinetic = 0.5 * rho_[c] * magSqr(w.u);
        rhoU_[c] = rho_[c] * w.u;
        rhoE_[c] =
            mixture_.at(part_.cdata() + n_ * c, mass_.cdata() + n_ * c, w.p, burntOf(c)).energy
            + kinetic;
        relaxedP_[c] = w.p;
    }
}
