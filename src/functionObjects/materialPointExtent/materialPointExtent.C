/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointExtent

Description
    Extent of each phase and extreme values of its points: smallest and
    largest coordinate, centre of mass sum_p m_p x_p/sum_p m_p, largest |u_p|,
    largest principal stress (tension positive), smallest and largest pressure.

    Extremes are over points, not over their domains; with halfSize the
    coordinates include x_p -+ the half-size of the point, if the shape
    function gives points a size (GIMP). In directions that are not computed
    the coordinate is that of the middle of the mesh.

Usage
    \verbatim
    extent
    {
        type            materialPointExtent;
        libs            (mpmFunctionObjects);
        phases          (target flyer);
        halfSize        no;
        writeControl    timeStep;
        writeInterval   10;
    }
    \endverbatim

    \table
        Property | Description                         | Required | Default
        type     | materialPointExtent                 | yes      |
        phases   | names of phases                     | no       | all
        halfSize | include the half-size of points     | no       | no
    \endtable

    Files: <phase>.dat.

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "spectral.H"

namespace Foam::functionObjects
{

class materialPointExtent : public materialPointOutput
{
    bool halfSize_ = false;
    wordList phases_;

    wordList keywords() const override { return {"phase", "phases", "halfSize"}; }

    void prepare(const mpm::materialPointSystem& points) override
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
                    << " fvSolution.materialPoints; leave out halfSize." << exit(FatalIOError);
            }
            headers[phasei] = "Phase " + phases_[phasei] + ", coordinates of points"
                + (halfSize_ ? " -+ their half-size" : "")
                + "\n\tmin_x[m]\tmin_y[m]\tmin_z[m]\tmax_x[m]\tmax_y[m]\tmax_z[m]"
                  "\tcentre_x[m]\tcentre_y[m]\tcentre_z[m]\tmaxMagU[m/s]"
                  "\tmaxSigma[Pa]\tmin_p[Pa]\tmax_p[Pa]";
        }
        setFiles(phases_, headers);
    }

    void sample(const mpm::materialPointSystem& points) override
    {
        forAll(phases_, phasei)
        {
            const mpm::materialPointCloud& cloud = phase(points, phases_[phasei]).cloud();
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
                    centre += cloud.mass()[0][p] * x;
                    maxU2 = max(maxU2, magSqr(cloud.velocity(p)));

                    const symmTensor sigma(cloud.sigma(p));
                    const scalar mean = tr(sigma) / 3;
                    minP = min(minP, -mean);
                    maxP = max(maxP, -mean);

                    // No principal value is larger than this
                    if (mean + std::sqrt(2.0 / 3.0) * mag(dev(sigma)) > maxSigma)
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
            row(phasei) << tabs{low} << tabs{high} << tabs{centre / max(mass, VSMALL)} << tab
                        << std::sqrt(maxU2) << tab << maxSigma << tab << minP << tab << maxP
                        << endl;
        }
    }

public:
    TypeName("materialPointExtent");

    using materialPointOutput::materialPointOutput;
};

defineTypeNameAndDebug(materialPointExtent, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointExtent, dictionary);

} // End namespace Foam::functionObjects
