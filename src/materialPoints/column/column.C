// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "column.H"
#include "pointBlock.H"
#include <cstring>
#include <new>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::alignedArray::alignedArray(const label n) :
    data_(static_cast<scalar*>(::operator new[](size_t(n) * sizeof(scalar), std::align_val_t(64))))
{
    std::memset(static_cast<void*>(data_.get()), 0, size_t(n) * sizeof(scalar));
}

Foam::mpm::column::column(const word& name, const kinds kind, const int nDim) :
    name_(name), kind_(kind), nDim_(nDim), capacity_(0), component_(nComponents(kind, nDim))
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::mpm::column::nComponents(const kinds kind, const int nDim)
{
    switch (kind)
    {
    case scalars:
        return 1;
    case vectors:
        return nDim;
    case stresses:
        return nStress(nDim);
    case strains:
        return nStrain(nDim);
    default:
        return nDim * nDim;
    }
}

void Foam::mpm::column::reserve(const label n, const label nOld)
{
    if (n <= capacity_ && capacity_ > 0)
    {
        return;
    }
    for (alignedArray& a : component_)
    {
        alignedArray larger(n + padding);
        if (nOld > 0)
        {
            std::memcpy(larger.data(), a.data(), size_t(nOld) * sizeof(scalar));
        }
        a.swap(larger);
    }
    capacity_ = n;
}

void Foam::mpm::column::permute(
    const label* from, const label first, const label n, alignedArray& scratch)
{
    // Values are on their way from memory long before they are copied: without
    // it, this takes four times the time. Eight are one line of the cache
    constexpr label ahead = 512, line = 8;

    for (alignedArray& a : component_)
    {
        const scalar* __restrict__ old = a.data();
        scalar* __restrict__ to = scratch.data();

        std::memcpy(to, old, size_t(first) * sizeof(scalar));
        label i = first;
        for (; i < n - ahead - line; i += line)
        {
            __builtin_prefetch(old + from[i + ahead]);
            __builtin_prefetch(old + from[i + ahead + line / 2]);
            for (label k = 0; k < line; ++k)
            {
                to[i + k] = old[from[i + k]];
            }
        }
        for (; i < n; ++i)
        {
            to[i] = old[from[i]];
        }
        a.swap(scratch);
    }
}
