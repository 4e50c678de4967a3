// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointGridTransfer.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(pointGridTransfer, 0);
defineRunTimeSelectionTable(pointGridTransfer, grid);
}

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::word Foam::mpm::pointGridTransfer::usual(const pointGrid& grid)
{
    try
    {
        const auto iter = gridConstructorTablePtr_->cfind("GIMP");
        iter.val()(grid);
        return "GIMP";
    }
    catch (const string&)
    {
        return "nodeDual";
    }
}

Foam::autoPtr<Foam::mpm::pointGridTransfer>
Foam::mpm::pointGridTransfer::New(const dictionary& dict, const pointGrid& grid)
{
    const word name(dict.get<word>("shapeFunction"));

    if (gridConstructorTablePtr_)
    {
        const auto iter = gridConstructorTablePtr_->cfind(name);
        if (iter.good())
        {
            try
            {
                autoPtr<pointGridTransfer> passes(iter.val()(grid));
                passes->cellMeans =
                    oneOfOrDefault(dict, "dilatation", "point", {"point", "cellMean"})
                    == "cellMean";
                return passes;
            }
            catch (const string& reason)
            {
                FatalIOErrorInFunction(dict)
                    << "The shape function " << name << " does not allow this mesh: " << reason
                    << "." << nl << "linear allows every mesh of hexahedra, nodeDual any"
                    << " cells, GIMP needs boxes along the axes without"
                    << " re-entrant corners, quadraticBSpline and"
                    << " cubicBSpline also one width of all cells in each"
                    << " direction." << exit(FatalIOError);
            }
        }
    }

    const wordList valid(
        gridConstructorTablePtr_ ? gridConstructorTablePtr_->sortedToc() : wordList());
    FatalIOErrorInFunction(dict) << "Unknown shapeFunction " << name << meant(name, valid).c_str()
                                 << nl << nl << "Valid shape functions are: " << valid
                                 << exit(FatalIOError);

    return nullptr;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarList
Foam::mpm::pointGridTransfer::nodeVolumes(const pointGrid& grid, const bool byRadius) const
{
    return grid.nodeVolumes(grid.shared(reach()), byRadius);
}

Foam::scalar Foam::mpm::pointGridTransfer::meanWidth(const pointGrid& grid, const label celli) const
{
    scalar product = 1;
    for (int d = 0; d < grid.nDim(); ++d)
    {
        product *= grid.width(celli, d);
    }
    return grid.nDim() == 1 ? product : grid.nDim() == 2 ? std::sqrt(product) : std::cbrt(product);
}

void Foam::mpm::pointGridTransfer::forNodesOf(
    const materialPointCloud& cloud, const boolList& marked,
    const std::function<void(const label, const label, const scalar, const scalar*)>& f) const
{
    const int D = cloud.grid().nDim(), radial = cloud.grid().radial();
    const column* half = cloud.halfSize();
    DynamicList<label> nodes;
    DynamicList<scalar> S, gradS;
    forStencils(
        cloud,
        [&](const label k, const labelUList& stencil)
        {
            bool near = false;
            for (const label node : stencil)
            {
                near = near || (node >= 0 && marked[node]);
            }
            const label end = near ? cloud.start()[k + 1] : cloud.start()[k];
            for (label p = cloud.start()[k]; p < end; ++p)
            {
                scalar x[3], l[3] = {0, 0, 0};
                for (int d = 0; d < D; ++d)
                {
                    x[d] = cloud.x()[d][p];
                    l[d] = half ? (*half)[d][p] : 0;
                }
                weights(cloud.cells()[k], x, half ? l : nullptr, nodes, S, gradS);
                const scalar v = cloud.volume()[0][p];
                forAll(nodes, i)
                {
                    if (nodes[i] < 0 || !marked[nodes[i]])
                    {
                        continue;
                    }
                    scalar A[3];
                    for (int d = 0; d < D; ++d)
                    {
                        A[d] = v * gradS[D * i + d];
                    }
                    if (radial >= 0)
                    {
                        A[radial] += v * S[i] / x[radial];
                    }
                    f(p, nodes[i], S[i], A);
                }
            }
        });
}
