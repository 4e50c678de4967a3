// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointQuantity.H"
#include "FlatOutput.H"
#include "spectral.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

enum quantities
{
    VELOCITY,
    POSITION,
    DISPLACEMENT,
    STRESS,
    PRESSURE,
    EQUIVALENT,
    LARGEST,
    DAMAGE,
    VOLUME,
    MASS,
    DENSITY,
    JACOBIAN,
    TEMPERATURE,
    HISTORY
};

const struct
{
    const char* name;
    int rank;
    const char* unit;
} known[] = {{"U", 3, "[m/s]"},       {"x", 3, "[m]"},       {"displacement", 3, "[m]"},
             {"sigma", 6, "[Pa]"},    {"pPoint", 1, "[Pa]"}, {"sigmaEq", 1, "[Pa]"},
             {"sigmaMax", 1, "[Pa]"}, {"damage", 1, "[-]"},  {"V", 1, "[m3]"},
             {"m", 1, "[kg]"},        {"rho", 1, "[kg/m3]"}, {"J", 1, "[-]"},
             {"T", 1, "[K]"}};

//- Clouds have damage and a temperature only where asked for
bool has(const materialPointCloud& cloud, const int quantity)
{
    return quantity == DAMAGE     ? bool(cloud.damage())
        : quantity == TEMPERATURE ? bool(cloud.temperature())
                                  : true;
}

const char* const* componentNames(const int rank)
{
    static const char* const vectors[] = {"x", "y", "z"};
    static const char* const symmetric[] = {"xx", "xy", "xz", "yy", "yz", "zz"};
    static const char* const tensors[] = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};

    return rank == 3 ? vectors : rank == 6 ? symmetric : tensors;
}

int rankOf(const column& history)
{
    return history.kind() == column::scalars ? 1 : history.kind() == column::tensors ? 9 : 6;
}

//- A history column as OpenFOAM has it
void historyValues(
    const materialPointCloud& cloud, const column& h, const label p,
    scalar (&values)[pointQuantity::maxSize])
{
    if (h.kind() == column::scalars)
    {
        values[0] = h[0][p];
        return;
    }

    const bool symmetric = h.kind() != column::tensors;
    const tensor t(cloud.tensorOf(h, p));
    const symmTensor s(symm(t));
    for (int i = 0; i < (symmetric ? 6 : 9); ++i)
    {
        values[i] = symmetric ? s[i] : t[i];
    }
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pointQuantity::pointQuantity(
    const dictionary& dict, const materialPointPhase& phase, const word& name,
    const startState* start) :
    phase_(phase), start_(start), name_(name), quantity_(-1), rank_(1), component_(-1)
{
    const UPtrList<column>& history = phase.cloud().history();

    const auto lookUp = [&](const std::string& asked)
    {
        for (int i = 0; i < HISTORY; ++i)
        {
            if (has(phase.cloud(), i)
                && (asked == known[i].name || (i == PRESSURE && asked == "p")))
            {
                quantity_ = i;
                rank_ = known[i].rank;
                unit_ = known[i].unit;
                return true;
            }
        }
        forAll(history, i)
        {
            if (asked == history[i].name())
            {
                quantity_ = HISTORY + i;
                rank_ = rankOf(history[i]);
                return true;
            }
        }
        return false;
    };

    // Names may hold underscores themselves
    bool found = lookUp(name);
    const std::size_t at = name.rfind('_');
    if (!found && at != std::string::npos && lookUp(name.substr(0, at)))
    {
        for (int i = 0; rank_ > 1 && i < rank_; ++i)
        {
            if (name.substr(at + 1) == componentNames(rank_)[i])
            {
                component_ = i;
                found = true;
            }
        }
    }

    if (!found)
    {
        FatalIOErrorInFunction(dict) << "Unknown field " << name << " of phase " << phase.name()
                                     << meant(name, names(phase)).c_str() << nl << nl
                                     << "Valid fields are: " << flatOutput(names(phase)) << nl
                                     << "and components of vectors and tensors, such as U_y and"
                                     << " sigma_xy." << nl << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::pointQuantity::needsStart(const word& name)
{
    const std::string base(name.substr(0, name.find('_')));
    return base == "displacement" || base == "J";
}

Foam::wordList Foam::mpm::pointQuantity::names(const materialPointPhase& phase)
{
    DynamicList<word> result;
    for (int i = 0; i < HISTORY; ++i)
    {
        if (has(phase.cloud(), i))
        {
            result.append(known[i].name);
        }
    }
    for (const column& h : phase.cloud().history())
    {
        result.append(h.name());
    }
    return wordList(std::move(result));
}

Foam::wordList Foam::mpm::pointQuantity::titles() const
{
    wordList result(size(), name_);
    if (size() > 1)
    {
        forAll(result, i)
        {
            result[i] += std::string("_") + componentNames(rank_)[i];
        }
    }
    return result;
}

void Foam::mpm::pointQuantity::get(const label p, scalar (&values)[maxSize]) const
{
    const materialPointCloud& cloud = phase_.cloud();

    const label first = quantity_ == DISPLACEMENT || quantity_ == JACOBIAN
        ? start_->find(label(cloud.id()[0][p]))
        : 0;
    if (first < 0)
    {
        FatalErrorInFunction << "Material point " << label(cloud.id()[0][p]) << " of "
                             << phase_.name() << " was not there at the start, time "
                             << start_->time() << ": it has no " << name_ << "."
                             << exit(FatalError);
    }

    const auto copy = [&](const auto& v)
    {
        for (int i = 0; i < rank_; ++i)
        {
            values[i] = v[i];
        }
    };

    switch (quantity_)
    {
    case VELOCITY:
        copy(cloud.velocity(p));
        break;

    case POSITION:
        copy(positionOf(cloud, p));
        break;

    case DISPLACEMENT:
    {
        const vector moved(positionOf(cloud, p) - start_->x()[first]);
        std::fill_n(values, 3, scalar(0));
        for (int d = 0; d < cloud.grid().nDim(); ++d)
        {
            const int c = cloud.grid().direction(d);
            values[c] = moved[c];
        }
        break;
    }

    case STRESS:
        copy(cloud.sigma(p));
        break;

    case PRESSURE:
        values[0] = -tr(cloud.sigma(p)) / 3;
        break;

    case EQUIVALENT:
        values[0] = std::sqrt(1.5) * mag(dev(cloud.sigma(p)));
        break;

    case LARGEST:
    {
        const tensor t(cloud.sigma(p));
        double s[9];
        std::copy(t.begin(), t.end(), s);
        values[0] = largestPrincipal(s);
        break;
    }

    case DAMAGE:
        values[0] = (*cloud.damage())[0][p];
        break;

    case VOLUME:
        values[0] = cloud.volume()[0][p];
        break;

    case MASS:
        values[0] = cloud.mass()[0][p];
        break;

    case DENSITY:
        values[0] = cloud.mass()[0][p] / cloud.volume()[0][p];
        break;

    case JACOBIAN:
        values[0] = cloud.volume()[0][p] / start_->V()[first];
        break;

    case TEMPERATURE:
        values[0] = (*cloud.temperature())[0][p];
        break;

    default:
        historyValues(cloud, cloud.history()[quantity_ - HISTORY], p, values);
    }

    if (component_ > 0)
    {
        values[0] = values[component_];
    }
}
