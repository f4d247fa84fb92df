#include "frame.h"

#include <util/crc16.h>

#include "board.h"
#include "uart.h"

#define SEND_MAX (1 + 6 + 12 * IMU_COUNT + 2) /* SAMPLES is the longest: type, payload, CRC */
#define RECEIVE_MAX 16                        /* HAPTIC, the longest, has 8 bytes with COBS */
#define TYPE_AND_CRC 3

_Static_assert(SEND_MAX < 254, "put_cobs writes blocks of less than 254 bytes");

static uint8_t sending[SEND_MAX];
static uint8_t sending_length;
static uint8_t received[RECEIVE_MAX];
static uint8_t received_length; /* RECEIVE_MAX + 1: too long, to be dropped */

void frame_begin(uint8_t type)
{
    sending[0] = type;
    sending_length = 1;
}

void frame_u8(uint8_t value)
{
    sending[sending_length++] = value;
}

void frame_u16(uint16_t value)
{
    frame_u8(value & 0xFF);
    frame_u8(value >> 8);
}

void frame_u32(uint32_t value)
{
    frame_u16(value & 0xFFFF);
    frame_u16(value >> 16);
}

/* CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, no reflection. */
static uint16_t crc16(const uint8_t *data, uint8_t length)
{
    uint16_t crc = 0xFFFF;
    while (length--)
        crc = _crc_xmodem_update(crc, *data++);
    return crc;
}

static void put_cobs(const uint8_t *data, uint8_t length)
{
    uint8_t start = 0;
    while (start <= length) { /* one turn per zero, and one for the end */
        uint8_t end = start;
        while (end < length && data[end])
            end++;
        uart_put(end - start + 1);
        while (start < end)
            uart_put(data[start++]);
        start = end + 1;
    }
    uart_put(0);
}

bool frame_try_send(void)
{
    if (uart_room() < sending_length + 2 + 2) /* CRC; COBS' first byte and the closing zero */
        return false;
    frame_u16(crc16(sending, sending_length));
    put_cobs(sending, sending_length);
    return true;
}

void frame_send(void)
{
    while (!frame_try_send()) {
    }
}

/* Undoes COBS in place; returns the length, or 0 where the codes do not add up. */
static uint8_t uncobs(uint8_t *data, uint8_t length)
{
    uint8_t from = 0, to = 0;
    while (from < length) {
        uint8_t code = data[from++];
        if (code - 1 > length - from)
            return 0;
        for (uint8_t i = 1; i < code; i++)
            data[to++] = data[from++];
        if (from < length)
            data[to++] = 0;
    }
    return to;
}

static int8_t finish_received(uint8_t *type, const uint8_t **payload)
{
    uint8_t length = received_length <= RECEIVE_MAX ? uncobs(received, received_length) : 0;
    received_length = 0;
    if (length < TYPE_AND_CRC)
        return -1;
    uint16_t crc = received[length - 2] | (uint16_t)received[length - 1] << 8;
    if (crc != crc16(received, length - 2))
        return -1;
    *type = received[0];
    *payload = received + 1;
    return length - TYPE_AND_CRC;
}

int8_t frame_receive(uint8_t byte, uint8_t *type, const uint8_t **payload)
{
    if (byte == 0)
        return finish_received(type, payload);
    if (received_length < RECEIVE_MAX)
        received[received_length++] = byte;
    else
        received_length = RECEIVE_MAX + 1;
    return -1;
}
