// The smallest program that uses all of ParaDT: triangulates the corners of a cube and two points inside, certifies the result,
// and prints the number of cells and their hash. Compiled as C and as C++. It contains the implementation, unless USE_ONLY is
// defined; then it uses the implementation of another file.
#ifndef USE_ONLY
#define PARADT_IMPLEMENTATION
#endif
#include "paradt.h"
#include "paradt.h" // a second inclusion changes nothing

#include <stdio.h>
#include <string.h>

#ifdef SECOND_FILE
int second_file(void);
int second_file(void)
#else
#ifdef CALL_SECOND_FILE
#ifdef __cplusplus
extern "C"
#endif
int second_file(void);
#endif
int main(void)
#endif
{
    static const double corners[10][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},       {0, 0, 1},
                                          {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {.5, .25, .125}, {.75, .5, .5}};
    paradt_points points;
    paradt_options options;
    paradt_triangulation result;
    paradt_fault fault;
    paradt_status status;
    memset(&points, 0, sizeof points);
    memset(&options, 0, sizeof options);
    points.data = corners;
    points.count = 10;
    points.dim = 3;
    status = paradt_triangulate(&result, &points, &options);
    if (status == PARADT_OK)
        status = paradt_check(&result, &points, &options, &fault);
    if (status != PARADT_OK) {
        printf("%s\n", paradt_status_string(status));
        return 1;
    }
    printf("%d cells, hash %08lx%08lx\n", (int)result.cell_count, (unsigned long)(paradt_hash(&result) >> 32),
           (unsigned long)(paradt_hash(&result) & 0xffffffffu));
    paradt_free(&result);
#ifdef CALL_SECOND_FILE
    return second_file();
#else
    return 0;
#endif
}
