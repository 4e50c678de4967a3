// A rank that waits for a message sleeps in place of calling sched_yield() in a loop.
//
// Tests have more ranks than cores, beside other tests. Who yields comes last behind all that
// want the core, and each message then waits for some slices of time: a run of three ranks on two
// busy cores took 127 s, with this 21 s. Preloaded by mpirun (foamCase.py); MPI calls the function
// where mpi_yield_when_idle is set. Where a sleep itself costs the core much (27 us on a virtual
// machine whose timers are dear: such a run took more than 500 s for 6) most calls yield.

#include <ctime>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace
{

//- Of this thread [s]
double cpuTime()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

}

extern "C" int sched_yield()
{
    // Sleeps end after the time that was asked, not 50 us later
    static const int exact = prctl(PR_SET_TIMERSLACK, 1000UL, 0, 0, 0);
    static_cast<void>(exact);

    static unsigned calls = 0, every = 1;
    if (++calls % every)
    {
        return int(syscall(SYS_sched_yield));
    }
    const timespec little{0, 5000};
    const double start = cpuTime();
    const int result = nanosleep(&little, nullptr);
    if (cpuTime() - start > 1e-5)
    {
        every += every < 200;
    }
    else if (every > 1)
    {
        --every;
    }
    return result;
}
