/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "startHints.H"
#include "phaseNames.H"
#include "dictionaryTools.H"
#include "Time.H"
#include "IFstream.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Do regions of setMaterialPointsDict fill a phase with the rho of its law?
//  What is wrong in the file setMaterialPoints says
bool filledWithRho(const fileName& file, const word& phase)
{
    if (!isFile(file))
    {
        return false;
    }
    bool filled = false, own = false;
    const bool threw = FatalIOError.throwExceptions();
    try
    {
        IFstream is(file);
        const dictionary dict(is);
        for (const entry& e : dict.subOrEmptyDict("regions"))
        {
            if (e.isDict() && e.dict().getOrDefault<word>("phase", "") == phase)
            {
                filled = true;
                own = own || e.dict().found("density");
            }
        }
    }
    catch (const Foam::error&)
    {
        filled = false;
    }
    FatalIOError.throwExceptions(threw);
    return filled && !own;
}


//- Mass [kg] and centre of mass [m] of the points of a velocity field
scalar centreOfMass
(
    const PtrList<mpm::materialPointPhase>& phases,
    const word& field,
    point& centre
)
{
    scalar mass = 0;
    centre = Zero;
    for (const mpm::materialPointPhase& phase : phases)
    {
        const mpm::materialPointCloud& cloud = phase.cloud();
        forAll(cloud.cells(), k)
        {
            for
            (
                label p = cloud.start()[k];
                phase.velocityField() == field && p < cloud.start()[k + 1];
                ++p
            )
            {
                mass += cloud.mass()[0][p];
                centre +=
                    cloud.mass()[0][p]*cloud.position(p, cloud.cells()[k]);
            }
        }
    }
    reduce(mass, sumOp<scalar>());
    reduce(centre, sumOp<vector>());
    centre /= max(mass, VSMALL);
    return mass;
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::requireGas
(
    const dictionary& phaseProperties,
    const wordList& names
)
{
    const bool gas =
        phaseNames(phaseProperties, {"gas"}).size()
     || phaseNames(phaseProperties, {"fluid"}).size();
    for (const word& name : names)
    {
        const dictionary& dict = requiredDict(phaseProperties, name);
        for (const word key : {"drag", "heatTransfer"})
        {
            if (!gas && dict.found(key))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry " << key << " of phase " << name
                    << " acts between points and a gas, but phases "
                    << flatOutput(names) << " has none. Remove it, or add a"
                    << " phase of type gas or fluid." << exit(FatalIOError);
            }
        }
    }
}


void Foam::mpm::warnOfDensity(const materialPointPhase& phase)
{
    const materialPointCloud& cloud = phase.cloud();
    const Time& time = cloud.time();
    const fileName state
    (
        time.path()/time.timeName()/"uniform"/"materialPointState"
    );
    scalar mass = 0, volume = 0;
    for (label p = 0; p < cloud.size(); ++p)
    {
        mass += cloud.mass()[0][p];
        volume += cloud.volume()[0][p];
    }
    reduce(mass, sumOp<scalar>());
    reduce(volume, sumOp<scalar>());
    const bool old = returnReduce(isFile(state), orOp<bool>());
    if (old || phase.prescribed() || !(volume > 0))
    {
        return;
    }
    const scalar rho = mass/volume;
    if
    (
        mag(rho - phase.rho()) > 0.01*phase.rho()
     && Pstream::master()
     && filledWithRho
        (
            time.globalPath()/time.system()/"setMaterialPointsDict",
            phase.name()
        )
    )
    {
        WarningInFunction
            << "The points of phase " << phase.name() << " have the density "
            << rho << " kg/m3 (mass over volume), but its rho is "
            << phase.rho() << " kg/m3: they were made with another rho. Run"
            << " setMaterialPoints again"
            << (Pstream::parRun() ? ", then decomposePar -force." : ".")
            << endl;
    }
}


void Foam::mpm::warnOfNormals
(
    const dictionary& phaseProperties,
    const pointGrid& grid,
    const PtrList<materialPointPhase>& phases
)
{
    for (const entry& e : phaseProperties.subOrEmptyDict("contact"))
    {
        if (!e.isDict() || !e.dict().found("normal"))
        {
            continue;
        }
        const wordList fields(e.dict().get<wordList>("fields"));
        const vector n(normalised(e.dict().get<vector>("normal")));
        point a, b;
        const scalar ma = centreOfMass(phases, fields[0], a);
        const scalar mb = centreOfMass(phases, fields[1], b);
        vector way(b - a);
        for (int d = 0; d < grid.nDim(); ++d)
        {
            // Around a period there are two ways
            if (grid.period(d) > 0)
            {
                way[grid.direction(d)] = 0;
            }
        }
        if (ma > 0 && mb > 0 && (n & way) < -1e-6*mag(way))
        {
            IOWarningInFunction(e.dict())
                << "Contact " << e.keyword() << ": normal " << n
                << " is from the first field to the second, but points"
                << " against the way from the centre of mass of " << fields[0]
                << ' ' << a << " to that of " << fields[1] << ' ' << b
                << ": they may never touch. If it is reversed, write"
                << "  normal " << (0*n - n) << ";" << endl;
        }
    }
}

// ************************************************************************* //
