// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "coupledCells.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::coupledCells::coupledCells(const polyMesh& mesh, ghostCells& ghosts) :
    cell(mesh.nFaces() - mesh.nInternalFaces(), label(-1)),
    separation(cell.size(), Zero),
    cyclic(false)
{
    // Cells behind cyclic faces
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(pp))
        {
            const labelUList& nbr = refCast<const cyclicPolyPatch>(pp).neighbPatch().faceCells();
            forAll(pp, i)
            {
                const label facei = pp.start() + i - mesh.nInternalFaces();
                cell[facei] = nbr[i];
                separation[facei] =
                    refCast<const cyclicPolyPatch>(pp).neighbPatch().faceCentres()[i]
                    - pp.faceCentres()[i];
                cyclic = true;
            }
        }
    }

    // Cells of other processors
    if (Pstream::parRun())
    {
        labelList nbrCell(cell.size(), -1);
        vectorField nbrCentre(cell.size(), Zero);
        forAll(nbrCell, i)
        {
            nbrCell[i] = mesh.faceOwner()[mesh.nInternalFaces() + i];
            nbrCentre[i] = mesh.faceCentres()[mesh.nInternalFaces() + i];
        }
        syncTools::swapBoundaryFaceList(mesh, nbrCell);
        syncTools::swapBoundaryFaceList(mesh, nbrCentre);

        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            if (isA<processorPolyPatch>(pp))
            {
                const label proci = refCast<const processorPolyPatch>(pp).neighbProcNo();
                const bool shifted = isA<processorCyclicPolyPatch>(pp);
                forAll(pp, i)
                {
                    const label facei = pp.start() + i - mesh.nInternalFaces();
                    cell[facei] = ghosts.add(proci, nbrCell[facei]);
                    if (shifted)
                    {
                        separation[facei] = nbrCentre[facei] - pp.faceCentres()[i];
                        cyclic = true;
                    }
                }
            }
        }
    }
}
