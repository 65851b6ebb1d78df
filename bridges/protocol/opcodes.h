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

/* Written by make_protocol from bridges/protocol/can: do not edit. */
/* clang-format off */

/* Functions: C_ from the host to robots, S_ from a robot to the host. */
#define EYECAN_C_NMT 0x00         /* C_Nmt */
#define EYECAN_C_ESTOP 0x01       /* C_EStop */
#define EYECAN_S_FAULT 0x08       /* S_Fault */
#define EYECAN_S_POSE 0x18        /* S_Pose */
#define EYECAN_S_SPEED 0x19       /* S_Speed */
#define EYECAN_S_ENC12 0x1A       /* S_Enc12 */
#define EYECAN_S_ENC34 0x1B       /* S_Enc34 */
#define EYECAN_S_PSD_A 0x1C       /* S_PsdA */
#define EYECAN_S_PSD_B 0x1D       /* S_PsdB */
#define EYECAN_S_PSD_RAW 0x1E     /* S_PsdRaw */
#define EYECAN_S_DIGITAL 0x1F     /* S_Digital */
#define EYECAN_C_VW_SPEED 0x20    /* C_VWSpeed */
#define EYECAN_C_VW_MOVE 0x21     /* C_VWMove */
#define EYECAN_C_SET_POSE 0x22    /* C_SetPose */
#define EYECAN_C_MOTOR 0x23       /* C_Motor */
#define EYECAN_C_PID 0x24         /* C_Pid */
#define EYECAN_C_SERVO 0x25       /* C_Servo */
#define EYECAN_C_DIGITAL 0x26     /* C_Digital */
#define EYECAN_C_DIGITAL_CFG 0x27 /* C_DigitalCfg */
#define EYECAN_S_ANALOG_A 0x28    /* S_AnalogA */
#define EYECAN_S_ANALOG_B 0x29    /* S_AnalogB */
#define EYECAN_S_STATUS 0x2A      /* S_Status */
#define EYECAN_S_LIDAR_HDR 0x2C   /* S_LidarHdr */
#define EYECAN_S_LIDAR_CHUNK 0x2D /* S_LidarChunk; as a CAN FD frame S_LidarChunkFD */
#define EYECAN_S_ZONES 0x2E       /* S_Zones */
#define EYECAN_S_VERSION 0x48     /* S_Version */
#define EYECAN_HEARTBEAT 0x70     /* Heartbeat */

/* Identifiers and version. */
#define EYECAN_NODE_BITS 4        /* Lowest bits of an identifier: the node */
#define EYECAN_NODE_FIRST 1       /* First robot */
#define EYECAN_NODE_LAST 14       /* Last robot */
#define EYECAN_NODE_HOST 15       /* The host */
#define EYECAN_PROTOCOL_VERSION 1 /* S_Version Protocol */

/* Masks of identifiers. */
#define EYECAN_NODE_MASK 0x00F     /* Identifier & this: the node */
#define EYECAN_FUNCTION_MASK 0x7F0 /* Identifier & this: the function << NODE_BITS */

/* C_Nmt Node; 1 to 14 are robots. */
#define EYECAN_NODE_ALL 0 /* All robots */

/* Functions without a message. */
#define EYECAN_BULK_RESPONSE 0x58 /* Reserved for ISO-TP from the robot; optional, not described here */
#define EYECAN_BULK_REQUEST 0x60  /* Reserved for ISO-TP to the robot; optional, not described here */

/* Unsigned 16-bit values that may be absent. */
#define EYECAN_ABSENT 0xFFFF /* No such sensor or point, or not measured */

/* Ranges of PSDs, LIDAR points and zones, mm. */
#define EYECAN_PSD_OUT_OF_RANGE 9999 /* Nothing within reach */

/* C_Nmt Command. */
#define EYECAN_NMT_ENABLE 0x01  /* Become operational, with speed 0; ends an emergency stop that is over */
#define EYECAN_NMT_STOP 0x02    /* Motors off, state STOPPED */
#define EYECAN_NMT_STANDBY 0x80 /* Motors off, state STANDBY */
#define EYECAN_NMT_RESET 0x81   /* Restart as after power-up: odometry, encoders and parameters are lost */

/* Heartbeat State. */
#define EYECAN_STATE_BOOT 0x00        /* Has just started; the first frame of a robot and no later one */
#define EYECAN_STATE_STOPPED 0x04     /* Motors off after NMT STOP or an emergency stop */
#define EYECAN_STATE_OPERATIONAL 0x05 /* Takes commands that move something; the host always sends this */
#define EYECAN_STATE_STANDBY 0x7F     /* Motors off: not enabled yet, NMT STANDBY, or the host is lost */

/* C_EStop Reason; a robot treats all alike. */
#define EYECAN_ESTOP_USER 1        /* Somebody pressed a button */
#define EYECAN_ESTOP_PROGRAM_END 2 /* The program has ended */
#define EYECAN_ESTOP_HOST_FAULT 3  /* The host found a fault; also sent by the guard of a crashed program */

/* S_Fault Code, in the classes of CANopen. */
#define EYECAN_FAULT_NONE 0x0000              /* No fault any more */
#define EYECAN_FAULT_LOW_BATTERY 0x3120       /* Steady: the supply is below the robot's limit */
#define EYECAN_FAULT_MOTOR_BLOCKED 0x7121     /* Steady: a wheel is held (StallLeft, StallRight) */
#define EYECAN_FAULT_HOST_LOST 0x8130         /* Steady: 300 ms without heartbeat of the host while operational */
#define EYECAN_FAULT_BUS_OFF_RECOVERED 0x8140 /* Event: the robot had left the bus and is back */
#define EYECAN_FAULT_DUPLICATE_NODE 0x8150    /* Steady: another node sends under this one's number */
#define EYECAN_FAULT_FRAME_LENGTH 0x8210      /* Event: a frame was too short; Aux is identifier + length << 16 */
#define EYECAN_FAULT_BAD_VALUE 0x8220         /* Event: a frame had a value that it may not have; Aux is identifier */
#define EYECAN_FAULT_ESTOP 0xFF01             /* Steady: emergency stop */
#define EYECAN_FAULT_COMMAND_TIMEOUT 0xFF02   /* Steady: 250 ms without C_VWSpeed or C_Motor while one drove */

/* S_Fault Register, as in CANopen; bits. */
#define EYECAN_REGISTER_ANY 0x01           /* Any fault */
#define EYECAN_REGISTER_CURRENT 0x02       /* Codes 7xxx */
#define EYECAN_REGISTER_VOLTAGE 0x04       /* Codes 3xxx */
#define EYECAN_REGISTER_COMMUNICATION 0x10 /* All other codes */

/* S_Fault Flags: all steady faults, the most important first; bits. */
#define EYECAN_FLAG_ESTOP 0x01           /* Fault ESTOP is set */
#define EYECAN_FLAG_DUPLICATE_NODE 0x02  /* Fault DUPLICATE_NODE is set */
#define EYECAN_FLAG_HOST_LOST 0x04       /* Fault HOST_LOST is set */
#define EYECAN_FLAG_COMMAND_TIMEOUT 0x08 /* Fault COMMAND_TIMEOUT is set */
#define EYECAN_FLAG_MOTOR_BLOCKED 0x10   /* Fault MOTOR_BLOCKED is set */
#define EYECAN_FLAG_LOW_BATTERY 0x20     /* Fault LOW_BATTERY is set */

/* S_Speed MoveState. */
#define EYECAN_MOVE_IDLE 0    /* Nothing commanded since the start, or motors off or C_Motor while no move was under way */
#define EYECAN_MOVE_SPEED 1   /* The last command was C_VWSpeed, also with speed 0 or after its time-out */
#define EYECAN_MOVE_RUNNING 2 /* The move LastMoveSeq is under way */
#define EYECAN_MOVE_DONE 3    /* The move has ended where it should */
#define EYECAN_MOVE_ABORTED 4 /* The last move was given up: motors off or C_Motor meanwhile, or a wheel was held too long */

/* C_VWMove Type. */
#define EYECAN_VW_STRAIGHT 1 /* Distance counts, Angle is ignored; Speed in mm/s */
#define EYECAN_VW_TURN 2     /* On the spot: Angle counts, Distance is ignored; Speed in deg/s */
#define EYECAN_VW_CURVE 3    /* An arc of length Distance that turns by Angle; Speed in mm/s along it */
#define EYECAN_VW_DRIVE 4    /* As CURVE */

/* C_Motor Mode. */
#define EYECAN_MOTOR_PERCENT 0 /* Duty, -100 to 100 % */
#define EYECAN_MOTOR_TICKS 1   /* Speed control, -128 to 127 encoder ticks per 10 ms */

/* C_DigitalCfg Mode. */
#define EYECAN_PORT_INPUT 0     /* Input without resistor */
#define EYECAN_PORT_OUTPUT 1    /* Output; its level is that of the last C_Digital */
#define EYECAN_PORT_PULL_UP 2   /* Input with resistor to supply */
#define EYECAN_PORT_PULL_DOWN 3 /* Input with resistor to ground */

/* S_Status IrKey; others are codes of keys. */
#define EYECAN_IR_NONE 0 /* No key */

/* S_Version Hardware: for people, a host takes any; 128 to 255 are for your boards. */
#define EYECAN_HARDWARE_UNKNOWN 0   /* Not told */
#define EYECAN_HARDWARE_EYEBOT_IO 1 /* EyeBot I/O board, or firmware-stubs in its place */

/* S_Version Capabilities; other bits are 0; bits. */
#define EYECAN_CAPABLE_OF_MOVES 0x0001 /* Executes C_VWMove by itself */
#define EYECAN_CAPABLE_OF_SCANS 0x0002 /* Sends LIDAR scans: the host waits for the first one when it starts */
#define EYECAN_CAPABLE_OF_ZONES 0x0100 /* Sends readings of range matrix 1, the next bits up to 0x8000: of 2 to 8; as for SCANS */

/* clang-format on */
/* End of what make_protocol writes. */

#endif
