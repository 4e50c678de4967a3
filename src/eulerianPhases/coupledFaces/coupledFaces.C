// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "coupledFaces.H"
#include "processorPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "transform.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include <algorithm>

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

void Foam::mpm::coupledFaces::swap(const UList<column>& columns) const
{
    label width = 0;
    for (const column& c : columns)
    {
        width += c.n;
    }
    const auto at = [&](const column& c, const polyPatch& pp)
    { return c.values + c.n * (pp.start() - nInternal_); };

    const label request = UPstream::nRequests();
    send_.setSize(processor_.size());
    receive_.setSize(processor_.size());
    forAll(processor_, i)
    {
        const auto& pp = refCast<const processorPolyPatch>(patches_[processor_[i]]);
        receive_[i].setSize(width * pp.size());
        UIPstream::read(
            UPstream::commsTypes::nonBlocking, pp.neighbProcNo(),
            reinterpret_cast<char*>(receive_[i].data()),
            std::streamsize(receive_[i].size() * sizeof(scalar)), pp.tag(), pp.comm());
    }
    forAll(processor_, i)
    {
        const auto& pp = refCast<const processorPolyPatch>(patches_[processor_[i]]);
        send_[i].setSize(width * pp.size());
        scalar* to = send_[i].data();
        for (const column& c : columns)
        {
            to = std::copy_n(at(c, pp), c.n * pp.size(), to);
        }
        UOPstream::write(
            UPstream::commsTypes::nonBlocking, pp.neighbProcNo(),
            reinterpret_cast<const char*>(send_[i].cdata()),
            std::streamsize(send_[i].size() * sizeof(scalar)), pp.tag(), pp.comm());
    }

    // Each pair of cyclic patches once
    for (const label patchi : cyclic_)
    {
        const auto& pp = refCast<const cyclicPolyPatch>(patches_[patchi]);
        for (const column& c : columns)
        {
            if (pp.owner())
            {
                std::swap_ranges(at(c, pp), at(c, pp) + c.n * pp.size(), at(c, pp.neighbPatch()));
            }
        }
    }

    UPstream::waitRequests(request);
    forAll(processor_, i)
    {
        const polyPatch& pp = patches_[processor_[i]];
        const scalar* from = receive_[i].cdata();
        for (const column& c : columns)
        {
            std::copy_n(from, c.n * pp.size(), at(c, pp));
            from += c.n * pp.size();
        }
    }
}

void Foam::mpm::coupledFaces::swap(UList<gasState>& b, List<column> others) const
{
    static_assert(sizeof(gasState) == 5 * sizeof(scalar), "plain numbers");
    others.append(column{reinterpret_cast<scalar*>(b.data()), 5});
    swap(others);
    for (const labelList* list : {&processor_, &cyclic_})
    {
        for (const label patchi : *list)
        {
            rotate(patchi, b);
        }
    }
}
