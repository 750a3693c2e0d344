// Points that come, go and move, with their triangulation at any time. Writes dynamic.svg: red is what the last point made.
//
//     cc -O2 -o dynamic examples/dynamic.c -lm && ./dynamic
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <stdio.h>
#include <stdlib.h>

static double chance(void) { return rand() / (RAND_MAX + 1.0); }

static void must(paradt_status status) {
    if (status != PARADT_OK) {
        fprintf(stderr, "%s\n", paradt_status_string(status));
        exit(1);
    }
}

static void draw(const paradt_dynamic *set) {
    paradt_dynamic_info info;
    paradt_dynamic_update last;
    FILE *svg = fopen("dynamic.svg", "w");
    if (!svg)
        exit(1);
    paradt_dynamic_get_info(set, &info);
    paradt_dynamic_get_update(set, &last);
    fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 400' stroke='#456'>\n");
    for (size_t c = 0; c < info.cell_end; c++) { // some numbers below the end are of no cell
        paradt_index v[3];
        int made = 0;
        if (!paradt_dynamic_cell(set, (paradt_index)c, v, NULL))
            continue;
        for (size_t i = 0; i < last.made_count; i++)
            made |= last.made[i] == (paradt_index)c;
        fprintf(svg, "<path fill='%s' d='M", made ? "#e65" : "#dec");
        for (int j = 0; j < 3; j++) {
            const double *x = paradt_dynamic_point(set, v[j], NULL);
            fprintf(svg, "%.1f %.1f ", 400 * x[0], 400 * x[1]);
        }
        fprintf(svg, "Z'/>\n");
    }
    fprintf(svg, "</svg>\n");
    fclose(svg);
}

int main(void) {
    const paradt_points none = paradt_points_f64(NULL, 0, 2);
    paradt_dynamic *set;
    paradt_dynamic_info info;
    paradt_index ids[300];
    must(paradt_dynamic_create(&set, &none, NULL));
    for (int i = 0; i < 300; i++) { // come; the point before is no hint here, as it may be anywhere
        const double x[2] = {chance(), chance()};
        must(paradt_dynamic_insert(set, x, 0, -1, &ids[i]));
    }
    for (int i = 0; i < 100; i++) // go
        must(paradt_dynamic_remove(set, ids[i]));
    for (int i = 100; i < 300; i++) { // move a little
        const double *at = paradt_dynamic_point(set, ids[i], NULL);
        const double x[2] = {at[0] + 0.01 * chance(), at[1] + 0.01 * chance()};
        must(paradt_dynamic_move(set, ids[i], x, 0));
    }
    const double middle[2] = {0.5, 0.5};
    must(paradt_dynamic_insert(set, middle, 0, -1, NULL));
    paradt_dynamic_get_info(set, &info);
    printf("%zu points, %zu triangles\n", info.point_count, info.cell_count);
    draw(set);
    paradt_dynamic_free(set);
    return 0;
}
