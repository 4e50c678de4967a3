// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "childGradients.H"
#include "emptyPolyPatch.H"
#include "symmTensorField.H"
#include "syncTools.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::childGradients::childGradients(
    const fvMesh& mesh, const labelUList& cells, List<DynamicList<vector>>&& children) :
    place_(mesh.nCells(), -1),
    cells_(cells),
    neighbours_(cells.size()),
    moments_(cells.size(), Zero),
    open_(cells.size(), false),
    children_(std::move(children)),
    factor_(cells.size(), 1)
{
    const label nInternal = mesh.nInternalFaces();
    const Vector<label> computed(mesh.geometricD());
    vectorField behind;
    syncTools::swapBoundaryCellPositions(mesh, mesh.cellCentres(), behind);
    boolList coupled(behind.size(), false);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        SubList<bool>(coupled, pp.size(), pp.start() - nInternal) = pp.coupled();
    }
    forAll(cells_, h)
    {
        const label c = cells_[h];
        const point& C = mesh.cellCentres()[c];
        place_[c] = h;
        symmTensor& m = moments_[h];
        for (direction d = 0; d < 3; ++d)
        {
            const label diagonal = d == 0 ? symmTensor::XX
                : d == 1                  ? symmTensor::YY
                                          : symmTensor::ZZ;
            m[diagonal] = computed[d] < 0 ? 1 : 0;
        }
        for (const label f : mesh.cells()[c])
        {
            const label b = f - nInternal;
            if (b >= 0 && !coupled[b])
            {
                const polyPatch& pp = mesh.boundaryMesh()[mesh.boundaryMesh().whichPatch(f)];
                open_[h] = open_[h] || !(isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp));
                continue;
            }
            const label P = mesh.faceOwner()[f];
            const label N = b >= 0 ? -1 : P == c ? mesh.faceNeighbour()[f] : P;
            const vector d((b >= 0 ? behind[b] : mesh.cellCentres()[N]) - C);
            neighbours_[h].append(neighbour{N, b, d});
            m += sqr(d) / magSqr(d);
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::childGradients::separate(const scalarField& share, const scalarField& behind)
{
    constexpr scalar same = 1e-12;
    forAll(cells_, h)
    {
        DynamicList<neighbour> kept;
        for (const neighbour& n : neighbours_[h])
        {
            const scalar q = n.cell < 0 ? behind[n.behind] : share[n.cell];
            if (mag(q - share[cells_[h]]) <= same)
            {
                kept.append(n);
                continue;
            }
            open_[h] = true;
            moments_[h] -= sqr(n.d) / magSqr(n.d);
        }
        neighbours_[h].transfer(kept);
    }
}

void Foam::mpm::childGradients::add(
    const scalarField& v, const scalarField& behind, const scalar scale, const bool state,
    const scalarField& slack)
{
    // Differences up to this part of the scale are rounding, which must not decide
    constexpr scalar none = 1e-12;
    // Beyond the cell and its neighbours, where some are missing
    constexpr scalar beyond = 0.05;

    vectorField* g = new vectorField(cells_.size(), Zero);
    gradients_.append(g);
    ofState_.append(state);
    forAll(cells_, h)
    {
        const scalar here = v[cells_[h]];
        scalar low = here, high = here;
        vector b(Zero);
        for (const neighbour& n : neighbours_[h])
        {
            const scalar q = n.cell < 0 ? behind[n.behind] : v[n.cell];
            low = min(low, q);
            high = max(high, q);
            b += (q - here) * n.d / magSqr(n.d);
        }
        if (high - low <= none * scale || det(moments_[h]) < 1e-3)
        {
            continue;
        }
        (*g)[h] = inv(moments_[h]) & b;
        if (open_[h])
        {
            const scalar up = min(here - low, beyond * mag(here));
            low = min(low, here - min(high - here, beyond * mag(here)));
            high = max(high, here + up);
        }
        scalar factor = 1;
        for (const vector& d : children_[h])
        {
            const scalar change = (*g)[h] & d;
            const scalar most = max(change > 0 ? high - here : here - low, slack[cells_[h]]);
            factor = min(factor, mag(change) > most ? most / mag(change) : 1);
        }
        if (state)
        {
            factor_[h] = min(factor_[h], factor);
        }
        else
        {
            (*g)[h] *= factor;
        }
    }
}
