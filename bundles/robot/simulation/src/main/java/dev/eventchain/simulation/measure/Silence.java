package dev.eventchain.simulation.measure;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.host.RunLog.SampleId;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Finds the components that did not work in any scenario. A component executes once each of its
 * inputs has come, so one with a missing input does nothing, and the scenario says nothing about
 * it. Of components that wait for each other, the first one is the cause.
 */
public final class Silence {

  /** Reader of the commands. */
  private static final String VEHICLE = "the vehicle";

  private final SimulatedChain chain;
  private final List<RunLog> logs;

  /** Missing topics of each silent component. */
  private final Map<String, Set<String>> waiting = new LinkedHashMap<>();

  /** Topics that a component failed to write although all its inputs came. */
  private final Map<String, Set<String>> mute = new LinkedHashMap<>();

  private Silence(SimulatedChain chain, List<RunLog> logs) {
    this.chain = chain;
    this.logs = logs;
  }

  /**
   * Returns a finding for each component that did not work, unless another component is the cause.
   */
  public static List<Diagnostic> in(List<RunLog> logs, SimulatedChain chain) {
    Silence silence = new Silence(chain, logs);
    chain.nodes().forEach(silence::listen);
    silence.listenAtTheVehicle();
    return silence.findings();
  }

  /**
   * Checks that the vehicle received a message on at least one commanding topic, if there are any.
   */
  private void listenAtTheVehicle() {
    List<String> commands = chain.commands();
    if (!commands.isEmpty() && commands.stream().noneMatch(this::isPublished)) {
      waiting.put(VEHICLE, new TreeSet<>(commands));
    }
  }

  private boolean isPublished(String topic) {
    return logs.stream().anyMatch(log -> !log.publicationsOf(topic).isEmpty());
  }

  private void listen(SoftwareNode node) {
    Set<String> missing = chain.topicsReadBy(node);
    Set<String> unwritten = chain.topicsWrittenBy(node);
    for (RunLog log : logs) {
      List<Activation> activations = log.nodes().getOrDefault(node.getName(), List.of());
      missing.removeAll(topics(activations, Activation::reads));
      unwritten.removeAll(topics(activations, Activation::writes));
    }
    if (!missing.isEmpty()) {
      waiting.put(node.getName(), missing);
    } else if (!unwritten.isEmpty()) {
      mute.put(node.getName(), unwritten);
    }
  }

  private static Set<String> topics(
      List<Activation> activations, Function<Activation, Collection<SampleId>> samples) {
    return activations.stream()
        .flatMap(each -> samples.apply(each).stream())
        .map(SampleId::topic)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private List<Diagnostic> findings() {
    List<Diagnostic> findings = new ArrayList<>();
    waiting.forEach((name, missing) -> unmatched(name, missing).ifPresent(findings::add));
    waiting.forEach(
        (name, missing) ->
            missing.stream()
                .filter(topic -> !isUnmatched(name, topic))
                .filter(topic -> chain.writers(topic).stream().noneMatch(this::isSilent))
                .map(topic -> waits(name, topic))
                .forEach(findings::add));
    mute.forEach((name, unwritten) -> findings.add(writesNothing(name, unwritten)));
    if (findings.isEmpty() && !waiting.isEmpty()) {
      findings.add(waitForEachOther());
    }
    return findings;
  }

  /**
   * Returns a finding if messages of synchronized topics came, but never with stamps that belong
   * together.
   */
  private Optional<Diagnostic> unmatched(String name, Set<String> missing) {
    return missing.stream()
        .filter(topic -> isUnmatched(name, topic))
        .findFirst()
        .flatMap(topic -> node(name))
        .map(
            node ->
                finding(
                    name,
                    "%s never executed: all of %s came, but never with %s."
                        .formatted(
                            quoted(name),
                            String.join(", ", TopicIndex.synchronizedBy(node)),
                            node.isSetTolerance()
                                ? String.format(
                                    Locale.ROOT,
                                    "stamps that differ by less than the tolerance of %s ms",
                                    node.getTolerance())
                                : "equal stamps"),
                    "Compare the stamps in the headers: give a tolerance above what writers and"
                        + " latencies put between them, or do not synchronize these inputs."));
  }

  /** Returns whether a missing topic and all that are synchronized with it were published. */
  private boolean isUnmatched(String name, String topic) {
    List<String> topics = node(name).map(TopicIndex::synchronizedBy).orElse(List.of());
    return topics.contains(topic) && topics.stream().allMatch(this::isPublished);
  }

  private Optional<SoftwareNode> node(String name) {
    return chain.nodes().stream().filter(node -> name.equals(node.getName())).findFirst();
  }

  private boolean isSilent(String name) {
    return waiting.containsKey(name) || mute.containsKey(name);
  }

  private Diagnostic waits(String name, String topic) {
    List<String> writers = chain.writers(topic);
    boolean vehicle = name.equals(VEHICLE);
    String why;
    String hint;
    if (isPublished(topic)) {
      why = "is sent, but never reached it.";
      hint = "Compare type and quality of service of both ends.";
    } else if (!writers.isEmpty()) {
      why = "never arrived; " + quoted(writers) + " should have written it.";
      hint = "A component that is not simulated writes nothing: see simulation.node.left-out.";
    } else if (chain.bench().provided().containsKey(topic)) {
      why = "never arrived: no scenario let the bench send it.";
      hint =
          "Look at its `lost`, `latency_ms` and `rate_hz` in bench.yaml, and how long scenarios last.";
    } else if (vehicle) {
      why = "never arrived: no component writes it.";
      hint =
          "Let a component write the command; otherwise, the scenarios say nothing about the"
              + " software.";
    } else {
      why = "never arrived: no component writes it, and the simulated vehicle does not send it.";
      hint = "Read a topic of the simulated vehicle, or add the component that writes this one.";
    }
    String subject = vehicle ? "The vehicle was never commanded" : quoted(name) + " never executed";
    return finding(name, "%s: %s %s".formatted(subject, topic, why), hint);
  }

  private Diagnostic writesNothing(String name, Set<String> unwritten) {
    return finding(
        name,
        "%s executed, but never wrote %s.".formatted(quoted(name), String.join(", ", unwritten)),
        "Let execute() return each output in at least one scenario, or a node publish it; or leave"
            + " it out of the chain.");
  }

  private Diagnostic waitForEachOther() {
    List<String> names = waiting.keySet().stream().filter(name -> !name.equals(VEHICLE)).toList();
    return error(
        names.get(0),
        "%s never executed: they wait for each other.".formatted(quoted(names)),
        "Let one of them begin without the others' topics.");
  }

  private Diagnostic finding(String name, String message, String hint) {
    List<String> others = new ArrayList<>(waiting.keySet());
    others.remove(name);
    others.remove(VEHICLE);
    String without = others.isEmpty() ? "" : " Nor did " + quoted(others) + ".";
    return error(name, message + without, hint);
  }

  private static Diagnostic error(String name, String message, String hint) {
    return Diagnostic.of(MeasureRules.NODE_SILENT, message, SourceLocation.NONE.withElement(name))
        .withHint(hint);
  }

  private static String quoted(List<String> names) {
    return names.stream().map(Silence::quoted).collect(Collectors.joining(", "));
  }

  private static String quoted(String name) {
    return "'" + name + "'";
  }
}
