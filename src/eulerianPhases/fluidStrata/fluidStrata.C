// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fluidStrata.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "SortableList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Faces that are no side of a mesh of fewer dimensions
bool counts(const polyMesh& mesh, const label f)
{
    const label patchi = mesh.isInternalFace(f) ? -1 : mesh.boundaryMesh().whichPatch(f);
    return patchi < 0 || !isA<emptyPolyPatch>(mesh.boundaryMesh()[patchi]);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::fluidStrata::table::depths(const scalar h, scalarField& depth) const
{
    scalar volume = 0;
    forAll(triangles, i)
    {
        depth[i] = 0;
        for (const triangle& t : triangles[i])
        {
            if (h >= t.c)
            {
                depth[i] += t.share * (h - (t.a + t.b + t.c) / 3);
            }
            else if (h > t.b)
            {
                depth[i] += t.share
                    * (h - (t.a + t.b + t.c) / 3 + pow3(t.c - h) / (3 * (t.c - t.a) * (t.c - t.b)));
            }
            else if (h > t.a)
            {
                depth[i] += t.share * pow3(h - t.a) / (3 * (t.b - t.a) * (t.c - t.a));
            }
        }
        volume -= depth[i] * up[i];
    }
    return volume;
}

void Foam::mpm::fluidStrata::table::fill(const scalar V, scalarField& depth) const
{
    constexpr int most = 60;
    constexpr scalar exact = 1e-12;

    int j = 0;
    while (j < nLayers - 1 && below[j + 1] < V)
    {
        ++j;
    }
    const scalar step = (high - low) / nLayers;
    scalar a = low + j * step, b = a + step, fa = below[j] - V, fb = below[j + 1] - V;
    for (int n = 0, side = 0; n < most; ++n)
    {
        // Illinois: what stays counts half
        const scalar h = fb > fa ? min(max((a * fb - b * fa) / (fb - fa), a), b) : 0.5 * (a + b);
        const scalar f = depths(h, depth) - V;
        if (mag(f) <= exact * below[nLayers])
        {
            return;
        }
        if (f > 0)
        {
            b = h;
            fb = f;
            fa *= side == 1 ? 0.5 : 1;
            side = 1;
        }
        else
        {
            a = h;
            fa = f;
            fb *= side == -1 ? 0.5 : 1;
            side = -1;
        }
    }
}

void Foam::mpm::fluidStrata::make(const label c)
{
    autoPtr<table> made(new table);
    table& t = made();
    t.low = GREAT;
    t.high = -GREAT;
    DynamicList<label> faces;
    for (const label f : mesh_.cells()[c])
    {
        if (counts(mesh_, f))
        {
            faces.append(f);
        }
    }
    t.faces = faces;
    t.up.setSize(faces.size());
    t.y = scalarField(faces.size(), Zero);
    t.triangles.setSize(faces.size());
    forAll(faces, i)
    {
        const label f = faces[i];
        t.up[i] = (mesh_.faceOwner()[f] == c ? 1 : -1) * (mesh_.faceAreas()[f] & up_);
        const pointField corners(mesh_.faces()[f].points(mesh_.points()));
        const point middle(average(corners));
        scalar area = 0;
        forAll(corners, k)
        {
            const point &p = corners[k], &q = corners[corners.fcIndex(k)];
            triangle s{p & up_, q & up_, middle & up_, mag((q - p) ^ (middle - p))};
            t.low = min(t.low, s.a);
            t.high = max(t.high, s.a);
            if (s.a > s.b)
            {
                Swap(s.a, s.b);
            }
            if (s.b > s.c)
            {
                Swap(s.b, s.c);
            }
            if (s.a > s.b)
            {
                Swap(s.a, s.b);
            }
            area += s.share;
            t.y[i] += s.share * (s.a + s.b + s.c) / 3;
            t.triangles[i].append(s);
        }
        t.y[i] /= area;
        for (triangle& s : t.triangles[i])
        {
            s.share /= area;
        }
    }
    scalarField depth(faces.size());
    for (int j = 0; j <= nLayers; ++j)
    {
        t.below[j] = t.depths(t.low + j * (t.high - t.low) / nLayers, depth);
    }
    number_[c] = tables_.size();
    tables_.append(made.ptr());
}

bool Foam::mpm::fluidStrata::beside(const label c, const boolList& atInterface) const
{
    for (const label f : mesh_.cells()[c])
    {
        const label other = !mesh_.isInternalFace(f) ? mesh_.nCells() + f - mesh_.nInternalFaces()
            : mesh_.faceOwner()[f] == c              ? mesh_.faceNeighbour()[f]
                                                     : mesh_.faceOwner()[f];
        if (atInterface[other])
        {
            return true;
        }
    }
    return false;
}

void Foam::mpm::fluidStrata::set(
    const label c, const label n, const scalar* s, const scalarList& rho)
{
    if (number_[c] < 0)
    {
        make(c);
    }
    const table& t = tables_[number_[c]];

    // The heaviest first; of what is not there the density does not matter
    SortableList<scalar> order(n);
    scalar mean = 0, sum = 0;
    for (label k = 0; k < n; ++k)
    {
        order[k] = s[k] > 0 ? -rho[k] : GREAT;
        sum += max(s[k], scalar(0));
        mean += s[k] > 0 ? s[k] * rho[k] : 0;
    }
    order.sort();
    mean /= sum;

    r_.setSize(t.faces.size());
    depth_.setSize(t.faces.size());
    scalarField& r = r_;
    r = 0;
    scalar filled = 0, lightest = 0;
    for (label i = 0; i < n && order[i] < GREAT; ++i)
    {
        lightest = -order[i];
        filled += s[order.indices()[i]] / sum;
        if (i + 1 == n || order[i + 1] == GREAT)
        {
            break;
        }
        t.fill(filled * t.below[nLayers], depth_);
        const scalar step = (order[i + 1] - order[i]) * g_;
        forAll(r, f)
        {
            r[f] += step * depth_[f];
        }
    }
    forAll(r, f)
    {
        r[f] += (mean - lightest) * g_ * t.y[f];
    }
    r -= average(r);

    // What warped faces leave of the sum, so that it is none
    vector rest(Zero);
    scalar V = 0;
    point centre(Zero);
    forAll(r, i)
    {
        const label f = t.faces[i];
        const vector S((mesh_.faceOwner()[f] == c ? 1 : -1) * mesh_.faceAreas()[f]);
        rest += r[i] * S;
        V += mesh_.faceCentres()[f] & S;
        centre += mesh_.faceCentres()[f];
    }
    V /= mesh_.nGeometricD();
    centre /= r.size();
    forAll(r, i)
    {
        const label f = t.faces[i];
        (mesh_.faceOwner()[f] == c ? own_ : nei_)[f] =
            r[i] - (rest & (mesh_.faceCentres()[f] - centre)) / V;
        set_.append(f);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fluidStrata::fluidStrata(const fvMesh& mesh, const vector& g) :
    mesh_(mesh), g_(mag(g)), up_(-g / max(g_, VSMALL))
{
    constexpr scalar along = 1e-6;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp))
        {
            return;
        }
    }
    const int D = mesh.nGeometricD();
    if (!(g_ > 0) || D < 2)
    {
        return;
    }
    boolList wanted(mesh.nCells(), false);
    bool boxes = true;
    forAll(wanted, c)
    {
        int n = 0;
        bool oblique = false;
        for (const label f : mesh.cells()[c])
        {
            if (counts(mesh, f))
            {
                const vector& S = mesh.faceAreas()[f];
                const scalar cosine = mag(S & up_) / mag(S);
                ++n;
                oblique = oblique || (cosine > along && cosine < 1 - along);
            }
        }
        wanted[c] = n > D + 1;
        boxes = boxes && !(wanted[c] && (oblique || n > 2 * D));
    }
    if (!returnReduce(boxes, andOp<bool>()))
    {
        wanted_.transfer(wanted);
        number_.setSize(mesh.nCells(), -1);
        own_.setSize(mesh.nFaces(), 0);
        nei_.setSize(mesh.nInternalFaces(), 0);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fluidStrata::update(
    const UList<label>& cells, const boolList& atInterface, const label n,
    const UList<scalar>& part, const UList<scalar>& mass)
{
    for (const label f : set_)
    {
        own_[f] = 0;
        if (f < nei_.size())
        {
            nei_[f] = 0;
        }
    }
    set_.clear();
    if (!active())
    {
        return;
    }
    // Interfaces move on: not a table of every cell that they have been in
    if (tables_.size() > 1000 + 4 * cells.size())
    {
        tables_.clear();
        number_ = -1;
    }
    scalarList rho(n);
    for (const label c : cells)
    {
        if (wanted_[c] && (atInterface[c] || beside(c, atInterface)))
        {
            const scalar* s = part.cdata() + n * c;
            for (label k = 0; k < n; ++k)
            {
                rho[k] = s[k] > 0 ? mass[n * c + k] / s[k] : 0;
            }
            set(c, n, s, rho);
        }
    }
}
