#include "motion.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GRAVITY 9.80665

struct motion {
    size_t rows, columns;
    double *value; /* row by row; column 0 is the time */
};

static double *row_of(const motion_t *motion, size_t i)
{
    return motion->value + i * motion->columns;
}

/* Parses one line into `row`; false unless it holds exactly `columns` numbers. */
static int parse_row(char *line, double *row, size_t columns)
{
    char *rest = line;
    for (size_t i = 0; i < columns; i++) {
        char *end;
        row[i] = strtod(rest, &end);
        if (end == rest)
            return 0;
        rest = end;
    }
    return rest[strspn(rest, " \t\r\n")] == 0;
}

static int append_line(motion_t *motion, char *line)
{
    motion->value = realloc(motion->value, (motion->rows + 1) * motion->columns * sizeof(double));
    if (!motion->value)
        return 0;
    double *row = row_of(motion, motion->rows);
    if (!parse_row(line, row, motion->columns))
        return 0;
    if (motion->rows && row[0] <= row[-(ptrdiff_t)motion->columns])
        return 0;
    motion->rows++;
    return 1;
}

motion_t *motion_read(const char *path, int imus)
{
    FILE *file = fopen(path, "r");
    if (!file) {
        fprintf(stderr, "%s cannot be read: %s.\n", path, strerror(errno));
        return NULL;
    }
    motion_t *motion = calloc(1, sizeof *motion);
    motion->columns = 1 + (size_t)imus * MOTION_AXES;
    char *line = NULL;
    size_t size = 0;
    int good = 1;
    while (good && getline(&line, &size, file) > 0)
        good = append_line(motion, line);
    fclose(file);
    free(line);
    if (good && motion->rows)
        return motion;
    fprintf(stderr, "%s, line %zu: wanted a later time and %zu numbers.\n", path, motion->rows + 1,
            motion->columns - 1);
    return NULL;
}

/* The last row whose time is not after t; row 0 where there is none. */
static size_t row_before(const motion_t *motion, double t)
{
    size_t low = 0, high = motion->rows;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (row_of(motion, middle)[0] <= t)
            low = middle;
        else
            high = middle;
    }
    return low;
}

void motion_at(const motion_t *motion, int imu, double t, double felt[MOTION_AXES])
{
    if (!motion) {
        memcpy(felt, (double[MOTION_AXES]){0, 0, GRAVITY, 0, 0, 0}, MOTION_AXES * sizeof *felt);
        return;
    }
    size_t i = row_before(motion, t);
    const double *a = row_of(motion, i);
    const double *b = i + 1 < motion->rows ? row_of(motion, i + 1) : a;
    double part = b == a ? 0 : (t - a[0]) / (b[0] - a[0]);
    if (part < 0)
        part = 0;
    for (int axis = 0; axis < MOTION_AXES; axis++) {
        int column = 1 + imu * MOTION_AXES + axis;
        felt[axis] = a[column] + part * (b[column] - a[column]);
    }
}
