/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "hydrostatic.H"
#include "cyclicPolyPatch.H"
#include "dictionaryTools.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::hydrostatic::add(const link& l, const vector& S)
{
    const scalar through = S & (l.toP - l.toN);
    links_.push_back(l);
    links_.back().factor = magSqr(S)/max(through, 1e-3*mag(S)*mag(l.toP - l.toN));
}


void Foam::mpm::hydrostatic::weigh
(
    const scalarField& rho,
    std::vector<scalar>& w
) const
{
    w.resize(links_.size());
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        const link& l = links_[i];
        const scalar a = mag(l.toP), b = mag(l.toN);
        w[i] = l.factor*(a + b)/(a*rho[l.P] + b*rho[l.N]);
    }
}


void Foam::mpm::hydrostatic::residual
(
    const scalarField& rho,
    const scalarField& p,
    const std::vector<scalar>& w,
    scalarField& r
) const
{
    r = 0;
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        const link& l = links_[i];
        const scalar jump = rho[l.P]*(g_ & l.toP) - rho[l.N]*(g_ & l.toN);
        const scalar flux = w[i]*(p[l.N] - p[l.P] - jump);
        r[l.P] += flux;
        r[l.N] -= flux;
    }
}


Foam::scalarField Foam::mpm::hydrostatic::change
(
    const std::vector<scalar>& w,
    const scalarField& start
) const
{
    constexpr scalar wanted = 1e-4;

    const label n = start.size();
    scalarField r(start), x(n, Zero), D(n, VSMALL), z(n), s(n, Zero), As(n);
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        D[links_[i].P] += w[i];
        D[links_[i].N] += w[i];
    }
    scalar before = 0, first = 0;
    for (label step = 0; step < 20*n + 100; ++step)
    {
        z = r/D;
        const scalar now = sumProd(r, z);
        first = step == 0 ? now : first;
        if (!(now > sqr(wanted)*first))
        {
            break;
        }
        s = z + (before > 0 ? now/before : scalar(0))*s;
        before = now;
        As = 0;
        for (std::size_t i = 0; i < w.size(); ++i)
        {
            const link& l = links_[i];
            const scalar flux = w[i]*(s[l.P] - s[l.N]);
            As[l.P] += flux;
            As[l.N] -= flux;
        }
        const scalar across = sumProd(s, As);
        if (!(across > 0))
        {
            break;
        }
        const scalar length = now/across;
        x += length*s;
        r -= length*As;
    }
    return x;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::hydrostatic::hydrostatic
(
    const fvMesh& mesh,
    const dictionary& dict,
    const vector& g
)
:
    mesh_(mesh),
    g_(g),
    at_(required<point>(dict, "point")),
    p_(required<scalar>(dict, "p")),
    cell_(-1)
{
    checkKeywords(dict, {"point", "p"});
    if (!(mag(g) > 0))
    {
        // Down along a wedge's axis, or the last direction that is computed
        direction along = 0;
        for (direction d = 0; d < 3; ++d)
        {
            along = mesh.geometricD()[d] > 0 ? d : along;
        }
        for (const polyPatch& patch : mesh.boundaryMesh())
        {
            if (isA<wedgePolyPatch>(patch))
            {
                const vector axis
                (
                    cmptMag(refCast<const wedgePolyPatch>(patch).axis())
                );
                along = axis.y() > 0.5 ? 1 : axis.z() > 0.5 ? 2 : 0;
            }
        }
        vector down(Zero);
        down[along] = -9.81;
        FatalIOErrorInFunction(dict)
            << "Entry hydrostatic needs gravity: a file constant/g with"
            << "  dimensions [0 1 -2 0 0 0 0]; value " << down << ";  or"
            << " another direction of the mesh that points down."
            << exit(FatalIOError);
    }
    boundBox bb(mesh.bounds());
    bb.inflate(1e-6);
    if (!bb.contains(at_))
    {
        FatalIOErrorInFunction(dict)
            << "The point of hydrostatic " << at_ << " is outside the mesh "
            << mesh.bounds() << "." << exit(FatalIOError);
    }
    cell_ = mesh.findCell(at_);
    if (cell_ < 0)
    {
        cell_ = findMin(scalarField(mag(mesh.cellCentres() - at_)));
    }

    const vectorField& C = mesh.cellCentres();
    const vectorField& F = mesh.faceCentres();
    for (label f = 0; f < mesh.nInternalFaces(); ++f)
    {
        const label P = mesh.faceOwner()[f], N = mesh.faceNeighbour()[f];
        add({P, N, F[f] - C[P], F[f] - C[N], 0}, mesh.faceAreas()[f]);
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isA<cyclicPolyPatch>(patch))
        {
            continue;
        }
        const cyclicPolyPatch& cyclic = refCast<const cyclicPolyPatch>(patch);
        if (!cyclic.owner())
        {
            continue;
        }
        const cyclicPolyPatch& other = cyclic.neighbPatch();
        forAll(cyclic, i)
        {
            const label f = cyclic.start() + i, h = other.start() + i;
            const label P = cyclic.faceCells()[i], N = other.faceCells()[i];
            add({P, N, F[f] - C[P], F[h] - C[N], 0}, mesh.faceAreas()[f]);
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::hydrostatic::solve
(
    const scalarField& rho,
    scalarField& p
) const
{
    // In steps, so that what is left is rounding of p
    constexpr label most = 20;

    std::vector<scalar> w;
    weigh(rho, w);
    scalarField r(p.size());
    scalar before = VGREAT;
    for (label i = 0; i < most; ++i)
    {
        residual(rho, p, w, r);
        const scalar now = gSumMag(r);
        if (!(now < 0.1*before))
        {
            break;
        }
        before = now;
        p += change(w, r);
    }
    const vector away(mesh_.cellCentres()[cell_] - at_);
    p += p_ + rho[cell_]*(g_ & away) - p[cell_];
}

// ************************************************************************* //
