package dev.eventchain.simulation.run;

import dev.eventchain.diagnostics.Sha256;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** All messages that the nodes publish in a run, in the order of their publication. */
public final class MessageLog {

  /** Length from which only a hash of a message is kept, in bytes. */
  private static final int LONGEST = 1 << 16;

  private final List<Message> messages = new ArrayList<>();

  /**
   * A published message.
   *
   * @param time when it became visible, in ns
   * @param content its bytes; a hash of them if it is long
   * @param isWhole whether the content is its bytes
   */
  public record Message(long time, String topic, ByteBuffer content, boolean isWhole) {

    /** Returns a copy of the content. */
    public byte[] bytes() {
      byte[] bytes = new byte[content.remaining()];
      content.duplicate().get(bytes);
      return bytes;
    }
  }

  /**
   * The first message in which two runs differ.
   *
   * @param first empty if the first run published nothing more
   * @param second empty if the second run published nothing more
   */
  public record Difference(Optional<Message> first, Optional<Message> second) {}

  void add(long time, String topic, ByteBuffer message) {
    byte[] bytes = new byte[message.remaining()];
    message.duplicate().get(bytes);
    boolean isWhole = bytes.length <= LONGEST;
    byte[] content =
        isWhole ? bytes : new Sha256().add(bytes).hex().getBytes(StandardCharsets.US_ASCII);
    messages.add(new Message(time, topic, ByteBuffer.wrap(content), isWhole));
  }

  /** Returns the first difference from another run; empty if it published the same. */
  public Optional<Difference> differenceFrom(MessageLog other) {
    int common = Math.min(messages.size(), other.messages.size());
    for (int i = 0; i < Math.max(messages.size(), other.messages.size()); i++) {
      if (i >= common || !messages.get(i).equals(other.messages.get(i))) {
        return Optional.of(new Difference(at(i), other.at(i)));
      }
    }
    return Optional.empty();
  }

  private Optional<Message> at(int index) {
    return index < messages.size() ? Optional.of(messages.get(index)) : Optional.empty();
  }
}
