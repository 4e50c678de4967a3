// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "boxSides.H"
#include "emptyPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- limiter(r) of r = ab/aa, aa >= 0

struct vanLeer
{
    static scalar weight(const scalar ab, const scalar aa)
    {
        return ab > 0 ? 2 * ab / (aa + ab) : 0;
    }
};

struct vanAlbada
{
    static scalar weight(const scalar ab, const scalar aa)
    {
        return ab * (ab + aa) / (sqr(ab) + sqr(aa) + VSMALL);
    }
};

struct Minmod
{
    static scalar weight(const scalar ab, const scalar aa)
    {
        return ab > 0 ? (ab < aa ? ab / aa : 1) : 0;
    }
};

struct SuperBee
{
    static scalar weight(const scalar ab, const scalar aa)
    {
        return !(ab > 0)  ? 0
            : ab > aa     ? (ab < 2 * aa ? ab / aa : 2)
            : 2 * ab < aa ? 2 * ab / aa
                          : 1;
    }
};

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::boxSides::find()
{
    // Share of a width by which boxes may differ
    constexpr scalar tolerance = 1e-6;

    const vectorField& S = mesh_.faceAreas();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& C = mesh_.cellCentres();
    const scalarField& V = mesh_.V();
    const label nInternal = mesh_.nInternalFaces();

    nDim_ = 0;
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh_.geometricD()[d] > 0)
        {
            direction_[nDim_] = d;
            inverse_[nDim_] = 0;
            ++nDim_;
        }
    }
    if (nDim_ != mesh_.nSolutionD())
    {
        return false;
    }

    boolList empty(mesh_.nFaces() - nInternal, false);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        for (label i = 0; i < pp.size(); ++i)
        {
            empty[pp.start() - nInternal + i] = isA<emptyPolyPatch>(pp);
            coupled_[pp.start() - nInternal + i] = pp.coupled();
        }
    }

    links_.setSize(nDim_ * mesh_.nCells(), link{{0, 0}, {-1, -1}});
    forAll(V, c)
    {
        for (const label f : mesh_.cells()[c])
        {
            const label i = f - nInternal;
            if (i >= 0 && empty[i])
            {
                continue;
            }
            const bool owner = mesh_.faceOwner()[f] == c;
            const scalar area = mag(S[f]);
            int d = 0;
            while (d < nDim_ && mag(S[f][direction_[d]]) < (1 - sqr(tolerance)) * area)
            {
                ++d;
            }
            if (d == nDim_)
            {
                return false;
            }
            const bool above = (S[f][direction_[d]] > 0) == owner;
            link& l = links_[nDim_ * c + d];
            if (l.side[above] >= 0)
            {
                return false;
            }
            l.side[above] = owner ? 2 * f : 2 * f + 1;
            l.of[above] = i >= 0 ? -1 - i : owner ? mesh_.faceNeighbour()[f] : mesh_.faceOwner()[f];

            // Of one width with all others, half of it to its faces
            const scalar inverse = area / V[c];
            inverse_[d] = inverse_[d] > 0 ? inverse_[d] : inverse;
            if (mag(inverse - inverse_[d]) > tolerance * inverse_[d]
                || mag(mag(Cf[f] - C[c]) * inverse - 0.5) > tolerance)
            {
                return false;
            }
        }
    }
    for (const link& l : links_)
    {
        if (l.side[0] < 0 || l.side[1] < 0)
        {
            return false;
        }
    }
    return true;
}

template<class Limiter, bool General, bool Near>
void Foam::mpm::boxSides::loop(
    const scalar dt, const reconstruction::phase& of, const boolUList* nearSolid,
    gasState* sides) const
{
    const gasState* const W = of.W.cdata();
    const gasState* const Wb = of.Wb.cdata();
    const scalar* const jump = of.jump ? of.jump->cdata() : nullptr;
    const scalar gamma = General ? 0 : of.thermo->gamma();
    const label nCells = mesh_.nCells();
    const int D = nDim_;

    region_.forCells(
        [&](const label c)
        {
            const gasState& w = W[c];
            const link* const links = links_.cdata() + D * c;
            const bool near = Near && (*nearSolid)[c];
            gasState slope[3][2];
            bool still[3][2];
            scalar div = 0, ofRho = 0, ofP = 0;
            vector ofU(Zero), gradP(Zero);
            for (int d = 0; d < D; ++d)
            {
                // From below to the cell, from the cell to above
                const link& l = links[d];
                gasState by[2];
                bool behind[2];
                for (int i = 0; i < 2; ++i)
                {
                    const label b = l.of[i];
                    const gasState& n = b < 0 ? Wb[-1 - b] : W[b];
                    const scalar rest =
                        jump ? (l.side[i] & 1 ? -jump[l.side[i] >> 1] : jump[l.side[i] >> 1]) : 0;
                    behind[i] = b < 0 && !coupled_[-1 - b];
                    const scalar s = (i ? 1 : -1) * (behind[i] ? 2 : 1);
                    by[i].rho = s * (n.rho - w.rho);
                    by[i].u = s * (n.u - w.u);
                    by[i].p = s * (n.p - rest - w.p);
                }
                const gasState& b = by[0];
                const gasState& a = by[1];
                const scalar rho = 0.5 * Limiter::weight(a.rho * b.rho, sqr(a.rho)) * a.rho;
                const scalar p = 0.5 * Limiter::weight(a.p * b.p, sqr(a.p)) * a.p;
                const scalar ab = a.u & b.u;
                slope[d][0] = gasState{-rho, -0.5 * Limiter::weight(ab, magSqr(b.u)) * b.u, -p};
                slope[d][1] = gasState{rho, 0.5 * Limiter::weight(ab, magSqr(a.u)) * a.u, p};

                gasState change{0, Zero, 0};
                for (int i = 0; i < 2; ++i)
                {
                    gasState& s = slope[d][i];
                    const label n = l.of[i];
                    const scalar sign = i ? 1 : -1;
                    still[d][i] =
                        Near && !behind[i] && (near || (*nearSolid)[n < 0 ? nCells - 1 - n : n]);
                    if (behind[i])
                    {
                        s = gasState{0, Zero, 0};
                        change.rho += 0.5 * by[i].rho;
                        change.u += 0.5 * by[i].u;
                        change.p += 0.5 * by[i].p;
                    }
                    else if (still[d][i])
                    {
                        s = gasState{0, Zero, 0};
                    }
                    else
                    {
                        change.rho += sign * s.rho;
                        change.u += sign * s.u;
                        change.p += sign * s.p;
                    }
                }
                const int k = direction_[d];
                const scalar flow = inverse_[d] * w.u[k];
                div += inverse_[d] * change.u[k];
                ofRho += flow * change.rho;
                ofU += flow * change.u;
                ofP += flow * change.p;
                gradP[k] = inverse_[d] * change.p;
            }

            const scalar h = near ? 0 : -0.5 * dt;
            const gasState ahead{
                w.rho + h * (ofRho + w.rho * div), w.u + h * (ofU + gradP / w.rho),
                w.p + h * (ofP + (General ? of.t[c].K : gamma * w.p) * div)};
            const scalar leastRho = 0.1 * w.rho;
            const scalar leastP = General ? w.p - 0.9 * of.t[c].strength : 0.1 * w.p;
            for (int d = 0; d < D; ++d)
            {
                for (int i = 0; i < 2; ++i)
                {
                    const gasState& s = slope[d][i];
                    const gasState to{ahead.rho + s.rho, ahead.u + s.u, ahead.p + s.p};
                    sides[links[d].side[i]] =
                        still[d][i] || to.rho < leastRho || to.p < leastP ? w : to;
                }
            }
        });
}

template<class Limiter>
void Foam::mpm::boxSides::choose(
    const scalar dt, const reconstruction::phase& of, const boolUList* nearSolid,
    gasState* sides) const
{
    const bool gamma = of.thermo && of.thermo->isGammaLaw();
    if (gamma && nearSolid)
    {
        loop<Limiter, false, true>(dt, of, nearSolid, sides);
    }
    else if (gamma)
    {
        loop<Limiter, false, false>(dt, of, nearSolid, sides);
    }
    else if (nearSolid)
    {
        loop<Limiter, true, true>(dt, of, nearSolid, sides);
    }
    else
    {
        loop<Limiter, true, false>(dt, of, nearSolid, sides);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::boxSides>
Foam::mpm::boxSides::New(const fvMesh& mesh, const activeRegion& region)
{
    autoPtr<boxSides> found(new boxSides(mesh, region));
    if (!returnReduce(found->find(), andOp<bool>()))
    {
        found.clear();
    }
    return found;
}

Foam::mpm::boxSides::boxSides(const fvMesh& mesh, const activeRegion& region) :
    mesh_(mesh),
    region_(region),
    nDim_(0),
    direction_(label(0)),
    inverse_(scalar(0)),
    coupled_(mesh.nFaces() - mesh.nInternalFaces(), false)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::boxSides::update(
    const word& limiter, const scalar dt, const reconstruction::phase& of,
    const boolUList* nearSolid, List<reconstruction::sides>& faces) const
{
    gasState* const sides = &faces.begin()->own;
    if (limiter == "vanLeer")
    {
        choose<vanLeer>(dt, of, nearSolid, sides);
    }
    else if (limiter == "vanAlbada")
    {
        choose<vanAlbada>(dt, of, nearSolid, sides);
    }
    else if (limiter == "Minmod")
    {
        choose<Minmod>(dt, of, nearSolid, sides);
    }
    else
    {
        choose<SuperBee>(dt, of, nearSolid, sides);
    }
    if (region_.all())
    {
        return;
    }

    // Nothing happens outside the region
    region_.forFaces(
        [&](const label f)
        {
            const label P = mesh_.faceOwner()[f], N = mesh_.faceNeighbour()[f];
            if (!region_.has(P))
            {
                faces[f].own = of.W[P];
            }
            if (!region_.has(N))
            {
                faces[f].nei = of.W[N];
            }
        });
}
