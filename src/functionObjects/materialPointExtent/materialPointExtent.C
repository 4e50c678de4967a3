/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointExtent.H"
#include "addToRunTimeSelectionTable.H"
#include "spectral.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(materialPointExtent, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        materialPointExtent,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

void writeVector(Ostream& os, const vector& v)
{
    for (const scalar c : v)
    {
        os  << tab << c;
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::materialPointExtent::keywords() const
{
    return {"phase", "phases", "halfSize"};
}


void Foam::functionObjects::materialPointExtent::prepare
(
    const mpm::materialPointSystem& points
)
{
    halfSize_ = dict_.getOrDefault<bool>("halfSize", false);
    phases_ = selectedPhases(points);

    List<string> headers(phases_.size());
    forAll(phases_, phasei)
    {
        if (halfSize_ && !phase(points, phases_[phasei]).cloud().halfSize())
        {
            FatalIOErrorInFunction(dict_)
                << "Points have no half-size with this shape function of"
                << " fvSolution.materialPoints; leave out halfSize."
                << exit(FatalIOError);
        }
        headers[phasei] =
            "Phase " + phases_[phasei] + ", coordinates of points"
          + (halfSize_ ? " -+ their half-size" : "")
          + "\n\tmin_x[m]\tmin_y[m]\tmin_z[m]\tmax_x[m]\tmax_y[m]\tmax_z[m]"
            "\tcentre_x[m]\tcentre_y[m]\tcentre_z[m]\tmaxMagU[m/s]"
            "\tmaxSigma[Pa]\tmin_p[Pa]\tmax_p[Pa]";
    }
    setFiles(phases_, headers);
}


void Foam::functionObjects::materialPointExtent::sample
(
    const mpm::materialPointSystem& points
)
{
    forAll(phases_, phasei)
    {
        const mpm::materialPointCloud& cloud =
            phase(points, phases_[phasei]).cloud();
        const mpm::pointGrid& grid = cloud.grid();

        vector low(vector::max), high(vector::min), centre(Zero);
        scalar mass = 0, maxU2 = 0;
        scalar maxSigma = -VGREAT, minP = VGREAT, maxP = -VGREAT;

        forAll(cloud.cells(), k)
        {
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                const point x(cloud.position(p, cloud.cells()[k]));
                vector h(Zero);
                for (int d = 0; halfSize_ && d < grid.nDim(); ++d)
                {
                    h[grid.direction(d)] = (*cloud.halfSize())[d][p];
                }
                low = min(low, x - h);
                high = max(high, x + h);

                mass += cloud.mass()[0][p];
                centre += cloud.mass()[0][p]*x;
                maxU2 = max(maxU2, magSqr(cloud.velocity(p)));

                const symmTensor sigma(cloud.sigma(p));
                const scalar mean = tr(sigma)/3;
                minP = min(minP, -mean);
                maxP = max(maxP, -mean);

                // No principal value is larger than this
                if (mean + std::sqrt(2.0/3.0)*mag(dev(sigma)) > maxSigma)
                {
                    const tensor t(sigma);
                    double s[9];
                    std::copy(t.begin(), t.end(), s);
                    maxSigma = max(maxSigma, mpm::largestPrincipal(s));
                }
            }
        }

        reduce(low, minOp<vector>());
        reduce(high, maxOp<vector>());
        reduce(centre, sumOp<vector>());
        reduce(mass, sumOp<scalar>());
        reduce(maxU2, maxOp<scalar>());
        reduce(maxSigma, maxOp<scalar>());
        reduce(minP, minOp<scalar>());
        reduce(maxP, maxOp<scalar>());

        if (!returnReduce(cloud.size(), sumOp<label>()))
        {
            low = high = Zero;
            maxSigma = minP = maxP = 0;
        }

        if (!Pstream::master())
        {
            continue;
        }
        Ostream& os = row(phasei);
        writeVector(os, low);
        writeVector(os, high);
        writeVector(os, centre/max(mass, VSMALL));
        os  << tab << std::sqrt(maxU2) << tab << maxSigma << tab << minP << tab
            << maxP << endl;
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::materialPointExtent::materialPointExtent
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    materialPointOutput(name, runTime, dict),
    halfSize_(false)
{
    read(dict);
}

// ************************************************************************* //
