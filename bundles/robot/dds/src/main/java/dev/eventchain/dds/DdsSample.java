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
   * Returns the serialized message with its header, as {@link dev.eventchain.messages.CdrCodec}
   * reads it. Not a copy.
   */
  public byte[] bytes() {
    return bytes;
  }

  /**
   * Returns the source timestamp in ns: since 1970, unless writer and reader agree on another
   * epoch.
   */
  public long sourceTimestamp() {
    return sourceTimestamp;
  }

  /** Returns the number, within this process, of the matched writer that sent the sample. */
  public long publication() {
    return publication;
  }
}
