// Qhull's reentrant library, for any dimension: convex hulls where QHULL_HULLS is defined, with its default options and
// triangulated output; else Delaunay triangulations, with the options that are usual for Delaunay triangulations:
// triangulated output, scaled last coordinate, coplanar points kept and, up to 4 dimensions, a point at infinity for
// cospherical input (in more dimensions Qx, the default). Qhull computes in floating point and merges facets, so its
// cells are not exact.
#include <libqhull_r/qhull_ra.h>

#include "bench.h"

static uint64_t hash_of(qhT *qh, const bench_points *points) {
    bench_index index = bench_index_make(points);
    uint64_t hash = 0;
    facetT *facet;
    FORALLfacets {
        if (facet->upperdelaunay)
            continue;
        uint64_t vertices[PARADT_MAX_DIM + 1];
        int count = 0;
        vertexT *vertex, **vertexp;
        FOREACHvertex_(facet->vertices) {
            size_t point = (size_t)qh_pointid(qh, vertex->point);
            if (count <= points->dim && point < points->count)
                vertices[count++] = bench_index_of(&index, points->coordinates + point * (size_t)points->dim);
        }
        hash += paradt_hash_cell(vertices, count);
    }
    bench_index_free(&index);
    return hash;
}

int main(int argc, char **argv) {
    bench_arguments arguments = bench_parse(argc, argv);
    bench_points points = bench_read(arguments.path);
    if (points.weights)
        bench_fail(arguments.path, "has weights");
    size_t bytes = points.count * (size_t)points.dim * sizeof(coordT);
    coordT *input = malloc(bytes);
    if (!input)
        bench_fail(arguments.path, "no memory");
    memcpy(input, points.coordinates, bytes);
#ifdef QHULL_HULLS
    char command[] = "qhull Qt Pp";
#else
    char command[] = "qhull d Qt Qbb Qc Q12 Pp Qz";
    char *last = strrchr(command, ' '); // Qz, the point at infinity
    if (points.dim > 4)
        *last = 0;
#endif
    qhT memory;
    qhT *qh = &memory;
    QHULL_LIB_CHECK
    qh_zero(qh, stderr);
    bench_clock clock = bench_start(&points);
    int status = qh_new_qhull(qh, points.dim, (int)points.count, input, False, command, NULL, stderr);
    bench_stop(&clock);
    if (status)
        bench_fail("Qhull", "failed");
    uint64_t cells = 0;
    facetT *facet;
    FORALLfacets cells += !facet->upperdelaunay;
    uint64_t hash = arguments.hash ? hash_of(qh, &points) : 0;
    bench_print(&arguments, &points, &clock, cells, arguments.hash ? &hash : NULL, "");
    qh_freeqhull(qh, qh_ALL);
    free(input);
    return 0;
}
