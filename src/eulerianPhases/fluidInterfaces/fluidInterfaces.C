/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "fluidInterfaces.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fluidInterfaces::setWidths()
{
    const fvMesh& mesh = faces_.mesh;
    const vectorField& S = mesh.faceAreas();
    const auto width = [&](const label f, const label c)
    {
        scalar across = 0;
        for (const label g : mesh.cells()[c])
        {
            across += mag(S[g] & S[f]);
        }
        return 2*mesh.V()[c]*mag(S[f])/across;
    };
    widthOwn_.setSize(mesh.nFaces(), 0);
    widthNei_.setSize(mesh.nInternalFaces(), 0);
    for (label f = 0; f < mesh.nFaces(); ++f)
    {
        widthOwn_[f] = width(f, mesh.faceOwner()[f]);
    }
    for (label f = 0; f < mesh.nInternalFaces(); ++f)
    {
        widthNei_[f] = width(f, mesh.faceNeighbour()[f]);
    }
}


Foam::scalar Foam::mpm::fluidInterfaces::tangent
(
    const scalar a,
    const scalar sign,
    const scalar b,
    const scalar lambda
)
{
    // y = b x: where the tangent passes 1/2
    const scalar E = std::exp(sign*b*(2*a - 1)), e = std::exp(b);
    const scalar T = (0.5*(e + 1/e) - E)/(0.5*(e - 1/e));
    if (lambda < 1e-3)
    {
        // In the middle of the short end
        const scalar t = std::tanh(b*(1 - 0.5*lambda));
        return 0.5*(1 + sign*(t - T)/(1 - t*T));
    }
    const scalar o = std::exp(b*(1 - lambda));
    return
        0.5
      + 0.5*sign/(b*lambda)
       *std::log(E/(0.5*(o + 1/o) - 0.5*(o - 1/o)*T));
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fluidInterfaces::fluidInterfaces
(
    const gasFaces& faces,
    const coupledFaces& coupled,
    const label nFluids
)
:
    faces_(faces),
    coupled_(coupled),
    n_(nFluids),
    nShares_(nFluids == 2 ? 1 : nFluids)
{
    setWidths();
    setWeights();
    const label nCells = faces.mesh.nCells();
    const label nBoundary = faces.mesh.nFaces() - faces.mesh.nInternalFaces();
    single_.setSize(nCells + nBoundary, 0);
    major_.setSize(nCells + nBoundary, 0);
    near_.setSize(nCells + nBoundary, false);
    slot_.setSize(nCells, -1);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fluidInterfaces::update(const contents& of)
{
    if (n_ == 1)
    {
        return;
    }
    sortCells(of);
    setSlots();
    setGradients(of);
}


void Foam::mpm::fluidInterfaces::setTransverse
(
    const contents& of,
    const scalarField& phi
)
{
    const fvMesh& mesh = faces_.mesh;
    const label nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    transverse_.setSize(nShares_*cells_.size());
    forAll(cells_, s)
    {
        const label c = cells_[s];
        for (label k = 0; k < nShares_; ++k)
        {
            transverse_[nShares_*s + k] = Zero;
        }
        for (const label f : mesh.cells()[c])
        {
            const bool isOwn = own[f] == c;
            const scalar in = isOwn ? -phi[f] : phi[f];
            const bool ofCell =
                f >= nInternal && of.alphaB[n_*(f - nInternal)] < 0;
            if (!(in > 0) || ofCell)
            {
                continue;
            }
            const symmTensor nn(sqr(mesh.faceAreas()[f])*(in/sqr(faces_.magS[f])));
            for (label k = 0; k < nShares_; ++k)
            {
                const scalar there =
                    f >= nInternal
                  ? of.alphaB[n_*(f - nInternal) + k]
                  : of.part[n_*(isOwn ? nei[f] : own[f]) + k]
                   /of.theta[isOwn ? nei[f] : own[f]];
                transverse_[nShares_*s + k] +=
                    (there - of.part[n_*c + k]/of.theta[c])*nn;
            }
        }
    }
}


inline Foam::scalar Foam::mpm::fluidInterfaces::halfStep
(
    const scalar a,
    const label s,
    const label k,
    const vector& n,
    const scalar h
) const
{
    const symmTensor& T = transverse_[nShares_*s + k];
    return min(max(a + h*(tr(T) - (n & (T & n))), wisp), 1 - wisp);
}


void Foam::mpm::fluidInterfaces::sharesOfCell
(
    const contents& of,
    const label f,
    const label c,
    const scalar dt,
    scalar* alpha
) const
{
    const vector n(faces_.mesh.faceAreas()[f]/faces_.magS[f]);
    scalar sum = 0;
    for (label k = 0; k < n_; ++k)
    {
        alpha[k] = of.part[n_*c + k]/of.theta[c];
        if (k < nShares_ && alpha[k] > wisp && alpha[k] < 1 - wisp)
        {
            alpha[k] = halfStep
            (
                alpha[k], slot_[c], k, n, 0.5*dt/(faces_.mesh.V()[c]*of.theta[c])
            );
        }
        else if (alpha[k] <= wisp)
        {
            alpha[k] = 0;
        }
        if (k == nShares_)
        {
            alpha[k] = 1 - alpha[0];
        }
        sum += alpha[k];
    }
    for (label k = 0; k < n_; ++k)
    {
        alpha[k] /= sum;
    }
}


void Foam::mpm::fluidInterfaces::shares
(
    const contents& of,
    const label f,
    const label D,
    const bool fromOwner,
    const scalar dt,
    const scalar phi,
    const scalar out,
    const scalar* receiver,
    scalar* alpha
) const
{
    const fvMesh& mesh = faces_.mesh;
    const scalar* part = of.part.cdata() + n_*D;
    const scalar theta = of.theta[D];
    if (single_[D] >= 0)
    {
        for (label k = 0; k < n_; ++k)
        {
            alpha[k] = k == single_[D];
        }
        return;
    }

    const label s = slot_[D];
    const scalar V = mesh.V()[D];
    const vector n((fromOwner ? 1 : -1)*mesh.faceAreas()[f]/faces_.magS[f]);
    const scalar h = fromOwner ? widthOwn_[f] : widthNei_[f];
    const scalar lambda =
        min(scalar(1), mag(phi)*dt/(theta*faces_.magS[f]*h));
    for (label k = 0; k < nShares_; ++k)
    {
        scalar a = part[k]/theta;
        if (a > wisp && a < 1 - wisp)
        {
            a = halfStep(a, s, k, n, 0.5*dt/(V*theta));
            const vector& g = gradient_[nShares_*s + k];
            const scalar size = mag(g), own = part[k]/theta;
            const scalar along = (g & n)/max(size, VSMALL);
            const scalar contrast = size*h/(V*own*(1 - own));
            const scalar b =
                beta*mag(along)
               *min(max((contrast - mixed)/(sharp - mixed), 0.0), 1.0);
            if (b > 1e-3)
            {
                a = tangent(a, along > 0 ? 1 : -1, b, lambda);
            }
        }
        alpha[k] = min(max(a, scalar(0)), scalar(1));
    }
    if (nShares_ < n_)
    {
        alpha[1] = 1 - alpha[0];
    }

    // Within what there is
    const scalar volume = dt*out/V;
    scalar sum = 0, room = 0;
    for (label k = 0; k < n_; ++k)
    {
        const scalar all = part[k]/volume;
        if (part[k] < wisp*theta)
        {
            alpha[k] = receiver[k] > part[k]/theta ? min(all, scalar(1)) : 0;
        }
        else
        {
            alpha[k] = min(alpha[k], all);
        }
        sum += alpha[k];
    }
    if (sum > 1)
    {
        for (label k = 0; k < n_; ++k)
        {
            alpha[k] /= sum;
        }
    }
    else if (sum < 1)
    {
        const auto spare = [&](const label k)
        {
            return
                part[k] < wisp*theta
              ? scalar(0) : min(part[k]/volume, scalar(1)) - alpha[k];
        };
        for (label k = 0; k < n_; ++k)
        {
            room += spare(k);
        }
        for (label k = 0; k < n_; ++k)
        {
            alpha[k] += (1 - sum)*spare(k)/max(room, VSMALL);
        }
    }
}

// ************************************************************************* //
