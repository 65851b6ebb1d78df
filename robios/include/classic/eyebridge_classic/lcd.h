/**
 * Screen and keys. Part of eyebot.h; do not include directly.
 *
 * The screen has 128 x 64 pixels, (0, 0) top-left, one bit each: 7 rows of 16 characters (rows 0 to
 * 6, columns 0 to 15), and an eighth row for the labels of the four keys below it. Rows come before
 * columns, but LCDLine() and LCDArea() take x before y.
 */
#ifndef EYEBRIDGE_CLASSIC_LCD_H
#define EYEBRIDGE_CLASSIC_LCD_H

/**
 * printf() at the cursor. A line that is full goes on in the next row; '\a' beeps. The robot has
 * fewer conversions than printf; here there are all. 1 for NULL.
 */
int LCDPrintf(const char* format, ...) __attribute__((format(printf, 1, 2)));
/** The same at a row and column; 1 when there is no such place (as all that take one). */
int LCDSetPrintf(int row, int column, const char* format, ...)
    __attribute__((format(printf, 3, 4)));
/** Clears the screen, the labels of the keys too; the cursor goes to 0, 0. */
int LCDClear(void);
/** One character at the cursor. */
int LCDPutChar(char c);
/** One character at a place; the cursor stays behind it, as after every LCDSet… */
int LCDSetChar(int row, int column, char c);
/** Text at the cursor; '\n' begins a new row. */
int LCDPutString(const char* s);
int LCDSetString(int row, int column, const char* s);
/** A number in hexadecimal digits, as many as it needs. */
int LCDPutHex(int val);
/** The lowest byte of a number in two hexadecimal digits. */
int LCDPutHex1(int val);
int LCDPutInt(int val);
/** Right-aligned in at least `spaces` columns. */
int LCDPutIntS(int val, int spaces);
/** With six decimals, as "%f" (our choice). */
int LCDPutFloat(float val);
/** Right-aligned in at least `spaces` columns, with 0 … 9 `decimals`. */
int LCDPutFloatS(float val, int spaces, int decimals);
/**
 * SCROLLING (at first): when the screen is full its rows move up; NONSCROLLING: text goes on at the
 * top. CURSOR: the cursor is shown; NOCURSOR (at first). The two are OR-ed.
 */
int LCDMode(int mode);
int LCDSetPos(int row, int column);
/** 1 for NULL. */
int LCDGetPos(int* row, int* column);
/**
 * Shows the middle of a grey image, its pixels 1, 1 to 54, 80, at the top left, dithered to black
 * and white; the row of labels stays. 1 for NULL.
 */
int LCDPutGraphic(image* buf);
/** The same for a colour image. (On the robot the image may be lost; here it is not.) */
int LCDPutColorGraphic(colimage* buf);
/**
 * The whole screen from 1024 bytes, rows of 16 from the top, the highest bit left, 1 is black. (The
 * form is our choice: no manual has it.)
 */
int LCDPutImage(BYTE* buf);
/** Labels of the four keys, 4 characters each; "" (or NULL) leaves a label, " " clears it. */
int LCDMenu(const char* s1, const char* s2, const char* s3, const char* s4);
/** One label, `pos` 1 … 4, else 1. */
int LCDMenuI(int pos, const char* string);
/** 0 clears, 1 sets, 2 inverts; 1 for a pixel that is not there. */
int LCDSetPixel(int row, int col, int val);
int LCDInvertPixel(int row, int col);
/** 0 clear, 1 set; -1 for a pixel that is not there. */
int LCDGetPixel(int row, int col);
/** A line, `col` as LCDSetPixel(); what lies outside is cut off. */
int LCDLine(int x1, int y1, int x2, int y2, int col);
/** A filled rectangle, both corners included; 1 unless x1 <= x2 and y1 <= y2. */
int LCDArea(int x1, int y1, int x2, int y2, int col);

/* Keys: KEY1 … KEY4. A press is reported once. */

/** Waits for a key and stores its code. 1 for NULL. */
int KEYGetBuf(char* buf);
/** Waits for a key and returns its code. Ends the program when no key can come any more. */
int KEYGet(void);
/** The oldest press that was not reported yet, or 0. Does not wait. */
int KEYRead(void);
/** Waits for a key of the mask `excode` and returns its code. */
int KEYWait(int excode);

#endif
