// A rank that waits for a message looks for it for 50 us, then sleeps between looks, in place of
// calling sched_yield() in a loop.
//
// Tests have more ranks than cores, beside other tests. Who yields comes last behind all that
// want the core, and each message then waits for some slices of time: a run of three ranks on two
// busy cores took 127 s, with sleeps 21 s. Sleeps from the first look on cost too much where timers
// are dear. On a virtual machine with 27 us of the core for each three ranks did 9 steps in 25 s
// and do now 179 in 20 s, beside a busy process 116. Preloaded by mpirun (foamCase.py); MPI calls
// the function where mpi_yield_when_idle is set.

#include <ctime>
#include <sys/prctl.h>

namespace
{

//- [s]
double now()
{
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

}

extern "C" int sched_yield()
{
    // Sleeps end after the time that was asked, not 50 us later
    static const int exact = prctl(PR_SET_TIMERSLACK, 1000UL, 0, 0, 0);
    static_cast<void>(exact);

    // Work between two calls begins a wait anew
    static double first = 0, last = 0;
    const double t = now();
    if (t - last > 1e-5)
    {
        first = t;
    }
    last = t;
    if (t - first < 5e-5)
    {
        return 0;
    }
    const timespec little{0, 20000};
    const int result = nanosleep(&little, nullptr);
    last = now();
    return result;
}
