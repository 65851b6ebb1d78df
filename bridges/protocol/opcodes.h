#ifndef EYEBRIDGE_OPCODES_H
#define EYEBRIDGE_OPCODES_H

/* The numbers that the bridge (C++) and the board firmware (C99) share, and nothing else: each side
 * has its own codec. What they mean byte by byte is in SPECIFICATION.md. */

/* ---- IO7: one letter per request ---- */

/* Documented on the IO7 command page. */
#define IO7_HELP 'h'           /* text list of commands */
#define IO7_OUTPUT 'O'         /* verbose 0..1 */
#define IO7_DEMO 'E'           /* drives the robot along a path: never sent */
#define IO7_MOTOR 'm'          /* motor, duty in percent */
#define IO7_MOTOR_SPEED 'M'    /* motor, ticks per 10 ms; switches the PID on */
#define IO7_PID 'd'            /* motor, p, i, d */
#define IO7_SERVO 's'          /* servo, position */
#define IO7_SERVO_LIMITS 'S'   /* servo, lower, upper in units of 10 us */
#define IO7_PSD 'p'            /* sensor -> raw ADC value */
#define IO7_ENCODER 'e'        /* encoder -> 16-bit counter */
#define IO7_VERSION 'v'        /* -> 4 characters */
#define IO7_VOLTAGE 'V'        /* -> supply in units of 10 mV */
#define IO7_DIGITAL_IN 'i'     /* port -> 0 or 1 */
#define IO7_DIGITAL_IN_ALL 'I' /* -> 16 bits, port 15 first */
#define IO7_DIGITAL_OUT 'o'    /* port, bit */
#define IO7_PORT_CONFIG 'c'    /* port, one of IO7_PORT_... */
#define IO7_ANALOG 'a'         /* port -> raw ADC value */

/* Not on the readable part of the page: by analogy, used only when asked for (SPECIFICATION.md). */
#define IO7_VW_SET_SPEED 'x' /* v mm/s, w deg/s */
#define IO7_VW_GET_SPEED 'X' /* -> v mm/s, w deg/s */
#define IO7_VW_GET_POSE 'q'  /* -> x mm, y mm, phi deg */
#define IO7_VW_SET_POSE 'Q'  /* x mm, y mm, phi deg */
#define IO7_VW_STRAIGHT 'y'  /* speed mm/s, distance mm */
#define IO7_VW_TURN 'Y'      /* speed deg/s, angle deg */
#define IO7_VW_CURVE 'C'     /* distance mm, angle deg, speed mm/s */
#define IO7_VW_REMAINING 'z' /* -> mm */
#define IO7_VW_DONE 'Z'      /* -> 0 under way, 1 done, -1 given up */

/* First and last of each argument. */
#define IO7_MOTOR_FIRST 1
#define IO7_MOTOR_LAST 4
#define IO7_DUTY_FIRST (-100)
#define IO7_DUTY_LAST 100
#define IO7_TICKS_FIRST (-128)
#define IO7_TICKS_LAST 127
#define IO7_GAIN_FIRST 0
#define IO7_GAIN_LAST 255
#define IO7_SERVO_FIRST 1
#define IO7_SERVO_LAST 14
#define IO7_SERVO_POSITION_FIRST 0
#define IO7_SERVO_POSITION_LAST 255
#define IO7_SERVO_LIMIT_FIRST 0
#define IO7_SERVO_LIMIT_LAST 255
#define IO7_PSD_FIRST 1
#define IO7_PSD_LAST 6
#define IO7_ENCODER_FIRST 1
#define IO7_ENCODER_LAST 4
#define IO7_PORT_FIRST 0
#define IO7_PORT_LAST 15
#define IO7_ANALOG_FIRST 0
#define IO7_ANALOG_LAST 8
#define IO7_WORD_FIRST (-32768)
#define IO7_WORD_LAST 32767
#define IO7_PORT_INPUT 'i'
#define IO7_PORT_OUTPUT 'o'
#define IO7_PORT_PULL_UP 'I'
#define IO7_PORT_PULL_DOWN 'J'

/* Ranges of what is answered. */
#define IO7_ADC_LAST 4095
#define IO7_VOLTAGE_LAST 2000
#define IO7_COUNTER_LAST 65535
#define IO7_VERSION_LENGTH 4

/* ---- CAN: 11-bit identifier = function << 4 | node ---- */

#define EYECAN_NODE_BITS 4
#define EYECAN_NODE_MASK 0x00F
#define EYECAN_FUNCTION_MASK 0x7F0
#define EYECAN_NODE_ALL 0
#define EYECAN_NODE_FIRST 1
#define EYECAN_NODE_LAST 14
#define EYECAN_NODE_HOST 15

/* Functions. C_ goes from the host to robots, S_ from a robot to the host. */
#define EYECAN_C_NMT 0x00
#define EYECAN_C_ESTOP 0x01
#define EYECAN_S_FAULT 0x08
#define EYECAN_S_POSE 0x18
#define EYECAN_S_SPEED 0x19
#define EYECAN_S_ENC12 0x1A
#define EYECAN_S_ENC34 0x1B
#define EYECAN_S_PSD_A 0x1C
#define EYECAN_S_PSD_B 0x1D
#define EYECAN_S_PSD_RAW 0x1E
#define EYECAN_S_DIGITAL 0x1F
#define EYECAN_C_VW_SPEED 0x20
#define EYECAN_C_VW_MOVE 0x21
#define EYECAN_C_SET_POSE 0x22
#define EYECAN_C_MOTOR 0x23
#define EYECAN_C_PID 0x24
#define EYECAN_C_SERVO 0x25
#define EYECAN_C_DIGITAL 0x26
#define EYECAN_C_DIGITAL_CFG 0x27
#define EYECAN_S_ANALOG_A 0x28
#define EYECAN_S_ANALOG_B 0x29
#define EYECAN_S_STATUS 0x2A
#define EYECAN_S_LIDAR_HDR 0x2C
#define EYECAN_S_LIDAR_CHUNK 0x2D /* as a CAN FD frame: S_LidarChunkFD */
#define EYECAN_S_VERSION 0x48
#define EYECAN_BULK_RESPONSE 0x58 /* ISO-TP, optional */
#define EYECAN_BULK_REQUEST 0x60  /* ISO-TP, optional */
#define EYECAN_HEARTBEAT 0x70

/* S_Version.protocol */
#define EYECAN_PROTOCOL_VERSION 1
/* S_Version.capabilities */
#define EYECAN_CAPABLE_OF_MOVES 0x0001
#define EYECAN_CAPABLE_OF_SCANS 0x0002

/* C_Nmt.command */
#define EYECAN_NMT_ENABLE 0x01
#define EYECAN_NMT_STOP 0x02
#define EYECAN_NMT_STANDBY 0x80
#define EYECAN_NMT_RESET 0x81

/* Heartbeat.state */
#define EYECAN_STATE_BOOT 0x00
#define EYECAN_STATE_STOPPED 0x04
#define EYECAN_STATE_OPERATIONAL 0x05
#define EYECAN_STATE_STANDBY 0x7F

/* C_EStop.reason */
#define EYECAN_ESTOP_USER 1
#define EYECAN_ESTOP_PROGRAM_END 2
#define EYECAN_ESTOP_HOST_FAULT 3

/* S_Fault.code, in the classes of CANopen's emergency codes */
#define EYECAN_FAULT_NONE 0x0000
#define EYECAN_FAULT_LOW_BATTERY 0x3120
#define EYECAN_FAULT_MOTOR_BLOCKED 0x7121
#define EYECAN_FAULT_HOST_LOST 0x8130
#define EYECAN_FAULT_BUS_OFF_RECOVERED 0x8140
#define EYECAN_FAULT_DUPLICATE_NODE 0x8150 /* another node sends under this one's number */
#define EYECAN_FAULT_FRAME_LENGTH 0x8210
#define EYECAN_FAULT_BAD_VALUE 0x8220
#define EYECAN_FAULT_ESTOP 0xFF01
#define EYECAN_FAULT_COMMAND_TIMEOUT 0xFF02

/* S_Speed.move_state */
#define EYECAN_MOVE_IDLE 0
#define EYECAN_MOVE_SPEED 1
#define EYECAN_MOVE_RUNNING 2
#define EYECAN_MOVE_DONE 3
#define EYECAN_MOVE_ABORTED 4

/* C_VWMove.type */
#define EYECAN_VW_STRAIGHT 1
#define EYECAN_VW_TURN 2
#define EYECAN_VW_CURVE 3
#define EYECAN_VW_DRIVE 4

/* C_Motor.mode */
#define EYECAN_MOTOR_PERCENT 0
#define EYECAN_MOTOR_TICKS 1

/* C_DigitalCfg.mode */
#define EYECAN_PORT_INPUT 0
#define EYECAN_PORT_OUTPUT 1
#define EYECAN_PORT_PULL_UP 2
#define EYECAN_PORT_PULL_DOWN 3

/* Values that are not there, or out of reach. */
#define EYECAN_ABSENT 0xFFFF
#define EYECAN_PSD_OUT_OF_RANGE 9999

#endif
