package dev.eventchain.catalogue;

import dev.eventchain.catalogue.arxml.ArxmlFormat;
import dev.eventchain.catalogue.dbc.DbcFormat;
import dev.eventchain.catalogue.ddsidl.DdsIdlFormat;
import dev.eventchain.catalogue.signal.CatalogueFormat;
import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.catalogue.vss.VssFormat;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.Signal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** The signals of a whole vehicle, of which a chain uses a few. Immutable. */
public final class SignalCatalogue {

  private static final List<CatalogueFormat> FORMATS =
      List.of(new VssFormat(), new DdsIdlFormat(), new DbcFormat(), new ArxmlFormat());

  private final Map<String, CatalogueSignal> byPath = new LinkedHashMap<>();
  private final CatalogueTopics topics;
  private final List<Diagnostic> diagnostics;

  private SignalCatalogue(
      List<CatalogueSignal> signals, CatalogueTopics topics, List<Diagnostic> diagnostics) {
    signals.forEach(signal -> byPath.putIfAbsent(signal.path(), signal));
    this.topics = topics;
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** Reads a catalogue. What cannot be read is a finding, and so is a catalogue without signals. */
  public static SignalCatalogue read(CatalogueSource source) {
    List<Diagnostic> found = new ArrayList<>();
    String name = source.file().toString().toLowerCase(Locale.ROOT);
    Optional<CatalogueFormat> format =
        FORMATS.stream().filter(it -> it.suffixes().stream().anyMatch(name::endsWith)).findFirst();
    if (format.isEmpty()) {
      String suffixes =
          FORMATS.stream().flatMap(it -> it.suffixes().stream()).collect(Collectors.joining(", "));
      found.add(
          Diagnostic.of(
                  CatalogueRules.FORMAT,
                  "This is no catalogue of signals in a format that is read.",
                  SourceLocation.of(source.file()))
              .withHint("These are read: " + suffixes + "."));
      return new SignalCatalogue(List.of(), new CatalogueTopics("none"), found);
    }
    List<CatalogueSignal> signals = format.get().read(source, found::add);
    if (signals.isEmpty() && !Diagnostic.anyError(found)) {
      found.add(
          Diagnostic.of(
                  CatalogueRules.EMPTY,
                  "The catalogue has no signals.",
                  SourceLocation.of(source.file()))
              .withHint(
                  "In VSS, a signal has the type sensor, actuator or attribute; in DBC, it is an SG_ of a message; in ARXML, an I-SIGNAL of a frame on CAN."));
    }
    return new SignalCatalogue(signals, new CatalogueTopics(format.get().prefix()), found);
  }

  /** Returns all signals, in the order of the files. */
  public List<CatalogueSignal> signals() {
    return List.copyOf(byPath.values());
  }

  /** Returns whether a signal has a path, or is in the group with that path. */
  public static boolean isIn(CatalogueSignal signal, String path) {
    return signal.path().equals(path) || signal.path().startsWith(path + ".");
  }

  /** Returns the topics of all signals. */
  public List<Signal> topics() {
    return topics(signals());
  }

  /**
   * Returns the topics of some signals: one for the current value of each, one for the wanted value
   * of each actuator, and one alone for a value that software sends.
   */
  public List<Signal> topics(List<CatalogueSignal> some) {
    return some.stream().flatMap(signal -> topics.of(signal).stream()).toList();
  }

  /** Returns the topics of some signals in the form of {@code signals.json}. */
  public String asJson(List<CatalogueSignal> some) {
    return topics.asJson(some);
  }

  /** Returns the findings. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }
}
