package dev.eventchain.messages;

/**
 * Messages on the wire of ROS 2: plain CDR, version 1 (OMG CORBA 3.4 part 2, 9.3; DDS-XTypes 1.3,
 * 7.4.1), after a header of four bytes. Written little-endian, read in both orders.
 */
public final class CdrCodec {

  private CdrCodec() {}

  /**
   * The bytes of a message.
   *
   * @return header and payload
   */
  public static byte[] encode(MessageValue message) {
    CdrWriter writer = new CdrWriter();
    writer.write(message);
    return writer.toBytes();
  }

  /**
   * The message of a whole array.
   *
   * @throws IllegalArgumentException as {@link #decode(MessageType, byte[], int, int)}
   */
  public static MessageValue decode(MessageType type, byte[] bytes) {
    return decode(type, bytes, 0, bytes.length);
  }

  /**
   * The message of a part of an array.
   *
   * @throws IllegalArgumentException if the bytes are not a message of this type: they end too
   *     early, have another representation, or hold a string that is not UTF-8
   */
  public static MessageValue decode(MessageType type, byte[] bytes, int offset, int length) {
    return new CdrReader(bytes, offset, length).read(type);
  }

  /**
   * Makes sure that bytes hold a message of this type and nothing else but up to three bytes of
   * padding, without reading its values.
   *
   * @throws IllegalArgumentException if they end too early or continue after it, have another
   *     representation or a Boolean that is neither 0 nor 1
   */
  public static void requireMessage(MessageType type, byte[] bytes) {
    new CdrReader(bytes, 0, bytes.length).requireMessage(type);
  }
}
