// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "energyBudget.H"
#include "dictionaryTools.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include <type_traits>

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
    f("afterburn", b.afterburn);
}

//- Add those of all processors
const auto addAll = [](const char*, auto& value)
{ reduce(value, sumOp<std::decay_t<decltype(value)>>()); };

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
    forSums(*this, addAll);
    forLaterSums(*this, addAll);
    reduce(mass, sumOp<scalar>());
    reduce(energy, sumOp<scalar>());
    reduce(momentum, sumOp<vector>());
}

Foam::dictionary Foam::mpm::gasBudget::state() const
{
    dictionary state;
    const auto write = [&](const char* name, const auto& value) { state.add(name, value); };
    forSums(*this, write);
    forLaterSums(*this, write);
    return state;
}

void Foam::mpm::gasBudget::setState(const dictionary& state)
{
    forSums(
        *this,
        [&](const char* name, auto& value)
        { value = required<std::decay_t<decltype(value)>>(state, name); });
    forLaterSums(
        *this,
        [&](const char* name, scalar& value) { value = state.getOrDefault<scalar>(name, 0); });
}
