// Ways of running tasks: what a program may hand in as parallel_for. `user` is ignored.
#ifndef RUNNERS_H
#define RUNNERS_H

#include <pthread.h>
#include <stdlib.h>

#include "paradt.h"

typedef struct runners_job {
    void (*task)(void *context, size_t index);
    void *context;
    size_t next, count;
    pthread_mutex_t lock;
} runners_job;

static void *runners_run(void *argument) {
    runners_job *j = (runners_job *)argument;
    for (;;) {
        pthread_mutex_lock(&j->lock);
        size_t index = j->next++;
        pthread_mutex_unlock(&j->lock);
        if (index >= j->count)
            return NULL;
        j->task(j->context, index);
    }
}

// On four threads, each of which takes the next task when it has done one.
static inline void run_on_threads(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    enum { THREADS = 4 };
    pthread_t threads[THREADS];
    runners_job j = {task, context, 0, count, PTHREAD_MUTEX_INITIALIZER};
    (void)user;
    for (int i = 0; i < THREADS; i++)
        if (pthread_create(&threads[i], NULL, runners_run, &j))
            abort();
    for (int i = 0; i < THREADS; i++)
        pthread_join(threads[i], NULL);
}

// In the calling thread, the last task first.
static inline void run_backwards(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    (void)user;
    while (count-- > 0)
        task(context, count);
}

#endif
