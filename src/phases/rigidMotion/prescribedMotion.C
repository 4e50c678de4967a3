// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "prescribedMotion.H"
#include "dictionaryTools.H"
#include "ListOps.H"
#include "TableBase.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::prescribedMotion::start(const scalar time, const materialPointCloud&)
{
    path_ = pathNew_ = Zero;
    placement_ = place(path_, rate(time));
    checkDirection(placement_.velocity, "velocity");
}

Foam::dictionary Foam::mpm::prescribedMotion::state() const
{
    dictionary state;
    state.add("path", path_);
    return state;
}

void Foam::mpm::prescribedMotion::setState(const scalar time, const dictionary& state)
{
    path_ = pathNew_ = required<vector>(state, "path");
    placement_ = place(path_, rate(time));
}

void Foam::mpm::prescribedMotion::advance(const scalar t0, const scalar t1)
{
    // Gauss' points and weights on [-1, 1]
    static const scalar at[5] = {
        0, 0.538469310105683091, -0.538469310105683091, 0.906179845938663993,
        -0.906179845938663993};
    static const scalar weight[5] = {
        0.568888888888888889, 0.478628670499366468, 0.478628670499366468, 0.236926885056189088,
        0.236926885056189088};

    DynamicList<scalar> ends;
    addKinks(t0, t1, ends);
    Foam::sort(ends);
    ends.append(t1);

    vector sum(Zero);
    scalar from = t0;
    for (const scalar to : ends)
    {
        const scalar half = 0.5 * (to - from), middle = 0.5 * (from + to);
        for (int i = 0; i < 5; ++i)
        {
            sum += half * weight[i] * rate(middle + half * at[i]);
        }
        from = to;
    }
    pathNew_ = path_ + sum;
    placement_ = place(pathNew_, rate(t1));
    checkDirection(placement_.velocity, "velocity");
}

namespace Foam::mpm
{

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

template<class Type>
void prescribedMotion::kinks(
    const Function1<Type>& f, const scalar t0, const scalar t1, DynamicList<scalar>& times)
{
    if (const auto* table = dynamic_cast<const Function1Types::TableBase<Type>*>(&f))
    {
        const scalarField t(table->x());
        for (const scalar ti : t)
        {
            if (ti > t0 && ti < t1)
            {
                times.append(ti);
            }
        }
    }
}

// For motions of other libraries
template void
prescribedMotion::kinks(const Function1<scalar>&, const scalar, const scalar, DynamicList<scalar>&);
template void
prescribedMotion::kinks(const Function1<vector>&, const scalar, const scalar, DynamicList<scalar>&);

// * * * * * * * * * * * * * * * * * Classes * * * * * * * * * * * * * * * * //

//- At rest
class fixedMotion : public prescribedMotion
{
public:
    TypeName("fixed");

    fixedMotion(const dictionary& dict, const pointGrid& grid) : prescribedMotion(grid)
    {
        checkKeywords(dict, {"type"});
    }

    bool moves() const override { return false; }

    vector rate(const scalar) const override { return Zero; }

    void addKinks(const scalar, const scalar, DynamicList<scalar>&) const override {}

    placement place(const vector&, const vector&) const override { return placement(); }
};

//- Moves with a velocity over time, without turning
class translationMotion : public prescribedMotion
{
    autoPtr<Function1<vector>> velocity_;

public:
    TypeName("translation");

    translationMotion(const dictionary& dict, const pointGrid& grid) : prescribedMotion(grid)
    {
        checkKeywords(dict, {"type", "velocity", "velocityCoeffs"});
        requireKeyword(dict, "velocity");
        velocity_ = Function1<vector>::New("velocity", dict);
    }

    vector rate(const scalar time) const override { return velocity_->value(time); }

    void addKinks(const scalar t0, const scalar t1, DynamicList<scalar>& times) const override
    {
        kinks(*velocity_, t0, t1, times);
    }

    placement place(const vector& path, const vector& rate) const override
    {
        placement p;
        p.shift = path;
        p.velocity = rate;
        return p;
    }
};

//- Rotates about a fixed axis
class rotationMotion : public prescribedMotion
{
    const point origin_;
    vector axis_;
    autoPtr<Function1<scalar>> omega_;

public:
    TypeName("rotation");

    rotationMotion(const dictionary& dict, const pointGrid& grid) :
        prescribedMotion(grid),
        origin_(required<point>(dict, "origin")),
        axis_(required<vector>(dict, "axis"))
    {
        checkKeywords(dict, {"type", "origin", "axis", "omega", "omegaCoeffs"});
        requireKeyword(dict, "omega");
        omega_ = Function1<scalar>::New("omega", dict);

        // In 2D only the direction that is not computed, in 1D none
        vector along(axis_);
        for (int d = 0; d < grid.nDim(); ++d)
        {
            if (grid.nDim() < 3)
            {
                along[grid.direction(d)] = 0;
            }
        }
        if (!(mag(axis_) > 0) || mag(along - axis_) > 1e-12 * mag(axis_) || grid.nDim() == 1)
        {
            FatalIOErrorInFunction(dict)
                << "Entry axis is " << axis_ << "; it must not be zero, and in"
                << " 2D normal to the plane. In 1D nothing can turn." << exit(FatalIOError);
        }
        if (grid.radial() >= 0)
        {
            FatalIOErrorInFunction(dict) << "On wedge patches nothing turns in the plane: an"
                                         << " axisymmetric scene allows the motions fixed and"
                                         << " translation." << exit(FatalIOError);
        }
        axis_ /= mag(axis_);
    }

    vector rate(const scalar time) const override { return axis_ * omega_->value(time); }

    void addKinks(const scalar t0, const scalar t1, DynamicList<scalar>& times) const override
    {
        kinks(*omega_, t0, t1, times);
    }

    placement place(const vector& path, const vector& rate) const override
    {
        const scalar angle = path & axis_;
        const tensor cross(
            0, -axis_.z(), axis_.y(), axis_.z(), 0, -axis_.x(), -axis_.y(), axis_.x(), 0);
        placement p;
        p.origin = origin_;
        p.R =
            tensor::I + std::sin(angle) * cross + 2 * sqr(std::sin(0.5 * angle)) * (cross & cross);
        p.spin = rate;
        return p;
    }
};

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

defineTypeNameAndDebug(fixedMotion, 0);
defineTypeNameAndDebug(translationMotion, 0);
defineTypeNameAndDebug(rotationMotion, 0);
addToRunTimeSelectionTable(rigidMotion, fixedMotion, dictionary);
addToRunTimeSelectionTable(rigidMotion, translationMotion, dictionary);
addToRunTimeSelectionTable(rigidMotion, rotationMotion, dictionary);

} // End namespace Foam::mpm
