/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "nodeDual.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"

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



Foam::labelListList Foam::mpm::nodeDual::boundaryFaces(const pointGrid& grid)
{
    const polyMesh& mesh = grid.mesh();
    List<DynamicList<label>> faces(grid.nNodes());
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled() || isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        forAll(pp, i)
        {
            for (const label pointi : pp[i])
            {
                DynamicList<label>& of = faces[grid.pointToNode()[pointi]];
                if (!of.found(pp.start() + i))
                {
                    of.append(pp.start() + i);
                }
            }
        }
    }
    labelListList lists(grid.nNodes());
    forAll(lists, n)
    {
        lists[n] = faces[n];
    }
    return lists;
}


Foam::tensor Foam::mpm::nodeDual::makeRing
(
    const pointGrid& grid,
    const label m,
    const labelUList& faces,
    DynamicList<entry>& row
)
{
    const polyMesh& mesh = grid.mesh();

    // Groups of faces: patch, sum of the areas in the computed directions
    DynamicList<label> patch, group;
    DynamicList<vector> area;
    DynamicList<vector> S;
    for (const label facei : faces)
    {
        vector s(Zero);
        for (int d = 0; d < grid.nDim(); ++d)
        {
            s[d] = mesh.faceAreas()[facei][grid.direction(d)];
        }
        S.append(s);
        const label patchi = mesh.boundaryMesh().whichPatch(facei);
        label g = 0;
        while
        (
            g < patch.size()
         && (
                patch[g] != patchi
             || (area[g] & s) < 0.8660254*mag(area[g])*mag(s)
            )
        )
        {
            ++g;
        }
        if (g == patch.size())
        {
            patch.append(patchi);
            area.append(vector(Zero));
        }
        area[g] += s;
        group.append(g);
    }

    for (entry& e : row)
    {
        e.N = 0;
        bool all = true;
        for (label g = 0; all && g < patch.size(); ++g)
        {
            bool found = false;
            forAll(faces, i)
            {
                const face& f = mesh.faces()[faces[i]];
                for (const label pointi : f)
                {
                    found =
                        found
                     || (
                            group[i] == g
                         && grid.pointToNode()[pointi] == e.node
                        );
                }
            }
            all = found;
        }
        if (!all)
        {
            continue;
        }
        forAll(faces, i)
        {
            const face& f = mesh.faces()[faces[i]];
            bool found = false;
            for (const label pointi : f)
            {
                found = found || grid.pointToNode()[pointi] == e.node;
            }
            e.N += found ? mag(S[i])/f.size() : 0;
        }
    }

    // What the planes of the groups have in common
    tensor P(directions(grid.nDim()));
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
    const DynamicList<entry>& row,
    scalar* W
)
{
    // Newton's method for the least of log sum N exp(-q.d), which is convex
    scalar most = 0, size = 0;
    for (const entry& e : row)
    {
        most = e.N > 0 ? max(most, mag(P & e.d)) : most;
        size = max(size, mag(e.d));
    }
    // Of an oblique corner P is zero to rounding
    const bool reaches = most > 1e-6*size;
    const scalar h = reaches ? most : 1;
    vector q(Zero);
    const auto values = [&](const vector& at, vector& mean, symmTensor& square)
    {
        scalar Z = 0;
        mean = Zero;
        square = Zero;
        for (const entry& e : row)
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
    scalar F = reaches ? values(q, mean, square) : 0;
    bool found = false;
    for (int step = 0; step < 100 && reaches && !found && mag(q) < 50; ++step)
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
        const vector dq(inv(full) & mean);
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
    const bool alone = !found;
    forAll(row, i)
    {
        const bool own = row[i].node == m && magSqr(row[i].d) == 0;
        W[i] = alone ? scalar(own) : (own ? 1 - beta : 0) + beta*W[i]/Z;
    }
}

// ************************************************************************* //
