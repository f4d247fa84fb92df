#include "link.h"

#include <avr/pgmspace.h>

#include "battery.h"
#include "clock.h"
#include "frame.h"
#include "haptic.h"
#include "imus.h"
#include "uart.h"

#define PROTOCOL 1
#define FIRMWARE_MAJOR 1
#define FIRMWARE_MINOR 3
#define FIRMWARE_PATCH 0

#ifndef GLOVE_ID
#define GLOVE_ID 1
#endif

/* What this image is. A host that writes it finds the place by the eight letters, tells the version
   and says which glove the number belongs to. */
static const struct {
    char magic[8];
    uint8_t version[3];
    uint8_t protocol;
    uint32_t glove_id;
} about PROGMEM __attribute__((used)) = {
    {'G', 'L', 'O', 'V', 'E', 'I', 'M', 'G'},
    {FIRMWARE_MAJOR, FIRMWARE_MINOR, FIRMWARE_PATCH},
    PROTOCOL,
    GLOVE_ID,
};

enum { HELLO = 0x01, SAMPLES = 0x02, STATUS = 0x03, ERROR = 0x04, PULSE = 0x05, TEMPERATURES = 0x06 };
enum { ASK_HELLO = 0x81, START = 0x82, STOP = 0x83, RATE = 0x84, HAPTIC = 0x85 };

static bool streaming;
static uint16_t seq;
static uint16_t dropped;

bool link_is_streaming(void)
{
    return streaming;
}

void link_send_hello(void)
{
    frame_begin(HELLO);
    frame_u8(PROTOCOL);
    frame_u8(FIRMWARE_MAJOR);
    frame_u8(FIRMWARE_MINOR);
    frame_u8(FIRMWARE_PATCH);
    frame_u32(pgm_read_dword(&about.glove_id));
    frame_u8(IMU_COUNT);
    frame_u16(GYRO_RANGE_DPS);
    frame_u8(ACCEL_RANGE_G);
    frame_u16(clock_rate());
    frame_u8(HAPTIC_CHANNELS);
    for (uint8_t i = 0; i < IMU_COUNT; i++) {
        frame_u8(imus_id(i));
        frame_u8(imus_selftest(i));
    }
    frame_send();
}

void link_send_temperatures(void)
{
    frame_begin(TEMPERATURES);
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        frame_u16(imus_temperature_of_cC(i));
    frame_send();
}

void link_send_status(void)
{
    frame_begin(STATUS);
    frame_u16(battery_mV());
    frame_u16(imus_temperature_cC());
    frame_u16(imus_ok());
    frame_u16(dropped);
    frame_send();
}

void link_send_samples(uint32_t t_us, uint8_t skipped, const imu_reading_t readings[IMU_COUNT])
{
    seq += skipped;
    dropped += skipped;
    frame_begin(SAMPLES);
    frame_u16(seq++);
    frame_u32(t_us);
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        for (uint8_t axis = 0; axis < IMU_AXES; axis++)
            frame_u16(readings[i].axis[axis]);
    if (!frame_try_send())
        dropped++;
}

void link_send_pulse(uint16_t number, uint32_t t_us)
{
    frame_begin(PULSE);
    frame_u16(number);
    frame_u32(t_us);
    frame_send();
}

static void append_text(const char *text)
{
    for (char c; (c = pgm_read_byte(text)); text++)
        frame_u8(c);
}

void link_send_error(const char *text, uint16_t imus)
{
    frame_begin(ERROR);
    append_text(text);
    for (uint8_t i = 0; i < IMU_COUNT; i++)
        if (imus & _BV(i)) {
            frame_u8(' ');
            frame_u8('0' + i);
        }
    frame_send();
}

static void set_rate(uint16_t rate_hz)
{
    if (rate_hz != 50 && rate_hz != 100 && rate_hz != 200)
        link_send_error(PSTR("rate must be 50, 100 or 200 Hz"), 0);
    else if (rate_hz == 200 && BAUD < 250000UL)
        link_send_error(PSTR("200 Hz needs 250000 baud"), 0);
    else
        clock_set_rate(rate_hz);
}

/* STATUS goes first, so that the host knows from the first packet on which IMUs to believe. */
static void start_streaming(void)
{
    streaming = true;
    link_send_status();
}

static uint16_t u16_at(const uint8_t *bytes)
{
    return bytes[0] | (uint16_t)bytes[1] << 8;
}

/* A command of the wrong length is dropped, as one with a wrong checksum is. */
static void obey(uint8_t type, const uint8_t *payload, int8_t length)
{
    if (type == ASK_HELLO && length == 0)
        link_send_hello();
    else if (type == START && length == 0)
        start_streaming();
    else if (type == STOP && length == 0)
        streaming = false;
    else if (type == RATE && length == 2)
        set_rate(u16_at(payload));
    else if (type == HAPTIC && length == 4)
        haptic_start(payload[0], payload[1], u16_at(payload + 2), clock_us());
}

void link_obey(void)
{
    uint8_t byte, type;
    const uint8_t *payload;
    while (uart_get(&byte)) {
        int8_t length = frame_receive(byte, &type, &payload);
        if (length >= 0)
            obey(type, payload, length);
    }
}
