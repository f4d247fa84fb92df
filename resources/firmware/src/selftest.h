/* The factory self-test of all IMUs at once. */
#ifndef SELFTEST_H
#define SELFTEST_H

#include <stdint.h>

#define SELFTEST_ACCEL 0x01
#define SELFTEST_GYRO 0x02
#define SELFTEST_ABSENT 0x80 /* it did not answer, and was not tested */

/* Drives the sensing masses of every IMU that answers and compares the response with what the
 * factory burnt in (AN-MPU-9250A-03). Puts into `failed`, per IMU, SELFTEST_ACCEL and SELFTEST_GYRO.
 * Takes about 0.2 s, during which the hand should rest; leaves the working ranges set. */
void selftest_run(uint8_t failed[]);

#endif
