// ParaDT's locator, living set and Voronoi diagrams. See use.h. Parts that the library is compiled without
// (PARADT_NO_LOCATOR, PARADT_NO_DYNAMIC, PARADT_NO_VORONOI) are left out.
//
// The locator answers for the points as they were given; set-locate and set-nearest ask the living set.
#include "use.h"

static paradt_triangulation triangulation; // of the points
static paradt_points given;

static void must(paradt_status status, const char *what) {
    if (status != PARADT_OK)
        bench_fail(what, paradt_status_string(status));
}

static void triangulate(use *u) {
    paradt_triangulation t;
    use_start(u);
    must(paradt_triangulate(&t, &given, NULL), "triangulate");
    use_stop(u);
    paradt_free(&t);
}

#ifndef PARADT_NO_LOCATOR
static paradt_locator *locator;

static void check_cells(use *u, const paradt_location *found) {
    for (size_t i = 0; i < u->count; i++) {
        const double *vertices[PARADT_MAX_DIM + 1];
        const paradt_index *cell = triangulation.cells + (size_t)found[i].cell * (size_t)(given.dim + 1);
        if (!found[i].face)
            continue;
        for (int k = 0; k <= given.dim; k++)
            vertices[k] = u->points.coordinates + (size_t)cell[k] * (size_t)given.dim;
        use_check_cell(u, vertices, given.dim + 1);
    }
}

static void check_vertices(use *u, const paradt_index *found) {
    for (size_t i = 0; i < u->count; i++) {
        const double *vertices[1] = {u->points.coordinates + (size_t)found[i] * (size_t)given.dim};
        use_check_cell(u, vertices, 1);
    }
}

static void make_locator(use *u) {
    paradt_locator *second;
    use_start(u);
    must(paradt_locator_create(&second, &triangulation, &given, NULL), "locator");
    use_stop(u);
    paradt_locator_free(second);
}

// hinted: the queries are sorted, and each starts where the one before ended
static void locate(use *u, int hinted) {
    paradt_location *found = (paradt_location *)use_memory(u->count, sizeof *found);
    paradt_index hint = -1;
    use_queries(u, &u->asked);
    if (hinted)
        use_sort(u);
    use_start(u);
    for (size_t i = 0; i < u->count; i++) {
        found[i] = paradt_locate_one(locator, use_place(u, i), hint);
        if (hinted)
            hint = triangulation.cells[(size_t)found[i].cell * (size_t)(given.dim + 1)];
    }
    use_stop(u);
    check_cells(u, found);
    free(found);
}
static void locate_sorted(use *u) { locate(u, 1); }
static void locate_random(use *u) { locate(u, 0); }

static void locate_batch(use *u) {
    paradt_location *found = (paradt_location *)use_memory(u->count, sizeof *found);
    paradt_points queries;
    use_queries(u, &u->asked);
    queries = paradt_points_f64(u->places, u->count, given.dim);
    use_start(u);
    must(paradt_locate(locator, &queries, found, NULL), "locate");
    use_stop(u);
    check_cells(u, found);
    free(found);
}

static void nearest(use *u, int hinted) {
    paradt_index *found = (paradt_index *)use_memory(u->count, sizeof *found), hint = -1;
    use_queries(u, &u->asked);
    if (hinted)
        use_sort(u);
    use_start(u);
    for (size_t i = 0; i < u->count; i++) {
        found[i] = paradt_nearest_one(locator, use_place(u, i), hint);
        if (hinted)
            hint = found[i];
    }
    use_stop(u);
    check_vertices(u, found);
    free(found);
}
static void nearest_sorted(use *u) { nearest(u, 1); }
static void nearest_random(use *u) { nearest(u, 0); }

static void nearest_batch(use *u) {
    paradt_index *found = (paradt_index *)use_memory(u->count, sizeof *found);
    paradt_points queries;
    use_queries(u, &u->asked);
    queries = paradt_points_f64(u->places, u->count, given.dim);
    use_start(u);
    must(paradt_nearest(locator, &queries, found, NULL), "nearest");
    use_stop(u);
    check_vertices(u, found);
    free(found);
}
#endif

#ifndef PARADT_NO_DYNAMIC
static paradt_dynamic *set;

static void create(use *u) {
    paradt_dynamic *second;
    use_start(u);
    must(paradt_dynamic_create(&second, &given, NULL), "create");
    use_stop(u);
    paradt_dynamic_free(second);
}

static void insert(use *u, int hinted) {
    paradt_index id = -1;
    use_queries(u, &u->inserted);
    if (hinted)
        use_sort(u);
    use_start(u);
    for (size_t i = 0; i < u->count; i++)
        must(paradt_dynamic_insert(set, use_place(u, i), 0, hinted ? id : -1, &id), "insert");
    use_stop(u);
}
static void insert_sorted(use *u) { insert(u, 1); }
static void insert_random(use *u) { insert(u, 0); }

static void insert_batch(use *u) {
    paradt_points points;
    use_queries(u, &u->inserted);
    points = paradt_points_f64(u->places, u->count, given.dim);
    use_start(u);
    must(paradt_dynamic_insert_points(set, &points, NULL), "insert");
    use_stop(u);
}

static paradt_index *ids_of(const use *u) {
    paradt_index *ids = (paradt_index *)use_memory(u->count, sizeof *ids);
    for (size_t i = 0; i < u->count; i++)
        ids[i] = (paradt_index)u->which[i];
    return ids;
}

static void remove_random(use *u) {
    use_removals(u);
    use_start(u);
    for (size_t i = 0; i < u->count; i++)
        must(paradt_dynamic_remove(set, (paradt_index)u->which[i]), "remove");
    use_stop(u);
}

static void remove_batch(use *u) {
    paradt_index *ids;
    use_removals(u);
    ids = ids_of(u);
    use_start(u);
    must(paradt_dynamic_remove_points(set, ids, u->count), "remove");
    use_stop(u);
    free(ids);
}

static void move_random(use *u) {
    use_moves(u);
    use_start(u);
    for (size_t i = 0; i < u->count; i++)
        must(paradt_dynamic_move(set, (paradt_index)u->which[i], use_place(u, i), 0), "move");
    use_stop(u);
}

static void move_batch(use *u) {
    paradt_points places;
    paradt_index *ids;
    use_moves(u);
    ids = ids_of(u);
    places = paradt_points_f64(u->places, u->count, given.dim);
    use_start(u);
    must(paradt_dynamic_move_points(set, ids, &places), "move");
    use_stop(u);
    free(ids);
}

static void check_set_cell(use *u, paradt_index cell) {
    paradt_index ids[PARADT_MAX_DIM + 1];
    const double *vertices[PARADT_MAX_DIM + 1];
    if (!paradt_dynamic_cell(set, cell, ids, NULL))
        return;
    for (int k = 0; k <= given.dim; k++)
        vertices[k] = paradt_dynamic_point(set, ids[k], NULL);
    use_check_cell(u, vertices, given.dim + 1);
}

static void cells(use *u) {
    paradt_dynamic_info info;
    paradt_dynamic_get_info(set, &info);
    for (size_t c = 0; c < info.cell_end; c++)
        check_set_cell(u, (paradt_index)c);
}

#ifndef PARADT_NO_LOCATOR
static void set_locate(use *u) {
    paradt_location *found = (paradt_location *)use_memory(u->count, sizeof *found);
    use_queries(u, &u->asked);
    use_start(u);
    for (size_t i = 0; i < u->count; i++)
        found[i] = paradt_dynamic_locate(set, use_place(u, i), -1);
    use_stop(u);
    for (size_t i = 0; i < u->count; i++)
        if (found[i].face)
            check_set_cell(u, found[i].cell);
    free(found);
}

static void set_nearest(use *u) {
    paradt_index *found = (paradt_index *)use_memory(u->count, sizeof *found);
    use_queries(u, &u->asked);
    use_start(u);
    for (size_t i = 0; i < u->count; i++)
        found[i] = paradt_dynamic_nearest(set, use_place(u, i), -1);
    use_stop(u);
    for (size_t i = 0; i < u->count; i++) {
        const double *vertices[1] = {paradt_dynamic_point(set, found[i], NULL)};
        use_check_cell(u, vertices, 1);
    }
    free(found);
}
#endif
#endif

#ifndef PARADT_NO_VORONOI
// Volumes, faces with their areas, and neighbours of all cells in the unit cube, with the triangulation
static void voronoi(use *u) {
    static const double box[2 * PARADT_MAX_DIM] = {0, 0, 0, 1, 1, 1}, square[4] = {0, 0, 1, 1};
    paradt_voronoi_request request = {PARADT_VORONOI_VOLUMES | PARADT_VORONOI_FACES | PARADT_VORONOI_AREAS, box, NULL, 0};
    paradt_triangulation t;
    paradt_voronoi v;
    double error = 0;
    if (given.dim == 2)
        request.box = square;
    use_start(u);
    must(paradt_triangulate(&t, &given, NULL), "triangulate");
    must(paradt_voronoi_compute(&v, &t, &given, &request, NULL), "voronoi");
    use_stop(u);
    for (size_t i = 0; i < v.cell_count; i++)
        error = error < v.volume_errors[i] ? v.volume_errors[i] : error;
    fprintf(stderr, "ParaDT: volume 1 %+.3g, %zu faces of cells, error of a volume at most %.3g\n", v.volume - 1,
            v.first_face[v.cell_count], error);
    paradt_voronoi_free(&v);
    paradt_free(&t);
}
#endif

static void build(use *u) {
    given = paradt_points_f64(u->points.coordinates, u->points.count, u->points.dim);
    must(paradt_triangulate(&triangulation, &given, NULL), "triangulate");
#ifndef PARADT_NO_LOCATOR
    must(paradt_locator_create(&locator, &triangulation, &given, NULL), "locator");
#endif
#ifndef PARADT_NO_DYNAMIC
    must(paradt_dynamic_create(&set, &given, NULL), "create");
#endif
}

int main(int argc, char **argv) {
    const use_operation operations[] = {
        {"triangulate", triangulate},
#ifndef PARADT_NO_LOCATOR
        {"locator", make_locator},
        {"locate-sorted", locate_sorted},
        {"locate-batch", locate_batch},
        {"locate-random", locate_random},
        {"nearest-sorted", nearest_sorted},
        {"nearest-batch", nearest_batch},
        {"nearest-random", nearest_random},
#endif
#ifndef PARADT_NO_DYNAMIC
        {"create", create},
        {"insert-sorted", insert_sorted},
        {"insert-batch", insert_batch},
        {"insert-random", insert_random},
        {"remove-random", remove_random},
        {"remove-batch", remove_batch},
        {"move-random", move_random},
        {"move-batch", move_batch},
        {"cells", cells},
#ifndef PARADT_NO_LOCATOR
        {"set-locate", set_locate},
        {"set-nearest", set_nearest},
#endif
#endif
#ifndef PARADT_NO_VORONOI
        {"voronoi", voronoi},
#endif
    };
    return use_main(argc, argv, build, operations, sizeof operations / sizeof *operations);
}
