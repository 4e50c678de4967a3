// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "childGradients.H"
#include "symmTensorField.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::childGradients::childGradients(
    const fvMesh& mesh, const labelUList& cells, List<DynamicList<vector>>&& children) :
    place_(mesh.nCells(), -1),
    cells_(cells),
    neighbours_(cells.size()),
    inverse_(cells.size(), Zero),
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
        symmTensor m(Zero);
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
                continue;
            }
            const label P = mesh.faceOwner()[f];
            const label N = b >= 0 ? -1 : P == c ? mesh.faceNeighbour()[f] : P;
            const vector d((b >= 0 ? behind[b] : mesh.cellCentres()[N]) - C);
            neighbours_[h].append(neighbour{N, b, d});
            m += sqr(d) / magSqr(d);
        }
        inverse_[h] = det(m) > 1e-3 ? inv(m) : symmTensor::zero;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::childGradients::add(
    const scalarField& v, const scalarField& behind, const scalar scale, const bool share)
{
    // Differences up to this part of the scale are rounding, which must not decide
    constexpr scalar none = 1e-12;
    vectorField* g = new vectorField(cells_.size(), Zero);
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
        if (high - low <= none * scale)
        {
            continue;
        }
        (*g)[h] = inverse_[h] & b;
        if (share)
        {
            factor_[h] = 0;
        }
        for (const vector& d : children_[h])
        {
            const scalar change = (*g)[h] & d, most = change > 0 ? high - here : low - here;
            if (mag(change) > mag(most))
            {
                factor_[h] = min(factor_[h], most / change);
            }
        }
    }
    gradients_.append(g);
}
