package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.eventchain.sandbox.PythonEnvironment;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;

/** The library and domains for tests. */
final class Wire {

  static final Duration PATIENCE = Duration.ofMinutes(2);

  /** Prefix of tags, since tests of several builds may run on one machine at once. */
  private static final String RUN = "test-" + ProcessHandle.current().pid();

  private static final AtomicInteger COUNT = new AtomicInteger();

  private Wire() {}

  /**
   * Returns the library that {@code EVENTCHAIN_LIBDDSC} names, else that of the Python environment.
   */
  static DdsLibrary library() {
    boolean named = !System.getenv().getOrDefault("EVENTCHAIN_LIBDDSC", "").isEmpty();
    return DdsLibrary.load(named ? Optional.empty() : Optional.of(OfPython.PATH));
  }

  /** Returns a tag that is unique among tests. */
  static String newTag() {
    return RUN + "-" + COUNT.incrementAndGet();
  }

  /** Returns a domain number that is unique within this process. */
  static int newDomain() {
    return 10 + COUNT.incrementAndGet() % 200;
  }

  /** Returns an isolated participant in a new domain. */
  static DdsParticipant alone() {
    return DdsParticipant.loopback(library(), newDomain(), newTag());
  }

  /**
   * Returns a participant that communicates with those of the same tag over the network, although
   * they are in this process: Cyclone uses different domains, with the same domain on the wire.
   */
  static DdsParticipant onTheWire(String tag) {
    return onTheWire(tag, "");
  }

  /** As {@code onTheWire(String)}, with nodes announced as in a ROS 2 release. */
  static DdsParticipant onTheWire(String tag, String distribution) {
    return DdsParticipant.on(
        library(),
        newDomain(),
        DdsParticipant.loopback("<ExternalDomainId>7</ExternalDomainId><Tag>" + tag + "</Tag>"),
        distribution);
  }

  /**
   * Waits until both know each other. A writer that knows the reader is not enough: what it writes
   * before the reader knows it, too, is lost.
   */
  static void connect(DdsWriter writer, DdsReader reader) {
    assertTrue(writer.waitForMatches(1, PATIENCE), () -> "no reader of " + writer.topic());
    assertTrue(reader.waitForMatches(1, PATIENCE), () -> "no writer of " + reader.topic());
  }

  private static final class OfPython {
    static final Path PATH = find();

    /** Finds the library. Other machines have no wheel; where one exists, it is required. */
    private static Path find() {
      boolean linux = System.getProperty("os.name").equals("Linux");
      assumeTrue(linux && System.getProperty("os.arch").equals("amd64"));
      return PythonEnvironment.ensureWithCycloneDds(line -> {}).cycloneDds().orElseThrow();
    }
  }
}
