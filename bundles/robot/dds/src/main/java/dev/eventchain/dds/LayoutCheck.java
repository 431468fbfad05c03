package dev.eventchain.dds;

import com.sun.jna.Pointer;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;

/**
 * Checks that the library has the memory layout that this bundle assumes: sends a message of nested
 * types, with a given timestamp, to this process itself.
 */
final class LayoutCheck {

  /** Only within this process: other processes may use this domain. */
  private static final int DOMAIN = 0;

  private static final String ALONE =
      "<CycloneDDS><Domain id=\"any\"><General><Interfaces>"
          + "<NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/></Interfaces>"
          + "<AllowMulticast>false</AllowMulticast></General><Discovery>"
          + "<ParticipantIndex>none</ParticipantIndex><Tag>eventchain-layout-check</Tag>"
          + "</Discovery></Domain></CycloneDDS>";

  private static final long STAMP = 0x1122334455667788L;
  private static final int KIND_OF_DATA = 2;
  private static final long KIND = 16;
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private LayoutCheck() {}

  /**
   * Runs the check.
   *
   * @throws IllegalStateException if the layout differs, or the message does not arrive
   */
  static void run(DdsLibrary library) {
    MessageType type = MessageCatalog.of(List.of()).find("sensor_msgs/msg/LaserScan").orElseThrow();
    MessageValue scan = MessageValue.of(type).set("header.frame_id", "layout");
    byte[] bytes = CdrCodec.encode(scan.set("ranges", new float[] {1.5f, 2.5f}));
    QosSettings qos = QosSettings.named("default").orElseThrow();
    try (DdsParticipant participant = DdsParticipant.on(library, DOMAIN, ALONE);
        DdsWriter writer = participant.writer("/eventchain_layout", type, qos);
        DdsReader reader = participant.reader("/eventchain_layout", type, qos)) {
      Pointer data = writer.serialized(bytes);
      boolean known =
          data.getInt(KIND) == KIND_OF_DATA
              && data.getLong(DdsWriter.SOURCE_TIMESTAMP) == Long.MIN_VALUE;
      Samples.ddsiSerdataUnref(data);
      require(known, "a sample in memory has a different structure");
      require(writer.waitForMatches(1, PATIENCE), "a writer does not find a reader");
      require(writer.write(bytes, STAMP), "a sample cannot be written");
      List<DdsSample> samples = reader.take(PATIENCE);
      require(samples.size() == 1, "a sample that was written does not arrive");
      require(samples.get(0).sourceTimestamp() == STAMP, "a sample arrives with a different time");
      require(
          Arrays.equals(samples.get(0).bytes(), bytes), "a sample arrives with different bytes");
    }
  }

  private static void require(boolean condition, String otherwise) {
    if (!condition) {
      throw new IllegalStateException(otherwise + ".");
    }
  }
}
