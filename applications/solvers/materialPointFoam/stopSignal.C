/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "stopSignal.H"
#include "scalar.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include <csignal>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

volatile std::sig_atomic_t signalled = 0;

extern "C" void noteSignal(int number)
{
    signalled = number;
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::stopSignal::stopSignal()
:
    nSteps_(1),
    left_(1),
    last_(clock::now())
{
    for (const int number : {SIGTERM, SIGINT})
    {
        struct sigaction action = {};
        action.sa_handler = noteSignal;
        action.sa_flags = SA_RESTART | int(SA_RESETHAND);
        sigemptyset(&action.sa_mask);
        sigaction(number, &action, nullptr);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::mpm::stopSignal::received()
{
    if (!Pstream::parRun())
    {
        return signalled;
    }
    if (--left_ > 0)
    {
        return 0;
    }

    // The slowest processor's seconds since the last look
    scalar seconds =
        std::chrono::duration<scalar>(clock::now() - last_).count();
    reduce(seconds, maxOp<scalar>());
    last_ = clock::now();
    nSteps_ = max
    (
        label(1),
        label(min(scalar(2*nSteps_), nSteps_/max(seconds, 1e-3)))
    );
    left_ = nSteps_;

    return returnReduce(int(signalled), maxOp<int>());
}

// ************************************************************************* //
