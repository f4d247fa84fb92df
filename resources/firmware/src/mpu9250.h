/* One MPU-9250, or a chip with the same registers, behind a chip select (register map
 * RM-MPU-9250A-00, revision 1.6). No magnetometer is used. */
#ifndef MPU9250_H
#define MPU9250_H

#include <stdbool.h>
#include <stdint.h>

#define GYRO_RANGE_DPS 2000
#define ACCEL_RANGE_G 16
#define IMU_AXES 6

/* Raw readings: ax, ay, az, gx, gy, gz, as the wire has them. */
typedef struct {
    int16_t axis[IMU_AXES];
    int16_t temperature; /* raw */
} imu_reading_t;

/* Settings of ranges and self-test, for mpu_set_ranges. */
#define MPU_WORK_GYRO 0x18  /* ±2000 °/s */
#define MPU_WORK_ACCEL 0x18 /* ±16 g */
#define MPU_TEST_RANGE 0x00 /* ±250 °/s, ±2 g */
#define MPU_TEST_DRIVE 0xE0 /* the same with all three axes driven */

/* Returns the chip to its power-on state; it needs 100 ms for that. */
void mpu_reset(uint8_t imu);

/* WHO_AM_I of the chip; MPU_NO_CHIP if none answers. */
#define MPU_NO_CHIP 0
uint8_t mpu_id(uint8_t imu);

/* Whether an id is that of an MPU-6500, 9250 or 9255. Other ids are clones and relatives. */
bool mpu_is_known(uint8_t id);

/* Wakes and configures the chip: 1 kHz, 92 Hz low-pass, working ranges. False if it does not keep
 * these settings. */
bool mpu_start(uint8_t imu);

/* Whether the chip still has the settings of mpu_start: a chip whose supply failed for an instant
 * answers with others, and its numbers mean something else. */
bool mpu_is_configured(uint8_t imu);

void mpu_set_ranges(uint8_t imu, uint8_t gyro_config, uint8_t accel_config);

/* Factory self-test codes: accelerometer x, y, z, gyroscope x, y, z. */
void mpu_self_test_codes(uint8_t imu, uint8_t code[IMU_AXES]);

/* Reads the newest sample. False where no chip answers or it has no new one. */
bool mpu_read(uint8_t imu, imu_reading_t *reading);

/* Hundredths of a degree Celsius of a raw temperature. */
int16_t mpu_temperature_cC(int16_t raw);

#endif
