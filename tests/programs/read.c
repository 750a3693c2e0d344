// Prints the points of an input as the tools read it, in one line: x y z;x y z;... with weights behind the coordinates,
// then a note, if there is one, in brackets. Usage: read [--dim D] [--weights] [--radii] [--columns LIST] [--format
// NAME] INPUT. The status is that of the tools: 3 for input that can't be read, 2 for wrong usage.
#define PARADT_READ_IMPLEMENTATION
#include "examples/paradt_read.h"

static void print(const paradt_io_points *points) {
    size_t i;
    int k;
    for (i = 0; i < points->count; i++) {
        for (k = 0; k < points->dim; k++)
            printf(k ? " %.17g" : "%.17g", points->coordinates[i * (size_t)points->dim + (size_t)k]);
        if (points->weights) printf(" %.17g", points->weights[i]);
        putchar(';');
    }
    if (*points->note) printf(" [%s]", points->note);
    putchar('\n');
}

int main(int count, char **arguments) {
    static const int statuses[] = {0, 3, 2, 1};
    paradt_io_want want;
    paradt_io_points points;
    paradt_io_error error;
    const char *reason = NULL;
    int i;
    memset(&want, 0, sizeof want);
    for (i = 1; i + 1 < count && !reason; i++) {
        if (strcmp(arguments[i], "--weights") == 0) want.weights = 1;
        else if (strcmp(arguments[i], "--radii") == 0) want.radii = 1;
        else if (strcmp(arguments[i], "--dim") == 0) want.dim = atoi(arguments[++i]);
        else if (strcmp(arguments[i], "--columns") == 0)
            reason = paradt_io_check_columns(want.columns = arguments[++i]);
        else if (strcmp(arguments[i], "--format") == 0) reason = paradt_io_check_format(want.format = arguments[++i]);
    }
    if (reason) {
        fprintf(stderr, "%s\n", reason);
        return 2;
    }
    if (!paradt_io_read(&points, arguments[count - 1], &want, &error)) {
        fprintf(stderr, "%s\n", error.text);
        return statuses[error.status];
    }
    print(&points);
    paradt_io_free(&points);
    return 0;
}
