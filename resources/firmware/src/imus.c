#include "imus.h"

#include <avr/wdt.h>
#include <stdbool.h>
#include <util/delay.h>

#include "selftest.h"

#define RESET_MS 100
#define GYRO_START_MS 35

static uint16_t ok;
static uint16_t passed; /* the self-test, since the start */
static bool judged;
static uint8_t id[IMU_COUNT], selftest[IMU_COUNT];
static int16_t temperature[IMU_COUNT]; /* raw, of the last reading */

void imus_start(void)
{
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        mpu_reset(i);
    _delay_ms(RESET_MS);
    wdt_reset();
    ok = passed = 0;
    judged = false;
    imus_revive();
    _delay_ms(GYRO_START_MS);
}

uint16_t imus_ok(void)
{
    return ok;
}

uint8_t imus_id(uint8_t imu)
{
    return id[imu];
}

uint8_t imus_selftest(uint8_t imu)
{
    return selftest[imu];
}

uint16_t imus_judge(const uint8_t failed[])
{
    uint16_t refused = 0;
    judged = true;
    for (uint8_t i = 0; i < IMU_COUNT; i++) {
        bool tested = ok & _BV(i);
        selftest[i] = tested ? failed[i] : SELFTEST_ABSENT;
        if (tested && !failed[i])
            passed |= _BV(i);
        else if (tested && !mpu_is_known(id[i]))
            refused |= _BV(i);
    }
    ok &= ~refused;
    return refused;
}

static void set_no_reading(imu_reading_t *reading)
{
    for (uint8_t i = 0; i < IMU_AXES; i++)
        reading->axis[i] = IMU_NO_READING;
}

uint16_t imus_read(imu_reading_t readings[IMU_COUNT])
{
    uint16_t before = ok;
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        if ((ok & _BV(i)) && !mpu_read(i, &readings[i]))
            ok &= ~_BV(i);
    /* The settings come after the data, so that no reading taken with others gets past. */
    for (uint8_t i = 0; i < IMU_COUNT; i++) {
        if ((ok & _BV(i)) && !mpu_is_configured(i))
            ok &= ~_BV(i);
        if (ok & _BV(i))
            temperature[i] = readings[i].temperature;
        else
            set_no_reading(&readings[i]);
    }
    return before & ~ok;
}

int16_t imus_temperature_of_cC(uint8_t imu)
{
    return ok & _BV(imu) ? mpu_temperature_cC(temperature[imu]) : IMU_NO_READING;
}

int16_t imus_temperature_cC(void)
{
    uint8_t first = 0;
    while (first < IMU_COUNT - 1 && !(ok & _BV(first)))
        first++;
    return mpu_temperature_cC(temperature[first]);
}

/* A chip of unknown id needs the self-test, which has no time while samples are sent. */
static bool may_start(uint8_t imu)
{
    uint8_t found = mpu_id(imu);
    if (found == MPU_NO_CHIP)
        return false;
    id[imu] = found;
    return !judged || mpu_is_known(found) || passed & _BV(imu);
}

void imus_revive(void)
{
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        if (!(ok & _BV(i)) && may_start(i) && mpu_start(i))
            ok |= _BV(i);
}
