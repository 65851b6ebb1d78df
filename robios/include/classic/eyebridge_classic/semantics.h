/**
 * Numbers of devices. Part of eyebot.h; do not include directly.
 *
 * Known from published files are only PSD_FRONT, PSD_LEFT, PSD_RIGHT and BUMP_RIGHT; the others are
 * our choice, negative and blocked by family. A robot's file (.robi, eyesim.p) may give any number
 * to its sensors, and XXXInit() looks for the name that belongs to a number first, then for the number itself.
 */
#ifndef EYEBRIDGE_CLASSIC_SEMANTICS_H
#define EYEBRIDGE_CLASSIC_SEMANTICS_H

#define UNKNOWN_SEMANTICS 0

#define MOTOR_LEFT (-100)
#define MOTOR_RIGHT (-101)

#define PSD_FRONT (-200)
#define PSD_FRONTLEFT (-201)
#define PSD_FRONTRIGHT (-202)
#define PSD_FRONT_HIGH (-203)
#define PSD_FRONT_LOW (-204)
#define PSD_LEFT (-205)
#define PSD_LEFTFRONT (-206)
#define PSD_LEFTBACK (-207)
#define PSD_RIGHT (-210)
#define PSD_RIGHTFRONT (-211)
#define PSD_RIGHTBACK (-212)
#define PSD_BACK (-215)
#define PSD_BACKLEFT (-216)
#define PSD_BACKRIGHT (-217)

#define QUAD_LEFT (-300)
#define QUAD_RIGHT (-301)

/* Left, right, front, back; of a side the front, the middle, the back. */
#define IR_F (-400)
#define IR_LF (-401)
#define IR_LM (-402)
#define IR_LB (-403)
#define IR_B (-404)
#define IR_RF (-405)
#define IR_RM (-406)
#define IR_RB (-407)

#define BUMP_RIGHT (-500)
#define BUMP_LEFT (-501)
#define BUMP_FRONT (-502)
#define BUMP_BACK (-503)

#define SERVO1 (-601)
#define SERVO2 (-602)
#define SERVO3 (-603)
#define SERVO4 (-604)
#define SERVO5 (-605)
#define SERVO6 (-606)
#define SERVO7 (-607)
#define SERVO8 (-608)
#define SERVO9 (-609)
#define SERVO10 (-610)
#define SERVO11 (-611)
#define SERVO12 (-612)
#define SERVO13 (-613)
#define SERVO14 (-614)
#define SERVO15 (-615)
#define SERVO16 (-616)

/* Programs say either: the ROM's demos VW, most others VW_DRIVE. */
#define VW (-700)
#define VW_DRIVE (-700)

#define COMPASS (-800)
#define IRTV (-900)

#endif
