package dev.eventchain.catalogue.network;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/** A message of a network, while its description is read. */
public final class NetworkMessage {

  /** Largest number of a message: 32 bits. */
  public static final long LARGEST_NUMBER = 0xFFFF_FFFFL;

  /** Bit that marks an identifier of 29 bits. */
  public static final long EXTENDED = 0x8000_0000L;

  private static final long LARGEST_STANDARD = 0x7FF;
  private static final long LARGEST_EXTENDED = 0x1FFF_FFFF;

  /** The message of signals that no message has, which is never sent. */
  private static final String WITHOUT_MESSAGE = "VECTOR__INDEPENDENT_SIG_MSG";

  private final long number;
  private final String name;
  private final int size;
  private final Set<String> senders = new LinkedHashSet<>();
  private final Map<String, NetworkSignal> signals = new LinkedHashMap<>();
  private String longName = "";
  private String comment = "";
  private OptionalInt cycle = OptionalInt.empty();

  /**
   * Creates a message without signals.
   *
   * @param number what it is found by: its identifier, with bit 31 if that is one of 29 bits; bits
   *     from 32 on may keep messages of several buses apart
   * @param size in bytes
   */
  public NetworkMessage(long number, String name, int size) {
    this.number = number;
    this.name = name;
    this.size = size;
  }

  public boolean isExtended() {
    return (number & EXTENDED) != 0;
  }

  public boolean isNeverSent() {
    return name.equals(WITHOUT_MESSAGE);
  }

  /** Returns the identifier on the bus. */
  public long identifier() {
    return number & LARGEST_NUMBER & ~EXTENDED;
  }

  /** Returns a sentence about an identifier with more bits than its kind has. */
  public Optional<String> identifierProblem() {
    boolean fits = identifier() <= (isExtended() ? LARGEST_EXTENDED : LARGEST_STANDARD);
    return fits || isNeverSent()
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "The identifier of '%s' has more than %d bits.",
                name,
                isExtended() ? 29 : 11));
  }

  public long number() {
    return number;
  }

  public String name() {
    return longName.isEmpty() ? name : longName;
  }

  public int size() {
    return size;
  }

  /** Returns the nodes that send it. */
  public Set<String> senders() {
    return senders;
  }

  /**
   * Adds a signal; one that cannot be in this message is not added.
   *
   * @return a sentence about the reason why not
   */
  public Optional<String> add(NetworkSignal signal) {
    String full = "'" + name() + "." + signal.name() + "'";
    if (signal.layout().factor().signum() == 0) {
      return Optional.of(full + " has a factor of 0.");
    }
    if (!signal.layout().fits(size)) {
      return Optional.of(full + " does not fit into the " + size + " bytes of its message.");
    }
    return signals.putIfAbsent(signal.name(), signal) == null
        ? Optional.empty()
        : Optional.of("There is another signal " + full + ".");
  }

  /** Returns the signals by the names under which they were added. */
  public Map<String, NetworkSignal> signals() {
    return signals;
  }

  /** Returns when a multiplexed signal is there; empty if it always is. */
  public Optional<SendingCondition> condition(NetworkSignal signal) {
    if (signal.multiplexed().isEmpty() || signal.condition().isPresent()) {
      return signal.condition();
    }
    List<SendingCondition.Range> number =
        List.of(SendingCondition.Range.of(new BigDecimal(signal.multiplexed())));
    return signals.values().stream()
        .filter(it -> it.isMultiplexer() && it.multiplexed().isEmpty())
        .map(it -> new SendingCondition(it, number))
        .findFirst();
  }

  /**
   * Returns the numbers of all multiplexers on which a signal depends, those of others included.
   */
  public Map<NetworkSignal, List<SendingCondition.Range>> conditions(NetworkSignal signal) {
    Map<NetworkSignal, List<SendingCondition.Range>> all = new LinkedHashMap<>();
    Optional<SendingCondition> next = condition(signal);
    while (next.isPresent() && !all.containsKey(next.get().multiplexer())) {
      all.put(next.get().multiplexer(), next.get().ranges());
      next = condition(next.get().multiplexer());
    }
    return all;
  }

  public String comment() {
    return comment;
  }

  /** Returns the stated time between two of them in ms, 0 if it is not sent regularly. */
  public OptionalInt cycle() {
    return cycle;
  }

  public void rename(String full) {
    longName = full;
  }

  public void comment(String text) {
    comment = text;
  }

  public void cycle(int milliseconds) {
    cycle = OptionalInt.of(milliseconds);
  }
}
