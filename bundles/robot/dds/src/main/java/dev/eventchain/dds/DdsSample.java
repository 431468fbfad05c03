package dev.eventchain.dds;

/** A received sample. */
public final class DdsSample {

  private final byte[] bytes;
  private final long sourceTimestamp;
  private final long publication;

  DdsSample(byte[] bytes, long sourceTimestamp, long publication) {
    this.bytes = bytes;
    this.sourceTimestamp = sourceTimestamp;
    this.publication = publication;
  }

  /**
   * The message as {@link dev.eventchain.messages.CdrCodec} reads it, header included. Not a copy.
   */
  public byte[] bytes() {
    return bytes;
  }

  /**
   * What the writer stamped it with, in ns: since 1970, unless writer and reader agree on something
   * else.
   */
  public long sourceTimestamp() {
    return sourceTimestamp;
  }

  /** Which of the matched writers it is from: a number of this process. */
  public long publication() {
    return publication;
  }
}
