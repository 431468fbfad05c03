package dev.eventchain.dds;

import com.sun.jna.Pointer;

/**
 * The functions of libddsc that are called for each sample, bound directly; see {@link Cyclone}.
 */
final class Samples {

  private Samples() {}

  static native int waitsetWait(int waitset, Pointer tags, long count, long timeout);

  static native Pointer ddsiSerdataFromSerIov(
      Pointer type, int kind, long count, Pointer vector, long size);

  static native int ddsiSerdataSize(Pointer data);

  static native void ddsiSerdataToSer(Pointer data, long offset, long size, Pointer target);

  static native void ddsiSerdataUnref(Pointer data);

  /** Writes data with the current time. Takes ownership of the data. */
  static native int writecdr(int writer, Pointer data);

  /** Writes data with their own timestamp. Takes ownership of the data. */
  static native int forwardcdr(int writer, Pointer data);

  static native int takecdr(int reader, Pointer data, int count, Pointer information, int mask);
}
