/**
 * Loudspeaker and microphone. Part of eyebot.h; do not include directly.
 *
 * In virtual time nothing is heard, and a sound takes its length.
 */
#ifndef EYEBRIDGE_CLASSIC_AUDIO_H
#define EYEBRIDGE_CLASSIC_AUDIO_H

/**
 * Begins to play a sample, a WAV, AU or SND file in memory with 8 bits a value. Returns its
 * frequency; 0 for NULL, another format, and where there is no player. (The M6 says how long it is as
 * well, which the sample knows itself.)
 */
int AUPlaySample(void* sample, ...);
/** 1 when no sample is played (any more). */
int AUCheckSample(void);
/** Begins a tone of 65 … 21000 hertz, 1 … 65535 ms; else, and where there is no player, 1. */
int AUTone(int freq, int msec);
/** 1 when no tone is played (any more). */
int AUCheckTone(void);
int AUBeep(void);
/**
 * Begins to record from the microphone: `len` bytes, of which 28 are the header of an AU file.
 * Returns the frequency, 0 for NULL, fewer bytes, and where there is no microphone.
 */
int AURecordSample(void* buf, long len, long freq);
/** 1 when nothing is recorded (any more). */
int AUCheckRecord(void);
/** A value of the microphone, 0 … 1023; -1 where there is none. */
int AUCaptureMic(void);

#endif
