// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointRegion.H"
#include "dictionaryTools.H"
#include "labelVector.H"
#include "meshShape.H"
#include "simplexParts.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointRegion::checkEntries() const
{
    wordList valid(
        {"phase", "type", "pointsPerCell", "parts", "samples", "velocity", "stress", "pressure",
         "temperature", "volumeFraction", "density", "overlap"});
    valid.append(shape_->keywords());
    if (dict_.found("scale") && !valid.found("scale") && valid.found("surface"))
    {
        FatalIOErrorInFunction(dict_)
            << "Unknown keyword scale in " << dict_.name()
            << "; it belongs into surface { file ...; scale ...; }" << exit(FatalIOError);
    }
    checkKeywords(dict_, valid);
}

void Foam::mpm::pointRegion::readPointsPerCell()
{
    const word key("pointsPerCell");
    requireKeyword(dict_, key);
    const token first(dict_.lookup(key));
    const vector given(
        first.isNumber() ? vector::uniform(dict_.get<scalar>(key)) : dict_.get<vector>(key));
    labelVector perAxis(Zero);
    for (int c = 0; c < 3; ++c)
    {
        if (mag(given[c]) < labelMax && given[c] == std::floor(given[c]))
        {
            perAxis[c] = label(given[c]);
            continue;
        }
        FatalIOErrorInFunction(dict_)
            << "Entry " << key << " is " << given[c] << " in direction "
            << "xyz"[c] << "; it must be a whole number, 1 to 16: the points of"
            << " a cell along this direction." << exit(FatalIOError);
    }

    nSub_ = nSamples_ = 1;
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        n_[d] = perAxis[grid_.direction(d)];
        if (n_[d] < 1 || n_[d] > 16)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry " << key << " asks for " << n_[d] << " points in direction "
                << "xyz"[grid_.direction(d)] << " of a cell; it must be 1 to 16."
                << exit(FatalIOError);
        }
        nSub_ *= n_[d];
        nSamples_ *= m_;
        const bool corners = byElements_ || byCorners_;
        if (corners && n_[d] != n_[0])
        {
            FatalIOErrorInFunction(dict_)
                << "Entry " << key << " is " << perAxis << "; in "
                << (byElements_ ? "elements of a mesh"
                                : "cells that are no"
                                  " hexahedra")
                << " it must be the same in all directions: 1 (a point at the"
                << " centroid), 2 (a point for each corner) or more (simplices"
                << " in equal parts)." << exit(FatalIOError);
        }
    }
    bySimplices_ = (byElements_ || byCorners_) && n_[0] > 2;
    if (byElements_)
    {
        const bodyMesh& body = refCast<const meshShape>(*shape_).body();
        nSub_ = n_[0] == 1 ? label(1) : body.mostParts(n_[0]);
    }
    else if (byCorners_ && n_[0] > 1)
    {
        nSub_ = 0;
        for (label celli = 0; celli < grid_.nCells(); ++celli)
        {
            nSub_ = max(nSub_, mostParts(celli));
        }
    }
}

Foam::label Foam::mpm::pointRegion::mostParts(const label celli) const
{
    if (!bySimplices_)
    {
        return grid_.nodesOf(celli).size();
    }
    try
    {
        return simplexParts::number(grid_, celli, n_[0]);
    }
    catch (const string& reason)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry pointsPerCell is " << n_[0] << ", which cuts cells into"
            << " simplices: " << reason.c_str() << '.' << exit(FatalIOError);
    }
    return 0;
}

void Foam::mpm::pointRegion::readVelocity()
{
    const word key("velocity");
    U_ = omega_ = origin_ = Zero;
    along_.setSize(3);
    if (!dict_.isDict(key))
    {
        U_ = dict_.getOrDefault<vector>(key, Zero);
        return;
    }

    const dictionary& dict = dict_.subDict(key);
    const wordList coordinates({"x", "y", "z"});
    wordList valid({"uniform", "omega", "axis", "origin"});
    for (const word& c : coordinates)
    {
        valid.append(c);
        valid.append(c + "Coeffs");
    }
    checkKeywords(dict, valid);

    U_ = dict.getOrDefault<vector>("uniform", Zero);
    if (dict.found("omega"))
    {
        const vector axis(required<vector>(dict, "axis"));
        if (!(mag(axis) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry axis is " << axis << "; it must have a length > 0." << exit(FatalIOError);
        }
        omega_ = dict.get<scalar>("omega") * axis / mag(axis);
        origin_ = required<point>(dict, "origin");
    }
    else if (dict.found("axis") || dict.found("origin"))
    {
        FatalIOErrorInFunction(dict)
            << "Entries axis and origin only go with omega [rad/s]." << exit(FatalIOError);
    }
    forAll(coordinates, c)
    {
        if (dict.found(coordinates[c]))
        {
            along_.set(c, Function1<vector>::New(coordinates[c], dict));
        }
    }
}

Foam::vector Foam::mpm::pointRegion::velocityAt(const point& x) const
{
    vector U(U_ + (omega_ ^ shape_->computed(x - origin_)));
    forAll(along_, c)
    {
        if (along_.set(c))
        {
            U += along_[c].value(x[c]);
        }
    }
    if (mag(U - shape_->computed(U)) > 0)
    {
        FatalIOErrorInFunction(dict_)
            << "The velocity " << U << " at " << x << " has a component in a"
            << " direction of the mesh that is not computed (empty or wedge"
            << " patches); it must be 0."
            << (mag(omega_) > 0 ? " In 2D the axis lies along it." : "") << exit(FatalIOError);
    }
    return U;
}

void Foam::mpm::pointRegion::readStress()
{
    sigma_ = Zero;

    const bool found = dict_.found("stress");
    const bool ambient = found && token(dict_.lookup("stress")).isWord();

    if (ambient)
    {
        oneOf(dict_, "stress", {"ambient"});
        if (!inGas_)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry stress is ambient, the pressure of a gas, but"
                << " constant/phaseProperties has no phase of type gas. Leave"
                << " stress and pressure out, or give the stress (xx xy xz yy yz"
                << " zz), negative in compression:  stress (-1e5 0 0 -1e5 0"
                << " -1e5);" << exit(FatalIOError);
        }
        const scalar p = dict_.get<scalar>("pressure");
        sigma_ = symmTensor(-p, 0, 0, -p, 0, -p);
        return;
    }
    if (dict_.found("pressure"))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry pressure only goes with:  stress ambient;" << exit(FatalIOError);
    }
    if (!found)
    {
        return;
    }

    sigma_ = dict_.get<symmTensor>("stress");

    bool isComputed[3] = {false, false, false};
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        isComputed[grid_.direction(d)] = true;
    }
    if ((sigma_.xy() != 0 && !(isComputed[0] && isComputed[1]))
        || (sigma_.xz() != 0 && !(isComputed[0] && isComputed[2]))
        || (sigma_.yz() != 0 && !(isComputed[1] && isComputed[2])))
    {
        FatalIOErrorInFunction(dict_)
            << "The stress (xx xy xz yy yz zz) " << sigma_ << " has shear in"
            << " an empty direction of the mesh; it must be 0." << exit(FatalIOError);
    }
}
