// A rank that waits for a message sleeps in place of calling sched_yield() in a loop.
//
// Tests have more ranks than cores, beside other tests. Who yields comes last behind all that
// want the core, and each message then waits for some slices of time: a run of three ranks on two
// busy cores took 127 s, with this 21 s. Preloaded by mpirun (foamCase.py); MPI calls the function
// where mpi_yield_when_idle is set.

#include <ctime>
#include <sys/prctl.h>

extern "C" int sched_yield()
{
    // Sleeps end after the time that was asked, not 50 us later
    static const int exact = prctl(PR_SET_TIMERSLACK, 1000UL, 0, 0, 0);
    static_cast<void>(exact);
    const timespec little{0, 5000};
    return nanosleep(&little, nullptr);
}
