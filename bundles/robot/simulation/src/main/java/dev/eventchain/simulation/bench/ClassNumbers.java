package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.world.ActorKind;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads the numbers that a message has for the kinds of objects: {@code {car: 1, other: 0}}. */
final class ClassNumbers {

  private static final NumberRange NUMBER = NumberRange.of(-128, 65535);

  /** The key for all kinds that are not named. */
  private static final String OTHER = "other";

  private static final List<String> IDS =
      Arrays.stream(ActorKind.values()).map(ActorKind::id).toList();

  private ClassNumbers() {}

  /** Returns a number for each kind. */
  static Map<ActorKind, Integer> read(ObjectReader section) {
    int other = (int) section.wholeNumber(OTHER, NUMBER).orElse(0);
    Map<ActorKind, Integer> numbers = new EnumMap<>(ActorKind.class);
    Arrays.stream(ActorKind.values()).forEach(kind -> numbers.put(kind, other));
    for (String name : section.names()) {
      Optional<ActorKind> kind =
          Arrays.stream(ActorKind.values()).filter(each -> each.id().equals(name)).findFirst();
      if (kind.isPresent()) {
        section
            .wholeNumber(name, NUMBER)
            .ifPresent(number -> numbers.put(kind.get(), (int) number));
      } else if (!name.equals(OTHER)) {
        section.value(name);
        section.find(
            Diagnostic.of(
                    BenchRules.BENCH_VALUE_RANGE,
                    "There is no kind of object '" + name + "'.",
                    section.atKey(name))
                .withHint(
                    NearestName.of(name, IDS)
                        .map(nearest -> "Did you mean '" + nearest + "'?")
                        .orElse("The kinds are: " + String.join(", ", IDS) + ", other.")));
      }
    }
    return numbers;
  }
}
