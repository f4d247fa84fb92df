#include "imu_model.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    SELF_TEST_X_GYRO = 0x00,
    SELF_TEST_X_ACCEL = 0x0D,
    SMPLRT_DIV = 0x19,
    GYRO_CONFIG = 0x1B,
    ACCEL_CONFIG = 0x1C,
    INT_STATUS = 0x3A,
    ACCEL_XOUT_H = 0x3B,
    TEMP_OUT_H = 0x41,
    GYRO_XOUT_H = 0x43,
    GYRO_ZOUT_L = 0x48,
    PWR_MGMT_1 = 0x6B,
    WHO_AM_I = 0x75,
};

#define H_RESET 0x80
#define SLEEP 0x40
#define DATA_READY 0x01
#define FULL_SCALE(config) (((config) >> 3) & 3)
#define START_UP_S 0.1 /* the data sheet's longest, for registers after power-on */
#define INNER_RATE_HZ 1000.0
#define CONFIG_MAX_HZ 1e6 /* serial clock for all registers but sensors and interrupts */
#define SENSOR_MAX_HZ 20e6
#define FLOATING 0xFF
#define GRAVITY 9.80665
#define TEMPERATURE_RAW 3339 /* 31 °C: 333.87 per °C from 21 °C */
#define WARMER_RAW 333.87    /* per °C */

static void reset_registers(imu_model_t *imu)
{
    memset(imu->registers, 0, sizeof imu->registers);
    imu->registers[PWR_MGMT_1] = 0x01;
    imu->registers[WHO_AM_I] = imu->chip;
    for (int axis = 0; axis < 3; axis++) { /* each chip has its own factory codes; one has none */
        imu->registers[SELF_TEST_X_ACCEL + axis] = imu->number ? 80 + 9 * imu->number + axis : 0;
        imu->registers[SELF_TEST_X_GYRO + axis] = imu->number ? 120 + 9 * imu->number + axis : 0;
    }
}

void imu_init(imu_model_t *imu, int number, const motion_t *motion)
{
    *imu = (imu_model_t){.number = number, .motion = motion, .present = true, .chip = 0x71};
    imu->weak_accel = imu->weak_gyro = 1;
    imu_power_on(imu, 0);
}

void imu_power_on(imu_model_t *imu, double t)
{
    reset_registers(imu);
    imu->busy_until = t + START_UP_S;
    imu->sample = -1;
}

static void put_big_endian(uint8_t *at, double raw)
{
    int16_t value = (int16_t)fmax(-32768, fmin(32767, round(raw)));
    at[0] = (uint16_t)value >> 8;
    at[1] = value & 0xFF;
}

/* Response of a driven axis in counts at the smallest full scale. */
static double self_test_response(uint8_t code, double without_code)
{
    return code ? 2620 * pow(1.01, code - 1) : without_code;
}

/* Samples one sensor's three axes: `full_scale` is that of setting 0, in the unit of `felt`. */
static void sample_sensor(imu_model_t *imu, uint8_t config, uint8_t codes, uint8_t out,
                          const double felt[3], double full_scale, double driven, double health)
{
    int setting = FULL_SCALE(imu->registers[config]);
    for (int axis = 0; axis < 3; axis++) {
        double counts = felt[axis] / full_scale * 32768;
        if (imu->registers[config] & (0x80 >> axis))
            counts += health * self_test_response(imu->registers[codes + axis], driven);
        put_big_endian(imu->registers + out + 2 * axis, counts / (1 << setting));
    }
}

static void sample_all(imu_model_t *imu, double t)
{
    double felt[MOTION_AXES];
    motion_at(imu->motion, imu->number, t, felt);
    sample_sensor(imu, ACCEL_CONFIG, SELF_TEST_X_ACCEL, ACCEL_XOUT_H, felt, 2 * GRAVITY,
                  0.45 * 16384, imu->weak_accel);
    sample_sensor(imu, GYRO_CONFIG, SELF_TEST_X_GYRO, GYRO_XOUT_H, felt + 3, 250 * M_PI / 180,
                  100 * 131, imu->weak_gyro);
    put_big_endian(imu->registers + TEMP_OUT_H, TEMPERATURE_RAW + WARMER_RAW * imu->warmer);
    imu->registers[INT_STATUS] |= DATA_READY;
}

/* Inner samples are made when somebody could look at them, with the values of their own instant. */
static void catch_up(imu_model_t *imu, double t)
{
    double rate = INNER_RATE_HZ / (1 + imu->registers[SMPLRT_DIV]);
    int64_t sample = (int64_t)floor(t * rate);
    if (sample == imu->sample || imu->registers[PWR_MGMT_1] & SLEEP)
        return;
    imu->sample = sample;
    sample_all(imu, sample / rate);
}

void imu_select(imu_model_t *imu, double t)
{
    imu->now = t;
    imu->addressed = imu->gave_data = false;
    if (t >= imu->busy_until)
        catch_up(imu, t);
}

static bool is_sensor(uint8_t address)
{
    return address >= INT_STATUS && address <= GYRO_ZOUT_L;
}

static void check_clock(imu_model_t *imu, double hz)
{
    double limit = imu->reading && is_sensor(imu->address) ? SENSOR_MAX_HZ : CONFIG_MAX_HZ;
    if (hz <= limit * 1.001)
        return;
    if (!imu->violations++)
        fprintf(stderr, "IMU %d: %.1f MHz is too fast for register 0x%02X\n", imu->number,
                hz / 1e6, imu->address);
}

static uint8_t read_register(imu_model_t *imu)
{
    uint8_t value = imu->registers[imu->address];
    if (imu->address == INT_STATUS) {
        imu->registers[INT_STATUS] = 0; /* reading it clears it */
        imu->gave_data = true;
    }
    return value;
}

static void write_register(imu_model_t *imu, uint8_t value)
{
    if (imu->address == PWR_MGMT_1 && value & H_RESET)
        imu_power_on(imu, imu->now);
    else if (imu->address != WHO_AM_I && !is_sensor(imu->address))
        imu->registers[imu->address] = value;
}

uint8_t imu_transfer(imu_model_t *imu, uint8_t mosi, double hz)
{
    uint8_t miso = 0;
    if (!imu->present)
        return FLOATING;
    if (imu->now < imu->busy_until)
        return 0;
    if (!imu->addressed) {
        imu->addressed = true;
        imu->reading = mosi & 0x80;
        imu->address = mosi & 0x7F;
        return 0;
    }
    check_clock(imu, hz);
    if (imu->reading)
        miso = read_register(imu);
    else
        write_register(imu, mosi);
    imu->address = (imu->address + 1) & 0x7F;
    return miso;
}
