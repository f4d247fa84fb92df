/* Frames of the glove link: COBS( type | payload | crc16 ) 0x00, little-endian. */
#ifndef FRAME_H
#define FRAME_H

#include <stdbool.h>
#include <stdint.h>

/* Starts a frame in the one buffer for sending; frame_u8..u32 append to its payload. */
void frame_begin(uint8_t type);
void frame_u8(uint8_t value);
void frame_u16(uint16_t value);
void frame_u32(uint32_t value);

/* Sends the frame if the port has room for all of it; returns whether it did. */
bool frame_try_send(void);

/* Sends the frame, waiting until there is room. */
void frame_send(void);

/* Takes one received byte. When it completes a frame that is right in every way, returns the length
 * of its payload, puts its type and where its payload lies (valid until the next byte); otherwise
 * -1. */
int8_t frame_receive(uint8_t byte, uint8_t *type, const uint8_t **payload);

#endif
