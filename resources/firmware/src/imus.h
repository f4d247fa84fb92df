/* The glove's IMUs as a set: started, tested, read, and brought back when they return. */
#ifndef IMUS_H
#define IMUS_H

#include <stdint.h>

#include "board.h"
#include "mpu9250.h"

/* What an IMU that does not answer reads: no chip gives it on all six axes. */
#define IMU_NO_READING INT16_MIN

/* Resets and starts all; takes about 0.15 s. */
void imus_start(void);

/* Bit j is set where IMU j answers and is used. */
uint16_t imus_ok(void);

/* WHO_AM_I of an IMU when it was started last, MPU_NO_CHIP if none has answered. */
uint8_t imus_id(uint8_t imu);

/* Takes the results of the self-test (see selftest_run). A chip of unknown id that failed is not
 * used from then on; returns the bits of these. Until its test has passed, such a chip is used only
 * between imus_start and this call. */
uint16_t imus_judge(const uint8_t failed[]);

/* Flags of the last self-test of an IMU; SELFTEST_ABSENT if it did not answer then. */
uint8_t imus_selftest(uint8_t imu);

/* Reads all into `readings`, IMU_NO_READING for those that do not answer or have lost their settings.
 * Returns the bits of the IMUs that have just stopped answering. */
uint16_t imus_read(imu_reading_t readings[IMU_COUNT]);

/* Hundredths of a degree Celsius in the first IMU that answers, as of the last imus_read. */
int16_t imus_temperature_cC(void);

/* The same of one IMU; IMU_NO_READING where it does not answer. */
int16_t imus_temperature_of_cC(uint8_t imu);

/* Tries to start again those that do not answer; takes under 1.5 ms. */
void imus_revive(void);

#endif
