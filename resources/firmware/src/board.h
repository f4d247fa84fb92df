/* What is soldered where. ATmega328P at 16 MHz; the wiring table is in ../README.md. */
#ifndef BOARD_H
#define BOARD_H

#include <avr/io.h>

#define IMU_COUNT 7
#define HAPTIC_CHANNELS 3

/* Chip selects, active low: IMU 0..5 on PC0..PC5, IMU 6 on PB2. PB2 is SS, which has to be an
 * output anyway: as an input pulled low it would throw the SPI out of master mode. */
#define SELECT_C_MASK 0x3F
#define SELECT_B_MASK _BV(PB2)

#define SPI_OUTPUTS (_BV(PB3) | _BV(PB5)) /* MOSI, SCK; MISO is PB4 */

/* Motors: channel 0 on PD6 (OC0A), 1 on PD5 (OC0B), 2 on PD3 (OC2B). */
#define HAPTIC_OUTPUTS (_BV(PD6) | _BV(PD5) | _BV(PD3))

/* Pulses of other devices: PD2 (INT0). */
#define SYNC_PIN _BV(PD2)

/* Battery through 300 kΩ over 100 kΩ to ADC7, measured against the inner 1.1 V. */
#define BATTERY_MUX 7
#define BATTERY_FULL_SCALE_MV 4400UL

#endif
