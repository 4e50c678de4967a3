/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "energyBudget.H"
#include "dictionaryTools.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Call f(name, value) for each sum
template<class Budget, class Function>
void forSums(Budget& b, const Function& f)
{
    f("mass0", b.mass0);
    f("momentum0", b.momentum0);
    f("energy0", b.energy0);
    f("massIn", b.massIn);
    f("boundaryImpulse", b.boundaryImpulse);
    f("gravityImpulse", b.gravityImpulse);
    f("boundary", b.boundary);
    f("external", b.external);
    f("rigid", b.rigid);
    f("dry", b.dry);
    f("fixups", b.fixups);
}


//- Those that older states do not have
template<class Budget, class Function>
void forLaterSums(Budget& b, const Function& f)
{
    f("heat", b.heat);
    f("granular", b.granular);
}


struct adder
{
    template<class T>
    void operator()(const char*, T& value) const
    {
        reduce(value, sumOp<T>());
    }
};


struct writer
{
    dictionary& to;

    template<class T>
    void operator()(const char* name, const T& value) const
    {
        to.add(name, value);
    }
};


struct reader
{
    const dictionary& from;

    template<class T>
    void operator()(const char* name, T& value) const
    {
        value = mpm::required<T>(from, name);
    }
};


struct laterReader
{
    const dictionary& from;

    void operator()(const char* name, scalar& value) const
    {
        value = from.getOrDefault<scalar>(name, 0);
    }
};

}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pointLosses::reduceAll()
{
    reduce(work, sumOp<scalar>());
    reduce(failure, sumOp<scalar>());
    reduce(dissipation, sumOp<scalar>());
}


void Foam::mpm::gasBudget::reduceAll()
{
    forSums(*this, adder());
    forLaterSums(*this, adder());
    reduce(mass, sumOp<scalar>());
    reduce(energy, sumOp<scalar>());
    reduce(momentum, sumOp<vector>());
}


Foam::dictionary Foam::mpm::gasBudget::state() const
{
    dictionary state;
    forSums(*this, writer{state});
    forLaterSums(*this, writer{state});
    return state;
}


void Foam::mpm::gasBudget::setState(const dictionary& state)
{
    forSums(*this, reader{state});
    forLaterSums(*this, laterReader{state});
}

// ************************************************************************* //
