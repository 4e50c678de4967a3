/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "regionTable.H"
#include "IOmanip.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A line of the table; a negative volume is not known
void printLine
(
    const std::string& region,
    const word& phase,
    const label nPoints,
    const scalar mass,
    const scalar volume,
    const scalar exactVolume
)
{
    const auto padded = [](std::string s)
    {
        s.resize(max(s.size(), std::size_t(15)), ' ');
        return s + ' ';
    };

    OStringStream line;
    line.precision(6);
    line<< "    " << padded(region).c_str() << padded(phase).c_str()
        << setw(10) << nPoints << setw(14) << mass << setw(14) << volume;
    if (exactVolume > 0)
    {
        line<< setw(14) << exactVolume
            << setw(14) << (volume - exactVolume)/exactVolume;
    }
    else
    {
        line<< setw(14) << "n/a" << setw(14) << "n/a";
    }
    Info<< line.str().c_str() << nl;
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::printTable
(
    const wordList& phases,
    const PtrList<pointRegion>& regions
)
{
    Info<< "    region          phase               points     mass [kg]"
        << "   volume [m3]    exact [m3]    difference" << nl;

    forAll(regions, i)
    {
        const pointRegion& r = regions[i];
        printLine
        (
            r.name(), r.phase(), r.points().size(), r.mass(), r.volume(),
            r.exactVolume()
        );
    }
    Info<< nl;

    for (const word& phase : phases)
    {
        label n = 0;
        scalar mass = 0, volume = 0, exact = 0;
        forAll(regions, j)
        {
            const pointRegion& r = regions[j];
            if (r.phase() == phase)
            {
                n += r.points().size();
                mass += r.mass();
                volume += r.volume();
                const scalar v = r.exactVolume();
                exact = v < 0 || exact < 0 ? -1 : exact + v;
            }
        }
        printLine("total", phase, n, mass, volume, exact);
    }
    Info<< endl;
}

// ************************************************************************* //
