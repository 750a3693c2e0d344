// Voronoi and power cells in a box, beside those of Voro++: volumes, surfaces, centroids, and which faces there are. Voro++ works
// in floating point with tolerances, so faces as small as rounding errors are left out.
#include "harness.h"

#include "voro.h"

// Families without points that coincide, and without long thin cells, whose volumes Voro++ misses
static const char *const names[] = {"uniform", "gauss", "sphere", "clusters", "plummer", "lattice", "fcc", "lattice surface",
                                    "lattice off by ulps", "cospherical", "cube surface"};

// The box of the points, and some space around it
static double box_of(const sample *s, double *box) {
    double size = 0;
    for (int k = 0; k < 3; k++) {
        box[k] = box[3 + k] = s->x[k];
        FOR_EACH_POINT(s, x) {
            box[k] = fmin(box[k], x[k]);
            box[3 + k] = fmax(box[3 + k], x[k]);
        }
        size = fmax(size, box[3 + k] - box[k]);
    }
    for (int k = 0; k < 3; k++) {
        box[k] -= 0.1 * size;
        box[3 + k] += 0.1 * size;
    }
    return 1.2 * size;
}

static void compare(const sample *s, const paradt_voronoi *v, const voro_cell *due, double size, double least) {
    for (int i = 0; i < s->count; i++) {
        const double volume = size * size * size, area = size * size;
        double surface = 0, neighbors = 0;
        int faces = 0;
        for (size_t k = v->first_face[i]; k < v->first_face[i + 1]; k++) {
            const paradt_index *sides = v->sides + 2 * v->faces[k], other = sides[sides[0] == i];
            surface += v->areas[v->faces[k]];
            if (v->areas[v->faces[k]] > least) {
                faces++;
                neighbors += other < 0 ? 0 : 1 + (double)other;
            }
        }
        if (fabs(v->volumes[i] - due[i].volume) > 1e-11 * volume)
            fail_on_sample(s, "a volume is not Voro++'s");
        if (fabs(surface - due[i].area) > 1e-9 * area)
            fail_on_sample(s, "a surface is not Voro++'s");
        if (faces != due[i].faces || neighbors != due[i].neighbors)
            fail_on_sample(s, "the faces are not Voro++'s");
        for (int k = 0; k < 3 && v->volumes[i] > 1e-6 * volume; k++)
            if (fabs(v->centroids[3 * i + k] - due[i].centroid[k]) > 1e-9 * size)
                fail_on_sample(s, "a centroid is not Voro++'s");
    }
}

// state: weighting
static void cells_equal_voros(void **state) {
    const weighting *w = &weightings[(intptr_t)*state];
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        const family *f = &families[family_named(names[n])];
        sample s = family_make(f, w, 3, f->at_most && f->at_most < 2000 ? f->at_most : 2000, 11 + n);
        voro_cell *due = (voro_cell *)malloc((size_t)s.count * sizeof *due);
        paradt_points points = points_of(&s);
        paradt_triangulation t;
        paradt_voronoi v;
        double box[6], size = box_of(&s, box), least = 1e-10 * size * size;
        paradt_voronoi_request request = {PARADT_VORONOI_VOLUMES | PARADT_VORONOI_CENTROIDS | PARADT_VORONOI_FACES |
                                              PARADT_VORONOI_AREAS, box, NULL, 0};
        watch(&s, 60);
        for (int i = 0; s.w && i < s.count; i++) // Voro++ has radii
            s.w[i] = fabs(s.w[i]);
        assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
        assert_int_equal(paradt_voronoi_compute(&v, &t, &points, &request, NULL), PARADT_OK);
        voro_cells(s.x, s.w, (size_t)s.count, box, least, due);
        compare(&s, &v, due, size, least);
        watch(NULL, 0);
        paradt_voronoi_free(&v);
        paradt_free(&t);
        free(due);
        sample_free(&s);
    }
}

int main(void) {
    static struct CMUnitTest tests[2];
    tests[0] = named_test(cells_equal_voros, (void *)(intptr_t)0, "cells_equal_voros");
    tests[1] = named_test(cells_equal_voros, (void *)(intptr_t)1, "power_cells_equal_voros");
    return run_named_tests("equals_voro", tests, 2);
}
