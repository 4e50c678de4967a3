// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "cloudColumn.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

void copyValues(const mpm::column& from, mpm::column& to, const label n)
{
    for (int i = 0; i < from.nComponents(); ++i)
    {
        std::copy(from[i], from[i] + n, to[i]);
    }
}

}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::cloudColumn::grow(const label n, const label nOld)
{
    reserve(n, nOld);
    if (new_)
    {
        new_->reserve(n, nOld);
    }
}

Foam::label Foam::mpm::cloudColumn::nDoubles() const
{
    const bool kept = kept_ && kept_->capacity();
    return nComponents() * (1 + bool(new_) + kept);
}

void Foam::mpm::cloudColumn::fill(const label first, const label end)
{
    for (int i = 0; i < nComponents(); ++i)
    {
        std::fill((*this)[i] + first, (*this)[i] + end, rules_.initialValue);
    }
}

void Foam::mpm::cloudColumn::keep(const label n)
{
    if (kept_)
    {
        kept_->reserve(capacity(), 0);
        copyValues(*this, *kept_, n);
    }
}

void Foam::mpm::cloudColumn::restore(const label n)
{
    if (kept_)
    {
        copyValues(*kept_, *this, n);
    }
}
