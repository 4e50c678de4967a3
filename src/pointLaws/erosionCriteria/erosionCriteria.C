/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    The criteria of the table in erosionCriterion.H.

\*---------------------------------------------------------------------------*/

#include "erosionCriterion.H"
#include "PtrList.H"
#include "point.H"

namespace Foam::mpm
{

//- A history column of the law above a limit
class columnErosion : public erosionCriterion
{
    const scalar limit_;
    const int column_;

public:
    columnErosion(const dictionary& dict, const erodible& of, const word& name) :
        limit_(positive(dict, "limit")), column_(of.law.columnOf(name, of.nDim))
    {
        checkKeywords(dict, {"type", "limit"});
        if (column_ < 0)
        {
            FatalIOErrorInFunction(dict)
                << "erosion by " << dict.get<word>("type") << " needs a law"
                << " with the column " << name << "; " << of.law.type() << " has none."
                << exit(FatalIOError);
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

class plasticStrainErosion : public columnErosion
{
public:
    TypeName("plasticStrain");

    plasticStrainErosion(const dictionary& dict, const erodible& of) :
        columnErosion(dict, of, "plasticStrain")
    {
    }
};

class temperatureErosion : public columnErosion
{
public:
    TypeName("temperature");

    temperatureErosion(const dictionary& dict, const erodible& of) : columnErosion(dict, of, "T") {}
};

class volumeRatioErosion : public erosionCriterion
{
    const scalar rho_;
    scalar min_, max_;

public:
    TypeName("volumeRatio");

    volumeRatioErosion(const dictionary& dict, const erodible& of) :
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
            const scalar J = rho_ * b.points.volume[p] / b.points.mass[p];
            gone[p] = gone[p] || J > max_ || J < min_;
        }
    }
};

//- Damage that has been 1 for a time
class damageErosion : public erosionCriterion
{
    const scalar time_;

protected:
    bool marks(const erosionBlock& b, const label p) const
    {
        return b.points.damage[p] >= 1 && b.failedTime[p] >= time_;
    }

public:
    TypeName("damage");

    damageErosion(const dictionary& dict, const erodible& of) :
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

    bool needsFailedTime() const override { return true; }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (label p = 0; p < b.points.n; ++p)
        {
            gone[p] = gone[p] || marks(b, p);
        }
    }
};

class loneErosion : public damageErosion
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

class speedErosion : public erosionCriterion
{
    const scalar limit_;

public:
    TypeName("speed");

    speedErosion(const dictionary& dict, const erodible&) : limit_(positive(dict, "limit"))
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

class outsideErosion : public erosionCriterion
{
    const point min_, max_;

public:
    TypeName("outside");

    outsideErosion(const dictionary& dict, const erodible&) :
        min_(required<vector>(dict, "min")), max_(required<vector>(dict, "max"))
    {
        checkKeywords(dict, {"type", "min", "max"});
        if (!(cmptMin(max_ - min_) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "The box of erosion by outside is empty: min is " << min_ << ", max is " << max_
                << "." << exit(FatalIOError);
        }
    }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (int d = 0; d < b.points.nDim; ++d)
        {
            const scalar low = min_[b.axis[d]], high = max_[b.axis[d]];
            for (label p = 0; p < b.points.n; ++p)
            {
                gone[p] = gone[p] || b.x[d][p] < low || b.x[d][p] > high;
            }
        }
    }
};

class timeStepErosion : public erosionCriterion
{
    //- Limit of h/speed [s], 0: none; of the speed [m/s]
    scalar limit_, fastest_;

    bool marks(const scalar width, const scalar speed) const
    {
        return width < limit_ * speed || speed > fastest_;
    }

public:
    TypeName("timeStep");

    timeStepErosion(const dictionary& dict, const erodible& of) :
        limit_(dict.found("limit") ? positive(dict, "limit") : 0), fastest_(GREAT)
    {
        checkKeywords(dict, {"type", limit_ > 0 ? "limit" : "share"});
        const scalar c0 = of.law.waveSpeed();
        if (limit_ > 0)
        {
            return;
        }
        if (!(c0 > 0))
        {
            FatalIOErrorInFunction(dict) << "erosion by timeStep needs a limit [s]: the law "
                                         << of.law.type() << " has no sound speed to take a share"
                                         << " from." << exit(FatalIOError);
        }
        fastest_ = c0 / boundedOrDefault(dict, "share", 0.25, 1e-6, 0.5);
    }

    bool needsSpeeds(const scalar width, const scalar speed) const override
    {
        return marks(width, speed);
    }

    void mark(const erosionBlock& b, boolList& gone) const override
    {
        for (label p = 0; b.speed && p < b.points.n; ++p)
        {
            gone[p] = gone[p] || marks(b.width[p], b.speed[p]);
        }
    }
};

class anyErosion : public erosionCriterion
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
                parts_.append(erosionCriterion::New(requiredDict(dict, e.keyword()), of));
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

    bool needsSpeeds(const scalar width, const scalar speed) const override
    {
        for (const erosionCriterion& part : parts_)
        {
            if (part.needsSpeeds(width, speed))
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

defineTypeNameAndDebug(erosionCriterion, 0);
defineRunTimeSelectionTable(erosionCriterion, dictionary);

#define addErosion(criterion)                                                                      \
    defineTypeNameAndDebug(criterion, 0);                                                          \
    addToRunTimeSelectionTable(erosionCriterion, criterion, dictionary)

addErosion(plasticStrainErosion);
addErosion(temperatureErosion);
addErosion(volumeRatioErosion);
addErosion(damageErosion);
addErosion(loneErosion);
addErosion(speedErosion);
addErosion(outsideErosion);
addErosion(timeStepErosion);
addErosion(anyErosion);

#undef addErosion

} // End namespace Foam::mpm
