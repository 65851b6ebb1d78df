/** LCD, KEY: the panel. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_ROBIOS_LCD_H
#define EYEBRIDGE_ROBIOS_LCD_H

/* Kept from the published header: set while the panel is in use, size and place of images. */
extern int LCD_INITIAL;
extern int IM_TYPE, IM_LEFT, IM_TOP, IM_WIDTH, IM_LENGTH;

/**
 * Prints like printf() at the cursor, in the current font and colours, over an opaque background;
 * the cursor moves on. '\n' starts the next row, a full row continues in the next one, and at the
 * bottom the text scrolls up (UNCERTAIN in RoBIOS; switch off with LCD_NOSCROLLING). UTF-8 and
 * Latin-1. Always 0. Not marked as a printf function, so that formats in variables do not warn.
 */
int LCDPrintf(const char* format, ...);
/**
 * Moves the cursor, then prints as LCDPrintf(). Rows and columns are character cells from 0 at the
 * top left, as programs use them (one manual says pixels). What lies outside is cut off.
 */
int LCDSetPrintf(int row, int column, const char* format, ...);
/** Blanks the screen to black, cursor to 0, 0, white text on black. The menu stays. */
int LCDClear(void);
/** Moves the text cursor; cells, as in LCDSetPrintf(). */
int LCDSetPos(int row, int column);
/** Reads the text cursor; cells. Fails on a null pointer. */
int LCDGetPos(int* row, int* column);
/** Colours of the text printed from now on. */
int LCDSetColor(COLOR fg, COLOR bg);
/** HELVETICA, TIMES or COURIER in NORMAL, BOLD or ITALICS; 1 for any other value. */
int LCDSetFont(int font, int variation);
/** 8, 10, 12 (default), 14, 18 or 24 pixels; the cells change with it. 1 for any other size. */
int LCDSetFontSize(int fontsize);
/**
 * Switches by flags; a flag not given stays as it is. Visible: AUTOREFRESH, SCROLLING, LINEFEED
 * (rows that are full continue in the next), SHOWMENU/HIDEMENU. The others are accepted and do
 * nothing. At the start: AUTOREFRESH, SCROLLING and LINEFEED on, no menu.
 */
int LCDSetMode(int mode);
/**
 * Labels the four soft keys, left to right, and shows them: black on red, green, yellow, blue. At
 * most 31 bytes each; '\n' separates lines; "" leaves the key blank, but it still works.
 */
int LCDMenu(const char* st1, const char* st2, const char* st3, const char* st4);
/**
 * One label in its own colours. pos is 1..4; a program that ever passes 0 is taken to count 0..3
 * from then on (both are met), until it calls LCDMenu(). 1 for any other position.
 */
int LCDMenuI(int pos, const char* string, COLOR fg, COLOR bg);
/** Width and height in pixels (560 and 400 unless configured). Fails on a null pointer. */
int LCDGetSize(int* x, int* y);
/** One pixel; origin top-left, y down. Outside the screen nothing is drawn, here and below. */
int LCDPixel(int x, int y, COLOR col);
/** The colour shown at a pixel; 0 outside the screen. */
COLOR LCDGetPixel(int x, int y);
/** A straight line; both ends are drawn. */
int LCDLine(int x1, int y1, int x2, int y2, COLOR col);
/**
 * Rectangle with the corners (x1,y1) and (x2,y2), filled when fill is not 0. Both corners belong to
 * it (UNCERTAIN: older libraries leave out the right and bottom edge); they may be swapped.
 */
int LCDArea(int x1, int y1, int x2, int y2, COLOR col, int fill);
/** Circle around (x1,y1); size is the radius, 0 draws one pixel. 1 for a negative size. */
int LCDCircle(int x1, int y1, int size, COLOR col, int fill);
/*
 * Of older libraries; in no current manual, but in the published library: every colour there
 * becomes its opposite. Both ends and corners belong to it. (LCDList and its list menus are not
 * there: only the library of 2013 had them.)
 */
/** Inverts one pixel. */
int LCDPixelInvert(int x, int y);
/** Inverts a straight line. */
int LCDLineInvert(int x1, int y1, int x2, int y2);
/** Inverts a filled rectangle. */
int LCDAreaInvert(int x1, int y1, int x2, int y2);
/** Mode (QQVGA …) of the images that follow, placed at 0, 0. QVGA at the start, then CAMInit()'s.
 */
int LCDImageSize(int t);
/**
 * Place and size in pixels of the images that follow, until LCDImageSize(). Must be the image's
 * real size. 1 for a size outside 1..4096. A later CAMInit() does not change it.
 */
int LCDImageStart(int x, int y, int xs, int ys);
/** Shows a colour image, 3 bytes a pixel. Fails on a null pointer, as the next two. */
int LCDImage(BYTE* img);
/** Shows a grey image: 0 black … 255 white. */
int LCDImageGray(BYTE* g);
/** Shows one byte a pixel: 0 white, all else black (as on EyeSim; the ESP32 port does the
 * opposite). */
int LCDImageBinary(BYTE* b);
/** Shows what was drawn since LCD_NOAUTOREFRESH; otherwise nothing to do. */
int LCDRefresh(void);

/**
 * Waits for a key and returns KEY1..KEY4. A press that no call has reported yet counts. When no key
 * can ever come (key script used up, no terminal, no window) the program ends with a message.
 */
int KEYGet(void);
/** The oldest press that no call has reported yet, or NOKEY: each press is reported once. */
int KEYRead(void);
/** Waits until one of the keys in the mask is pressed and returns it; other presses are dropped. */
int KEYWait(int key);
/** Waits for a touch anywhere: LCD pixel coordinates. 0. Ends the program as KEYGet() does. */
int KEYGetXY(int* x, int* y);
/** 0 and its place when there was a touch since the last call, else 1 and *x, *y unchanged. */
int KEYReadXY(int* x, int* y);

/** From X11: nothing to do here, returns 1. */
int XInitThreads(void);

#endif
