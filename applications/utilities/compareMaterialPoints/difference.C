/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "difference.H"
#include "Map.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- First place of each name
Map<label> placesOf(const labelUList& names)
{
    Map<label> places(2*names.size());
    forAll(names, i)
    {
        places.insert(names[i], i);
    }
    return places;
}


//- Norm of n numbers, less those of another set if there is one
scalar norm(const int n, const scalar* a, const scalar* b)
{
    scalar sum = 0;
    for (int c = 0; c < n; ++c)
    {
        const scalar d = b ? a[c] - b[c] : a[c];
        sum += d*d;
    }
    return std::isfinite(sum) ? std::sqrt(sum) : GREAT;
}


//- Largest finite norm
scalar largestNorm(const caseTime::values& v)
{
    scalar largest = 0;
    forAll(v.names, i)
    {
        const scalar m =
            norm(v.nComponents, &v.numbers[v.nComponents*i], nullptr);
        largest = m < GREAT ? max(largest, m) : largest;
    }
    return largest;
}


//- Number of names that are not there, and the first of them
label countMissing
(
    const labelUList& names,
    const Map<label>& there,
    label& first
)
{
    label n = 0;
    first = -1;
    for (const label name : names)
    {
        if (!there.found(name) && n++ == 0)
        {
            first = name;
        }
    }
    return n;
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::difference::difference
(
    const caseTime::values& a,
    const caseTime::values& b
)
:
    nCompared(0),
    largest(0),
    L2(0),
    scale(max(largestNorm(a), largestNorm(b))),
    worst(-1)
{
    const Map<label> inA(placesOf(a.names)), inB(placesOf(b.names));
    nOnlyFirst = countMissing(a.names, inB, firstOnlyFirst);
    nOnlySecond = countMissing(b.names, inA, firstOnlySecond);

    // The set with names that occur several times is the longer one
    const bool swap = b.names.size() > a.names.size();
    const caseTime::values& from = swap ? b : a;
    const caseTime::values& to = swap ? a : b;
    const Map<label>& inTo = swap ? inA : inB;
    const int n = from.nComponents;

    scalar sum = 0;
    forAll(from.names, i)
    {
        const auto place = inTo.cfind(from.names[i]);
        if (!place.good())
        {
            continue;
        }
        const scalar d =
            norm(n, &from.numbers[n*i], &to.numbers[n*place.val()]);
        ++nCompared;
        sum += d < GREAT ? d*d : 0;
        if (d > largest)
        {
            largest = d;
            worst = from.names[i];
        }
    }
    L2 = largest < GREAT ? std::sqrt(sum/max(nCompared, label(1))) : GREAT;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::difference::twice(const labelUList& names)
{
    labelList sorted(names);
    Foam::sort(sorted);
    for (label i = 1; i < sorted.size(); ++i)
    {
        if (sorted[i] == sorted[i - 1])
        {
            return sorted[i];
        }
    }
    return -1;
}

// ************************************************************************* //
