// A block breaks where it is hit: the Voronoi cells of points around the blow, clipped to the block, are closed convex
// pieces that fit together exactly. Writes fracture.obj, an object a piece, and fracture.svg, the pieces pulled apart.
//
//     cc -O2 -o fracture examples/fracture.c -lm && ./fracture
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { PIECES = 60 };

static double sites[PIECES][3];
static double chance(void) { return rand() / (RAND_MAX + 1.0); }

// Voronoi cells do not hide each other in a circle: those with farther sites are behind.
static double depth(size_t site) { return sites[site][0] * 0.6 - sites[site][1] * 0.7 + sites[site][2] * 0.4; }
static int by_depth(const void *a, const void *b) {
    double x = depth(*(const size_t *)a), y = depth(*(const size_t *)b);
    return (x > y) - (x < y);
}

// Writes one face of a piece. The face looks away from its first side, so it is turned for a piece on the second.
static void put_face(const paradt_voronoi *v, size_t face, size_t piece, FILE *obj, FILE *svg) {
    const size_t first = v->first_vertex[face], n = v->first_vertex[face + 1] - first;
    const int turned = v->sides[2 * face] != (paradt_index)piece;
    const double *normal = v->normals + 3 * face, way = turned ? -1 : 1;
    const double towards = way * (normal[0] * 0.6 - normal[1] * 0.7 + normal[2] * 0.4);
    fprintf(obj, "f");
    if (towards > 0)
        fprintf(svg, "<path fill='hsl(30,20%%,%.0f%%)' d='M", 30 + 55 * fabs(0.3 * normal[0] + 0.9 * normal[2]));
    for (size_t i = 0; i < n; i++) {
        const size_t vertex = (size_t)v->polygons[turned ? first + n - 1 - i : first + i];
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = v->vertices[3 * vertex + (size_t)k] + 0.3 * (sites[piece][k] - 0.5);
        fprintf(obj, " %zu", vertex + 1);
        if (towards > 0)
            fprintf(svg, "%.1f %.1f ", 150 * (0.75 * x[0] + 0.65 * x[1]) + 80,
                    330 - 150 * (x[2] * 0.91 - 0.27 * x[0] + 0.31 * x[1]));
    }
    fprintf(obj, "\n");
    if (towards > 0)
        fprintf(svg, "Z'/>\n");
}

int main(void) {
    static const double box[6] = {0, 0, 0, 1, 1, 1}, blow[3] = {0.9, 0.1, 0.9};
    const paradt_points points = paradt_points_f64(sites[0], PIECES, 3);
    const paradt_voronoi_request want = {PARADT_VORONOI_VOLUMES | PARADT_VORONOI_AREAS | PARADT_VORONOI_POLYGONS, box,
                                         NULL, 0};
    paradt_triangulation t;
    paradt_voronoi v;
    size_t order[PIECES];
    FILE *obj = fopen("fracture.obj", "w"), *svg = fopen("fracture.svg", "w");
    for (size_t i = 0; i < PIECES; i++) { // the denser, the nearer to the blow
        double near = pow(chance(), 2);
        order[i] = i;
        for (int k = 0; k < 3; k++)
            sites[i][k] = near * chance() + (1 - near) * (0.7 * blow[k] + 0.3 * chance());
    }
    if (!obj || !svg || paradt_triangulate(&t, &points, NULL) || paradt_voronoi_compute(&v, &t, &points, &want, NULL))
        return 1;
    fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 400' stroke='#432' stroke-width='.5'>\n");
    for (size_t i = 0; i < v.vertex_count; i++)
        fprintf(obj, "v %.17g %.17g %.17g\n", v.vertices[3 * i], v.vertices[3 * i + 1], v.vertices[3 * i + 2]);
    qsort(order, PIECES, sizeof *order, by_depth);
    for (size_t i = 0; i < PIECES; i++) {
        fprintf(obj, "o piece_%zu\n", order[i]);
        for (size_t k = v.first_face[order[i]]; k < v.first_face[order[i] + 1]; k++)
            put_face(&v, (size_t)v.faces[k], order[i], obj, svg);
    }
    fprintf(svg, "</svg>\n");
    printf("%d pieces, volume %.12f\n", PIECES, v.volume);
    fclose(obj);
    fclose(svg);
    paradt_voronoi_free(&v);
    paradt_free(&t);
    return 0;
}
