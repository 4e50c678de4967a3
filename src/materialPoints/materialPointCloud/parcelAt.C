// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "parcelAt.H"
#include "polyMesh.H"
#include "tetIndices.H"

Foam::autoPtr<Foam::passiveParticle>
Foam::mpm::parcelAt(const polyMesh& mesh, const point& x, const label celli)
{
    // Of a place that is no number the centre
    barycentric best(1, 0, 0, 0);
    tetIndices of(celli, mesh.cells()[celli][0], 1);
    scalar deepest = -GREAT;
    const auto look = [&](const label c)
    {
        const vector& centre = mesh.cellCentres()[c];
        for (const label facei : mesh.cells()[c])
        {
            for (label i = 1; i < mesh.faces()[facei].size() - 1 && deepest < 0; ++i)
            {
                const tetIndices tet(c, facei, i);
                const triFace corners(tet.faceTriIs(mesh));
                const vector d = x - centre;
                const vector e1 = mesh.points()[corners[0]] - centre;
                const vector e2 = mesh.points()[corners[1]] - centre;
                const vector e3 = mesh.points()[corners[2]] - centre;
                const scalar six = e1 & (e2 ^ e3);
                if (mag(six) <= SMALL * mag(e1) * mag(e2) * mag(e3))
                {
                    continue;
                }
                const scalar l1 = (d & (e2 ^ e3)) / six;
                const scalar l2 = (d & (e3 ^ e1)) / six;
                const scalar l3 = (d & (e1 ^ e2)) / six;
                const barycentric l(1 - l1 - l2 - l3, l1, l2, l3);
                if (cmptMin(l) > deepest)
                {
                    deepest = cmptMin(l);
                    best = l;
                    of = tet;
                }
            }
        }
    };
    look(celli);
    for (const label facei : mesh.cells()[celli])
    {
        if (deepest < 0 && mesh.isInternalFace(facei))
        {
            const label owner = mesh.faceOwner()[facei];
            look(owner == celli ? mesh.faceNeighbour()[facei] : owner);
        }
    }
    if (deepest < -1e-9)
    {
        for (const label pointi : mesh.cells()[celli].labels(mesh.faces()))
        {
            for (const label c : labelList(mesh.pointCells(pointi)))
            {
                look(c);
            }
        }
    }
    return autoPtr<passiveParticle>(
        new passiveParticle(mesh, best, of.cell(), of.face(), of.tetPt()));
}
