// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "boxSlopes.H"
#include "Vector2D.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::boxSides::find(labelList& directions)
{
    // Of an area along an axis
    constexpr scalar straight = 1 - 1e-12;

    const vectorField& S = mesh_.faceAreas();
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
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const bool side = isA<wedgePolyPatch>(pp);
        wedgeSides_.setSize(
            side ? mesh_.nCells() : wedgeSides_.size(), FixedList<label, 4>(label(-1)));
        for (label i = 0; i < pp.size(); ++i)
        {
            skipped[pp.start() - nInternal + i] = side || isA<emptyPolyPatch>(pp);
            coupled_[pp.start() - nInternal + i] = pp.coupled();
        }
    }
    directions.setSize(mesh_.nFaces(), -1);
    forAll(directions, f)
    {
        if (f < nInternal || !skipped[f - nInternal])
        {
            const scalar least = straight * mag(S[f]);
            int d = 0;
            while (d < nDim_ && mag(S[f][direction_[d]]) < least)
            {
                ++d;
            }
            if (d == nDim_)
            {
                return false;
            }
            directions[f] = d;
        }
    }
    return true;
}

bool Foam::mpm::boxSides::linkCells(const labelUList& directions)
{
    // Of a way along an axis
    constexpr scalar straight = 1 - 1e-12;

    const vectorField& S = mesh_.faceAreas();
    const vectorField& C = mesh_.cellCentres();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    // Faces on each side, seen from each face
    labelList counts(2 * nDim_ * mesh_.nCells(), 0);
    const auto place = [&](const label f, const label c)
    {
        const int d = directions[f];
        return 2 * (nDim_ * c + d) + ((S[f][direction_[d]] > 0) == (own[f] == c));
    };
    forAll(directions, f)
    {
        if (directions[f] >= 0)
        {
            ++counts[place(f, own[f])];
            if (f < nInternal)
            {
                ++counts[place(f, nei[f])];
            }
        }
    }
    scalarList behind(coupled_.size(), scalar(1));
    forAll(behind, i)
    {
        if (directions[nInternal + i] >= 0)
        {
            behind[i] = counts[place(nInternal + i, own[nInternal + i])];
        }
    }
    coupledFaces_.swap(behind);

    links_.setSize(nDim_ * mesh_.nCells(), link{{0, 0}, {-1, -1}});
    labelList coarser(mesh_.nFaces(), 0);
    const auto set = [&](const label f, const label c, const label of)
    {
        const bool owner = own[f] == c;
        link& l = links_[nDim_ * c + directions[f]];
        const bool above = place(f, c) % 2;
        l.side[above] = owner ? 2 * f : 2 * f + 1;
        l.of[above] = of;
    };
    forAll(directions, f)
    {
        const label i = f - nInternal, P = own[f];
        if (directions[f] < 0)
        {
            if (wedgeSides_.size() && isA<wedgePolyPatch>(patches[patches.whichPatch(f)]))
            {
                FixedList<label, 4>& sides = wedgeSides_[P];
                *std::find(sides.begin(), sides.end() - 1, -1) = f;
            }
            continue;
        }
        const label mine = counts[place(f, P)];
        const label other = i < 0 ? counts[place(f, nei[f])] : label(behind[i]);
        const vector way(i < 0 ? C[nei[f]] - C[P] : Zero);
        const bool one = mine == 1 && other == 1;
        if ((mine > 1 && (other > 1 || (i >= 0 && !coupled_[i]))) || mine > 4 || other > 4
            || (one && mag(way[direction_[directions[f]]]) < straight * mag(way)))
        {
            return false;
        }
        coarser[f] = mine > 1 ? 1 : other > 1 ? -1 : 0;
        set(f, P, i >= 0 ? -1 - i : nei[f]);
        if (i < 0)
        {
            set(f, nei[f], P);
        }
    }
    for (const link& l : links_)
    {
        if (l.side[1] < 0 || (l.side[0] < 0 && wedgeSides_.empty()))
        {
            return false;
        }
    }
    setBorders(directions, coarser);
    return true;
}

void Foam::mpm::boxSides::measureFaces(scalarField& v, scalarField& d) const
{
    const vectorField& S = mesh_.faceAreas();
    const surfaceScalarField& weights = mesh_.surfaceInterpolation::weights();
    const vectorField& C = mesh_.cellCentres();
    v.setSize(mesh_.nFaces(), 1);
    d.setSize(mesh_.nFaces(), 0);
    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        v[f] = 1 - weights[f];
        d[f] = mag((C[mesh_.faceNeighbour()[f]] - C[mesh_.faceOwner()[f]]) & S[f]) / mag(S[f]);
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!patch.coupled())
        {
            continue;
        }
        const vectorField way(patch.delta());
        forAll(way, i)
        {
            const label f = patch.start() + i;
            v[f] = 1 - patch.weights()[i];
            d[f] = mag(way[i] & S[f]) / mag(S[f]);
        }
    }
}

void Foam::mpm::boxSides::measure()
{
    // Share of a width by which boxes of one size may differ
    constexpr scalar tolerance = 1e-9;

    const scalarField& V = mesh_.V();
    const vectorField& S = mesh_.faceAreas();
    scalarField v, d;
    measureFaces(v, d);

    // Of both sides a face each and the area
    const auto of =
        [&](const label c, const FixedList<label, 2>& side, const Vector2D<scalar>& area)
    {
        widths w;
        for (int i = 0; i < 2; ++i)
        {
            const label f = side[i] >> 1;
            const bool none = side[i] < 0;
            w.v[i] = none ? 0 : side[i] & 1 ? 1 - v[f] : v[f];
            w.inverse[i] = none ? 0 : area[i] / V[c];
        }
        for (int i = 0; i < 2; ++i)
        {
            const scalar to = side[i] < 0 ? 0 : 2 * d[side[i] >> 1];
            w.own[i] = to * w.inverse[i] * w.v[i] - 1;
            w.other[i] = to * w.inverse[1 - i] * w.v[1 - i];
        }
        return w;
    };
    const auto ofLink = [&](const label at)
    {
        const link& l = links_[at];
        FixedList<label, 2> side;
        Vector2D<scalar> area(Zero);
        for (int i = 0; i < 2; ++i)
        {
            side[i] = l.side[i];
            area[i] = side[i] < 0 ? 0 : mag(S[side[i] >> 1]);
        }
        return of(at / nDim_, side, area);
    };

    boolList skipped(mesh_.nCells(), false);
    for (border& b : borders_)
    {
        skipped[b.cell] = true;
        for (int j = 0; j < nDim_; ++j)
        {
            FixedList<label, 2> side(label(-1));
            Vector2D<scalar> area(Zero);
            for (int i = 0; i < 2; ++i)
            {
                for (label k = b.start[2 * j + i]; k < b.start[2 * j + i + 1]; ++k)
                {
                    side[i] = parts_[k].side;
                    area[i] += mag(S[side[i] >> 1]);
                }
            }
            b.width[j] = of(b.cell, side, area);
        }
    }

    bool uniform = wedgeSides_.empty(), same = true;
    label first = -1;
    inverseOf_.setSize(links_.size(), 0);
    for (label at = 0; uniform && at < links_.size(); ++at)
    {
        if (skipped[at / nDim_])
        {
            continue;
        }
        const widths w(ofLink(at));
        first = first < 0 ? at / nDim_ : first;
        const scalar inverse = w.inverse[0];
        inverseOf_[at] = inverse;
        for (int i = 0; i < 2; ++i)
        {
            uniform = uniform && mag(w.inverse[i] - inverse) < tolerance * inverse
                && (mag(w.v[i] - 0.5) < tolerance || w.v[i] == 1);
        }
        const scalar one = inverseOf_[nDim_ * first + at % nDim_];
        same = same && mag(inverse - one) < tolerance * one;
    }
    uniform = uniform && (same || borders_.size());
    for (int j = 0; j < nDim_; ++j)
    {
        inverse_[j] = first < 0 ? 0 : inverseOf_[nDim_ * first + j];
    }
    if (!uniform || same)
    {
        inverseOf_.clear();
    }
    if (!uniform)
    {
        widths_.setSize(links_.size());
        forAll(widths_, at)
        {
            if (!skipped[at / nDim_])
            {
                widths_[at] = ofLink(at);
            }
        }
    }
    for (const border& b : borders_)
    {
        links_[nDim_ * b.cell].side[0] = -2;
    }
    measureBorders();
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
    const scalar* const ofCells = inverseOf_.size() ? inverseOf_.cdata() : nullptr;

    region_.forCells(
        [&](const label c)
        {
            const link* const links = links_.cdata() + D * c;
            if (links->side[0] == -2)
            {
                return;
            }
            const gasState& w = from.W[c];
            const scalar* const inverse = ofCells ? ofCells + D * c : inverse_.cdata();
            const bool near = Near && (*nearSolid)[c];
            gasState slope[3][2];
            bool still[3][2];
            advection flow;
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
                    limit < Limiter,
                    Uniform ? uniform : graded > (inverse[d], width, s, still[d], slope[d]));
                const int k = direction_[d];
                flow.add(w, change, k);
                if (!Uniform)
                {
                    flow.div += w.u[k] * (width->inverse[1] - width->inverse[0]);
                }
            }

            const gasState ahead(
                flow.ahead(w, near ? 0 : -0.5 * dt, General ? of.t[c].K : gamma * w.p));
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
    const scalar dt, const reconstruction::phase& of, const boolUList* nearSolid, gasState* sides)
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
    if (levels_)
    {
        borderSides<Limiter>(dt, of, nearSolid, sides);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::boxSides> Foam::mpm::boxSides::New(
    const fvMesh& mesh, const activeRegion& region, const coupledFaces& coupled)
{
    autoPtr<boxSides> found(new boxSides(mesh, region, coupled));
    labelList directions;
    if (!returnReduce(found->find(directions), andOp<bool>())
        || !returnReduce(found->linkCells(directions), andOp<bool>()))
    {
        found.clear();
    }
    else
    {
        found->levels_ = returnReduce(found->borders_.size(), sumOp<label>());
        found->measure();
    }
    return found;
}

Foam::mpm::boxSides::boxSides(
    const fvMesh& mesh, const activeRegion& region, const coupledFaces& coupled) :
    mesh_(mesh),
    region_(region),
    coupledFaces_(coupled),
    nDim_(0),
    direction_(label(0)),
    inverse_(scalar(0)),
    levels_(false),
    coupled_(mesh.nFaces() - mesh.nInternalFaces(), false)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::boxSides::update(
    const word& limiter, const scalar dt, const reconstruction::phase& of,
    const boolUList* nearSolid, List<reconstruction::sides>& faces)
{
    gasState* const sides = &faces.begin()->own;
    if (limiter == "vanLeer")
    {
        choose<boxLimiters::vanLeer>(dt, of, nearSolid, sides);
    }
    else if (limiter == "vanAlbada")
    {
        choose<boxLimiters::vanAlbada>(dt, of, nearSolid, sides);
    }
    else if (limiter == "Minmod")
    {
        choose<boxLimiters::Minmod>(dt, of, nearSolid, sides);
    }
    else
    {
        choose<boxLimiters::SuperBee>(dt, of, nearSolid, sides);
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
