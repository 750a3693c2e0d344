// HXT, the parallel Delaunay code inside Gmsh. libgmsh exports its function, but no header of the package declares it.
// The declarations below are those of libgmsh 4.8. Compare them with the source before using another version.
#include <gmshc.h>
#include <omp.h>

#include "bench.h"

#if GMSH_API_VERSION_MAJOR != 4 || GMSH_API_VERSION_MINOR != 8
#error "these declarations of HXT hold for Gmsh 4.8"
#endif

#define HXT_GHOST UINT32_MAX // the vertex at infinity

typedef struct hxt_mesh {
    double *coordinates; // [vertex_count][4], the fourth is for HXT's own use
    uint32_t vertex_count;
    uint32_t vertex_size;
    uint32_t *nodes; // [cell_count][4]
    uint64_t *neighbors;
    uint32_t *colors;
    uint16_t *flags;
    uint64_t cell_count;
    uint64_t cell_size;
    uint64_t others[21]; // triangles, lines, points, boundary: not used here
} hxt_mesh;

typedef struct hxt_delaunay_options {
    void *box;
    void *nodal_sizes;
    uint32_t vertices_in_mesh;
    uint32_t insertion_first;
    double partitionability;
    int perfect_delaunay;
    int verbosity;
    int reproducible;
    int threads;
} hxt_delaunay_options;

int hxtMeshCreate(hxt_mesh **mesh);
int hxtDelaunay(hxt_mesh *mesh, hxt_delaunay_options *options);

// Is the ghost no vertex of the cell?
static int is_finite(const uint32_t *nodes) {
    for (int i = 0; i < 4; i++)
        if (nodes[i] == HXT_GHOST)
            return 0;
    return 1;
}

static uint64_t hash_of(const hxt_mesh *mesh, const bench_points *points) {
    bench_index index = bench_index_make(points);
    uint64_t hash = 0;
    for (uint64_t c = 0; c < mesh->cell_count; c++) {
        const uint32_t *nodes = mesh->nodes + 4 * c;
        if (!is_finite(nodes))
            continue;
        uint64_t vertices[4];
        for (int i = 0; i < 4; i++)
            vertices[i] = bench_index_of(&index, mesh->coordinates + 4 * (size_t)nodes[i]);
        hash += paradt_hash_cell(vertices, 4);
    }
    bench_index_free(&index);
    return hash;
}

int main(int argc, char **argv) {
    bench_arguments arguments = bench_parse(argc, argv);
    bench_points points = bench_read(arguments.path);
    if (points.dim != 3 || points.weights)
        bench_fail(arguments.path, "not 3 coordinates without weights");
    hxt_mesh *mesh;
    void *coordinates = NULL;
    if (hxtMeshCreate(&mesh) || posix_memalign(&coordinates, 64, (points.count + 1) * 4 * sizeof(double)))
        bench_fail(arguments.path, "no memory");
    mesh->coordinates = coordinates;
    mesh->vertex_count = mesh->vertex_size = (uint32_t)points.count;
    for (size_t i = 0; i < points.count; i++) {
        memcpy(mesh->coordinates + 4 * i, points.coordinates + 3 * i, 3 * sizeof(double));
        mesh->coordinates[4 * i + 3] = 0;
    }
    omp_set_num_threads((int)arguments.jobs); // HXT's helper functions ignore options.threads
    hxt_delaunay_options options = {0};
    options.perfect_delaunay = 1;
    options.threads = (int)arguments.jobs;
#pragma omp parallel
    bench_warm_up();
    bench_clock clock = bench_start(&points);
    int status = hxtDelaunay(mesh, &options);
    bench_stop(&clock);
    if (status < 0)
        bench_fail("HXT", "failed");
    uint64_t cells = 0;
    for (uint64_t c = 0; c < mesh->cell_count; c++)
        cells += (uint64_t)is_finite(mesh->nodes + 4 * c);
    uint64_t hash = arguments.hash ? hash_of(mesh, &points) : 0;
    bench_print(&arguments, &points, &clock, cells, arguments.hash ? &hash : NULL, "");
    return 0;
}
