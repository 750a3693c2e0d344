// MPI calls that sleep while they wait. MPI libraries wait by polling. That is fast if every rank has a processor, and very
// slow if eight ranks share two: a waiting rank takes processor time from the ranks it waits for. The calls in which
// paradt_mpi.h waits are replaced, through MPI's profiling interface, by nonblocking calls and naps.
#ifndef MPI_POLITE_H
#define MPI_POLITE_H

#include <mpi.h>
#include <time.h>

static int polite_wait(MPI_Request *request, MPI_Status *status) {
    struct timespec nap = {0, 20000};
    int done = 0, error = PMPI_Test(request, &done, status), tries;
    for (tries = 0; !error && !done; tries++) {
        if (tries == 200) nap.tv_nsec *= 10; // a long wait: others work, and every look takes time from them
        if (tries > 20) nanosleep(&nap, NULL);
        error = PMPI_Test(request, &done, status);
    }
    return error;
}

#define POLITE(name, nonblocking, parameters, arguments)                                                               \
    int name parameters {                                                                                              \
        MPI_Request request;                                                                                           \
        int error = nonblocking arguments;                                                                             \
        return error ? error : polite_wait(&request, MPI_STATUS_IGNORE);                                               \
    }

int MPI_Wait(MPI_Request *request, MPI_Status *status) {
    return polite_wait(request, status);
}

POLITE(MPI_Allreduce, PMPI_Iallreduce,
       (const void *send, void *receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
       (send, receive, count, type, op, comm, &request))
POLITE(MPI_Bcast, PMPI_Ibcast, (void *data, int count, MPI_Datatype type, int root, MPI_Comm comm),
       (data, count, type, root, comm, &request))
POLITE(MPI_Exscan, PMPI_Iexscan,
       (const void *send, void *receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
       (send, receive, count, type, op, comm, &request))
POLITE(MPI_Allgather, PMPI_Iallgather,
       (const void *send, int count, MPI_Datatype type, void *receive, int got, MPI_Datatype as, MPI_Comm comm),
       (send, count, type, receive, got, as, comm, &request))
POLITE(MPI_Alltoall, PMPI_Ialltoall,
       (const void *send, int count, MPI_Datatype type, void *receive, int got, MPI_Datatype as, MPI_Comm comm),
       (send, count, type, receive, got, as, comm, &request))
POLITE(MPI_Barrier, PMPI_Ibarrier, (MPI_Comm comm), (comm, &request))
POLITE(MPI_Comm_dup, PMPI_Comm_idup, (MPI_Comm comm, MPI_Comm *copy), (comm, copy, &request))

#endif
