package dev.eventchain.messages;

/**
 * Codec for ROS 2 messages on the wire: plain CDR, version 1 (OMG CORBA 3.4 part 2, 9.3; DDS-XTypes
 * 1.3, 7.4.1), after a header of four bytes. Writes little-endian, reads both byte orders.
 */
public final class CdrCodec {

  private CdrCodec() {}

  /**
   * Encodes a message.
   *
   * @return header and payload
   */
  public static byte[] encode(MessageValue message) {
    CdrWriter writer = new CdrWriter();
    writer.write(message);
    return writer.toBytes();
  }

  /**
   * Decodes a message that fills an array.
   *
   * @throws IllegalArgumentException as {@link #decode(MessageType, byte[], int, int)}
   */
  public static MessageValue decode(MessageType type, byte[] bytes) {
    return decode(type, bytes, 0, bytes.length);
  }

  /**
   * Decodes a message in a part of an array.
   *
   * @throws IllegalArgumentException if the bytes are not a message of this type: they end too
   *     early, have another representation, or hold a string that is not UTF-8
   */
  public static MessageValue decode(MessageType type, byte[] bytes, int offset, int length) {
    return new CdrReader(bytes, offset, length).read(type);
  }

  /**
   * Checks that bytes hold a message of this type, followed by at most three bytes of padding. Does
   * not read its values.
   *
   * @throws IllegalArgumentException if they are too short or too long, have another representation
   *     or a Boolean that is neither 0 nor 1
   */
  public static void requireMessage(MessageType type, byte[] bytes) {
    new CdrReader(bytes, 0, bytes.length).requireMessage(type);
  }
}
