/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointPasses.H"
#include "selector.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(pointPasses, 0);
    defineRunTimeSelectionTable(pointPasses, grid);
}
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::mpm::pointPasses>
Foam::mpm::pointPasses::New(const dictionary& dict, const hexGrid& grid)
{
    const word name(dict.get<word>("shapeFunction"));

    if (gridConstructorTablePtr_)
    {
        const auto iter = gridConstructorTablePtr_->cfind(name);
        if (iter.good())
        {
            try
            {
                autoPtr<pointPasses> passes(iter.val()(grid));
                passes->cellMeans =
                    oneOfOrDefault
                    (
                        dict, "dilatation", "point", {"point", "cellMean"}
                    )
                 == "cellMean";
                return passes;
            }
            catch (const string& reason)
            {
                FatalIOErrorInFunction(dict)
                    << "The shape function " << name
                    << " does not allow this mesh: " << reason << "." << nl
                    << "linear allows every mesh of hexahedra, GIMP needs"
                    << " boxes along the axes without re-entrant corners,"
                    << " quadraticBSpline and cubicBSpline also one width of"
                    << " all cells in each direction. Cells refined locally do"
                    << " not work: for finer cells in a place grade the blocks"
                    << " of the mesh (simpleGrading), or refine all."
                    << exit(FatalIOError);
            }
        }
    }

    FatalIOErrorInFunction(dict)
        << "Unknown shapeFunction " << name << nl << nl
        << "Valid shape functions are: "
        << (gridConstructorTablePtr_ ? gridConstructorTablePtr_->sortedToc() : wordList())
        << exit(FatalIOError);

    return nullptr;
}

// ************************************************************************* //
