/* The SPI between the simulated ATmega328P and the IMUs: chip selects and true timing. */
#ifndef SPI_BUS_H
#define SPI_BUS_H

#include <simavr/sim_avr.h>

#include "imu_model.h"

#define BUS_IMUS 7

typedef struct {
    avr_t *avr;
    imu_model_t imu[BUS_IMUS];
    unsigned selected; /* bit per IMU */
    uint8_t sent, received;
    unsigned conflicts;          /* transfers with two chips selected at once */
    avr_cycle_count_t first;     /* when IMU 0 began to give its sample; 0: it did not */
    avr_cycle_count_t round_max; /* longest time from that to the end of the last IMU's sample */
} spi_bus_t;

void bus_attach(spi_bus_t *bus, avr_t *avr, const motion_t *motion);

/* Simulated time, s. */
double bus_time(const avr_t *avr);

#endif
