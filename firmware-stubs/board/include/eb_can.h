#ifndef EB_CAN_H
#define EB_CAN_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EB_MAX_SIGNALS 33
#define EB_LIDAR_POINTS 360
#define EB_MATRICES 8
#define EB_ZONES 64
#define EB_ZONES_A_FRAME 3

/* A frame as the controller takes it. */
struct eb_can_frame {
  uint32_t id; /* 11 bits; 29 when extended */
  uint8_t length;
  bool fd;
  bool extended;
  bool remote; /* asks for a frame; has no data */
  uint8_t data[64];
};

/* One number in a frame; they follow each other from bit 0 on, least significant bit first. */
struct eb_signal {
  int8_t bits; /* negative: signed */
  bool absent; /* EYECAN_ABSENT is allowed, too */
  int32_t first, last;
};

/* How a message is laid out. */
struct eb_message {
  uint8_t function; /* EYECAN_... */
  bool fd;
  uint8_t first_node, last_node; /* of its identifier */
  uint8_t length;
  uint8_t count;
  const struct eb_signal* signals;
};

/* Null when there is no such message. */
const struct eb_message* eb_find_message(int function, bool fd);
/* Writes a frame; false when a value or the node is none that the message may have. */
bool eb_can_pack(struct eb_can_frame* frame, int function, bool fd, int node,
                 const int32_t* values);
enum eb_can_unpacked { EB_CAN_GOOD, EB_CAN_SHORT, EB_CAN_BAD_VALUE, EB_CAN_NOT_OURS };
/* Reads a frame's numbers. Bytes after the last number are ignored. */
enum eb_can_unpacked eb_can_unpack(const struct eb_can_frame* frame,
                                   int32_t values[EB_MAX_SIGNALS]);

/* The frames that a robot sends, in order of their identifiers; a node keeps a bit for each. */
enum eb_can_due {
  EB_DUE_FAULT,
  EB_DUE_POSE,
  EB_DUE_SPEED,
  EB_DUE_ENC12,
  EB_DUE_ENC34,
  EB_DUE_PSD_A,
  EB_DUE_PSD_B,
  EB_DUE_PSD_RAW,
  EB_DUE_DIGITAL,
  EB_DUE_ANALOG_A,
  EB_DUE_ANALOG_B,
  EB_DUE_STATUS,
  EB_DUE_LIDAR_HEADER,
  EB_DUE_LIDAR_CHUNK,
  EB_DUE_ZONES,
  EB_DUE_VERSION,
  EB_DUE_HEARTBEAT,
  EB_DUE_COUNT
};

/* A scan on its way. */
struct eb_scan {
  uint16_t points;
  uint16_t range_deg;
  int8_t tilt_deg;
  uint16_t range_mm[EB_LIDAR_POINTS];
};

/* The board's side of the bus. Frames are made when they are sent, so that they are never old. */
struct eb_node {
  uint8_t id; /* 0: not on a bus */
  bool fd;
  uint8_t state; /* EYECAN_STATE_... */
  bool booted;   /* the boot heartbeat went out */
  uint32_t due;  /* bit n: enum eb_can_due */
  uint32_t since_us[EB_DUE_COUNT];
  uint32_t host_us;    /* since the host's heartbeat */
  uint32_t command_us; /* since C_VWSpeed or C_Motor */
  uint32_t estop_us;   /* since C_EStop */
  uint32_t twin_us;    /* since somebody else used our node id */
  bool commanded;      /* a speed or duty is in force that must be repeated */
  bool raw;            /* it is one of C_Motor */
  bool timed_out;
  bool move_known; /* `move_seq` was executed since the last enable */
  uint8_t move_seq;
  uint16_t faults;      /* steady: EYECAN_FLAG_... */
  uint16_t sent_faults; /* as the host knows them */
  uint16_t event_code;  /* momentary, not sent yet; 0 = none */
  uint32_t event_aux;
  bool event_sent; /* the host has seen a momentary fault: say that it is over */
  uint16_t digital_in, digital_out;
  struct eb_scan scan;
  uint8_t scan_id;
  uint16_t scan_time_ms;
  uint16_t next_chunk, chunks;
  /* A reading of a range matrix on its way. */
  uint16_t zones_mm[EB_ZONES];
  uint8_t zones_matrix, zones_reading, zones_chunk;
};

#ifdef __cplusplus
}
#endif

#endif
