#include "mpu9250.h"

#include "spi.h"

enum {
    SELF_TEST_X_GYRO = 0x00,
    SELF_TEST_X_ACCEL = 0x0D,
    SMPLRT_DIV = 0x19,
    CONFIG = 0x1A,
    GYRO_CONFIG = 0x1B,
    ACCEL_CONFIG = 0x1C,
    ACCEL_CONFIG2 = 0x1D,
    INT_STATUS = 0x3A, /* the sensor data follow it */
    USER_CTRL = 0x6A,
    PWR_MGMT_1 = 0x6B,
    WHO_AM_I = 0x75,
};

#define READ 0x80
#define FLOATING 0xFF /* what a bus without a chip reads, or 0x00 */
#define MPU6500_ID 0x70
#define MPU9250_ID 0x71
#define MPU9255_ID 0x73
#define LOW_PASS_92_HZ 2
#define H_RESET 0x80
#define CLOCK_FROM_GYRO 0x01
#define NO_I2C 0x10
#define DATA_READY 0x01

static void write_register(uint8_t imu, uint8_t address, uint8_t value)
{
    spi_select(imu);
    spi_transfer(address);
    spi_transfer(value);
    spi_release();
}

static void read_registers(uint8_t imu, uint8_t address, uint8_t *into, uint8_t count)
{
    spi_select(imu);
    spi_transfer(READ | address);
    while (count--)
        *into++ = spi_transfer(0);
    spi_release();
}

void mpu_reset(uint8_t imu)
{
    write_register(imu, PWR_MGMT_1, H_RESET);
}

void mpu_set_ranges(uint8_t imu, uint8_t gyro_config, uint8_t accel_config)
{
    write_register(imu, GYRO_CONFIG, gyro_config);
    write_register(imu, ACCEL_CONFIG, accel_config);
}

uint8_t mpu_id(uint8_t imu)
{
    uint8_t id;
    read_registers(imu, WHO_AM_I, &id, 1);
    return id == FLOATING ? MPU_NO_CHIP : id;
}

bool mpu_is_known(uint8_t id)
{
    return id == MPU6500_ID || id == MPU9250_ID || id == MPU9255_ID;
}

bool mpu_start(uint8_t imu)
{
    write_register(imu, PWR_MGMT_1, CLOCK_FROM_GYRO);
    write_register(imu, USER_CTRL, NO_I2C); /* noise on the clock must not look like I²C */
    write_register(imu, SMPLRT_DIV, 0);
    write_register(imu, CONFIG, LOW_PASS_92_HZ);
    write_register(imu, ACCEL_CONFIG2, LOW_PASS_92_HZ);
    mpu_set_ranges(imu, MPU_WORK_GYRO, MPU_WORK_ACCEL);
    return mpu_is_configured(imu);
}

bool mpu_is_configured(uint8_t imu)
{
    uint8_t value[4];
    read_registers(imu, CONFIG, value, sizeof value);
    return value[0] == LOW_PASS_92_HZ && value[1] == MPU_WORK_GYRO &&
           value[2] == MPU_WORK_ACCEL && value[3] == LOW_PASS_92_HZ;
}

void mpu_self_test_codes(uint8_t imu, uint8_t code[IMU_AXES])
{
    read_registers(imu, SELF_TEST_X_ACCEL, code, 3);
    read_registers(imu, SELF_TEST_X_GYRO, code + 3, 3);
}

static int16_t big_endian(const uint8_t *bytes)
{
    return (int16_t)((uint16_t)bytes[0] << 8 | bytes[1]);
}

bool mpu_read(uint8_t imu, imu_reading_t *reading)
{
    uint8_t raw[15]; /* status, acceleration, temperature, rotation rate */
    spi_fast();
    read_registers(imu, INT_STATUS, raw, sizeof raw);
    spi_slow();
    for (uint8_t i = 0; i < 3; i++) {
        reading->axis[i] = big_endian(raw + 1 + 2 * i);
        reading->axis[3 + i] = big_endian(raw + 9 + 2 * i);
    }
    reading->temperature = big_endian(raw + 7);
    /* A bus without a chip reads 0x00 or 0xFF, a chip at rest 0x00. */
    return raw[0] == DATA_READY;
}

int16_t mpu_temperature_cC(int16_t raw)
{
    return (int16_t)(raw * 10000L / 33387) + 2100; /* 333.87 per °C, 0 at 21 °C */
}
