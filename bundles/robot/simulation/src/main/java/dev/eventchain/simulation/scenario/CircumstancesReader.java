package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.bench.YamlText;
import dev.eventchain.simulation.formula.ActorSignals;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.Signal;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Reads what a scenario waits for: conditions of the road, the vehicle, the actors and the inputs,
 * but not of messages, so that other software does not change when it comes.
 */
final class CircumstancesReader {

  private final YamlText source;
  private final Signal.Source signals;
  private final Set<String> read;

  /**
   * Creates a reader.
   *
   * @param source the file, for the locations of problems
   * @param known the signals of the bench
   * @param actors the names of the actors
   * @param events the names of the events of a storyboard
   * @param read receives the names of the signals that the conditions read
   */
  CircumstancesReader(
      SourceText source,
      Signal.Source known,
      Collection<String> actors,
      Collection<String> events,
      Set<String> read) {
    this.read = read;
    this.source = new YamlText(source);
    this.signals = new ActorSignals(new WithoutMessages(known), actors, events);
  }

  /** Reads the condition at a key; empty if there is none, or if it is wrong. */
  Optional<Circumstance> read(ObjectReader section, String key) {
    Optional<String> text = section.text(key);
    if (text.isEmpty()) {
      return Optional.empty();
    }
    try {
      Formula formula =
          Formula.parseCircumstance(source.range(section.at(key), text.get()), signals);
      formula.signals().stream()
          .flatMap(Signal::origins)
          .forEach(signal -> read.add(signal.name()));
      return Optional.of(new Circumstance(formula));
    } catch (DiagnosticException e) {
      for (Diagnostic problem : e.diagnostics()) {
        SourceLocation place = problem.location().withElement(section.pointerTo(key));
        section.find(problem.withLocation(place));
      }
      return Optional.empty();
    }
  }

  /** The signals of a source except for fields of topics and outputs. */
  private record WithoutMessages(Signal.Source all) implements Signal.Source {

    @Override
    public Optional<Signal> find(String name) {
      return name.startsWith("/") ? Optional.empty() : all.find(name);
    }

    @Override
    public List<String> names() {
      return all.names().stream().filter(name -> !name.startsWith("/")).toList();
    }

    @Override
    public boolean readsOutputs() {
      return false;
    }

    @Override
    public String aboutTopics() {
      return " What is waited for happens on the road, and in no message.";
    }
  }
}
