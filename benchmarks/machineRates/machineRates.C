/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    machineRates

Description
    What one core of this machine can do, beside which the rates of the other
    benchmarks are read: triad a = b + s c over arrays much larger than the
    cache [GB/s, 24 bytes per element, as STREAM counts], and double fused
    multiply-adds in registers [GFlop/s].

\*---------------------------------------------------------------------------*/

#include "lanes.H"
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

namespace
{

// Of the widest registers that the flags allow
constexpr int bytes = 8 * Foam::mpm::registerLanes;

double seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}

int main()
{
    double triad = 0, fma = 0;

    {
        const long n = 1L << 25;
        std::unique_ptr<double[]> a(new double[n]), b(new double[n]), c(new double[n]);
        for (long i = 0; i < n; ++i)
        {
            a[i] = 0;
            b[i] = i;
            c[i] = 1;
        }
        for (int rep = 0; rep < 8; ++rep)
        {
            double* __restrict__ pa = a.get();
            const double* __restrict__ pb = b.get();
            const double* __restrict__ pc = c.get();
            const double s = 0.5 + rep, t = seconds();
            for (long i = 0; i < n; ++i)
            {
                pa[i] = pb[i] + s * pc[i];
            }
            triad = std::max(triad, 24.0 * n / (seconds() - t) * 1e-9);
        }
        if (a[n / 2] < 0)
            std::puts("");
    }

    {
        typedef double v __attribute__((vector_size(bytes)));
        const v m = v{} + 0.999999, d = v{} + 1e-6;
        v x0 = v{} + 1.0, x1 = x0, x2 = x0, x3 = x0, x4 = x0, x5 = x0;
        v x6 = x0, x7 = x0, x8 = x0, x9 = x0, x10 = x0, x11 = x0;
        for (int rep = 0; rep < 5; ++rep)
        {
            // Twelve independent chains: enough for the latency of the unit
            const long n = 20000000;
            const double t = seconds();
            for (long k = 0; k < n; ++k)
            {
                x0 = x0 * m + d;
                x1 = x1 * m + d;
                x2 = x2 * m + d;
                x3 = x3 * m + d;
                x4 = x4 * m + d;
                x5 = x5 * m + d;
                x6 = x6 * m + d;
                x7 = x7 * m + d;
                x8 = x8 * m + d;
                x9 = x9 * m + d;
                x10 = x10 * m + d;
                x11 = x11 * m + d;
                // All twelve are different to the compiler
                __asm__ volatile(""
                                 : "+v"(x0), "+v"(x1), "+v"(x2), "+v"(x3), "+v"(x4), "+v"(x5),
                                   "+v"(x6), "+v"(x7), "+v"(x8), "+v"(x9), "+v"(x10), "+v"(x11));
            }
            fma = std::max(fma, 2.0 * bytes / 8 * 12 * n / (seconds() - t) * 1e-9);
        }
        const v all = x0 + x1 + x2 + x3 + x4 + x5 + x6 + x7 + x8 + x9 + x10 + x11;
        const double s = all[0];
        if (s < 0)
            std::puts("");
    }

    std::printf("triad %.1f GB/s, FMA %.1f GFlop/s\n", triad, fma);
    return 0;
}
