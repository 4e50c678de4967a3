// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "impedanceFlux.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(impedanceFlux, 0);
addToRunTimeSelectionTable(faceFlux, impedanceFlux, dictionary);
}

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

//- Faces next to solid, as many as lanes together, always by the same code: so
//  that uniform states stay so also across coupled faces
class Foam::mpm::impedanceFlux::porousFaces
{
    static constexpr int W = registerLanes;
    typedef lanes<W> T;

    //- Numbers of the structures of impedanceFlux
    static constexpr int nState = sizeof(porousState<scalar>) / sizeof(scalar);
    static constexpr int nArea = sizeof(porousArea<scalar>) / sizeof(scalar);

    const impedanceFlux& flux_;
    const besideSolid* const solid_;
    const result& to_;
    const leaving& leaving_;

    union
    {
        porousState<T> left_;
        scalar leftAt_[nState][W];
    };
    union
    {
        porousState<T> right_;
        scalar rightAt_[nState][W];
    };
    union
    {
        porousArea<T> area_;
        scalar areaAt_[nArea][W];
    };
    label faces_[W];
    int n_;

    static void put(scalar (*at)[W], const scalar* numbers, const int n, const int lane)
    {
        for (int i = 0; i < n; ++i)
        {
            at[i][lane] = numbers[i];
        }
    }

public:
    porousFaces(
        const impedanceFlux& flux, const besideSolid* solid, const result& to, const leaving& out) :
        flux_(flux), solid_(solid), to_(to), leaving_(out), n_(0)
    {
    }

    void add(const label f, const porousSide& L, const porousSide& R)
    {
        const porousState<scalar> left(flux_.numbers(f, L)), right(flux_.numbers(f, R));
        const porousArea<scalar> area(flux_.areaOf<false>(f, solid_->pores));
        put(leftAt_, &left.rho, nState, n_);
        put(rightAt_, &right.rho, nState, n_);
        put(areaAt_, &area.magS, nArea, n_);
        faces_[n_++] = f;
        if (n_ == W)
        {
            finish();
        }
    }

    //- The faces that wait. Lanes that are empty repeat the last one
    void finish()
    {
        if (!n_)
        {
            return;
        }
        const auto repeat = [this](scalar(*at)[W], const int n)
        {
            for (int i = 0; i < n; ++i)
            {
                std::fill(at[i] + n_, at[i] + W, at[i][n_ - 1]);
            }
        };
        repeat(leftAt_, nState);
        repeat(rightAt_, nState);
        repeat(areaAt_, nArea);
        const porousResult<T> r(beside(
            left_, right_, area_, solid_->dt, 0, 1,
            solid_->pores.K ? solid_->pores.fd : solidOnFaces::none));
        const T phi = r.theta * r.u * area_.magS;
        for (int l = 0; l < n_; ++l)
        {
            to_.phi[faces_[l]] = phi[l];
            to_.pStar[faces_[l]] = r.pStar[l];
            leaving_.add(faces_[l]);
        }
        n_ = 0;
    }
};

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<bool Porous, bool General, bool Vector>
void Foam::mpm::impedanceFlux::insideFaces(
    const gasStates<General>& states, const besideSolid* solid, const result& to) const
{
    typedef typename gasStates<General>::state state;
    const fvMesh& mesh = faces_.mesh;
    const label nCells = mesh.nCells();
    const label nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vector* const S = mesh.faceAreas().cdata();
    const scalarField& V = mesh.V();
    const bool upwind = states.upwind();
    const scalar factor = states.factor();
    scalar* const phi = to.phi.data();
    scalar* const pStar = to.pStar.data();

    // Faces next to solid, W together where areas are numbers
    const impedanceFlux::leaving leaving(mesh, to);
    porousFaces group(*this, solid, to, leaving);
    const auto porous =
        [&](const label f, const state& L, const state& R, const scalar thetaR, const scalar VR)
    {
        const scalar qL = states.q(L), qR = states.q(R);
        const scalar z = std::sqrt(factor * max(L.w.rho * qL, R.w.rho * qR));
        const label P = own[f];
        const porousSide left{L.w, factor * qL, z, L.w.p, solid->theta[P], V[P]};
        const porousSide right{R.w, factor * qR, z, R.w.p, thetaR, VR};
        if (Vector)
        {
            porousFace<true>(f, left, right, solid->dt, solid->pores, 0, 1, to);
            leaving.add(f);
        }
        else
        {
            group.add(f, left, right);
        }
    };

    // Face between two states: Z = z/|S|
    const auto between = [&](const label f, const state& L, const state& R, const scalar Z)
    {
        const scalar uL = L.w.u & S[f], uR = R.w.u & S[f];
        phi[f] = 0.5 * (uL + uR + (L.w.p - R.w.p) / Z);
        pStar[f] = 0.5 * (L.w.p + R.w.p + Z * (uL - uR));
    };
    const auto open = [&](const label f, const state& L, const state& R)
    {
        const scalar z2 = max(L.w.rho * states.q(L), R.w.rho * states.q(R));
        between(f, L, R, std::sqrt(factor * z2) * faces_.invMagS[f]);
    };

    // A root per cell, not per face
    scalar* const z = z_.data();
    if (upwind)
    {
        const auto set = [&](const label c)
        {
            const state L(states.cell(c));
            z[c] = std::sqrt(factor * L.w.rho * states.q(L));
        };
        if (zOfAll_ && !faces_.region.all())
        {
            faces_.region.forCells(set);
        }
        else
        {
            for (label c = 0; c < nCells; ++c)
            {
                set(c);
            }
        }
        zOfAll_ = !faces_.region.all();
    }

    faces_.region.forFaces(
        [&](const label f)
        {
            const label P = own[f], N = nei[f];
            if (Porous && (solid->near[P] || solid->near[N]))
            {
                porous(f, states.cell(P), states.cell(N), solid->theta[N], V[N]);
                return;
            }
            if (upwind)
            {
                between(f, states.cell(P), states.cell(N), max(z[P], z[N]) * faces_.invMagS[f]);
            }
            else
            {
                open(f, states.own(f), states.nei(f));
            }
            leaving.add(f);
        });

    for (const label f : faces_.coupled)
    {
        const label P = own[f], i = f - nInternal;
        if (Porous && (solid->near[P] || solid->near[nCells + i]))
        {
            porous(f, states.cell(P), states.behind(i), solid->thetaB[i], faces_.Vb[i]);
            continue;
        }
        if (upwind)
        {
            open(f, states.cell(P), states.behind(i));
        }
        else
        {
            open(f, states.own(f), states.nei(f));
        }
        leaving.add(f);
    }
    group.finish();
}

template<bool Porous, bool General>
void Foam::mpm::impedanceFlux::boundaryFaces(
    const gasStates<General>& states, const besideSolid* solid, const result& to) const
{
    const fvMesh& mesh = faces_.mesh;
    const label nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const vectorField& S = mesh.faceAreas();
    const scalarField& magS = faces_.magS;
    const bool upwind = states.upwind();
    scalarField& phi = to.phi;
    scalarField& pStar = to.pStar;

    for (const label f : faces_.boundary)
    {
        const label P = own[f], i = f - nInternal;
        const bool close = Porous && solid->near[P];
        const auto L = upwind || close ? states.cell(P) : states.own(f);
        const gasState& B = states.behind(i).w;
        const scalar u = B.u & S[f];
        phi[f] = u;
        pStar[f] = B.p;
        if (close)
        {
            // Without an area of the solid the gas of its share goes with it
            const solidOnFaces& pores = solid->pores;
            const scalar thetaS = pores.thetaS[f];
            phi[f] *= 1 - thetaS;
            if (pores.area)
            {
                phi[f] += thetaS * pores.uS[f] * magS[f];
            }
        }
        if (faces_.wall[i])
        {
            // As between the state and its mirror image
            scalar z = std::sqrt(states.factor() * L.w.rho * states.q(L));
            if (close)
            {
                z *= solid->theta[P] / max(solid->theta[P], 1 - solid->pores.thetaS[f]);
            }
            pStar[f] += L.w.p - states.cell(P).w.p + z * ((L.w.u & S[f]) - u) / magS[f];
        }
        to.out[P] += max(phi[f], scalar(0));
    }
}

void Foam::mpm::impedanceFlux::clear(const result& to) const
{
    faces_.region.forCells([&](const label c) { to.out[c] = 0; });
    for (const label f : faces_.boundary)
    {
        to.out[faces_.mesh.faceOwner()[f]] = 0;
    }
}

template<bool General>
void Foam::mpm::impedanceFlux::all(const gasStates<General>& states, const result& to) const
{
    clear(to);
    insideFaces<false, General, false>(states, nullptr, to);
    boundaryFaces<false>(states, nullptr, to);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::impedanceFlux::flux(const gasStates<false>& states, const result& to) const
{
    all(states, to);
}

void Foam::mpm::impedanceFlux::flux(const gasStates<true>& states, const result& to) const
{
    all(states, to);
}

void Foam::mpm::impedanceFlux::flux(
    const gasStates<false>& states, const besideSolid& solid, const result& to) const
{
    clear(to);
    if (solid.pores.area)
    {
        insideFaces<true, false, true>(states, &solid, to);
    }
    else
    {
        insideFaces<true, false, false>(states, &solid, to);
    }
    boundaryFaces<true>(states, &solid, to);
}
