package dev.eventchain.catalogue.network;

import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSignal.Role;
import dev.eventchain.catalogue.signal.CatalogueUnits;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.Signal.NamedNumber;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;

/** The signals of a network as those of a catalogue, with physical values. */
public final class NetworkSignals {

  private final Network network;
  private final Optional<String> node;
  private final Consumer<Diagnostic> findings;
  private final Set<String> paths = new HashSet<>();

  /**
   * Creates a conversion.
   *
   * @param node the node that the software is; empty if it only receives
   */
  public NetworkSignals(Network network, Optional<String> node, Consumer<Diagnostic> findings) {
    this.network = network;
    this.node = node;
    this.findings = findings;
  }

  /** Returns the signals of all messages, in the order of the file. */
  public List<CatalogueSignal> all() {
    List<CatalogueSignal> signals = new ArrayList<>();
    for (NetworkMessage message : network.messages()) {
      for (NetworkSignal signal : message.signals().values()) {
        signal(message, signal).ifPresent(signals::add);
      }
    }
    return signals;
  }

  private Optional<CatalogueSignal> signal(NetworkMessage message, NetworkSignal signal) {
    String path = part(message.name()) + "." + part(signal.name());
    boolean legal = path.matches("[A-Za-z][A-Za-z0-9_]*\\.[A-Za-z][A-Za-z0-9_]*");
    if (!legal || !paths.add(path)) {
      String full = message.name() + "." + signal.name();
      String reason =
          legal
              ? "'%s' has the topic of another signal, %s.".formatted(full, path)
              : "'" + full + "' cannot be the name of a topic.";
      find(reason, signal.place());
      return Optional.empty();
    }
    Optional<SignalValues> values = SignalValues.of(signal);
    if (values.isEmpty()) {
      find("'" + path + "' is a number with a point, but not of its size.", signal.place());
      return Optional.empty();
    }
    if (values.get().isOutside()) {
      findings.accept(
          Diagnostic.of(
                  CatalogueRules.RANGE,
                  "'" + path + "' states a range that none of its values is in.",
                  signal.place())
              .withHint("It is not read: all values that its bits hold count as possible."));
    }
    return Optional.of(converted(message, signal, path, values.get()));
  }

  private CatalogueSignal converted(
      NetworkMessage message, NetworkSignal signal, String path, SignalValues values) {
    boolean sent = node.filter(message.senders()::contains).isPresent();
    boolean truth = values.type().equals("bool");
    return new CatalogueSignal(
        path,
        sent ? Role.COMMAND : Role.SENSOR,
        Optional.of(values.type()),
        unit(signal),
        truth ? OptionalDouble.empty() : values.least(),
        truth ? OptionalDouble.empty() : values.most(),
        List.of(),
        names(signal, values),
        description(message, signal, values),
        message.comment().isBlank() ? List.of() : List.of(message.comment()),
        signal.place());
  }

  /**
   * Returns a name as a part of a topic, which has no two underscores in a row, and none at its
   * ends.
   */
  private static String part(String name) {
    return name.replaceAll("_+", "_").replaceFirst("^_", "").replaceFirst("_$", "");
  }

  /** Returns the unit; empty for what tools write where there is none. */
  private static String unit(NetworkSignal signal) {
    String unit = CatalogueUnits.of(signal.unit().strip());
    return CatalogueUnits.isNone(unit) ? "" : unit;
  }

  /** Returns the comment, with meanings of numbers, and when it is sent. */
  private String description(NetworkMessage message, NetworkSignal signal, SignalValues values) {
    List<String> sentences = new ArrayList<>();
    if (!signal.comment().isBlank()) {
      String comment = signal.comment().strip();
      sentences.add(comment.matches("(?s).*[.!?]") ? comment : comment + ".");
    }
    sentences.addAll(texts(signal, values.special()));
    message
        .condition(signal)
        .map(SendingCondition::text)
        .ifPresent(when -> sentences.add("Only sent where " + when + "."));
    signal
        .initial()
        .map(raw -> SignalValues.plain(signal.layout().physical(raw)))
        .ifPresent(value -> sentences.add("At first " + value + "."));
    int cycle = signal.cycle().orElse(network.cycle(message));
    if (cycle > 0) {
      sentences.add("Sent every " + cycle + " ms.");
    }
    return String.join(" ", sentences);
  }

  /** Returns the names of physical values, without those of numbers that its bits do not hold. */
  private static List<NamedNumber> names(NetworkSignal signal, SignalValues values) {
    return signal.texts().entrySet().stream()
        .map(
            it ->
                new NamedNumber(it.getValue(), signal.layout().physical(it.getKey()).doubleValue()))
        .filter(
            it ->
                it.number() >= values.least().orElse(Double.NEGATIVE_INFINITY)
                    && it.number() <= values.most().orElse(Double.POSITIVE_INFINITY))
        .toList();
  }

  /** Returns the meanings of values, and apart from them those outside the stated range. */
  private static List<String> texts(NetworkSignal signal, List<BigDecimal> special) {
    NetworkSignal.Layout layout = signal.layout();
    List<String> usual = new ArrayList<>();
    List<String> outside = new ArrayList<>();
    signal
        .texts()
        .forEach(
            (raw, text) ->
                (special.contains(raw) ? outside : usual)
                    .add(SignalValues.plain(layout.physical(raw)) + " " + text));
    List<String> sentences = new ArrayList<>();
    if (!usual.isEmpty()) {
      sentences.add("Values: " + String.join(", ", usual) + ".");
    }
    if (!outside.isEmpty()) {
      sentences.add(outsideOf(layout) + ": " + String.join(", ", outside) + ".");
    }
    return sentences;
  }

  private static String outsideOf(NetworkSignal.Layout layout) {
    Optional<String> least = layout.least().map(SignalValues::plain);
    Optional<String> most = layout.most().map(SignalValues::plain);
    if (least.isEmpty() || most.isEmpty()) {
      return least.map(it -> "Below " + it).or(() -> most.map(it -> "Above " + it)).orElse("");
    }
    return "Outside of " + least.get() + " to " + most.get();
  }

  private void find(String message, SourceLocation place) {
    findings.accept(Diagnostic.of(CatalogueRules.ENTRY, message, place));
  }
}
