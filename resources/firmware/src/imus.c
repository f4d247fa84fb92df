#include "imus.h"

#include <avr/wdt.h>
#include <util/delay.h>

#define RESET_MS 100
#define GYRO_START_MS 35

static uint16_t ok;
static int16_t temperature; /* raw */

void imus_start(void)
{
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        mpu_reset(i);
    _delay_ms(RESET_MS);
    wdt_reset();
    ok = 0;
    imus_revive();
    _delay_ms(GYRO_START_MS);
}

uint16_t imus_ok(void)
{
    return ok;
}

static void set_no_reading(imu_reading_t *reading)
{
    for (uint8_t i = 0; i < IMU_AXES; i++)
        reading->axis[i] = IMU_NO_READING;
}

static void note_temperature(const imu_reading_t readings[IMU_COUNT])
{
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        if (ok & _BV(i)) {
            temperature = readings[i].temperature;
            return;
        }
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
        if (!(ok & _BV(i)))
            set_no_reading(&readings[i]);
    }
    note_temperature(readings);
    return before & ~ok;
}

int16_t imus_temperature_cC(void)
{
    return mpu_temperature_cC(temperature);
}

void imus_revive(void)
{
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        if (!(ok & _BV(i)) && mpu_start(i))
            ok |= _BV(i);
}
