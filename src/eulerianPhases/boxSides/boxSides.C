// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "boxSides.H"
#include "lanes.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include <algorithm>

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
    // Of an area or a way along an axis
    constexpr scalar straight = 1 - 1e-12;

    const vectorField& S = mesh_.faceAreas();
    const vectorField& C = mesh_.cellCentres();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    nDim_ = 0;
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh_.geometricD()[d] > 0)
        {
            direction_[nDim_++] = d;
        }
    }
    boolList skipped(mesh_.nFaces() - nInternal, false);
    bool wedge = false;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const bool side = isA<wedgePolyPatch>(pp);
        wedge = wedge || side;
        for (label i = 0; i < pp.size(); ++i)
        {
            skipped[pp.start() - nInternal + i] = side || isA<emptyPolyPatch>(pp);
            coupled_[pp.start() - nInternal + i] = pp.coupled();
        }
    }
    const auto along = [&](const vector& v)
    {
        const scalar least = straight * mag(v);
        int d = 0;
        while (d < nDim_ && mag(v[direction_[d]]) < least)
        {
            ++d;
        }
        return d;
    };

    links_.setSize(nDim_ * mesh_.nCells(), link{{0, 0}, {-1, -1}});
    wedgeSides_.setSize(wedge ? mesh_.nCells() : 0, FixedList<label, 4>(label(-1)));
    for (label c = 0; c < mesh_.nCells(); ++c)
    {
        for (const label f : mesh_.cells()[c])
        {
            const label i = f - nInternal;
            if (i >= 0 && skipped[i])
            {
                if (wedge)
                {
                    FixedList<label, 4>& sides = wedgeSides_[c];
                    *std::find(sides.begin(), sides.end() - 1, -1) = f;
                }
                continue;
            }
            const int d = along(S[f]);
            if (d == nDim_ || (i < 0 && along(C[nei[f]] - C[own[f]]) != d))
            {
                return false;
            }
            const bool owner = own[f] == c;
            const bool above = (S[f][direction_[d]] > 0) == owner;
            link& l = links_[nDim_ * c + d];
            if (l.side[above] >= 0)
            {
                return false;
            }
            l.side[above] = owner ? 2 * f : 2 * f + 1;
            l.of[above] = i >= 0 ? -1 - i : owner ? nei[f] : own[f];
        }
    }
    for (const link& l : links_)
    {
        if (l.side[1] < 0 || (l.side[0] < 0 && !wedge))
        {
            return false;
        }
    }
    return true;
}

void Foam::mpm::boxSides::measure()
{
    // Share of a width by which boxes of one size may differ
    constexpr scalar tolerance = 1e-9;

    const scalarField& V = mesh_.V();
    const vectorField& S = mesh_.faceAreas();
    const label nInternal = mesh_.nInternalFaces();
    const surfaceScalarField& weights = mesh_.surfaceInterpolation::weights();
    const surfaceScalarField& deltas = mesh_.surfaceInterpolation::deltaCoeffs();

    // Of the neighbour seen from the owner; distance of the centres
    scalarField v(mesh_.nFaces(), 1), d(mesh_.nFaces(), 0);
    for (label f = 0; f < nInternal; ++f)
    {
        v[f] = 1 - weights[f];
        d[f] = 1 / deltas[f];
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!patch.coupled())
        {
            continue;
        }
        const scalarField way(mag(patch.delta()));
        forAll(way, i)
        {
            v[patch.start() + i] = 1 - patch.weights()[i];
            d[patch.start() + i] = way[i];
        }
    }

    const auto of = [&](const label at)
    {
        const link& l = links_[at];
        widths w;
        for (int i = 0; i < 2; ++i)
        {
            const label f = l.side[i] >> 1;
            const bool none = l.side[i] < 0;
            w.v[i] = none ? 0 : l.side[i] & 1 ? 1 - v[f] : v[f];
            w.inverse[i] = none ? 0 : mag(S[f]) / V[at / nDim_];
        }
        for (int i = 0; i < 2; ++i)
        {
            const scalar to = l.side[i] < 0 ? 0 : 2 * d[l.side[i] >> 1];
            w.own[i] = to * w.inverse[i] * w.v[i] - 1;
            w.other[i] = to * w.inverse[1 - i] * w.v[1 - i];
        }
        return w;
    };

    bool uniform = wedgeSides_.empty();
    for (label at = 0; uniform && at < links_.size(); ++at)
    {
        const widths w(of(at));
        scalar& inverse = inverse_[at % nDim_];
        inverse = at < nDim_ ? w.inverse[0] : inverse;
        for (int i = 0; i < 2; ++i)
        {
            uniform = uniform && mag(w.inverse[i] - inverse) < tolerance * inverse
                && (mag(w.v[i] - 0.5) < tolerance || w.v[i] == 1);
        }
    }
    if (!uniform)
    {
        widths_.setSize(links_.size());
        forAll(widths_, at)
        {
            widths_[at] = of(at);
        }
    }
}

template<bool Uniform>
MPM_INLINE void
Foam::mpm::boxSides::differences(const gasState& w, const link& l, const states& of, around& s)
{
    for (int i = 0; i < 2; ++i)
    {
        const label b = l.of[i], side = l.side[i];
        const bool none = !Uniform && side < 0;
        const gasState& n = none ? w : b < 0 ? of.Wb[-1 - b] : of.W[b];
        const scalar rest =
            of.jump && !none ? (side & 1 ? -of.jump[side >> 1] : of.jump[side >> 1]) : 0;
        s.behind[i] = none || (b < 0 && !of.coupled[-1 - b]);
        const scalar sign = (i ? 1 : -1) * (Uniform && s.behind[i] ? 2 : 1);
        s.by[i].rho = sign * (n.rho - w.rho);
        s.by[i].u = sign * (n.u - w.u);
        s.by[i].p = sign * (n.p - rest - w.p);
    }
}

template<class Limiter, bool Uniform>
MPM_INLINE Foam::mpm::gasState Foam::mpm::boxSides::limit(
    const scalar inverse, const widths* width, const around& s, const bool (&still)[2],
    gasState (&sides)[2])
{
    // v limiter(r) of the difference at face i; oo, oq: products with itself and the other one
    const auto isCut = [](const scalar ab, const scalar aa) { return mag(ab) > 1999 * aa; };
    bool cut = false;
    const auto share = [&](const int i, const scalar oo, const scalar oq)
    {
        scalar ab = Uniform ? oq : width->own[i] * oo + width->other[i] * oq;
        if (isCut(ab, oo))
        {
            cut = true;
            ab = max(-2001 * oo, min(ab, 1999 * oo));
        }
        return (Uniform ? 0.5 : width->v[i]) * Limiter::weight(ab, oo);
    };
    gasState change{0, Zero, 0};
    const scalar rhos = s.by[0].rho * s.by[1].rho, ps = s.by[0].p * s.by[1].p,
                 us = s.by[0].u & s.by[1].u;
    for (int i = 0; i < 2; ++i)
    {
        const gasState& o = s.by[i];
        const scalar sign = i ? 1 : -1;
        gasState& to = sides[i];
        if (s.behind[i] || still[i])
        {
            to = gasState{0, Zero, 0};
        }
        else if (
            Uniform && i && !s.behind[0] && !still[0] && !cut && !isCut(rhos, sqr(o.rho))
            && !isCut(ps, sqr(o.p)))
        {
            // A slope of both sides: these limiters are symmetric
            to.rho = -sides[0].rho;
            to.p = -sides[0].p;
            to.u = share(i, magSqr(o.u), us) * o.u;
        }
        else
        {
            to.rho = sign * share(i, sqr(o.rho), rhos) * o.rho;
            to.p = sign * share(i, sqr(o.p), ps) * o.p;
            to.u = sign * share(i, magSqr(o.u), us) * o.u;
        }

        // Of the face less that of the cell. To choose a reference takes 1.6 times as long
        const scalar k = Uniform ? inverse : width->inverse[i];
        if (s.behind[i])
        {
            const scalar part = Uniform ? 0.5 * k : k;
            change.rho += part * o.rho;
            change.u += part * o.u;
            change.p += part * o.p;
        }
        else
        {
            change.rho += sign * k * to.rho;
            change.u += sign * k * to.u;
            change.p += sign * k * to.p;
        }
    }
    return change;
}

template<class Limiter, bool General, bool Near, bool Uniform>
void Foam::mpm::boxSides::loop(
    const scalar dt, const reconstruction::phase& of, const boolUList* nearSolid,
    gasState* sides) const
{
    const states from{
        of.W.cdata(), of.Wb.cdata(), of.jump ? of.jump->cdata() : nullptr, coupled_.cdata()};
    const scalar gamma = General ? 0 : of.thermo->gamma();
    const label nCells = mesh_.nCells();
    const int D = nDim_;

    region_.forCells(
        [&](const label c)
        {
            const gasState& w = from.W[c];
            const link* const links = links_.cdata() + D * c;
            const bool near = Near && (*nearSolid)[c];
            gasState slope[3][2];
            bool still[3][2];
            scalar div = 0, ofRho = 0, ofP = 0;
            vector ofU(Zero), gradP(Zero);
            for (int d = 0; d < D; ++d)
            {
                around s;
                const widths* const width = Uniform ? nullptr : widths_.cdata() + D * c + d;
                differences<Uniform>(w, links[d], from, s);
                for (int i = 0; i < 2; ++i)
                {
                    const label n = links[d].of[i];
                    still[d][i] =
                        Near && !s.behind[i] && (near || (*nearSolid)[n < 0 ? nCells - 1 - n : n]);
                }
                const gasState change(
                    limit<Limiter, Uniform>(inverse_[d], width, s, still[d], slope[d]));
                const int k = direction_[d];
                div += change.u[k];
                if (!Uniform)
                {
                    div += w.u[k] * (width->inverse[1] - width->inverse[0]);
                }
                ofRho += w.u[k] * change.rho;
                ofU += w.u[k] * change.u;
                ofP += w.u[k] * change.p;
                gradP[k] = change.p;
            }

            const scalar h = near ? 0 : -0.5 * dt;
            const gasState ahead{
                w.rho + h * (ofRho + w.rho * div), w.u + h * (ofU + gradP / w.rho),
                w.p + h * (ofP + (General ? of.t[c].K : gamma * w.p) * div)};
            const scalar leastRho = 0.1 * w.rho;
            const scalar leastP = General ? w.p - 0.9 * of.t[c].strength : 0.1 * w.p;
            const auto kept = [&](const gasState& to)
            { return to.rho < leastRho || to.p < leastP ? w : to; };
            for (int d = 0; d < D; ++d)
            {
                for (int i = 0; i < 2; ++i)
                {
                    const gasState& s = slope[d][i];
                    const label side = links[d].side[i];
                    if (Uniform || side >= 0)
                    {
                        sides[side] = still[d][i]
                            ? w
                            : kept({ahead.rho + s.rho, ahead.u + s.u, ahead.p + s.p});
                    }
                }
            }
            if (!Uniform && wedgeSides_.size())
            {
                for (const label f : wedgeSides_[c])
                {
                    if (f >= 0)
                    {
                        sides[2 * f] = kept(ahead);
                    }
                }
            }
        });
}

template<class Limiter>
void Foam::mpm::boxSides::choose(
    const scalar dt, const reconstruction::phase& of, const boolUList* nearSolid,
    gasState* sides) const
{
    const auto chosen = [&](auto general, auto near, auto uniform)
    {
        loop<Limiter, decltype(general)::value, decltype(near)::value, decltype(uniform)::value>(
            dt, of, nearSolid, sides);
    };
    const auto ofNear = [&](auto general, auto near)
    {
        widths_.empty() ? chosen(general, near, std::true_type())
                        : chosen(general, near, std::false_type());
    };
    const auto ofGeneral = [&](auto general)
    { nearSolid ? ofNear(general, std::true_type()) : ofNear(general, std::false_type()); };
    of.thermo&& of.thermo->isGammaLaw() ? ofGeneral(std::false_type())
                                        : ofGeneral(std::true_type());
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
    else
    {
        found->measure();
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
