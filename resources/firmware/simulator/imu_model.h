/* A simulated MPU-9250 as its SPI pins show it (register map RM-MPU-9250A-00). */
#ifndef IMU_MODEL_H
#define IMU_MODEL_H

#include <stdbool.h>
#include <stdint.h>

#include "motion.h"

typedef struct {
    int number;
    const motion_t *motion;
    bool present;         /* false: nothing drives MISO */
    double weak_accel;    /* share of the factory's self-test response; 1 is healthy */
    double weak_gyro;
    uint8_t chip;         /* what WHO_AM_I reads */
    double warmer;        /* than 31 °C */
    unsigned violations;  /* of the data sheet's rules, by the master */

    uint8_t registers[128];
    double busy_until;    /* s; deaf until then after a reset or power-on */
    double now;           /* s; start of the transaction under way */
    int64_t sample;       /* number of the last internal sample */
    uint8_t address;      /* next one of the transaction */
    bool reading, addressed;
    bool gave_data;       /* the transaction has read a sample */
} imu_model_t;

void imu_init(imu_model_t *imu, int number, const motion_t *motion);

/* Power off and on again at t: all settings are lost. */
void imu_power_on(imu_model_t *imu, double t);

/* The chip select falls at t (s). */
void imu_select(imu_model_t *imu, double t);

/* One byte, both ways, at a clock of `hz`. */
uint8_t imu_transfer(imu_model_t *imu, uint8_t mosi, double hz);

#endif
