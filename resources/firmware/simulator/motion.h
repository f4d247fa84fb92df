/* What the simulated IMUs feel: read from a file, straight lines between its rows. */
#ifndef MOTION_H
#define MOTION_H

#include <stddef.h>

#define MOTION_AXES 6

typedef struct motion motion_t;

/* Reads rows of `t` (s) and, per IMU, ax ay az (m/s²) gx gy gz (rad/s), separated by blanks; times
 * rise. NULL, with a sentence on standard error, where the file is not like that. */
motion_t *motion_read(const char *path, int imus);

/* Puts what `imu` feels at t (s); the ends are held. At rest, z upwards, where motion is NULL. */
void motion_at(const motion_t *motion, int imu, double t, double felt[MOTION_AXES]);

#endif
