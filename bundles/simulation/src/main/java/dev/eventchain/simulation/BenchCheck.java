package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.RosNames;
import dev.eventchain.metamodel.Signal.Direction;
import dev.eventchain.metamodel.TopicIndex;
import dev.eventchain.metamodel.TopicIndex.Endpoint;
import dev.eventchain.metamodel.TopicIndex.Topic;
import dev.eventchain.metamodel.eventchain.Data;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.simulation.Bench.Consumed;
import dev.eventchain.simulation.Bench.Effect;
import dev.eventchain.simulation.Bench.Field;
import dev.eventchain.simulation.Bench.Provided;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;

/** Compares what a chain reads from the vehicle and writes to it with what the bench connects. */
final class BenchCheck {

  private static final Set<String> STAMPS = Set.of("stamp.sec", "stamp.nanosec", "stamp");

  private final Bench bench;
  private final TopicIndex topics;
  private final Function<EObject, SourceLocation> locator;
  private final List<Diagnostic> found = new ArrayList<>();

  BenchCheck(Bench bench, EventChain chain, Function<EObject, SourceLocation> locator) {
    this.bench = bench;
    this.topics = TopicIndex.of(chain);
    this.locator = locator;
  }

  List<Diagnostic> check() {
    for (Topic topic : topics.topics()) {
      Provided provided = bench.provided().get(topic.name());
      if (topic.publishers().isEmpty()) {
        checkRead(topic, provided);
      }
      Consumed consumed = bench.consumed().get(topic.name());
      if (consumed == null) {
        checkUntaken(topic);
      }
    }
    bench.consumed().values().forEach(this::checkRequired);
    checkAnythingTaken();
    return List.copyOf(found);
  }

  /** A topic that no component writes must come from the vehicle, and each field of it, too. */
  private void checkRead(Topic topic, Provided provided) {
    Data first = topic.subscribers().get(0).data().get(0);
    if (provided == null) {
      boolean known =
          bench
              .declared()
              .find(topic.name())
              .filter(it -> it.direction() == Direction.PROVIDED)
              .isPresent();
      find(
          "bench.topic.unconnected",
          "%s reads %s, which %s."
              .formatted(
                  names(topic.subscribers()),
                  topic.name(),
                  known
                      ? "no entry of the bench provides"
                      : "nobody sends: no component writes it, and the bench does not provide it"),
          first,
          "Say under `provides` of bench.yaml where its fields come from.");
      return;
    }
    for (Endpoint reader : topic.subscribers()) {
      reader.data().forEach(data -> checkField(provided, data));
    }
  }

  private void checkField(Provided provided, Data data) {
    String path = data.getFieldName();
    if (path == null || provided.lidar() || isStamp(path)) {
      return;
    }
    boolean set =
        provided.fields().stream().map(Field::path).anyMatch(it -> RosNames.overlap(it, path));
    if (!set) {
      find(
          "bench.field.unset",
          "'%s' of %s is read, but the bench leaves it at its default."
              .formatted(path, provided.topic()),
          data,
          "Give it a source in bench.yaml, or a constant if it is always the same.");
    }
  }

  /** The time of a header is set by itself. */
  private static boolean isStamp(String path) {
    return STAMPS.stream().anyMatch(stamp -> path.endsWith("header." + stamp));
  }

  /** What is written for the vehicle must do something, or be said to do nothing. */
  private void checkUntaken(Topic topic) {
    boolean forVehicle =
        bench
            .declared()
            .find(topic.name())
            .filter(it -> it.direction() == Direction.CONSUMED)
            .isPresent();
    if (forVehicle && !topic.publishers().isEmpty()) {
      find(
          "bench.topic.unconnected",
          "%s writes %s to the vehicle, but the bench does not take it."
              .formatted(names(topic.publishers()), topic.name()),
          topic.publishers().get(0).data().get(0),
          "Say under `consumes` of bench.yaml what its fields do, or `observed: true`.");
    }
  }

  private void checkRequired(Consumed consumed) {
    List<String> written =
        topics.find(consumed.topic()).stream()
            .flatMap(topic -> topic.publishers().stream())
            .flatMap(endpoint -> endpoint.data().stream())
            .map(Data::getFieldName)
            .filter(path -> path != null)
            .toList();
    for (Effect effect : consumed.fields()) {
      if (effect.required()
          && written.stream().noneMatch(it -> RosNames.overlap(it, effect.path()))) {
        found.add(
            Diagnostic.error(
                    "bench.field.unwritten",
                    "No component writes '%s' of %s, which the bench requires."
                        .formatted(effect.path(), consumed.topic()),
                    effect.location())
                .withHint("Let a component write it, or leave `required` out."));
      }
    }
  }

  /** Software that neither commands the vehicle nor tells it anything cannot be judged. */
  private void checkAnythingTaken() {
    boolean expected =
        bench.consumed().values().stream()
            .anyMatch(
                topic -> bench.isOwn(topic.topic()) || topics.find(topic.topic()).isPresent());
    if (!expected && found.isEmpty()) {
      found.add(
          Diagnostic.error(
                  "bench.topic.unconnected",
                  "Nothing that the chain writes reaches the vehicle.",
                  bench.location())
              .withHint("Say under `consumes` of bench.yaml what the vehicle takes."));
    }
  }

  private void find(String id, String message, Data place, String hint) {
    found.add(Diagnostic.error(id, message, locator.apply(place)).withHint(hint));
  }

  private static String names(List<Endpoint> endpoints) {
    return endpoints.stream()
        .map(endpoint -> "'" + endpoint.node().getName() + "'")
        .distinct()
        .collect(Collectors.joining(", "));
  }
}
