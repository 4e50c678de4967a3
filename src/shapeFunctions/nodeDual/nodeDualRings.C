/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "nodeDual.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tensor Foam::mpm::nodeDual::directions(const int nDim)
{
    tensor P(Zero);
    for (int d = 0; d < nDim; ++d)
    {
        P[4*d] = 1;
    }
    return P;
}


Foam::tensor Foam::mpm::nodeDual::makeRing(const int nDim, nodeRows::row& r)
{
    tensor P(directions(nDim));
    if (r.faces.empty())
    {
        return P;
    }

    // Groups of faces: patch, sum of the areas
    DynamicList<label> patch, group;
    DynamicList<vector> area;
    for (const nodeRows::ringFace& f : r.faces)
    {
        label g = 0;
        while
        (
            g < patch.size()
         && (
                patch[g] != f.patch
             || (area[g] & f.area) < 0.8660254*mag(area[g])*mag(f.area)
            )
        )
        {
            ++g;
        }
        if (g == patch.size())
        {
            patch.append(f.patch);
            area.append(vector(Zero));
        }
        area[g] += f.area;
        group.append(g);
    }

    boolList inGroup(patch.size());
    for (nodeRows::entry& e : r.entries)
    {
        scalar sum = 0;
        inGroup = false;
        forAll(r.faces, i)
        {
            const nodeRows::ringFace& f = r.faces[i];
            if (f.has(e))
            {
                inGroup[group[i]] = true;
                sum += mag(f.area)/f.nodes.size();
            }
        }
        e.N = inGroup.found(false) ? 0 : sum;
    }

    // What the planes of the groups have in common
    for (const vector& a : area)
    {
        const vector n(P & a);
        if (mag(n) > 0.1*mag(a))
        {
            P -= (n*n)/magSqr(n);
        }
    }
    return P;
}


void Foam::mpm::nodeDual::solve
(
    const int nDim,
    const label m,
    const tensor& P,
    const UList<nodeRows::entry>& row,
    scalar* W
)
{
    // Newton's method for the least of log sum N exp(-q.d), which is convex
    scalar most = 0, furthest = 0;
    for (const nodeRows::entry& e : row)
    {
        most = e.N > 0 ? max(most, mag(P & e.d)) : most;
        furthest = max(furthest, mag(e.d));
    }
    if (most <= 1e-9*furthest)
    {
        // What P leaves of the directions at a corner is rounding
        forAll(row, i)
        {
            W[i] = row[i].node == m && magSqr(row[i].d) == 0;
        }
        return;
    }
    const scalar h = most;
    vector q(Zero);
    const auto values = [&](const vector& at, vector& mean, symmTensor& square)
    {
        scalar Z = 0;
        mean = Zero;
        square = Zero;
        for (const nodeRows::entry& e : row)
        {
            if (!(e.N > 0))
            {
                continue;
            }
            const vector d((P & e.d)/h);
            const scalar w = e.N*std::exp(-(at & d));
            Z += w;
            mean += w*d;
            square += w*sqr(d);
        }
        mean /= Z;
        square /= Z;
        return std::log(Z);
    };

    vector mean;
    symmTensor square;
    scalar F = values(q, mean, square);
    bool found = false;
    for (int step = 0; step < 100 && !found && mag(q) < 50; ++step)
    {
        if (mag(mean) < 1e-15)
        {
            found = true;
            break;
        }
        // Directions that the ring does not have stay out of it
        const symmTensor H(square - sqr(mean));
        const tensor full
        (
            tensor(H) + max(tr(H), scalar(1e-300))*(tensor(tensor::I) - P)
        );
        if (det(full) <= 1e-12*pow3(tr(H)))
        {
            break;
        }
        vector dq(inv(full) & mean);
        dq *= min(scalar(1), 10/max(mag(dq), VSMALL));
        scalar share = 1;
        vector newMean;
        symmTensor newSquare;
        scalar newF = values(q + dq, newMean, newSquare);
        while (newF > F + 1e-14 && share > 1e-4)
        {
            share *= 0.5;
            newF = values(q + share*dq, newMean, newSquare);
        }
        if (mag(newMean) >= mag(mean) && mag(mean) < 1e-13)
        {
            found = true;
            break;
        }
        q += share*dq;
        F = newF;
        mean = newMean;
        square = newSquare;
    }

    scalar Z = 0;
    forAll(row, i)
    {
        W[i] =
            row[i].N > 0 ? row[i].N*std::exp(-(q & (P & row[i].d))/h) : 0;
        Z += W[i];
    }
    forAll(row, i)
    {
        const bool own = row[i].node == m && magSqr(row[i].d) == 0;
        W[i] = !found ? scalar(own) : (own ? 1 - beta : 0) + beta*W[i]/Z;
    }
}

// ************************************************************************* //
