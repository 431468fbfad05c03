package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.arxml.ArxmlLimits.NoNumberException;
import dev.eventchain.catalogue.network.NetworkMessage;
import dev.eventchain.catalogue.network.NetworkSignal;
import dev.eventchain.diagnostics.SourceLocation;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.BiConsumer;

/** Reads the signals of the PDUs of frames, also of PDUs in others. */
final class ArxmlPdus {

  /** Most bytes of a message on CAN XL. */
  private static final int LARGEST_SIZE = 2048;

  /** Most PDUs in each other: those of a container may be secured, and multiplexed. */
  private static final int DEEPEST = 4;

  /** Most signals with their texts: frames may carry the same PDUs again and again. */
  private static final int MOST = 1_000_000;

  private static final Set<String> PLAIN = Set.of("I-SIGNAL-I-PDU", "NM-PDU");

  /** Number of the first message without an identifier, beyond those of all buses. */
  private static final long WITHOUT_IDENTIFIER = (1L << 62) | NetworkMessage.EXTENDED;

  private final ArxmlTree tree;
  private final ArxmlUnread unread;
  private final BiConsumer<String, SourceLocation> findings;
  private final ArxmlSignals signals;
  private final ArxmlMultiplexers multiplexers;
  private final Set<String> read = new LinkedHashSet<>();

  /** The messages of PDUs in containers, by their paths. */
  private final Map<String, NetworkMessage> contained = new HashMap<>();

  private long unnumbered = WITHOUT_IDENTIFIER;
  private long count;

  /**
   * A message with its signals.
   *
   * @param parts the frame, PDUs and signals that it is made of
   */
  record Content(NetworkMessage message, Set<ArxmlElement> parts) {}

  /**
   * Place of a PDU.
   *
   * @param shift bits before it in its message
   * @param cycle of the PDU that it is in, in ms
   * @param depth how many PDUs it is in
   */
  record Place(int shift, OptionalInt cycle, int depth) {

    Place below(OptionalInt own) {
      return new Place(shift, own, depth + 1);
    }
  }

  /** Too many signals for a catalogue. */
  static final class TooManyException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    TooManyException() {
      super("Its frames have more than " + MOST + " signals and texts.");
    }
  }

  ArxmlPdus(ArxmlTree tree, ArxmlUnread unread, BiConsumer<String, SourceLocation> findings) {
    this.tree = tree;
    this.unread = unread;
    this.findings = findings;
    this.signals = new ArxmlSignals(tree, unread);
    this.multiplexers = new ArxmlMultiplexers(tree, this);
  }

  /** Returns a number for a message that has no identifier. */
  long unnumbered() {
    return unnumbered++;
  }

  /** Returns the bytes of a frame or PDU. */
  static int size(ArxmlElement element, String tag) throws NoNumberException {
    Optional<ArxmlElement> size = element.first(tag);
    if (size.isEmpty()) {
      throw new NoNumberException(
          "'" + element.path() + "' has no " + tag + ".", element.location());
    }
    return (int) ArxmlLimits.whole(size.get(), LARGEST_SIZE);
  }

  /** Returns the message of a frame with its signals, and those of the PDUs in containers. */
  List<Content> of(ArxmlElement frame, NetworkMessage message) {
    List<Content> contents = new ArrayList<>();
    contents.add(new Content(message, new LinkedHashSet<>(Set.of(frame))));
    for (ArxmlElement mapping : frame.all("PDU-TO-FRAME-MAPPINGS", "PDU-TO-FRAME-MAPPING")) {
      attempt(
          () -> {
            Optional<ArxmlElement> start = mapping.first("START-POSITION");
            long bits = start.isEmpty() ? 0 : ArxmlLimits.whole(start.get(), 8L * LARGEST_SIZE);
            Place place = new Place((int) bits / 8 * 8, OptionalInt.empty(), 0);
            Optional<ArxmlElement> pdu = tree.follow(mapping, Set.of(), "PDU-REF");
            if (pdu.isPresent()) {
              add(pdu.get(), place, contents);
            }
          });
    }
    return contents;
  }

  private void add(ArxmlElement pdu, Place place, List<Content> contents) throws NoNumberException {
    Content content = contents.get(0);
    if (place.depth() > DEEPEST) {
      findings.accept("'" + pdu.path() + "' is in too many other PDUs.", pdu.location());
      return;
    }
    content.parts().add(pdu);
    if (content.message().comment().isEmpty()) {
      content.message().comment(pdu.about());
    }
    switch (pdu.tag()) {
      case "MULTIPLEXED-I-PDU" -> {
        for (NetworkSignal signal : multiplexers.of(pdu, place, content)) {
          add(signal, content.message());
        }
      }
      case "SECURED-I-PDU" -> secured(pdu, place, contents);
      case "CONTAINER-I-PDU" -> contained(pdu, place, contents);
      default -> signals(pdu, place, content).forEach(it -> add(it, content.message()));
    }
  }

  private void add(NetworkSignal signal, NetworkMessage message) {
    message.add(signal).ifPresent(problem -> findings.accept(problem, signal.place()));
  }

  /** Reads what a secured PDU protects, unless that is in another message. */
  private void secured(ArxmlElement pdu, Place place, List<Content> contents)
      throws NoNumberException {
    Optional<ArxmlElement> inner =
        pdu.text("USE-AS-CRYPTOGRAPHIC-I-PDU").filter("true"::equals).isPresent()
            ? Optional.empty()
            : tree.follow(pdu, Set.of("PDU-TRIGGERING"), "PAYLOAD-REF")
                .flatMap(it -> tree.follow(it, Set.of(), "I-PDU-REF"));
    if (inner.isPresent()) {
      add(inner.get(), place.below(cycle(pdu, place)), contents);
    }
  }

  /**
   * Reads the PDUs of a container, each of which is a message of its own, also if it is in other
   * containers.
   */
  private void contained(ArxmlElement container, Place place, List<Content> contents)
      throws NoNumberException {
    for (ArxmlElement reference :
        container.all("CONTAINED-PDU-TRIGGERING-REFS", "CONTAINED-PDU-TRIGGERING-REF")) {
      Optional<ArxmlElement> pdu =
          tree.follow(reference, Set.of("PDU-TRIGGERING"))
              .flatMap(it -> tree.follow(it, Set.of(), "I-PDU-REF"));
      if (pdu.isPresent()) {
        contained(pdu.get(), container, place, contents);
      }
    }
  }

  private void contained(
      ArxmlElement pdu, ArxmlElement container, Place place, List<Content> contents)
      throws NoNumberException {
    Set<ArxmlElement> parts = new LinkedHashSet<>(contents.get(0).parts());
    NetworkMessage known = contained.get(pdu.path());
    if (known != null) {
      count(1);
      parts.add(pdu);
      contents.add(new Content(known, parts));
      return;
    }
    NetworkMessage message = new NetworkMessage(unnumbered(), pdu.name(), size(pdu, "LENGTH"));
    contained.put(pdu.path(), message);
    List<Content> inner = new ArrayList<>(List.of(new Content(message, parts)));
    add(pdu, new Place(0, cycle(container, place), place.depth() + 1), inner);
    contents.addAll(inner);
  }

  /** Returns the signals of a PDU in their order, and notes that it was read. */
  List<NetworkSignal> signals(ArxmlElement pdu, Place place, Content content)
      throws NoNumberException {
    read.add(pdu.path());
    OptionalInt cycle = cycle(pdu, place);
    List<NetworkSignal> all = new ArrayList<>();
    for (ArxmlElement mapping : mappings(pdu)) {
      attempt(
          () -> {
            Optional<NetworkSignal> signal =
                signals.of(mapping, content.message().name(), place.shift());
            if (signal.isPresent()) {
              tree.follow(mapping, Set.of("I-SIGNAL"), "I-SIGNAL-REF")
                  .ifPresent(content.parts()::add);
              cycle.ifPresent(signal.get()::cycle);
              all.add(counted(signal.get()));
            }
          });
    }
    return all;
  }

  private NetworkSignal counted(NetworkSignal signal) {
    count(1 + signal.texts().size());
    return signal;
  }

  private void count(int more) {
    count += more;
    if (count > MOST) {
      throw new TooManyException();
    }
  }

  private static List<ArxmlElement> mappings(ArxmlElement pdu) {
    List<ArxmlElement> mappings =
        new ArrayList<>(pdu.all("I-SIGNAL-TO-PDU-MAPPINGS", "I-SIGNAL-TO-I-PDU-MAPPING"));
    mappings.addAll(pdu.all("I-SIGNAL-TO-I-PDU-MAPPINGS", "I-SIGNAL-TO-I-PDU-MAPPING"));
    mappings.removeIf(it -> it.first("I-SIGNAL-REF").isEmpty());
    return mappings;
  }

  /** Returns the time between two of a PDU in ms; that of the PDU around it if it has none. */
  static OptionalInt cycle(ArxmlElement pdu, Place place) throws NoNumberException {
    Optional<ArxmlElement> period =
        pdu.first(
            "I-PDU-TIMING-SPECIFICATIONS",
            "I-PDU-TIMING",
            "TRANSMISSION-MODE-DECLARATION",
            "TRANSMISSION-MODE-TRUE-TIMING",
            "CYCLIC-TIMING",
            "TIME-PERIOD",
            "VALUE");
    if (period.isEmpty()) {
      return place.cycle();
    }
    BigDecimal ms = ArxmlLimits.number(period.get()).movePointRight(3);
    boolean known = ms.signum() > 0 && ms.compareTo(BigDecimal.valueOf(Integer.MAX_VALUE)) <= 0;
    return known
        ? OptionalInt.of(ms.setScale(0, RoundingMode.CEILING).intValue())
        : OptionalInt.empty();
  }

  /** Notes the PDUs with signals that are in no frame. */
  void noteOthers() {
    for (String kind : PLAIN.stream().sorted().toList()) {
      for (ArxmlElement pdu : tree.all(kind)) {
        if (!read.contains(pdu.path()) && !mappings(pdu).isEmpty()) {
          unread.note(ArxmlUnread.Kind.PDU, pdu.name(), pdu.location());
        }
      }
    }
  }

  /** A step of reading that fails alone. */
  private interface Step {
    void run() throws NoNumberException;
  }

  private void attempt(Step step) {
    try {
      step.run();
    } catch (NoNumberException e) {
      findings.accept(e.getMessage(), e.place());
    }
  }
}
