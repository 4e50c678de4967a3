// A function object of a user: the centre of mass of a phase over time

#include "materialPointOutput.H"
#include "addToRunTimeSelectionTable.H"
#include <numeric>

namespace Foam::functionObjects
{

struct centreOfMass
:
    public materialPointOutput
{
    word phase_;

    TypeName("centreOfMass");

    centreOfMass(const word& name, const Time& time, const dictionary& dict)
    :
        materialPointOutput(name, time, dict)
    {
        read(dict);
    }

    wordList keywords() const override { return {"phase"}; }

    void prepare(const mpm::materialPointSystem& points) override
    {
        phase_ = selectedPhases(points).first();
        setFiles({phase_}, {"x[m]\ty[m]\tz[m]"});
    }

    void sample(const mpm::materialPointSystem& points) override
    {
        const mpm::materialPointCloud& cloud = phase(points, phase_).cloud();
        const scalar* m = cloud.mass()[0];
        vector x(Zero);
        forAll(cloud.cells(), k)
        {
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                x += m[p]*cloud.position(p, cloud.cells()[k]);
            }
        }
        scalar M = std::accumulate(m, m + cloud.size(), scalar(0));
        reduce(x, sumOp<vector>());
        reduce(M, sumOp<scalar>());
        x /= M;
        if (Pstream::master())
        {
            row(0) << tab << x.x() << tab << x.y() << tab << x.z() << endl;
        }
    }
};

defineTypeNameAndDebug(centreOfMass, 0);
addToRunTimeSelectionTable(functionObject, centreOfMass, dictionary);

} // End namespace Foam::functionObjects
