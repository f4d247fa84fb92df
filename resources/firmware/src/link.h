/* The conversation with the host: what the glove sends and receives (protocol version 1). */
#ifndef LINK_H
#define LINK_H

#include <stdbool.h>
#include <stdint.h>

#include "board.h"
#include "mpu9250.h"

bool link_is_streaming(void);

/* Obeys what the host has sent. */
void link_obey(void);

void link_send_hello(void);
void link_send_status(void);

/* The temperature of every IMU. */
void link_send_temperatures(void);

/* Sends one sample of all IMUs, or counts it as dropped where the port is behind. `skipped` sampling
 * instants before it, which nobody read, are missing numbers too. */
void link_send_samples(uint32_t t_us, uint8_t skipped, const imu_reading_t readings[IMU_COUNT]);

/* A pulse on the synchrony pin. */
void link_send_pulse(uint16_t number, uint32_t t_us);

/* An ERROR of text and the numbers of the IMUs in `imus`; text lies in flash. */
void link_send_error(const char *text, uint16_t imus);

#endif
