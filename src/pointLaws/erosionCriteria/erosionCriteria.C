/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    The criteria of the table in erosionCriterion.H.

\*---------------------------------------------------------------------------*/

#include "erosionCriterion.H"
#include "selector.H"
#include "PtrList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace mpm
{

//- A history column of the law above a limit
class columnErosion
:
    public erosionCriterion
{
    const scalar limit_;
    const int column_;

public:

    columnErosion(const dictionary& dict, const erodible& of, const word& name)
    :
        limit_(positive(dict, "limit")),
        column_(of.law.columnOf(name, of.nDim))
    {
        checkKeywords(dict, {"type", "limit"});
        if (column_ < 0)
        {
            FatalIOErrorInFunction(dict)
                << "erosion by " << dict.get<word>("type") << " needs a law"
                << " with the column " << name << "; " << of.law.type()
                << " has none." << exit(FatalIOError);
        }
    }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        const scalar* value = b.points.history[column_];
        for (label p = 0; p < b.points.n; ++p)
        {
            gone[p] = gone[p] || value[p] > limit_;
        }
    }
};


class plasticStrainErosion
:
    public columnErosion
{
public:

    TypeName("plasticStrain");

    plasticStrainErosion(const dictionary& dict, const erodible& of)
    :
        columnErosion(dict, of, "plasticStrain")
    {}
};


class temperatureErosion
:
    public columnErosion
{
public:

    TypeName("temperature");

    temperatureErosion(const dictionary& dict, const erodible& of)
    :
        columnErosion(dict, of, "T")
    {}
};


class volumeRatioErosion
:
    public erosionCriterion
{
    const scalar rho_;
    scalar min_, max_;

public:

    TypeName("volumeRatio");

    volumeRatioErosion(const dictionary& dict, const erodible& of)
    :
        rho_(of.law.rho()),
        min_(boundedOrDefault(dict, "min", 0, 0, 1)),
        max_(boundedOrDefault(dict, "max", GREAT, 1, GREAT))
    {
        checkKeywords(dict, {"type", "min", "max"});
        if (!dict.found("min") && !dict.found("max"))
        {
            FatalIOErrorInFunction(dict)
                << "erosion by volumeRatio needs one or both of min (0 to 1)"
                << " and max (1 or more)." << exit(FatalIOError);
        }
    }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (label p = 0; p < b.points.n; ++p)
        {
            const scalar J = rho_*b.points.volume[p]/b.points.mass[p];
            gone[p] = gone[p] || J > max_ || J < min_;
        }
    }
};


//- Damage that has been 1 for a time
class damageErosion
:
    public erosionCriterion
{
    const scalar time_;

protected:

    bool marks(const erosionBlock& b, const label p) const
    {
        return b.points.damage[p] >= 1 && b.failedTime[p] >= time_;
    }

public:

    TypeName("damage");

    damageErosion(const dictionary& dict, const erodible& of)
    :
        time_(boundedOrDefault(dict, "time", 0, 0, GREAT))
    {
        checkKeywords(dict, {"type", "time"});
        if (!of.fails)
        {
            FatalIOErrorInFunction(dict)
                << "erosion by " << dict.get<word>("type") << " needs a"
                << " failureModel beside it in the phase: without one points"
                << " have no damage." << exit(FatalIOError);
        }
    }

    bool needsFailedTime() const override
    {
        return true;
    }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (label p = 0; p < b.points.n; ++p)
        {
            gone[p] = gone[p] || marks(b, p);
        }
    }
};


class loneErosion
:
    public damageErosion
{
public:

    TypeName("lone");

    using damageErosion::damageErosion;

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (label k = 0; k + 1 < b.start.size(); ++k)
        {
            const label p = b.start[k];
            if (b.start[k + 1] == p + 1)
            {
                gone[p] = gone[p] || marks(b, p);
            }
        }
    }
};


class speedErosion
:
    public erosionCriterion
{
    const scalar limit_;

public:

    TypeName("speed");

    speedErosion(const dictionary& dict, const erodible&)
    :
        limit_(positive(dict, "limit"))
    {
        checkKeywords(dict, {"type", "limit"});
    }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (label p = 0; p < b.points.n; ++p)
        {
            scalar U2 = 0;
            for (int d = 0; d < b.points.nDim; ++d)
            {
                U2 += sqr(b.U[d][p]);
            }
            gone[p] = gone[p] || U2 > sqr(limit_);
        }
    }
};


class anyErosion
:
    public erosionCriterion
{
    PtrList<erosionCriterion> parts_;

public:

    TypeName("any");

    anyErosion(const dictionary& dict, const erodible& of)
    {
        for (const entry& e : dict)
        {
            if (e.keyword() != "type")
            {
                parts_.append
                (
                    erosionCriterion::New(requiredDict(dict, e.keyword()), of)
                );
            }
        }
        if (parts_.empty())
        {
            FatalIOErrorInFunction(dict)
                << "erosion by any needs a dictionary { type ...; } for each"
                << " of its criteria." << exit(FatalIOError);
        }
    }

    bool needsFailedTime() const override
    {
        for (const erosionCriterion& part : parts_)
        {
            if (part.needsFailedTime())
            {
                return true;
            }
        }
        return false;
    }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (const erosionCriterion& part : parts_)
        {
            part.mark(b, gone);
        }
    }
};

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

#define addErosion(criterion)                                                  \
    defineTypeNameAndDebug(criterion, 0);                                      \
    addToRunTimeSelectionTable(erosionCriterion, criterion, dictionary)

addErosion(plasticStrainErosion);
addErosion(temperatureErosion);
addErosion(volumeRatioErosion);
addErosion(damageErosion);
addErosion(loneErosion);
addErosion(speedErosion);
addErosion(anyErosion);

#undef addErosion

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
