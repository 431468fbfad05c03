package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.RosNames;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.Signal.Direction;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.TopicIndex.Endpoint;
import dev.eventchain.model.TopicIndex.Topic;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.simulation.bench.Bench.Consumed;
import dev.eventchain.simulation.bench.Bench.Effect;
import dev.eventchain.simulation.bench.Bench.Field;
import dev.eventchain.simulation.bench.Bench.Provided;
import dev.eventchain.simulation.world.Actuator;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;

/**
 * Compares the topics that a chain reads from the vehicle and writes to it with those of the bench.
 */
final class BenchCheck {

  private static final Set<String> STAMPS = Set.of("stamp.sec", "stamp.nanosec", "stamp");

  private final Bench bench;
  private final TopicIndex topics;
  private final List<LatencyConstraint> constraints;
  private final Function<EObject, SourceLocation> locator;
  private final List<Diagnostic> found = new ArrayList<>();

  BenchCheck(Bench bench, EventChain chain, Function<EObject, SourceLocation> locator) {
    this.bench = bench;
    this.topics = TopicIndex.of(chain);
    this.constraints = chain.getLatencyConstraints();
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
    bench.consumed().values().forEach(this::checkWritten);
    bench.provided().values().forEach(this::checkCounted);
    checkAnythingTaken();
    checkConflicts();
    return List.copyOf(found);
  }

  /** Checks that the vehicle provides a topic that no component writes, and each of its fields. */
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
          BenchRules.BENCH_TOPIC_UNCONNECTED,
          "%s reads %s, which %s."
              .formatted(
                  names(topic.subscribers()),
                  topic.name(),
                  known
                      ? "no entry of the bench provides"
                      : "nothing sends: no component writes it, and the bench does not provide it"),
          first,
          "Say under `provides` of bench.yaml where its fields come from" + guesses(topic));
      return;
    }
    for (Endpoint reader : topic.subscribers()) {
      reader.data().forEach(data -> checkField(provided, data));
    }
  }

  /** Returns the end of a hint, with what {@code init} would write. */
  private String guesses(Topic topic) {
    List<String> guesses = bench.guesses(topic.name());
    return guesses.isEmpty() ? "." : "; `init` guesses `" + String.join("`, `", guesses) + "`.";
  }

  private void checkField(Provided provided, Data data) {
    String path = data.getFieldName();
    checkType(data, provided.topic(), provided.type());
    if (path == null || provided.scans() || isStamp(path)) {
      return;
    }
    provided.fields().stream()
        .filter(field -> field.path().equals(path))
        .map(Field::source)
        .filter(Bench.Quantity.class::isInstance)
        .forEach(source -> checkUnit(data, provided.topic(), ((Bench.Quantity) source).unit()));
    provided.objects().stream()
        .flatMap(objects -> objects.columns().stream())
        .filter(column -> column.path().equals(path))
        .forEach(column -> checkUnit(data, provided.topic(), column.unit()));
    boolean set = provided.paths().anyMatch(it -> RosNames.overlap(it, path));
    if (!set) {
      find(
          BenchRules.BENCH_FIELD_UNSET,
          "'%s' of %s is read, but the bench leaves it at its default."
              .formatted(path, provided.topic()),
          data,
          "Give it a source in bench.yaml, or a constant if it is always the same.");
    }
  }

  /** Checks that both ends use the same unit, which {@code signals.json} may leave open. */
  private void checkUnit(Data data, String topic, Unit unit) {
    Optional<Unit> other = Optional.ofNullable(data.getUnit()).flatMap(Unit::parse);
    if (other.isPresent() && other.get().relationTo(unit) != Unit.Relation.SAME) {
      find(
          BenchRules.BENCH_UNIT,
          "'%s' of %s is in %s here, but in another unit in the bench."
              .formatted(data.getFieldName(), topic, data.getUnit()),
          data,
          "Write the same unit in signals.json, the bench and the component.");
    }
  }

  private void checkType(Data data, String topic, String type) {
    String other = data.getMessageType();
    if (other != null && !RosNames.fullMessageType(other).equals(type)) {
      find(
          BenchRules.BENCH_TYPE,
          "The messages of %s are %s here, but %s in the bench.".formatted(topic, other, type),
          data,
          "Write the same type in both.");
    }
  }

  /** Checks that the latency constraints that count a latency exist, and begin with its topic. */
  private void checkCounted(Provided provided) {
    for (String name : provided.transfer().counted()) {
      if (constraints.stream().noneMatch(it -> beginsWith(it, name, provided.topic()))) {
        found.add(uncounted(name, provided));
      } else if (constraints.stream().filter(it -> name.equals(it.getName())).count() > 1) {
        found.add(ambiguous(name, provided));
      }
    }
  }

  private boolean beginsWith(LatencyConstraint constraint, String name, String topic) {
    return name.equals(constraint.getName())
        && topics.find(topic).stream()
            .flatMap(each -> each.subscribers().stream())
            .anyMatch(reader -> reader.node() == constraint.getFirst());
  }

  private static Diagnostic ambiguous(String name, Provided provided) {
    return Diagnostic.of(
            BenchRules.BENCH_LATENCY_UNKNOWN,
            "The latency of %s counts in '%s', but several latency constraints have that name."
                .formatted(provided.topic(), name),
            provided.location())
        .withHint("Give each of them a name of its own.");
  }

  private Diagnostic uncounted(String name, Provided provided) {
    List<String> known =
        constraints.stream()
            .map(LatencyConstraint::getName)
            .filter(Objects::nonNull)
            .filter(it -> constraints.stream().anyMatch(e -> beginsWith(e, it, provided.topic())))
            .toList();
    return Diagnostic.of(
            BenchRules.BENCH_LATENCY_UNKNOWN,
            "The latency of %s counts in '%s', but no latency constraint of that name begins with a component that reads the topic."
                .formatted(provided.topic(), name),
            provided.location())
        .withHint(
            known.isEmpty()
                ? "No latency constraint does. Leave it out, or bound the time from a reader of the topic."
                : "These do: " + String.join(", ", known) + ".");
  }

  private void checkWritten(Consumed consumed) {
    for (Topic topic : topics.find(consumed.topic()).stream().toList()) {
      for (Endpoint writer : topic.publishers()) {
        for (Data data : writer.data()) {
          checkType(data, consumed.topic(), consumed.type());
          consumed.fields().stream()
              .filter(effect -> effect.actuator().isPresent())
              .filter(effect -> effect.path().equals(data.getFieldName()))
              .forEach(
                  effect ->
                      checkUnit(data, consumed.topic(), Unit.parse(effect.unit()).orElseThrow()));
        }
      }
    }
  }

  /** Returns whether a field is the time stamp of a header, which is set automatically. */
  static boolean isStamp(String path) {
    return STAMPS.stream().anyMatch(stamp -> path.endsWith("header." + stamp));
  }

  /** Checks that a topic written for the vehicle has an effect or is declared to have none. */
  private void checkUntaken(Topic topic) {
    boolean forVehicle =
        bench
            .declared()
            .find(topic.name())
            .filter(it -> it.direction() == Direction.CONSUMED)
            .isPresent();
    if (forVehicle && !topic.publishers().isEmpty()) {
      find(
          BenchRules.BENCH_TOPIC_UNCONNECTED,
          "%s writes %s to the vehicle, but the bench does not take it."
              .formatted(names(topic.publishers()), topic.name()),
          topic.publishers().get(0).data().get(0),
          "Say under `consumes` of bench.yaml what its fields do, or `observed: true`"
              + guesses(topic));
    }
  }

  /** Returns the paths of a topic's fields that components and nodes as they are write. */
  private List<String> written(Consumed consumed) {
    return topics.find(consumed.topic()).stream()
        .flatMap(topic -> topic.publishers().stream())
        .flatMap(endpoint -> endpoint.data().stream())
        .map(Data::getFieldName)
        .filter(path -> path != null)
        .toList();
  }

  private void checkRequired(Consumed consumed) {
    for (Effect effect : consumed.fields()) {
      if (effect.required() && !isWritten(consumed, effect)) {
        found.add(
            Diagnostic.of(
                    BenchRules.BENCH_FIELD_UNWRITTEN,
                    "No component writes '%s' of %s, which the bench requires."
                        .formatted(effect.path(), consumed.topic()),
                    effect.location())
                .withHint("Let a component write it, or leave `required` out."));
      }
    }
  }

  /** Reports software that writes nothing to the vehicle and therefore cannot be judged. */
  private void checkAnythingTaken() {
    boolean expected =
        bench.consumed().values().stream()
            .anyMatch(
                topic -> bench.isOwn(topic.topic()) || topics.find(topic.topic()).isPresent());
    if (!expected && found.isEmpty()) {
      found.add(
          Diagnostic.of(
                  BenchRules.BENCH_TOPIC_UNCONNECTED,
                  "Nothing that the chain writes reaches the vehicle.",
                  bench.location())
              .withHint("Say under `consumes` of bench.yaml what the vehicle takes."));
    }
  }

  /**
   * Checks for two topics that drive the same actuator; conflicts within one file are found by its
   * reader.
   */
  private void checkConflicts() {
    Map<Actuator, String> driven = new EnumMap<>(Actuator.class);
    for (Consumed consumed : bench.consumed().values()) {
      for (Effect effect : consumed.fields()) {
        Set<String> others = new TreeSet<>();
        if (effect.actuator().isPresent() && isWritten(consumed, effect)) {
          Actuator actuator = effect.actuator().get();
          driven.forEach(
              (other, topic) -> {
                if (other.excludes(actuator)) {
                  others.add(topic);
                }
              });
          driven.putIfAbsent(actuator, consumed.topic());
        }
        others.remove(consumed.topic());
        others.forEach(other -> find(consumed, effect, other));
      }
    }
  }

  private boolean isWritten(Consumed consumed, Effect effect) {
    return written(consumed).stream().anyMatch(it -> RosNames.overlap(it, effect.path()));
  }

  private void find(Consumed consumed, Effect effect, String other) {
    found.add(
        Diagnostic.of(
                BenchRules.BENCH_ACTUATOR_CONFLICT,
                "'%s' of %s drives %s, and so does %s: the vehicle can follow only one of them."
                    .formatted(
                        effect.path(), consumed.topic(), effect.actuator().get().id(), other),
                effect.location())
            .withHint("Mark one of them as `observed`."));
  }

  private void find(Rule rule, String message, Data place, String hint) {
    found.add(Diagnostic.of(rule, message, locator.apply(place)).withHint(hint));
  }

  private static String names(List<Endpoint> endpoints) {
    return endpoints.stream()
        .map(endpoint -> "'" + endpoint.node().getName() + "'")
        .distinct()
        .collect(Collectors.joining(", "));
  }
}
