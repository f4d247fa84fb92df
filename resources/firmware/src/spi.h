/* The SPI as master, mode 3, with one chip select per IMU. */
#ifndef SPI_H
#define SPI_H

#include <stdint.h>

void spi_init(void);

/* 1 MHz: the most that the MPU-9250 allows for its configuration. */
void spi_slow(void);

/* 4 MHz, for sensor data: the chip would take 20 MHz, wires to the fingertips do not. */
void spi_fast(void);

void spi_select(uint8_t imu);
void spi_release(void);
uint8_t spi_transfer(uint8_t byte);

#endif
