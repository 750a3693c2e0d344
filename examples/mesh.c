// A landscape of float vertices: triangulated where they are, smoothed by their neighbours. Writes mesh.svg.
//
//     cc -O2 -o mesh examples/mesh.c -lm && ./mesh
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { COUNT = 900 };

struct vertex {
    float x, y, z;
    float smooth; // what z becomes
};
static struct vertex vertices[COUNT];

static float chance(void) { return (float)(rand() / (RAND_MAX + 1.0)); }

// The triangles that are seen, from back to front, are sorted by how far back they are.
static float back(const paradt_index *v) { return vertices[v[0]].y + vertices[v[1]].y + vertices[v[2]].y; }
static int by_distance(const void *a, const void *b) {
    float x = back((const paradt_index *)a), y = back((const paradt_index *)b);
    return (x < y) - (x > y);
}

static void draw(FILE *svg, const paradt_index *v) {
    const struct vertex *a = &vertices[v[0]], *b = &vertices[v[1]], *c = &vertices[v[2]];
    float ux = b->x - a->x, uy = b->y - a->y, uz = b->z - a->z, wx = c->x - a->x, wy = c->y - a->y, wz = c->z - a->z;
    float nx = uy * wz - uz * wy, ny = uz * wx - ux * wz, nz = ux * wy - uy * wx;
    float light = (0.6f * nz - 0.7f * nx + 0.4f * ny) / sqrtf(nx * nx + ny * ny + nz * nz);
    fprintf(svg, "<path fill='hsl(90,30%%,%.0f%%)' d='M", 45 + 40 * light);
    for (int j = 0; j < 3; j++)
        fprintf(svg, "%.1f %.1f ", 20 + 360 * vertices[v[j]].x, 280 - 130 * vertices[v[j]].y - 200 * vertices[v[j]].z);
    fprintf(svg, "Z'/>\n");
}

int main(void) {
    paradt_points points = paradt_points_f32(&vertices[0].x, COUNT, 2); // x and y alone: seen from above
    paradt_triangulation t;
    paradt_adjacency near;
    points.stride = sizeof(struct vertex);
    for (int i = 0; i < COUNT; i++) {
        struct vertex *v = &vertices[i];
        v->x = chance();
        v->y = chance();
        v->z = 0.5f * expf(-15 * ((v->x - .6f) * (v->x - .6f) + (v->y - .5f) * (v->y - .5f))) + 0.05f * chance() +
               0.15f * sinf(5 * v->x) * sinf(4 * v->y);
    }
    if (paradt_triangulate(&t, &points, NULL) || paradt_adjacency_compute(&near, &t, PARADT_VERTEX_VERTICES, NULL))
        return 1;
    for (size_t i = 0; i < near.count; i++) { // the mean of the vertex and its neighbours
        vertices[i].smooth = vertices[i].z;
        for (size_t k = near.first[i]; k < near.first[i + 1]; k++)
            vertices[i].smooth += vertices[near.items[k]].z;
        vertices[i].smooth /= (float)(near.first[i + 1] - near.first[i] + 1);
    }
    for (int i = 0; i < COUNT; i++)
        vertices[i].z = vertices[i].smooth;
    printf("%zu triangles, %.2f neighbours a vertex\n", t.cell_count, (double)near.first[COUNT] / COUNT);
    qsort(t.cells, t.cell_count, 3 * sizeof *t.cells, by_distance);
    FILE *svg = fopen("mesh.svg", "w");
    if (!svg)
        return 1;
    fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 300' stroke='#343' stroke-width='.3'>\n");
    for (size_t c = 0; c < t.cell_count; c++)
        draw(svg, t.cells + 3 * c);
    fprintf(svg, "</svg>\n");
    fclose(svg);
    paradt_adjacency_free(&near);
    paradt_free(&t);
    return 0;
}
