/** Types and constants of RoBIOS-7. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_ROBIOS_TYPES_H
#define EYEBRIDGE_ROBIOS_TYPES_H

/** A colour, 0xRRGGBB; the upper byte is ignored. */
typedef int COLOR;
typedef unsigned char BYTE;
/** Handle of a timer, from OSAttachTimer(). */
typedef int TIMER;
typedef sem_t SEMA;
typedef struct {
  pthread_t thread;
  int identifier;
} TASK;
typedef char* DeviceSemantics;

/* Camera and image modes: width _X, height _Y, pixels _PIXELS, bytes of a colour image _SIZE. */
#define QQVGA 0
#define QVGA 1
#define VGA 2
#define CAM1MP 3
#define CAMHD 4
#define CAM5MP 5
/** Any other size: not supported by CAMInit(), LCDImageSize() and IPSetSize(), which fail. */
#define CUSTOM 10

#define QQVGA_X 160
#define QQVGA_Y 120
#define QVGA_X 320
#define QVGA_Y 240
#define VGA_X 640
#define VGA_Y 480
#define CAM1MP_X 1296
#define CAM1MP_Y 730
#define CAMHD_X 1920
#define CAMHD_Y 1080
#define CAM5MP_X 2592
#define CAM5MP_Y 1944

#define QQVGA_PIXELS (QQVGA_X * QQVGA_Y)
#define QVGA_PIXELS (QVGA_X * QVGA_Y)
#define VGA_PIXELS (VGA_X * VGA_Y)
#define CAM1MP_PIXELS (CAM1MP_X * CAM1MP_Y)
#define CAMHD_PIXELS (CAMHD_X * CAMHD_Y)
#define CAM5MP_PIXELS (CAM5MP_X * CAM5MP_Y)

#define QQVGA_SIZE (QQVGA_PIXELS * 3)
#define QVGA_SIZE (QVGA_PIXELS * 3)
#define VGA_SIZE (VGA_PIXELS * 3)
#define CAM1MP_SIZE (CAM1MP_PIXELS * 3)
#define CAMHD_SIZE (CAMHD_PIXELS * 3)
#define CAM5MP_SIZE (CAM5MP_PIXELS * 3)

/*
 * Images: R, G, B (or one grey byte) a pixel, row by row, top-left first. Flat arrays, because
 * every function takes BYTE*; an older page shows rows and columns as dimensions of their own.
 */
typedef BYTE QQVGAcol[QQVGA_SIZE];
typedef BYTE QVGAcol[QVGA_SIZE];
typedef BYTE VGAcol[VGA_SIZE];
typedef BYTE CAM1MPcol[CAM1MP_SIZE];
typedef BYTE CAMHDcol[CAMHD_SIZE];
typedef BYTE CAM5MPcol[CAM5MP_SIZE];
typedef BYTE QQVGAgray[QQVGA_PIXELS];
typedef BYTE QVGAgray[QVGA_PIXELS];
typedef BYTE VGAgray[VGA_PIXELS];
typedef BYTE CAM1MPgray[CAM1MP_PIXELS];
typedef BYTE CAMHDgray[CAMHD_PIXELS];
typedef BYTE CAM5MPgray[CAM5MP_PIXELS];

#define CAM_SUCCESS 0
#define CAM_FAILURE 1

/* Colours. CYAN and OLIVE are not the HTML ones, on purpose. */
#define RED 0xFF0000
#define GREEN 0x00FF00
#define BLUE 0x0000FF
#define WHITE 0xFFFFFF
#define GRAY 0x808080
#define BLACK 0x000000
#define SILVER 0xC0C0C0
#define LIGHTGRAY 0xD3D3D3
#define DARKGRAY 0xA9A9A9
#define NAVY 0x000080
#define CYAN 0x00EEEE
#define TEAL 0x008080
#define MAGENTA 0xFF00FF
#define PURPLE 0x800080
#define MAROON 0x800000
#define YELLOW 0xFFFF00
#define OLIVE 0x9ACD32
#define ORANGE 0xFFA500

/* Keys, as bits of a mask. */
#define NOKEY 0
#define KEY1 1
#define KEY2 2
#define KEY3 4
#define KEY4 8
#define ANYKEY 0xFFFFFFFF

/* Keys of list menus and touch maps: accepted by old programs, never reported. */
#define KEY_LIST1 0x00000010
#define KEY_LIST2 0x00000020
#define KEY_LIST3 0x00000040
#define KEY_LIST4 0x00000080
#define KEY_LIST5 0x00000100
#define KEY_LIST6 0x00000200
#define KEY_LIST7 0x00000400
#define KEY_LIST8 0x00000800
#define KEY_LISTDN 0x10000000
#define KEY_LISTUP 0x20000000
#define KEY_LISTTL 0x40000000
#define KEY_ESCAPE 0x80000000
#define KEY_INVALID 0xFFFFFFFF
#define KEY_GOIDLE 1
#define KEY_NOIDLE 0
#define KEY_STATE (-1)
#define KEYTM_UNKNOWN 0
#define KEYTM_CLASSIC 1
#define KEYTM_STANDARD 2
#define KEYTM_REGIONS 3
#define KEYTM_LISTMENU 4
#define KEYTM_MAX_REGIONS 32

/* Fonts and their variations. */
#define HELVETICA 0
#define TIMES 1
#define COURIER 2
#define NORMAL 0
#define BOLD 1
#define ITALICS 2

/* Flags of text colours (their numbers overlap those of LCDSetMode; no function takes them). */
#define LCD_BGCOL_TRANSPARENT 0x01
#define LCD_BGCOL_NOTRANSPARENT 0x10
#define LCD_BGCOL_INVERSE 0x02
#define LCD_BGCOL_NOINVERSE 0x20
#define LCD_FGCOL_INVERSE 0x04
#define LCD_FGCOL_NOINVERSE 0x40

/* Flags of LCDSetMode(): the second of each pair switches off what the first switches on. */
#define LCD_AUTOREFRESH 0x0001
#define LCD_NOAUTOREFRESH 0x0100
#define LCD_SCROLLING 0x0002
#define LCD_NOSCROLLING 0x0200
#define LCD_LINEFEED 0x0004
#define LCD_NOLINEFEED 0x0400
#define LCD_SHOWMENU 0x0008
#define LCD_HIDEMENU 0x0800
#define LCD_LISTMENU 0x0010
#define LCD_CLASSICMENU 0x1000
#define LCD_FB_ROTATE 0x0080
#define LCD_FB_NOROTATION 0x8000

/** Bytes of one soft-key label, with its closing zero. */
#define LCD_MENU_STRLENGTH 32
#define LCD_LIST_STRLENGTH 64
/** Height of the menu strip in pixels. */
#define MENU_HEIGHT 38

/*
 * PSD numbers of the current robots. Programs before 2018 took 1 for left and 2 for front; compile
 * those with -DEYEBOT_PSD_2015, and run them with --psd-numbers 2015, or with a robot file that has
 * these numbers. There is no PSD_DOWN: programs define their own.
 */
#ifdef EYEBOT_PSD_2015
#define PSD_LEFT 1
#define PSD_FRONT 2
#endif
#ifndef PSD_FRONT
#define PSD_FRONT 1
#endif
#ifndef PSD_LEFT
#define PSD_LEFT 2
#endif
#ifndef PSD_RIGHT
#define PSD_RIGHT 3
#endif
#ifndef PSD_BACK
#define PSD_BACK 4
#endif

/* What OSMachineType() returns. */
#define VEHICLE 1
#define PLATFORM 2
#define WALKER 3

#define IOBOARD 1
#define VERSION "1.0"
#define LIBM6OS_VERSION "1.0"
#define MACHINE_SPEED 700000000
#define MACHINE_TYPE VEHICLE
#define MACHINE_NAME "EyeBot"
#define MACHINE_ID 1
#define HDT_FILE "/home/pi/eyebot/bin/hdt.txt"

/* From X11, which the published header includes; the same values, so X11 may follow. */
#ifndef True
#define True 1
#endif
#ifndef False
#define False 0
#endif

#endif
