// An MPI of one process, for measurements. Ranks are threads that run one at a time, each until it has to wait for
// another. So the work of a rank between two calls is timed undisturbed, whatever the number of ranks, and the bytes
// that its calls would send are counted. The header has only the functions that paradt_mpi.h and the including programs
// call.
//
// Modelled time. A collective call ends a step. A step takes as long as its slowest rank (CPU time of the thread) plus
// its messages. These are modelled: the rank that sends and receives most pays LATENCY for each message and
// 1 / BANDWIDTH for each byte, in both directions. The collective call takes LATENCY for each of log2(ranks) rounds,
// the least number there can be, and 1 / BANDWIDTH for each byte that a rank receives.
//
// Several runs. The program runs several times, and all runs have the same steps. A step of a rank is divided into
// stretches, which end with each call of the rank to MPI or to alone_progress. (The library reports progress after
// every thousand insertions.) Of each stretch the least time of all runs counts, which leaves out what else the machine
// did meanwhile. Whole steps would not do: the least time of one rank's long step still holds an average of these
// disturbances, while the least times of many ranks' short steps do not, so many ranks would look too fast.
//
// Touched pages. A rank waits for seconds here, while a rank of a cluster waits for milliseconds, and the host of a
// virtual machine takes back pages that are idle so long. Therefore the memory of a rank from alone_alloc is touched
// when it is allocated, and after each long wait of the rank. Touching is not timed.
#ifndef ALONE_MPI_H
#define ALONE_MPI_H

#include <pthread.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef int MPI_Comm, MPI_Status, MPI_Request;
typedef enum { MPI_BYTE, MPI_UINT8_T, MPI_INT, MPI_INT64_T, MPI_UINT64_T, MPI_DOUBLE } MPI_Datatype;
typedef enum { MPI_SUM, MPI_MIN, MPI_MAX } MPI_Op;

enum { MPI_COMM_WORLD = 0, MPI_SUCCESS = 0, ALONE_MOST_RANKS = 1024 };
#define MPI_IN_PLACE      ((void *)-1)
#define MPI_STATUS_IGNORE NULL

static const double ALONE_LATENCY = 2e-6, ALONE_BANDWIDTH = 1e10; // seconds a message, bytes a second

typedef struct alone_message {
    struct alone_message *next;
    int from;
    size_t bytes;
    char *data;
} alone_message;

// The head of a block of memory
typedef struct alone_block {
    struct alone_block *next, *previous; // in the ring of the rank's blocks
    size_t bytes;
    void *unused; // pads the head, so that the block is aligned as malloc aligns it
} alone_block;

typedef struct alone_rank {
    pthread_t thread;
    pthread_cond_t turn;
    const void *in; // arguments of the current collective call
    void *out;
    double began;           // CPU time of the thread when the current stretch began
    double messages, bytes; // sent and received in this step
    size_t stretch;         // number of the current stretch
    int ended;              // the program has returned
    alone_block blocks;     // head of the ring of the rank's blocks; its links are NULL before the first block
    double waiting_since;   // wall time when the rank gave its turn away
    alone_message *mail;    // messages to the rank that it has not received, oldest first
    alone_message **last;   // where to append the next message
} alone_rank;

static struct {
    int ranks;
    int running; // the rank whose turn it is
    pthread_mutex_t lock;
    alone_rank rank[ALONE_MOST_RANKS];
    int arrived;         // ranks that have arrived at the current collective call
    unsigned long calls; // collective calls that have ended: the number of the current step
    void (*program)(int rank);
} alone;

// The stretches of a rank
typedef struct alone_stretches {
    double *least; // [capacity] seconds, the least of the runs so far
    size_t capacity;
} alone_stretches;

// The steps of all runs with the same number of ranks. Has to be all zero before the first run.
typedef struct alone_record {
    int ranks, runs;
    unsigned long steps, capacity; // of `ends` and `messaging`, in steps
    alone_stretches rank[ALONE_MOST_RANKS];
    size_t *ends;      // [steps][ranks] first stretch after the step
    double *messaging; // [steps] seconds of the messages, which are the same in all runs
} alone_record;

static alone_record *alone_current; // record of the current run

static _Thread_local int alone_me;
static _Thread_local struct {
    char *data;
    int from; // -1: a send, which has ended
} alone_requests[2 * ALONE_MOST_RANKS + 64];
static _Thread_local int alone_request_count;

// Returns the CPU time of the thread in seconds.
static double alone_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// realloc, for count * bytes bytes
static void *alone_grow(void *block, size_t count, size_t bytes) {
    void *larger = realloc(block, count * bytes);
    if (!larger) abort();
    return larger;
}

// Ends a stretch: each call begins with this. Returns this rank.
static alone_rank *alone_enter(void) {
    alone_rank *me = &alone.rank[alone_me];
    alone_stretches *mine = &alone_current->rank[alone_me];
    double seconds = alone_now() - me->began, *least;
    if (me->stretch == mine->capacity) {
        mine->capacity = 2 * mine->capacity + 64;
        mine->least = (double *)alone_grow(mine->least, mine->capacity, sizeof *mine->least);
    }
    least = &mine->least[me->stretch++];
    *least = alone_current->runs && *least < seconds ? *least : seconds;
    return me;
}

// Begins a stretch: each call ends with this.
static int alone_leave(void) {
    alone.rank[alone_me].began = alone_now();
    return MPI_SUCCESS;
}

// A paradt_progress that ends a stretch and begins the next
static int alone_progress(void *user, double fraction) {
    (void)user, (void)fraction;
    alone_enter();
    return alone_leave();
}

// Gives the turn to the next rank that has not ended. The caller holds the lock.
static void alone_pass(void) {
    int next = alone_me;
    do next = (next + 1) % alone.ranks;
    while (alone.rank[next].ended && next != alone_me);
    alone.running = next;
    pthread_cond_signal(&alone.rank[next].turn);
}

// The caller holds the lock.
static void alone_await_turn(void) {
    while (alone.running != alone_me) pthread_cond_wait(&alone.rank[alone_me].turn, &alone.lock);
}

// Touches each page of a block.
static void alone_touch(alone_block *block) {
    enum { PAGE = 4096 };
    for (size_t at = 0; at < block->bytes; at += PAGE) {
        volatile char *byte = (volatile char *)(block + 1) + at;
        *byte = *byte;
    }
}

// The functions of a paradt_allocator. A block has to be freed by the rank that allocated it.
static void *alone_alloc(void *user, size_t bytes) {
    alone_rank *me = &alone.rank[alone_me];
    alone_block *block = (alone_block *)malloc(sizeof *block + bytes);
    double began = alone_now();
    (void)user;
    if (!block) return NULL;
    if (!me->blocks.next) me->blocks.next = me->blocks.previous = &me->blocks;
    block->bytes = bytes;
    block->previous = &me->blocks;
    block->next = me->blocks.next;
    block->next->previous = me->blocks.next = block;
    alone_touch(block);
    me->began += alone_now() - began;
    return block + 1;
}

static void alone_free(void *user, void *memory) {
    alone_block *block = (alone_block *)memory - 1;
    (void)user;
    block->next->previous = block->previous;
    block->previous->next = block->next;
    free(block);
}

// Returns the wall time in seconds.
static double alone_wall(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// Lets the other ranks run until it is this rank's turn again.
static void alone_yield(void) {
    const double LONG = 0.5; // seconds
    alone_rank *me = &alone.rank[alone_me];
    me->waiting_since = alone_wall();
    pthread_mutex_lock(&alone.lock);
    alone_pass();
    alone_await_turn();
    pthread_mutex_unlock(&alone.lock);
    if (alone_wall() - me->waiting_since < LONG || !me->blocks.next) return;
    for (alone_block *block = me->blocks.next; block != &me->blocks; block = block->next) alone_touch(block);
}

// Records the step that the current call ends. received: bytes that each rank receives in the call
static void alone_end_step(double received) {
    alone_record *record = alone_current;
    double longest = 0, rounds = 0;
    size_t *ends, ranks = (size_t)alone.ranks;
    if (alone.calls == record->capacity) {
        record->capacity = 2 * record->capacity + 64;
        record->ends = (size_t *)alone_grow(record->ends, record->capacity * ranks, sizeof *record->ends);
        record->messaging = (double *)alone_grow(record->messaging, record->capacity, sizeof *record->messaging);
    }
    ends = record->ends + alone.calls * ranks;
    for (int r = 0; r < alone.ranks; r++) {
        alone_rank *rank = &alone.rank[r];
        double seconds = rank->messages * ALONE_LATENCY + rank->bytes / ALONE_BANDWIDTH;
        longest = seconds > longest ? seconds : longest;
        if (record->runs && ends[r] != rank->stretch) abort(); // this run differs from the first
        ends[r] = rank->stretch;
        rank->messages = rank->bytes = 0;
    }
    for (int reached = 1; reached < alone.ranks; reached *= 2) rounds++;
    record->messaging[alone.calls] =
        longest + rounds * ALONE_LATENCY + (alone.ranks > 1 ? received / ALONE_BANDWIDTH : 0);
}

// The seconds of the first steps of a record
typedef struct alone_sum {
    double all_work;  // of all ranks together
    double most_work; // of the rank with the most work
    double computing; // of the slowest rank of each step, summed over the steps
    double messaging; // of the messages
} alone_sum;

// Returns the seconds of a rank in a step.
static double alone_work(const alone_record *record, unsigned long step, int rank) {
    const size_t *end = record->ends + step * (size_t)record->ranks + (size_t)rank;
    double sum = 0;
    for (size_t i = step ? end[-record->ranks] : 0; i < *end; i++) sum += record->rank[rank].least[i];
    return sum;
}

// Sums up the first `steps` steps of a record.
static alone_sum alone_add_up(const alone_record *record, unsigned long steps) {
    alone_sum sum = {0, 0, 0, 0};
    for (unsigned long step = 0; step < steps; step++) {
        double slowest = 0;
        for (int r = 0; r < record->ranks; r++) {
            double work = alone_work(record, step, r);
            slowest = work > slowest ? work : slowest;
        }
        sum.computing += slowest;
        sum.messaging += record->messaging[step];
    }
    for (int r = 0; r < record->ranks; r++) {
        double work = 0;
        for (unsigned long step = 0; step < steps; step++) work += alone_work(record, step, r);
        sum.all_work += work;
        sum.most_work = work > sum.most_work ? work : sum.most_work;
    }
    return sum;
}

// A collective call. Each rank arrives with its `in` and `out`. The last one calls `finish`, which moves the data of
// all ranks, and ends the step. received: bytes that each rank receives
static int alone_collective(const void *in, void *out, double received, void (*finish)(void *facts), void *facts) {
    alone_rank *me = alone_enter();
    unsigned long call = alone.calls;
    me->in = in == MPI_IN_PLACE ? out : in;
    me->out = out;
    if (++alone.arrived == alone.ranks) {
        finish(facts);
        alone_end_step(received);
        alone.arrived = 0;
        alone.calls++;
    }
    while (alone.calls == call) alone_yield();
    return alone_leave();
}

// --- the functions of MPI

static size_t alone_size(MPI_Datatype type) {
    static const size_t sizes[] = {1, 1, sizeof(int), 8, 8, 8};
    return sizes[type];
}

// The arguments of a collective call that `finish` needs; they are the same on all ranks
typedef struct alone_facts {
    size_t count;
    MPI_Datatype type;
    MPI_Op op;
    int root;
} alone_facts;

#define ALONE_COMBINE(name, value)                                                                                     \
    static void name(value *sum, const value *x, size_t count, MPI_Op op) {                                            \
        for (size_t i = 0; i < count; i++)                                                                             \
            sum[i] = op == MPI_SUM ? (value)(sum[i] + x[i]) : (op == MPI_MIN) == (x[i] < sum[i]) ? x[i] : sum[i];      \
    }
ALONE_COMBINE(alone_combine_bytes, uint8_t)
ALONE_COMBINE(alone_combine_ints, int)
ALONE_COMBINE(alone_combine_signed, int64_t)
ALONE_COMBINE(alone_combine_unsigned, uint64_t)
ALONE_COMBINE(alone_combine_doubles, double)

static void alone_combine(void *sum, const void *x, const alone_facts *f) {
    switch (f->type) {
    case MPI_BYTE:
    case MPI_UINT8_T: alone_combine_bytes((uint8_t *)sum, (const uint8_t *)x, f->count, f->op); break;
    case MPI_INT: alone_combine_ints((int *)sum, (const int *)x, f->count, f->op); break;
    case MPI_INT64_T: alone_combine_signed((int64_t *)sum, (const int64_t *)x, f->count, f->op); break;
    case MPI_UINT64_T: alone_combine_unsigned((uint64_t *)sum, (const uint64_t *)x, f->count, f->op); break;
    case MPI_DOUBLE: alone_combine_doubles((double *)sum, (const double *)x, f->count, f->op); break;
    }
}

// Each alone_finish_... moves the data of one kind of collective call.

static void alone_finish_allreduce(void *context) {
    const alone_facts *f = (const alone_facts *)context;
    size_t bytes = f->count * alone_size(f->type);
    void *sum = malloc(bytes + 1);
    memcpy(sum, alone.rank[0].in, bytes);
    for (int r = 1; r < alone.ranks; r++) alone_combine(sum, alone.rank[r].in, f);
    for (int r = 0; r < alone.ranks; r++) memcpy(alone.rank[r].out, sum, bytes);
    free(sum);
}

static void alone_finish_exscan(void *context) {
    const alone_facts *f = (const alone_facts *)context;
    size_t bytes = f->count * alone_size(f->type);
    void *sum = calloc(bytes + 1, 1), *next = malloc(bytes + 1);
    for (int r = 0; r < alone.ranks; r++) {
        memcpy(next, sum, bytes);
        alone_combine(sum, alone.rank[r].in, f);
        if (r > 0) memcpy(alone.rank[r].out, next, bytes);
    }
    free(sum);
    free(next);
}

static void alone_finish_allgather(void *context) {
    const alone_facts *f = (const alone_facts *)context;
    size_t bytes = f->count * alone_size(f->type);
    for (int r = 0; r < alone.ranks; r++)
        for (int from = 0; from < alone.ranks; from++)
            memcpy((char *)alone.rank[r].out + (size_t)from * bytes, alone.rank[from].in, bytes);
}

static void alone_finish_alltoall(void *context) {
    const alone_facts *f = (const alone_facts *)context;
    size_t bytes = f->count * alone_size(f->type);
    for (int r = 0; r < alone.ranks; r++)
        for (int from = 0; from < alone.ranks; from++)
            memcpy((char *)alone.rank[r].out + (size_t)from * bytes,
                   (const char *)alone.rank[from].in + (size_t)r * bytes, bytes);
}

static void alone_finish_bcast(void *context) {
    const alone_facts *f = (const alone_facts *)context;
    for (int r = 0; r < alone.ranks; r++)
        if (r != f->root) memcpy(alone.rank[r].out, alone.rank[f->root].in, f->count * alone_size(f->type));
}

static int MPI_Allreduce(const void *in, void *out, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
    alone_facts f = {(size_t)count, type, op, 0};
    (void)comm;
    return alone_collective(in, out, (double)(f.count * alone_size(type)), alone_finish_allreduce, &f);
}

static int MPI_Exscan(const void *in, void *out, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
    alone_facts f = {(size_t)count, type, op, 0};
    (void)comm;
    return alone_collective(in, out, (double)(f.count * alone_size(type)), alone_finish_exscan, &f);
}

// A collective call in which each rank receives `count` values from each other rank
static int alone_from_all(const void *in, int count, MPI_Datatype type, void *out, void (*finish)(void *facts)) {
    alone_facts f = {(size_t)count, type, MPI_SUM, 0};
    return alone_collective(in, out, (double)f.count * (double)alone_size(type) * (alone.ranks - 1), finish, &f);
}

static int MPI_Allgather(const void *in, int count, MPI_Datatype type, void *out, int got, MPI_Datatype got_type,
                         MPI_Comm comm) {
    (void)got, (void)got_type, (void)comm;
    return alone_from_all(in, count, type, out, alone_finish_allgather);
}

static int MPI_Alltoall(const void *in, int count, MPI_Datatype type, void *out, int got, MPI_Datatype got_type,
                        MPI_Comm comm) {
    (void)got, (void)got_type, (void)comm;
    return alone_from_all(in, count, type, out, alone_finish_alltoall);
}

static int MPI_Bcast(void *data, int count, MPI_Datatype type, int root, MPI_Comm comm) {
    alone_facts f = {(size_t)count, type, MPI_SUM, root};
    (void)comm;
    return alone_collective(data, data, (double)(f.count * alone_size(type)), alone_finish_bcast, &f);
}

static void alone_count_message(int rank, size_t bytes) {
    alone.rank[rank].messages++;
    alone.rank[rank].bytes += (double)bytes;
}

// Copies the message, so that no send ever waits.
static int MPI_Isend(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
                     MPI_Request *request) {
    size_t bytes = (size_t)count * alone_size(type);
    alone_message *message;
    (void)tag, (void)comm;
    alone_enter();
    message = (alone_message *)malloc(sizeof *message);
    message->next = NULL;
    message->from = alone_me;
    message->bytes = bytes;
    message->data = (char *)malloc(bytes + 1);
    memcpy(message->data, data, bytes);
    *alone.rank[to].last = message;
    alone.rank[to].last = &message->next;
    alone_count_message(alone_me, bytes);
    *request = alone_request_count++;
    alone_requests[*request].from = -1;
    return alone_leave();
}

static int MPI_Irecv(void *data, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Request *request) {
    (void)tag, (void)comm;
    alone_enter();
    alone_count_message(alone_me, (size_t)count * alone_size(type));
    *request = alone_request_count++;
    alone_requests[*request].from = from;
    alone_requests[*request].data = (char *)data;
    return alone_leave();
}

// Removes the first message from a rank and returns it; NULL if there is none. Between two ranks there may be only one
// at a time. So a message must not be longer than the pieces of paradt_mpi.h: pieces would be received in the wrong
// order.
static alone_message *alone_take_message(int from) {
    alone_rank *me = &alone.rank[alone_me];
    for (alone_message **at = &me->mail; *at; at = &(*at)->next) {
        alone_message *message = *at;
        if (message->from != from) continue;
        *at = message->next;
        if (!*at) me->last = at;
        return message;
    }
    return NULL;
}

static int MPI_Wait(MPI_Request *request, MPI_Status *status) {
    alone_message *message = NULL;
    (void)status;
    alone_enter();
    while (alone_requests[*request].from >= 0 && !(message = alone_take_message(alone_requests[*request].from)))
        alone_yield();
    if (message) {
        memcpy(alone_requests[*request].data, message->data, message->bytes);
        free(message->data);
        free(message);
    }
    alone_request_count--;
    return alone_leave();
}

static int MPI_Comm_dup(MPI_Comm comm, MPI_Comm *copy) {
    *copy = comm;
    return MPI_SUCCESS;
}

static int MPI_Comm_free(MPI_Comm *comm) {
    (void)comm;
    return MPI_SUCCESS;
}

static int MPI_Comm_rank(MPI_Comm comm, int *rank) {
    (void)comm;
    *rank = alone_me;
    return MPI_SUCCESS;
}

static int MPI_Comm_size(MPI_Comm comm, int *size) {
    (void)comm;
    *size = alone.ranks;
    return MPI_SUCCESS;
}

// --- running

// The thread of a rank
static void *alone_thread(void *context) {
    alone_me = (int)(intptr_t)context;
    pthread_mutex_lock(&alone.lock);
    alone_await_turn();
    pthread_mutex_unlock(&alone.lock);
    alone_leave();
    alone.program(alone_me);
    pthread_mutex_lock(&alone.lock);
    alone.rank[alone_me].ended = 1;
    alone_pass();
    pthread_mutex_unlock(&alone.lock);
    return NULL;
}

// Frees what a record holds and makes it all zero.
static void alone_forget(alone_record *record) {
    for (int r = 0; r < record->ranks; r++) free(record->rank[r].least);
    free(record->ends);
    free(record->messaging);
    memset(record, 0, sizeof *record);
}

// Runs the program as `ranks` ranks, which is the same number for all runs of a record, and adds the run to the record.
static void alone_run(alone_record *record, int ranks, void (*program)(int rank)) {
    memset(&alone, 0, sizeof alone);
    alone.ranks = record->ranks = ranks;
    alone.program = program;
    alone_current = record;
    pthread_mutex_init(&alone.lock, NULL);
    for (int r = 0; r < ranks; r++) {
        pthread_cond_init(&alone.rank[r].turn, NULL);
        alone.rank[r].last = &alone.rank[r].mail;
    }
    for (int r = 0; r < ranks; r++)
        if (pthread_create(&alone.rank[r].thread, NULL, alone_thread, (void *)(intptr_t)r)) abort();
    for (int r = 0; r < ranks; r++) pthread_join(alone.rank[r].thread, NULL);
    if (record->runs++ && alone.calls != record->steps) abort(); // this run differs from the first
    record->steps = alone.calls;
}

#endif
