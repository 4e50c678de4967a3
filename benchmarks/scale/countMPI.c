// Calls of MPI of each rank, for LD_PRELOAD: what it computes, what it sends, to whom.
//
// Each call that OpenFOAM's Pstream makes is handed on to PMPI and its processor time taken away
// from that of the program: what is left is computing. When the program ends a file
// $MPM_COUNT.<rank> has lines of words:
//
//     computing <seconds>     seconds of the thread outside MPI
//     inMPI <seconds>         seconds of the thread in MPI, waiting by looking too
//     <call> <calls> <bytes>  bytes that this rank gives to the call
//     to <rank> <calls> <bytes>       by MPI_Isend: what goes between neighbours

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum
{
    ALLREDUCE,
    ALLTOALL,
    ALLTOALLV,
    BSEND,
    GATHERV,
    IRECV,
    ISEND,
    RECV,
    SCATTERV,
    SEND,
    N_KINDS
};

static const char* const names[N_KINDS] = {"Allreduce", "Alltoall", "Alltoallv", "Bsend",
    "Gatherv", "Irecv", "Isend", "Recv", "Scatterv", "Send"};

static long long calls[N_KINDS];
static long long bytes[N_KINDS];
static long long* callsTo;
static long long* bytesTo;
static int rank;
static int nRanks = 1;
static double inside;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void add(int kind, int count, MPI_Datatype type)
{
    int size = 0;
    PMPI_Type_size(type, &size);
    ++calls[kind];
    bytes[kind] += (long long)count * size;
}

static void sum(const int counts[], MPI_Datatype type, int kind)
{
    long long n = 0;
    for (int i = 0; counts && i < nRanks; ++i)
    {
        n += counts[i];
    }
    int size = 0;
    PMPI_Type_size(type, &size);
    ++calls[kind];
    bytes[kind] += n * size;
}

// Hand the call on, its seconds to those in MPI
#define HAND_ON(call) \
    const double start = now(); \
    const int result = P##call; \
    inside += now() - start; \
    return result

int MPI_Init_thread(int* argc, char*** argv, int required, int* provided)
{
    const int result = PMPI_Init_thread(argc, argv, required, provided);
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    PMPI_Comm_size(MPI_COMM_WORLD, &nRanks);
    callsTo = calloc((size_t)nRanks, sizeof(long long));
    bytesTo = calloc((size_t)nRanks, sizeof(long long));
    return result;
}

int MPI_Allreduce(
    const void* from, void* to, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm)
{
    add(ALLREDUCE, count, type);
    HAND_ON(MPI_Allreduce(from, to, count, type, op, comm));
}

int MPI_Alltoall(const void* from, int nFrom, MPI_Datatype fromType, void* to, int nTo,
    MPI_Datatype toType, MPI_Comm comm)
{
    add(ALLTOALL, nFrom * nRanks, fromType);
    HAND_ON(MPI_Alltoall(from, nFrom, fromType, to, nTo, toType, comm));
}

int MPI_Alltoallv(const void* from, const int nFrom[], const int atFrom[], MPI_Datatype fromType,
    void* to, const int nTo[], const int atTo[], MPI_Datatype toType, MPI_Comm comm)
{
    sum(nFrom, fromType, ALLTOALLV);
    HAND_ON(MPI_Alltoallv(from, nFrom, atFrom, fromType, to, nTo, atTo, toType, comm));
}

int MPI_Gatherv(const void* from, int nFrom, MPI_Datatype fromType, void* to, const int nTo[],
    const int atTo[], MPI_Datatype toType, int root, MPI_Comm comm)
{
    add(GATHERV, nFrom, fromType);
    HAND_ON(MPI_Gatherv(from, nFrom, fromType, to, nTo, atTo, toType, root, comm));
}

int MPI_Scatterv(const void* from, const int nFrom[], const int atFrom[], MPI_Datatype fromType,
    void* to, int nTo, MPI_Datatype toType, int root, MPI_Comm comm)
{
    sum(rank == root ? nFrom : NULL, fromType, SCATTERV);
    HAND_ON(MPI_Scatterv(from, nFrom, atFrom, fromType, to, nTo, toType, root, comm));
}

int MPI_Bsend(const void* from, int count, MPI_Datatype type, int dest, int tag, MPI_Comm comm)
{
    add(BSEND, count, type);
    HAND_ON(MPI_Bsend(from, count, type, dest, tag, comm));
}

int MPI_Send(const void* from, int count, MPI_Datatype type, int dest, int tag, MPI_Comm comm)
{
    add(SEND, count, type);
    HAND_ON(MPI_Send(from, count, type, dest, tag, comm));
}

int MPI_Isend(const void* from, int count, MPI_Datatype type, int dest, int tag, MPI_Comm comm,
    MPI_Request* request)
{
    const long long before = bytes[ISEND];
    add(ISEND, count, type);
    ++callsTo[dest];
    bytesTo[dest] += bytes[ISEND] - before;
    HAND_ON(MPI_Isend(from, count, type, dest, tag, comm, request));
}

int MPI_Irecv(void* to, int count, MPI_Datatype type, int source, int tag, MPI_Comm comm,
    MPI_Request* request)
{
    ++calls[IRECV];
    HAND_ON(MPI_Irecv(to, count, type, source, tag, comm, request));
}

int MPI_Recv(void* to, int count, MPI_Datatype type, int source, int tag, MPI_Comm comm,
    MPI_Status* status)
{
    ++calls[RECV];
    HAND_ON(MPI_Recv(to, count, type, source, tag, comm, status));
}

int MPI_Probe(int source, int tag, MPI_Comm comm, MPI_Status* status)
{
    HAND_ON(MPI_Probe(source, tag, comm, status));
}

int MPI_Test(MPI_Request* request, int* flag, MPI_Status* status)
{
    HAND_ON(MPI_Test(request, flag, status));
}

int MPI_Wait(MPI_Request* request, MPI_Status* status)
{
    HAND_ON(MPI_Wait(request, status));
}

int MPI_Waitall(int n, MPI_Request requests[], MPI_Status statuses[])
{
    HAND_ON(MPI_Waitall(n, requests, statuses));
}

// A run on one processor never calls MPI_Finalize
__attribute__((destructor)) static void writeCounts(void)
{
    const double all = now();
    char path[4096];
    const char* base = getenv("MPM_COUNT");
    if (!base || snprintf(path, sizeof path, "%s.%d", base, rank) >= (int)sizeof path)
    {
        return;
    }
    FILE* file = fopen(path, "w");
    if (!file)
    {
        return;
    }
    fprintf(file, "computing %.6f\ninMPI %.6f\n", all - inside, inside);
    for (int kind = 0; kind < N_KINDS; ++kind)
    {
        fprintf(file, "%s %lld %lld\n", names[kind], calls[kind], bytes[kind]);
    }
    for (int i = 0; callsTo && i < nRanks; ++i)
    {
        if (callsTo[i])
        {
            fprintf(file, "to %d %lld %lld\n", i, callsTo[i], bytesTo[i]);
        }
    }
    fclose(file);
}
