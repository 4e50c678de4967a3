// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "coupledFaces.H"
#include "processorPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "transform.H"
#include "UIPstream.H"
#include "UOPstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Exchange of n of any plain type per face; turn() is called with what came
template<class T, class Turn>
void exchange(
    const polyBoundaryMesh& patches, const label nInternal, const labelList& processor,
    const labelList& cyclic, const label n, UList<T>& b, List<List<T>>& send,
    List<List<T>>& receive, const Turn& turn)
{
    const label request = UPstream::nRequests();
    send.setSize(processor.size());
    receive.setSize(processor.size());
    forAll(processor, i)
    {
        const auto& pp = refCast<const processorPolyPatch>(patches[processor[i]]);
        const SubList<T> mine(b, n * pp.size(), n * (pp.start() - nInternal));
        receive[i].setSize(mine.size());
        send[i] = mine;
        UIPstream::read(
            UPstream::commsTypes::nonBlocking, pp.neighbProcNo(),
            reinterpret_cast<char*>(receive[i].data()),
            std::streamsize(receive[i].size() * sizeof(T)), pp.tag(), pp.comm());
    }
    forAll(processor, i)
    {
        const auto& pp = refCast<const processorPolyPatch>(patches[processor[i]]);
        UOPstream::write(
            UPstream::commsTypes::nonBlocking, pp.neighbProcNo(),
            reinterpret_cast<const char*>(send[i].cdata()),
            std::streamsize(send[i].size() * sizeof(T)), pp.tag(), pp.comm());
    }

    // Each pair of cyclic patches once
    for (const label patchi : cyclic)
    {
        const auto& pp = refCast<const cyclicPolyPatch>(patches[patchi]);
        if (pp.owner())
        {
            const label a = n * (pp.start() - nInternal);
            const label c = n * (pp.neighbPatch().start() - nInternal);
            for (label i = 0; i < n * pp.size(); ++i)
            {
                std::swap(b[a + i], b[c + i]);
            }
        }
    }

    UPstream::waitRequests(request);
    forAll(processor, i)
    {
        const polyPatch& pp = patches[processor[i]];
        SubList<T>(b, n * pp.size(), n * (pp.start() - nInternal)) = receive[i];
    }
    for (const label patchi : processor)
    {
        turn(patchi);
    }
    for (const label patchi : cyclic)
    {
        turn(patchi);
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::coupledFaces::rotate(const label patchi, UList<gasState>& b) const
{
    const auto& pp = refCast<const coupledPolyPatch>(patches_[patchi]);
    if (pp.parallel())
    {
        return;
    }
    const tensorField& T = pp.forwardT();
    const label start = pp.start() - nInternal_;
    for (label i = 0; i < pp.size(); ++i)
    {
        b[start + i].u = transform(T[T.size() == 1 ? 0 : i], b[start + i].u);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::coupledFaces::coupledFaces(const fvMesh& mesh) :
    patches_(mesh.boundaryMesh()), nInternal_(mesh.nInternalFaces())
{
    DynamicList<label> processor, cyclic;
    forAll(patches_, patchi)
    {
        const polyPatch& pp = patches_[patchi];
        if (isA<processorPolyPatch>(pp))
        {
            processor.append(patchi);
        }
        else if (isA<cyclicPolyPatch>(pp))
        {
            cyclic.append(patchi);
        }
        else if (pp.coupled())
        {
            FatalErrorInFunction << "Patch " << pp.name() << " has type " << pp.type()
                                 << ", which the gas cannot use." << nl
                                 << "Valid coupled types are: (cyclic processor"
                                 << " processorCyclic)" << exit(FatalError);
        }
    }
    processor_.transfer(processor);
    cyclic_.transfer(cyclic);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::coupledFaces::swap(UList<gasState>& b) const
{
    exchange(
        patches_, nInternal_, processor_, cyclic_, 1, b, send_, receive_,
        [&](const label patchi) { rotate(patchi, b); });
}

void Foam::mpm::coupledFaces::swap(UList<scalar>& b, const label n) const
{
    List<List<scalar>> send, receive;
    exchange(patches_, nInternal_, processor_, cyclic_, n, b, send, receive, [](const label) {});
}

void Foam::mpm::coupledFaces::swap(UList<label>& b) const
{
    List<List<label>> send, receive;
    exchange(patches_, nInternal_, processor_, cyclic_, 1, b, send, receive, [](const label) {});
}
