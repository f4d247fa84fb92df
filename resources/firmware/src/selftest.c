#include "selftest.h"

#include <avr/wdt.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <util/delay.h>

#include "imus.h"

#define READINGS 64  /* at 1 kHz */
#define SETTLE_MS 25 /* after switching the drive */

/* Limits where the factory burnt in no code: 225..675 mg and 60 °/s, at ±2 g and ±250 °/s. */
#define ACCEL_MIN 3686
#define ACCEL_MAX 11059
#define GYRO_MIN 7860

typedef int16_t averages_t[IMU_COUNT][IMU_AXES];

static void set_all_ranges(uint8_t gyro_config, uint8_t accel_config)
{
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        if (imus_ok() & _BV(i))
            mpu_set_ranges(i, gyro_config, accel_config);
}

static void average_all(averages_t into)
{
    static int32_t sum[IMU_COUNT][IMU_AXES];
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        for (uint8_t axis = 0; axis < IMU_AXES; axis++)
            sum[i][axis] = 0;
    for (uint8_t n = 0; n < READINGS; n++) {
        _delay_ms(1);
        for (uint8_t i = 0; i < IMU_COUNT; i++) {
            imu_reading_t reading;
            mpu_read(i, &reading); /* an old sample read twice does no harm here */
            for (uint8_t axis = 0; axis < IMU_AXES; axis++)
                sum[i][axis] += reading.axis[axis];
        }
    }
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        for (uint8_t axis = 0; axis < IMU_AXES; axis++)
            into[i][axis] = sum[i][axis] / READINGS;
    wdt_reset();
}

static bool accel_passes(uint8_t code, uint16_t response, float factory)
{
    if (code == 0)
        return response >= ACCEL_MIN && response <= ACCEL_MAX;
    return response > 0.5f * factory && response < 1.5f * factory;
}

static bool gyro_passes(uint8_t code, uint16_t response, float factory)
{
    return code == 0 ? response >= GYRO_MIN : response > 0.5f * factory;
}

static uint8_t judge(uint8_t imu, const int16_t rest[], const int16_t driven[])
{
    uint8_t code[IMU_AXES], failed = 0;
    mpu_self_test_codes(imu, code);
    for (uint8_t axis = 0; axis < IMU_AXES; axis++) {
        uint16_t response = labs((int32_t)driven[axis] - rest[axis]);
        float factory = 2620.0f * powf(1.01f, code[axis] - 1); /* eq. of the note, full scale 0 */
        if (axis < 3 && !accel_passes(code[axis], response, factory))
            failed |= SELFTEST_ACCEL;
        if (axis >= 3 && !gyro_passes(code[axis], response, factory))
            failed |= SELFTEST_GYRO;
    }
    return failed;
}

void selftest_run(uint8_t failed[])
{
    static averages_t rest, driven;
    set_all_ranges(MPU_TEST_RANGE, MPU_TEST_RANGE);
    _delay_ms(SETTLE_MS);
    average_all(rest);
    set_all_ranges(MPU_TEST_DRIVE, MPU_TEST_DRIVE);
    _delay_ms(SETTLE_MS);
    average_all(driven);
    set_all_ranges(MPU_WORK_GYRO, MPU_WORK_ACCEL);
    _delay_ms(SETTLE_MS);
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        failed[i] = imus_ok() & _BV(i) ? judge(i, rest[i], driven[i]) : 0;
}
