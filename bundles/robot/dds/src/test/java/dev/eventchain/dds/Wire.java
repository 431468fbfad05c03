package dev.eventchain.dds;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.eventchain.sandbox.PythonEnvironment;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;

/** The library and domains for tests. */
final class Wire {

  static final Duration PATIENCE = Duration.ofMinutes(2);

  /** On one machine tests of several builds may run at once: tags keep them apart. */
  private static final String RUN = "test-" + ProcessHandle.current().pid();

  private static final AtomicInteger COUNT = new AtomicInteger();

  private Wire() {}

  /** The library that {@code EVENTCHAIN_LIBDDSC} names, else that of the Python environment. */
  static DdsLibrary library() {
    boolean named = !System.getenv().getOrDefault("EVENTCHAIN_LIBDDSC", "").isEmpty();
    return DdsLibrary.load(named ? Optional.empty() : Optional.of(OfPython.PATH));
  }

  /** A tag that no other test has. */
  static String newTag() {
    return RUN + "-" + COUNT.incrementAndGet();
  }

  /** A number of this process that no other test has. */
  static int newDomain() {
    return 10 + COUNT.incrementAndGet() % 200;
  }

  /** A participant for itself, or with others of this domain in this process. */
  static DdsParticipant alone() {
    return DdsParticipant.loopback(library(), newDomain(), newTag());
  }

  /**
   * A participant that meets those with the same tag over the network, although it is in this
   * process: for Cyclone in another domain, on the wire in the same.
   */
  static DdsParticipant onTheWire(String tag) {
    return onTheWire(tag, "");
  }

  /** The same, with nodes as a release of ROS 2 tells of them. */
  static DdsParticipant onTheWire(String tag, String distribution) {
    return DdsParticipant.on(
        library(),
        newDomain(),
        DdsParticipant.loopback("<ExternalDomainId>7</ExternalDomainId><Tag>" + tag + "</Tag>"),
        distribution);
  }

  private static final class OfPython {
    static final Path PATH = find();

    /** There is no wheel for other machines; where there should be one, it must be there. */
    private static Path find() {
      boolean linux = System.getProperty("os.name").equals("Linux");
      assumeTrue(linux && System.getProperty("os.arch").equals("amd64"));
      return PythonEnvironment.ensureWithCycloneDds(line -> {}).cycloneDds().orElseThrow();
    }
  }
}
