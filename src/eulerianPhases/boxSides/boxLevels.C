// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "boxSlopes.H"
#include "SubList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::boxSides::setBorders(const labelUList& directions, const labelUList& coarser)
{
    const vectorField& S = mesh_.faceAreas();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    boolList isBorder(mesh_.nCells(), false);
    labelList deltaOf(mesh_.nFaces(), -1);
    label nDeltas = coupled_.size();
    forAll(coarser, f)
    {
        if (coarser[f])
        {
            isBorder[own[f]] = true;
            deltaOf[f] = f < nInternal ? nDeltas++ : f - nInternal;
            if (f < nInternal)
            {
                isBorder[nei[f]] = true;
            }
        }
    }
    deltas_.setSize(nDeltas, gasState{0, Zero, 0});

    DynamicList<border> borders;
    DynamicList<part> parts;
    forAll(isBorder, c)
    {
        if (!isBorder[c])
        {
            continue;
        }
        border b{c, FixedList<label, 7>(label(parts.size())), FixedList<widths, 3>()};
        for (int side = 0; side < 2 * nDim_; ++side)
        {
            const label first = parts.size();
            scalar area = 0;
            for (const label f : mesh_.cells()[c])
            {
                const bool owner = own[f] == c;
                const int d = directions[f];
                if (d < 0 || 2 * d + ((S[f][direction_[d]] > 0) == owner) != side)
                {
                    continue;
                }
                const bool mine = coarser[f] == (owner ? 1 : -1);
                parts.append(part{
                    f >= nInternal ? nInternal - f - 1
                        : owner    ? nei[f]
                                   : own[f],
                    owner ? 2 * f : 2 * f + 1, mag(S[f]), mine ? deltaOf[f] : -1,
                    mine ? -1 : deltaOf[f], vector(Zero)});
                area += mag(S[f]);
            }
            for (label k = first; k < parts.size(); ++k)
            {
                parts[k].share /= area;
            }
            b.start[side + 1] = parts.size();
        }
        borders.append(b);
    }
    borders_.transfer(borders);
    parts_.transfer(parts);
}

void Foam::mpm::boxSides::measureBorders()
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    for (const border& b : borders_)
    {
        for (label k = b.start[0]; k < b.start[2 * nDim_]; ++k)
        {
            part& at = parts_[k];
            const vector way(Cf[at.side >> 1] - C[b.cell]);
            for (int t = 0; at.to >= 0 && t < nDim_; ++t)
            {
                const bool across = k < b.start[2 * t] || k >= b.start[2 * t + 2];
                const scalar* const inverse = b.width[t].inverse;
                at.place[t] = across ? 0.5 * (inverse[0] + inverse[1]) * way[direction_[t]] : 0;
            }
        }
    }
}

void Foam::mpm::boxSides::differences(
    const border& b, const states& of, const boolUList* nearSolid, const bool deltas,
    around (&s)[3], bool (&still)[3][2]) const
{
    const label nCells = mesh_.nCells();
    const gasState& w = of.W[b.cell];
    const bool near = nearSolid && (*nearSolid)[b.cell];
    for (int side = 0; side < 2 * nDim_; ++side)
    {
        const int d = side / 2, i = side % 2;
        gasState& sum = s[d].by[i];
        sum = gasState{0, Zero, 0};

        // At the axis of a wedge there is no face
        s[d].behind[i] = b.start[side] == b.start[side + 1];
        still[d][i] = near;
        for (label k = b.start[side]; k < b.start[side + 1]; ++k)
        {
            const part& at = parts_[k];
            const bool inside = at.of >= 0;
            const gasState& n = inside ? of.W[at.of] : of.Wb[-1 - at.of];
            const scalar rest =
                of.jump ? (at.side & 1 ? -of.jump[at.side >> 1] : of.jump[at.side >> 1]) : 0;
            const scalar part = (i ? 1 : -1) * at.share;
            sum.rho += part * (n.rho - w.rho);
            sum.u += part * (n.u - w.u);
            sum.p += part * (n.p - rest - w.p);
            if (deltas && at.from >= 0)
            {
                const gasState& more = deltas_[at.from];
                sum.rho += part * more.rho;
                sum.u += part * more.u;
                sum.p += part * more.p;
            }
            s[d].behind[i] = s[d].behind[i] || (!inside && !of.coupled[-1 - at.of]);
            still[d][i] =
                still[d][i] || (nearSolid && (*nearSolid)[inside ? at.of : nCells - 1 - at.of]);
        }
        still[d][i] = still[d][i] && !s[d].behind[i];
    }
}

Foam::mpm::gasState Foam::mpm::boxSides::delta(const part& at, const gasState (&slope)[3][2]) const
{
    gasState sum{0, Zero, 0};
    for (int t = 0; t < nDim_; ++t)
    {
        sum.rho += at.place[t] * (slope[t][1].rho - slope[t][0].rho);
        sum.u += at.place[t] * (slope[t][1].u - slope[t][0].u);
        sum.p += at.place[t] * (slope[t][1].p - slope[t][0].p);
    }
    return sum;
}

template<class Limiter>
void Foam::mpm::boxSides::setDeltas(const states& of, const boolUList* nearSolid)
{
    deltas_ = gasState{0, Zero, 0};
    for (const border& b : borders_)
    {
        around s[3];
        bool still[3][2];
        gasState slope[3][2];
        bool needed = false;
        for (label k = b.start[0]; k < b.start[2 * nDim_]; ++k)
        {
            needed = needed || parts_[k].to >= 0;
        }
        if (!needed)
        {
            continue;
        }
        differences(b, of, nearSolid, false, s, still);
        for (int d = 0; d < nDim_; ++d)
        {
            limit<Limiter, levels>(0, &b.width[d], s[d], still[d], slope[d]);
        }
        for (label k = b.start[0]; k < b.start[2 * nDim_]; ++k)
        {
            if (parts_[k].to >= 0)
            {
                deltas_[parts_[k].to] = delta(parts_[k], slope);
            }
        }
    }
    SubList<gasState> ofBoundary(deltas_, coupled_.size());
    coupledFaces_.swap(ofBoundary);
}

template<class Limiter>
void Foam::mpm::boxSides::borderSides(
    const scalar dt, const reconstruction::phase& of, const boolUList* nearSolid, gasState* sides)
{
    const states from{
        of.W.cdata(), of.Wb.cdata(), of.jump ? of.jump->cdata() : nullptr, coupled_.cdata()};
    const bool gammaLaw = of.thermo && of.thermo->isGammaLaw();
    setDeltas<Limiter>(from, nearSolid);
    for (const border& b : borders_)
    {
        const label c = b.cell;
        if (!region_.has(c))
        {
            continue;
        }
        const gasState& w = of.W[c];
        around s[3];
        bool still[3][2];
        gasState slope[3][2];
        advection flow;
        differences(b, from, nearSolid, true, s, still);
        for (int d = 0; d < nDim_; ++d)
        {
            const widths& width = b.width[d];
            const int k = direction_[d];
            flow.add(w, limit<Limiter, levels>(0, &width, s[d], still[d], slope[d]), k);
            flow.div += w.u[k] * (width.inverse[1] - width.inverse[0]);
        }
        const bool near = nearSolid && (*nearSolid)[c];
        const gasState ahead(
            flow.ahead(w, near ? 0 : -0.5 * dt, gammaLaw ? of.thermo->gamma() * w.p : of.t[c].K));
        const scalar leastP = gammaLaw ? 0.1 * w.p : w.p - 0.9 * of.t[c].strength;
        const auto kept = [&](const gasState& to)
        { return to.rho < 0.1 * w.rho || to.p < leastP ? w : to; };
        for (int side = 0; side < 2 * nDim_; ++side)
        {
            const int d = side / 2, i = side % 2;
            for (label k = b.start[side]; k < b.start[side + 1]; ++k)
            {
                const gasState& to = slope[d][i];
                const gasState more(delta(parts_[k], slope));
                sides[parts_[k].side] = still[d][i]
                    ? w
                    : kept(
                        {ahead.rho + to.rho + more.rho, ahead.u + to.u + more.u,
                         ahead.p + to.p + more.p});
            }
        }
        if (wedgeSides_.size())
        {
            for (const label f : wedgeSides_[c])
            {
                if (f >= 0)
                {
                    sides[2 * f] = kept(ahead);
                }
            }
        }
    }
}

// * * * * * * * * * * * * * * * Instantiations  * * * * * * * * * * * * * * //

#define borderSidesOf(Limiter)                                                                     \
    template void Foam::mpm::boxSides::borderSides<Foam::mpm::boxLimiters::Limiter>(               \
        const scalar, const reconstruction::phase&, const boolUList*, gasState*);
borderSidesOf(vanLeer) borderSidesOf(vanAlbada) borderSidesOf(Minmod) borderSidesOf(SuperBee)
